"""Feasible timelines: constraints, optimality, an independent solver, and rewards after the last row."""

import numpy as np
import pytest
from scipy.optimize import nnls

from laplace_core import InputError
from laplace_core.code.encoding import discount_grid
from laplace_core.inverse.axis import axis_of, growth_for
from laplace_core.inverse.feasible import FeasibleSolution, feasible
from laplace_core.inverse.interior import _inverted
from laplace_core.inverse.problem import Problem, problem_of
from laplace_core.inverse.project import projected
from tests.support.random_gamma_spaces import noisy_space
from tests.support.timelines import noisy_masses, timelines

GAMMAS = discount_grid(10, "log")
STEPS = 12


def problem(noise: float = 1e-3, *, seed: int = 0, time_step: float = 1.0, alive: bool = True) -> Problem:
    rng = np.random.default_rng(seed)
    exact = GAMMAS[:, None] ** np.arange(STEPS) @ timelines(rng, 2, STEPS, 4)
    masses = noisy_masses(exact, noise / (1 - GAMMAS), rng)
    return Problem(masses, GAMMAS, round(STEPS / time_step), time_step, starts_alive=alive)


def all_columns(found: FeasibleSolution) -> np.ndarray:
    """Rows and windows, ``(A, C, B)``."""
    return np.concatenate([found.masses, found.beyond], axis=-2)


def survival_of(found: FeasibleSolution) -> np.ndarray:
    return found.axis.survival(all_columns(found).sum(axis=-1))


def slow_twin(given: Problem, alpha: float) -> np.ndarray:
    """Both constraints as non-negative least squares: inequalities by slacks, equalities by a heavy weight.

    Unknown are the masses and the ends d of an episode: survival_n = sum_{m >= n} d_m, sum d = 1.
    """
    axis = axis_of(given.gammas, given.steps, given.time_step)
    count, stretches, bins = len(axis.size), len(axis.first), given.masses.shape[-1]
    sums = np.add.reduceat(np.eye(count), axis.first, axis=0)
    heavy = 1e4
    fit = np.kron(np.eye(bins), np.vstack([axis.transform, alpha * np.diag(np.sqrt(axis.size))]))
    couple = np.hstack([np.tile(sums, bins), -np.triu(np.ones((stretches, stretches)))])
    total = np.concatenate([np.zeros(bins * count), np.ones(stretches)])
    system = np.vstack([np.hstack([fit, np.zeros((len(fit), stretches))]), heavy * couple, heavy * total])
    found = []
    for masses in given.masses:
        aims = np.concatenate([np.concatenate([masses[:, b], np.zeros(count)]) for b in range(bins)])
        x = nnls(system, np.concatenate([aims, np.zeros(stretches), [heavy]]), maxiter=100_000)[0]
        found.append(x[: bins * count].reshape(bins, count).T)
    return np.array(found)


def objective(given: Problem, columns: np.ndarray, alpha: float) -> np.ndarray:
    axis = axis_of(given.gammas, given.steps, given.time_step)
    misfit = ((axis.transform @ columns - given.masses) ** 2).sum(axis=(1, 2))
    return misfit + alpha**2 * (axis.size[:, None] * columns**2).sum(axis=(1, 2))


def test_constraints_hold_and_the_residual_of_optimality_is_small(subtests):
    for noise in (0.0, 1e-3, 1e-1):
        for alpha in (0.0, 0.01, 1.0):
            for time_step in (1.0, 0.5):
                with subtests.test(noise=noise, alpha=alpha, time_step=time_step):
                    found = feasible(problem(noise, time_step=time_step), alpha)
                    survival = survival_of(found)
                    assert all_columns(found).min() >= 0
                    assert np.abs(survival[:, 0] - 1).max() < 1e-8
                    assert np.diff(survival, axis=1).max() < 1e-8
                    assert found.kkt.max() < 1e-6


def test_it_reaches_the_objective_of_an_independent_solver(subtests):
    for alpha in (0.03, 0.5):
        with subtests.test(alpha=alpha):
            given = problem()
            found, twin = all_columns(feasible(given, alpha, 1e-9)), slow_twin(given, alpha)
            np.testing.assert_allclose(objective(given, found, alpha), objective(given, twin, alpha), rtol=1e-5)
            np.testing.assert_allclose(found, twin, atol=2e-3)


def test_multipliers_prove_that_it_is_the_best():
    # The multipliers of survival are prices a step; with y the gradient of the objective less the prices, no column
    # may gain (y >= 0) and none in use may cost (x y = 0).
    given, alpha = problem(), 0.1
    found = feasible(given, alpha, 1e-9)
    columns, axis = all_columns(found), found.axis
    gradient = -axis.transform.T @ found.residual + alpha**2 * axis.size[:, None] * columns
    reduced = gradient - axis.spread(found.prices[:, :-1])[..., None]
    assert reduced.min() > -1e-7
    assert np.abs(columns * reduced).max() < 1e-7
    ends = np.cumsum(found.prices[:, :-1], axis=1) - found.prices[:, -1:]
    assert ends.min() > -1e-7


def test_an_exact_timeline_is_fitted_exactly():
    given = problem(0.0)
    assert feasible(given, 0.0).misfit.max() < 1e-7


