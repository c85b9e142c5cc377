"""Decoded against simulated: numbers that can be told beforehand."""

from __future__ import annotations

import numpy as np
import pytest
import torch

from laplace_core import GammaSpace
from laplace_core.agents import LaplaceSettings
from laplace_core.encoding import theta_midpoints
from laplace_core.horizon import expected_rewards
from laplace_core.inverse import decode
from laplace_core.training.checkpoint import new_agent
from laplace_core.training.continuations import Continuations, outcomes_of_states
from laplace_core.training.simulated_truth import confront, confront_states

torch.set_num_threads(1)
GAMMAS, THETAS, K = np.linspace(0.05, 0.98, 40), np.array([-1.0, 0.5, 1.5, 2.5]), 6


def exact_space(rewards: np.ndarray, alive: np.ndarray) -> GammaSpace:
    """The gamma-space of hard thresholds that these continuations stand for, of action 1; of action 0, nothing."""
    powers = GAMMAS[:, None] ** np.arange(K)
    tails = (alive[..., None] & (rewards[..., None] > THETAS)).mean(axis=0)
    values, constant = powers @ tails, powers @ alive.mean(axis=0)
    return GammaSpace(np.stack([0 * values, values]), np.stack([0 * constant, constant]), GAMMAS, THETAS)


@pytest.fixture
def simulated():
    """Of four continuations two last for two steps, paying 1 each, and two for five, paying 2 at the last."""
    alive = np.arange(K) < np.array([2, 2, 5, 5])[:, None]
    rewards = np.where(np.arange(K) == 4, 2.0, 1.0) * alive
    return Continuations(rewards, alive)


def test_a_gamma_space_that_is_true_is_not_far_off(simulated):
    found = confront(exact_space(simulated.rewards, simulated.alive), 1, simulated, 1e-9)
    np.testing.assert_allclose(found.survival, [1, 1, 0.5, 0.5, 0.5, 0])
    np.testing.assert_allclose(found.reward, [1, 1, 0.5, 0.5, 1, 0])
    np.testing.assert_allclose(found.decoded_survival, found.survival, atol=1e-4)
    np.testing.assert_allclose(found.distance, 0, atol=1e-3)
    # Midpoints of these sensitivities: rewards 1 and 2 exactly.
    np.testing.assert_allclose(found.decoded_reward, found.reward, atol=1e-3)
    assert found.count == 4
    assert np.abs(found.calibration.predicted - found.calibration.observed).max() < 1e-3


def test_one_that_is_a_step_late_is_off_by_what_it_misses(simulated):
    """Tau 0 decoded from nothing: P(r > -1) and P(r > .5) are missed by 1 each; trapezoids over theta give 1.5 + .5."""
    late = Continuations(np.roll(simulated.rewards, 1, axis=1), np.roll(simulated.alive, 1, axis=1))
    found = confront(exact_space(late.rewards, late.alive), 1, simulated, 1e-9)
    assert found.distance[0] == pytest.approx(2.0, abs=1e-3)
    assert found.decoded_survival[0] == pytest.approx(0.0, abs=1e-3)


def test_many_states_are_their_mean():
    settings = LaplaceSettings(hidden=8, features=4, gammas=4, thetas=5, theta_min=-3.0, theta_max=12.0, seed=3)
    agent = new_agent(settings)
    states = outcomes_of_states(agent, "CartPole-v1", episodes=2, each=3, steps=20)
    found = confront_states(agent, states, 0.5)
    each = []
    for observation, action in zip(states.observations, states.actions, strict=True):
        space = agent.gamma_space(observation)
        each.append(
            expected_rewards(decode(space.differences[action], agent.gammas, 20, 0.5), theta_midpoints(agent.thetas))
        )
    np.testing.assert_allclose(found.decoded_reward, np.mean(each, axis=0), rtol=1e-4, atol=1e-6)
    np.testing.assert_allclose(found.survival, states.alive.mean(axis=0))
    assert found.calibration.counts.sum() == states.alive.size * 5
