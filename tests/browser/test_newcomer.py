"""Five tasks of a newcomer, walked by visible labels alone; every click and key stroke counts and is printed (-s)."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from playwright.sync_api import expect

from laplace_core import load_world
from laplace_core.worlds import dump_world
from tests.browser.support import open_at, settled

pytestmark = pytest.mark.browser
BEFORE = {
    "explain the page": "1 click, to a text that begins under the screen",
    "find the alpha where the choice turns": "1 click and 24 key strokes",
    "open an own world": "2 clicks",
    "find whether an agent's timeline comes true": "3 clicks",
    "export one panel for a paper": "not possible: 1 click saved all panels in one file",
}
"""What the same tasks took on the page before it was put in an order; the history of this file has the walks."""


class Hand:
    """A person on the page, who knows what is written on it and nothing else."""

    def __init__(self, page) -> None:
        self.page, self.clicks = page, 0

    def click(self, words: str, role: str = "button") -> None:
        self.on(self.page.get_by_role(role, name=words, exact=True))

    def on(self, place) -> None:
        expect(place).to_be_visible()
        settled(self.page)  # a button that is drawn again under the hand loses the click
        place.click()
        self.clicks += 1
        settled(self.page)

    def report(self, task: str, most: int) -> None:
        print(f"\nnewcomer: {task}: before {BEFORE[task]}; now {self.clicks} clicks")
        assert self.clicks <= most


@pytest.fixture
def hand(page):
    return Hand(page)


def in_view(page, place) -> bool:
    box = place.bounding_box()
    return bool(box) and box["y"] >= 0 and box["y"] + box["height"] <= page.viewport_size["height"]


def test_explain_the_page(page, address, hand):
    """One sentence without a click; two lines and the formula behind the '?' beside the title."""
    open_at(page, address)
    sentence = page.get_by_text("how likely each reward (across) is at each future step (up)")
    expect(sentence).to_be_visible()
    assert in_view(page, sentence)
    hand.on(page.get_by_label("what Tau-space shows"))
    formula = page.get_by_text("P = V diag(s / (s² + α²)) Uᵀ Z")
    expect(formula).to_be_visible()
    assert in_view(page, formula)
    hand.report("explain the page", 1)


def test_find_the_alpha_where_the_choice_turns(page, address, hand):
    verdict = open_at(page, address)
    expect(verdict).to_contain_text("choose short")
    turns = page.get_by_text("choice turns at α =")
    expect(turns).to_be_visible()
    settled(page)
    hand.on(turns.get_by_role("button").first)
    expect(verdict).to_contain_text("choose short")
    page.get_by_role("slider", name="regularisation α").press("ArrowLeft")  # one place below, and the choice is another
    expect(verdict).to_contain_text("choose long")
    hand.report("find the alpha where the choice turns", 1)


def test_open_an_own_world(page, address, hand, tmp_path: Path):
    open_at(page, address)
    file = tmp_path / "mine.json"
    file.write_text(dump_world(load_world("double_chain")))
    hand.on(page.get_by_text("Bring your own", exact=True))
    with page.expect_file_chooser() as waiting:
        hand.click("Upload")
    waiting.value.set_files(file)
    expect(page).to_have_url(re.compile("world=own"))
    hand.report("open an own world", 2)


def test_find_whether_an_agents_timeline_comes_true(page, address, hand):
    open_at(page, address)
    hand.click("Trained agents", role="link")
    hand.click("Roll out")
    hand.click("Simulate")
    expect(page.get_by_text(re.compile("decoded timeline against simulated continuations", re.I))).to_be_visible()
    hand.report("find whether an agent's timeline comes true", 3)


def test_export_one_panel(page, address, hand):
    open_at(page, address)
    hand.on(page.get_by_label("what Values over T shows"))
    with page.expect_download() as waiting:
        hand.on(page.get_by_label("save Values over T as SVG"))
    texts = {node.text for node in ET.parse(waiting.value.path()).iter("{http://www.w3.org/2000/svg}text")}
    assert {"Values over T", "short", "long"} <= texts
    assert "Tau-space" not in texts
    hand.report("export one panel for a paper", 2)


def test_the_story_tells_five_steps_and_leads_to_an_own_world(page, address, hand):
    """Each step is a link that alone reproduces the view; its words stand over the picture that it is about."""
    verdict = open_at(page, address)
    hand.click("Guided story", role="link")
    steps = page.get_by_label("guided story").get_by_role("link")
    assert steps.all_inner_texts() == [
        "The toy", "Its code", "The inverse", "The artefact", "The repair", "Now your own",
    ]  # fmt: skip
    hand.click("The artefact", role="link")
    expect(verdict).to_contain_text("choose short")
    expect(page).to_have_url(re.compile("story=4"))
    expect(page.locator(".of-tau-space")).to_have_class(re.compile("lit"))
    hand.click("The repair", role="link")
    expect(verdict).to_contain_text("choose long")
    expect(page.get_by_text("Without rescaling")).to_be_visible()
    open_at(page, address, "world=two_branch&normalise=paper&action=short&story=4")
    expect(page.get_by_role("link", name="The artefact")).to_have_attribute("aria-current", "step")
    hand.click("end the story")
    expect(page).not_to_have_url(re.compile("story"))
    expect(verdict).to_contain_text("choose short")


def test_why_is_remembered(page, address, hand):
    open_at(page, address)
    expect(page.locator("canvas.kernel")).to_be_hidden()
    hand.on(page.get_by_text("Why?"))
    expect(page.locator("canvas.kernel")).to_be_visible()
    open_at(page, address, "world=double_chain")
    expect(page.locator("canvas.kernel")).to_be_visible()


def test_after_a_rollout_alpha_is_in_view_and_the_lens_shows_the_action_taken(page, address):
    open_at(page, f"{address}/agents", "")
    page.get_by_role("button", name="Roll out").click()
    page.locator(".laplace-player canvas").wait_for()
    settled(page)
    lens = "document.querySelector('.laplace-lens').lens"
    assert in_view(page, page.locator("input[name=alpha]"))
    actions = set()
    for _ in range(40):
        page.locator("input[name=step]").press("ArrowRight")
        settled(page)
        taken = page.locator(".laplace-player .values tr.taken td").nth(1).inner_text()
        shown = page.evaluate(f"() => {lens}.model.header.actions[{lens}.state.action]")
        assert shown == taken
        actions.add(shown)
        if len(actions) > 1:
            break
    assert len(actions) > 1
    assert "action=" not in page.url
