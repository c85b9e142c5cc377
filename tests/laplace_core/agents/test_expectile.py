"""Expectile DQN: its loss, and the distribution imputed to expectiles."""

from __future__ import annotations

import numpy as np
import pytest
import torch
from hypothesis import example, given, settings
from hypothesis import strategies as st

from laplace_core.agents.expectile import LEAST_TAIL, _minorant_slopes, expectile_loss, impute
from laplace_core.tabular import peers as tables

torch.set_num_threads(1)
LEVELS = torch.tensor([0.25, 0.5, 0.75])


def levels(count: int) -> np.ndarray:
    return np.arange(1, count + 1) / (count + 1)


def expectile(locations: np.ndarray, masses: np.ndarray, level: float) -> float:
    """By bisection of its first-order condition."""
    low, high = locations.min(), locations.max()
    for _ in range(100):
        e = (low + high) / 2
        pull = np.where(locations < e, 1.0 - level, level) * (locations - e) @ masses
        low, high = (e, high) if pull > 0 else (low, e)
    return (low + high) / 2


def imputed(expectiles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    found = impute(torch.tensor(expectiles)[None], torch.tensor(levels(expectiles.size)))
    return tuple(part[0].double().numpy() for part in found)


def test_an_expectile_loss_worked_by_hand():
    """Levels 1/4, 1/2, 3/4, expectiles 0, 1, 2, targets 1 and 3 with masses 1/2; weights level above, 1 - level below.

    0: u = 1, 3: 1/4 (1 + 9) / 2 = 1.25, gradient -2 * 1/4 (1 + 3) / 2 = -1.
    1: u = 0, 2: 1/2 * 4 / 2 = 1, gradient -2 * 1/2 * 2 / 2 = -1.
    2: u = -1, 1: (1/4 + 3/4) / 2 = .5, gradient -2 (3/4 - 1/4) / 2 = -.5.
    """
    outputs = torch.tensor([[0.0, 1.0, 2.0]], requires_grad=True)
    loss = expectile_loss(outputs, torch.tensor([[1.0, 3.0]]), torch.tensor([[0.5, 0.5]]), LEVELS)
    loss.sum().backward()
    assert loss.item() == pytest.approx(2.75)
    np.testing.assert_allclose(outputs.grad[0], [-1.0, -1.0, -0.5])


def test_the_loss_equals_a_triple_loop():
    random = np.random.default_rng(0)
    e, y, p, t = random.normal(size=(4, 5)), random.normal(size=(4, 7)), random.dirichlet(np.ones(7), 4), levels(5)
    found = expectile_loss(*(torch.tensor(array) for array in (e, y, p, t)))
    for b in range(4):
        cost = 0.0
        for i in range(5):
            for j in range(7):
                u = y[b, j] - e[b, i]
                cost += p[b, j] * (t[i] if u > 0 else 1.0 - t[i]) * u * u
        assert found[b].item() == pytest.approx(cost)


def test_an_imputation_worked_by_hand():
    """X is 0 or 4, evenly; levels 1/4, 1/2, 3/4: t E(X - e)+ = (1 - t) E(e - X)+ gives e = 1, 2, 3.

    E(X - e)+ is (4 - e) / 2: 3/2 at 1 and 1/2 at 3, slope -1/2 between. The tails: the mass beyond may be as large as
    1/(3 + 1), which puts the end at 3 + (1/2) / (1/4) = 5, and by symmetry the other at -1. There are 1/4 each at
    -1, 1, 3, 5: another distribution than X, with the same expectiles.
    """
    locations, masses = imputed(np.array([1.0, 2.0, 3.0]))
    np.testing.assert_allclose(locations, [-1.0, 1.0, 3.0, 5.0], atol=1e-6)
    np.testing.assert_allclose(masses, 0.25, atol=1e-6)


DISTRIBUTIONS = st.lists(
    st.tuples(st.floats(-100.0, 100.0), st.floats(0.02, 1.0)), min_size=1, max_size=12
).map(lambda pairs: (np.array(pairs)[:, 0], np.array(pairs)[:, 1] / sum(mass for _, mass in pairs)))  # fmt: skip


@settings(deadline=None)
@given(DISTRIBUTIONS, st.sampled_from([3, 5, 11, 31]))
@example((np.array([-100.0, 0.0]), np.array([0.03, 0.97])), 11)  # tails lighter than 1/12 and far away
@example((np.array([0.0, 100.0]), np.array([0.97, 0.03])), 11)
def test_the_imputed_distribution_has_the_expectiles_of_the_true_one(distribution, count):
    if min(distribution[1][distribution[0].argmin()], distribution[1][distribution[0].argmax()]) < LEAST_TAIL:
        return  # rarer than promised
    true = np.array([expectile(*distribution, level) for level in levels(count)])
    locations, masses = imputed(true)
    assert np.all(np.diff(locations) >= 0)
    again = np.array([expectile(locations, masses, level) for level in levels(count)])
    np.testing.assert_allclose(again, true, atol=3e-5)  # locations of 100 in single precision


def test_the_tables_impute_the_same_expectiles_by_least_squares():
    """Neither is the true distribution, which expectiles do not tell; both meet the conditions of paper, Eq. 12."""
    random = np.random.default_rng(0)
    truth = random.normal(size=9), random.dirichlet(np.full(9, 2.0))
    true = np.array([expectile(*truth, level) for level in levels(11)])
    for locations, masses in (imputed(true), tables.impute(true, levels(11), truth[0].min(), truth[0].max())):
        conditions = tables.expectile_conditions(locations, true, levels(11)) @ masses
        np.testing.assert_allclose(conditions, 0.0, atol=1e-5)


@given(st.sampled_from([3, 5, 11]).flatmap(lambda n: st.lists(st.floats(-1e3, 1e3), min_size=n, max_size=n)))
def test_any_outputs_stand_for_a_distribution_with_their_mean(outputs):
    """Whatever a network gives: out of order, equal, or the expectiles of no distribution."""
    locations, masses = imputed(np.array(outputs))
    assert np.all(np.isfinite(locations))
    assert np.all(np.diff(locations) >= 0)
    assert masses.min() >= 0.0
    assert masses.sum() == pytest.approx(1.0, abs=1e-5)
    middle = outputs[len(outputs) // 2]
    assert locations @ masses == pytest.approx(middle, abs=1e-5 * (1.0 + np.abs(locations).max()))


def test_equal_expectiles_are_one_return():
    locations, masses = imputed(np.full(11, 7.0))
    np.testing.assert_allclose(locations, 7.0, atol=1e-6)
    assert masses.sum() == pytest.approx(1.0)


@given(st.lists(st.floats(-5.0, 5.0), min_size=3, max_size=8))
def test_the_minorant_is_the_lower_hull(heights):
    """Against the lower hull by walking: drop a point wherever the path turns to the right."""
    x, y = np.cumsum(np.arange(1.0, len(heights) + 1.0)), np.array(heights)
    hull: list[int] = []
    for i in range(len(x)):
        while len(hull) > 1 and slope(x, y, hull[-2], hull[-1]) >= slope(x, y, hull[-1], i):
            hull.pop()
        hull.append(i)
    expected = np.diff(np.interp(x, x[hull], y[hull])) / np.diff(x)
    found = _minorant_slopes(torch.tensor(x)[None], torch.tensor(y)[None])[0]
    np.testing.assert_allclose(found, expected, atol=1e-9)


def slope(x: np.ndarray, y: np.ndarray, i: int, j: int) -> float:
    return (y[j] - y[i]) / (x[j] - x[i])
