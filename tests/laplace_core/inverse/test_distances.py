"""Distances between timelines against slow twins and values by hand."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import wasserstein_distance

from laplace_core.inverse.distances import (
    choice_regret,
    mean_time_distance,
    relative_error,
    time_distance,
    total_variation,
    value_error,
    value_range,
)


def pair(seed: int, shape=(2, 6, 3)) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    return rng.normal(size=shape), rng.uniform(size=shape)


def test_distances_by_hand():
    truth = np.array([[1.0, 0.0], [0.0, 0.0], [0.0, 0.5], [0.0, 0.0]])
    late = np.array([[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.0, 0.0]])
    # Bin 0: a mass of 1, two steps late. Bin 1: .5 is missing at row 2, so as if it lay at row 4, two steps away.
    np.testing.assert_allclose(time_distance(late, truth), [2.0, 1.0])
    np.testing.assert_allclose(time_distance(late, truth, 0.5), [1.0, 0.5])
    assert mean_time_distance(late, truth) == pytest.approx(3.0 / 1.5)
    # Errors -1, 1 and -.5; the truth is 1 and .5.
    assert relative_error(late, truth) == pytest.approx(np.sqrt(2.25 / 1.25))
    assert total_variation(late, truth) == pytest.approx(2.5 / 2 / 1.5)


def test_of_nothing_a_distance_is_what_there_is_too_much():
    nothing = np.zeros((3, 1))
    assert mean_time_distance(nothing, nothing) == 0.0
    assert mean_time_distance(np.array([[0.0], [1.0], [0.0]]), nothing) == 2.0
    assert relative_error(np.ones((3, 1)), nothing) == pytest.approx(np.sqrt(3))


@given(st.integers(0, 10_000))
def test_equal_masses_have_the_distance_that_scipy_finds(seed):
    rng = np.random.default_rng(seed)
    here, there = rng.dirichlet(np.ones(7), size=2)
    rows = np.arange(7)
    assert time_distance(here[:, None], there[:, None])[0] == pytest.approx(
        wasserstein_distance(rows, rows, here, there), abs=1e-12
    )


@given(st.integers(0, 10_000), st.sampled_from([1.0, 0.5]))
def test_missing_mass_lies_after_the_last_row(seed, time_step):
    """The twin puts what either lacks of 1 into one more row and asks scipy."""
    rng = np.random.default_rng(seed)
    here, there = rng.dirichlet(np.ones(8), size=2)[:, :7]
    rows = np.arange(8) * time_step
    whole = [np.append(each, 1.0 - each.sum()) for each in (here, there)]
    assert time_distance(here[:, None], there[:, None], time_step)[0] == pytest.approx(
        wasserstein_distance(rows, rows, *whole), abs=1e-12
    )


@given(st.integers(0, 10_000))
def test_of_expected_reward_it_is_the_error_of_all_values_together(seed):
    here, there = pair(seed, (6, 1))
    by_horizon = [abs(here[:T].sum() - there[:T].sum()) for T in range(1, 7)]
    assert time_distance(here, there)[0] == pytest.approx(sum(by_horizon))


@given(st.integers(0, 10_000))
def test_measures_against_loops(seed):
    here, there = pair(seed)
    for a in range(2):
        sizes = [abs(here[a, k, b] - there[a, k, b]) for k in range(6) for b in range(3)]
        mass = sum(there[a, k, b] for k in range(6) for b in range(3))
        steps = sum(abs(sum(here[a, j, b] - there[a, j, b] for j in range(k + 1))) for k in range(6) for b in range(3))
        assert total_variation(here, there)[a] == pytest.approx(sum(sizes) / 2 / mass)
        squares = sum(size**2 for size in sizes) / sum(x**2 for x in there[a].ravel())
        assert relative_error(here, there)[a] == pytest.approx(np.sqrt(squares))
        assert mean_time_distance(here, there)[a] == pytest.approx(steps / mass)


def test_errors_of_values_and_regret_by_hand():
    truth = np.array([[1.0, 1.0, 1.0], [0.0, 2.0, 5.0]])
    values = np.array([[1.0, 3.0, 1.0], [0.0, 2.0, 4.0]])
    assert value_range(truth) == 5.0
    assert value_error(values, truth) == pytest.approx((2.0 + 1.0) / 6 / 5)
    # At T = 2 action 0 is chosen, which is worth 1 and not 2.
    assert choice_regret(values, truth) == pytest.approx(1.0 / 3 / 5)
    assert choice_regret(truth, truth) == value_error(truth, truth) == 0.0
    # Equal values choose action 0, which loses 0, 1 and 4.
    assert choice_regret(np.zeros((2, 3)), truth) == pytest.approx((0 + 1 + 4) / 3 / 5)


def test_a_range_is_never_nothing():
    assert value_range(np.full((2, 3), -4.0)) == 4.0
    assert value_range(np.zeros((2, 3))) == 1.0
