"""The feasible timeline of a large view in a real browser: the linear one is there at once, the feasible one comes."""

from __future__ import annotations

import re

import numpy as np
import pytest
from playwright.sync_api import expect

from laplace_core import Settings, load_world, study
from tests.browser.support import DRAWN, comes_to_show, settled

pytestmark = pytest.mark.browser
SIZE = {"thetas": 400, "steps": 100, "gammas": 30, "alpha": 0.05}
"""A few seconds of the feasible solver."""
COMING = "The feasible timeline is being computed; this is the linear one."
HERE = "This is the linear timeline."


def query(**changes):
    return "&".join(f"{name}={value}" for name, value in {**SIZE, **changes}.items())


def decoded(**changes):
    settings = Settings(world="two_branch", **{**SIZE, **changes})
    return study(load_world("two_branch"), settings).decoded.tau_space[0]


def cancel(page):
    page.get_by_role("button", name="Cancel", exact=True).click()
    expect(page.get_by_text(HERE)).to_be_visible()
    settled(page)


@pytest.fixture(scope="module")
def linear():
    return decoded()


@pytest.fixture(scope="module")
def feasible():
    return decoded(solver="feasible")


def open_at(page, address, **changes):
    """A page with the linear timeline, at rest."""
    page.goto(f"{address}/?world=two_branch&{query(**changes)}")
    page.wait_for_function(DRAWN)
    settled(page)


def choose(page):
    """Choose the feasible solver, and wait until the page says what it does."""
    box = page.get_by_role("combobox", name="Solver")
    box.scroll_into_view_if_needed()
    box.click()
    page.get_by_role("option", name="Feasible timeline", exact=True).click()
    expect(page.get_by_text(COMING)).to_be_visible()


@pytest.mark.long
def test_the_linear_timeline_is_drawn_until_the_feasible_one_is_there(page, address, linear, feasible):
    open_at(page, address)
    comes_to_show(page, linear)
    choose(page)
    comes_to_show(page, linear)
    top = page.locator(".laplace-lens").bounding_box()["y"]
    cancel(page)
    comes_to_show(page, linear)
    tops = [page.locator(".laplace-lens").bounding_box()["y"]]
    page.get_by_role("button", name="Compute the feasible timeline").click()
    comes_to_show(page, feasible)
    settled(page)
    expect(page.get_by_text(re.compile("linear (one|timeline)"))).to_have_count(0)
    tops.append(page.locator(".laplace-lens").bounding_box()["y"])
    assert tops == pytest.approx([top, top], abs=1.0), "the pictures stay where they are"

    # Another horizon is read from the same timeline.
    page.locator("input[name=horizon]").press("ArrowLeft")
    page.wait_for_function("() => location.search.includes('horizon=')")
    settled(page)
    comes_to_show(page, feasible)


@pytest.mark.long
def test_what_is_asked_for_last_is_computed(page, address):
    open_at(page, address, alpha=0.11)
    choose(page)
    slider = page.locator("input[name=alpha]")
    slider.evaluate("(input) => { input.value = +input.value + 20; input.dispatchEvent(new Event('input')); }")
    slider.evaluate("(input) => input.dispatchEvent(new Event('change'))")
    page.wait_for_function("() => !location.search.includes('alpha=0.11')")
    settled(page)
    alpha = float(re.search(r"alpha=([^&]+)", page.url)[1])
    comes_to_show(page, decoded(solver="feasible", alpha=alpha))


@pytest.mark.long
def test_the_page_of_the_inverse_draws_the_linear_timeline_first(page, address):
    page.goto(f"{address}/inverse?world=two_branch&{query(alpha=0.13)}")
    page.wait_for_function("() => document.querySelector('.laplace-inverse')?.inverse?.scene?.made")
    settled(page)
    choose(page)
    page.wait_for_function("() => document.querySelector('.laplace-inverse').inverse.scene.model.arrays.decoded")
    settled(page)
    expect(page.get_by_text(COMING)).to_have_count(0)
    shown = page.evaluate("() => Array.from(document.querySelector('.laplace-inverse').inverse.scene.made.tau)")
    expected = decoded(solver="feasible", alpha=0.13, weighting="deviation")
    np.testing.assert_allclose(np.reshape(shown, expected.shape), expected, atol=1e-5)
