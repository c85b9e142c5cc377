"""The lens in a real browser: its numbers against the library, and what hands and keys do to it."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from base64 import b64encode

import numpy as np
import pytest
from playwright.sync_api import expect

from laplace_core import Settings, load_world, study
from laplace_core.payloads.lens import payload
from laplace_core.payloads.packing import pack
from tests.browser.support import ask_why, grab, module_of, open_at, runs_asked, runs_of_demo, settled
from tests.support.lens_agreement import compared_in, fixture, network, payloads, random_cases

pytestmark = pytest.mark.browser
OPENING = "world=two_branch&normalise=paper"


def open_lens(page, demo, query=OPENING):
    verdict = open_at(page, demo, query)
    settled(page)
    return verdict


def words(page, panel: str) -> str:
    return page.locator(f"canvas.{panel}").get_attribute("aria-label")


def picture(page, panel: str) -> str:
    return page.locator(f"canvas.{panel}").evaluate("(canvas) => canvas.toDataURL()")


def test_javascript_agrees_with_the_library_in_a_browser(chromium):
    """A state of every kind of payload; tests/test_js.py compares many, where Chromium's engine runs without a page."""
    held = payloads(small=True) | network()
    result = compared_in(chromium, fixture(held, random_cases(held, len(held), 11)))
    assert result["problems"] == []
    assert max(result["off"].values()) <= 1e-4, result["off"]


@pytest.mark.long
def test_the_first_view_and_each_remedy_by_one_switch(page, demo):
    verdict = open_lens(page, demo)
    expect(verdict).to_have_class(re.compile("bad"))
    expect(verdict).to_contain_text("choose short (14.85 v 9.74)")
    switch = page.get_by_role("switch", name="row rescaling")
    expect(switch).to_be_hidden()
    ask_why(page)
    expect(switch).to_have_attribute("aria-checked", "true")
    expect(switch).to_contain_text("regret 0 → 4.8")
    switch.click()
    expect(verdict).to_have_class(re.compile("ok"))
    expect(verdict).to_contain_text("choose long (9.70 v")
    page.get_by_role("button", name="As the paper").click()
    expect(page.locator("[role=switch][aria-checked=true]")).to_have_count(5)
    page.get_by_role("button", name="All repaired").click()
    expect(page.locator("[role=switch][aria-checked=true]")).to_have_count(0)


def test_a_drag_redraws_and_the_server_hears_the_release_only(page, demo):
    open_lens(page, demo, "world=discounting_chain&thetas=60")
    for control in ("alpha", "horizon", "slope"):
        before = runs_of_demo(page)
        move = grab(page, control)
        settled(page)
        for i in range(20):  # a move after the next, each of them drawn
            page.evaluate("() => { document.querySelector('.laplace-lens').frames.length = 0; }")
            move(0.4 + 0.35 * np.sin(2 * np.pi * (i + 1) / 20))
            page.wait_for_function("() => document.querySelector('.laplace-lens').frames.length > 0")
        settled(page)
        assert runs_of_demo(page) == runs_asked(page) == before
        page.mouse.up()
        page.get_by_text(f"runs {before + 1}, ").wait_for()
        settled(page)
        assert runs_of_demo(page) == runs_asked(page) == before + 1


def test_keys_held_down_are_one_release(page, demo):
    open_lens(page, demo)
    before = runs_of_demo(page)
    # What eight strokes of a key do, without a pause between them: a busy machine would make pauses.
    page.locator("input[name=alpha]").evaluate(
        """(input) => { for (let i = 0; i < 8; i += 1) {
        input.stepDown();
        for (const kind of ['input', 'change']) input.dispatchEvent(new Event(kind));
        } }"""
    )
    page.get_by_text(f"runs {before + 1}, alpha 0.126").wait_for()
    settled(page)
    assert runs_of_demo(page) == before + 1


def test_undo_redo_and_reset(page, demo):
    verdict = open_lens(page, demo)
    rows = page.get_by_label("rows of tau-space")
    rows.select_option("none")
    expect(verdict).to_have_class(re.compile("ok"))
    undo, redo = (page.get_by_role("button", name=name, exact=True) for name in ("undo", "redo"))
    expect(undo).to_be_enabled()
    undo.click()
    expect(verdict).to_have_class(re.compile("bad"))
    expect(undo).to_be_disabled()
    redo.click()
    expect(verdict).to_have_class(re.compile("ok"))
    page.get_by_role("button", name="reset").click()
    expect(verdict).to_have_class(re.compile("bad"))


