"""The page of the paper in a real browser: from the list to a section, a picture, the raw file and the workbench."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from laplace_core.experiments.paper.claims import ENTRIES
from tests.browser.support import DRAWN, settled

pytestmark = pytest.mark.browser
COMMITTED = Path(__file__).resolve().parents[2] / "docs" / "paper"
SIZES = {"wide": (1440, 900), "phone": (390, 844)}
_OVERFLOWS = "() => document.querySelector('[data-testid=stMain]').scrollWidth > innerWidth"


@pytest.mark.parametrize("size", ["wide", pytest.param("phone", marks=pytest.mark.long)])
def test_a_figure_is_found_in_the_list_and_opened_in_the_workbench(page, address, size):
    width, height = SIZES[size]
    page.set_viewport_size({"width": width, "height": height})
    page.goto(f"{address}/paper")
    section = page.locator(".st-key-paper_fig4")
    section.locator(".main-svg").first.wait_for()
    settled(page)
    assert page.locator("h2.paper-title").count() == len(ENTRIES)
    assert not page.evaluate(_OVERFLOWS)

    page.locator(".paper-states").get_by_role("link", name="Figure 4").click()
    expect(section.locator("h2")).to_be_in_viewport()
    assert page.url.startswith(f"{address}/paper")
    with page.expect_download() as download:
        section.get_by_role("button", name="Raw results").click()
    assert Path(download.value.path()).read_bytes() == (COMMITTED / "fig4.json").read_bytes()

    section.get_by_role("link", name="Open in the workbench").click()
    page.wait_for_function(DRAWN)
    settled(page)
    assert "normalise=paper" in page.url
    assert "14.85" in page.locator(".laplace-lens .verdict").inner_text()
