"""Timelines that are drawn directly are ones that a world could have."""

import numpy as np
import pytest

from laplace_core.inverse.timelines import Timelines, draw_timelines


@pytest.fixture(scope="module")
def drawn() -> Timelines:
    return draw_timelines(np.random.default_rng(0), 400, 60, 6)


def test_timelines_are_feasible(drawn):
    assert drawn.masses.min() >= 0.0
    survival = drawn.masses.sum(axis=-1)
    np.testing.assert_allclose(survival[:, 0], 1.0)
    assert np.diff(survival, axis=-1).max() < 1e-12
    assert np.all(drawn.beyond.sum(axis=(1, 2)) <= survival[:, -1] + 1e-12)
    assert np.all((drawn.endings >= 0) & (drawn.endings <= 1))


def test_many_kinds_are_among_them(drawn):
    """Of 400: some that never end, some that end before the last row, late ones, and some with one bin only."""
    survival = drawn.masses.sum(axis=-1)
    assert 20 < (drawn.beyond.sum(axis=(1, 2)) > 0.999).sum() < 200
    assert (survival[:, -1] < 1e-9).sum() > 50
    assert ((survival[:, -1] > 0.01) & (survival[:, -1] < 0.9)).sum() > 50
    used = (drawn.masses.max(axis=1) > 0).sum(axis=-1)
    assert used.min() == 1
    assert used.max() == 6


def test_the_transform_goes_on_after_the_last_row(drawn):
    """The twin adds further rows one by one."""
    gammas = np.array([0.3, 0.9, 0.95])
    found = drawn.transformed(gammas)
    for n in range(20):
        total = sum(gammas[:, None] ** k * drawn.masses[n, k] for k in range(60))
        for c in range(3):
            for k in range(1500):
                total = total + gammas[:, None] ** (60 + k) * (1.0 - drawn.endings[n, c]) ** k * drawn.beyond[n, c]
        np.testing.assert_allclose(found[n], total, atol=1e-10)


def test_the_same_seed_draws_the_same():
    first, second = (draw_timelines(np.random.default_rng(3), 5, 30, 4) for _ in range(2))
    np.testing.assert_array_equal(first.masses, second.masses)
    np.testing.assert_array_equal(first.endings, second.endings)
