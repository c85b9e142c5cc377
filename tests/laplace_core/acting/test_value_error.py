"""The error of an agent's values: of every algorithm, against an episode added up by hand."""

from __future__ import annotations

import numpy as np
import pytest

from laplace_core.agents import SETTINGS
from laplace_core.agents.registry import AGENTS
from laplace_core.experiments.training import evaluated

SMALL = {
    "laplace": {"features": 4, "gammas": 3, "gamma_max": 0.9, "acting_gamma": 0.9}, "dqn": {"gamma": 0.9},
    "c51": {"gamma": 0.9, "atoms": 5}, "qrdqn": {"gamma": 0.9, "quantiles": 4}, "expectile": {"gamma": 0.9},
}  # fmt: skip


@pytest.mark.parametrize("algorithm", list(SMALL))
def test_the_value_of_the_greedy_action_less_what_came(algorithm, monkeypatch):
    """CartPole pays 1 a step: N steps are worth (1 - .9^N) / .1 at a discount of .9. Action 1 is worth 7, 0 less."""
    agent = AGENTS[algorithm](SETTINGS[algorithm](hidden=8, **SMALL[algorithm]), 4, 2, 500)
    assert agent.acting_discount == pytest.approx(0.9)
    monkeypatch.setattr(agent, "action_values", lambda seen, head=None: np.tile([3.0, 7.0], (len(seen), 1)))
    scores, error = evaluated(agent, "CartPole-v1", 4, 2)
    came = (1.0 - 0.9**scores.lengths) / 0.1
    assert len(scores.returns) == 4
    assert error == pytest.approx(7.0 - came.mean())


def test_values_of_the_next_steps_only_are_held_against_nothing():
    agent = AGENTS["fixed_horizon"](SETTINGS["fixed_horizon"](hidden=8, horizon=6), 4, 2, 500)
    assert agent.acting_discount is None
    assert evaluated(agent, "CartPole-v1", 2, 0)[1] is None
