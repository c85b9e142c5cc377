"""Bands of decoded expected rewards."""

from dataclasses import replace

import numpy as np
import pytest

from laplace_core.code.gamma_space import with_noise
from laplace_core.inverse import decode, decode_matrix
from laplace_core.inverse.bands import (
    LAYERS,
    bands,
    bands_by_draws,
    layer_noise,
    layers_of,
    tikhonov_of_layers,
)
from laplace_core.inverse.channels import channel_weights
from laplace_core.inverse.feasible import feasible
from laplace_core.inverse.nonnegative import nonnegative
from tests.support.random_gamma_spaces import noisy_space

NOISE, ROWS, ALPHA = 1e-2, 15, 0.3


def test_the_noise_band_is_the_spread_of_decoded_noise():
    # 400 draws: their standard deviation is known within 3.5%, the largest of 30 rows within 12%.
    exact, noisy, deviations = noisy_space(NOISE)
    found = bands(noisy, ROWS, ALPHA, deviations)
    spaces = [with_noise(exact, NOISE, seed) for seed in range(400)]
    decoded = [decode(each.differences, each.gammas, ROWS, ALPHA) @ each.bin_values for each in spaces]
    np.testing.assert_allclose(found.noise, np.std(decoded, axis=0), rtol=0.15)


@pytest.mark.parametrize("open_ends", [False, True])
def test_noise_that_neighbouring_sensitivities_share_is_the_spread_of_such_noise(open_ends):
    # 400 draws, each with one error for each layer of sensitivities and one for the constant channel.
    _, noisy, deviations = noisy_space(NOISE)
    space = replace(noisy, open_ends=open_ends)
    found = bands(space, ROWS, ALPHA, deviations, independent=False)
    weights, _ = channel_weights(space.thetas, LAYERS)
    errors = deviations[:, None] * np.random.default_rng(0).normal(size=(400, space.gammas.size, LAYERS + 1))
    values = space.values[:1] + errors[..., 1:] @ (weights > 0.0)
    drawn = replace(space, values=values, constant=space.constant[:1] + errors[..., 0])
    decoded = decode(drawn.differences, space.gammas, ROWS, ALPHA) @ space.bin_values
    np.testing.assert_allclose(found.noise[0], decoded.std(axis=0), rtol=0.15)
    assert found.noise.max() > 0.1 * NOISE


def test_shared_noise_is_the_same_to_an_exact_band_and_to_one_of_draws():
    _, noisy, deviations = noisy_space(NOISE)
    space = replace(noisy, open_ends=True)
    exact = bands(space, ROWS, ALPHA, deviations, independent=False).noise
    layers = layers_of(space, ROWS, deviations, independent=False)
    np.testing.assert_allclose(exact[0], layer_noise(layers, ALPHA))
    drawn = bands_by_draws(tikhonov_of_layers, layers, ALPHA, draws=300).noise
    np.testing.assert_allclose(drawn, exact, rtol=0.2)


def test_bias_is_what_the_inverse_does_to_the_timeline_that_fits():
    # Values of the fitted timeline, without noise, decoded and compared with it.
    _, noisy, deviations = noisy_space(NOISE)
    found = bands(noisy, ROWS, 3.0, deviations)
    layers = layers_of(noisy, ROWS, deviations)
    fitted = feasible(layers.problem, 0.0)
    clean = (layers.problem.masses - fitted.residual) @ layers.sizes
    decoded = decode(clean[..., None], noisy.gammas, ROWS, 3.0)[..., 0]
    np.testing.assert_allclose(found.bias, decoded - fitted.masses @ layers.sizes, atol=1e-9)
    assert np.abs(found.bias).max() > 0.05  # an alpha of 3 smears all of it
    own = bands(noisy, ROWS, ALPHA, deviations, matrix=decode_matrix(noisy.gammas, ROWS, 3.0))
    np.testing.assert_allclose(own.bias, found.bias)


def test_bands_of_draws_agree_with_those_of_a_linear_inverse():
    _, noisy, deviations = noisy_space(NOISE)
    layers = layers_of(noisy, ROWS, deviations)
    found = bands_by_draws(tikhonov_of_layers, layers, ALPHA, draws=300)
    np.testing.assert_allclose(found.noise[0], layer_noise(layers, ALPHA), rtol=0.2)
    tighter = bands_by_draws(nonnegative, layers, ALPHA, draws=20)
    assert tighter.noise.mean() < found.noise.mean()  # what cannot be negative varies less


def test_layers_keep_the_expected_reward():
    # The trapezoid rule counts what lies between the outermost sensitivities; with open ends so do the bins, but for
    # half a spacing in the outermost two: equal where these are empty.
    exact, _, deviations = noisy_space(NOISE)
    layers = layers_of(exact, ROWS, deviations)
    means = layers.problem.masses @ layers.sizes
    thetas = exact.thetas
    trapezoid = ((exact.values[..., 1:] + exact.values[..., :-1]) / 2 * np.diff(thetas)).sum(axis=-1)
    np.testing.assert_allclose(means, thetas[0] * exact.constant + trapezoid, atol=1e-12)


# --- bumps ---
