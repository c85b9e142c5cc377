"""Selectors of alpha against slow twins, brute force and what they must find; the record that each choice leaves."""

import json
import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError
from laplace_core.code.encoding import discount_grid
from laplace_core.inverse import (
    AUTO,
    LINEAR,
    SELECTORS,
    Problem,
    choose_alpha,
    decode_matrix,
    problem_of,
    solve,
    transform_matrix,
)
from laplace_core.inverse.auto import COEFFICIENTS
from laplace_core.inverse.components import sweep_alphas, sweep_of
from laplace_core.inverse.selectors import ROBUSTNESS, chosen_index, gcv, loo
from laplace_core.inverse.solvers import spectrum_for
from laplace_core.inverse.spectrum import difference_operator
from tests.support.random_gamma_spaces import noisy, random_space

GAMMAS = discount_grid(12)
NOISE = 1e-3 / (1.0 - GAMMAS)


def problem(seed=0, steps=20, deviations=NOISE):
    """Two actions and three sensitivities, whose timelines are sums of two bumps, with noise on every value."""
    rng = np.random.default_rng(seed)
    tau = np.arange(steps)
    bumps = [
        np.exp(-0.5 * ((tau - c) / w) ** 2) for c, w in zip(rng.uniform(0, steps, 8), rng.uniform(1, 5, 8), strict=True)
    ]
    tails = np.stack([np.cumsum(bumps[4 * a : 4 * a + 4], axis=0)[::-1] / 6.0 for a in range(2)])  # (A, H+1, K)
    values = transform_matrix(GAMMAS, steps) @ tails.swapaxes(-1, -2) + NOISE[:, None] * rng.normal(size=(2, 12, 4))
    masses = np.concatenate([-np.diff(values, axis=-1), values[..., -1:]], axis=-1)
    return Problem(masses, GAMMAS, steps, 1.0, deviations)


class Dense:
    """The slow twin: one alpha, one column after the other, with the matrices written out."""

    def __init__(self, given: Problem, solver: str, alpha: float):
        spectrum = spectrum_for(given, solver)
        W = np.eye(len(given.gammas)) if spectrum.weights is None else np.diag(spectrum.weights)
        D = decode_matrix(given.gammas, given.steps, alpha, given.time_step, solver=solver, deviations=given.deviations)
        self.tails = np.cumsum(given.masses[..., ::-1], axis=-1)[..., ::-1]
        self.columns = [W @ action[:, h] for action in self.tails for h in range(action.shape[1])]
        self.A = W @ given.transform @ D @ np.linalg.inv(W)  # influence matrix of the weighted data
        self.residuals = [column - self.A @ column for column in self.columns]
        L = spectrum.scale * difference_operator(given.steps, {"tikhonov1": 1, "tikhonov2": 2}.get(solver, 0))
        self.smoothed = [L @ D @ np.linalg.inv(W) @ column for column in self.columns]
        self.rss = sum(float(r @ r) for r in self.residuals)
        self.size = sum(float(x @ x) for x in self.smoothed)
        self.d, self.G, self.m, self.W = float(np.trace(self.A)), len(given.gammas), len(self.columns), W

    @property
    def n(self):
        return self.G * self.m


def naive_curve(name, given, solver, alphas, noise):
    """The curve of a selector, by its formula."""
    dense = [Dense(given, solver, alpha) for alpha in alphas]
    if name == "gcv":
        return [(s.rss / s.n) / ((s.G - s.d) / s.G) ** 2 for s in dense]
    if name == "rgcv":
        plain = naive_curve("gcv", given, solver, alphas, noise)
        fitted = [np.trace(s.A @ s.A) / s.G for s in dense]
        return [v * (ROBUSTNESS + (1 - ROBUSTNESS) * f) for v, f in zip(plain, fitted, strict=True)]
    if name == "loo":
        return [sum(r[g] ** 2 / (1 - s.A[g, g]) ** 2 for r in s.residuals for g in range(s.G)) / s.n for s in dense]
    if name == "aic":
        return [s.n * math.log(s.rss / s.n) + 2 * s.m * s.d * s.n / (s.n - s.m * s.d - 1) for s in dense]
    if name == "bic":
        return [s.n * math.log(s.rss / s.n) + s.m * s.d * s.n * math.log(s.n) / (s.n - s.m * s.d - 2) for s in dense]
    if name == "discrepancy":
        return [s.rss / (s.m * sum((s.W[g, g] * noise[g]) ** 2 for g in range(s.G))) for s in dense]
    if name == "quasiopt":
        changes = [
            sum(float(np.sum((y - x) ** 2)) for x, y in zip(s.smoothed, t.smoothed, strict=True))
            for s, t in pairwise(dense)
        ]
        return [*np.sqrt(changes), math.inf]
    if name == "ncp":
        return [_ncp(s.residuals) for s in dense]
    if name == "fitted":
        wanted = min(max(naive_auto(given, solver), math.log(alphas[0])), math.log(alphas[-1]))
        return [abs(math.log(alpha) - wanted) for alpha in alphas]
    raise AssertionError(name)


