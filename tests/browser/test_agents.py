"""A trained agent in a real browser: roll out, scrub, change alpha, download; the numbers against the library."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import expect

from laplace_core import GammaSpace, Settings
from laplace_core.acting.flags import flag_steps
from laplace_core.acting.rollout import roll_out
from laplace_core.code.encoding import softening
from laplace_core.code.gamma_space import bin_edges
from laplace_core.code.interpolation import with_added
from laplace_core.inverse import decode
from laplace_core.study.horizon import expected_rewards
from laplace_core.study.settings import resolve_for_gamma_space
from laplace_core.training.checkpoint import load_checkpoint
from tests.browser.support import settled

pytestmark = pytest.mark.browser
CHECKPOINTS = Path(__file__).resolve().parents[2] / "checkpoints"
SEED, STEP = 3, 17


def by_the_library(environment):
    loaded = load_checkpoint(CHECKPOINTS / f"laplace_{environment}.safetensors")
    return loaded, roll_out(loaded.agent, environment, SEED, rule="fading", horizon=60)


@pytest.fixture(scope="module")
def wanted():
    """The same episode by the library."""
    return by_the_library("CartPole-v1")


def rolled_out(page, address, environment="CartPole-v1"):
    page.goto(f"{address}/agents?checkpoint=laplace_{environment}&r.rule=fading&r.horizon=60&r.seed={SEED}")
    page.get_by_role("button", name="Roll out").click()
    page.locator(".laplace-player canvas").wait_for()
    page.locator("canvas.tau-space").wait_for()
    page.wait_for_function("() => document.querySelector('.laplace-lens').frames.length > 1")


def shown(page) -> np.ndarray:
    """Differences of the model that the lens shows, (A, G, B); empty while it is being put on the page anew."""
    return np.array(page.evaluate(
        "() => { const { model } = document.querySelector('.laplace-lens')?.lens ?? {};"
        " return (model?.grids.own.columns.shared.values ?? []).map((one) => Array.from(one)); }"
    ))  # fmt: skip


def scrub(page, step: int) -> None:
    page.locator("input[name=step]").evaluate(
        "(input, step) => { input.value = step; input.dispatchEvent(new Event('input')); }", step
    )


def saved(page, name: str) -> bytes:
    with page.expect_download() as download:
        page.get_by_role("button", name=name, exact=True).click()
    return Path(download.value.path()).read_bytes()


@pytest.mark.parametrize(
    "environment",
    ["CartPole-v1", *(pytest.param(name, marks=pytest.mark.long) for name in ("Acrobot-v1", "LunarLander-v3"))],
)
def test_the_whole_path_and_its_numbers(page, address, environment):
    loaded, rollout = by_the_library(environment)
    rolled_out(page, address, environment)
    scrub(page, STEP)
    page.wait_for_url(f"**r.at={STEP}*")
    page.locator("input[name=alpha]").focus()
    for _ in range(12):
        page.keyboard.press("ArrowLeft")
    page.wait_for_url("**alpha=*")
    exactly(page, loaded, rollout)

    found, told = taken_along(page)
    assert told["alpha"] < 0.6
    space = loaded.agent.gamma_space(rollout.observations[STEP])
    tau_space = decode(space.differences, space.gammas, len(found), told["alpha"], 1.0)[told["action"]]
    np.testing.assert_allclose(found[:, -tau_space.shape[1] :], tau_space, atol=1e-6)
    np.testing.assert_allclose(found[:, 1], expected_rewards(tau_space, space.bin_values), atol=1e-5)

    file = np.load(io.BytesIO(saved(page, "NPZ")))
    np.testing.assert_array_equal(file["actions"], rollout.actions)
    np.testing.assert_allclose(file["gamma_space"][STEP], space.values, rtol=1e-5, atol=1e-5)
    np.testing.assert_array_equal(file["observations"], rollout.observations)


def taken_along(page) -> tuple[np.ndarray, dict[str, object]]:
    """The table of the lens, tau-space last, and the state that it was saved under."""
    lines = saved(page, "save CSV").decode().splitlines()
    rows = [[float(x) for x in row] for row in csv.reader(io.StringIO("\n".join(lines[2:])))]
    return np.array(rows), page.evaluate("() => document.querySelector('.laplace-lens').lens.state")


def exactly(page, loaded, rollout, *, step=STEP, added=0) -> GammaSpace:
    """Wait until the lens has the exact gamma-space of a step, and not the player's rounded one; returns it."""
    space = with_added(loaded.agent.gamma_space(rollout.observations[step]), added)
    settled(page)
    np.testing.assert_allclose(shown(page).ravel(), space.differences.ravel(), rtol=0, atol=1e-9)
    return space


