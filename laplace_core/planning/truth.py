"""The truth of a tabular world: reward timelines and the finite-horizon optimum."""

from __future__ import annotations

import numpy as np
from scipy import sparse

from laplace_core.planning.policies import action_values, selection
from laplace_core.worlds.model import World


def reward_timeline(world: World, state: int, policy: np.ndarray, steps: int) -> np.ndarray:
    """P(r_tau = reward_values[v], alive at tau | s, a), shape ``(A, steps, V)``.

    The action is free at tau = 0 and the policy's afterwards; the sum over v is the survival.
    """
    pairs = slice(state * world.n_actions, (state + 1) * world.n_actions)
    pi = selection(world, policy)
    moves, rewards = pi @ world.transition_matrix, pi @ world.reward_probabilities
    # Where a step leads and what it pays, in one product that scipy need not transpose at every step.
    step = sparse.hstack([moves, rewards], format="csr").T
    timeline = np.zeros((world.n_actions, steps, rewards.shape[1]))
    timeline[:, 0] = world.reward_probabilities[pairs].toarray()
    distribution = world.transition_matrix[pairs].toarray().T
    for tau in range(1, steps):
        after = step @ distribution
        distribution, paid = after[: world.n_states], after[world.n_states :]
        timeline[:, tau] = paid.T
    return timeline


def finite_horizon_optimum(world: World, steps: int, gamma: float, state: int | None = None) -> np.ndarray:
    """Q*_T(s, a) for T = 1..steps: the best that T more steps can hold.

    Backward induction: Q*_T = E[r] + gamma E max_a' Q*_{T-1}(s', a'), Q*_0 = 0.

    Returns:
        ``(steps, S, A)``, or ``(steps, A)`` for one ``state``, without ever holding the rest.
    """
    rows = slice(None) if state is None else state
    values = np.empty((steps, *world.expected_reward[rows].shape))
    best = np.zeros(world.n_states)
    for horizon in range(steps):
        now = action_values(world, best, gamma)
        values[horizon] = now[rows]
        best = now.max(axis=1)
    return values


def value_of_rule(world: World, actions: np.ndarray, gamma: float) -> np.ndarray:
    """J_T(s): what a rule that looks at the time to go collects, shape ``(steps, S)``.

    Args:
        actions: ``actions[T-1, s]``, the action taken in s with T steps to go, int ``(steps, S)``.
    """
    collected = np.empty(actions.shape)
    later = np.zeros(world.n_states)
    everywhere = np.arange(world.n_states)
    for horizon, chosen in enumerate(actions):
        later = action_values(world, later, gamma)[everywhere, chosen]
        collected[horizon] = later
    return collected
