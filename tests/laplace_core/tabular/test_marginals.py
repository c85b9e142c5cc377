"""A decoded tau-space as laws: worked by hand, row by row with a root finder, and what always holds."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

from laplace_core.tabular.marginals import marginals

REWARDS = np.array([-1.0, 0.0, 1.0])


@pytest.mark.parametrize(
    ("row", "wanted"),
    [
        ([0.2, 0.3, 0.4], [0.2, 0.3, 0.4]),  # a law already; what it lacks to 1 pays nothing
        ([0.6, -0.2, 0.6], [0.5, 0.0, 0.5]),  # mean 0 and total 1 of what is left, -1 and 1
        ([0.5, -0.2, 0.7], [0.4, 0.0, 0.6]),  # mean .2: .6 - .4
        ([0.0, 0.0, 1.3], [0.0, 0.0, 1.0]),  # mean 1.3: as near as rewards of 1 allow
        ([-0.4, 0.0, 0.5], [0.0, 0.0, 0.9]),  # mean .9: the total of .1 is too small for it
        ([-0.1, 0.0, 0.0], [0.0, 0.0, 0.0]),  # nothing is left to tilt
        ([0.9, 0.0, 0.6], [0.65, 0.0, 0.35]),  # above 1: total 1, mean -.3
    ],
)
def test_rows_worked_by_hand(row, wanted):
    np.testing.assert_allclose(marginals(np.array([row]), REWARDS)[0], wanted, atol=1e-9)


def by_root(row: np.ndarray, rewards: np.ndarray) -> np.ndarray:
    """The tilt of one row by a root finder; the ends of the bracket where its mean cannot be had."""
    mean, total = row @ rewards, min(1.0, max(0.0, row.sum()))
    left, reached = np.maximum(row, 0.0), rewards[row > 0]
    farthest = max(0.0, reached.max()) if mean > 0 else min(0.0, reached.min())
    if farthest:
        total = min(1.0, max(total, mean / farthest))

    def tilted(tilt: float) -> np.ndarray:
        found = left * np.exp(tilt * (rewards - rewards.mean()) / np.ptp(rewards))
        return total * found / found.sum()

    gap = [tilted(end) @ rewards - mean for end in (-40.0, 40.0)]
    if gap[0] * gap[1] > 0:
        return tilted(-40.0 if gap[0] > 0 else 40.0)
    return tilted(brentq(lambda tilt: tilted(tilt) @ rewards - mean, -40.0, 40.0, xtol=1e-13))


@given(seed=st.integers(0, 10_000), noise=st.sampled_from([0.01, 0.1, 0.5]))
def test_rows_are_laws_with_the_mean_that_was_decoded(seed, noise):
    rng = np.random.default_rng(seed)
    rewards = np.sort(rng.normal(size=6))
    tau_space = rng.dirichlet(np.ones(6), 8) * rng.random((8, 1)) + noise * rng.normal(size=(8, 6))
    found = marginals(tau_space, rewards)
    assert np.all(found >= 0)
    assert np.all(found.sum(axis=1) <= 1.0 + 1e-9)
    for row, law in zip(tau_space, found, strict=True):
        if (row >= 0).all() and row.sum() <= 1:
            np.testing.assert_allclose(law, row, atol=1e-9)
        elif (row > 0).any():
            np.testing.assert_allclose(law @ rewards, by_root(row, rewards) @ rewards, atol=1e-6)
            np.testing.assert_allclose(law, by_root(row, rewards), atol=1e-5)
