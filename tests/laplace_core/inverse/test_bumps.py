"""Bumps in decoded expected rewards, and the probability that each is real."""

import numpy as np
import pytest

from laplace_core.experiments.inverse.bumps import fitted_calibration
from laplace_core.inverse.bumps import FEATURES, Calibration, bumps, calibration, contrast, features, find_bumps, is_in
from tests.support.random_gamma_spaces import noisy_space

ROWS = 15


def test_bumps_are_found_with_their_sign_and_rows():
    rewards = np.array([4.0, 0.5, 0.0, 0.0, -1.0, -2.0, -1.0, 0.0, 0.0, 0.1, 0.0])
    found = find_bumps(rewards)
    assert [(bump.start, bump.peak, bump.stop, bump.sign) for bump in found] == [(0, 0, 1, 1), (4, 5, 7, -1)]
    assert found[0].contrast == pytest.approx(3.5)  # the row after it holds .5
    assert found[1].contrast == pytest.approx(4 / 3 + 0.1 / 3)  # the side after it pays .1 / 3, that before it more
    assert find_bumps(np.zeros(5)) == []


def test_a_step_is_no_bump():
    rewards = np.array([0.0, 0.0, 1.0, 1.0, 1.0, 1.0])
    assert contrast(rewards, 2, 4, 1) == 0.0


def test_a_bump_is_in_a_timeline_that_shows_half_of_it():
    (bump,) = find_bumps(np.array([0.0, 0.0, 2.0, 0.0, 0.0]))
    half, less, later = np.array([[0, 0, 1.0, 0, 0], [0, 0, 0.9, 0, 0], [0, 0, 0, 0, 2.0]])
    assert [bool(is_in(bump, each)) for each in (half, less, later)] == [True, False, False]


def test_a_bump_that_survives_is_more_probable():
    found = find_bumps(np.array([0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.9, 0.0]))
    shares = np.array([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]])
    never, always = calibration().probability(features(found, shares, np.full(8, 0.1), 2.0))
    assert 0.0 < never < 0.5 < always < 1.0


def test_features_of_a_bump_are_those_that_their_names_say():
    # Contrast 2 over a deviation of .5 is 4; over the largest reward, 4, it is .5; the peak is row 2, 1 row wide.
    found = find_bumps(np.array([0.0, 0.0, 2.0, 0.0, 0.0]))
    (numbers,) = features(found, np.array([[0.5, 0.25, 0.125]]), np.full(5, 0.5), 4.0)
    ratio, height = np.log(4.0), np.log(0.5 + 1e-3)
    expected = [1, 0.5, 0.25, 0.125, 0.25**2, 0.125**2, ratio, ratio**2, height, height**2, np.log(3.0), 0.0]
    np.testing.assert_allclose(numbers, expected)
    assert len(FEATURES) == len(expected)


def test_a_fitted_calibration_says_how_often_bumps_are_real():
    # The log odds are a crooked function of one feature; the others are noise. 40,000 bumps: shares within 1.5%.
    rng = np.random.default_rng(0)
    numbers = np.concatenate([np.ones((40_000, 1)), rng.normal(size=(40_000, len(FEATURES) - 1))], axis=1)
    odds = np.where(numbers[:, 1] > 0.0, 3.0 * numbers[:, 1], numbers[:, 1])
    real = rng.random(40_000) < 1.0 / (1.0 + np.exp(-odds))
    fitted = fitted_calibration(numbers[:20_000], real[:20_000])
    predicted, seen = fitted.probability(numbers[20_000:]), real[20_000:]
    for low in np.arange(0.1, 0.9, 0.2):
        inside = (predicted >= low) & (predicted < low + 0.2)
        assert abs(predicted[inside].mean() - seen[inside].mean()) < 0.03
    one_line = Calibration(fitted.weights, np.array([-50.0, 50.0]), np.array([-50.0, 50.0])).probability(
        numbers[20_000:]
    )
    assert _loss(predicted, seen) < _loss(one_line, seen)  # the knots are worth something


def _loss(predicted, real):
    return -np.mean(np.log(np.where(real, predicted, 1.0 - predicted)))


def test_every_bump_gets_a_probability():
    _, noisy, deviations = noisy_space(1e-3)
    found = bumps(noisy, ROWS, 0.1, deviations)
    assert len(found) == 2
    assert all(0.0 < bump.probability < 1.0 for action in found for bump in action)