def test_python_and_undo_meet(page, demo):
    open_lens(page, demo)
    page.get_by_role("button", name="alpha 0.001 from Python").click()
    expect(page.locator(".slider", has=page.locator("input[name=alpha]"))).to_contain_text("0.001")
    page.get_by_role("button", name="undo", exact=True).click()
    expect(page.locator(".slider", has=page.locator("input[name=alpha]"))).to_contain_text("0.2")
    page.get_by_text("alpha 0.2, T 3").wait_for()


def test_a_lens_put_back_shows_what_was_let_go_of(page, demo):
    open_lens(page, demo)
    page.locator("input[name=alpha]").press("End")
    page.get_by_text("alpha 10, T 3").wait_for()
    toggle = page.locator("label", has_text="show the lens")
    toggle.click()
    expect(page.locator("canvas.tau-space")).to_have_count(0)
    toggle.click()
    page.locator("canvas.tau-space").wait_for()
    expect(page.locator("input[name=alpha]")).to_have_attribute("aria-valuetext", "10")


def test_an_answer_that_a_payload_is_missing_repeats_the_release_that_it_replaces(page, demo):
    """Streamlit keeps only the last answer that the server has not read: the release before it would be lost."""
    open_lens(page, demo)
    page.locator("input[name=alpha]").focus()
    page.keyboard.press("ArrowRight")
    settled(page)
    state = page.evaluate("() => document.querySelector('.laplace-lens').lens.state")
    answers = module_of(page, "lens/entry.js").evaluate(
        """({ default: show }) => Array.from({ length: 9 }, (_, revision) => {
          const header = new TextEncoder().encode(JSON.stringify({ name: 'demo', id: 'not held', revision }));
          const data = new Uint8Array(4 + header.length);
          new DataView(data.buffer).setUint32(0, header.length, true);
          data.set(header, 4);
          let answer;
          show({ data, parentElement: document.body, setTriggerValue: (name, value) => { answer = value; } });
          return answer;
        })"""
    )
    assert state["alpha"] > 0.2
    repeated = [answer for answer in answers if "state" in answer]
    assert [answer["state"] for answer in repeated] == [state]  # of the revision that the browser is at
    assert repeated[0]["revision"] == answers.index(repeated[0])
    assert answers.count({"missing": "not held"}) == 8


def test_a_payload_that_was_sent_before_a_release_was_heard_does_not_take_it_back(page, demo):
    """A lens of another shape takes the place of the one that the hand moved, with the state before the release."""
    open_lens(page, demo)
    before = page.evaluate("() => document.querySelector('.laplace-lens').lens.state")
    page.locator("input[name=alpha]").focus()
    page.keyboard.press("ArrowRight")
    settled(page)
    data = payload(study(load_world("fig6_chain"), Settings(world="fig6_chain")))[0]
    header = {"name": "demo", "id": "not held", "state": before, "base": before}
    messages = [b64encode(pack(header | {"revision": revision}, data)).decode() for revision in range(9)]
    alphas = module_of(page, "lens/entry.js").evaluate(
        """({ default: show }, messages) => messages.map((message) => {
          const data = Uint8Array.from(atob(message), (letter) => letter.charCodeAt(0));
          const parentElement = document.createElement('div');
          show({ data, parentElement, setTriggerValue: () => {} });
          return parentElement.querySelector('.laplace-lens').lens.state.alpha;
        })""",
        messages,
    )
    moved = [alpha for alpha in alphas if alpha != before["alpha"]]
    assert len(moved) == 1, "of the revision that the browser is at"
    assert moved[0] > before["alpha"]


