"""Pages that everybody can use: by the rules of WCAG 2.2 AA, by keys alone, in small windows and without motion."""

from __future__ import annotations

import contextlib
import itertools
import re
from typing import NamedTuple

import pytest

from tests.browser.support import ROOT, ask_why, open_at, settled

pytestmark = pytest.mark.usefixtures("chromium")
playwright = pytest.importorskip("playwright.sync_api")
expect = playwright.expect

AXE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]


class Page(NamedTuple):
    path: str
    title: str
    picture: str
    """What is drawn last."""
    explains: bool = False
    """Whether it has a lens, with its part 'Why?' and its dialog for print."""
    skip: str = "Skip to the picture"


PAGES = {
    "worlds": Page("", "Worlds", ".laplace-lens canvas", explains=True),
    "inverse": Page("inverse", "Inverse", ".laplace-inverse canvas"),
    "agents": Page("agents", "Trained agents", ".laplace-lens canvas", explains=True),
    "race": Page("race", "Deadline race", ".laplace-track canvas"),
    "train": Page("train", "Train", ".laplace-chart .main-svg"),
    "paper": Page("paper", "Paper", ".laplace-chart .main-svg"),
    "guide": Page("guide", "Guide", "pre", skip="Skip to the text"),
}


def opened(page, address, name, *, why=False):
    path, _, picture, explains, _ = PAGES[name]
    page.goto(f"{address}/{path}")
    page.locator(f"[data-testid=stMain] {picture}").first.wait_for()
    settled(page)
    if explains and why:
        ask_why(page)


def violations(page, of="document"):
    """What axe finds, a line each: the rule, and where."""
    found = page.evaluate(
        """async ([of, values]) => {
             const wanted = { runOnly: { type: 'tag', values }, resultTypes: ['violations'] };
             return (await axe.run(of === 'document' ? document : of, wanted)).violations;
           }""",
        [of, RULES],
    )
    return [f"{each['id']}: {node['target']} {node['failureSummary']}" for each in found for node in each["nodes"]]


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=() if name in ("worlds", "inverse") else pytest.mark.long) for name in PAGES],
)
def test_axe_finds_nothing_in_either_theme(page, address, name):
    if not AXE.exists():
        pytest.fail("axe-core is not installed: run `npm ci`.")
    opened(page, address, name, why=True)
    page.evaluate(AXE.read_text(encoding="utf-8"))
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        page.wait_for_function(
            "(scheme) => getComputedStyle(document.querySelector('.stApp')).colorScheme === scheme", arg=scheme
        )
        settled(page)
        assert violations(page) == []
        help_ = page.locator(".laplace-lens .help summary, .laplace-inverse .why summary").first
        if help_.count():
            help_.click()
            assert violations(page, "details[open]:has(code)") == []
            help_.click()
        if PAGES[name].explains:
            page.get_by_role("button", name="save for print").click()
            dialog = page.get_by_role("dialog", name="Save for print")
            expect(dialog.get_by_role("status")).to_contain_text("mm")
            assert violations(page, "dialog[open]") == []
            dialog.get_by_role("button", name="Close").click()


# Words, fields and pictures that are cut off at a side, or lie beside the window.
_CLIPPED = """() => {
  const found = [], main = document.querySelector('[data-testid=stMain]');
  if (document.documentElement.scrollWidth > innerWidth + 1) found.push('the page');
  if (main.scrollWidth > main.clientWidth + 1) found.push('the main area');
  const words = (each) => [...each.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
  const hides = (each) => ['hidden', 'clip'].includes(getComputedStyle(each).overflowX);
  const scrolls = (each) => ['auto', 'scroll'].includes(getComputedStyle(each).overflowX);
  for (const each of main.querySelectorAll('*:not(script, style, svg *, .unseen, .said, .js-plotly-plot *)')) {
    const { left, right, width, height } = each.getBoundingClientRect();
    if (!each.checkVisibility({ visibilityProperty: true }) || !width || !height) continue;
    if (!words(each) && !each.matches('canvas, img, input, button')) continue;
    for (let above = each; above !== main; above = above.parentElement) {
      const outer = above.getBoundingClientRect(), beside = Math.max(right - outer.right, outer.left - left);
      const much = above === each ? each.scrollWidth - each.clientWidth : beside;
      if (hides(above) && much > 1.5) found.push(`${each.textContent.trim().slice(0, 60)}: ${much}`);
      if (hides(above) && much > 1.5 || scrolls(above)) break;
      if (above.parentElement === main && (right > innerWidth + 1 || left < -1)) found.push(each.textContent.trim());
    }
  }
  return found;
}"""


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=() if name in ("worlds", "inverse") else pytest.mark.long) for name in PAGES]
)
def test_a_page_is_named_described_skipped_to_by_keys_and_whole_in_any_window(page, address, name, subtests):
    """A zoom of 200% of a window of 1440x900 is one of 720x450."""
    opened(page, address, name)
    _, title, _, explains, skip = PAGES[name]
    expect(page).to_have_title(f"{title} · Laplace code workbench")
    levels = page.locator("h1, h2, h3, h4, h5, h6").evaluate_all("(all) => all.map((each) => +each.tagName[1])")
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(deeper - level <= 1 for level, deeper in itertools.pairwise(levels))

    told = "(all) => all.map((e) => `${e.ariaLabel ?? e.alt ?? ''} ${e.getAttribute('aria-valuetext') ?? ''}`)"
    pictures = page.locator("canvas:visible, [data-testid=stMain] .laplace-chart, [data-testid=stMain] img:visible")
    words = pictures.evaluate_all(told)
    assert all(each.strip() for each in words)
    canvases = page.locator("canvas:visible").evaluate_all(told)
    assert all(re.search(r"\d", each) for each in canvases), canvases
    assert len(canvases) >= (4 if explains else 0)

    page.locator("body").press("Tab")
    link = page.get_by_role("link", name=skip)
    expect(link).to_be_focused()
    expect(link).to_be_in_viewport()
    before = page.url
    page.keyboard.press("Enter")
    assert page.url == before
    inside = "() => Boolean(document.activeElement.closest('[data-testid=stMain]')) && document.activeElement.tagName"
    assert page.evaluate(inside) == ("H1" if name == "guide" else "DIV" if name in ("train", "paper") else "CANVAS")

    if explains:
        ask_why(page)
    for width, height in ((390, 844), (720, 450), (1024, 768), (1240, 800), (1440, 900), (1920, 1080)):
        with subtests.test(width=width):
            page.set_viewport_size({"width": width, "height": height})
            settled(page)
            # The sidebar may open a while after its window has the room for it.
            with contextlib.suppress(playwright.TimeoutError):
                page.wait_for_function(f"() => !({_CLIPPED})().length")
            assert page.evaluate(_CLIPPED) == []


