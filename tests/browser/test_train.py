"""Training as a person watches it: it moves, a reload and another tab find it, it stops, goes on, and is opened."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import expect

from tests.browser.support import settled

pytestmark = pytest.mark.browser

RUN = "laplace_two_branch_7"
LONG = "environment=two_branch&t.seed=7&t.steps=1000000&t.evaluate_every=300&t.hidden=16&t.batch=16"


def card(page, name=RUN):
    return page.locator(f".st-key-run_{name}")


def state(page):
    return card(page).locator(".run-state")


def steps(page) -> int:
    expect(card(page)).to_contain_text(re.compile(r"of [\d,]+ steps"))
    return int(re.search(r"([\d,]+) of [\d,]+ steps", card(page).inner_text())[1].replace(",", ""))


def later(page, step: int) -> int:
    """The step once it is beyond ``step``."""
    page.wait_for_function(
        """([name, step]) => {
        const words = document.querySelector(`.st-key-run_${name}`)?.innerText ?? '';
        return +(words.match(/([\\d,]+) of [\\d,]+ steps/)?.[1] ?? '0').replaceAll(',', '') > step; }""",
        arg=[RUN, step],
    )
    return steps(page)


def scores(plot) -> int:
    """Evaluations that the picture really draws."""
    return plot.evaluate("(p) => p._fullData.at(-1).x.length")


def test_a_run_moves_is_found_again_stops_goes_on_and_is_opened(page, address):
    page.goto(f"{address}/train?{LONG}")
    page.get_by_role("button", name="Start training").click()
    expect(state(page)).to_have_text("training")
    first = later(page, 0)
    page.wait_for_function("() => document.querySelectorAll('.js-plotly-plot .main-svg').length >= 3")
    plot = page.locator(".js-plotly-plot[data-name='training']")
    plot.evaluate("(p) => { p.marked = true; }")
    expect(card(page)).to_contain_text("best evaluation")
    before = scores(plot)
    page.wait_for_function(
        "([plot, before]) => plot._fullData.at(-1).x.length > before", arg=[plot.element_handle(), max(1, before)]
    )
    assert plot.evaluate("(p) => p.marked")  # the same element, updated
    second = later(page, first)

    page.reload()
    expect(state(page)).to_have_text("training")
    assert steps(page) >= second
    other = page.context.new_page()
    other.goto(f"{address}/train")
    expect(state(other)).to_have_text("training")
    other.close()

    card(page).get_by_role("button", name="Cancel").click()
    expect(state(page)).to_have_text("stopped")
    stopped = steps(page)
    page.reload()
    expect(state(page)).to_have_text("stopped")
    assert steps(page) == stopped
    card(page).get_by_role("button", name="Resume").click()
    expect(state(page)).to_have_text("training")
    later(page, stopped)
    card(page).get_by_role("button", name="Cancel").click()
    expect(state(page)).to_have_text("stopped")

    settled(page)  # the poll has ended
    card(page).get_by_role("button", name="Open in Trained agents").click()
    expect(page).to_have_url(re.compile(f"agents.*checkpoint=run%3A{RUN}"))
    expect(page.locator(".laplace-lens .verdict")).to_be_visible(timeout=60_000)
    expect(page.get_by_text("Laplace DQN, seed 7")).to_be_visible(timeout=60_000)


@pytest.mark.parametrize("width", [1440, 390])
def test_the_page_fits_its_window(page, address, width):
    page.set_viewport_size({"width": width, "height": 844})
    page.goto(f"{address}/train")
    expect(card(page).or_(page.get_by_text("There is no run yet")).first).to_be_visible()
    settled(page)
    assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth + 1")


def test_a_run_is_removed_after_a_second_click(page, address):
    page.goto(f"{address}/train?environment=two_branch&t.seed=8&t.steps=1000000")
    page.get_by_role("button", name="Start training").click()
    name = "laplace_two_branch_8"
    mine = card(page, name)
    # While cards make room for a new one, what was in its place may still be there: this is its own button.
    mine.locator(f".st-key-more_{name}").get_by_role("button", name="More").click()
    page.get_by_role("button", name="Remove ...").click()
    page.get_by_role("button", name=f"Yes, remove {name} for good").click()
    expect(mine).to_have_count(0)


def started(page, address: str, seed: int) -> str:
    """Begin a long run; returns its name."""
    page.goto(f"{address}/train?environment=two_branch&t.seed={seed}&t.steps=1000000&t.hidden=16&t.batch=16")
    page.get_by_role("button", name="Start training").click()
    name = f"laplace_two_branch_{seed}"
    expect(card(page, name).locator(f".st-key-more_{name}")).to_be_visible()
    return name


def removed(page, name: str) -> None:
    card(page, name).get_by_role("button", name="More").click()
    page.get_by_role("button", name="Remove ...").click()
    page.get_by_role("button", name=f"Yes, remove {name} for good").click()
    expect(card(page, name)).to_have_count(0)


@pytest.mark.long
def test_another_browser_sees_a_run_and_cannot_change_it(page, chromium, address):
    name = started(page, address, 21)
    stranger = chromium.new_context()
    other = stranger.new_page()
    other.goto(f"{address}/train")
    expect(card(other, name)).to_contain_text("Started in another browser.")
    expect(card(other, name).get_by_role("button", name="Show")).to_be_visible()
    for words in ("Cancel", "More"):
        expect(card(other, name).get_by_role("button", name=words)).to_have_count(0)
    stranger.close()
    page.reload()
    expect(card(page, name).get_by_role("button", name="More")).to_be_visible()
    removed(page, name)


@pytest.mark.long
def test_two_tabs_of_one_browser_that_open_at_once_are_one_owner(chromium, address):
    context = chromium.new_context()
    first, second = context.new_page(), context.new_page()
    for tab in (first, second):
        tab.goto(f"{address}/train?environment=two_branch")
    for tab in (first, second):
        expect(tab.get_by_role("button", name="Start training")).to_be_visible()
        tab.wait_for_function("() => document.cookie.includes('laplace_owner=')")
        settled_tab(tab)
    name = started(second, address, 22)
    first.goto(f"{address}/train")
    removed(first, name)
    context.close()


def settled_tab(tab) -> None:
    """Until Streamlit has nothing to do."""
    expect(tab.locator("[data-testid='stStatusWidget']")).to_have_count(0)


WATCH_CARDS = """
() => {
  window.strange = [];
  const look = () => {
    for (const card of document.querySelectorAll("[class*='st-key-run_laplace']")) {
      const name = [...card.classList].find((each) => each.startsWith('st-key-run_')).slice('st-key-run_'.length);
      for (const part of card.querySelectorAll("[class*='st-key-']")) {
        const key = [...part.classList].find((each) => /^st-key-(cancel|open|show|more)/.test(each));
        if (key && !key.endsWith(name)) window.strange.push(`${name}: ${key}`);
      }
    }
  };
  new MutationObserver(look).observe(document.body, { childList: true, subtree: true, attributes: true });
}
"""


@pytest.mark.long
def test_a_card_never_holds_the_buttons_of_another_run(page, address):
    """When a new run moves the cards, each of which gets another place."""
    names = [started(page, address, 31)]
    page.evaluate(WATCH_CARDS)
    for seed in (32, 33):
        page.get_by_role("spinbutton", name="Seed").fill(str(seed))
        page.get_by_role("spinbutton", name="Seed").press("Enter")
        expect(page).to_have_url(re.compile(rf"t\.seed={seed}"))
        page.get_by_role("button", name="Start training").click()
        names.append(f"laplace_two_branch_{seed}")
        expect(card(page, names[-1]).locator(f".st-key-more_{names[-1]}")).to_be_visible()
    for name in names:
        removed(page, name)
    assert page.evaluate("() => window.strange") == []
