"""Acting for whole episodes by decoded values, and what that costs against the optimum.

A decision here is made in every state and for every time to go; the value of such a rule is then exact, by
backward induction over the world, so that a regret is never a matter of sampling.
"""

from __future__ import annotations

import numpy as np

from laplace_core.encoding import bin_masses, theta_midpoints
from laplace_core.errors import InputError
from laplace_core.horizon import horizon_values
from laplace_core.inverse import decode
from laplace_core.learning import finite_horizon_optimum, proxy_gamma_space, reward_indicator_basis, value_of_rule
from laplace_core.settings import Settings
from laplace_core.study import decode_and_read, encode, grids, policies_of
from laplace_core.ties import greedy_action
from laplace_core.worlds import World

MAX_WORK = 400_000_000
"""Numbers decoded for all states together before :func:`values_everywhere` refuses (a few seconds of work)."""


def values_everywhere(world: World, settings: Settings) -> np.ndarray:
    """Decoded V_T(s, a) for every state, ``(S, A, K)``, under resolved settings.

    Rows left alone are linear in gamma-space: one decode of the midpoint proxy does. Rescaled rows are not,
    and every state is decoded in full.

    Raises:
        InputError: the world is too large for that.
    """
    s = settings
    gammas, thetas = grids(s)
    policies = policies_of(world, gammas, s.policy, s.acting_gamma)
    work = world.n_states * world.n_actions * s.steps * (1 if s.normalise == "none" else s.thetas)
    if work > MAX_WORK:
        raise InputError(
            f"a whole episode in {world.n_states:,} states at {s.steps} steps is {work:,} numbers, above "
            f"{MAX_WORK:,}: lower steps or thetas, or leave the rows as they are."
        )
    if s.normalise == "none":
        proxy = bin_masses(world.reward_values, thetas, s.slope) @ theta_midpoints(thetas)
        values = proxy_gamma_space(world, proxy, gammas, policies)
        rewards = decode(values[..., None], gammas, s.steps, s.alpha, s.time_step)[..., 0]
        return horizon_values(rewards, s.acting_gamma, s.softness, s.time_step)
    decoded = np.empty((world.n_states, world.n_actions, s.steps))
    for state in range(world.n_states):
        basis = reward_indicator_basis(world, state, gammas, policies)
        gamma_space = encode(basis, world.reward_values, gammas, thetas, s.slope)
        decoded[state] = decode_and_read(gamma_space, s).horizon_values
    return decoded


def rule_actions(values: np.ndarray, time_step: float = 1.0) -> np.ndarray:
    """The action taken with T = 1, 2, ... whole steps to go, int ``(T, S)``, from ``(S, A, K)`` values."""
    horizons = np.arange(1, int(np.floor(values.shape[-1] * time_step + 1e-9)) + 1)
    columns = np.rint(horizons / time_step).astype(int) - 1
    return np.moveaxis(greedy_action(values[:, :, columns], axis=1), -1, 0)


def episode_regret(
    world: World, actions: np.ndarray, gamma: float, optimum: np.ndarray, constant_horizon: int | None = None
) -> np.ndarray:
    """V*_T(s) - J_T(s), what an episode of T steps under the rule loses, ``(T, S)``, >= 0.

    Args:
        actions: from :func:`rule_actions`; row T - 1 is used with T steps to go.
        optimum: :func:`laplace_core.learning.finite_horizon_optimum` over all states, ``(T, S, A)``.
        constant_horizon: act at every step as if this many steps were left (an artefact of the paper's
            experiment), instead of by the time to go.
    """
    if constant_horizon is not None:
        actions = np.broadcast_to(actions[constant_horizon - 1], actions.shape)
    return optimum[: len(actions)].max(axis=2) - value_of_rule(world, actions, gamma)


def episode_regret_of(world: World, settings: Settings, constant_horizon: int | None = None) -> np.ndarray:
    """:func:`episode_regret` of acting by the study's decoded values, ``(T, S)``."""
    actions = rule_actions(values_everywhere(world, settings), settings.time_step)
    optimum = finite_horizon_optimum(world, len(actions), settings.acting_gamma)
    return episode_regret(world, actions, settings.acting_gamma, optimum, constant_horizon)
