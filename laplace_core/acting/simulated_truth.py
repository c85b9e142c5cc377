"""Decoded timelines against simulated ones: expected reward, survival, the error of tau-space, and calibration.

Rewards are seen through the agent's own activation: what it learned is E f_h(r), and a threshold that a reward meets
exactly is passed by half of it. Everything is decoded with whole steps and without rescaling.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import torch

from laplace_core.acting.continuations import Calibration, Continuations, Outcomes, calibration, standard_error
from laplace_core.agents.agent import Agent
from laplace_core.agents.capabilities import HasGammaSpace
from laplace_core.code.encoding import area_around_zero, reward_distance
from laplace_core.code.gamma_space import GammaSpace
from laplace_core.errors import InputError
from laplace_core.inverse import decode
from laplace_core.study.horizon import expected_rewards


@dataclass(frozen=True, eq=False)
class Empirical:
    """The timeline of ``count`` simulations on K steps; means with their standard errors.

    Attributes:
        tails: ``(K, H)``, E f_h(r_tau) over those alive: what a perfect tau-space sums up to.
        reward, reward_error: ``(K,)``, E[r_tau], in units of reward.
        survival, survival_error: ``(K,)``, P(alive).
        chance: ``(K,)``, the distance that a perfect tau-space has on average, because simulations are few.
    """

    count: int
    tails: np.ndarray
    reward: np.ndarray
    reward_error: np.ndarray
    survival: np.ndarray
    survival_error: np.ndarray
    chance: np.ndarray

    @property
    def open_tails(self) -> np.ndarray:
        """The tails at the edges of a tau-space with open ends, ``(K, H+2)``: alive before them, nothing after."""
        return with_ends(self.tails, self.survival)

    def distance(self, tau_space: np.ndarray, thetas: np.ndarray) -> np.ndarray:
        """W1 distance to a tau-space ``(K, H-1)``, or with open ends ``(K, H+1)``: ``(K,)``.

        See :func:`laplace_core.code.encoding.reward_distance`. What lies in an open end counts at its sensitivity, so
        that there, too, a distance is never less than the difference of the expected rewards.
        """
        if tau_space.shape[-1] < thetas.size:
            return reward_distance(tau_space, self.tails, thetas)
        return reward_distance(tau_space, self.open_tails, np.concatenate([thetas[:1], thetas, thetas[-1:]]))


def with_ends(tails: np.ndarray, alive: np.ndarray) -> np.ndarray:
    """P(alive), the tails, and 0, ``(..., H+2)``, from tails ``(..., H)`` and ``(...)``."""
    return np.concatenate([alive[..., None], tails, np.zeros((*alive.shape, 1))], axis=-1)


def empirical(agent: Agent, sample: Continuations) -> Empirical:
    """The timeline that an agent with a gamma-space should decode, estimated from continuations."""
    passed = _passed(agent, sample)
    assert isinstance(agent, HasGammaSpace)  # :func:`_passed` refused any other
    thetas = agent.thetas
    places, ends = np.concatenate([thetas[:1], thetas, thetas[-1:]]), with_ends(passed, sample.alive.astype(float))
    # The mean of the absolute value of a normal number is sqrt(2 / pi) times its standard deviation.
    chance = np.sqrt(2.0 / np.pi) * area_around_zero(ends[..., :1] - ends, places, standard_error)
    return Empirical(len(passed), passed.mean(axis=0), *sample.mean_reward, *sample.survival, chance)


def _passed(agent: Agent, sample: Continuations) -> np.ndarray:
    """f_h(r) of every step of every simulation, 0 where it is over, ``(N, K, H)``.

    Raises:
        InputError: an agent without a gamma-space.
    """
    if not isinstance(agent, HasGammaSpace):
        raise InputError("this agent has no gamma-space to compare with simulated rewards.")
    with torch.no_grad():
        passed = agent.sensitivities.tails(torch.as_tensor(sample.rewards, dtype=torch.float32))[..., 1:].double()
    return np.where(sample.alive[..., None], passed.numpy(), 0.0)


@dataclass(frozen=True, eq=False)
class Confronted:
    """A simulated timeline and the decoded one, on K future steps.

    Attributes:
        simulated: means over simulations, or over states.
        reward: ``(K,)``, decoded E[r_tau], in units of reward.
        survival: ``(K,)``, decoded probabilities.
        distance: ``(K,)``, the W1 distance of tau-space, in units of reward.
        calibration: of E f_h(r_tau) over those alive, over all steps and sensitivities.
    """

    simulated: Empirical
    reward: np.ndarray
    survival: np.ndarray
    distance: np.ndarray
    calibration: Calibration


def confront(agent: Agent, space: GammaSpace, action: int, sample: Continuations, *, alpha: float) -> Confronted:
    """One state's gamma-space and the continuations that begin with an action.

    The gamma-space may have more discounts than the agent has learned
    (:func:`laplace_core.code.interpolation.with_added`): it is decoded at its own.
    """
    at = replace(space, values=space.values[[action]], constant=space.constant[[action]])
    return _confronted(agent, sample, at, alpha=alpha)


def confront_states(agent: Agent, outcomes: Outcomes, alpha: float) -> Confronted:
    """Many states' gamma-spaces and the rewards observed after each; means are over the states.

    Raises:
        InputError: an agent without a gamma-space.
    """
    if not isinstance(agent, HasGammaSpace):
        raise InputError("this agent has no gamma-space to compare with simulated rewards.")
    values, constant = agent.gamma_spaces(outcomes.observations)
    row = np.arange(len(values))
    tails, constant = values[row, outcomes.actions], constant[row, outcomes.actions]
    sample = Continuations(outcomes.rewards, outcomes.alive)
    spaces = GammaSpace(tails, constant, agent.gammas, agent.thetas, open_ends=True)
    return _confronted(agent, sample, spaces, alpha=alpha)


def _confronted(agent: Agent, sample: Continuations, spaces: GammaSpace, *, alpha: float) -> Confronted:
    """Gamma-space of one state or of as many as there are simulations: S of them in place of actions."""
    observed, simulated = _passed(agent, sample), empirical(agent, sample)
    steps, gammas, thetas = sample.rewards.shape[1], spaces.gammas, spaces.thetas
    tau_space = decode(spaces.differences, gammas, steps, alpha).mean(axis=0)
    alive = decode(spaces.constant[..., None], gammas, steps, alpha)[..., 0].mean(axis=0)
    predicted = np.broadcast_to(decode(spaces.values, gammas, steps, alpha), observed.shape)
    return Confronted(
        simulated, expected_rewards(tau_space, spaces.bin_values), alive,
        simulated.distance(tau_space, thetas), calibration(predicted, observed),
    )  # fmt: skip
