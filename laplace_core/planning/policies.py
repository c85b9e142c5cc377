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


_DIRECT = 1e9
"""Products that a factorisation may take by its estimate: about a second."""
_RESIDUAL = 1e-12


def solve_discounted(moves: sparse.sparray, gamma: float, right: np.ndarray) -> np.ndarray:
    """x in (I - gamma M) x = b at one discount: see :meth:`Discounted.solve`."""
    return Discounted(moves).solve(gamma, right)


class Discounted:
    """(I - gamma M) x = b of one matrix M at any discount. The rows of M, or its columns, sum to at most 1."""

    def __init__(self, moves: sparse.sparray):
        self._system = sparse.eye_array(moves.shape[0], dtype=complex, format="csc") + 1j * moves.tocsc()
        self._system.sum_duplicates()  # in the order that the factorisation puts them in
        # The entries of I are the real part and those of M the imaginary one: only their difference is left to do.
        self._identity, self._moves = self._system.data.real.copy(), self._system.data.imag.copy()
        self._iterates = _products_to_factorise(moves) > _DIRECT

    def solve(self, gamma: float, right: np.ndarray) -> np.ndarray:
        """x for b of shape ``(S,)`` or ``(S, n)``.

        By one sparse factorisation; where its factors would be nearly dense, by BiCGSTAB (van der Vorst 1992), to a
        residual of 1e-12 of b: x is then exact to 1e-12 / (1 - gamma) of b, in the largest element or in the sum.
        """
        from scipy.sparse.linalg import splu  # half the library's import time, and only needed to solve

        self._system.data = self._identity - gamma * self._moves
        iterated = _iterated(self._system, right) if self._iterates else None
        return splu(self._system).solve(right) if iterated is None else iterated


def _products_to_factorise(moves: sparse.sparray) -> float:
    """An estimate: those of a band matrix, S b^2, with the half bandwidth b that reverse Cuthill-McKee finds.

    States on a line or a grid are a narrow band. Where every state leads to any other, b is nearly S.
    """
    n = moves.shape[0]
    if float(n) ** 3 <= _DIRECT:
        return float(n) ** 3
    from scipy.sparse.csgraph import reverse_cuthill_mckee

    joined = (moves + moves.T).tocsr()
    place = np.empty(n, dtype=int)
    place[reverse_cuthill_mckee(joined, symmetric_mode=True)] = np.arange(n)
    first, second = joined.nonzero()
    band = np.abs(place[first] - place[second]).max(initial=0)
    return float(n) * float(band) ** 2


def _iterated(system: sparse.csc_array, right: np.ndarray) -> np.ndarray | None:
    """The solution by iteration; None where that does not converge."""
    from scipy.sparse.linalg import bicgstab

    columns = right.reshape(right.shape[0], -1).T
    found = np.empty(columns.shape)
    for each, column in zip(found, columns, strict=True):
        each[:], _ = bicgstab(system, column, rtol=0.1 * _RESIDUAL, atol=0.0, maxiter=1_000)
        # What the iteration believes of its residual drifts from what it is.
        if not np.linalg.norm(column - system @ each) <= _RESIDUAL * np.linalg.norm(column):
            return None
    return found.T.reshape(right.shape)


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


_SMALL = 200
"""States of a world in which a factorisation costs no more than some twenty products."""


def _swept_policy(world: World, gamma: float) -> np.ndarray:
    """A first guess by value iteration: a sweep is a product, a step of policy iteration a factorisation."""
    values = np.zeros(world.n_states)
    for _ in range(1_000 if world.n_states > _SMALL else 50):
        q = action_values(world, values, gamma)
        change = np.abs(q.max(axis=1) - values).max()
        values = q.max(axis=1)
        if change <= 1e-6 * np.abs(values).max():
            break
    return greedy_action(q)


def target_policies(world: World, gammas: np.ndarray, kind: str, acting_gamma: float) -> list[np.ndarray]:
    """The policy that each discount evaluates, one ``(S,)`` array a discount.

    ``shared``: all the one that is greedy at ``acting_gamma``, which makes gamma-space a true transform.
    ``per_gamma``: each its own greedy policy, as in the paper; no single process has these values. Neighbours that
    have the same policy share one object.
    """
    if kind not in TARGET_POLICIES:
        raise InputError(f"policy {kind!r} is not one of {', '.join(TARGET_POLICIES)}.")
    if kind == "shared":
        return [greedy_policy(world, acting_gamma)] * len(gammas)
    policies: list[np.ndarray] = []
    for gamma in gammas:
        last = policies[-1] if policies else None
        policy = greedy_policy(world, float(gamma), last)
        policies.append(policy if last is None or not np.array_equal(policy, last) else last)
    return policies
