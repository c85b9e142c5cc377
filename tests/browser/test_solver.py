"""Solver and rule for alpha in a real browser, on Worlds and on Trained agents: chosen, dragged, linked, offered."""

from __future__ import annotations

import re

import numpy as np
import pytest
from playwright.sync_api import expect

from laplace_core import Settings, load_world, study
from tests.browser.support import DRAWN, comes_to_show, runs_asked, settled, tau_space

pytestmark = pytest.mark.browser
PAGES = {"worlds": "?world=rise_and_fade&thetas=40&noise=0.001", "agents": "agents?checkpoint=laplace_CartPole-v1"}


def open_at(page, address, query):
    page.goto(f"{address}/{query}")
    page.wait_for_function(DRAWN)
    settled(page)


def pick(page, label, option):
    box = page.get_by_role("combobox", name=label)
    box.scroll_into_view_if_needed()  # a list that opens at the edge of the page is not all there
    box.click()
    box.press_sequentially(option)
    page.get_by_role("option", name=option, exact=True).click()
    settled(page)


def alpha(page):
    return page.locator(".slider", has=page.locator("input[name=alpha]")).locator("output")


@pytest.mark.parametrize("name", ["worlds", pytest.param("agents", marks=pytest.mark.long)])
def test_a_solver_and_a_rule_are_chosen_and_their_link_shows_the_same_picture(page, address, name):
    open_at(page, address, PAGES[name])
    first = tau_space(page)
    pick(page, "Solver", "Non-negative")
    expect(page).to_have_url(re.compile("solver=nonnegative"))
    positive = tau_space(page)
    assert first.min() < -1e-4
    assert positive.min() >= 0.0
    pick(page, "Alpha rule", "Automatic")
    expect(page).to_have_url(re.compile("selector=auto"))
    expect(alpha(page)).to_contain_text("· Automatic")
    chosen, words = tau_space(page), alpha(page).text_content()
    open_at(page, address, page.url.partition(f"{address}/")[2])
    comes_to_show(page, chosen)
    assert alpha(page).text_content() == words
    expect(page.get_by_role("combobox", name="Solver")).to_have_value("Non-negative")

    # A drag takes alpha from the rule: the non-negative timeline follows it before the server knows.
    runs = runs_asked(page)
    page.locator("input[name=alpha]").evaluate(
        "(input) => { input.value = +input.value - 20; input.dispatchEvent(new Event('input')); }"
    )
    page.wait_for_function(
        "(before) => document.querySelector('.laplace-lens').lens.seen.tau.some((value, i) => value !== before[i])",
        arg=chosen.ravel().tolist(),
    )
    expect(alpha(page)).not_to_contain_text("Automatic")
    assert runs_asked(page) == runs
    dragged = tau_space(page)
    assert dragged.min() >= 0.0
    page.locator("input[name=alpha]").evaluate("(input) => input.dispatchEvent(new Event('change'))")
    expect(page).to_have_url(re.compile("alpha="))
    settled(page)
    comes_to_show(page, dragged)
    expect(page.get_by_role("combobox", name="Alpha rule")).to_have_value("By hand")


@pytest.mark.long
def test_survival_above_1_offers_the_feasible_timeline_in_one_click(page, address):
    open_at(page, address, "?world=two_branch&thetas=20&noise=0.01&alpha=0.01")
    assert page.evaluate("() => Math.max(...document.querySelector('.laplace-lens').lens.seen.survival.flatMap("
                         "(line) => [...line]))") > 1.05  # fmt: skip
    page.locator(".laplace-lens .verdict").get_by_role("button", name="Use the feasible timeline").click()
    expect(page).to_have_url(re.compile("solver=feasible"))
    settings = Settings(thetas=20, noise=0.01, alpha=0.01, solver="feasible")
    comes_to_show(page, study(load_world("two_branch"), settings).decoded.tau_space[0])
    settled(page)
    expect(page.get_by_role("button", name="Use the feasible timeline")).to_have_count(0)

    # The server runs this solver: until alpha is released, the timeline stays and the sentence says so.
    before = tau_space(page)
    slider = page.locator("input[name=alpha]")
    slider.evaluate("(input) => { input.value = +input.value + 80; input.dispatchEvent(new Event('input')); }")
    expect(page.locator(".laplace-lens .verdict")).to_contain_text("Not computed yet.")
    np.testing.assert_array_equal(tau_space(page), before)
    slider.evaluate("(input) => input.dispatchEvent(new Event('change'))")
    expect(page.locator(".laplace-lens .verdict")).not_to_contain_text("Not computed yet.")
    assert np.abs(tau_space(page) - before).max() > 1e-3
