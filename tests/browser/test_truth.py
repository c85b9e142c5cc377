"""Simulated truth in a real browser: begun beside the lens, drawn over tau-space, and gone with its state."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import pytest

from laplace_core.acting.continuations import continue_from
from laplace_core.acting.rollout import roll_out
from laplace_core.acting.simulated_truth import empirical
from laplace_core.inverse import decode
from laplace_core.trained.truths import COUNT, STEPS
from laplace_core.training.checkpoint import load_checkpoint
from tests.browser.support import settled
from tests.browser.test_agents import saved, scrub

pytestmark = pytest.mark.browser
NAME, SEED, STEP, ACTION, T = "laplace_LunarLander-v3", 3, 12, 2, 40
CHECKPOINT = Path(__file__).resolve().parents[2] / "checkpoints" / f"{NAME}.safetensors"
_SIMULATED = "() => document.querySelector('.laplace-lens').lens.model.simulated?.count ?? 0"


def columns(text: str) -> dict[str, list[str]]:
    rows = list(csv.reader(io.StringIO("\n".join(text.splitlines()[1:]))))
    return dict(zip(rows[0], zip(*rows[1:], strict=True), strict=True))


def test_continuations_are_drawn_held_against_tau_space_and_gone_with_their_state(page, address):
    query = f"checkpoint={NAME}&r.shown=yes&r.seed={SEED}&r.rule=fading&r.horizon={T}&r.at={STEP}&action=main engine"
    page.goto(f"{address}/agents?{query}")
    page.locator(".laplace-player canvas").wait_for()
    page.locator("canvas.tau-space").wait_for()
    page.get_by_role("button", name="Simulate", exact=True).click()
    page.wait_for_function(f"{_SIMULATED.removeprefix('() => ')} === {COUNT}")
    page.get_by_text("calibration of P(r > θ, alive)").wait_for()
    page.wait_for_function("() => document.querySelector('canvas.tau-space').ariaLabel.includes('outlined')")

    loaded = load_checkpoint(CHECKPOINT)
    rollout = roll_out(loaded.agent, "LunarLander-v3", SEED, rule="fading", horizon=T)
    found = empirical(loaded.agent, continue_from(loaded.agent, rollout, STEP, action=ACTION, count=COUNT, steps=STEPS))
    space = loaded.agent.gamma_space(rollout.observations[STEP])

    def check():
        alpha = page.evaluate("() => document.querySelector('.laplace-lens').lens.state.alpha")
        shown = columns(saved(page, "save CSV").decode())
        np.testing.assert_allclose(np.array(shown["simulated reward"], float), found.reward, rtol=1e-5, atol=1e-6)
        tau_space = decode(space.differences[ACTION], space.gammas, STEPS, alpha)
        wanted = found.distance(tau_space, space.thetas)
        np.testing.assert_allclose(np.array(shown["W1"], float), wanted, atol=2e-3 * wanted.max())
        return alpha

    before = check()
    page.locator("input[name=alpha]").evaluate(
        "(input) => { input.value = 250; input.dispatchEvent(new Event('input')); }"  # held, not let go of
    )
    settled(page)
    assert check() < before / 2

    scrub(page, STEP + 3)
    assert page.evaluate(_SIMULATED) == 0
    page.wait_for_url(f"**r.at={STEP + 3}*")
    page.get_by_role("button", name="Simulate", exact=True).and_(page.locator(":enabled")).wait_for()
    scrub(page, STEP)  # and back to what is known
    page.wait_for_function(f"{_SIMULATED.removeprefix('() => ')} === {COUNT}")
