"""Decoded timelines against simulated ones: expected reward, survival, how far tau-space is off, and calibration.

Everything is decoded with whole steps and without rescaling, whatever a picture beside it does.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from laplace_core.agents.agent import Agent
from laplace_core.encoding import theta_midpoints
from laplace_core.errors import InputError
from laplace_core.horizon import expected_rewards
from laplace_core.inverse import decode
from laplace_core.pipeline import GammaSpace
from laplace_core.training.continuations import Calibration, Continuations, Outcomes, calibration


@dataclass(frozen=True, eq=False)
class Confronted:
    """On K future steps, each simulated mean with its standard error over ``count`` simulations or states.

    Attributes:
        reward, reward_error, decoded_reward: ``(K,)``, E[r_tau], in units of reward.
        survival, survival_error, decoded_survival: ``(K,)``, probabilities.
        distance: ``(K,)``, the area between the decoded and the simulated P(r_tau > theta, alive) over the range of
            theta, in units of reward: the W1 distance of the two laws where both are wholly inside that range.
        calibration: of P(r_tau > theta, alive), over all steps and sensitivities.
    """

    count: int
    reward: np.ndarray
    reward_error: np.ndarray
    decoded_reward: np.ndarray
    survival: np.ndarray
    survival_error: np.ndarray
    decoded_survival: np.ndarray
    distance: np.ndarray
    calibration: Calibration


def confront(space: GammaSpace, action: int, found: Continuations, alpha: float) -> Confronted:
    """One state's gamma-space and the continuations that begin with an action."""
    mine = (each[action][None] for each in (space.differences, space.values, space.constant))
    return _confronted(found, *mine, space.gammas, space.thetas, alpha)


def confront_states(agent: Agent, found: Outcomes, alpha: float) -> Confronted:
    """Many states' gamma-spaces and what came after each; means are over the states.

    Raises:
        InputError: an agent without a gamma-space.
    """
    if not hasattr(agent, "gamma_spaces"):
        raise InputError("this agent has no gamma-space to hold against what came.")
    values, constant = agent.gamma_spaces(found.observations)
    row = np.arange(len(values))
    tails, constant = values[row, found.actions], constant[row, found.actions]
    differences = tails[..., :-1] - tails[..., 1:]
    simulated = Continuations(found.rewards, found.alive)
    return _confronted(simulated, differences, tails, constant, agent.gammas, agent.thetas, alpha)


def _confronted(
    found: Continuations, differences: np.ndarray, tails: np.ndarray, constant: np.ndarray, gammas: np.ndarray,
    thetas: np.ndarray, alpha: float,
) -> Confronted:  # fmt: skip
    """Gamma-space of one state or of as many as there are simulations: differences ``(S, G, H-1)``, tails
    ``(S, G, H)``, constant ``(S, G)``."""
    count, steps = found.rewards.shape
    decoded_tails = decode(tails, gammas, steps, alpha)  # (S, K, H)
    reward = expected_rewards(decode(differences, gammas, steps, alpha), theta_midpoints(thetas)).mean(axis=0)
    alive = decode(constant[..., None], gammas, steps, alpha)[..., 0].mean(axis=0)
    observed, _ = found.exceeds(thetas)
    gap = np.abs(decoded_tails.mean(axis=0) - observed)
    distance = ((gap[:, :-1] + gap[:, 1:]) / 2.0) @ np.diff(thetas)  # trapezoids
    happened = found.alive[..., None] & (found.rewards[..., None] > thetas)
    said = np.broadcast_to(decoded_tails, happened.shape)
    return Confronted(count, *found.expected, reward, *found.survival, alive, distance, calibration(said, happened))
