"""The report on interpolated discounts: its numbers by other means, and what the command line prints."""

import json

import numpy as np
import pytest
import torch

from laplace_core import InputError
from laplace_core.acting.rollout import roll_out
from laplace_core.agents import LaplaceSettings
from laplace_core.agents.peer_settings import DqnSettings
from laplace_core.cli import main
from laplace_core.code.interpolation import left_out
from laplace_core.experiments import interpolation
from laplace_core.training.checkpoint import new_agent, save_checkpoint

torch.set_num_threads(1)


@pytest.fixture
def agent(tmp_path):
    settings = LaplaceSettings(environment="two_branch", hidden=4, features=4, gammas=5, thetas=7, theta_max=12.0)
    made = new_agent(settings)
    save_checkpoint(tmp_path / "a.safetensors", made, 0, None)
    return made, tmp_path / "a.safetensors"


def test_of_a_network_it_is_the_error_of_every_discount_left_out(agent):
    made, path = agent
    rollout = roll_out(made, "two_branch", 3)
    worst = left_out(rollout.spaces.astype(float), rollout.gammas).max(axis=-1)
    found = interpolation.of_network(path, 3)
    assert found["kinds"]["line"]["worst"] == pytest.approx(worst.max())
    assert found["kinds"]["line"]["by discount"] == pytest.approx(np.median(worst, axis=(0, 1)).tolist())
    assert set(found["kinds"]) == {"line", "monotone cubic", "cubic spline"}


def test_every_kind_meets_what_was_learned_and_draws_a_line_as_a_line():
    gammas = np.exp(-1 / np.array([1.0, 2.0, 4.0, 8.0]))
    straight = np.array([0.1, 0.2, 0.3, 0.4])[:, None] / (1 - gammas)[:, None]
    wanted = np.exp(-1 / np.array([2.0, 4.0 * np.sqrt(2.0)]))
    for kind in interpolation.KINDS.values():
        found = kind(straight, gammas, wanted)[:, 0] * (1 - wanted)
        np.testing.assert_allclose(found, [0.2, 0.35], atol=1e-12)


def test_interpolation_adds_what_a_smaller_alpha_adds_and_no_more(monkeypatch):
    """Free of error it does what learned discounts do; with error they help, and it does not."""
    monkeypatch.setattr(interpolation, "ALPHAS", (1.0,))
    clean, noisy = interpolation.of_world("two_decisions")
    assert clean["line"] == pytest.approx(clean["as many learned"], abs=2e-3)
    assert noisy["as many learned"] < noisy["learned"] < noisy["line"]


def test_what_the_command_line_prints(agent, capsys, monkeypatch):
    monkeypatch.setattr(interpolation, "WORLDS", ("two_decisions",))
    monkeypatch.setattr(interpolation, "SEEDS", 1)
    assert main(["report", "interpolation", str(agent[1]), "--json"]) == 0
    numbers = json.loads(capsys.readouterr().out)
    assert len(numbers["worlds"]) == len(interpolation.ALPHAS) * len(interpolation.NOISES)
    assert main(["report", "interpolation", str(agent[1])]) == 0
    assert "as many learned" in capsys.readouterr().out
    assert main(["report", "interpolation", str(agent[1]), "--seed=-1"]) == 2
    assert main(["report", "interpolation", "nowhere.safetensors"]) == 2


@pytest.mark.parametrize("settings", [
    DqnSettings(environment="two_branch", hidden=4), LaplaceSettings(environment="two_branch", hidden=4, gammas=2),
])  # fmt: skip
def test_an_agent_with_too_few_discounts_is_refused(tmp_path, settings):
    save_checkpoint(tmp_path / "a.safetensors", new_agent(settings), 0, None)
    with pytest.raises(InputError, match="three"):
        interpolation.of_network(tmp_path / "a.safetensors", 0)
