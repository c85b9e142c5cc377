"""Worlds, timelines and files of one's own, typed and dropped into a real browser."""

from __future__ import annotations

import json
import re

import pytest
from playwright.sync_api import expect

from laplace_core import Settings, load_world, study, study_of_gamma_space
from laplace_core.files.packed_text import pack, unpack
from laplace_core.study.npz import read_gamma_space
from laplace_core.worlds import dump_world, parse_world
from laplace_core.worlds.timeline import FIRST_TIMELINE
from tests.browser.support import comes_to_show, open_at, settled
from tests.support.malformed_saved import with_arrays
from tests.support.malformed_worlds import TEXT

pytestmark = pytest.mark.browser

OWN = f"world=own&own={pack(dump_world(load_world('two_branch')))}"

WITHIN = """(name) => {
    const { left, right } = document.querySelector(`[role=dialog][aria-label="${name}"]`).getBoundingClientRect();
    return left >= 0 && right <= innerWidth + 1;
}"""
TOO_WIDE = """() => {
  const scrolls = (e) => e && (/(auto|scroll)/.test(getComputedStyle(e).overflowX) && e.dataset.testid !== 'stMain'
    && e.dataset.testid !== 'stAppViewContainer' || scrolls(e.parentElement));
  return [...document.querySelectorAll('[data-testid="stMain"] *')]
    .filter((e) => e.getBoundingClientRect().right > innerWidth + 1 && e.getBoundingClientRect().width > 0)
    .filter((e) => getComputedStyle(e).visibility !== 'hidden' && !scrolls(e.parentElement)
      && !e.closest('svg') && !e.matches('[type="range"]'))
    .map((e) => `${e.tagName} ${e.className} ${e.dataset.testid ?? ''}`.slice(0, 120));
}"""


def selected(table, row: int, column: int) -> None:
    """Wait until the table says that this cell is the selected one."""
    cell = table.locator(f"#glide-cell-{column + 1}-{row}")  # the tick boxes are column 0
    expect(cell).to_have_attribute("aria-selected", "true")


def type_into_table(page, row: int, column: int, text: str) -> None:
    """Go to a cell of the table by the keyboard and type over it."""
    table = page.locator('[data-testid="stDataFrame"]')
    table.locator("canvas[data-testid=data-grid-canvas]").wait_for()
    table.scroll_into_view_if_needed()
    settled(page)
    box = table.bounding_box()
    page.mouse.click(box["x"] + 90, box["y"] + 52)  # the first cell, under the header and beside the tick boxes
    selected(table, 0, 0)
    for i in range(row):
        page.keyboard.press("ArrowDown")
        selected(table, i + 1, 0)
    for i in range(column):
        page.keyboard.press("ArrowRight")
        selected(table, row, i + 1)
    page.keyboard.press("Enter")  # opens the cell
    cell = page.locator("#portal :is(input, textarea):not([disabled])")
    expect(cell).to_be_focused()
    cell.fill(text)
    page.keyboard.press("Enter")
    expect(cell).to_have_count(0)


def test_a_reward_typed_into_the_table_moves_the_picture_and_the_link(page, address):
    verdict = open_at(page, address, OWN + "&alpha=0.2")
    expect(verdict).to_contain_text("choose long")
    type_into_table(page, 0, 3, "11")  # what the short branch pays
    expect(verdict).to_contain_text("choose short")
    world = parse_world(unpack(re.search("own=([^&]+)", page.url)[1]))
    assert world.reward_values.tolist() == [0.0, 10.0, 11.0]
    comes_to_show(page, study(world, Settings(alpha=0.2)).decoded.tau_space[0])
    type_into_table(page, 1, 2, "0.5")
    expect(page.get_by_text("add up to 0.5")).to_be_visible()
    expect(verdict).to_contain_text("choose short")
    page.get_by_role("button", name="Rescale probabilities to 1").click()
    expect(page.get_by_text("add up to 0.5")).to_have_count(0)
    comes_to_show(page, study(world, Settings(alpha=0.2)).decoded.tau_space[0])