def test_a_softer_slope_and_added_discounts(page, address, wanted):
    loaded, rollout = wanted
    rolled_out(page, address)
    scrub(page, STEP)
    page.get_by_role("combobox", name="discounts added").select_option("+ 1 in each gap")
    page.wait_for_url("**added=1*")
    page.locator("input[name=slope_share]").focus()
    for _ in range(10):
        page.keyboard.press("ArrowLeft")
    assert page.evaluate("() => document.querySelector('.laplace-lens').lens.state.slope_share") == 0.5
    page.wait_for_url("**slope_share=0.5*")
    space = exactly(page, loaded, rollout, added=1)
    found, told = taken_along(page)
    assert (told["added"], told["slope_share"]) == (1, 0.5)
    soft = space.differences[told["action"]] @ softening(loaded.agent.sensitivities.places, 0.5, open_ends=True)
    wanted_ = decode(soft, space.gammas, len(found), told["alpha"], 1.0)
    np.testing.assert_allclose(found[:, -soft.shape[1] :], wanted_, atol=1e-9)

    # The next step comes from the player, which has the trained discounts only.
    scrub(page, STEP + 1)
    drawn = shown(page).reshape(space.differences.shape)
    exact = with_added(rollout.space(STEP + 1), 1).differences
    assert np.abs(drawn - exact).max() < 2e-4 * np.abs(exact).max()
    settled(page)  # what a picture says is renewed when the hand rests
    said = page.locator("canvas.gamma-space").get_attribute("aria-label")
    assert "29 discounts" in said
    assert "interpolated" in said
    assert "0.5 of the trained slope" in said


def test_a_key_pressed_while_a_step_is_answered_is_not_lost(page, address):
    """The answer brings other data and the state from before the key, which comes at every stage of it."""
    rolled_out(page, address)
    settled(page)
    page.locator("input[name=alpha]").focus()
    alpha = "() => document.querySelector('.laplace-lens').lens.state.alpha"
    begun = "([runs, received]) => window.watched.runs > runs && window.watched.received.length >= received"
    for i, messages in enumerate((None, 0, 1, 5, 15, 40)):
        before = page.evaluate("() => [window.watched.runs, window.watched.received.length]")
        scrub(page, 5 + i)
        if messages is not None:  # so many of the answer
            page.wait_for_function(
                f"(before) => ({begun})(before) || window.watched.runs > before[0] && window.watched.still()",
                arg=[before[0], before[1] + messages], polling="raf",
            )  # fmt: skip
        page.keyboard.press("ArrowLeft")
        pressed = page.evaluate(alpha)
        page.wait_for_url(f"**alpha={pressed:g}*")
        page.wait_for_url(f"**r.at={5 + i}*")
        settled(page)
        assert page.evaluate(alpha) == pressed
        assert page.evaluate("() => document.activeElement.name") == "alpha"


def test_artefacts_are_marked_and_one_button_leads_from_one_to_the_next(page, address, wanted):
    _, rollout = wanted
    rollout_of = f"checkpoint=laplace_CartPole-v1&r.rule=fading&r.horizon=60&r.seed={SEED}&r.shown=yes"
    page.goto(f"{address}/agents?{rollout_of}&alpha=0.1")
    settings = resolve_for_gamma_space(Settings(world="CartPole-v1", alpha=0.1), rollout.gammas)
    flags = flag_steps(rollout, settings)
    begins = np.flatnonzero(flags.begins)
    button = page.get_by_role("button", name=f"artefact › {len(begins)}")
    step = 0
    for _ in range(min(3, len(begins))):
        step = int(begins[(begins > step).argmax()])  # around the end to the first
        button.click()
        page.wait_for_function(f"() => document.querySelector('input[name=step]').value == {step}")
        names = [name for name, mark in zip(flags.names, flags.marks[step], strict=True) if mark]
        assert page.locator(".laplace-player .here").inner_text() == " · ".join(names)


def test_scrubbing_needs_no_server_and_shows_the_next_step_at_once(page, address, wanted):
    _, rollout = wanted
    rolled_out(page, address)
    page.route("**/*", lambda route: route.abort())  # whatever is not there by now does not come
    page.evaluate("() => { document.querySelector('.laplace-player').times.length = 0; }")
    exact = np.array([rollout.space(i).differences for i in range(len(rollout.spaces))])
    for step in (1, 2, 30, 59):
        scrub(page, step)  # sooner than it comes to rest
        found = shown(page).reshape(exact.shape[1:])
        level = np.abs(exact).max(axis=(0, 1, 3)) / 32767
        assert (np.abs(found - exact[step]).max(axis=(0, 2)) <= 0.51 * level + 1e-6).all()
        assert page.locator(".laplace-player .line b").inner_text() == f"step {step} of 59"
    assert page.evaluate("() => document.querySelector('.laplace-player').times.length") == 4  # each drawn once


