"""Reading values for a horizon, by summing a tau-space or by weighing a gamma-space, and choosing by them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError
from laplace_core.code.encoding import bin_masses, discount_grid, sensitivity_grid, theta_midpoints
from laplace_core.code.ties import greedy_action
from laplace_core.inverse import decode, transform_matrix
from laplace_core.study.horizon import (
    choose_actions,
    deadline_weights,
    discount_kernel,
    expected_rewards,
    horizon_values,
    readout_weights,
    regret,
    row_horizons,
    target_discounts,
)
from tests.support.random_worlds import discounts

SOFTNESS = [0.0, 0.2, 1.0]
TIME_STEPS = [1.0, 0.5, 0.25, 0.3]


def numbers(shape, seed=0) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=shape)


# --- deadlines ---


def test_hard_deadline_counts_the_steps_before_it():
    np.testing.assert_array_equal(deadline_weights(3, 5), [1, 1, 1, 0, 0])
    # Step n stands for n - 1/2 to n + 1/2, so a horizon of two steps ends at 1.5, right on row 6 of 1/4.
    np.testing.assert_array_equal(deadline_weights(2, 9, time_step=0.25), [1, 1, 1, 1, 1, 1, 0.5, 0, 0])
    # Row 90 of .7 lies right on 63, although 90 * .7 rounds to just below it.
    assert deadline_weights(63.5, 100, time_step=0.7).sum() == 90.5


def test_columns_lie_between_the_rows_that_count_and_those_that_do_not():
    np.testing.assert_array_equal(row_horizons(4), [1, 2, 3, 4])
    # Rows at 0, 1/3, 2/3, ...: after two of them, at 1/2, the first step is over.
    np.testing.assert_allclose(row_horizons(5, 1 / 3), [2 / 3, 1, 4 / 3, 5 / 3, 2])
    for time_step in (1.0, 0.5, 0.3):
        for k, horizon in enumerate(row_horizons(7, time_step)):
            np.testing.assert_array_equal(deadline_weights(horizon, 7, time_step=time_step), np.arange(7) <= k)


def test_soft_deadline_is_a_sigmoid_as_wide_as_a_fraction_of_the_horizon():
    # T = 5, width .2 * 5 = 1: sigmoid(4.5 - tau), so sigmoid(.5) = .6225 and sigmoid(-.5) = .3775 around T.
    weights = deadline_weights(5, 8, 0.2)
    np.testing.assert_allclose(weights, [1 / (1 + math.exp(-(4.5 - tau))) for tau in range(8)])
    np.testing.assert_allclose(weights[4:6], [0.6225, 0.3775], atol=1e-4)


@given(st.integers(1, 30))
def test_a_deadline_hardens_as_its_width_vanishes(horizon):
    np.testing.assert_allclose(deadline_weights(horizon, 35, 1e-6), deadline_weights(horizon, 35), atol=1e-12)


def test_a_deadline_hardens_in_finer_time_too():
    np.testing.assert_allclose(deadline_weights(2, 12, 1e-6, 0.25), deadline_weights(2, 12, 0.0, 0.25), atol=1e-12)


@pytest.mark.parametrize(("horizon", "softness"), [(0, 0.1), (math.inf, 0.1), (5, -0.1), (5, math.nan)])
def test_impossible_deadlines_are_refused(horizon, softness):
    with pytest.raises(InputError, match=r"horizon|softness"):
        deadline_weights(horizon, 3, softness)


# --- values from expected rewards ---


def test_expected_reward_weighs_the_midpoints():
    np.testing.assert_allclose(expected_rewards(np.array([[0.5, 0.25], [0.0, 0.1]]), np.array([2.0, 4.0])), [2.0, 0.4])


def test_value_of_a_timeline_by_hand():
    # 5, 0, 10 at gamma .9: 5, then 5, then 5 + .81 * 10.
    np.testing.assert_allclose(horizon_values(np.array([5.0, 0.0, 10.0]), 0.9), [5.0, 5.0, 13.1])


def test_values_of_all_horizons_equal_a_loop(subtests):
    for time_step in TIME_STEPS:
        for softness in SOFTNESS:
            with subtests.test(time_step=time_step, softness=softness):
                rewards, gamma = numbers((2, 9)), 0.9
                values = horizon_values(rewards, gamma, softness, time_step)
                for a, column in np.ndindex(2, 9):
                    horizon, total = column * time_step + (1 + time_step) / 2, 0.0
                    for row in range(9):
                        tau = row * time_step
                        if softness:
                            weight = 1 / (1 + math.exp(-(horizon - 0.5 - tau) / (softness * horizon)))
                        else:
                            weight = float(row <= column)
                        total += weight * gamma**tau * rewards[a, row]
                    assert values[a, column] == pytest.approx(total, abs=1e-12)
                    weights = target_discounts(horizon, 9, gamma, softness, time_step)
                    assert values[a, column] == pytest.approx(weights @ rewards[a], abs=1e-12)


# --- readout weights ---


@given(
    gammas=discounts,
    steps=st.integers(1, 20),
    alpha=st.floats(0.01, 2.0),
    softness=st.sampled_from(SOFTNESS),
    time_step=st.sampled_from(TIME_STEPS),
)
def test_readout_equals_decoding_and_summing(gammas, steps, alpha, softness, time_step):
    # Same steps, same alpha, no clipping, no rescaling, and the midpoint proxy as Q_g: the two are one.
    thetas = sensitivity_grid(12, -3.0, 4.0)
    midpoints = theta_midpoints(thetas)
    timeline = np.abs(numbers((2, steps, 3)))
    rewards = np.array([-1.0, 0.5, 2.0])
    differences = transform_matrix(gammas, steps, time_step) @ timeline @ bin_masses(rewards, thetas, 4.0)
    tau_space = decode(differences, gammas, steps, alpha, time_step)
    summed = horizon_values(expected_rewards(tau_space, midpoints), 0.95, softness, time_step)
    targets = [target_discounts(T, steps, 0.95, softness, time_step) for T in row_horizons(steps, time_step)]
    weights = readout_weights(gammas, np.array(targets), alpha, time_step)
    np.testing.assert_allclose((differences @ midpoints) @ weights.T, summed, rtol=0, atol=1e-9)


@given(discounts, st.integers(1, 20), st.floats(0.01, 2.0), st.sampled_from(TIME_STEPS))
def test_readout_weights_solve_their_equation(gammas, steps, alpha, time_step):
    F, target = transform_matrix(gammas, steps, time_step), numbers(steps)
    w = np.linalg.solve(F @ F.T + alpha**2 * np.eye(len(gammas)), F @ target)
    np.testing.assert_allclose(readout_weights(gammas, target, alpha, time_step), w, rtol=0, atol=1e-8)


def test_kernel_is_what_a_readout_really_weighs():
    # A unit reward at step tau alone has Q_g = gamma_g^tau: its readout is the kernel at tau.
    gammas, w = discount_grid(6), numbers(6)
    kernel = discount_kernel(gammas, w, 10)
    np.testing.assert_allclose(kernel, [w @ gammas**tau for tau in range(10)])


@pytest.mark.parametrize(
    ("gammas", "missed", "gain"),
    [(discount_grid(15, "paper"), 0.50, 35), (np.exp(-1 / np.geomspace(1, 100, 15)), 0.19, 24)],
)
def test_the_grid_limits_which_deadlines_can_be_read(gammas, missed, gain):
    # .99^tau until tau = 100, by readout at alpha .01 over 1000 steps: relative L1 error of the kernel and
    # noise gain |w|, for the paper's discounts and for time constants log-spaced from 1 to 100.
    target = target_discounts(100, 1000, 0.99)
    weights = readout_weights(gammas, target, 0.01)
    off = np.abs(discount_kernel(gammas, weights, 1000) - target).sum() / target.sum()
    assert off == pytest.approx(missed, abs=0.005)
    assert np.linalg.norm(weights) == pytest.approx(gain, abs=0.5)


def test_a_soft_deadline_costs_less_noise_than_a_hard_one():
    gammas = np.exp(-1 / np.geomspace(1, 100, 15))
    gains = [
        np.linalg.norm(readout_weights(gammas, target_discounts(100, 1000, 0.99, softness), 0.01))
        for softness in (0.0, 0.2, 0.5)
    ]
    assert gains[0] > 2 * gains[1] > 4 * gains[2]


# --- choosing ---


def test_ties_go_to_the_lowest_action_within_one_billionth():
    values = np.array([[1.0, 1.0 + 0.9e-9, 0.0], [1.0, 1.0 + 1.1e-9, 0.0], [0.0, 1.0, 1.0 - 0.9e-9]])
    np.testing.assert_array_equal(greedy_action(values), [0, 1, 1])
    np.testing.assert_array_equal(choose_actions(values.T), [0, 1, 1])


def test_large_values_tie_in_proportion():
    # At 1e6 rounding alone is 1e-10 a step and adds up: the tolerance grows with the values, to 1e-3.
    assert greedy_action(np.array([1e6, 1e6 + 0.5e-3])) == 0
    assert greedy_action(np.array([1e6, 1e6 + 2e-3])) == 1


def test_a_terrible_action_does_not_blur_the_others():
    assert greedy_action(np.array([-1e10, 5.0, 10.0])) == 2


def test_regret_is_what_the_chosen_action_lacks():
    optimum = np.array([[5.0, 5.0, 5.0], [0.0, 7.0, 5.0]])
    np.testing.assert_array_equal(regret(optimum, np.array([1, 0, 1])), [5.0, 2.0, 0.0])
    np.testing.assert_array_equal(regret(optimum, choose_actions(optimum)), 0.0)
