"""Decoding: the cached operator against one bare matrix product, and against loops over the sensitivities."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from bench.report import Figure, Goal
from bench.timing import interleaved, spread
from laplace_core import Settings, load_world, study
from laplace_core.inverse import decode, decode_matrix, transform_matrix

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
