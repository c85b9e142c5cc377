"""A peer in a real browser: opened, rolled out, scrubbed, compared with observed returns; numbers by the library."""

from __future__ import annotations

import io
import json
from pathlib import Path

import numpy as np
import pytest
import torch
from playwright.sync_api import expect

from laplace_core.acting.return_laws import return_laws, simulate_returns
from laplace_core.acting.rollout import roll_out
from laplace_core.agents.settings import QrdqnSettings
from laplace_core.training.checkpoint import new_agent, save_checkpoint
from tests.browser.support import settled

pytestmark = pytest.mark.browser
STEP = 6


@pytest.fixture
def agent():
    """Untrained, with outputs that differ from state to state."""
    agent = new_agent(QrdqnSettings(environment="CartPole-v1", hidden=8, quantiles=9))
    with torch.no_grad():
        for parameter in agent.target.parameters():
            parameter += 0.4 * torch.randn(parameter.shape, generator=torch.Generator().manual_seed(2))
    return agent


def drawn(page) -> list:
    """Corners of every trace of the picture of the state."""
    return page.evaluate(
        "() => document.querySelector('[data-name=state]')._fullData.map(({ x, y }) => [Array.from(x), Array.from(y)])"
    )


def test_a_peer_from_a_file_is_scrubbed_and_held_against_what_comes(page, address, agent, tmp_path):
    save_checkpoint(tmp_path / "mine.safetensors", agent, 7, None)
    page.goto(f"{address}/agents")
    page.locator("input[type=file]").set_input_files(str(tmp_path / "mine.safetensors"))
    expect(page.get_by_text("Outputs: 9 quantiles, discount 0.99.")).to_be_visible()
    page.get_by_role("button", name="Roll out", exact=True).click()
    page.locator(".laplace-player canvas").wait_for()
    page.wait_for_function("() => document.querySelector('[data-name=episode]')?._fullData")

    rollout = roll_out(agent, "CartPole-v1", 0)
    scrub = "(input, step) => { input.value = step; input.dispatchEvent(new Event('input')); }"
    page.locator("input[name=step]").evaluate(scrub, STEP)
    # The picture follows the hand, and is the server's own once the step is heard.
    law = return_laws(agent, rollout.observations[STEP])[0]
    for heard in (False, True):
        if heard:
            page.wait_for_url(f"**r.at={STEP}*")
            expect(page.get_by_text(f"at step {STEP}, then each agent's own greedy policy, once")).to_be_visible()
        page.wait_for_function(
            "(mean) => Math.abs(document.querySelector('[data-name=state]')._fullData[2].x[0] - mean) < 1e-4",
            arg=law.mean,
        )
        stairs, mean = drawn(page)[0], drawn(page)[2]
        np.testing.assert_allclose(stairs[0][1:-1], np.unique(law.locations)[-len(stairs[0][1:-1]) :], atol=1e-5)
        assert stairs[1][-1] == pytest.approx(1.0)
        assert mean[1] == [0]

    page.get_by_role("button", name="Simulate returns").click()
    expect(page.get_by_text("Shaded: W1")).to_be_visible()
    action = int(rollout.actions[STEP])
    came, wanted = (
        simulate_returns(agent, rollout, STEP, action),
        return_laws(agent, rollout.observations[STEP])[action],
    )
    panel = page.locator("[data-name=codes]").get_by_text(f"W1 {came.distance(wanted):.3g}", exact=True)
    expect(panel).to_be_visible()

    settled(page)  # the run of the page gives the button its file at its end
    with page.expect_download() as download:
        page.get_by_role("button", name="Save returns (NPZ)").click()
    file = np.load(io.BytesIO(Path(download.value.path()).read_bytes()))
    told = json.loads(str(file["settings"]))
    assert told[0] == {"algorithm": "qrdqn", "kind": "learned", "gamma": 0.99}
    assert "laplace" in [each["algorithm"] for each in told]
    np.testing.assert_allclose(file["0_qrdqn_came"], came.returns)
    np.testing.assert_allclose(file["0_qrdqn_locations"], wanted.locations, rtol=1e-6)