@pytest.mark.parametrize("name", ["worlds", "agents", "inverse"])
def test_alpha_is_at_most_ten_tabs_from_the_top(page, address, name):
    opened(page, address, name)
    page.locator("body").press("Tab")
    page.keyboard.press("Enter")
    alpha = "(focused) => /alpha|α/.test(focused.ariaLabel) && focused.matches('[name=alpha], canvas[role=slider]')"
    tabs = 1
    while not page.locator(":focus").evaluate(alpha):
        page.keyboard.press("Tab")
        tabs += 1
        assert tabs <= 10
    page.keyboard.press("ArrowLeft")
    expect(page).to_have_url(re.compile("alpha="))


def test_keys_undo_and_redo_on_the_lens_but_not_in_a_field(page, address):
    open_at(page, address)
    alpha = page.locator("input[name=alpha]")
    first = alpha.input_value()
    alpha.press("ArrowLeft")
    settled(page)
    second = alpha.input_value()
    assert second != first
    page.keyboard.press("Control+z")
    settled(page)
    assert alpha.input_value() == first
    page.keyboard.press("Control+Shift+Z")
    settled(page)
    assert alpha.input_value() == second

    page.get_by_label("r2", exact=True).press("Control+z")
    settled(page)
    assert alpha.input_value() == second
    page.get_by_role("button", name="save for print").click()
    page.get_by_role("dialog").get_by_label("Tau-space").press("Control+z")
    settled(page)
    assert alpha.input_value() == second


def test_keys_undo_and_redo_on_the_inverse(page, address):
    opened(page, address, "inverse")
    curve = page.get_by_role("slider", name="alpha, on L-curve", exact=True)
    first = curve.get_attribute("aria-valuenow")
    curve.press("ArrowRight")
    expect(page).to_have_url(re.compile("alpha="))
    settled(page)
    second = curve.get_attribute("aria-valuenow")
    assert second != first
    page.keyboard.press("Control+z")
    expect(curve).to_have_attribute("aria-valuenow", first)
    settled(page)
    page.keyboard.press("Control+Shift+Z")
    expect(curve).to_have_attribute("aria-valuenow", second)
    settled(page)
    expect(curve).to_have_attribute("aria-valuenow", second)


def test_nothing_moves_by_itself_where_a_person_wants_less_motion(page, address):
    page.emulate_media(reduced_motion="reduce")
    opened(page, address, "worlds")
    longest = page.evaluate(
        """() => Math.max(...[...document.querySelectorAll('*')].flatMap((each) => {
             const { transitionDuration, animationDuration } = getComputedStyle(each);
             return `${transitionDuration},${animationDuration}`.split(',').map(parseFloat);
           }))"""
    )
    assert longest <= 0.001


def test_the_print_dialog_names_panels_as_the_page_does(page, address):
    open_at(page, address)
    ask_why(page)
    titles = page.locator(".laplace-lens .picture h2").all_text_contents()
    page.get_by_role("button", name="save for print").click()
    dialog = page.get_by_role("dialog", name="Save for print")
    expect(dialog.get_by_role("status")).to_contain_text("mm")
    labels = dialog.locator("label:has([type=checkbox])").all_inner_texts()
    assert {label.strip() for label in labels} == set(titles)
    assert {"Tau-space", "Gamma-space", "World"} <= set(titles)
