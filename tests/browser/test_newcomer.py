"""Five tasks of a newcomer, walked by visible labels alone; every click and key stroke counts and is printed (-s)."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

from laplace_core import load_world
from laplace_core.worlds import dump_world
from tests.browser.support import open_at, settled

pytestmark = pytest.mark.browser


class Hand:
    """A person on the page, who knows what is written on it and nothing else."""

    def __init__(self, page) -> None:
        self.page, self.clicks, self.keys = page, 0, 0

    def click(self, words: str, role: str = "button") -> None:
        self.on(self.page.get_by_role(role, name=words, exact=True))

    def on(self, place) -> None:
        place.click()
        self.clicks += 1
        settled(self.page)

    def press(self, place, key: str) -> None:
        place.press(key)
        self.keys += 1

    def report(self, task: str) -> None:
        keys = f" and {self.keys} key strokes" if self.keys else ""
        print(f"\nnewcomer: {task}: {self.clicks} clicks{keys}")


@pytest.fixture
def hand(page):
    return Hand(page)


def test_explain_the_page(page, address, hand):
    open_at(page, address)
    hand.click("How to read this")
    expect(page.get_by_text("how likely each reward is at each future step")).to_be_visible()
    hand.report("explain the page")


def test_find_the_alpha_where_the_choice_turns(page, address, hand):
    verdict = open_at(page, address)
    alpha = page.get_by_role("slider", name="α")
    hand.on(alpha)
    chosen = re.search("choose (\\w+)", verdict.inner_text())[1]
    while f"choose {chosen}" in verdict.inner_text():
        hand.press(alpha, "PageDown")
        settled(page)
    while f"choose {chosen}" not in verdict.inner_text():
        hand.press(alpha, "ArrowRight")
        settled(page)
    hand.report("find the alpha where the choice turns")


def test_open_an_own_world(page, address, hand, tmp_path: Path):
    open_at(page, address)
    file = tmp_path / "mine.json"
    file.write_text(dump_world(load_world("double_chain")))
    hand.on(page.get_by_text("Bring your own"))
    with page.expect_file_chooser() as waiting:
        hand.click("Upload")
    waiting.value.set_files(file)
    expect(page).to_have_url(re.compile("world=own"))
    hand.report("open an own world")


def test_find_whether_an_agents_timeline_comes_true(page, address, hand):
    open_at(page, address)
    hand.click("Trained agents", role="link")
    hand.click("Roll out")
    hand.click("Simulate")
    expect(page.get_by_text(re.compile("does the decoded timeline come true", re.I))).to_be_visible()
    hand.report("find whether an agent's timeline comes true")


def test_export_one_panel(page, address, hand):
    """There is no way: the nearest is one picture of all panels."""
    open_at(page, address)
    with page.expect_download() as waiting:
        hand.click("save SVG")
    assert waiting.value.suggested_filename.endswith(".svg")
    hand.report("export one panel for a paper (all panels in one file, to be cut by hand)")