def naive_auto(given: Problem, solver: str) -> float:
    """log alpha of ``auto``: one component, one column and one alpha after the other."""
    spectrum = spectrum_for(given, solver)
    W = np.eye(len(given.gammas)) if spectrum.weights is None else np.diag(spectrum.weights)
    s = spectrum.s[spectrum.usable]
    reached = spectrum.U[:, : spectrum.free + len(s)]
    columns = [W @ action[:, b] for action in given.masses for b in range(action.shape[1])]
    tails = [W @ column for action in given.masses for column in np.cumsum(action[:, ::-1], axis=1).T]
    energy = [sum((u @ c) ** 2 for c in columns) / len(columns) for u in reached.T]
    outside = sum(c @ c for c in columns) / len(columns) - sum(energy)
    alphas = np.geomspace(s[-1] / 100, 10 * s[0], 120)
    bare = energy[spectrum.free :]

    def likelihood(a: float) -> float:
        lost = [a**2 / (x**2 + a**2) for x in s]
        misfit = sum(x * e for x, e in zip(lost, bare, strict=True)) + outside
        return len(s) * math.log(misfit) - sum(map(math.log, lost))

    def change(a: float, b: float) -> float:
        if not min(s[-1] / 2, s[0] / 100) <= a <= s[0]:
            return math.inf
        return sum((x / (x**2 + a**2) - x / (x**2 + b**2)) ** 2 * e for x, e in zip(s, bare, strict=True))

    numbers = [
        1.0, math.log(min(alphas, key=likelihood)),
        math.log(min(pairwise(alphas), key=lambda pair: change(*pair))[0]),
        math.log(sum(energy) + outside), math.log(sum(t @ t for t in tails) / len(tails)),
        math.log(given.steps), math.log(given.time_step), math.log(s[0]),
    ]  # fmt: skip
    weighting = "equal" if spectrum.weights is None else "weighted"
    held = json.loads(COEFFICIENTS.read_text())
    slow, summed = solver in held["coefficients"], numbers
    total = sum(energy) + outside
    lost_at = [[a**2 / (x**2 + a**2) for x in s] for a in (s[0] * 10 ** (-5 + 5 * i / 11) for i in range(12))]
    numbers = (
        numbers
        + [math.log((sum(x * e for x, e in zip(lost, bare, strict=True)) + outside) / total) for lost in lost_at]
        + [math.log(sum(lost)) for lost in lost_at]
    )
    network = held["networks"]["tikhonov" if slow else solver][weighting]
    seen = [
        min(3.0, max(-3.0, (n - mean) / scale))
        for n, mean, scale in zip(numbers, network["mean"], network["scale"], strict=True)
    ]
    for layer, (rows, biases) in enumerate(network["layers"]):
        outputs = [sum(w * x for w, x in zip(row, seen, strict=True)) + b for row, b in zip(rows, biases, strict=True)]
        seen = outputs if layer == 2 else [math.tanh(x) for x in outputs]
    if not slow:
        return seen[0]
    return sum(n * w for n, w in zip([*summed, *seen], held["coefficients"][solver][weighting], strict=True))


