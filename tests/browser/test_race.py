"""A deadline race in a real browser: where the sides part, scrubbing, many starts, and the numbers by the library."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import expect

from laplace_core.acting.race import Entrant, race, races
from laplace_core.training.checkpoint import load_checkpoint
from tests.browser.support import settled

pytestmark = pytest.mark.browser
CHECKPOINT = Path(__file__).resolve().parents[2] / "checkpoints" / "laplace_LunarLander-v3.safetensors"
T, START, COUNT = 20, 3, 6


@pytest.fixture(scope="module")
def sides():
    agent = load_checkpoint(CHECKPOINT).agent
    return "LunarLander-v3", Entrant(agent), Entrant(agent, "fading")


def shown(page) -> list[str]:
    """The returns under the cursor, left and right."""
    return page.locator(".laplace-track output").all_inner_texts()


def returns_after(found, step: int) -> list[str]:
    return [f"{side.rewards[:step].sum():.1f}" for side in (found.left, found.right)]


def test_a_race_is_watched_and_then_run_from_many_starts(page, address, sides):
    one, many = race(*sides, START, horizon=T), races(*sides, T, count=COUNT)
    page.goto(f"{address}/race?d.T={T}&d.start={START}&d.starts={COUNT}")
    page.locator(".laplace-track canvas").wait_for()
    assert shown(page) == returns_after(one, T)
    page.get_by_role("button", name="first apart").click()
    assert shown(page) == returns_after(one, one.parting + 1)
    page.wait_for_url(f"**d.at={one.parting + 1}*")
    page.get_by_role("button", name="last step").click()

    page.get_by_role("button", name=f"Race over {COUNT} starts").click()
    page.locator(".race-facts").wait_for()
    with page.expect_download() as download:
        page.get_by_role("button", name="CSV", exact=True).click()
    rows = list(csv.DictReader(io.StringIO(Path(download.value.path()).read_text())))
    np.testing.assert_allclose([float(row["difference"]) for row in rows], many.differences, atol=1e-6)
    page.get_by_role("button", name="best", exact=True).click()
    best = many.notable()["best"]
    page.get_by_text(f"from start {best}:").wait_for()
    page.wait_for_url(f"**d.start={best}*")
    assert page.get_by_label("Start", exact=True).input_value() == str(best)


def test_to_move_the_cursor_needs_no_server_and_it_plays(page, address, sides):
    one = race(*sides, START, horizon=T)
    page.goto(f"{address}/race?d.T={T}&d.start={START}")
    page.locator(".laplace-track canvas").wait_for()
    page.route("**/*", lambda route: route.abort())  # whatever is not there by now does not come
    for step in (0, 1, 7, T):
        page.locator("input[name=over]").evaluate(
            "(input, step) => { input.value = step; input.dispatchEvent(new Event('input')); }", step
        )
        assert shown(page) == returns_after(one, step)
    page.wait_for_function(
        "() => [...document.querySelectorAll('.laplace-track img')].every((one) => one.naturalHeight === 180)"
    )
    page.get_by_role("button", name="play", exact=True).click()  # at the end: from the start again
    page.wait_for_function(
        "() => { const at = +document.querySelector('input[name=over]').value; return at > 2 && at < 20; }"
    )
    page.wait_for_function("() => +document.querySelector('input[name=over]').value === 20")
    page.get_by_role("button", name="play", exact=True).wait_for()


@pytest.mark.parametrize("width", [390, 1024, 1200, 1440])
def test_the_numbers_of_both_sides_are_seen_whole(page, address, width):
    """Beside a sidebar there is less room than on the screen: a return was hidden under the other side's picture."""
    page.set_viewport_size({"width": width, "height": 800})
    page.goto(f"{address}/race?d.T={T}&d.start={START}")
    page.locator(".laplace-track canvas").wait_for()
    outside = page.locator(".laplace-track .lane").evaluate_all(
        "(lanes) => lanes.flatMap((lane) => [...lane.querySelectorAll('output, b, h2')].filter((words) =>"
        " words.getBoundingClientRect().right > lane.getBoundingClientRect().right + 1 || words.scrollWidth > "
        " words.clientWidth + 1).map((words) => words.textContent))"
    )
    assert outside == []


LONG = "d.T=1000&d.left=decoded&d.right=decoded"
"""Some 2,000 steps that are decoded one by one: a minute, more or less."""


@pytest.mark.long
def test_a_link_to_long_races_leaves_them_to_a_person_who_sees_the_cost_and_the_place_in_line(page, chromium, address):
    page.goto(f"{address}/race?{LONG}&d.start=1&d.many=yes&d.starts=500")
    page.get_by_text(re.compile(r"^This takes about \d+ (seconds|minutes)\.$")).wait_for()
    page.get_by_text(re.compile("This takes about .* lower T or the number of starts")).wait_for()
    expect(page.get_by_role("button", name="Race over 500 starts")).to_be_disabled()
    settled(page)
    expect(page.get_by_role("progressbar")).to_have_count(0)

    other = chromium.new_context().new_page()
    other.goto(f"{address}/race?{LONG}&d.start=2&d.many=yes&d.starts=40")  # forty, so that it outlasts what follows
    other.get_by_role("button", name="Race over 40 starts").click()
    expect(other.get_by_text(re.compile("Racing: step"))).to_be_visible()
    page.get_by_role("button", name="Race", exact=True).click()
    expect(page.get_by_text("Waits: 1 other is before this one")).to_be_visible()

    page.reload()  # another session: it has its place still
    expect(page.get_by_text("Waits: 1 other is before this one")).to_be_visible()
    page.get_by_role("button", name="Cancel").click()
    expect(page.get_by_role("button", name="Race", exact=True)).to_be_enabled()
    expect(page.get_by_role("progressbar")).to_have_count(0)
    expect(other.get_by_text(re.compile("Racing: step"))).to_be_visible()
    other.get_by_role("button", name="Cancel").click()
    expect(other.get_by_role("button", name="Race over 40 starts")).to_be_enabled()
    other.context.close()
