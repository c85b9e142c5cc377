"""Decoded against simulated: numbers that can be told beforehand."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
import torch

from laplace_core import GammaSpace
from laplace_core.acting.continuations import Continuations, outcomes_of_states
from laplace_core.acting.simulated_truth import confront, confront_states, empirical
from laplace_core.agents import LaplaceSettings
from laplace_core.code.encoding import reward_distance, theta_midpoints
from laplace_core.code.interpolation import with_added
from laplace_core.inverse import decode
from laplace_core.study.horizon import expected_rewards
from laplace_core.training.checkpoint import new_agent

torch.set_num_threads(1)
GAMMAS, THETAS, K = np.linspace(0.05, 0.98, 40), np.array([-1.0, 0.5, 1.5, 2.5]), 6


class HardTails:
    """Thresholds that are as hard as a step."""

    @staticmethod
    def tails(rewards):
        above = (rewards[..., None] > torch.tensor(THETAS)).float()
        return torch.cat([torch.ones_like(above[..., :1]), above], dim=-1)


HARD = SimpleNamespace(gammas=GAMMAS, thetas=THETAS, sensitivities=HardTails, gamma_spaces=list, gamma_space=list)
"""What an agent with a gamma-space has; its spaces are not asked for here."""


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
    found = confront(HARD, exact_space(simulated.rewards, simulated.alive), 1, simulated, alpha=1e-9)
    np.testing.assert_allclose(found.simulated.survival, [1, 1, 0.5, 0.5, 0.5, 0])
    np.testing.assert_allclose(found.simulated.reward, [1, 1, 0.5, 0.5, 1, 0])
    np.testing.assert_allclose(found.survival, found.simulated.survival, atol=1e-4)
    np.testing.assert_allclose(found.distance, 0, atol=1e-3)
    # Midpoints of these sensitivities: rewards 1 and 2 exactly.
    np.testing.assert_allclose(found.reward, found.simulated.reward, atol=1e-3)
    assert found.simulated.count == 4
    assert np.abs(found.calibration.predicted - found.calibration.observed).max() < 1e-3


def test_one_that_is_a_step_late_is_off_by_what_it_misses(simulated):
    """Tau 0 decoded from nothing: it misses a reward of 1. At tau 4 half of all have 1 in place of 2."""
    late = Continuations(np.roll(simulated.rewards, 1, axis=1), np.roll(simulated.alive, 1, axis=1))
    found = confront(HARD, exact_space(late.rewards, late.alive), 1, simulated, alpha=1e-9)
    assert found.distance[0] == pytest.approx(1.0, abs=1e-3)
    assert found.distance[4] == pytest.approx(0.5, abs=1e-3)
    assert found.survival[0] == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("added", [1, 3])
def test_added_discounts_are_decoded_as_the_more_that_they_are(simulated, added):
    """They used to be compared with the discounts that the agent has learned, and did not fit."""
    space = with_added(exact_space(simulated.rewards, simulated.alive), added)
    assert len(space.gammas) == len(GAMMAS) + (len(GAMMAS) - 1) * added
    found = confront(HARD, space, 1, simulated, alpha=1e-2)
    tau_space = decode(space.differences[1], space.gammas, K, 1e-2)
    np.testing.assert_allclose(found.reward, expected_rewards(tau_space, theta_midpoints(THETAS)))
    np.testing.assert_allclose(found.survival, decode(space.constant[1][:, None], space.gammas, K, 1e-2)[:, 0])
    assert found.calibration.counts.sum() == simulated.rewards.size * len(THETAS)


def atoms(places, masses):
    """Tau-space of one step, ``(1, H-1)``, with masses in the cells of -1, .5 to 2.5 of THETAS."""
    found = np.zeros((1, 3))
    np.add.at(found[0], places, masses)
    return found


def test_the_distance_of_two_laws_by_hand():
    """Cells of uniform mass over (-1, .5), (.5, 1.5), (1.5, 2.5); what is missing lies at 0.

    All of it in the second against all in the third: moved by 1. In the first, mean -.25, against over: |x| of a
    uniform x on (-1, .5) is (1/2 + .125) / 1.5 = .41667 on average. Half in the second against over: half of 1.
    """
    tails = np.array([[1.0, 1.0, 1.0, 0.0]])
    assert reward_distance(atoms([1], [1.0]), tails, THETAS) == pytest.approx([1.0])
    nothing = np.zeros((1, 4))
    assert reward_distance(atoms([0], [1.0]), nothing, THETAS) == pytest.approx([0.625 / 1.5])
    assert reward_distance(atoms([1], [0.5]), nothing, THETAS) == pytest.approx([0.5])


def test_the_distance_is_that_of_many_draws():
    """Against the area between the sorted draws, alive or 0, from the same cells."""
    rng = np.random.default_rng(0)
    thetas = np.array([-3.0, -1.0, -0.25, 0.5, 1.0, 4.0])
    one, other = rng.dirichlet(np.ones(6), size=2)[:, :5]  # the sixth part is over

    def draws(masses):
        cells = rng.choice(6, size=400_000, p=[*masses, 1 - masses.sum()])
        low, high = np.append(thetas[:-1], 0.0), np.append(thetas[1:], 0.0)
        return np.sort(low[cells] + rng.random(cells.size) * (high - low)[cells])

    wanted = np.abs(draws(one) - draws(other)).mean()
    tails = np.append(np.cumsum(other[::-1])[::-1], 0.0)
    found = reward_distance(one[None], tails[None], thetas)[0]
    # Exact where the two cumulated masses do not cross inside a cell, else a little more: trapezoids of |x|.
    assert wanted - 0.01 < found < wanted + 0.06
    midpoints = theta_midpoints(thetas)
    assert found >= abs((one - other) @ midpoints) - 1e-9


def test_chance_is_what_few_draws_of_the_truth_are_off():
    """Rewards 1 with .3, else over, 50 draws: |mean - .3| is sqrt(2 / pi) sqrt(.3 .7 / 50) = .0517 on average."""
    rng = np.random.default_rng(1)
    off, said = [], []
    for _ in range(400):
        alive = rng.random((50, 1)) < 0.3
        found = empirical(HARD, Continuations(alive * 1.0, alive))
        truth = atoms([1], [0.3])
        off.append(found.distance(truth, THETAS)[0])
        said.append(found.chance[0])
    assert np.mean(off) == pytest.approx(0.0517, rel=0.1)
    assert np.mean(said) == pytest.approx(0.0517, rel=0.05)


def test_many_states_are_their_mean():
    settings = LaplaceSettings(hidden=8, features=4, gammas=4, thetas=5, theta_min=-3.0, theta_max=12.0, seed=3)
    agent = new_agent(settings)
    states = outcomes_of_states(agent, "CartPole-v1", episodes=2, each=3, steps=20)
    found = confront_states(agent, states, 0.5)
    each = []
    for observation, action in zip(states.observations, states.actions, strict=True):
        space = agent.gamma_space(observation)
        rewards = np.array([agent.thetas[0], *theta_midpoints(agent.thetas), agent.thetas[-1]])  # the ends are open
        each.append(expected_rewards(decode(space.differences[action], agent.gammas, 20, 0.5), rewards))
    np.testing.assert_allclose(found.reward, np.mean(each, axis=0), rtol=1e-4, atol=1e-6)
    np.testing.assert_allclose(found.simulated.survival, states.alive.mean(axis=0))
    assert found.calibration.counts.sum() == states.alive.size * 5
