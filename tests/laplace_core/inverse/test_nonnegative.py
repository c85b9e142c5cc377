"""Non-negative Tikhonov against scipy's non-negative least squares, column by column."""

import numpy as np
import pytest
from scipy.optimize import nnls

from laplace_core import InputError
from laplace_core.code.encoding import discount_grid
from laplace_core.inverse.nonnegative import nonnegative
from laplace_core.inverse.problem import Problem
from tests.support.timelines import noisy_masses, timelines

GAMMAS = discount_grid(12, "log")
STEPS = 40


def problem(noise: float, deviations: np.ndarray | None = None, time_step: float = 1.0) -> Problem:
    rng = np.random.default_rng(3)
    transform = GAMMAS[:, None] ** (np.arange(STEPS) * time_step)
    exact = transform @ timelines(rng, 2, STEPS, 5)
    return Problem(noisy_masses(exact, noise / (1 - GAMMAS), rng), GAMMAS, STEPS, time_step, deviations)


def slow_twin(given: Problem, alpha: float) -> np.ndarray:
    """One scipy.optimize.nnls a column, on W F with alpha I below it."""
    weights = np.ones(12)
    if given.deviations is not None:
        weights = 1 / given.deviations
        weights /= np.sqrt((weights**2).mean())
    stacked = np.vstack([weights[:, None] * given.transform, alpha * np.eye(STEPS)])
    found = np.empty((2, STEPS, 5))
    for a in range(2):
        for b in range(5):
            z = np.concatenate([weights * given.masses[a, :, b], np.zeros(STEPS)])
            found[a, :, b] = nnls(stacked, z, maxiter=10_000)[0]
    return found


def test_it_equals_nonnegative_least_squares(subtests):
    for noise in (0.0, 1e-3, 1e-2):
        for alpha in (0.03, 0.3, 3.0):
            for deviations in (None, 0.01 / (1 - GAMMAS)):
                for time_step in (1.0, 0.5):
                    with subtests.test(noise=noise, alpha=alpha, weighted=deviations is not None, time_step=time_step):
                        given = problem(noise, deviations, time_step)
                        found = nonnegative(given, alpha)
                        np.testing.assert_allclose(found.masses, slow_twin(given, alpha), rtol=0, atol=1e-10)


def test_it_is_the_best_by_the_conditions_of_karush_kuhn_and_tucker():
    # Gradient F^T (F x - z) + alpha^2 x: 0 where x > 0, not negative where x = 0.
    given, alpha = problem(1e-3), 0.1
    found = nonnegative(given, alpha)
    gradient = -given.transform.T @ found.residual + alpha**2 * found.masses
    free = found.masses > 0
    assert free.any()
    np.testing.assert_array_equal(found.active, ~free)
    assert np.abs(gradient[free]).max() < 1e-10
    assert gradient[~free].min() > -1e-10
    np.testing.assert_allclose(found.residual, given.masses - given.transform @ found.masses, atol=1e-14)


def test_without_alpha_it_is_plain_nonnegative_least_squares():
    given = problem(1e-3)
    found = nonnegative(given, 0.0).masses[0, :, 0]
    best = nnls(given.transform, given.masses[0, :, 0])[1]
    assert found.min() >= 0
    assert np.linalg.norm(given.transform @ found - given.masses[0, :, 0]) == pytest.approx(best, rel=1e-9)


def test_equal_deviations_change_nothing():
    plain, weighted = nonnegative(problem(1e-3), 0.2), nonnegative(problem(1e-3, np.full(12, 0.07)), 0.2)
    np.testing.assert_allclose(plain.masses, weighted.masses, atol=1e-13)


def test_degrees_of_freedom_are_those_of_the_rows_that_are_free():
    # trace of F_f (F_f^T F_f + alpha^2)^-1 F_f^T of each bin, and the mean over the bins.
    given, alpha = problem(1e-3), 0.1
    found = nonnegative(given, alpha)
    for a in range(2):
        traces = []
        for b in range(5):
            part = given.transform[:, found.masses[a, :, b] > 0]
            traces.append(np.trace(part @ np.linalg.solve(part.T @ part + alpha**2 * np.eye(part.shape[1]), part.T)))
        assert found.degrees_of_freedom[a] == pytest.approx(np.mean(traces), rel=1e-8)


@pytest.mark.parametrize("alpha", [-1.0, np.nan, np.inf])
def test_impossible_alphas_are_refused(alpha):
    with pytest.raises(InputError, match="alpha"):
        nonnegative(problem(0.0), alpha)