def test_a_key_between_a_state_of_the_server_and_the_next_frame_is_kept(page, demo):
    """The server sets T while a change of alpha is not released yet; sliders stand right before anything is drawn."""
    open_lens(page, demo)
    found = page.evaluate(
        """() => {
          const { lens } = document.querySelector('.laplace-lens');
          const slider = (name) => document.querySelector(`input[name=${name}]`);
          const left = (name) => { slider(name).stepDown(); slider(name).dispatchEvent(new Event('input')); };
          const before = { ...lens.state };
          left('alpha');
          const first = lens.state.alpha;
          lens.show(lens.model, { state: { ...before, horizon: 2 } }, true);
          const after = { ...lens.state };
          left('alpha');
          left('horizon');
          return { before, first, after, last: lens.state };
        }"""
    )
    before, first, after, last = (found[name] for name in ("before", "first", "after", "last"))
    assert before["horizon"] > 2
    assert (after["alpha"], after["horizon"]) == (first, 2)
    assert last["alpha"] < first < before["alpha"]
    assert last["horizon"] < 2
    settled(page)
    assert page.evaluate("() => document.querySelector('.laplace-lens').lens.state") == last


def test_one_place_is_marked_in_every_picture(page, demo):
    open_lens(page, demo)
    ask_why(page)
    before = {panel: picture(page, panel) for panel in ("gamma-space", "values", "kernel", "rewards", "spectrum")}
    page.locator("canvas.tau-space").hover(position={"x": 120, "y": 120})
    settled(page)
    for panel, old in before.items():
        assert picture(page, panel) != old, panel
    page.locator("canvas.gamma-space").hover(position={"x": 120, "y": 120})
    settled(page)
    assert picture(page, "tau-space") != before["gamma-space"]
    page.get_by_role("button", name="reset").hover()
    settled(page)
    assert {panel: picture(page, panel) for panel in before} == before  # and the marks are gone again


def test_by_keyboard_alone(page, demo):
    verdict = open_lens(page, demo)
    page.locator("canvas.tau-space").focus()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("ArrowUp")
    settled(page)
    assert "Step 1 is seen" in words(page, "tau-space")
    page.locator(".why > summary").focus()
    page.keyboard.press("Enter")
    page.get_by_role("switch", name="row rescaling").focus()
    page.keyboard.press("Space")
    expect(verdict).to_have_class(re.compile("ok"))
    page.get_by_role("button", name="sweep alpha").focus()
    page.keyboard.press("Enter")
    moved = "() => +document.querySelector('input[name=alpha]').ariaValueText"
    page.wait_for_function(f"({moved})() < 0.19")
    page.keyboard.press("Enter")
    settled(page)
    stopped = page.evaluate(moved)
    assert stopped < 0.19
    page.get_by_text(f"alpha {stopped:g}, T 3").wait_for()
    for control in ("alpha", "slope", "horizon", "used", "softness", "value_gamma", "noise"):
        handle = page.locator(f"input[name={control}]")
        for key in ("Home", "End"):
            handle.press(key)
    settled(page)


def test_every_canvas_says_in_numbers_what_it_shows(page, demo):
    open_lens(page, demo)
    assert page.locator("canvas[role=img]").count() == 7
    assert "short 14.85, long 9.738" in words(page, "values")
    assert "decoded 5, 5, 5, true at the first steps 5, 0, 0" in words(page, "rewards")
    assert "3 usable" in words(page, "spectrum")
    assert "15 discounts" in words(page, "gamma-space")
    assert "probability 1 with mean reward 5" in words(page, "tau-space")
    assert "noise gain" in words(page, "kernel")
    assert "as tau-space gives it back: they differ by at most" in words(page, "fit")


def test_examples_here_and_elsewhere(page, demo):
    verdict = open_lens(page, demo, "world=two_branch&normalise=none")
    expect(verdict).to_have_class(re.compile("ok"))
    page.get_by_role("button", name="Fig. 4c").click()
    expect(verdict).to_contain_text("14.85")
    page.get_by_role("button", name="Fig. 6").click()
    page.get_by_text("asks for Fig. 6").wait_for()


def test_the_surface_keeps_its_camera(page, demo):
    open_lens(page, demo)
    page.get_by_role("button", name="surface").click()
    settled(page)
    flat = picture(page, "tau-space")
    page.locator("canvas.tau-space").focus()
    for _ in range(4):
        page.keyboard.press("ArrowRight")
    settled(page)
    turned = picture(page, "tau-space")
    assert turned != flat
    page.locator("input[name=alpha]").press("ArrowLeft")
    settled(page)
    page.locator("input[name=alpha]").press("ArrowRight")
    settled(page)
    assert picture(page, "tau-space") == turned


