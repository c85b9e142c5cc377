"""Selectors and operators against pytikhonov and DeerLab on the same matrices: ``make verify`` installs both.

Where they differ, the difference is stated and tested: DeerLab's ``rgcv`` takes the square of the influence matrix
element by element where Lukas takes the matrix product; its ``ncp`` sums over all frequencies, the mean and the mirror
images included; its ``bic`` has no small-sample correction.
"""

import math

import numpy as np
import pytest

from laplace_core.code.encoding import discount_grid
from laplace_core.inverse import SELECTORS, Problem, choose_alpha, decode_matrix, transform_matrix
from laplace_core.inverse.components import sweep_of
from laplace_core.inverse.selectors import ROBUSTNESS
from laplace_core.inverse.spectrum import difference_operator, spectrum_of

pytestmark = pytest.mark.long
STEPS, LEVEL = 25, 1e-3
GAMMAS = discount_grid(15)
DEVIATIONS = LEVEL / (1.0 - GAMMAS)
ORDERS = {"tikhonov": 0, "tikhonov1": 1, "tikhonov2": 2}


def one_column(seed):
    """A single tail with noise as a problem of one bin, its weighted data, and the weighted transform."""
    rng = np.random.default_rng(seed)
    true = np.exp(-0.5 * ((np.arange(STEPS) - rng.uniform(3, 15)) / rng.uniform(1, 4)) ** 2)
    values = transform_matrix(GAMMAS, STEPS) @ true + DEVIATIONS * rng.normal(size=15)
    given = Problem(values[:, None], GAMMAS, STEPS, 1.0, DEVIATIONS)
    weights = spectrum_of(GAMMAS, STEPS, 1.0, 0, DEVIATIONS).weights
    return given, weights * values, weights[:, None] * transform_matrix(GAMMAS, STEPS)


@pytest.mark.parametrize("solver", ORDERS)
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_deerlab(solver, seed):
    deerlab = pytest.importorskip("deerlab", reason="make verify installs it")
    given, data, kernel = one_column(seed)
    spectrum = spectrum_of(GAMMAS, STEPS, 1.0, ORDERS[solver], DEVIATIONS)
    operator = spectrum.scale * difference_operator(STEPS, ORDERS[solver])
    alphas = np.geomspace(0.05, 5.0, 60)
    sweep = sweep_of(given, solver, alphas=alphas)

    def theirs(method):
        chosen, *rest = deerlab.selregparam(
            data, kernel, solver=np.linalg.solve, method=method, algorithm="grid", searchrange=alphas, regop=operator,
            weights=np.ones(15), full_output=True,
        )  # fmt: skip
        return chosen, rest[1], rest[2], rest[3]

    ours = {name: curve(sweep)[0] for name, curve in SELECTORS.items() if name != "discrepancy"}
    _, gcv, residual, penalty = theirs("gcv")
    np.testing.assert_allclose(np.sqrt(sweep.residual[0]), residual, rtol=1e-5)
    np.testing.assert_allclose(np.sqrt(sweep.size[0]), penalty, rtol=1e-5)
    np.testing.assert_allclose(ours["gcv"] * 15, gcv, rtol=1e-5)
    np.testing.assert_allclose(ours["loo"] * 15, theirs("cv")[1], rtol=1e-5)
    np.testing.assert_allclose(ours["aic"], theirs("aicc")[1], rtol=1e-5)
    left = sweep.left - 2.0  # n - k - 2
    correction = np.where(left > 0, math.log(15) * sweep.degrees * (15 / np.where(left > 0, left, 1.0) - 1.0), np.inf)
    np.testing.assert_allclose(ours["bic"], theirs("bic")[1] + correction, rtol=1e-5)
    for i in range(0, 60, 7):
        A = kernel @ decode_matrix(GAMMAS, STEPS, alphas[i], solver=solver, deviations=DEVIATIONS) / spectrum.weights
        elementwise, product = np.trace(A**2) / 15, np.trace(A @ A) / 15
        shared = theirs("rgcv")[1][i] / (ROBUSTNESS + (1 - ROBUSTNESS) * elementwise) / 15
        assert ours["rgcv"][i] == pytest.approx(shared * (ROBUSTNESS + (1 - ROBUSTNESS) * product), rel=1e-5)
    for name, method in (("gcv", "gcv"), ("loo", "cv"), ("aic", "aicc"), ("corner", "lr")):
        chosen = alphas[np.argmin(ours[name])]
        if name == "corner":  # theirs spans the whole sweep; ours here as well, so that both are the same
            assert sweep.between.all()
        assert chosen == pytest.approx(theirs(method)[0], rel=1e-9), name


@pytest.mark.parametrize("solver", ORDERS)
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_pytikhonov(solver, seed):
    pytikhonov = pytest.importorskip("pytikhonov", reason="make verify installs it")
    given, data, kernel = one_column(seed)
    spectrum = spectrum_of(GAMMAS, STEPS, 1.0, ORDERS[solver], DEVIATIONS)
    operator = spectrum.scale * difference_operator(STEPS, ORDERS[solver])
    family = pytikhonov.TikhonovFamily(kernel, operator, data)
    alphas = np.geomspace(0.02, 5.0, 3001)  # its lambda is alpha^2
    sweep = sweep_of(given, solver, alphas=alphas, noise=DEVIATIONS)
    gcv = SELECTORS["gcv"](sweep)[0] / np.array([family.gcv(alpha**2) for alpha in alphas])
    np.testing.assert_allclose(gcv, 15.0, rtol=1e-5)  # the same but for a factor of G
    np.testing.assert_allclose(sweep.residual[0], [family.data_fidelity(alpha**2) for alpha in alphas], rtol=1e-5)
    bends = family.lcurve_data(alphas**2)["curvature"]
    ours, known = -SELECTORS["lcurve"](sweep)[0], slice(20, -20)
    assert np.isfinite(ours[known]).all()
    np.testing.assert_allclose(np.abs(ours[known]), np.abs(bends[known]), rtol=0.01, atol=0.01)
    size = float(spectrum.weights[0] * DEVIATIONS[0])  # of the weighted error, the same at every discount
    theirs = pytikhonov.discrepancy_principle(family, delta=size * math.sqrt(15), tau=1.0)
    chosen = choose_alpha(given, solver, "discrepancy", noise=DEVIATIONS, alphas=alphas)
    if theirs["converged"] and chosen.edge == "none":
        assert chosen.value == pytest.approx(math.sqrt(theirs["opt_lambdah"]), rel=0.003)