def test_jumps_lead_to_what_is_marked(page, address, wanted):
    _, rollout = wanted
    rolled_out(page, address)
    page.get_by_role("button", name="TD error ›").click()
    page.wait_for_url(f"**r.at={int(np.abs(rollout.surprise).argmax())}*")
    differs = page.get_by_role("button", name="greedy")
    if not rollout.differs.any():
        assert differs.is_disabled()
        return
    differs.click()
    settled(page)
    step = int(page.locator("input[name=step]").input_value())
    assert rollout.differs[step]


def test_it_plays_and_pauses(page, address):
    rolled_out(page, address)
    page.get_by_role("button", name="play").click()
    page.wait_for_function("() => document.querySelector('input[name=step]').value > 5")
    page.get_by_role("button", name="pause").click()
    settled(page)  # it waits for no frame that would move it
    at = page.locator("input[name=step]").input_value()
    assert int(at) > 5
    page.wait_for_url(f"**r.at={at}*")


def test_sensitivities_that_are_close_together_can_be_told_apart(page, address):
    """LunarLander's lie .13 apart around reward 0 and 12 apart at the ends; the axis gives each the same width."""
    page.goto(f"{address}/agents?checkpoint=laplace_LunarLander-v3")
    canvas = page.locator("canvas.tau-space")
    canvas.wait_for()
    page.get_by_role("button", name="all θ").click()
    settled(page)
    edges, back = page.evaluate(
        """() => { const { seen } = document.querySelector('.laplace-lens').lens, thetas = Array.from(seen.thetas);
        const { X, toX } = document.querySelector('canvas.tau-space').scale, edges = thetas.map(X);
        return [edges, edges.map(toX)]; }"""
    )
    thetas = bin_edges(load_checkpoint(CHECKPOINTS / "laplace_LunarLander-v3.safetensors").agent.thetas, open_ends=True)
    np.testing.assert_allclose(np.diff(edges), (edges[-1] - edges[0]) / (thetas.size - 1), rtol=1e-6)
    np.testing.assert_allclose(back, thetas, atol=1e-3)
    hover = "() => document.querySelector('.laplace-lens').lens.hover.theta"
    canvas.hover(position={"x": (edges[40] + edges[41]) / 2, "y": 80})
    page.wait_for_function(f"({hover})() !== undefined")
    # A pointer is put on whole pixels, which are less than a column here.
    assert thetas[40] < page.evaluate(hover) < thetas[41]
    canvas.focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_function(f"({hover})() > {thetas[41]}")
    assert page.evaluate(hover) < thetas[42]
    shown = "() => [...canvas.scale.x, ...canvas.scale.y]".replace(
        "canvas", "document.querySelector('canvas.tau-space')"
    )
    whole = page.evaluate(shown)
    page.keyboard.press("+")
    page.wait_for_function(f"({shown})()[3] - ({shown})()[2] < {0.6 * (whole[3] - whole[2])}")
    left, right, low, high = page.evaluate(shown)
    assert whole[0] < left < page.evaluate(hover) < right < whole[1]
    assert whole[2] <= low < page.evaluate(hover.replace("theta", "tau")) < high <= whole[3]
    for _ in range(2):
        page.keyboard.press("-")
    page.wait_for_function(f"({shown})()[3] - ({shown})()[2] > {0.99 * (whole[3] - whole[2])}")
    np.testing.assert_allclose(page.evaluate(shown), whole, atol=1e-6)
    box = canvas.bounding_box()
    page.mouse.move(box["x"] + 4, box["y"] + 60)  # from beside the picture
    page.mouse.down()
    page.mouse.move(box["x"] + 140, box["y"] + 120, steps=4)
    page.mouse.up()
    page.wait_for_function(f"({shown})()[1] < {whole[1] - 1}")
    assert page.evaluate(shown)[0] == pytest.approx(whole[0])


def test_the_lens_shows_the_action_taken_until_another_one_is_chosen(page, address):
    rolled_out(page, address)
    settled(page)
    taken = page.get_by_role("button", name="action taken")
    expect(taken).to_have_attribute("aria-pressed", "true")
    page.get_by_role("button", name="show push left").or_(page.get_by_title("show push left")).click()
    expect(page).to_have_url(re.compile("action=push(\\+|%20)left"))
    expect(taken).to_have_attribute("aria-pressed", "false")
    lens = "document.querySelector('.laplace-lens').lens"
    actions = set()
    for step in range(1, 12):
        scrub(page, step)
        settled(page)
        assert page.evaluate(f"() => {lens}.state.action") == 0
        actions.add(page.locator(".laplace-player .values tr.taken td").nth(1).inner_text())
    assert len(actions) == 2  # the episode itself does both
    taken.click()
    expect(page).not_to_have_url(re.compile("action="))
    expect(taken).to_have_attribute("aria-pressed", "true")
