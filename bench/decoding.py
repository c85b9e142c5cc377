"""Decoding: the cached operator against one bare matrix product, and against loops over the sensitivities."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from bench.report import Figure, Goal
from bench.timing import interleaved, spread
from laplace_core import Settings, load_world, study
from laplace_core.inverse import SELECTORS, Problem, decode, decode_matrix, solve, transform_matrix
from laplace_core.inverse.components import sweep_of
from laplace_core.inverse.selectors import curves_of

STEPS = 200
SUBJECT = "Decoding a gamma-space"


def figures() -> Iterator[Figure]:
    found = study(load_world("cliff_grid"), Settings(world="cliff_grid", gammas=100, thetas=500, steps=STEPS))
    differences, gammas = found.gamma_space.differences, found.gamma_space.gammas
    alpha = found.settings.alpha
    operator = np.array(decode_matrix(gammas, STEPS, alpha))
    sizes = f"{differences.shape} differences, K = {STEPS}, alpha {alpha:g}"

    seconds = interleaved(
        {
            "decode": (lambda: decode(differences, gammas, STEPS, alpha), 5),
            "product": (lambda: np.matmul(operator, differences), 5),
            "same product": (lambda: np.matmul(operator, differences), 5),
        },
        rounds=61,
    )
    yield Figure(
        SUBJECT, "decode / one bare matrix product", spread(seconds["decode"] / seconds["product"]), "x", sizes,
        Goal("<=", 1.3), f"np.matmul of {operator.shape} with {differences.shape}, the same numbers",
    )  # fmt: skip
    yield Figure(
        SUBJECT, "the bare product / itself", spread(seconds["same product"] / seconds["product"]), "x", sizes,
        note="the same call timed twice a round: what noise alone makes",
    )  # fmt: skip
    yield Figure(SUBJECT, "decode, time of one call", spread(1e3 * seconds["decode"]), "ms", sizes)

    seconds = interleaved(
        {
            "decode": (lambda: decode(differences, gammas, STEPS, alpha), 10),
            "solves": (lambda: solve_loop(differences, gammas, STEPS, alpha), 1),
            "products": (lambda: product_loop(differences, gammas, STEPS, alpha), 3),
        },
        rounds=5,
    )
    columns = differences.shape[0] * differences.shape[2]
    yield Figure(
        SUBJECT, "naive loop / decode", spread(seconds["solves"] / seconds["decode"]), "x", sizes,
        Goal(">=", 100), f"for each action and sensitivity one np.linalg.solve of (F^T F + alpha^2 I) x = F^T z, "
        f"{STEPS} x {STEPS}: {columns:,} solves; F^T F + alpha^2 I is formed once, factorised each time",
    )  # fmt: skip
    yield Figure(
        SUBJECT, "kinder loop / decode", spread(seconds["products"] / seconds["decode"]), "x", sizes,
        note=f"the SVD and the operator are kept; one {operator.shape} matrix-vector product for each action and "
        f"sensitivity: {columns:,} products",
    )  # fmt: skip
    yield from selector_figures(differences, gammas)


def selector_figures(differences: np.ndarray, gammas: np.ndarray) -> Iterator[Figure]:
    """Every selector over a whole sweep, against one solution an alpha."""
    deviations = 1e-3 / (1.0 - gammas)
    problem = Problem(differences, gammas, STEPS, 1.0, deviations)
    alphas = sweep_of(problem, "tikhonov").alphas
    seconds = interleaved(
        {
            "selectors": (lambda: curves_of(sweep_of(problem, "tikhonov", noise=deviations)), 3),
            "solutions": (lambda: [solve(problem, "tikhonov", alpha) for alpha in alphas[::20].tolist()], 1),
        },
        rounds=9,
    )
    sizes = f"{differences.shape} masses, K = {STEPS}, {len(alphas)} alphas, {len(SELECTORS)} selectors"
    yield Figure(
        SUBJECT, "all selectors of alpha over a sweep", spread(1e3 * seconds["selectors"]), "ms", sizes,
        Goal("<=", 50.0), "the cached decomposition is there already, as for every further space of a grid",
    )  # fmt: skip
    yield Figure(
        SUBJECT, "a solution for each alpha / all selectors", spread(20 * seconds["solutions"] / seconds["selectors"]),
        "x", sizes, note="every 20th alpha is solved, with its residual; its time counts 20 times",
    )  # fmt: skip


def solve_loop(differences: np.ndarray, gammas: np.ndarray, steps: int, alpha: float) -> np.ndarray:
    """Tikhonov, one column after the other, by the normal equations."""
    transform = transform_matrix(gammas, steps)
    system = transform.T @ transform + alpha**2 * np.eye(steps)
    tau_space = np.empty((differences.shape[0], steps, differences.shape[2]))
    for a, action in enumerate(differences):
        for h in range(action.shape[1]):
            tau_space[a, :, h] = np.linalg.solve(system, transform.T @ action[:, h])
    return tau_space


def product_loop(differences: np.ndarray, gammas: np.ndarray, steps: int, alpha: float) -> np.ndarray:
    """The cached operator, one column after the other."""
    operator = decode_matrix(gammas, steps, alpha)
    tau_space = np.empty((differences.shape[0], steps, differences.shape[2]))
    for a, action in enumerate(differences):
        for h in range(action.shape[1]):
            tau_space[a, :, h] = operator @ action[:, h]
    return tau_space
