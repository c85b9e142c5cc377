"""The test of consistency: alarms where something is wrong, none where nothing is, and noise that is estimated."""

from dataclasses import replace

import numpy as np
import pytest

from laplace_core import InputError
from laplace_core.inverse.channels import channel_gains, channel_weights, channels_of
from laplace_core.inverse.consistency import check_noise, check_seeds, shrunk_covariance
from tests.support.random_gamma_spaces import noisy_space

NOISE = 1e-3


def seeds(count: int, seed: int = 0):
    exact, _, deviations = noisy_space(NOISE, seed)
    rng = np.random.default_rng(seed)
    values = exact.values + deviations[:, None] * rng.normal(size=(count, *exact.values.shape))
    return values, exact.constant + deviations * rng.normal(size=(count, *exact.constant.shape)), exact


def test_a_consistent_space_raises_no_alarm():
    _, noisy, deviations = noisy_space(NOISE, 2)
    found = check_noise(noisy, deviations, draws=39)
    assert found.consistent
    assert found.blamed().size == 0
    assert 0.3 < found.misfit / found.usual < 3.0


@pytest.mark.parametrize("noise", [1e-3, 1e-4, pytest.param(1e-5, marks=pytest.mark.long)])
def test_the_best_fit_is_no_worse_than_the_truth_however_small_the_noise(noise):
    """The true timeline is feasible, so its misfit, the sum of squares of the whitened noise, bounds the smallest.

    A solver that gives up early stands far above it, in the data or in some of the draws, and raises false alarms.
    """
    for seed in range(6):
        exact, noisy, deviations = noisy_space(noise, seed)
        weights = channel_weights(exact.thetas, 2)[0]
        channels = channels_of(noisy.values - exact.values, noisy.constant - exact.constant, weights)
        errors = np.append(channels[:, :-1] - channels[:, 1:], channels[:, -1:], axis=1)
        variances = (channel_gains(weights, independent=True)[:, None] * deviations) ** 2
        of_truth = (errors**2 / np.append(variances[:-1] + variances[1:], variances[-1:], axis=0)).sum()
        found = check_noise(noisy, deviations, draws=19)
        assert found.misfit < of_truth
        assert found.usual < of_truth + 4 * np.sqrt(2 * errors.size)  # drawn misfits are below as many squares


def test_values_times_a_fifth_more_do():
    _, noisy, deviations = noisy_space(NOISE, 2)
    found = check_noise(replace(noisy, values=1.2 * noisy.values, constant=1.2 * noisy.constant), deviations, draws=39)
    assert found.p_value == pytest.approx(1 / 40)  # the smallest that 39 draws can give
    assert found.misfit > 10 * found.usual


def test_one_wrong_discount_is_blamed():
    _, noisy, deviations = noisy_space(NOISE, 2)
    factor = np.ones(12)
    factor[7] = 1.1
    wrong = replace(noisy, values=noisy.values * factor[:, None], constant=noisy.constant * factor)
    found = check_noise(wrong, deviations, draws=39)
    assert not found.consistent
    assert found.blamed()[0] == noisy.gammas[7]


def test_the_noise_of_seeds_is_estimated():
    values, constant, exact = seeds(8)
    found = check_seeds(values, constant, exact, draws=39)
    assert found.consistent
    np.testing.assert_allclose(found.deviations, np.std(constant, axis=0, ddof=1) / np.sqrt(8))
    wrong = check_seeds(1.2 * values, 1.2 * constant, exact, draws=39)
    assert not wrong.consistent


def test_the_same_seed_gives_the_same_draws():
    _, noisy, deviations = noisy_space(NOISE, 2)
    one, two = (check_noise(noisy, deviations, draws=19, seed=5) for _ in range(2))
    assert (one.p_value, one.usual) == (two.p_value, two.usual)


def test_a_shrunk_covariance_has_full_rank_and_keeps_variances():
    samples = np.random.default_rng(0).normal(size=(5, 12)) * np.arange(1, 13)
    found = shrunk_covariance(samples)
    np.testing.assert_allclose(np.diag(found), samples.var(axis=0, ddof=1))
    assert np.linalg.eigvalsh(found).min() > 0
    # Independent columns: what correlation five samples show is chance, and more than half of it is taken away.
    plain = np.corrcoef(samples.T)
    shrunk = found / np.sqrt(np.outer(np.diag(found), np.diag(found)))
    off = ~np.eye(12, dtype=bool)
    assert np.abs(shrunk[off]).mean() < 0.5 * np.abs(plain[off]).mean()


def test_many_samples_are_hardly_shrunk():
    truth = np.array([[1.0, 0.9], [0.9, 1.0]])
    samples = np.random.default_rng(0).multivariate_normal([0, 0], truth, size=4_000)
    np.testing.assert_allclose(shrunk_covariance(samples), truth, atol=0.08)


def test_too_little_to_test_with_is_refused():
    values, constant, exact = seeds(2)
    with pytest.raises(InputError, match="seeds"):
        check_seeds(values, constant, exact)
    for deviations in (np.ones(3), np.zeros(12), np.full(12, np.nan)):
        with pytest.raises(InputError, match="deviations"):
            check_noise(exact, deviations)


def test_seeds_may_agree_on_some_values_but_not_on_all():
    values, constant, exact = seeds(4)
    values, constant = values[:, :1], constant[:, :1]  # one action tells
    exact = replace(exact, values=exact.values[:1], constant=exact.constant[:1])
    values[:, :, :2], constant[:, :, :2] = exact.values[:, :2], exact.constant[:, :2]
    assert check_seeds(values, constant, exact, draws=19).p_value > 0
    with pytest.raises(InputError, match="show no noise"):
        check_seeds(np.repeat(values[:1], 4, axis=0), np.repeat(constant[:1], 4, axis=0), exact)


# --- channels ---


def test_channels_are_means_over_neighbouring_sensitivities():
    # Thetas 0, 1, 2, 4: the trapezoid rule gives them widths .5, 1, 1.5, 1, together 4 = theta_H - theta_1.
    weights, widths = channel_weights(np.array([0.0, 1.0, 2.0, 4.0]), 2)
    np.testing.assert_allclose(widths, [1.5, 2.5])
    np.testing.assert_allclose(weights, [[1 / 3, 2 / 3, 0, 0], [0, 0, 0.6, 0.4]])
    values, constant = np.array([[3.0, 2.0, 1.0, 0.0]]), np.array([4.0])
    np.testing.assert_allclose(channels_of(values, constant, weights), [[4.0], [7 / 3], [0.6]])


def test_independent_errors_average_out_and_common_ones_do_not():
    weights = channel_weights(np.linspace(0.0, 1.0, 9), 1)[0]  # widths 1/16, 7 times 1/8, 1/16
    np.testing.assert_allclose(channel_gains(weights, independent=True), [1.0, np.sqrt(7 / 64 + 2 / 256)])
    np.testing.assert_allclose(channel_gains(weights, independent=False), [1.0, 1.0])
