"""The interquartile mean over seeds and its bootstrap band, against a slow one that lists every ordered sample."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from laplace_core.acting.bootstrap import MOST_SEEDS, interquartile_band
from laplace_core.errors import InputError


def middle(values: list[float]) -> float:
    """The mean without the lowest and the highest quarter, rounded down."""
    cut = len(values) // 4
    ordered = sorted(values)
    return float(np.mean(ordered[cut : len(ordered) - cut]))


def slow_band(column: np.ndarray) -> tuple[float, float, float]:
    """The same for one column: all n^n samples, each as likely, and quantiles that are one of their means."""
    means = [middle(list(sample)) for sample in product(column, repeat=len(column))]
    low, high = np.quantile(means, [0.025, 0.975], method="inverted_cdf")
    return float(low), middle(list(column)), float(high)


# Of 1, 2, 3, 4, 100 the quarter that is left out is one seed on either side: (2 + 3 + 4) / 3 = 3.
def test_one_seed_that_is_far_off_does_not_move_it():
    assert interquartile_band(np.array([[1.0], [2.0], [3.0], [4.0], [100.0]]))[1] == pytest.approx(3.0)


@pytest.mark.parametrize("seeds", [1, 2, 3, 4, 5])
def test_it_is_that_of_all_ordered_samples(seeds):
    curves = np.random.default_rng(seeds).normal(size=(seeds, 6))
    curves[:, 0] = 7.0  # seeds that agree have a band of no width
    for i, ends in enumerate(zip(*interquartile_band(curves), strict=True)):
        assert ends == pytest.approx(slow_band(curves[:, i]))


def test_the_order_of_the_seeds_is_none():
    curves = np.random.default_rng(0).normal(size=(5, 4))
    for one, other in zip(interquartile_band(curves), interquartile_band(curves[::-1]), strict=True):
        np.testing.assert_allclose(one, other)


def test_too_many_seeds_are_refused():
    with pytest.raises(InputError, match=f"{MOST_SEEDS + 1} seeds"):
        interquartile_band(np.zeros((MOST_SEEDS + 1, 2)))
