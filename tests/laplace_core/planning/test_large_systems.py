"""Linear systems of large worlds: by factorisation where the factors are sparse, by iteration elsewhere."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import sparse

from laplace_core.planning import policies
from laplace_core.planning.policies import selection, solve_discounted, state_values
from laplace_core.worlds import World
from laplace_core.worlds.model import Outcome


def _wide(states: int = 1_200) -> World:
    """Each state leads to eight others, drawn at random: no numbering makes this a narrow band."""
    rng = np.random.default_rng(3)
    outcomes = []
    for state in range(states):
        for action in range(2):
            share = rng.dirichlet(np.ones(8))
            for p, following in zip(share, rng.choice(states, 8, replace=False), strict=True):
                outcomes.append(Outcome(state, action, float(p), int(following), float(rng.integers(-2, 3))))
    names = tuple(f"s{i}" for i in range(states))
    return World.from_outcomes("wide", names, ("a", "b"), outcomes)


@pytest.mark.parametrize("gamma", [0.3, 0.9, 0.999])
def test_a_wide_system_is_solved_as_by_dense_elimination(gamma):
    world = _wide()
    moves = selection(world, np.zeros(world.n_states, dtype=int)) @ world.transition_matrix
    right = np.random.default_rng(0).normal(size=(world.n_states, 2))
    for matrix in (moves, moves.T):
        for b in (right, right[:, 0]):
            expected = np.linalg.solve(np.eye(world.n_states) - gamma * matrix.toarray(), b)
            found = solve_discounted(matrix, gamma, b)
            assert found.shape == b.shape
            # A residual of 1e-12 of b, times the norm of the inverse: at most 1 / (1 - gamma) for rows or for columns.
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-11 * np.abs(b).max() / (1 - gamma))


def test_a_wide_system_is_not_factorised(monkeypatch):
    """Of 5,000 states a factorisation takes half a minute, and a study needs 50 of them."""
    world = _wide()

    def refuse(*_):
        raise AssertionError("factorised")

    monkeypatch.setattr("scipy.sparse.linalg.splu", refuse)
    assert np.isfinite(state_values(world, np.zeros(world.n_states, dtype=int), 0.99)).all()


def test_what_does_not_converge_is_factorised(monkeypatch):
    """A ring of 1,500 states, numbered at random, is a band of two; made wide by decree, it takes too many steps."""
    n = 1_500
    order = np.random.default_rng(1).permutation(n)
    ring = sparse.csr_array((np.ones(n), (order, np.roll(order, 1))), shape=(n, n))
    assert policies._products_to_factorise(ring) <= 4 * n
    monkeypatch.setattr(policies, "_DIRECT", 0.0)
    right = np.random.default_rng(0).normal(size=n)
    assert policies._iterated(sparse.eye_array(n, format="csc") - 0.9999 * ring.tocsc(), right) is None
    found = solve_discounted(ring, 0.9999, right)
    np.testing.assert_allclose(found - 0.9999 * (ring @ found), right, atol=1e-8)