def test_a_state_that_may_be_terminal_may_have_no_future():
    # All values 0: the episode is over before its first step. Started alive, at least one step must happen.
    nothing = np.zeros((1, 10, 3))
    over = feasible(Problem(nothing, GAMMAS, STEPS, starts_alive=False), 0.0)
    alive = feasible(Problem(nothing, GAMMAS, STEPS), 0.0)
    assert over.survival.max() < 1e-3
    assert alive.survival[0, 0] == pytest.approx(1.0, abs=1e-8)


def test_valid_endless_worlds_are_not_distorted():
    # For ever a reward in bin 0, but for the third step, which pays in bin 1: Q = 1 / (1 - g) - g^2, and g^2. At K = 50
    # and gamma .99, 60 of 100 discounted steps come after the last row.
    gammas = discount_grid(15)
    second = gammas**2
    masses = np.stack([1 / (1 - gammas) - second, second], axis=-1)[None]
    found = feasible(Problem(masses, gammas, 50), 1e-4)
    assert np.abs((1 - gammas)[:, None] * found.residual).max() < 2e-5  # of a probability
    assert np.abs(found.survival - 1).max() < 1e-6
    assert found.masses[0, 2, 1] == pytest.approx(1.0, abs=0.01)
    assert np.delete(found.masses[0, :, 1], 2).max() < 0.01
    assert found.beyond[0, :60, 0] == pytest.approx(1.0, abs=1e-3)  # the last windows weigh next to nothing


def test_with_a_finer_time_step_survival_holds_for_each_unit_of_time():
    found = feasible(problem(1e-2, time_step=0.25), 0.01)
    rows = found.masses.sum(axis=-1)  # step 0 is the rows 0 and .25, step 1 those from .5 to 1.25
    assert rows[0, :2].sum() == pytest.approx(1.0, abs=1e-8)
    assert rows[0, 2:6].sum() <= 1.0 + 1e-8
    np.testing.assert_allclose(survival_of(found)[0, 1], rows[0, 2:6].sum(), atol=1e-12)


@pytest.mark.parametrize("alpha", [-1.0, np.nan])
def test_impossible_alphas_are_refused(alpha):
    with pytest.raises(InputError, match="alpha"):
        feasible(problem(), alpha)


# --- the axis ---


def test_windows_add_up_to_all_that_comes_after_the_rows():
    # sum_{n >= K} g^n = g^K / (1 - g); of each window sum_{a <= n < b} g^n.
    axis = axis_of(GAMMAS, 20)
    windows = axis.transform[:, 20:]
    np.testing.assert_allclose(windows.sum(axis=1), GAMMAS**20 / (1 - GAMMAS), rtol=1e-12)
    start, length = int(axis.steps[22]), int(axis.lengths[22])
    np.testing.assert_allclose(windows[:, 2], (GAMMAS[:, None] ** (start + np.arange(length))).sum(axis=1))
    assert axis.lengths[-1] == np.inf


def test_rows_belong_to_the_step_they_are_nearest_to():
    axis = axis_of(GAMMAS, 10, 0.25)  # rows at 0 .. 2.25; steps 0, 1, 2
    np.testing.assert_array_equal(axis.first[:4], [0, 2, 6, 10])
    assert axis.steps[3] == 3
    np.testing.assert_array_equal(axis.spread(np.arange(len(axis.first)))[:10], [0, 0, 1, 1, 1, 1, 2, 2, 2, 2])


def test_rows_after_the_last_whole_step_belong_to_it():
    axis = axis_of(GAMMAS, 7, 0.25)  # up to 1.5: step 2 lies beyond
    np.testing.assert_array_equal(axis.first[:3], [0, 2, 7])
    assert axis.steps[2] == 2


def test_windows_grow_as_the_noise_permits():
    # 4 sqrt(1e-4) = .04, and never beyond the limits.
    assert growth_for(1e-4 / (1 - GAMMAS), GAMMAS) == pytest.approx(0.04)
    assert growth_for(1.0 / (1 - GAMMAS), GAMMAS) == 0.15


# --- projection ---


def test_a_projected_gamma_space_is_feasible_and_its_masses_are_nearer_to_the_truth():
    # The fit has some five parameters a bin for twelve numbers, so that about sqrt(5 / 12) of the noise is left.
    exact, noisy, deviations = noisy_space(0.01, seed=4)
    found = projected(noisy, deviations)
    before, after = (
        np.linalg.norm(np.diff(each.values - exact.values, axis=-1) / deviations[:, None]) for each in (noisy, found)
    )
    assert after < 0.75 * before
    assert np.diff(found.values, axis=-1).max() < 1e-8  # tails never rise with the sensitivity
    assert (found.values[..., 0] <= found.constant + 1e-8).all()
    assert feasible(problem_of(found, 40, deviations=deviations), 0.0).misfit.max() < 1e-3  # some timeline has them


def test_a_feasible_gamma_space_stays_what_it_is():
    exact, _, deviations = noisy_space(0.01, seed=4)
    found = projected(exact, deviations)
    change = (found.values - exact.values) / deviations[:, None]
    assert np.abs(change).max() < 0.1  # in units of the noise


@pytest.mark.parametrize("shape", [(1, 7, 1), (2, 3, 4), (5, 15)])
def test_triangular_matrices_are_inverted_in_their_place(shape):
    rng = np.random.default_rng(0)
    square = rng.normal(size=(*shape, shape[-1]))
    lower = np.linalg.cholesky(square @ np.swapaxes(square, -1, -2) + np.eye(shape[-1]))
    expected = np.linalg.inv(lower)
    found = _inverted(lower)
    assert found is lower
    np.testing.assert_allclose(found, expected, atol=1e-14)
