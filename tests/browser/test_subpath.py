"""The workbench below a path of another site, behind a reverse proxy, in a real browser."""

from __future__ import annotations

import re
import shutil
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import expect

from laplace_core import Settings, study
from laplace_core.worlds import parse_world
from tests.browser.support import FLAGS, MAIN, PATIENCE, WATCH, comes_to_show, find_chromium, open_at, served, settled
from tests.support import proxy
from tests.support.malformed_worlds import TEXT

pytestmark = [pytest.mark.browser, pytest.mark.long]
SITE = "laplace.test"
"""A name that the browser knows for this machine: a server takes connections from 127.0.0.1 whatever a proxy says."""


@pytest.fixture(scope="module")
def upstream():
    if find_chromium() is None:
        pytest.skip("no Chromium on the path: install it (Debian: apt-get install chromium) to run the browser tests")
    with served(MAIN, variables={"STREAMLIT_SERVER_BASE_URL_PATH": proxy.PREFIX}) as (url, _):
        yield urlsplit(url).port


@pytest.fixture(params=["tiny", "nginx"])
def behind(request, upstream, chromium):
    """A tab of a browser that knows the site, its address below the path, and what the proxy has refused."""
    if request.param == "nginx" and shutil.which("nginx") is None:
        pytest.skip("no nginx on the path")
    rule = f"--host-resolver-rules=MAP {SITE} 127.0.0.1"
    browser = chromium.browser_type.launch(executable_path=find_chromium(), args=[*FLAGS, rule])
    with getattr(proxy, request.param)(upstream) as (port, refused):
        context = browser.new_context(viewport={"width": 1440, "height": 900})
        context.set_default_timeout(PATIENCE)
        context.add_init_script(WATCH)
        tab = context.new_page()
        tab.problems = []
        tab.on("pageerror", lambda error: tab.problems.append(str(error)))
        tab.on("response", lambda answer: answer.status >= 400 and tab.problems.append(answer.url))
        yield tab, f"http://{SITE}:{port}{proxy.PREFIX}"
        problems = list(tab.problems)
        browser.close()
    assert problems == []
    assert refused == []


def test_pictures_pages_files_and_links_work_below_a_path(behind):
    page, address = behind
    page.goto(address)  # without the last slash
    expect(page).to_have_url(re.compile(rf"^{re.escape(address)}/(\?.*)?$"))
    verdict = open_at(page, address, "world=two_branch&alpha=0.1")
    expect(verdict).to_contain_text("choose long")
    assert page.url == f"{address}/?world=two_branch&alpha=0.1"

    # A file goes up by a request of its own, another one comes down.
    page.get_by_text("Bring your own").click()
    file = {"name": "mine.json", "mimeType": "application/json", "buffer": TEXT.encode()}
    page.locator('[data-testid="stFileUploaderDropzoneInput"]').set_input_files(file)
    expect(page).to_have_url(re.compile("world=own"))
    comes_to_show(page, study(parse_world(TEXT), Settings(world="own")).decoded.tau_space[0])
    with page.expect_download() as waiting:
        page.get_by_role("button", name="Download world").click()
    assert parse_world(waiting.value.path().read_text()).name == parse_world(TEXT).name

    # The link is the view, and every page is found by its name in the bar.
    settled(page)
    page.reload()
    comes_to_show(page, study(parse_world(TEXT), Settings(world="own")).decoded.tau_space[0])
    for name, path in (("Inverse", "inverse"), ("Trained agents", "agents"), ("Paper", "paper"), ("Train", "train")):
        page.get_by_test_id("stTopNavLink").filter(has_text=re.compile(f"^{name}$")).click()
        expect(page).to_have_url(re.compile(rf"{re.escape(address)}/{path}(\?|$)"))
        settled(page)
    kept = [each for each in page.context.cookies() if each["name"] == "laplace_owner"]
    assert [each["path"] for each in kept] == [f"{proxy.PREFIX}/"]
