"""Discount grids, sensitivity grids and the activation of a reward."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError
from laplace_core.code.encoding import (
    GAMMA_SPACINGS,
    activation,
    bin_masses,
    discount_grid,
    sensitivity_grid,
    softening,
    theta_midpoints,
)

# --- discounts ---


def test_paper_grid_is_five_equal_steps_in_each_of_three_ranges():
    # Section 3.3 of the paper: .01 to .5, .5 to .75, .75 to .99. Equal steps are (.5 - .01) / 5 = .098, .05,
    # and, with the end .99 included, (.99 - .75) / 4 = .06.
    expected = [0.01, 0.108, 0.206, 0.304, 0.402, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.81, 0.87, 0.93, 0.99]
    np.testing.assert_allclose(discount_grid(15, "paper"), expected, atol=1e-15)


def test_paper_grid_ignores_count_and_bounds():
    np.testing.assert_array_equal(discount_grid(3, "paper", 0.2, 0.3), discount_grid(15, "paper"))


def test_inverse_log_grid_is_uniform_in_one_over_log_gamma():
    # With three discounts the middle one has 1/log gamma = (1/log .01 + 1/log .99) / 2
    # = (-.2171 - 99.4992) / 2 = -49.8581, hence gamma = exp(-1/49.8581) = .980143.
    np.testing.assert_allclose(discount_grid(3, "inverse-log"), [0.01, 0.980143, 0.99], atol=1e-6)
    steps = np.diff(1 / np.log(discount_grid(12, "inverse-log", 0.1, 0.9)))
    np.testing.assert_allclose(steps, steps[0])


def test_log_grid_has_time_constants_in_equal_ratios():
    # Time constants 1, 10, 100 are gamma = exp(-1), exp(-1/10), exp(-1/100).
    low, high = math.exp(-1), math.exp(-1 / 100)
    np.testing.assert_allclose(discount_grid(3, "log", low, high), [low, math.exp(-0.1), high])


def test_linear_grid_has_equal_steps():
    np.testing.assert_allclose(discount_grid(3, "linear", 0.1, 0.9), [0.1, 0.5, 0.9])


@given(
    count=st.integers(2, 60),
    spacing=st.sampled_from([s for s in GAMMA_SPACINGS if s != "paper"]),
    low=st.floats(1e-4, 0.5),
    high=st.floats(0.51, 0.9999),
)
def test_grids_rise_from_bound_to_bound(count, spacing, low, high):
    grid = discount_grid(count, spacing, low, high)
    assert grid.shape == (count,)
    assert (grid[0], grid[-1]) == (low, high)
    assert np.all(np.diff(grid) > 0)


def test_impossible_discount_grids_are_refused(subtests):
    for arguments, named in [
        ((15, "geometric"), "spacing"),
        ((1, "log"), "at least 2"),
        ((15, "log", 0.0, 0.9), "gamma-min"),
        ((15, "log", 0.1, 1.0), "gamma-max"),
        ((15, "log", 0.9, 0.1), "gamma-min"),
        ((15, "log", math.nan, 0.9), "gamma-min"),
        ((15, "linear", 0.5, math.nextafter(0.5, 1)), "do not fit"),
    ]:
        with subtests.test(arguments=arguments, named=named), pytest.raises(InputError, match=named):
            discount_grid(*arguments)


# --- sensitivities ---


def test_uniform_sensitivities_and_their_midpoints():
    thetas = sensitivity_grid(5, -1.0, 3.0)
    np.testing.assert_allclose(thetas, [-1, 0, 1, 2, 3])
    np.testing.assert_allclose(theta_midpoints(thetas), [-0.5, 0.5, 1.5, 2.5])


def test_gaussian_sensitivities_have_equal_chances_between_them():
    # A normal law at the middle of [-2, 6] with a standard deviation of a quarter of the range, 2.
    def law(x):
        return 0.5 * (1 + math.erf((x - 2.0) / (2.0 * math.sqrt(2))))

    thetas = sensitivity_grid(9, -2.0, 6.0, "gaussian")
    chances = np.diff([law(theta) for theta in thetas])
    np.testing.assert_allclose(chances, chances[0])
    assert (thetas[0], thetas[-1]) == (-2.0, 6.0)
    narrow = sensitivity_grid(9, -2.0, 6.0, "gaussian", scale=1.0)
    assert np.ptp(narrow[1:-1]) < np.ptp(thetas[1:-1])


def test_asinh_sensitivities_are_dense_near_zero():
    # Uniform in asinh(theta / scale); the default scale is a hundredth of the largest bound, here 1.
    thetas = sensitivity_grid(11, -100.0, 100.0, "asinh")
    steps = np.diff([math.asinh(theta) for theta in thetas])
    np.testing.assert_allclose(steps, steps[0])
    assert thetas[6] - thetas[5] < 5 < thetas[10] - thetas[9]


def test_impossible_sensitivities_are_refused(subtests):
    for arguments, named in [
        ((5, 0.0, 1.0, "random"), "theta spacing"),
        ((1, 0.0, 1.0), "at least 2"),
        ((5, 1.0, 1.0), "theta-min"),
        ((5, 0.0, math.inf), "theta-max"),
        ((5, 0.0, 1.0, "asinh", 0.0), "scale"),
        ((50, 1e6, 2e6, "gaussian", 1e-12), "do not fit"),
    ]:
        with subtests.test(arguments=arguments, named=named), pytest.raises(InputError, match=named):
            sensitivity_grid(*arguments)


# --- the activation ---


@given(
    reward=st.floats(-50, 50),
    thetas=st.lists(st.floats(-50, 50), min_size=1, max_size=6),
    slope=st.floats(0.01, 10),
)
def test_activation_is_the_logistic_function(reward, thetas, slope):
    expected = [1 / (1 + math.exp(-slope * (reward - theta))) for theta in thetas]
    np.testing.assert_allclose(activation(reward, thetas, slope), expected, rtol=1e-9)


def test_activation_keeps_the_shape_of_the_rewards():
    assert activation(np.zeros((2, 3)), np.zeros(4), 1.0).shape == (2, 3, 4)


def test_infinite_slope_is_the_step_with_one_half_at_the_threshold():
    np.testing.assert_array_equal(activation(1.0, [0.0, 1.0, 2.0], np.inf), [1.0, 0.5, 0.0])


def test_steep_activation_neither_overflows_nor_warns():
    with np.errstate(all="raise", under="ignore"):
        np.testing.assert_array_equal(activation([-1e9, 1e9], [0.0], 1e9), [[0.0], [1.0]])


@pytest.mark.parametrize("slope", [0.0, -1.0, math.nan])
def test_slope_must_be_positive(slope):
    with pytest.raises(InputError, match="slope"):
        activation(0.0, [0.0, 1.0], slope)


@given(
    reward=st.floats(-10, 10),
    thetas=st.lists(st.floats(-10, 10), min_size=2, max_size=8, unique=True).map(sorted),
    slope=st.floats(0.1, 100),
)
def test_bin_masses_are_nonnegative_and_telescope(reward, thetas, slope):
    # The sum of all f_h - f_{h+1} is f_1 - f_H: what lies between the first and the last threshold.
    masses = bin_masses(reward, thetas, slope)
    ends = activation(reward, thetas, slope)
    assert masses.shape == (len(thetas) - 1,)
    assert np.all(masses >= 0)
    np.testing.assert_allclose(masses.sum(), ends[0] - ends[-1], atol=1e-12)


def test_a_threshold_on_a_reward_loses_half_of_its_mass():
    # f_1(0) = 1/2 if theta_1 = 0: half of the reward lies below the first threshold. An overhang of
    # 10 / slope leaves 1 / (1 + e^-10), all but 5e-5.
    slope = 5.0
    on_edge = bin_masses(0.0, sensitivity_grid(101, 0.0, 20.0), slope).sum()
    overhanging = bin_masses(0.0, sensitivity_grid(101, -10 / slope, 20.0), slope).sum()
    assert on_edge == pytest.approx(0.5, abs=1e-12)
    assert overhanging == pytest.approx(1.0, abs=5e-5)


@pytest.mark.parametrize(
    ("overlap", "largest"), [(2, 0.0003), (3, 0.006), (4, 0.023), (6, 0.078), (12, 0.22), (24, 0.33)]
)
def test_midpoint_proxy_rounds_rewards_once_the_sigmoids_part(overlap, largest):
    # Summed by parts, the proxy is a constant plus spacing * sum_h f_h(r). By Poisson's formula a sum of
    # shifted sigmoids is a straight line plus harmonics; with x = slope * spacing and u = r / spacing,
    #     (proxy - r) / spacing = (2 pi / x) sum_n sin(2 pi n u) / sinh(2 pi^2 n / x)
    # where u counts from a threshold. Its largest value is the table of errors by x.
    spacing, x = 0.5, float(overlap)
    thetas = np.arange(-40, 41) * spacing
    u = np.linspace(-1.0, 1.0, 401)
    off = (bin_masses(u * spacing, thetas, x / spacing) @ theta_midpoints(thetas) - u * spacing) / spacing
    n = np.arange(1, 200)
    with np.errstate(over="ignore"):
        harmonics = np.sin(2 * np.pi * np.outer(u, n)) / np.sinh(2 * np.pi**2 * n / x)
    np.testing.assert_allclose(off, 2 * np.pi / x * harmonics.sum(axis=1), atol=1e-9)
    assert np.abs(off).max() == pytest.approx(largest, abs=0.6 * 10.0 ** math.floor(math.log10(largest)))


# --- a softer slope ---

PLACES = np.arange(61) * 2.5  # 2.5 = slope * spacing, as agents have


def test_the_kernel_of_softening_turns_one_sigmoid_into_the_other():
    # With share 1/2 the density is 1 / (2 pi cosh(x / 2)). Convolved with that of slope 1, sigmoid'(x), by sums over a
    # grid around 0, it is the density of slope 1/2.
    x = np.linspace(-60, 60, 2_401)
    kernel, slopes = 1 / (2 * np.pi * np.cosh(x / 2)), lambda s: s / (4 * np.cosh(s * x / 2) ** 2)
    found = 0.05 * np.convolve(kernel, slopes(1.0), "same")
    np.testing.assert_allclose(found[600:-600], slopes(0.5)[600:-600], atol=1e-9)
    # Of a difference at 0, gd(2.5 / 2) / pi then lies between 0 and 2.5, with gd(y) = 2 arctan(tanh(y / 2)).
    inside = 2 * np.arctan(np.tanh(1.25 / 2)) / np.pi
    assert softening(np.array([-2.5, 2.5, 5.0]), 0.5)[0, 0] == pytest.approx(2 * inside)


def test_at_the_trained_slope_softening_is_the_identity_and_near_it_almost():
    np.testing.assert_array_equal(softening(PLACES, 1.0), np.eye(60))
    near = [np.abs(softening(PLACES, share) - np.eye(60)).max() for share in (0.99, 0.999, 0.9999)]
    assert near[0] < 0.02
    assert near[0] > near[1] > near[2]


@pytest.mark.parametrize("share", [0.95, 0.8, 0.7, 0.5, 0.3, 0.1])
def test_softening_comes_near_the_softer_activation(share):
    """Against the exact one; a half is the most that could be missed."""
    rewards = np.linspace(60, 90, 301)
    exact = bin_masses(rewards, PLACES, share)
    found = bin_masses(rewards, PLACES, 1.0) @ softening(PLACES, share)
    tails = np.abs(np.cumsum((found - exact)[:, ::-1], axis=1)).max()
    assert tails <= 0.0085
    # What passes through the softer sigmoid a second time is far off: softening is no such product.
    twice = bin_masses(rewards, PLACES, 1.0) @ bin_masses(theta_midpoints(PLACES), PLACES, share)
    assert np.abs(np.cumsum((twice - exact)[:, ::-1], axis=1)).max() > 2 * tails


@given(share=st.floats(0.2, 1.0), at=st.integers(25, 34))
def test_softening_keeps_probability_and_its_mean_away_from_the_edges(share, at):
    row = softening(PLACES, share)[at]
    assert np.all(row >= 0)
    assert row.sum() == pytest.approx(1.0, abs=2e-3)
    assert row @ theta_midpoints(PLACES) == pytest.approx(theta_midpoints(PLACES)[at], abs=0.6)


@pytest.mark.parametrize("share", [0.0, -1.0, 1.01, math.nan])
def test_a_slope_is_only_softened(share):
    with pytest.raises(InputError, match="share"):
        softening(PLACES, share)
