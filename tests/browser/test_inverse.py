"""The page of the inverse in a real browser: alpha is dragged on its pictures, and the link follows."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import expect

from tests.browser.support import PATIENCE, WATCH, runs_asked, settled

pytestmark = pytest.mark.browser
MADE = "() => document.querySelector('.laplace-inverse')?.inverse?.scene?.made"
TESTED = (
    "() => !/being tested/.test(document.querySelector('.laplace-inverse .verdict p')?.textContent ?? 'being tested')"
)


RIGHTMOST = """() => Math.max(...Array.from(document.querySelectorAll('.laplace-inverse *'))
  .filter((each) => each.checkVisibility()).map((each) => each.getBoundingClientRect().right))"""


def open_at(page, address, query=""):
    """The page of a link, once its pictures are drawn and its values tested; returns its sentence."""
    page.goto(f"{address}/inverse?{query}")
    page.wait_for_function(MADE)
    page.wait_for_function(TESTED)
    settled(page)
    return page.locator(".laplace-inverse .verdict")


def alpha(page) -> float:
    return page.evaluate("() => document.querySelector('.laplace-inverse').inverse.scene.state.alpha")


def drawn(page) -> np.ndarray:
    """The tau-space that is drawn."""
    return np.array(page.evaluate(f"() => Array.from(({MADE})().tau)"))


def hold(page, name, across, up=0.5):
    """Press the mouse on a picture, at shares of its width and height; returns what moves it there."""
    canvas = page.locator(f".laplace-inverse .{name} canvas")
    canvas.scroll_into_view_if_needed()
    box = canvas.bounding_box()

    def to(across, up=0.5):
        page.mouse.move(box["x"] + across * box["width"], box["y"] + up * box["height"])

    to(across, up)
    page.mouse.down()
    return to


@pytest.mark.parametrize("name", ["lcurve", pytest.param("rule-gcv", marks=pytest.mark.long)])
def test_a_drag_moves_the_timeline_at_once_and_the_link_when_it_ends(page, address, name):
    sentence = open_at(page, address, "world=two_branch&noise=0.001&action=long")
    expect(sentence).to_contain_text("Automatic, by the fitted network, takes alpha")
    before, first, runs = drawn(page), alpha(page), runs_asked(page)
    move = hold(page, name, 0.75, 0.4)
    move(0.9, 0.6)
    page.wait_for_function(
        "(first) => document.querySelector('.laplace-inverse').inverse.scene.made.alpha !== first", arg=first
    )
    settled(page)
    assert np.abs(drawn(page) - before).max() > 1e-3
    assert runs_asked(page) == runs
    assert "alpha" not in page.url
    dragged = alpha(page)
    page.mouse.up()
    expect(page).to_have_url(re.compile(r"alpha=[0-9.]+&selector=typed"))
    expect(sentence).to_contain_text("was set by hand; automatic takes")
    settled(page)
    assert float(re.search(r"alpha=([0-9.]+)", page.url)[1]) == dragged
    assert runs_asked(page) == runs + 1
    expect(page.get_by_role("combobox", name="Alpha rule")).to_have_value("By hand")


def test_the_non_negative_timeline_follows_the_drag_and_has_nothing_below_0(page, address):
    open_at(page, address, "world=two_branch&noise=0.001&action=long&solver=nonnegative")
    before = drawn(page)
    move = hold(page, "rule-gcv", 0.6)
    move(0.5)
    settled(page)
    assert np.abs(drawn(page) - before).max() > 1e-3
    assert drawn(page).min() >= 0
    page.mouse.up()
    expect(page).to_have_url(re.compile("alpha="))
    settled(page)


@pytest.mark.parametrize("solver", ["nonnegative", pytest.param("feasible", marks=pytest.mark.long)])
def test_the_band_of_a_solver_that_is_not_linear_is_drawn_after_release(page, address, solver):
    open_at(page, address, f"world=two_branch&noise=0.01&action=long&solver={solver}")
    note, host = page.locator(".laplace-inverse .rewards .note"), "document.querySelector('.laplace-inverse').inverse"
    expect(note).to_have_text("")
    first = page.evaluate(f"() => {host}.scene.told.band.noise")
    move = hold(page, "rule-gcv", 0.6)
    move(0.85)
    expect(note).to_have_text("band: after release")
    page.mouse.up()
    expect(page).to_have_url(re.compile("alpha="))
    expect(note).to_have_text("")
    assert page.evaluate(f"() => {host}.scene.told.band.noise") != first
    settled(page)


@pytest.mark.long
def test_the_feasible_timeline_answers_when_alpha_is_let_go_of(page, address):
    open_at(page, address, "world=two_branch&noise=0.001&action=long&solver=feasible")
    before = drawn(page)
    move = hold(page, "rule-gcv", 0.6)
    move(0.4)
    expect(page.locator(".laplace-inverse .tau-space .note")).to_contain_text("until release")
    page.mouse.up()
    expect(page).to_have_url(re.compile("alpha="))
    expect(page.locator(".laplace-inverse .tau-space .note")).to_have_text("")
    settled(page)
    assert np.abs(drawn(page) - before).max() > 1e-6


def test_arrow_keys_move_alpha_and_keys_held_down_are_one_release(page, address):
    open_at(page, address, "world=two_branch&noise=0.001&action=long")
    first, runs = alpha(page), runs_asked(page)
    page.get_by_role("slider", name="alpha, on L-curve", exact=True).focus()
    for _ in range(6):
        page.keyboard.press("ArrowRight")
    expect(page).to_have_url(re.compile("alpha="))
    settled(page)
    assert alpha(page) > 1.2 * first
    assert runs_asked(page) <= runs + 2


def test_the_cursor_over_alpha_and_horizon_sets_both(page, address):
    open_at(page, address, "world=two_decisions&noise=0.002")
    hold(page, "flips", 0.5, 0.75)
    page.mouse.up()
    expect(page).to_have_url(re.compile("horizon="))
    expect(page).to_have_url(re.compile("alpha="))
    expect(page.locator(".laplace-inverse .flips .note")).to_contain_text("at T")
    settled(page)


@pytest.fixture
def phone(chromium):
    """A page under a finger: what is dispatched to it, Chromium turns into pointers and scrolling as on a phone."""
    context = chromium.new_context(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    context.set_default_timeout(PATIENCE)
    context.add_init_script(WATCH)
    page = context.new_page()
    page.finger = context.new_cdp_session(page)
    yield page
    context.close()


def swipe(page, name, begin, end, steps=12):
    """Move a finger over a picture, from one place in pixels to another."""
    box = page.locator(f".laplace-inverse .{name} canvas").bounding_box()
    for i in range(steps + 1):
        x, y = (box[axis] + a + (b - a) * i / steps for axis, a, b in zip("xy", begin, end, strict=True))
        kind = "touchMove" if i else "touchStart"
        page.finger.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y}]})
    page.finger.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


def in_the_middle(page, name):
    """Bring a picture to the middle of the screen, so that there is room to scroll both ways; its size."""
    expect(page.get_by_text("is being tested")).to_have_count(0)  # what is found may take another number of lines
    canvas = page.locator(f".laplace-inverse .{name} canvas")
    canvas.evaluate("(canvas) => canvas.scrollIntoView({ block: 'center' })")
    settled(page)
    box = canvas.bounding_box()
    return box["width"], box["height"]


SCROLLED = "() => document.querySelector('[data-testid=stMain]').scrollTop"


@pytest.mark.parametrize(
    "name", ["lcurve", *(pytest.param(name, marks=pytest.mark.long) for name in ("rule-gcv", "flips"))]
)
def test_a_finger_drags_alpha(phone, address, name):
    open_at(phone, address, "world=two_decisions&noise=0.002&alpha=0.3&selector=typed")
    width, height = in_the_middle(phone, name)
    swipe(phone, name, (0.5 * width, 0.5 * height), (0.85 * width, 0.5 * height))
    expect(phone).to_have_url(re.compile("alpha=(?!0.3&)"))
    settled(phone)
    assert alpha(phone) > 0.4


def test_a_finger_moves_the_cursor_up_and_down_and_elsewhere_scrolls_the_page(phone, address):
    open_at(phone, address, "world=two_decisions&noise=0.002&alpha=0.03&selector=typed&horizon=4")
    width, height = in_the_middle(phone, "flips")
    at = phone.evaluate(SCROLLED)
    # The cursor lies at the upper end of the deadlines: far below it, and far from alpha, a finger scrolls.
    swipe(phone, "flips", (0.9 * width, 0.8 * height), (0.9 * width, 0.8 * height - 120))
    phone.wait_for_function(f"(at) => ({SCROLLED})() > at + 40", arg=at)
    settled(phone)
    assert "alpha=0.03&" in phone.url
    assert alpha(phone) == 0.03
    assert "horizon=4" in phone.url
    width, height = in_the_middle(phone, "flips")
    canvas = phone.locator(".laplace-inverse .flips canvas")
    before = canvas.bounding_box()["y"]
    top = phone.evaluate("() => document.querySelector('.laplace-inverse').inverse.scene.state.horizon")
    cursor = 22 + (height - 60) * 0.12  # within a finger's width of the row of the longest deadline
    swipe(phone, "flips", (0.6 * width, cursor), (0.6 * width, 0.75 * height))
    expect(phone).to_have_url(re.compile(r"horizon=[0-9.]+"))
    phone.wait_for_function(
        "(top) => document.querySelector('.laplace-inverse').inverse.scene.state.horizon < top", arg=top
    )
    settled(phone)
    assert canvas.bounding_box()["y"] == pytest.approx(before, abs=20)  # scrolled, it would have moved by some 200


def test_back_brings_the_alpha_before(page, address):
    open_at(page, address, "world=two_branch&noise=0.001&action=long&alpha=0.3&selector=typed")
    hold(page, "rule-gcv", 0.8)
    page.mouse.up()
    expect(page).to_have_url(re.compile("alpha=(?!0.3&)"))
    settled(page)
    page.go_back()
    expect(page).to_have_url(re.compile("alpha=0.3&"))
    page.wait_for_function("() => document.querySelector('.laplace-inverse').inverse.scene.made?.alpha === 0.3")
    settled(page)


@pytest.mark.long
def test_a_row_of_the_leaderboard_opens_its_solver(page, address):
    open_at(page, address, "world=two_branch&noise=0.001&action=long")
    page.get_by_text("Leaderboard: every solver with its own alpha").click()
    table = page.get_by_test_id("stDataFrame")
    expect(table).to_be_visible()
    settled(page)
    table.scroll_into_view_if_needed()
    box = table.bounding_box()
    page.mouse.click(box["x"] + 12, box["y"] + 35 * 7 + 18)  # the box before the seventh solver
    page.get_by_role("button", name="Show Non-negative").click()
    expect(page).to_have_url(re.compile("solver=nonnegative"))
    settled(page)


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(
    ("width", "height"), [(1440, 900), pytest.param(1024, 768, marks=pytest.mark.long), (390, 844)]
)
def test_nothing_is_wider_than_the_screen(page, address, scheme, width, height):
    page.set_viewport_size({"width": width, "height": height})
    page.emulate_media(color_scheme=scheme)
    expect(open_at(page, address)).to_be_visible()
    page.locator(".laplace-inverse .rule-aic summary").click()
    assert page.evaluate("() => document.documentElement.scrollWidth <= window.innerWidth + 1")
    assert page.evaluate(RIGHTMOST) <= width + 1


class Walk:
    """A new user, who uses visible labels only; ``clicks`` counts the controls pressed and the texts typed."""

    def __init__(self, page, address):
        self.page, self.clicks = page, 1
        page.goto(address)
        page.get_by_role("link", name="Inverse", exact=True).click()
        page.wait_for_function(TESTED)
        settled(page)

    def choose(self, label, option):
        box = self.page.get_by_role("combobox", name=label, exact=True)
        box.click()
        box.fill(option)
        expect(self.page.get_by_role("option", name=option, exact=True)).to_be_visible()
        asked = runs_asked(self.page)
        box.press("Enter")  # a list that opens while a section unfolds moves away from under a click
        self.page.wait_for_function("(asked) => window.watched.runs > asked", arg=asked)
        self.clicks += 2
        settled(self.page)

    def type(self, label, text):
        box = self.page.get_by_role("spinbutton", name=label, exact=True)
        box.fill(text)
        box.press("Enter")
        self.clicks += 1
        settled(self.page)

    def press(self, text):
        self.page.get_by_text(text, exact=True).click()
        self.clicks += 1
        settled(self.page)

    @property
    def sentence(self):
        self.page.wait_for_function(TESTED)
        return self.page.locator(".laplace-inverse .verdict").inner_text()


def test_a_new_user_finds_the_alpha_that_the_data_suggest_and_the_best_one(page, address):
    walk = Walk(page, address)
    walk.choose("World", "Fig. 6 chain")
    walk.type("Noise", "0.01")
    words = (
        r"takes alpha ([0-9.]+)\. (?:That is|It is (?:([0-9.]+) times|1/([0-9.]+) of)) the best alpha(?:, ([0-9.]+))?"
    )
    suggested, above, below, best = (
        None if number is None else float(number) for number in re.search(words, walk.sentence).groups()
    )
    if best is not None:
        assert (above or 1.0 / below) == pytest.approx(suggested / best, rel=0.02)
    assert walk.clicks <= 4


def test_a_new_user_finds_where_the_choice_turns(page, address):
    walk = Walk(page, address)
    walk.choose("World", "Two decisions in a row")
    turn = re.search(r"Chosen over T: (.+), (.+) from (\d+)", walk.sentence)
    early, late, horizon = turn.groups()
    canvas = page.get_by_role("slider", name="alpha, on Where the choice turns")
    canvas.focus()
    note = page.locator(".laplace-inverse .flips .note")
    expect(note).to_contain_text(late)
    for _ in range(4 - int(horizon) + 1):
        page.keyboard.press("ArrowDown")
    expect(note).to_contain_text(early)
    settled(page)
    first = note.inner_text()
    canvas.click(position={"x": 320, "y": 60})  # a large alpha, at a late deadline
    settled(page)
    assert first != note.inner_text()
    assert walk.clicks <= 4


def test_a_new_user_shows_that_values_of_mixed_policies_are_no_process(page, address):
    walk = Walk(page, address)
    walk.choose("World", "Two decisions in a row")
    assert "Some timeline may well have these values" in walk.sentence
    walk.press("Noise level, discounts, sensitivities")
    walk.choose("Target policy", "per gamma: one policy for each")
    assert "No feasible timeline has these values" in walk.sentence
    expect(page.locator(".laplace-inverse .verdict")).to_have_class(re.compile("bad"))
    assert walk.clicks <= 7


@pytest.mark.long
def test_a_new_user_compares_rules_on_random_worlds_and_takes_the_cases_along(page, address):
    walk = Walk(page, address)
    walk.press("Study solvers and rules on many worlds")
    walk.type("Cases of each world", "2")
    page.get_by_role("button", name="Run the study").click()
    csv = page.get_by_role("button", name="CSV of all cases")
    expect(page.get_by_role("button", name="Run the study")).to_have_count(0)
    expect(page.get_by_role("button", name="Cancel")).to_have_count(0)
    expect(page.locator(".js-plotly-plot")).to_have_count(2)
    expect(csv).to_be_visible()
    with page.expect_download() as taken:
        csv.click()
    rows = [line for line in Path(taken.value.path()).read_text().splitlines()[2:] if line]
    assert len(rows) == 2 * 3 * 2 * 4  # worlds, noises, solvers; the best alpha and three rules
    assert walk.clicks + 2 <= 5
    settled(page)
