"""Learning as a person watches it: it moves, it can be stopped, and a reload brings it back."""

from __future__ import annotations

import re
import subprocess

import numpy as np
import pytest
from playwright.sync_api import expect

from tests.browser.test_workbench import open_at, tau_space

pytestmark = pytest.mark.browser

ENDLESS = "world=two_branch&p.slip=0.2&source=learned&l.episodes=1000000&l.rate_floor=0.2"
"""It never settles: the rate stays high."""


def learners() -> set[int]:
    """Processes that learn for a page at this moment."""
    found = subprocess.run(["pgrep", "-f", "laplace_core learn .*--parent"], capture_output=True, text=True)
    return {int(line) for line in found.stdout.split()}


def episodes(page) -> int:
    return int(re.search(r"([\d,]+) of 1,000,000", strip(page).inner_text())[1].replace(",", ""))


def strip(page):
    return page.locator(".st-key-learning_strip")


def press_learn(page) -> None:
    page.get_by_role("button", name="Learn now", exact=True).click()


def test_the_pictures_move_while_it_learns_and_cancel_ends_the_process(page, address):
    open_at(page, address, ENDLESS)
    expect(strip(page)).to_contain_text("the pictures are exact")
    before, exact = learners(), tau_space(page)
    press_learn(page)
    expect(strip(page)).to_contain_text(re.compile("of 1,000,000 episodes"), timeout=60_000)
    (process,) = learners() - before
    first, drawn = episodes(page), tau_space(page)
    for _ in range(150):
        if episodes(page) > first and not np.array_equal(tau_space(page), drawn):
            break
        page.wait_for_timeout(200)
    assert episodes(page) > first
    assert not np.array_equal(tau_space(page), drawn)
    assert not np.array_equal(tau_space(page), exact)
    page.get_by_role("button", name="Cancel").click()
    expect(strip(page)).to_contain_text("cancelled at", timeout=15_000)
    assert process not in learners()
    expect(page.get_by_role("button", name="Cancel")).to_have_count(0)
    stopped, kept = episodes(page), tau_space(page)
    page.wait_for_timeout(1_500)
    assert episodes(page) == stopped
    np.testing.assert_array_equal(tau_space(page), kept)


def test_zoom_and_an_open_section_survive_the_looks_at_a_learner(page, address):
    open_at(page, address, ENDLESS)
    press_learn(page)
    expect(strip(page)).to_contain_text("of 1,000,000 episodes")
    page.wait_for_timeout(1_000)
    page.locator("canvas.tau-space").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("+")
    zoom = "() => JSON.stringify(document.querySelector('canvas.tau-space').scale.x)"
    page.wait_for_timeout(300)
    zoomed, whole = (
        page.evaluate(zoom),
        page.evaluate("() => document.querySelector('.laplace-lens').lens.seen.thetas[0]"),
    )
    assert str(whole) not in zoomed
    first = episodes(page)
    for _ in range(100):
        if episodes(page) > first:
            break
        page.wait_for_timeout(200)
    page.wait_for_timeout(1_500)
    assert episodes(page) > first
    assert page.evaluate(zoom) == zoomed
    page.locator("input[name=alpha]").press("ArrowLeft")
    expect(page).to_have_url(re.compile("alpha="))
    expect(strip(page)).to_contain_text("of 1,000,000 episodes")  # and it learns on
    page.get_by_role("button", name="Cancel").click()
    expect(strip(page)).to_contain_text("cancelled at", timeout=15_000)


def test_several_seeds_end_in_bands_and_a_reload_brings_the_same(page, address):
    open_at(page, address, "world=two_branch&p.slip=0.2&source=learned&l.episodes=80&l.seeds=3")
    press_learn(page)
    expect(page.get_by_role("button", name="Download agent")).to_be_visible()
    expect(strip(page)).to_contain_text("80 of 80 episodes by each of 3 learners")
    bands = """() => [...document.querySelectorAll('.js-plotly-plot')].map((p) => [p.dataset.name,
      p._fullData.filter((t) => t.fill === 'toself').length]).filter(([, n]) => n)"""
    page.wait_for_selector(".js-plotly-plot[data-name='probabilities'] .main-svg")
    page.wait_for_timeout(500)
    found = dict(page.evaluate(bands))
    assert found["rewards"] == 2
    assert found["values"] == 2
    assert found["probabilities"] >= 2
    before, words = tau_space(page), page.locator(".laplace-lens .verdict p").inner_text()
    page.reload()
    expect(page.get_by_role("button", name="Download agent")).to_be_visible()
    expect(page.locator(".laplace-lens .verdict p")).to_have_text(words)
    page.wait_for_function("() => document.querySelectorAll('.js-plotly-plot').length >= 5")
    page.wait_for_timeout(500)
    np.testing.assert_array_equal(tau_space(page), before)
