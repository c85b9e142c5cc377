"""Acting for whole episodes by decoded values, and what that costs against the optimum.

A decision here is made in every state and for every time to go; the value of such a rule is then exact, by
backward induction over the world, so that a regret is never a matter of sampling.
"""

from __future__ import annotations

import numpy as np

from laplace_core.caching import cached
from laplace_core.code.encoding import read_at_midpoints
from laplace_core.code.gamma_space import encode
from laplace_core.code.ties import greedy_action
from laplace_core.errors import InputError
from laplace_core.inverse import LINEAR, is_linear
from laplace_core.planning import finite_horizon_optimum, proxy_gamma_space, reward_indicator_basis, value_of_rule
from laplace_core.planning.policies import selection
from laplace_core.study.horizon import horizon_values, row_horizons
from laplace_core.study.pipeline import (
    check_fold,
    clipped_sensitivities,
    folded_values,
    grids,
    inverted,
    policies_of,
    read_study,
    timeline_from,
)
from laplace_core.study.settings import ResolvedForWorld
from laplace_core.study.size import largest_study
from laplace_core.worlds import World

MAX_WORK = 100_000_000
"""Numbers decoded for all states together before :func:`values_everywhere` refuses (a second or two of work); twice the
largest study where that is less."""

MAX_SOLVES = 2_000
"""States x discounts that are solved one by one where rows are rescaled (a second or two as well)."""


def values_everywhere(world: World, settings: ResolvedForWorld, learned: np.ndarray | None = None) -> np.ndarray:
    """Decoded V_T(s, a) for every state, ``(S, A, K)``, under resolved settings, without their noise.

    Rows left alone are linear in gamma-space: one decode of the midpoint proxy does. Rescaled rows are not,
    and every state is decoded in full.

    Args:
        learned: a learned reward-indicator basis of every state, ``(S, A, G, V)``, in place of the exact one.

    Raises:
        InputError: the world is too large for that, or the solver is not linear.
    """
    s = settings
    if not is_linear(s.solver):
        raise InputError(f"whole episodes in all states need a linear solver, one of {', '.join(LINEAR)}.")
    gammas, thetas = grids(s)
    if s.clip:
        timeline = timeline_from(world, s)
        clipped = clipped_sensitivities(s, world, timeline)
        thetas = thetas if clipped is None else clipped
    width = 1 if s.normalise == "none" else max(s.thetas, world.reward_values.size)
    work = world.n_states * world.n_actions * max(s.steps, s.gammas) * width
    solves = 0 if s.normalise == "none" or learned is not None else world.n_states * s.gammas
    if solves > MAX_SOLVES:
        raise InputError(
            f"rescaled rows need {solves:,} solves, one a state and discount, above {MAX_SOLVES:,}: "
            "leave the rows as they are."
        )
    check_fold(s, len(gammas), world.n_states * world.n_actions * width)
    most = min(MAX_WORK, 2 * largest_study())
    if work > most:
        raise InputError(
            f"a whole episode in {world.n_states:,} states at {s.steps} steps is {work:,} numbers, above "
            f"{most:,}: lower steps or thetas, or leave the rows as they are."
        )
    if s.normalise == "none":
        proxy = read_at_midpoints(world.reward_values, thetas, s.slope)[1]
        if learned is None:
            values = _proxies(world, proxy.tobytes(), gammas.tobytes(), s.policy, acting_gamma=s.acting_gamma)
        else:
            values = learned @ proxy
        if s.fold:
            return folded_values(lambda row: inverted(values[..., None], gammas, s, row)[..., 0], s)
        rewards = inverted(values[..., None], gammas, s)[..., 0]
        return horizon_values(rewards, s.value_gamma, s.softness, s.time_step)
    bases = _bases(world, gammas.tobytes(), s.policy, s.acting_gamma) if learned is None else learned
    decoded = [
        read_study(encode(basis, world.reward_values, gammas, thetas, s.slope), s).horizon_values for basis in bases
    ]
    return np.array(decoded)


@cached(4)
def _proxies(world: World, rewards: bytes, gammas: bytes, policy: str, *, acting_gamma: float) -> np.ndarray:
    """Cached :func:`laplace_core.planning.proxy_gamma_space`, ``(S, A, G)``."""
    grid = np.frombuffer(gammas)
    return proxy_gamma_space(world, np.frombuffer(rewards), grid, policies_of(world, grid, policy, acting_gamma))


@cached(4)
def _optimum(world: World, horizon: int, gamma: float) -> np.ndarray:
    return finite_horizon_optimum(world, horizon, gamma)


