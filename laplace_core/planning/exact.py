"""Exact gamma-space of a tabular world, through the reward-indicator basis.

For the distinct rewards v of a world,

    W[a, g, v] = E[ sum_tau gamma_g^tau 1[r_tau = v] | s, a ],        gamma_space = W @ f,  f[v, h] = f_h(v),

so that sensitivities and slope cost one small product and never a new solve. For one state, W follows from
the discounted occupancy of the later states, x = (I - gamma P_pi^T)^-1 P(. | s, a): one sparse factorisation a
discount and one right-hand side an action, whatever the number of rewards.
"""

from __future__ import annotations

import numpy as np
from scipy import sparse

from laplace_core.errors import InputError
from laplace_core.planning.policies import Discounted, selection, solve_discounted
from laplace_core.worlds.model import World


def reward_indicator_basis(world: World, state: int, gammas: np.ndarray, policies: list[np.ndarray]) -> np.ndarray:
    """W of one state, shape ``(A, G, V)``, in expected discounted counts of each reward.

    Args:
        state: index of the state in which the action is free; ``policies[g]`` decides afterwards.
        gammas: discounts in (0, 1), shape ``(G,)``.
        policies: one int ``(S,)`` or float ``(S, A)`` policy a discount; equal objects share their work.
    """
    gammas = _check_gammas(gammas)
    if len(policies) != gammas.size:
        raise InputError(f"there are {len(policies)} policies for {gammas.size} discounts; give one each.")
    pairs = slice(state * world.n_actions, (state + 1) * world.n_actions)
    now = world.reward_probabilities[pairs].toarray()
    basis = np.empty((world.n_actions, gammas.size, now.shape[1]))
    process: _Successors | None = None
    for g, (gamma, policy) in enumerate(zip(gammas, policies, strict=True)):
        if process is None or process.policy is not policy:
            process = _Successors(world, pairs, policy)
        basis[:, g] = now + gamma * process.discounted_rewards(gamma)
    return basis


class _Successors:
    """The process after one state's actions under a policy, restricted to the states that it can reach."""

    def __init__(self, world: World, pairs: slice, policy: np.ndarray):
        self.policy = policy
        pi = selection(world, policy)
        moves, first = (pi @ world.transition_matrix).tocsr(), world.transition_matrix[pairs]
        reached = _closure(moves, np.unique(first.indices))
        self.first = first[:, reached].toarray().T
        self.system = Discounted(moves[reached][:, reached].T)
        self.rewards = (pi @ world.reward_probabilities)[reached]

    def discounted_rewards(self, gamma: float) -> np.ndarray:
        """E sum_{tau >= 1} gamma^(tau - 1) 1[r_tau = v], shape ``(A, V)``."""
        if not self.first.size:
            return np.zeros((self.first.shape[1], self.rewards.shape[1]))
        return self.system.solve(gamma, self.first).T @ self.rewards


def _closure(moves: sparse.csr_array, states: np.ndarray) -> np.ndarray:
    """Every state that can be reached from ``states``, themselves included, in increasing order."""
    seen = np.zeros(moves.shape[0], dtype=bool)
    while states.size:
        seen[states] = True
        reached = np.unique(moves[states].indices)
        states = reached[~seen[reached]]
    return np.flatnonzero(seen)


def proxy_gamma_space(world: World, rewards: np.ndarray, gammas: np.ndarray, policies: list[np.ndarray]) -> np.ndarray:
    """Expected discounted sum of any reward ``rewards[v]`` put in place of v, for ALL states, ``(S, A, G)``.

    With the midpoint proxy sum_h theta_mid[h] (f_h - f_{h+1})(v) this is Eq. 9 in every state at once.
    """
    gammas = _check_gammas(gammas)
    now = world.reward_probabilities @ np.asarray(rewards, dtype=float)
    values = np.empty((world.n_states, world.n_actions, gammas.size))
    for g, (gamma, policy) in enumerate(zip(gammas, policies, strict=True)):
        pi = selection(world, policy)
        later = solve_discounted(pi @ world.transition_matrix, float(gamma), pi @ now)
        values[:, :, g] = (now + gamma * (world.transition_matrix @ later)).reshape(world.n_states, world.n_actions)
    return values


def _check_gammas(gammas: np.ndarray) -> np.ndarray:
    gammas = np.asarray(gammas, dtype=float)
    if gammas.ndim != 1 or not gammas.size or not np.all((gammas > 0) & (gammas < 1)):
        raise InputError("discounts must be a list of numbers between 0 and 1, both excluded.")
    return gammas
