"""Training as a person watches it: it moves, a reload and another tab find it, it stops, goes on, and is opened."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.browser

RUN = "laplace_two_branch_7"
LONG = "environment=two_branch&t.seed=7&t.steps=1000000&t.evaluate_every=300&t.hidden=16&t.batch=16"


def card(page, name=RUN):
    return page.locator(f".st-key-run_{name}")


def state(page):
    return card(page).locator(".run-state")


def steps(page) -> int:
    expect(card(page)).to_contain_text(re.compile(r"of [\d,]+ steps"), timeout=30_000)
    return int(re.search(r"([\d,]+) of [\d,]+ steps", card(page).inner_text())[1].replace(",", ""))


def later(page, step: int) -> int:
    """The step once it is beyond ``step``."""
    for _ in range(600):
        if steps(page) > step:
            return steps(page)
        page.wait_for_timeout(100)
    raise AssertionError("it does not move")


def scores(plot) -> int:
    """Evaluations that the picture really draws."""
    return plot.evaluate("(p) => p._fullData.at(-1).x.length")


def test_a_run_moves_is_found_again_stops_goes_on_and_is_opened(page, chromium, address):
    page.goto(f"{address}/train?{LONG}")
    page.get_by_role("button", name="Start training").click()
    expect(state(page)).to_have_text("training", timeout=120_000)
    first = later(page, 0)
    page.wait_for_function("() => document.querySelectorAll('.js-plotly-plot .main-svg').length >= 3")
    plot = page.locator(".js-plotly-plot[data-name='training']")
    plot.evaluate("(p) => { p.marked = true; }")
    expect(card(page)).to_contain_text("best evaluation", timeout=120_000)
    before = scores(plot)
    for _ in range(600):
        if scores(plot) > max(1, before):
            break
        page.wait_for_timeout(100)
    assert scores(plot) > max(1, before)
    assert plot.evaluate("(p) => p.marked")  # the same element, updated
    second = later(page, first)

    page.reload()
    expect(state(page)).to_have_text("training", timeout=60_000)
    assert steps(page) >= second
    other = chromium.new_context().new_page()
    other.goto(f"{address}/train")
    expect(state(other)).to_have_text("training", timeout=60_000)
    other.context.close()

    card(page).get_by_role("button", name="Cancel").click()
    expect(state(page)).to_have_text("stopped", timeout=30_000)
    stopped = steps(page)
    page.wait_for_timeout(1_500)
    assert steps(page) == stopped
    card(page).get_by_role("button", name="Resume").click()
    expect(state(page)).to_have_text("training", timeout=60_000)
    later(page, stopped)
    card(page).get_by_role("button", name="Cancel").click()
    expect(state(page)).to_have_text("stopped", timeout=30_000)

    page.wait_for_timeout(1_500)  # the last look of the poll
    card(page).get_by_role("button", name="Open in Trained agents").click()
    expect(page).to_have_url(re.compile(f"agents.*checkpoint=run%3A{RUN}"), timeout=60_000)
    expect(page.locator(".laplace-lens .verdict")).to_be_visible(timeout=60_000)
    expect(page.get_by_text("Laplace DQN, seed 7")).to_be_visible(timeout=60_000)


@pytest.mark.parametrize("width", [1440, 390])
def test_the_page_fits_its_window(page, address, width):
    page.set_viewport_size({"width": width, "height": 844})
    page.goto(f"{address}/train")
    expect(card(page).or_(page.get_by_text("No run is here yet")).first).to_be_visible()
    page.wait_for_timeout(500)
    assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth + 1")


def test_a_run_is_removed_after_a_second_click(page, address):
    page.goto(f"{address}/train?environment=two_branch&t.seed=8&t.steps=1000000")
    page.get_by_role("button", name="Start training").click()
    mine = card(page, "laplace_two_branch_8")
    expect(mine).to_be_visible()
    mine.get_by_role("button", name="More").click()
    page.get_by_role("button", name="Remove ...").click()
    page.get_by_role("button", name="Yes, remove it for good").click()
    expect(mine).to_have_count(0, timeout=30_000)