def test_zoom_survives_every_change(page, demo):
    open_lens(page, demo, "world=cliff_grid")
    whole = picture(page, "tau-space")
    box = page.locator("canvas.tau-space").bounding_box()
    page.mouse.move(box["x"] + 100, box["y"] + 60)
    page.mouse.down()
    page.mouse.move(box["x"] + 220, box["y"] + 200, steps=4)
    page.mouse.up()
    page.mouse.move(5, 5)
    settled(page)
    zoomed = picture(page, "tau-space")
    assert zoomed != whole
    for key in ("ArrowLeft", "ArrowRight"):
        page.locator("input[name=alpha]").press(key)
        settled(page)
    assert picture(page, "tau-space") == zoomed
    page.locator("canvas.tau-space").focus()
    page.keyboard.press("Escape")
    settled(page)
    assert picture(page, "tau-space") == whole
    page.keyboard.press("+")
    settled(page)
    assert picture(page, "tau-space") != whole


def saved(page, name, path):
    with page.expect_download() as waiting:
        page.get_by_role("button", name=f"save {name}").click()
    waiting.value.save_as(path)
    return path


def test_files_to_take_along(page, demo, tmp_path):
    open_lens(page, demo)
    assert saved(page, "PNG", tmp_path / "lens.png").read_bytes().startswith(b"\x89PNG")
    drawing = ET.parse(saved(page, "SVG", tmp_path / "lens.svg")).getroot()
    texts = " ".join(node.text or "" for node in drawing.iter("{http://www.w3.org/2000/svg}text"))
    assert "Tau-space" in texts
    assert "14.85" in texts
    head, names, *rows = saved(page, "CSV", tmp_path / "lens.csv").read_text().splitlines()
    assert '"normalise":"paper"' in head
    column = names.split(",").index('"value of short"')
    np.testing.assert_allclose([float(row.split(",")[column]) for row in rows], [4.9999, 9.9499, 14.8504], atol=2e-3)


def test_a_file_of_its_own_works_offline(page, demo, chromium, tmp_path):
    open_lens(page, demo)
    path = saved(page, "HTML", tmp_path / "lens.html")
    context = chromium.new_context(offline=True, viewport={"width": 1200, "height": 900})
    alone, problems = context.new_page(), []
    alone.on("pageerror", lambda error: problems.append(str(error)))
    alone.on("request", lambda request: problems.append(request.url) if request.url.startswith("http") else None)
    alone.goto(path.as_uri())
    verdict = alone.locator(".verdict")
    expect(verdict).to_contain_text("choose short (14.85 v 9.74)")
    alone.get_by_text("Why?").click()
    alone.get_by_role("switch", name="row rescaling").click()
    expect(verdict).to_have_class(re.compile("ok"))
    alone.locator("input[name=alpha]").press("Home")
    expect(verdict).to_contain_text("choose long (9.80 v")
    context.close()
    assert problems == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(("width", "height"), [(1440, 900), (390, 844)])
def test_nothing_is_wider_than_the_screen(page, demo, scheme, width, height):
    page.set_viewport_size({"width": width, "height": height})
    page.emulate_media(color_scheme=scheme)
    open_lens(page, demo, "world=discounting_chain&thetas=60")
    wide = "() => Math.max(...[...document.querySelectorAll('*')].map((x) => x.getBoundingClientRect().right))"
    assert page.evaluate(wide) <= width + 1
    ask_why(page)
    assert page.evaluate(wide) <= width + 1
    boxes = [page.locator("canvas").nth(i).bounding_box() for i in range(7)]
    assert len({round(box["y"]) for box in boxes}) == (3 if width > 900 else 7)
    assert all(box["x"] + box["width"] <= width + 1 for box in boxes)
    colour = page.locator(".laplace-lens").evaluate("(host) => getComputedStyle(host).color")
    assert (sum(map(int, re.findall(r"\d+", colour)[:3])) > 382) == (scheme == "dark")


def test_nothing_jumps(page, demo):
    open_lens(page, demo)
    ask_why(page)
    names = ["canvas.tau-space", "canvas.kernel", ".panels + .sliders", ".switches", ".footer"]

    def places():  # within the lens: the page itself may be scrolled
        top = page.locator(".laplace-lens").bounding_box()["y"]
        return [page.locator(name).bounding_box()["y"] - top for name in names]

    before = places()
    page.get_by_role("button", name="All repaired").click()
    page.locator("input[name=noise]").press("End")
    settled(page)
    assert places() == before