@cached(4)
def _bases(world: World, gammas: bytes, policy: str, acting_gamma: float) -> np.ndarray:
    """The reward-indicator basis of every state, ``(S, A, G, V)``, so that alpha and slope cost no solve."""
    grid = np.frombuffer(gammas)
    policies = policies_of(world, grid, policy, acting_gamma)
    return np.array([reward_indicator_basis(world, state, grid, policies) for state in range(world.n_states)])


def rule_actions(values: np.ndarray, time_step: float = 1.0) -> np.ndarray:
    """The action taken with T = 1, 2, ... whole steps to go, int ``(T, S)``, from ``(S, A, K)`` values."""
    available = row_horizons(values.shape[-1], time_step)
    whole = np.arange(1, int(np.floor(available[-1] + 1e-9)) + 1)
    columns = np.abs(available - whole[:, None]).argmin(axis=1)
    return np.moveaxis(greedy_action(values[:, :, columns], axis=1), -1, 0)


def episode_regret(
    world: World, actions: np.ndarray, gamma: float, optimum: np.ndarray, *, constant_horizon: int | None = None
) -> np.ndarray:
    """V*_T(s) - J_T(s), what an episode of T steps under the rule loses, ``(T, S)``, >= 0.

    Args:
        actions: from :func:`rule_actions`; row T - 1 is used with T steps to go.
        optimum: :func:`laplace_core.planning.finite_horizon_optimum` over all states, ``(T, S, A)``.
        constant_horizon: act at every step as if this many steps were left (an artefact of the paper's
            experiment), instead of by the time to go.
    """
    if constant_horizon is not None:
        if not 1 <= constant_horizon <= len(actions):
            raise InputError(f"the constant horizon is {constant_horizon}; it must be from 1 to {len(actions)}.")
        actions = np.broadcast_to(actions[constant_horizon - 1], actions.shape)
    return optimum[: len(actions)].max(axis=2) - value_of_rule(world, actions, gamma)


def constant_horizon_values(world: World, actions: np.ndarray, gamma: float) -> np.ndarray:
    """The value of an episode of T steps in which every step is acted as if all T were left, ``(T, S)``.

    Row T - 1 belongs to the rule ``actions[T - 1]`` kept throughout; horizons with the same rule share their work.
    """
    collected = np.empty(actions.shape)
    rules, which = np.unique(actions, axis=0, return_inverse=True)
    for number, rule in enumerate(rules):
        wanted = np.flatnonzero(which.ravel() == number)
        pi = selection(world, rule)
        moves, now = gamma * (pi @ world.transition_matrix), pi @ world.expected_reward.ravel()
        later = np.zeros(world.n_states)
        for step in range(wanted[-1] + 1):
            later = now + moves @ later
            if step in wanted:
                collected[step] = later
    return collected


def episode_regret_of(
    world: World, settings: ResolvedForWorld, constant_horizon: int | None = None, learned: np.ndarray | None = None
) -> np.ndarray:
    """:func:`episode_regret` of acting by the study's decoded values, ``(T, S)``.

    Under ``settings.deadline`` = constant, an episode of T steps is acted with T at every one of them.
    ``learned`` is as in :func:`values_everywhere`.
    """
    if constant_horizon is None and settings.deadline == "constant":
        constant, _, best = _episodes(world, settings) if learned is None else _played(world, settings, learned)
        return best - constant
    actions = rule_actions(values_everywhere(world, settings, learned), settings.time_step)
    optimum = _optimum(world, len(actions), settings.acting_gamma)
    return episode_regret(world, actions, settings.acting_gamma, optimum, constant_horizon=constant_horizon)


def constant_horizon_loss(world: World, settings: ResolvedForWorld) -> tuple[np.ndarray, np.ndarray]:
    """The loss of an episode of T steps that is acted with T throughout instead of the time to go, ``(T, S)``.

    Returns:
        the loss, negative where wrong values make the constant T the better one, and the value of the best episode.

    Raises:
        InputError: the world is too large for whole episodes.
    """
    constant, by_time_to_go, best = _episodes(world, settings)
    return by_time_to_go - constant, best


@cached(4)
def _episodes(world: World, settings: ResolvedForWorld) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Cached :func:`_played` by exact values."""
    return _played(world, settings)


def _played(
    world: World, settings: ResolvedForWorld, learned: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Value of an episode of T steps acted with constant T, by the time to go, and at best, ``(T, S)`` each."""
    actions, gamma = (
        rule_actions(values_everywhere(world, settings, learned), settings.time_step),
        settings.acting_gamma,
    )
    best = _optimum(world, len(actions), gamma).max(axis=2)
    return constant_horizon_values(world, actions, gamma), value_of_rule(world, actions, gamma), best
