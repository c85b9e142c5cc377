"""Deadlines that make sense for an agent in its environment."""

from __future__ import annotations

import pytest

from laplace_core.acting.deadlines import (
    USUAL,
    longest_horizon,
    rules_of_race,
    suited_steps,
    trained_discount,
    usual_horizon,
)
from laplace_core.agents import LaplaceSettings
from laplace_core.agents.settings import SETTINGS
from laplace_core.training.checkpoint import new_agent


@pytest.fixture(scope="module")
def agent():
    return new_agent(LaplaceSettings(hidden=8, features=4, gammas=5, thetas=5, theta_max=12.0))


def test_a_tabular_world_has_the_length_that_suits_it(agent):
    suited = suited_steps("two_branch")
    assert usual_horizon(agent, "two_branch") == suited
    assert longest_horizon(agent, "two_branch") == 4 * suited
    assert suited_steps("CartPole-v1") is None
    assert (usual_horizon(agent, "CartPole-v1"), longest_horizon(agent, "CartPole-v1")) == (USUAL, 500)


def test_one_that_takes_the_time_to_go_has_one_rule():
    assert rules_of_race(new_agent(SETTINGS["fixed_horizon"](hidden=8))) == ("own",)


def test_a_discount_is_the_nearest_that_was_learned_and_none_for_the_acting_one(agent):
    first, acting = float(agent.gammas[0]), float(agent.gammas[agent.acting_head])
    assert trained_discount(agent, first + 1e-4) == first
    assert trained_discount(agent, acting) is None
    assert trained_discount(agent, None) is None
    assert trained_discount(new_agent(SETTINGS["dqn"](hidden=8)), 0.5) is None
