"""Noise by counting: its law, its independence, and numbers that another language has to meet."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import stats

from laplace_core.code.noise import normal_noise


def by_hand(seed: int, number: int) -> float:
    """One number with Python's own integers."""

    def hashed(x: int) -> int:
        x = ((x ^ (x >> 16)) * 0x7FEB352D) & 0xFFFFFFFF
        x = ((x ^ (x >> 15)) * 0x846CA68B) & 0xFFFFFFFF
        return x ^ (x >> 16)

    first = hashed(seed ^ 0x9E3779B9)
    u, v = (hashed((first + 2 * number + i) & 0xFFFFFFFF) for i in (0, 1))
    return math.sqrt(-2.0 * math.log((u + 0.5) / 2**32)) * math.cos(2.0 * math.pi * v / 2**32)


@pytest.mark.parametrize("seed", [0, 1, 7, 2**31 - 1])
def test_each_number_is_the_one_that_the_formula_gives(seed):
    found = normal_noise(seed, (3, 5))
    np.testing.assert_allclose(found.ravel(), [by_hand(seed, n) for n in range(15)], rtol=1e-14)
    np.testing.assert_array_equal(normal_noise(seed, (10,), skip=5), found.ravel()[5:])


@pytest.mark.parametrize("seed", range(5))
def test_the_numbers_are_normal_and_know_nothing_of_each_other(seed):
    found = normal_noise(seed, (40_000,))
    assert stats.kstest(found, "norm").pvalue > 1e-4
    for lag in (1, 2, 3, 250):
        assert abs(np.corrcoef(found[:-lag], found[lag:])[0, 1]) < 4.0 / math.sqrt(found.size)
    assert abs(np.corrcoef(found, normal_noise(seed + 1, (40_000,)))[0, 1]) < 4.0 / math.sqrt(found.size)
