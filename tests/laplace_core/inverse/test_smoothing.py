"""The Savitzky-Golay filter over the discounts: by hand, by local fits, and what it may not do."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError
from laplace_core.code.encoding import discount_grid
from laplace_core.inverse.smoothing import filtered, probability_filter, savgol_matrix
from tests.support.random_gamma_spaces import noisy, random_space


def test_the_coefficients_of_the_textbook():
    # Savitzky and Golay (1964): a parabola through 5 points has the central weights (-3, 12, 17, 12, -3) / 35.
    np.testing.assert_allclose(savgol_matrix(9)[4], np.array([0, 0, -3, 12, 17, 12, -3, 0, 0]) / 35, atol=1e-12)
    np.testing.assert_allclose(savgol_matrix(5, 3, 0)[2], [0, 1 / 3, 1 / 3, 1 / 3, 0], atol=1e-12)
    np.testing.assert_array_equal(savgol_matrix(4, 1, 0), np.eye(4))


@given(st.integers(3, 20), st.sampled_from([3, 5, 7]), st.integers(0, 4), st.integers(0, 10**6))
def test_it_is_a_fit_of_a_polynomial_to_each_window(count, window, order, seed):
    if window > count or order >= window:
        return
    values = np.random.default_rng(seed).normal(size=count)
    expected, half = np.empty(count), window // 2
    for i in range(count):
        first = min(max(i - half, 0), count - window)  # at the ends, the outermost window
        places = np.arange(first, first + window)
        expected[i] = np.polyval(np.polyfit(places - i, values[places], order), 0.0)
    np.testing.assert_allclose(savgol_matrix(count, window, order) @ values, expected, atol=1e-9)


def test_a_gamma_space_is_filtered_as_probabilities():
    # (1 - gamma) Q a parabola over the index: it stays as it is, though Q itself is none.
    space = random_space(np.random.default_rng(3), least=(12, 4), kind="shared")
    G = space.gammas.size
    chances = 0.2 + 0.01 * np.arange(G) - 0.0005 * np.arange(G) ** 2
    matrix = probability_filter(space.gammas, 5, 2)
    np.testing.assert_allclose(matrix @ (chances / (1 - space.gammas)), chances / (1 - space.gammas), rtol=1e-10)
    found = filtered(space, 5, 2)
    np.testing.assert_allclose(found.values, matrix @ space.values)
    np.testing.assert_allclose(found.constant, space.constant @ matrix.T)
    np.testing.assert_allclose(found.differences, matrix @ space.differences, atol=1e-9)


def test_neighbours_are_those_of_the_sorted_grid():
    gammas, order = discount_grid(9), np.random.default_rng(0).permutation(9)
    mixed = probability_filter(gammas[order], 5, 2)
    np.testing.assert_allclose(mixed, probability_filter(gammas, 5, 2)[np.ix_(order, order)])


def test_it_takes_noise_away():
    # A weight of 17/35 at the centre leaves a variance of (9 + 144 + 289 + 144 + 9) / 35^2 = .486.
    clean = random_space(np.random.default_rng(7), least=(15, 20), kind="shared")
    rng, scale = np.random.default_rng(1), 1.0 - clean.gammas[:, None]
    left = [filtered(noisy(clean, 1.0, rng)).values - filtered(clean).values for _ in range(50)]
    inner = (np.array(left) * scale)[..., 2:-2, :]
    assert np.mean(inner**2) == pytest.approx(595 / 35**2, rel=0.1)


def test_windows_that_do_not_fit_are_refused(subtests):
    for window, order, named in [(4, 2, "--filter-window is 4"), (17, 2, "at most 15"), (0, 0, "--filter-window is 0"),
                                 (5, 5, "--filter-order is 5"), (5, -1, "--filter-order is -1")]:  # fmt: skip
        with subtests.test(window=window, order=order), pytest.raises(InputError, match=named):
            savgol_matrix(15, window, order)
