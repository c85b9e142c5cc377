"""Policies of a tabular world and the Markov reward process that each leaves behind."""

from __future__ import annotations

import numpy as np
from scipy import sparse

from laplace_core.code.ties import greedy_action, tie_size
from laplace_core.errors import InputError
from laplace_core.worlds.model import World

TARGET_POLICIES = ("shared", "per_gamma")


def check_policy(world: World, policy: np.ndarray) -> np.ndarray:
    """A given policy as int ``(S,)`` or float ``(S, A)``.

    Raises:
        InputError: wrong shape, unknown actions, or rows that are no distributions.
    """
    policy = np.asarray(policy)
    if policy.shape == (world.n_states,) and np.issubdtype(policy.dtype, np.integer):
        if policy.min() < 0 or policy.max() >= world.n_actions:
            raise InputError(f"the policy names an action outside 0 to {world.n_actions - 1}.")
        return policy
    if policy.shape != (world.n_states, world.n_actions):
        raise InputError(
            f"a policy has shape ({world.n_states},), integers, or ({world.n_states}, {world.n_actions}), "
            f"probabilities; this one has shape {policy.shape}."
        )
    if not np.all(policy >= 0) or not np.allclose(policy.sum(axis=1), 1.0, atol=1e-9):
        raise InputError("every row of the policy must be a probability distribution over the actions.")
    return policy.astype(float)


def selection(world: World, policy: np.ndarray) -> sparse.csr_array:
    """Pi, shape ``(S, S*A)``: Pi @ x averages x[s, a] over pi(a | s)."""
    states = np.arange(world.n_states)
    shape = (world.n_states, world.n_states * world.n_actions)
    if policy.ndim == 1:
        columns = states * world.n_actions + policy
        return sparse.csr_array((np.ones(world.n_states), (states, columns)), shape=shape)
    rows, actions = np.nonzero(policy)
    return sparse.csr_array((policy[rows, actions], (rows, rows * world.n_actions + actions)), shape=shape)


def solve_discounted(moves: sparse.sparray, gamma: float, right: np.ndarray) -> np.ndarray:
    """x in (I - gamma M) x = b by one sparse factorisation, for b of shape ``(S,)`` or ``(S, n)``."""
    from scipy.sparse.linalg import splu  # half the library's import time, and only needed to solve

    system = sparse.eye_array(moves.shape[0], format="csc") - gamma * moves.tocsc()
    return splu(system).solve(right)


def state_values(world: World, policy: np.ndarray, gamma: float) -> np.ndarray:
    """V(s) = E sum_tau gamma^tau r_tau under the policy, shape ``(S,)``, by one sparse solve."""
    pi = selection(world, policy)
    return solve_discounted(pi @ world.transition_matrix, gamma, pi @ world.expected_reward.ravel())


def action_values(world: World, values: np.ndarray, gamma: float) -> np.ndarray:
    """Q(s, a) = E[r] + gamma E V(s'), shape ``(S, A)``, for state values ``(S,)``."""
    return world.expected_reward + gamma * (world.transition_matrix @ values).reshape(world.expected_reward.shape)


def greedy_policy(world: World, gamma: float, warm_start: np.ndarray | None = None) -> np.ndarray:
    """The optimal policy at one discount, int ``(S,)``, by policy iteration on true expected rewards.

    An action is replaced only when another is better beyond the tie tolerance, so that the iteration ends;
    the result then takes the lowest of all tied actions.

    Raises:
        ArithmeticError: no convergence (more sweeps than policy iteration can need in practice).
    """
    policy = _swept_policy(world, gamma) if warm_start is None else warm_start.copy()
    everywhere = np.arange(world.n_states)
    for _ in range(10 * world.n_states + 100):
        q = action_values(world, state_values(world, policy, gamma), gamma)
        largest = float(np.abs(q).max())
        greedy = greedy_action(q, scale=largest)
        # An action within the tolerance of the best is as good as the best: changing it would never end.
        best = q.max(axis=1)
        better = best - q[everywhere, policy] > tie_size(best, largest)
        if not better.any():
            return greedy
        policy = np.where(better, greedy, policy)
    raise ArithmeticError(f"policy iteration on {world.name!r} at gamma={gamma:g} did not converge")


def _swept_policy(world: World, gamma: float, sweeps: int = 1_000) -> np.ndarray:
    """A first guess by value iteration: a sweep is a product, a step of policy iteration a factorisation."""
    values = np.zeros(world.n_states)
    for _ in range(sweeps):
        q = action_values(world, values, gamma)
        change = np.abs(q.max(axis=1) - values).max()
        values = q.max(axis=1)
        if change <= 1e-6 * np.abs(values).max():
            break
    return greedy_action(q)


def target_policies(world: World, gammas: np.ndarray, kind: str, acting_gamma: float) -> list[np.ndarray]:
    """The policy that each discount evaluates, one ``(S,)`` array a discount.

    ``shared``: all the one that is greedy at ``acting_gamma``, which makes gamma-space a true transform.
    ``per_gamma``: each its own greedy policy, as in the paper; no single process has these values.
    """
    if kind not in TARGET_POLICIES:
        raise InputError(f"policy {kind!r} is not one of {', '.join(TARGET_POLICIES)}.")
    if kind == "shared":
        return [greedy_policy(world, acting_gamma)] * len(gammas)
    policies: list[np.ndarray] = []
    for gamma in gammas:
        policies.append(greedy_policy(world, float(gamma), policies[-1] if policies else None))
    return policies
