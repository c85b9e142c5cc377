"""The transform, its regularised inverse, and what is done to the rows afterwards."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError
from laplace_core.code.encoding import discount_grid
from laplace_core.inverse import (
    MAX_STEPS,
    NORMALISATIONS,
    SURVIVAL_FLOOR,
    decode,
    decode_matrix,
    filter_factors,
    normalise_rows,
    resolution_matrix,
    transform_factors,
    transform_matrix,
)
from tests.support.random_worlds import discounts

steps = st.integers(1, 12)
alphas = st.floats(0.01, 3.0)
time_steps = st.sampled_from([1.0, 0.5, 0.3])


def numbers(shape, seed=0) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=shape)


# --- the transform ---


def test_transform_holds_the_powers_of_the_discounts():
    np.testing.assert_allclose(transform_matrix([0.5, 0.25], 3), [[1, 0.5, 0.25], [1, 0.25, 0.0625]])
    # Rows half a step apart: sqrt(gamma).
    np.testing.assert_allclose(transform_matrix([0.25], 3, 0.5), [[1, 0.5, 0.25]])


def test_impossible_transforms_are_refused(subtests):
    for arguments, named in [
        (([0.5, 1.0], 3), "discounts"),
        (([0.0], 3), "discounts"),
        (([math.nan], 3), "discounts"),
        (([], 3), "discounts"),
        (([0.5], 0), "steps"),
        (([0.5], MAX_STEPS + 1), "steps"),
        (([0.5], 3, 0.0), "time-step"),
        (([0.5], 3, 1.5), "time-step"),
    ]:
        with subtests.test(arguments=arguments, named=named), pytest.raises(InputError, match=named):
            transform_matrix(*arguments)


@given(discounts, steps, time_steps)
def test_factors_multiply_to_the_transform(gammas, steps, time_step):
    U, s, Vt = transform_factors(gammas, steps, time_step)
    np.testing.assert_allclose((U * s) @ Vt, transform_matrix(gammas, steps, time_step), atol=1e-12)
    assert np.all(np.diff(s) <= 0)
    assert not any(array.flags.writeable for array in (U, s, Vt))  # they are shared


# --- the inverse ---


@given(discounts, steps, alphas, time_steps)
def test_decoding_solves_the_tikhonov_problem(gammas, steps, alpha, time_step):
    # x minimises |F x - z|^2 + alpha^2 |x|^2. Normal equations: (F^T F + alpha^2 I) x = F^T z. The same
    # minimum is the least-squares solution of F with alpha I stacked below it, against z and zeros.
    F, z = transform_matrix(gammas, steps, time_step), numbers((len(gammas), 3))
    x = decode(z, gammas, steps, alpha, time_step)
    normal = np.linalg.solve(F.T @ F + alpha**2 * np.eye(steps), F.T @ z)
    stacked = np.linalg.lstsq(np.vstack([F, alpha * np.eye(steps)]), np.vstack([z, np.zeros((steps, 3))]))[0]
    np.testing.assert_allclose(x, normal, rtol=0, atol=1e-9)
    np.testing.assert_allclose(x, stacked, rtol=0, atol=1e-9)


def test_without_regularisation_the_inverse_is_the_pseudo_inverse():
    gammas = np.array([0.1, 0.5, 0.9])
    for count in (2, 3, 6):  # over-determined, square, under-determined
        pseudo = np.linalg.pinv(transform_matrix(gammas, count))
        np.testing.assert_allclose(decode_matrix(gammas, count, 0.0), pseudo, atol=1e-10)


@given(st.integers(1, 4), st.integers(0, 10**6))
def test_a_short_timeline_is_decoded_from_its_own_transform(count, seed):
    # Up to four steps seen through 15 discounts: the smallest singular value s is above .001, so that
    # alpha = 1e-7 leaves a relative error of alpha^2 / s^2 < 1e-8.
    gammas = discount_grid(15)
    F, x = transform_matrix(gammas, count), numbers((count, 5), seed)
    assert transform_factors(gammas, count).s[-1] > 0.001
    np.testing.assert_allclose(decode(F @ x, gammas, count, 1e-7), x, rtol=0, atol=1e-7)


@given(discounts, steps, alphas, time_steps)
def test_the_residual_is_what_regularisation_costs(gammas, steps, alpha, time_step):
    # F x - z = -(I - F D) z = -alpha^2 (F F^T + alpha^2 I)^-1 z.
    F, z = transform_matrix(gammas, steps, time_step), numbers((len(gammas), 2))
    expected = -(alpha**2) * np.linalg.solve(F @ F.T + alpha**2 * np.eye(len(gammas)), z)
    found = F @ decode(z, gammas, steps, alpha, time_step) - z
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9)


def test_more_regularisation_fits_less_and_shrinks():
    gammas, z = discount_grid(15), numbers((15, 1))
    F = transform_matrix(gammas, 20)
    found = [decode(z, gammas, 20, alpha) for alpha in (0.001, 0.01, 0.1, 1.0)]
    assert np.all(np.diff([np.linalg.norm(F @ x - z) for x in found]) > 0)
    assert np.all(np.diff([np.linalg.norm(x) for x in found]) < 0)


def test_decoding_differences_equals_differencing_the_decoded():
    gammas, tails = discount_grid(15), numbers((2, 15, 9))
    apart = decode(-np.diff(tails, axis=-1), gammas, 30, 0.1)
    np.testing.assert_allclose(apart, -np.diff(decode(tails, gammas, 30, 0.1), axis=-1), atol=1e-12)


def test_leading_axes_are_a_batch():
    gammas, values = discount_grid(8), numbers((2, 3, 8, 5))
    together = decode(values, gammas, 6, 0.1)
    assert together.shape == (2, 3, 6, 5)
    for i, j in np.ndindex(2, 3):
        np.testing.assert_allclose(together[i, j], decode(values[i, j], gammas, 6, 0.1), atol=1e-12)


@pytest.mark.parametrize("shape", [(8,), (5, 8), (2, 7, 8)])
def test_the_discount_axis_must_match(shape):
    with pytest.raises(InputError, match="8 discounts"):
        decode(np.zeros(shape), discount_grid(8), 3, 0.1)


def test_filter_factors():
    # 3 / (3^2 + 4^2) = 3/25 and 1 / (1 + 16) = 1/17; what is below 10 eps of the largest is rounding.
    np.testing.assert_allclose(filter_factors([3.0, 1.0, 3e-16], 4.0, 10), [3 / 25, 1 / 17, 0.0])
    np.testing.assert_allclose(filter_factors([2.0, 1e-16], 0.0, 10), [0.5, 0.0])
    for alpha in (-1.0, math.nan, math.inf):
        with pytest.raises(InputError, match="alpha"):
            filter_factors([1.0], alpha, 1)


# --- resolution ---


@given(discounts, steps, alphas, time_steps)
def test_resolution_matrix_is_decoding_after_encoding(gammas, steps, alpha, time_step):
    F = transform_matrix(gammas, steps, time_step)
    R = resolution_matrix(gammas, steps, alpha, time_step)
    np.testing.assert_allclose(R, decode(F, gammas, steps, alpha, time_step), atol=1e-12)
    # R = V diag(s^2 / (s^2 + alpha^2)) V^T: symmetric, and its trace counts the steps that can be told apart.
    s = np.linalg.svd(F, compute_uv=False)
    np.testing.assert_allclose(R, R.T, atol=1e-12)
    assert np.trace(R) == pytest.approx((s**2 / (s**2 + alpha**2)).sum())


@pytest.mark.parametrize(("relative", "usable"), [(1e-1, 3), (1e-2, 6), (1e-3, 9), (1e-4, 12)])
def test_each_digit_of_precision_buys_three_singular_values(relative, usable):
    # Fifteen discounts with log-spaced time constants and 200 steps: an ill-posed transform, whoever inverts it.
    s = transform_factors(discount_grid(15, "log"), 200).s
    assert (s > relative * s[0]).sum() == usable


def test_folding_pulls_later_rewards_into_the_window():
    # A unit reward at tau = 60, through 100 discounts at alpha .2. Decoded with 50 rows it has nowhere else
    # to go: .92 of it appears before the 50th step. Decoded with 200 rows and cut at 50: .26.
    gammas = discount_grid(100)
    z = (gammas**60)[:, None]
    assert decode(z, gammas, 50, 0.2).sum() == pytest.approx(0.92, abs=0.005)
    assert decode(z, gammas, 200, 0.2)[:50].sum() == pytest.approx(0.26, abs=0.005)


# --- rows ---


def test_rescaling_by_the_paper_turns_a_residue_into_a_certain_reward():
    # .03 of probability spread .02 / .01 becomes 2/3 / 1/3, a negative ripple is clipped, nothing stays nothing.
    rows = np.array([[0.02, 0.01], [0.5, -0.1], [0.0, 0.0]])
    np.testing.assert_allclose(normalise_rows(rows, rows.sum(axis=1), "paper"), [[2 / 3, 1 / 3], [1, 0], [0, 0]])


def test_rescaling_by_survival_leaves_out_what_is_over():
    rows = np.array([[0.3, 0.1], [0.02, 0.01]])
    found = normalise_rows(rows, np.array([0.5, SURVIVAL_FLOOR / 2]), "survival")
    np.testing.assert_allclose(found, [[0.6, 0.2], [0.0, 0.0]])


def test_normalising_equals_a_loop_over_the_rows(subtests):
    for time_step in [1.0, 0.25, 0.3]:
        for how in NORMALISATIONS:
            with subtests.test(time_step=time_step, how=how):
                rows, survival = numbers((2, 6, 4)) * time_step, np.abs(numbers((2, 6), 1)) * time_step
                expected = np.zeros_like(rows)
                for a, k in np.ndindex(2, 6):
                    row, alive = rows[a, k], survival[a, k] / time_step
                    if how == "none":
                        expected[a, k] = row
                    elif how == "survival" and alive > SURVIVAL_FLOOR:
                        expected[a, k] = row / alive
                    elif how == "paper" and row.max() > 0:
                        expected[a, k] = time_step * np.maximum(row, 0) / np.maximum(row, 0).sum()
                before = rows.copy()
                np.testing.assert_allclose(normalise_rows(rows, survival, how, time_step), expected, atol=1e-15)
                np.testing.assert_array_equal(rows, before)


def test_unknown_normalisations_are_refused():
    with pytest.raises(InputError, match="normalise"):
        normalise_rows(np.zeros((1, 1)), np.zeros(1), "rows")
