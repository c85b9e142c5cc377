"""What a person does on the workbench, in a real browser."""

from __future__ import annotations

import re
import shlex

import numpy as np
import pytest
from playwright.sync_api import expect

from laplace_core.cli import main
from tests.browser.support import ask_why, comes_to_differ, module_of, open_at, runs_asked, settled, tau_space

pytestmark = pytest.mark.browser


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


def test_a_slider_moves_the_picture_at_once_and_the_link_on_release(page, address):
    open_at(page, address, "world=two_branch&action=long")
    before = tau_space(page)
    page.locator("input[name=alpha]").focus()
    for _ in range(8):
        page.keyboard.press("ArrowLeft")
    comes_to_differ(page, before)
    expect(page).to_have_url(re.compile(r"alpha=0\.1[0-9]*"))


def test_the_download_equals_what_the_shown_command_computes(page, address, tmp_path):
    open_at(page, address, "world=two_branch&normalise=paper&alpha=0.1")
    page.get_by_role("button", name="Download", exact=True).click()
    with page.expect_download() as waiting:
        page.get_by_role("button", name=re.compile("^NPZ: every")).click()
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
    point = page.locator(".laplace-lens .world").locator(".scatterlayer .trace .points path.point").nth(1)
    settled(page)
    box = point.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    expect(page).to_have_url(re.compile("state=long"))


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(("width", "height"), [(1440, 900), (390, 844)])
def test_nothing_is_wider_than_the_screen_and_the_verdict_comes_first(page, address, scheme, width, height):
    page.set_viewport_size({"width": width, "height": height})
    page.emulate_media(color_scheme=scheme)
    verdict = open_at(page, address)
    expect(verdict).to_be_visible()
    assert page.evaluate("() => document.documentElement.scrollWidth <= window.innerWidth + 1")
    assert verdict.bounding_box()["y"] < height / 3


def test_the_page_does_not_jump_between_verdicts(page, address):
    verdict = open_at(page, address)
    places = [page.locator(f".laplace-lens {name}") for name in (".world", "canvas.values", ".leading", ".footer")]
    before = [place.bounding_box()["y"] for place in places]
    page.get_by_role("button", name="Keep survival").first.click()
    expect(verdict).to_have_class(re.compile("ok"))
    assert [place.bounding_box()["y"] for place in places] == pytest.approx(before, abs=1)


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


def test_a_release_is_answered_without_sending_the_payload_again(page, address):
    open_at(page, address, "world=cliff_grid")
    settled(page)
    largest = "() => Math.max(...window.watched.received.splice(0))"
    opening = page.evaluate(largest)
    for _ in range(2):
        before, link = runs_asked(page), page.url
        page.locator("input[name=alpha]").press("ArrowLeft")
        settled(page)
        assert runs_asked(page) == before + 1
        assert page.url != link
        answer = page.evaluate(largest)
    assert 0 < answer < 0.5 * opening
    assert "cliff_grid" in page.url


def test_a_browser_that_has_lost_the_payload_asks_for_it(page, address):
    open_at(page, address, "world=two_branch")
    page.locator("input[name=alpha]").press("ArrowLeft")
    expect(page).to_have_url(re.compile("alpha="))
    settled(page)
    models = module_of(page, "lens/models.js")
    models.evaluate("({ models }) => models.clear()")
    page.locator("input[name=alpha]").press("ArrowLeft")
    expect(page).to_have_url(re.compile("alpha=0.18"))
    page.wait_for_function("({ models }) => models.size === 1", arg=models)


def test_the_library_s_verdict_and_the_one_of_the_lens_begin_alike(page, address):
    verdict = open_at(page, address, "world=two_branch&normalise=paper")
    expect(verdict).to_contain_text("Cause: repeated reward")
    ask_why(page)
    page.get_by_role("switch", name="index shifted").click()
    expect(page).to_have_url(re.compile("shift=true"))
    expect(verdict).to_contain_text("At T = 3 the decoded values choose")
    page.get_by_role("switch", name="index shifted").click()
    expect(verdict).to_contain_text("Cause: repeated reward")


def test_a_switch_of_the_lens_is_blamed_by_the_library(page, address):
    verdict = open_at(page, address, "world=two_branch&shift=yes&alpha=0.01&horizon=1")
    expect(verdict).to_contain_text("Cause: shifted index")
    page.get_by_role("button", name="Undo the index shift").first.click()
    expect(verdict).to_have_class(re.compile("ok"))
    expect(page).not_to_have_url(re.compile("shift"))


# The sentence of the verdict that lies outside of its box, in pixels, and whether its box can be scrolled.
_CLIPPED = """() => {
  const box = document.querySelector('.laplace-lens .verdict'), words = box.querySelector('p');
  const [outer, inner] = [box, words].map((each) => each.getBoundingClientRect());
  return [words.scrollHeight - words.clientHeight, box.scrollHeight - box.clientHeight, inner.bottom - outer.bottom,
    inner.right - innerWidth].map((much) => Math.max(0, Math.round(much)));
}"""


@pytest.mark.long
def test_the_verdict_is_whole_at_every_width(page, address, subtests):
    """Windows of 390 to 1920 pixels; a zoom of 200% is a window of half the width."""
    open_at(page, address, "world=fig6_chain&alpha=10")
    settled(page)
    for width in (390, 640, 641, 720, 800, 900, 960, 1024, 1100, 1101, 1280, 1920):
        with subtests.test(width=width):
            page.set_viewport_size({"width": width, "height": 900})
            settled(page)
            assert page.evaluate(_CLIPPED) == [0, 0, 0, 0]


def test_the_graph_of_the_world_keeps_its_size_in_another_theme(page, address):
    open_at(page, address, "world=cliff_grid")
    settled(page)
    graph = page.locator(".laplace-lens .world")
    sizes = "(graph) => [graph.clientHeight, graph._fullLayout.height]"
    height, drawn = graph.evaluate(sizes)
    assert drawn == height
    page.emulate_media(color_scheme="dark")
    page.wait_for_function("() => document.querySelector('.laplace-lens .world')._fullLayout.font.color === '#e6e9ed'")
    settled(page)
    assert graph.evaluate(sizes) == [height, height]