@pytest.mark.long
def test_edits_are_there_again_after_back(page, address):
    verdict = open_at(page, address, OWN + "&alpha=0.2")
    type_into_table(page, 0, 3, "11")
    expect(verdict).to_contain_text("choose short")
    edited = page.url
    page.get_by_role("combobox", name="World").click()
    page.get_by_role("combobox", name="World").fill("double")
    page.keyboard.press("Enter")
    expect(page).to_have_url(re.compile("world=double_chain"))
    settled(page)
    page.go_back()
    expect(verdict).to_contain_text("choose short")
    settled(page)
    assert page.url == edited


def test_a_timeline_is_drawn_by_hand(page, address):
    open_at(page, address, "world=two_branch")
    page.get_by_text("Bring your own").click()
    settled(page)  # a button that is drawn again loses a click
    page.get_by_role("button", name="Draw a timeline").click()
    expect(page.get_by_text("Your timeline: each row is a reward")).to_be_visible()
    type_into_table(page, 0, 2, "7")
    settled(page)  # the link is written first, the file at the end of the same run
    rows = json.loads(unpack(re.search("timeline=([^&]+)", page.url)[1]))["rows"]
    assert rows[0] == ["now", 0, 7, 1]
    with page.expect_download() as waiting:
        page.get_by_role("button", name="Download world").click()
    world = parse_world(waiting.value.path().read_text())
    assert 7.0 in world.reward_values
    # A world file does not say which settings suit it; the timeline on the page brings its own.
    settings = Settings(gammas=50, alpha=1e-3, steps=11)
    comes_to_show(page, study(world, settings).decoded.tau_space[0])


def test_files_are_dropped_in_and_bad_ones_refused(page, address):
    open_at(page, address, "world=two_branch")
    page.get_by_text("Bring your own").click()
    box = page.locator('[data-testid="stFileUploaderDropzoneInput"]')
    box.set_input_files({"name": "bad.npz", "mimeType": "application/zip", "buffer": b"PK nothing"})
    expect(page.get_by_text("is not an .npz file of plain number arrays")).to_be_visible()
    expect(page.locator(".laplace-lens .verdict")).to_contain_text("choose long")
    box.set_input_files({"name": "mine.npz", "mimeType": "application/zip", "buffer": with_arrays()})
    expect(page.locator(".laplace-lens .verdict")).to_contain_text("No truth to compare with")
    found = study_of_gamma_space(read_gamma_space(with_arrays()), Settings(world="mine.npz"))
    comes_to_show(page, found.decoded.tau_space[0])
    box.set_input_files({"name": "mine.json", "mimeType": "application/json", "buffer": TEXT.encode()})
    expect(page).to_have_url(re.compile("world=own"))
    comes_to_show(page, study(parse_world(TEXT), Settings()).decoded.tau_space[0])


@pytest.mark.parametrize(
    ("width", "height", "query"),
    [
        (1440, 900, OWN),
        (390, 844, OWN),
        (390, 844, f"world=timeline&timeline={FIRST_TIMELINE}"),
        pytest.param(390, 844, "world=cliff_grid&source=learned", marks=pytest.mark.long),
    ],
    ids=["desktop", "own", "timeline", "learned"],
)
def test_nothing_is_wider_than_the_screen_with_every_section_open(page, address, width, height, query):
    page.set_viewport_size({"width": width, "height": height})
    pinned = pack(json.dumps({"world": "two_branch"}))
    open_at(page, address, f"{query}&pin={pinned}")
    page.wait_for_selector(".js-plotly-plot[data-name='compare B - A'] .main-svg")
    assert page.evaluate(TOO_WIDE) == []
    assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth + 1")
    for name in ("How to read this", "Copy", "Download"):
        page.get_by_role("button", name=name, exact=True).click()
        popover = page.get_by_role("dialog", name=name, exact=True)
        expect(popover).to_be_visible()
        page.wait_for_function(WITHIN, arg=name)  # it is put into place after it is shown
        settled(page)  # the server fills it in a run of its own, after which it has the focus
        page.keyboard.press("Escape")
        expect(popover).to_have_count(0)
