"""A study at many alphas, and every solver on it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from laplace_core import Settings, load_world, study, study_of_gamma_space
from laplace_core.inverse import SOLVERS
from laplace_core.inverse.distances import mean_time_distance
from laplace_core.study.course import course, errors_of, ranking, turns

ALPHAS = np.geomspace(1e-3, 10.0, 5)


@pytest.fixture(scope="module")
def noisy():
    return study(load_world("two_branch"), Settings(thetas=20, gammas=8, noise=0.003, noise_level=0.003, steps=6))


def test_each_alpha_chooses_and_errs_as_a_study_of_its_own_does(noisy):
    found = course(noisy, ALPHAS)
    for i, alpha in enumerate(ALPHAS):
        own = noisy.under(noisy.settings.at_alpha(float(alpha)))
        np.testing.assert_array_equal(found.chosen[i], own.decoded.actions)
        distance = mean_time_distance(own.decoded.tau_space, own.truth.tau_space).mean()
        assert found.time_error[i] == pytest.approx(distance)
    assert found.best == int(np.argmin(found.time_error))


def test_without_a_truth_there_is_a_choice_but_no_best_alpha(noisy):
    alone = study_of_gamma_space(noisy.gamma_space, Settings(world="own.npz", steps=6))
    found = course(alone, ALPHAS)
    assert found.time_error is None
    assert found.best is None
    for i, alpha in enumerate(ALPHAS):
        np.testing.assert_array_equal(
            found.chosen[i], alone.under(alone.settings.at_alpha(float(alpha))).decoded.actions
        )


def test_of_alphas_that_are_equally_good_the_largest_is_the_best(noisy):
    found = replace(course(noisy, ALPHAS), time_error=np.array([2.0, 1.0, 1.0, 3.0, 1.5]))
    assert found.best == 2


def test_turns_are_where_another_action_is_chosen():
    assert turns(np.array([1, 1, 0, 0, 1])) == [(0, 1), (2, 0), (4, 1)]
    assert turns(np.array([0])) == [(0, 0)]


def test_every_solver_that_can_be_used_is_ranked(noisy):
    found = {each.solver: each for each in ranking(noisy, "gcv")}
    assert set(found) >= set(SOLVERS) - {"neural"}
    own = noisy.under(replace(noisy.settings, solver="nonnegative", selector="gcv"))
    assert found["nonnegative"].alpha == own.settings.alpha
    assert found["nonnegative"].errors == errors_of(own)
    assert all(each.seconds > 0 for each in found.values())


def test_without_a_truth_a_ranking_has_no_errors(noisy):
    alone = study_of_gamma_space(noisy.gamma_space, Settings(world="own.npz", steps=6))
    assert {each.errors for each in ranking(alone)} == {(None,) * 5}


def test_the_truth_itself_has_no_error(noisy):
    decoded = replace(noisy.decoded, tau_space=noisy.truth.tau_space, horizon_values=noisy.truth.horizon_values)
    assert errors_of(replace(noisy, decoded=decoded)) == pytest.approx((0.0,) * 5)
