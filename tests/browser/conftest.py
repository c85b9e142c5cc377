"""One server and one Chromium for all browser tests; without a Chromium they are skipped and say so."""

from __future__ import annotations

from pathlib import Path

import pytest

from bench.browser import FLAGS, find_chromium, served

ROOT = Path(__file__).resolve().parent.parent.parent


@pytest.fixture(scope="session")
def address():
    if find_chromium() is None:
        pytest.skip("no Chromium on the path: install it (Debian: apt-get install chromium) to run the browser tests")
    with served(ROOT / "app" / "main.py") as (url, _):
        yield url


@pytest.fixture(scope="session")
def chromium(address):
    from playwright.sync_api import expect, sync_playwright

    expect.set_options(timeout=30_000)  # a machine that does other work, too

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find_chromium(), args=FLAGS)
        yield browser
        browser.close()


@pytest.fixture
def page(chromium):
    context = chromium.new_context(viewport={"width": 1440, "height": 900}, accept_downloads=True)
    context.set_default_timeout(60_000)
    page = context.new_page()
    page.problems = []
    page.on("pageerror", lambda error: page.problems.append(str(error)))
    yield page
    context.close()
    assert page.problems == []
