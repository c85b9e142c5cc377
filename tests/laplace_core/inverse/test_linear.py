"""Linear solvers against dense references: each is one matrix, and each minimises or filters what it says."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError
from laplace_core.code.encoding import discount_grid
from laplace_core.inverse import (
    LINEAR,
    SOLVERS,
    Problem,
    Solution,
    Solver,
    decode,
    decode_matrix,
    is_linear,
    iterations_of,
    problem_of,
    solve,
    solvers,
    transform_factors,
    transform_matrix,
)
from laplace_core.inverse.spectrum import difference_operator, spectrum_of
from tests.support.random_gamma_spaces import random_space

GAMMAS = discount_grid(15)
DEVIATIONS = 1.0 / (1.0 - GAMMAS)
GRIDS = [(GAMMAS, 30, 1.0), (GAMMAS, 200, 1.0), (GAMMAS, 40, 0.5), (np.array([0.3, 0.6, 0.9]), 3, 1.0),
         (discount_grid(40, "log"), 25, 1.0)]  # fmt: skip
ORDERS = {"tikhonov": 0, "tikhonov1": 1, "tikhonov2": 2}


def numbers(*shape, seed=0):
    return np.random.default_rng(seed).normal(size=shape)


# --- against dense references ---


def test_tikhonov_of_every_order_solves_the_stacked_least_squares_problem(subtests):
    # x minimises |W (F x - z)|^2 + alpha^2 |L x|^2: the least-squares solution of W F with alpha L below it, against
    # W z and zeros. W and L with the scales that the spectrum states.
    for gammas, steps, time_step in GRIDS:
        F = transform_matrix(gammas, steps, time_step)
        for solver, order in ORDERS.items():
            for deviations in (None, 1.0 / (1.0 - gammas)):
                for alpha in (0.05, 1.0):
                    with subtests.test(
                        G=len(gammas), K=steps, solver=solver, weighted=deviations is not None, alpha=alpha
                    ):
                        spectrum = spectrum_of(gammas, steps, time_step, order, deviations)
                        W = np.eye(len(gammas)) if spectrum.weights is None else np.diag(spectrum.weights)
                        L, z = spectrum.scale * difference_operator(steps, order), numbers(len(gammas), 3)
                        stacked = np.vstack([W @ F, alpha * L]), np.vstack([W @ z, np.zeros((len(L), 3))])
                        expected = np.linalg.lstsq(*stacked, rcond=None)[0]
                        found = decode(z, gammas, steps, alpha, time_step, solver=solver, deviations=deviations)
                        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * max(1, np.abs(expected).max()))


def test_filters_of_components_against_a_sum_over_the_singular_vectors(subtests):
    # x = sum_i phi_i (u_i . z / s_i) v_i, one component after the other.
    shares = {"tsvd": lambda s, a: float(s >= a), "dsvd": lambda s, a: s / (s + a)}
    U, s, Vt = np.linalg.svd(transform_matrix(GAMMAS, 30), full_matrices=False)
    z = numbers(15)
    for solver, share in shares.items():
        for alpha in (0.02, 0.5, 4.0):
            with subtests.test(solver=solver, alpha=alpha):
                expected = np.zeros(30)
                for i in range(15):
                    if s[i] > 30 * 2.2e-16 * s[0]:
                        expected += share(s[i], alpha) * (U[:, i] @ z) / s[i] * Vt[i]
                found = decode(z[:, None], GAMMAS, 30, alpha, solver=solver)[:, 0]
                np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * np.abs(expected).max())


def test_the_iteration_step_by_step(subtests):
    # x <- x + F^T (z - F x) / s_1^2 from 0, as often as alpha says: (s_1 / alpha)^2, rounded.
    F, z = transform_matrix(GAMMAS, 20), numbers(15)
    largest = np.linalg.norm(F, 2)
    for share, count in ((1.0, 1), (0.1, 100), (0.0375, 711), (3.0, 1)):
        with subtests.test(share=share):
            assert iterations_of(share * largest, largest) == count
            x = np.zeros(20)
            for _ in range(count):
                x = x + F.T @ (z - F @ x) / largest**2
            found = decode(z[:, None], GAMMAS, 20, share * largest, solver="iterative")[:, 0]
            np.testing.assert_allclose(found, x, rtol=0, atol=1e-10)
    assert iterations_of(0.0, largest) == math.inf
    assert iterations_of(1e-300, largest) == math.inf


@pytest.mark.parametrize("solver", ["tsvd", "dsvd", "iterative", "tikhonov"])
def test_without_regularisation_every_filter_is_the_pseudo_inverse(solver):
    gammas = np.array([0.1, 0.5, 0.9])
    for count in (2, 3, 6):
        pseudo = np.linalg.pinv(transform_matrix(gammas, count))
        np.testing.assert_allclose(decode_matrix(gammas, count, 0.0, solver=solver), pseudo, atol=1e-10)


def test_order_0_is_what_it_was():
    # The formula of version 0.2, to the last bit.
    U, s, Vt = transform_factors(GAMMAS, 60)
    for alpha in (0.0, 0.01, 1.0):
        usable = s > 60 * np.finfo(float).eps * s[0]
        factors = np.divide(s, s**2 + alpha**2, out=np.zeros_like(s), where=usable)
        np.testing.assert_array_equal(decode_matrix(GAMMAS, 60, alpha), (Vt.T * factors) @ U.T)


# --- the scale of alpha ---


@pytest.mark.parametrize("solver", LINEAR)
def test_equal_deviations_change_nothing(solver):
    plain = decode_matrix(GAMMAS, 30, 0.1, solver=solver)
    for size in (1e-3, 1.0, 7.0):
        np.testing.assert_array_equal(
            decode_matrix(GAMMAS, 30, 0.1, solver=solver, deviations=np.full(15, size)), plain
        )


@pytest.mark.parametrize("solver", LINEAR)
def test_the_unit_of_deviations_does_not_matter(solver):
    # A power of 2, so that no rounding differs: dsvd gives components of rounding back by up to 1 / alpha.
    one, other = (decode_matrix(GAMMAS, 30, 0.1, solver=solver, deviations=c * DEVIATIONS) for c in (1.0, 2.0**-10))
    np.testing.assert_array_equal(one, other)


def test_the_largest_singular_value_is_that_of_the_transform(subtests):
    # So that alpha = s_1 halves the strongest component, whatever the weights and the order: s^2 / (s^2 + s^2) = 1/2.
    for gammas, steps, time_step in GRIDS[:3]:
        largest = np.linalg.norm(transform_matrix(gammas, steps, time_step), 2)
        for order in (0, 1, 2):
            for deviations in (None, 1.0 / (1.0 - gammas)):
                with subtests.test(K=steps, order=order, weighted=deviations is not None):
                    spectrum = spectrum_of(gammas, steps, time_step, order, deviations)
                    assert spectrum.s[0] == pytest.approx(largest, rel=1e-9)
                    problem = Problem(np.ones((15, 1)), gammas, steps, time_step, deviations)
                    found = solve(problem, f"tikhonov{order or ''}", largest).degrees_of_freedom
                    shares = spectrum.s**2 / (spectrum.s**2 + largest**2)
                    assert shares[0] == pytest.approx(0.5, rel=1e-9)
                    assert found == pytest.approx(order + shares[spectrum.usable].sum(), rel=1e-9)


def test_components_are_what_they_are_said_to_be(subtests):
    for gammas, steps, time_step in GRIDS:
        for order in (0, 1, 2):
            with subtests.test(G=len(gammas), K=steps, order=order):
                spectrum = spectrum_of(gammas, steps, time_step, order, 1.0 / (1.0 - gammas))
                known = np.concatenate([np.ones(order, dtype=bool), spectrum.usable])
                U, rows, s = spectrum.U[:, known], spectrum.rows[:, known], np.append(np.ones(order), spectrum.s)[known]
                np.testing.assert_allclose(U.T @ U, np.eye(known.sum()), atol=1e-11)
                transform = spectrum.weights[:, None] * transform_matrix(gammas, steps, time_step)
                np.testing.assert_allclose(transform @ rows, U * s, atol=1e-9)
                smoothed = spectrum.scale * difference_operator(steps, order) @ rows
                np.testing.assert_allclose(smoothed[:, :order], 0.0, atol=1e-9)
                np.testing.assert_allclose(
                    smoothed[:, order:].T @ smoothed[:, order:], np.eye(known.sum() - order), atol=1e-8
                )


def test_a_timeline_without_bends_costs_order_2_nothing():
    # 3 - .1 tau is a straight line: its second difference is 0, and alpha does not touch it. A constant for order 1.
    line = 3.0 - 0.1 * np.arange(20)
    for solver, x in (("tikhonov2", line), ("tikhonov1", np.full(20, 0.7))):
        z = transform_matrix(GAMMAS, 20) @ x
        for alpha in (0.1, 1e3):
            np.testing.assert_allclose(decode(z[:, None], GAMMAS, 20, alpha, solver=solver)[:, 0], x, atol=1e-8)


def test_rows_that_are_fewer_than_the_order_are_fitted_without_a_penalty():
    for solver, count in (("tikhonov1", 1), ("tikhonov2", 1), ("tikhonov2", 2)):
        pseudo = np.linalg.pinv(transform_matrix(GAMMAS, count))
        np.testing.assert_allclose(decode_matrix(GAMMAS, count, 5.0, solver=solver), pseudo, atol=1e-11)


def test_a_noisy_discount_counts_less():
    # One value is wrong by 1: the larger its deviation, the less the rows move.
    error = np.eye(15)[:, [7]]
    moved = []
    for size in (1.0, 10.0, 1000.0):
        deviations = np.where(np.arange(15) == 7, size, 1.0)
        moved.append(np.abs(decode(error, GAMMAS, 30, 0.1, deviations=deviations)).max())
    assert moved[0] > 5 * moved[1] > 50 * moved[2]


# --- the one call ---


@given(st.sampled_from(sorted(LINEAR)), st.sampled_from([0.03, 1.0]), st.booleans(), st.integers(0, 10**6))
def test_a_solution_is_the_decoded_problem(solver, alpha, weighted, seed):
    problem = Problem(numbers(2, 15, 4, seed=seed), GAMMAS, 12, 1.0, DEVIATIONS if weighted else None)
    found = solve(problem, solver, alpha)
    D = decode_matrix(GAMMAS, 12, alpha, solver=solver, deviations=problem.deviations)
    np.testing.assert_allclose(found.masses, D @ problem.masses, rtol=1e-9, atol=1e-9 * np.abs(found.masses).max())
    np.testing.assert_allclose(found.residual, problem.masses - problem.transform @ found.masses)
    # Effective degrees of freedom: the trace of the influence matrix F D.
    np.testing.assert_allclose(found.degrees_of_freedom, np.full(2, np.trace(problem.transform @ D)), rtol=1e-6)
    assert found.active is None
    assert found.beyond is None


def test_a_bin_may_have_an_alpha_of_its_own():
    problem, alphas = Problem(numbers(2, 15, 3), GAMMAS, 12, 1.0, DEVIATIONS), np.array([0.01, 0.3, 2.0])
    for solver in LINEAR:
        found = solve(problem, solver, alphas)
        for b, alpha in enumerate(alphas):
            alone = solve(problem, solver, float(alpha)).masses[..., b]
            np.testing.assert_allclose(found.masses[..., b], alone, rtol=1e-9, atol=1e-10)
        each = [solve(problem, solver, float(alpha)).degrees_of_freedom[0] for alpha in alphas]
        np.testing.assert_allclose(found.degrees_of_freedom, np.mean(each))


def test_survival_is_the_decoded_constant_channel():
    space = random_space(np.random.default_rng(4), least=(8, 5))
    problem = problem_of(space, 20)
    found = solve(problem, "tikhonov1", 0.1)
    decoded = decode(space.constant[..., None], space.gammas, 20, 0.1, solver="tikhonov1")[..., 0]
    np.testing.assert_allclose(found.survival, decoded, atol=1e-10)
    inner = decode(space.differences, space.gammas, 20, 0.1, solver="tikhonov1")
    np.testing.assert_allclose(found.tau_space(open_ends=False), inner, atol=1e-10)


def test_a_solver_that_is_not_linear_is_one_entry_of_the_registry(monkeypatch):
    def clipped(problem: Problem, alpha: float | np.ndarray) -> Solution:
        found = solve(problem, "tikhonov", alpha)
        return Solution(np.maximum(found.masses, 0.0), found.residual, found.degrees_of_freedom)

    monkeypatch.setattr(solvers, "SOLVERS", {**SOLVERS, "clipped": Solver(clipped)})
    problem = Problem(numbers(15, 3), GAMMAS, 12)
    assert solve(problem, "clipped", 0.1).masses.min() == 0.0
    assert not is_linear("clipped")
    with pytest.raises(InputError, match="'clipped' has no decode matrix"):
        decode_matrix(GAMMAS, 12, 0.1, solver="clipped")


def test_malformed_problems_of_a_linear_solver_are_refused(subtests):
    problem = Problem(numbers(15, 3), GAMMAS, 12)
    for what, call, named in [
        ("unknown", lambda: solve(problem, "ridge", 0.1), "'ridge' is not one of tikhonov, "),
        ("unknown", lambda: is_linear("ridge"), "'ridge' is not one of"),
        ("no matrix", lambda: decode_matrix(GAMMAS, 12, 0.1, solver="ridge"), "'ridge' has no decode matrix"),
        ("alpha", lambda: solve(problem, "tsvd", -0.1), "alpha is -0.1"),
        ("alpha", lambda: solve(problem, "dsvd", math.nan), "alpha is nan"),
        ("alphas", lambda: solve(problem, "tikhonov", np.array([0.1, 0.2])), "one for each of the 3 bins"),
        ("alphas", lambda: solve(problem, "tikhonov", np.array([0.1, 0.2, -1.0])), "alpha is -1"),
        ("deviations", lambda: decode_matrix(GAMMAS, 12, 0.1, deviations=np.ones(3)), "deviations must be 15 numbers"),
        (
            "deviations",
            lambda: decode_matrix(GAMMAS, 12, 0.1, deviations=np.zeros(15)),
            "deviations must be 15 numbers",
        ),
        ("deviations", lambda: decode_matrix(GAMMAS, 12, 0.1, deviations=np.full(15, np.nan)), "must be 15 numbers"),
        ("discounts", lambda: decode_matrix(np.array([0.5]), 12, 0.1, solver="tikhonov2"), "at least 2 discounts"),
        ("order", lambda: spectrum_of(GAMMAS, 12, 1.0, 3), "order of the difference is 3"),
    ]:
        with subtests.test(what, named=named), pytest.raises(InputError, match=named):
            call()
