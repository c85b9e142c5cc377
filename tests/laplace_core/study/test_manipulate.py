"""Timelines that are cut, re-discounted, shifted and distorted, and their way back to gamma-space."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError
from laplace_core.code.gamma_space import bin_differences
from laplace_core.inverse import decode, transform_matrix
from laplace_core.inverse.problem import problem_of
from laplace_core.study.manipulate import (
    cut,
    distorted,
    rediscounted,
    round_trip_losses,
    shifted,
    transformed,
    values_of,
)

THETAS = np.array([0.0, 2.0])  # bins: below 0, counted as 0; 0 to 2, counted as 1; above 2, counted as 2
GAMMAS = np.array([0.5, 0.8])
# One action: 1 for certain, then 0 or 2 evenly, then the end with a chance of 1/2, or 2.
TIMELINE = np.array([[[0.0, 1.0, 0.0], [0.5, 0.0, 0.5], [0.0, 0.0, 0.5]]])


def random_timelines(seed: int, shape: tuple[int, ...] = (3, 7, 5)) -> np.ndarray:
    """Rows that sum to a survival that never increases."""
    rng = np.random.default_rng(seed)
    survival = np.sort(rng.uniform(size=shape[:-1]), axis=-1)[..., ::-1]
    return survival[..., None] * rng.dirichlet(np.ones(shape[-1]), size=shape[:-1])


# --- cut, re-discount, shift ---


def test_a_cut_keeps_the_rows_before_the_deadline():
    np.testing.assert_array_equal(cut(TIMELINE, 2.0)[0], [[0, 1, 0], [0.5, 0, 0.5], [0, 0, 0]])
    # T = 1.5 falls on row 1 (T - 1/2), which counts half.
    np.testing.assert_array_equal(cut(TIMELINE, 1.5)[0], [[0, 1, 0], [0.25, 0, 0.25], [0, 0, 0]])
    # Rows half a step apart: T = 1 ends at time 1/2, right on row 1.
    np.testing.assert_array_equal(cut(TIMELINE, 1.0, time_step=0.5)[0], [[0, 1, 0], [0.25, 0, 0.25], [0, 0, 0]])


def test_a_further_discount_weighs_every_row():
    np.testing.assert_allclose(rediscounted(TIMELINE, 0.5)[0], [[0, 1, 0], [0.25, 0, 0.25], [0, 0, 0.125]])
    np.testing.assert_allclose(rediscounted(TIMELINE, 0.25, 0.5)[0], [[0, 1, 0], [0.25, 0, 0.25], [0, 0, 0.125]])


def test_a_shift_moves_rows_and_loses_what_leaves():
    np.testing.assert_array_equal(shifted(TIMELINE, 1)[0], [[0, 0, 0], [0, 1, 0], [0.5, 0, 0.5]])
    np.testing.assert_array_equal(shifted(TIMELINE, -2)[0], [[0, 0, 0.5], [0, 0, 0], [0, 0, 0]])
    np.testing.assert_array_equal(shifted(TIMELINE, 0.5, 0.5), shifted(TIMELINE, 1))
    for delay in (3, -3, 50):
        assert not shifted(TIMELINE, delay).any()
    np.testing.assert_array_equal(shifted(TIMELINE, 0), TIMELINE)


@given(st.integers(0, 1000), st.floats(0.1, 1.0), st.integers(0, 3))
def test_what_manipulations_do_to_the_transform(seed, gamma, delay):
    """Re-discounting multiplies every discount by gamma; a shift by n multiplies values by discount^n."""
    timelines = random_timelines(seed)
    F, at_product = transform_matrix(GAMMAS, 7), transform_matrix(GAMMAS * gamma, 7)
    np.testing.assert_allclose(F @ rediscounted(timelines, gamma), at_product @ timelines, atol=1e-12)
    early = cut(timelines, 4.0)  # four rows, so that a shift by 3 loses nothing
    np.testing.assert_allclose(F @ shifted(early, delay), (GAMMAS**delay)[:, None] * (F @ early), atol=1e-12)


# --- risk ---


def test_distortions_by_hand():
    values = np.array([0.0, 1.0, 2.0])
    # The worst half: row 0 is certain; row 1 pays 0 or 2 evenly, so 0; row 2 is over in its worst half: no mass.
    worst = distorted(TIMELINE, values, "cvar", 0.5)[0]
    np.testing.assert_allclose(worst, [[0, 1, 0], [1, 0, 0], [0, 0, 0]], atol=1e-15)
    # The worst 3/4 hold 1/2 of 0 and 1/4 of 2, so two thirds and one third.
    np.testing.assert_allclose(distorted(TIMELINE, values, "cvar", 0.75)[0, 1], [2 / 3, 0, 1 / 3])
    # Averse, eta = -1: F = 1/2 becomes 1 - 1/4; seeking, eta = 1: F = 1/2 becomes 1/4.
    np.testing.assert_allclose(distorted(TIMELINE, values, "power", -1.0)[0, 1], [0.75, 0, 0.25])
    np.testing.assert_allclose(distorted(TIMELINE, values, "power", 1.0)[0, 1:], [[0.25, 0, 0.75], [0, 0, 0.75]])


def test_the_end_of_an_episode_pays_nothing_which_is_better_than_a_loss():
    # Half the episodes lose 1, the others are over: the worst half loses 1 for certain.
    losing = np.array([[[0.5, 0.0]]])
    np.testing.assert_allclose(distorted(losing, np.array([-1.0, 1.0]), "cvar", 0.5), [[[1.0, 0.0]]])


def naive_cvar(row: np.ndarray, values: np.ndarray, level: float) -> float:
    """Mean of the worst share ``level``: outcomes in order, each taken as long as there is something left to take."""
    outcomes = sorted([(0.0, 1.0 - row.sum()), *zip(values, row, strict=True)])
    left, total = level, 0.0
    for value, mass in outcomes:
        taken = min(mass, left)
        total, left = total + taken * value, left - taken
    return total / level


@given(st.integers(0, 1000), st.floats(0.02, 1.0), st.sampled_from([1.0, 0.25]))
def test_cvar_is_the_mean_of_the_worst(seed, level, time_step):
    timelines, values = random_timelines(seed), np.array([-2.0, -1.0, 0.0, 0.5, 3.0])
    means = distorted(timelines * time_step, values, "cvar", level, time_step=time_step) @ values / time_step
    expected = [[naive_cvar(row, values, level) for row in timeline] for timeline in timelines]
    np.testing.assert_allclose(means, expected, atol=1e-12)


@given(st.integers(0, 1000), st.floats(0.0, 5.0))
def test_distorted_rows_are_distributions_and_move_to_their_side(seed, size):
    timelines, values = random_timelines(seed), np.array([-2.0, -1.0, 0.0, 0.5, 3.0])
    plain = timelines @ values
    for level, sign in ((-size, -1.0), (size, 1.0)):
        moved = distorted(timelines, values, "power", level)
        assert moved.min() >= 0.0
        assert moved.sum(axis=-1).max() <= 1.0 + 1e-12
        assert np.all(sign * (moved @ values - plain) >= -1e-12)
    np.testing.assert_allclose(distorted(timelines, values, "power", 0.0), timelines, atol=1e-14)
    np.testing.assert_allclose(distorted(timelines, values, "cvar", 1.0), timelines, atol=1e-14)


def test_a_row_that_is_no_distribution_is_made_one_first():
    np.testing.assert_allclose(
        distorted(np.array([[[-0.5, 1.5, 0.5]]]), np.array([0.0, 1.0, 2.0]), "cvar", 1.0), [[[0.0, 0.75, 0.25]]]
    )


# --- back to gamma-space, and acting ---


def test_the_transform_back_by_hand():
    back = transformed(TIMELINE, GAMMAS, THETAS)
    # At 1/2: 1 + 1/2 + 1/8 steps; above 0: 1 + 1/4 + 1/8; above 2: 1/4 + 1/8. At 4/5 in the same way.
    np.testing.assert_allclose(back.constant, [[1.625, 1.0 + 0.8 + 0.32]])
    np.testing.assert_allclose(back.values, [[[1.375, 0.375], [1.0 + 0.4 + 0.32, 0.4 + 0.32]]])
    assert back.open_ends
    differences = bin_differences(back.values, back.constant, open_ends=True)
    np.testing.assert_allclose(differences[0, 0], [0.25, 1.0, 0.375])
    np.testing.assert_allclose(differences @ back.bin_values, [[1.75, 1.0 + 0.8 + 0.64]])


def test_a_round_trip_loses_what_regularisation_and_a_cut_take():
    gammas = np.linspace(0.1, 0.9, 9)
    space = transformed(random_timelines(1, (2, 6, 3)), gammas, THETAS)
    masses = problem_of(space, 6).masses
    for loss in round_trip_losses(space, decode(masses, gammas, 6, 0.0)):
        assert loss.relative < 1e-9
    gentle = [round_trip_losses(space, decode(masses, gammas, 6, alpha))[0].relative for alpha in (0.01, 0.1, 1.0)]
    assert gentle == sorted(gentle)
    # Of the timeline by hand a cut after the first row takes, at 4/5, 0.8 + 0.32 steps: 0.2 * 1.12 of (1 - gamma) Q.
    by_hand = transformed(TIMELINE, GAMMAS, THETAS)
    (loss,) = round_trip_losses(by_hand, cut(TIMELINE, 1.0))
    assert loss.gamma == 0.5  # there 0.5 * 0.625 = 0.3125 is more
    assert loss.largest == pytest.approx(0.3125)
    # Masses at 1/2: (.25, 1, .375) less (0, 1, 0); at 4/5: (.4, 1, .72).
    assert loss.relative == pytest.approx(np.sqrt((0.25**2 + 0.375**2 + 0.4**2 + 0.72**2) /
                                                  (0.25**2 + 1 + 0.375**2 + 0.4**2 + 1 + 0.72**2)))  # fmt: skip


def test_risk_and_a_deadline_change_the_action():
    # Action 0 pays 1 at once; action 1 pays 0 at once and then 2 or, as often, nothing; bins count as 0, 1 and 2.
    safe = [[0, 1, 0], [0, 0, 0]]
    risky = [[1, 0, 0], [0.2, 0, 0.8]]
    masses = np.array([safe, risky], dtype=float)
    values, actions = values_of(masses, THETAS, gamma=1.0)
    np.testing.assert_allclose(values, [[1, 1], [0, 1.6]])
    np.testing.assert_array_equal(actions, [0, 1])
    bins = np.array([0.0, 1.0, 2.0])
    values, actions = values_of(distorted(masses, bins, "cvar", 0.3), THETAS, gamma=1.0)
    # The worst .3 of the second step: .2 of 0 and .1 of 2.
    np.testing.assert_allclose(values, [[1, 1], [0, 2 / 3]])
    np.testing.assert_array_equal(actions, [0, 0])
    assert values_of(cut(masses, 1.0), THETAS, gamma=1.0)[1][-1] == 0


def test_what_makes_no_sense_is_refused(subtests):
    bins = np.array([0.0, 1.0, 2.0])
    for call, named in [
        (lambda: cut(TIMELINE, 0.0), "horizon"),
        (lambda: rediscounted(TIMELINE, 0.0), "discount"),
        (lambda: rediscounted(TIMELINE, 1.5), "discount"),
        (lambda: rediscounted(TIMELINE, np.nan), "discount"),
        (lambda: shifted(TIMELINE, 0.5), "whole number of rows"),
        (lambda: shifted(TIMELINE, np.inf), "whole number of rows"),
        (lambda: distorted(TIMELINE, bins, "wang", 0.5), "cvar, power"),
        (lambda: distorted(TIMELINE, bins, "cvar", 0.0), "cvar"),
        (lambda: distorted(TIMELINE, bins, "cvar", np.nan), "cvar"),
        (lambda: distorted(TIMELINE, bins, "power", np.inf), "power"),
        (lambda: distorted(TIMELINE, bins[:2], "cvar", 0.5), "values"),
        (lambda: distorted(TIMELINE, bins[::-1], "cvar", 0.5), "increasing"),
        (lambda: transformed(TIMELINE, GAMMAS, np.arange(3.0)), "open ends"),
        (lambda: transformed(TIMELINE[0], GAMMAS, THETAS), "actions, steps"),
        (lambda: values_of(TIMELINE[..., :2], THETAS, 0.9), "3 bins"),
    ]:
        with subtests.test(named=named), pytest.raises(InputError, match=named):
            call()
