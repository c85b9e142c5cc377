"""Learning as a person watches it: it moves, it can be stopped, and a reload brings it back."""

from __future__ import annotations

import json
import re
from contextlib import suppress

import numpy as np
import psutil
import pytest
from playwright.sync_api import expect

from tests.browser.support import comes_to_differ, open_at, settled, tau_space

pytestmark = pytest.mark.browser

ENDLESS = "world=two_branch&p.slip=0.2&source=learned&l.episodes=1000000&l.rate_floor=0.2"
"""It never settles: the rate stays high."""


def learners() -> set[int]:
    """Processes that learn for a page of these tests at this moment."""
    found = set()
    for one in psutil.Process().children(recursive=True):
        with suppress(psutil.Error):  # it is over by now
            if {"learn", "--parent"} <= set(one.cmdline()):
                found.add(one.pid)
    return found


def episodes(page) -> int:
    return int(re.search(r"([\d,]+) of 1,000,000", strip(page).inner_text())[1].replace(",", ""))


def comes_beyond(page, first: int) -> None:
    """Wait until more episodes have been learned than ``first``."""
    page.wait_for_function(
        """(first) => {
        const words = document.querySelector('.st-key-learning_strip')?.innerText ?? '';
        return +(words.match(/([\\d,]+) of 1,000,000/)?.[1] ?? '0').replaceAll(',', '') > first; }""",
        arg=first,
    )


def strip(page):
    return page.locator(".st-key-learning_strip")


def press_learn(page) -> None:
    page.get_by_role("button", name="Learn now", exact=True).click()


def test_the_pictures_move_while_it_learns_and_cancel_ends_the_process(page, address):
    open_at(page, address, ENDLESS)
    expect(strip(page)).to_contain_text("the pictures are exact")
    before, exact = learners(), tau_space(page)
    press_learn(page)
    expect(strip(page)).to_contain_text(re.compile("of 1,000,000 episodes"))
    (process,) = learners() - before
    first, drawn = episodes(page), tau_space(page)
    comes_beyond(page, first)
    comes_to_differ(page, drawn)
    assert not np.array_equal(tau_space(page), exact)
    page.get_by_role("button", name="Cancel").click()
    expect(strip(page)).to_contain_text("cancelled at")
    assert process not in learners()
    expect(page.get_by_role("button", name="Cancel")).to_have_count(0)
    stopped, kept = episodes(page), tau_space(page)
    page.locator("input[name=alpha]").press("ArrowLeft")  # the page is run again, and yet nothing is learned
    expect(page).to_have_url(re.compile(r"alpha=0\.19$"))
    page.get_by_role("button", name="undo", exact=True).click()
    expect(page).to_have_url(re.compile(r"alpha=0\.2$"))
    settled(page)
    assert episodes(page) == stopped
    np.testing.assert_array_equal(tau_space(page), kept)


@pytest.mark.long
def test_zoom_and_an_open_section_survive_the_looks_at_a_learner(page, address):
    open_at(page, address, ENDLESS)
    exact = tau_space(page)
    press_learn(page)
    expect(strip(page)).to_contain_text("of 1,000,000 episodes")
    comes_to_differ(page, exact)
    zoom = "() => JSON.stringify(document.querySelector('canvas.tau-space').scale.x)"
    low, high = json.loads(page.evaluate(zoom))
    page.locator("canvas.tau-space").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("+")
    width = "(([low, high]) => high - low)(document.querySelector('canvas.tau-space').scale.x)"
    page.wait_for_function(f"() => {width} < {0.7 * (high - low)}")  # half of it, whatever of it holds rewards
    zoomed = page.evaluate(zoom)
    for _ in range(2):
        first, drawn = episodes(page), tau_space(page)
        comes_beyond(page, first)
        comes_to_differ(page, drawn)
    assert page.evaluate(zoom) == zoomed
    page.locator("input[name=alpha]").press("ArrowLeft")
    expect(page).to_have_url(re.compile("alpha="))
    expect(strip(page)).to_contain_text("of 1,000,000 episodes")  # and it learns on
    page.get_by_role("button", name="Cancel").click()
    expect(strip(page)).to_contain_text("cancelled at")


@pytest.mark.long
def test_several_seeds_end_in_bands_and_a_reload_brings_the_same(page, address):
    open_at(page, address, "world=two_branch&p.slip=0.2&source=learned&l.episodes=80&l.seeds=3")
    press_learn(page)
    expect(page.get_by_role("button", name="Download agent")).to_be_visible()
    expect(strip(page)).to_contain_text("80 of 80 episodes by each of 3 learners")
    bands = """() => [...document.querySelectorAll('.js-plotly-plot')].map((p) => [p.dataset.name,
      p._fullData.filter((t) => t.fill === 'toself').length]).filter(([, n]) => n)"""
    page.wait_for_selector(".js-plotly-plot[data-name='probabilities'] .main-svg")
    settled(page)
    found = dict(page.evaluate(bands))
    assert found["rewards"] == 2
    assert found["values"] == 2
    assert found["probabilities"] >= 2
    before, words = tau_space(page), page.locator(".laplace-lens .verdict p").inner_text()
    page.reload()
    expect(page.get_by_role("button", name="Download agent")).to_be_visible()
    expect(page.locator(".laplace-lens .verdict p")).to_have_text(words)
    page.wait_for_function("() => document.querySelectorAll('.js-plotly-plot').length >= 5")
    settled(page)
    np.testing.assert_array_equal(tau_space(page), before)