def _ncp(residuals):
    """Distance of the cumulative periodogram from a line; the Fourier transform by its sum."""
    G = len(residuals[0])
    power = []
    for k in range(1, G // 2 + 1):
        waves = [sum(r[g] * np.exp(-2j * math.pi * k * g / G) for g in range(G)) for r in residuals]
        power.append(sum(abs(wave) ** 2 for wave in waves))
    q = len(power)
    return math.sqrt(sum((sum(power[: j + 1]) / sum(power) - (j + 1) / q) ** 2 for j in range(q)))


# --- the curves ---


@pytest.mark.parametrize("name", [name for name in SELECTORS if name not in ("lcurve", "corner")])
def test_each_curve_is_that_of_its_slow_twin(name, subtests):
    for solver in LINEAR:
        for deviations in (NOISE, None):
            with subtests.test(solver=solver, weighted=deviations is not None):
                given = problem(deviations=deviations)
                largest = spectrum_for(given, solver).largest
                alphas = np.geomspace(0.02, 0.9, 9) * largest
                sweep = sweep_of(given, solver, alphas=alphas, noise=NOISE)
                found = SELECTORS[name](sweep)[0]
                expected = np.array(naive_curve(name, given, solver, alphas, NOISE))
                np.testing.assert_allclose(found, expected, rtol=1e-7)


def test_the_sweep_holds_what_a_solution_of_each_alpha_holds(subtests):
    for solver in LINEAR:
        with subtests.test(solver=solver):
            given = problem(seed=3)
            sweep = sweep_of(given, solver, alphas=np.array([0.05, 0.5]))
            for i, alpha in enumerate(sweep.alphas):
                dense = Dense(given, solver, float(alpha))
                assert sweep.residual[0, i] == pytest.approx(dense.rss, rel=1e-8)
                assert sweep.size[0, i] == pytest.approx(dense.size, rel=1e-7)
                assert sweep.degrees[i] == pytest.approx(dense.d, rel=1e-8)
                assert sweep.left[i] == pytest.approx(dense.G - dense.d, rel=1e-8)
                found = solve(given, solver, float(alpha)).degrees_of_freedom
                np.testing.assert_allclose(found, sweep.degrees[i])


@pytest.mark.parametrize("solver", ["tikhonov", "tikhonov1", "tikhonov2"])
def test_leaving_one_discount_out_by_brute_force(solver):
    # Fit again without each discount, at the same weights and the same penalty alpha * L, and predict it.
    given = problem(seed=5)
    spectrum, alphas = spectrum_for(given, solver), np.array([0.05, 0.4, 2.0])
    found = loo(sweep_of(given, solver, alphas=alphas))[0]
    A = spectrum.weights[:, None] * given.transform
    L = spectrum.scale * difference_operator(given.steps, int(solver[8:] or 0))
    tails = np.cumsum(given.masses[..., ::-1], axis=-1)
    data = np.concatenate(list(spectrum.weights[:, None] * tails), axis=1)  # (G, columns)
    for found_at, alpha in zip(found, alphas, strict=True):
        total = 0.0
        for g in range(12):
            others = np.arange(12) != g
            stacked = np.vstack([A[others], alpha * L]), np.vstack([data[others], np.zeros((len(L), data.shape[1]))])
            x = np.linalg.lstsq(*stacked, rcond=None)[0]
            total += float(((A[g] @ x - data[g]) ** 2).sum())
        assert found_at == pytest.approx(total / data.size, rel=1e-8)


def test_generalised_cross_validation_is_not_leaving_one_out():
    given = problem(seed=5)
    sweep = sweep_of(given, "tikhonov")
    assert not np.allclose(gcv(sweep), loo(sweep), rtol=0.1)


def test_generalised_cross_validation_by_rotation():
    # GCV is leave-one-out after a rotation of the data that makes all leverages equal (Golub, Heath and Wahba 1979):
    # the Fourier transform of the left singular vectors makes the influence matrix circulant.
    given = problem(seed=2, deviations=None)
    U = np.linalg.svd(given.transform)[0]
    k = np.arange(12)
    rotation = np.exp(2j * np.pi * np.outer(k, k) / 12) / np.sqrt(12) @ U.T
    for alpha in (0.1, 1.0):
        dense = Dense(given, "tikhonov", alpha)
        circulant = rotation @ dense.A @ rotation.conj().T
        leverage = np.real(np.diag(circulant))
        np.testing.assert_allclose(leverage, leverage[0])
        left_out = sum((np.abs(rotation @ r / (1 - leverage)) ** 2).sum() for r in dense.residuals) / dense.n
        assert gcv(sweep_of(given, "tikhonov", alphas=np.array([alpha])))[0, 0] == pytest.approx(left_out, rel=1e-8)


# --- the L-curve ---


def test_curvature_of_the_l_curve_by_its_derivatives():
    # For Tikhonov of order 0, rho = |r|^2 and eta = |x|^2 obey rho' = -alpha^2 eta'. The curve (log |r|, log |x|) then
    # has the curvature (after Hansen 2010, 5.6, with alpha^4 eta^2 in the denominator as the derivation gives it)
    #   2 eta rho / |eta'| (alpha^2 eta' rho + 2 alpha eta rho + alpha^4 eta eta') / (alpha^4 eta^2 + rho^2)^1.5
    # with eta' = -4 alpha sum_i s_i^2 e_i / (s_i^2 + alpha^2)^3.
    given = problem(seed=1)
    sweep = sweep_of(given, "tikhonov", alphas=np.geomspace(0.05, 4.0, 4001))
    U, s, _ = np.linalg.svd(spectrum_for(given, "tikhonov").weights[:, None] * given.transform, full_matrices=False)
    e = np.array([sum(float(U[:, i] @ c) ** 2 for c in Dense(given, "tikhonov", 1.0).columns) for i in range(12)])
    a, rho, eta = sweep.alphas, sweep.residual[0], sweep.size[0]
    slope = -4 * a * ((s**2 * e)[:, None] / (s[:, None] ** 2 + a**2) ** 3).sum(axis=0)
    expected = 2 * eta * rho / np.abs(slope) * (a**2 * slope * rho + 2 * a * eta * rho + a**4 * eta * slope)
    expected /= (a**4 * eta**2 + rho**2) ** 1.5
    found = SELECTORS["lcurve"](sweep)[0]
    known = np.isfinite(found)
    known[:5] = known[-5:] = False
    assert known.sum() > 2000
    np.testing.assert_allclose(-found[known], expected[known], rtol=1e-3, atol=1e-3)


def test_the_corner_is_the_nearest_point_of_the_scaled_curve():
    given = problem(seed=1)
    sweep = sweep_of(given, "tikhonov1")
    s = spectrum_for(given, "tikhonov1").s
    s = s[s > 20 * 2.3e-16 * s[0]]
    here = [i for i, a in enumerate(sweep.alphas) if min(s[-1] / 2, s[0] / 100) <= a <= s[0]]
    x, y = ([0.5 * math.log(v[0, i]) for i in here] for v in (sweep.residual, sweep.size))
    found = SELECTORS["corner"](sweep)[0]
    for i, xi, yi in zip(here, x, y, strict=True):
        u, v = (xi - min(x)) / (max(x) - min(x)), (yi - min(y)) / (max(y) - min(y))
        assert found[i] == pytest.approx(math.sqrt(u * u + v * v), rel=1e-9)
    assert all(math.isinf(found[i]) for i in range(len(found)) if i not in here)


# --- what they must find ---


@pytest.mark.parametrize("solver", ["tikhonov", "tikhonov1", "tikhonov2", "dsvd"])
def test_more_noise_asks_for_more_smoothing(solver):
    clean = random_space(np.random.default_rng(11), least=(15, 20), kind="shared")
    for rule in ("gcv", "aic", "bic", "discrepancy"):
        chosen = []
        for level in (1e-5, 1e-3, 3e-2):
            deviations = level / (1.0 - clean.gammas)
            given = problem_of(noisy(clean, level, np.random.default_rng(2)), 15, deviations=deviations)
            chosen.append(choose_alpha(given, solver, rule, noise=deviations).value)
        assert chosen[0] < chosen[1] < chosen[2], (rule, chosen)


def test_tails_have_independent_errors_and_masses_do_not():
    # Nothing but error: the residual at an alpha that fits nothing is that of the error alone, on the tails of a space
    # G m sigma^2, and for each bin twice that, but for the last one, which is a tail. 400 actions: 2% off at most.
    rng = np.random.default_rng(0)
    tails = NOISE[:, None] * rng.normal(size=(400, 12, 6))
    given = Problem(np.concatenate([-np.diff(tails, axis=-1), tails[..., -1:]], axis=-1), GAMMAS, 20, 1.0, NOISE)
    masses = given.masses.reshape(-1, 6)
    correlation = np.mean(masses[:, 1] * masses[:, 2]) / np.mean(masses[:, 1] ** 2)
    assert correlation == pytest.approx(-0.5, abs=0.03)
    alphas = np.array([1e5])
    whole = sweep_of(given, "tikhonov", alphas=alphas, noise=NOISE)
    assert SELECTORS["discrepancy"](whole)[0, 0] == pytest.approx(1.0, abs=0.02)
    bins = sweep_of(given, "tikhonov", alphas=alphas, noise=NOISE, each_bin=True)
    np.testing.assert_allclose(SELECTORS["discrepancy"](bins)[:, 0], 1.0, atol=0.06)
    np.testing.assert_allclose(bins.expected[:-1] / bins.expected[-1], 2.0)


def test_discrepancy_takes_the_largest_alpha_that_fits_within_the_error():
    given = problem(seed=1)
    sweep = sweep_of(given, "tikhonov", noise=NOISE)
    record = choose_alpha(given, "tikhonov", "discrepancy", noise=NOISE)
    ratios = [Dense(given, "tikhonov", float(a)).rss / float(sweep.expected[0]) for a in sweep.alphas]
    assert record.value == max(a for a, ratio in zip(sweep.alphas, ratios, strict=True) if ratio <= 1.0)
    assert record.edge == "none"
    tiny = choose_alpha(given, "tikhonov", "discrepancy", noise=1e-9 * NOISE)
    assert (tiny.value, tiny.edge) == (sweep.alphas[0], "lower")


UNITS = [rule for rule in SELECTORS if rule != "fitted"]
"""Rules that know no unit; what is fitted knows that masses are probabilities."""


@given(st.sampled_from(sorted(LINEAR)), st.integers(0, 10**6))
def test_a_change_of_unit_changes_no_choice(solver, seed):
    one = problem(seed)
    other = replace(one, masses=1024.0 * one.masses)
    for rule in UNITS:
        chosen, scaled = (
            choose_alpha(given, solver, rule, noise=size * NOISE).value for given, size in ((one, 1.0), (other, 1024.0))
        )
        assert chosen == pytest.approx(scaled, rel=1e-9) or rule in ("lcurve", "ncp", "quasiopt", "corner")


def test_an_alpha_for_each_bin_is_that_of_the_bin_alone(subtests):
    given = problem(seed=4)
    for rule in SELECTORS:
        with subtests.test(rule=rule):
            record = choose_alpha(given, "tikhonov", rule, noise=NOISE, each_bin=True)
            assert len(record.value) == len(record.curve) == len(record.edge) == 4
            if rule == "fitted":  # one formula for the whole space
                assert len(set(record.value)) == 1
                continue
            # The last bin is a tail, so that it is a problem of its own: one column an action.
            alone = choose_alpha(replace(given, masses=given.masses[..., -1:]), "tikhonov", rule, noise=NOISE)
            assert record.value[-1] == pytest.approx(alone.value)
            solved = solve(given, "tikhonov", np.array(record.value))
            assert np.isfinite(solved.masses).all()


# --- the record ---


def test_the_record_says_how_alpha_was_chosen(subtests):
    given = problem(seed=1)
    for rule in ("auto", *SELECTORS):
        with subtests.test(rule=rule):
            record = choose_alpha(given, "tikhonov", rule, noise=NOISE)
            kept = json.loads(record.as_json())
            assert (kept["rule"], kept["solver"]) == (rule, "tikhonov")
            assert kept["criterion"] == (AUTO if rule == "auto" else rule)
            assert kept["value"] in kept["alphas"]
            assert len(kept["curve"]) == len(kept["alphas"]) == 200
            assert kept["edge"] in ("none", "lower", "upper")
            assert set(kept["others"]) == set(SELECTORS) - {kept["criterion"]}
            assert kept["noise"] == NOISE.tolist()
            known = [(value, a) for value, a in zip(kept["curve"], kept["alphas"], strict=True) if value is not None]
            if rule != "discrepancy":
                assert kept["value"] == min(known)[1]
            for other, value in kept["others"].items():
                assert value == choose_alpha(given, "tikhonov", other, noise=NOISE).value


def test_an_optimum_beyond_the_sweep_is_said_to_be_at_its_edge():
    given = problem(seed=1)
    for alphas, edge in ((np.geomspace(20, 90, 8), "lower"), (np.geomspace(1e-5, 1e-3, 8), "upper")):
        record = choose_alpha(given, "tikhonov", "gcv", alphas=alphas)
        assert record.edge == edge
        assert record.value == alphas[0 if edge == "lower" else -1]


def test_truncation_is_swept_by_the_number_of_components():
    given = problem(seed=1)
    s = np.linalg.svd(spectrum_for(given, "tsvd").weights[:, None] * given.transform)[1]
    count = int((s > 20 * 2.3e-16 * s[0]).sum())
    alphas = sweep_alphas(spectrum_for(given, "tsvd"), "tsvd")
    kept = [round(solve(given, "tsvd", float(a)).degrees_of_freedom[0]) for a in alphas]
    assert kept == list(range(count, 0, -1))


def test_rows_that_nothing_smooths_leave_nothing_to_choose():
    given = Problem(np.random.default_rng(0).normal(size=(12, 3)), GAMMAS, 2, 1.0, NOISE)
    for rule in SELECTORS:
        record = choose_alpha(given, "tikhonov2", rule, noise=NOISE)
        assert np.isfinite(record.value)
        assert np.isfinite(solve(given, "tikhonov2", record.value).masses).all()


def test_odd_data_give_a_finite_choice(subtests):
    rng = np.random.default_rng(0)
    grids = [(GAMMAS, 1), (GAMMAS, 2), (GAMMAS, 3), (np.array([0.5, 0.9]), 30), (np.array([0.1, 0.5, 0.9, 0.95]), 4)]
    for gammas, steps in grids:
        for what, masses in (("zeros", np.zeros((len(gammas), 3))), ("noise", rng.normal(size=(len(gammas), 3))),
                             ("exact", transform_matrix(gammas, steps) @ rng.random((steps, 3)))):  # fmt: skip
            for solver in LINEAR:
                with subtests.test(G=len(gammas), K=steps, what=what, solver=solver):
                    given = Problem(masses, gammas, steps)
                    record = choose_alpha(given, solver, "auto", noise=np.ones(len(gammas)))
                    assert all(np.isfinite(a) and a > 0 for a in (record.value, *record.others.values()))
                    json.loads(record.as_json())


def test_a_selector_that_lacks_what_it_needs_says_so(subtests):
    few = Problem(np.ones((3, 2)), np.array([0.2, 0.5, 0.9]), 5)
    for named, call in [
        (
            "discrepancy needs the size of the error: give --noise-level",
            lambda: choose_alpha(few, "tikhonov", "discrepancy"),
        ),
        ("ncp needs at least 4 discounts; there are 3", lambda: choose_alpha(few, "tikhonov", "ncp")),
        ("'bayes' is neither a number nor one of auto, gcv", lambda: choose_alpha(few, "tikhonov", "bayes")),
        ("'ridge' is not one of tikhonov", lambda: choose_alpha(few, "ridge", "gcv")),
        ("noise must be 3 numbers", lambda: choose_alpha(few, "tikhonov", "gcv", noise=np.ones(2))),
        ("noise must be 3 numbers", lambda: choose_alpha(few, "tikhonov", "gcv", noise=np.zeros(3))),
    ]:
        with subtests.test(named=named), pytest.raises(InputError, match=named):
            call()
    assert "discrepancy" not in choose_alpha(few, "tikhonov", "gcv").others
    assert "ncp" not in choose_alpha(few, "tikhonov", "gcv").others


def test_of_equal_values_the_largest_alpha_is_taken():
    assert chosen_index("gcv", np.array([[2.0, 1.0, 1.0, 3.0]])).tolist() == [2]
    assert chosen_index("discrepancy", np.array([[0.5, 0.9, 1.1], [2.0, 3.0, 4.0]])).tolist() == [1, 0]
