"""One server, one Chromium and one tab for all browser tests; without a Chromium they are skipped and say so.

To load a page in a tab that has loaded it before takes a fraction of the time that a new one takes. Every test loads
its page anew, so nothing but the browser's cache is left of the test before.
"""

from __future__ import annotations

import pytest

from tests.browser.support import DEMO, FLAGS, MAIN, PATIENCE, WATCH, find_chromium, served

SCREEN = {"width": 1440, "height": 900}


@pytest.fixture(scope="session")
def address():
    if find_chromium() is None:
        pytest.skip("no Chromium on the path: install it (Debian: apt-get install chromium) to run the browser tests")
    with served(MAIN) as (url, _):
        yield url


@pytest.fixture(scope="session")
def demo(chromium):
    with served(DEMO) as (url, _):
        yield url


@pytest.fixture(scope="session")
def chromium():
    if find_chromium() is None:
        pytest.skip("no Chromium on the path: install it (Debian: apt-get install chromium) to run the browser tests")
    from playwright.sync_api import expect, sync_playwright

    expect.set_options(timeout=PATIENCE)

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find_chromium(), args=FLAGS)
        yield browser
        browser.close()


@pytest.fixture(scope="session")
def tab(chromium):
    """The one tab, for :func:`page`; its ``problems`` are the errors of scripts."""
    context = chromium.new_context(viewport=SCREEN, accept_downloads=True)
    context.set_default_timeout(PATIENCE)
    context.add_init_script(WATCH)
    tab = context.new_page()
    tab.problems = []
    tab.on("pageerror", lambda error: tab.problems.append(str(error)))
    yield tab
    context.close()


@pytest.fixture
def page(tab):
    tab.problems.clear()
    yield tab
    problems = list(tab.problems)
    if tab.url.startswith("http"):
        tab.evaluate("() => localStorage.clear()")  # what a page remembers of how it was left
    tab.goto("about:blank")  # what a page that is left no longer loads is no error of the next one
    tab.unroute_all()
    tab.set_viewport_size(SCREEN)
    tab.emulate_media(color_scheme="light", reduced_motion="no-preference")
    tab.mouse.move(0, 0)
    assert problems == []
