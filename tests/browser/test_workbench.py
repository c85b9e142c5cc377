"""What a person does on the workbench, in a real browser."""

from __future__ import annotations

import re
import shlex

import numpy as np
import pytest
from playwright.sync_api import expect

from laplace_core.cli import main

pytestmark = pytest.mark.browser


def open_at(page, address, query=""):
    page.goto(f"{address}/?{query}" if query else address)
    page.wait_for_function("() => document.querySelectorAll('.js-plotly-plot .main-svg').length >= 5")
    return page.locator(".verdict")


def test_the_first_view_and_both_remedies(page, address):
    verdict = open_at(page, address)
    expect(verdict).to_have_class(re.compile("bad"))
    expect(verdict).to_contain_text("14.85 v 9.74")
    page.get_by_role("button", name="Add auxiliary states").first.click()
    expect(verdict).to_have_class(re.compile("ok"))
    expect(verdict).to_contain_text("choose long")
    expect(page).to_have_url(re.compile(r"p\.auxiliary=true"))
    verdict = open_at(page, address)
    page.get_by_role("button", name="Keep survival").first.click()
    expect(verdict).to_have_class(re.compile("ok"))
    expect(verdict).to_contain_text("choose long")


def test_a_slider_moves_the_picture_and_the_link(page, address):
    open_at(page, address, "world=two_branch&action=long")
    before = tau_space(page)
    slider = page.get_by_role("slider", name="alpha")
    slider.focus()
    for _ in range(8):
        page.keyboard.press("ArrowLeft")
    expect(page).to_have_url(re.compile(r"alpha=0\.0[0-9]+"))
    for _ in range(50):  # the picture follows the link by one draw
        if tau_space(page) not in (None, before):
            break
        page.wait_for_timeout(100)
    assert tau_space(page) not in (None, before)


def tau_space(page) -> str | None:
    """The decoded values that the tau-space chart really draws, as text; None while it is drawn anew."""
    return page.evaluate(
        """() => { const plots = [...document.querySelectorAll('.js-plotly-plot')];
        const tau = plots.find((p) => p.layout && p.layout.title.text.includes('tau-space'));
        return tau && JSON.stringify(Array.from(tau._fullData[0].z, (row) => Array.from(row))); }"""
    )


def test_the_download_equals_what_the_shown_command_computes(page, address, tmp_path):
    open_at(page, address, "world=two_branch&normalise=paper&alpha=0.1")
    page.get_by_role("button", name="Download", exact=True).click()
    with page.expect_download() as waiting:
        page.get_by_role("button", name=re.compile("^NPZ")).click()
    page.keyboard.press("Escape")
    waiting.value.save_as(tmp_path / "page.npz")
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.get_by_role("button", name="Copy", exact=True).click()
    page.get_by_role("button", name="Copy as command").click()
    expect(page.get_by_role("button", name="Copied")).to_be_visible()
    command = page.evaluate("() => navigator.clipboard.readText()")
    words = shlex.split(command)[3:]
    words[words.index("--out") + 1] = str(tmp_path / "command.npz")
    assert main(words) == 0
    seen, told = np.load(tmp_path / "page.npz"), np.load(tmp_path / "command.npz")
    assert set(seen.files) == set(told.files)
    for name in seen.files:
        if name != "settings":
            np.testing.assert_array_equal(seen[name], told[name])


def test_a_click_on_a_state_looks_from_there(page, address):
    open_at(page, address, "world=two_branch")
    point = page.locator(".js-plotly-plot").first.locator(".scatterlayer .trace .points path.point").nth(1)
    box = point.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    expect(page).to_have_url(re.compile("state=long"))


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(("width", "height"), [(1440, 900), (390, 844)])
def test_nothing_is_wider_than_the_screen_and_the_verdict_comes_first(chromium, address, scheme, width, height):
    context = chromium.new_context(viewport={"width": width, "height": height}, color_scheme=scheme)
    page = context.new_page()
    verdict = open_at(page, address)
    expect(verdict).to_be_visible()
    assert page.evaluate("() => document.documentElement.scrollWidth <= window.innerWidth + 1")
    assert verdict.bounding_box()["y"] < height / 3
    context.close()


def test_the_page_does_not_jump_between_verdicts(page, address):
    verdict = open_at(page, address)
    chart = page.locator(".js-plotly-plot").first
    before = chart.bounding_box()["y"]
    page.get_by_role("button", name="Keep survival").first.click()
    expect(verdict).to_have_class(re.compile("ok"))
    assert chart.bounding_box()["y"] == pytest.approx(before, abs=1)


def test_the_formulas_are_set(page, address):
    open_at(page, address)
    page.get_by_role("button", name="How to read this").click()
    page.wait_for_selector(".katex")
    assert page.locator(".katex-error").count() == 0
    assert page.locator(".katex-display").count() == 4


def test_back_returns_to_the_view_before(page, address):
    verdict = open_at(page, address, "world=two_branch&normalise=paper")
    expect(verdict).to_have_class(re.compile("bad"))
    page.get_by_role("button", name="Keep survival").first.click()
    expect(verdict).to_have_class(re.compile("ok"))
    expect(page).to_have_url(re.compile("normalise=none"))
    page.go_back()
    expect(verdict).to_have_class(re.compile("bad"))
    expect(page).to_have_url(re.compile("normalise=paper"))


def test_no_picture_is_offered_to_a_third_party(page, address):
    open_at(page, address)
    titles = page.evaluate("() => [...document.querySelectorAll('.modebar-btn')].map((b) => b.dataset.title)")
    assert titles
    assert not [title for title in titles if "share" in title.lower() or "cloud" in title.lower()]


def test_zoom_survives_a_change_of_alpha(page, address):
    open_at(page, address, "world=cliff_grid")
    zoom = "(p) => Plotly.relayout(p, {'xaxis.range': [8, 11]})"
    chart = page.locator(".js-plotly-plot", has_text="tau-space")
    chart.evaluate(zoom)
    page.get_by_role("slider", name="alpha").focus()
    page.keyboard.press("ArrowLeft")
    expect(page).to_have_url(re.compile("alpha="))
    page.wait_for_timeout(1000)
    assert chart.evaluate("(p) => p.layout.xaxis.range.map(Math.round)") == [8, 11]
