"""The neural inverse against Tikhonov, on random worlds: another generator than the one that it learned from.

Tikhonov has rows weighted by their noise, and its alpha by generalised cross-validation; beside it with rows that are
moved to the nearest ones that could be, and with the alpha of least distance, which only somebody who knows the truth
could choose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.experiments.inverse.random_cases import RandomCase, random_case
from laplace_core.inverse.distances import (
    choice_regret,
    mean_time_distance,
    relative_error,
    total_variation,
    value_error,
)
from laplace_core.inverse.neural import NeuralInverse, onto_rows, scaled_factors
from laplace_core.inverse.problem import Problem

NOISES = (0.0, 1e-3, 1e-2)
ALPHAS = np.geomspace(1e-7, 10.0, 41)
"""In singular values of the weighted transform."""
SOLVERS = ("tikhonov gcv", "clipped gcv", "tikhonov best", "neural")
MEASURES = ("distance", "relative error", "variation", "value error", "regret")
MOST_CASES = 10_000


def weighted_factors(problem: Problem) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """SVD of (1 - gamma) F: every discount has the same noise, which cross-validation supposes."""
    return scaled_factors(problem.gammas.tobytes(), problem.steps)


def gcv_alpha(problem: Problem) -> float:
    """The alpha of :data:`ALPHAS` with the least generalised cross-validation score over all columns together.

    G |(I - A) z|^2 / trace(I - A)^2, with A the influence matrix of Tikhonov's inverse, on weighted rows.
    """
    U, s, _ = weighted_factors(problem)
    columns = np.moveaxis((1.0 - problem.gammas)[:, None] * problem.masses, -2, 0).reshape(len(problem.gammas), -1)
    parts = ((U.T @ columns) ** 2).sum(axis=1)
    outside = max(0.0, float((columns**2).sum() - parts.sum()))
    kept = 1.0 / (1.0 + (s / ALPHAS[:, None]) ** 2)  # (alphas, r): what is left of each component in the residual
    residual = kept**2 @ parts + outside
    free = kept.sum(axis=1) + len(problem.gammas) - s.size
    return float(ALPHAS[np.argmin(len(problem.gammas) * residual / free**2)])


def _timelines(problem: Problem, case: RandomCase, network: NeuralInverse) -> dict[str, np.ndarray]:
    """Masses ``(A, K, B)`` by solver.

    All solvers decode as many rows as the network gives, so that what lies after row K has a place.
    """
    long = replace(problem, steps=network.steps)
    U, s, Vt = weighted_factors(long)
    parts = U.T @ ((1.0 - problem.gammas)[:, None] * problem.masses)

    def tikhonov(alpha: float) -> np.ndarray:
        return Vt[:, : problem.steps].T @ ((s / (s**2 + alpha**2))[:, None] * parts)

    by_alpha = [tikhonov(alpha) for alpha in ALPHAS]
    best = min(by_alpha, key=lambda masses: float(mean_time_distance(masses, case.masses).mean()))
    plain = tikhonov(gcv_alpha(long))
    # As a person would who knows that masses are not negative and that survival is at most 1.
    clipped = onto_rows(plain, np.clip(plain.sum(axis=-1), 0.0, 1.0))
    return dict(zip(SOLVERS, (plain, clipped, best, network.solve(problem).masses), strict=True))


def _measured(masses: np.ndarray, case: RandomCase) -> tuple[float, ...]:
    values, truth = case.values_of(masses @ case.worth), case.values_of(case.rewards)
    return (
        float(mean_time_distance(masses, case.masses).mean()),
        float(relative_error(masses, case.masses).mean()),
        float(total_variation(masses, case.masses).mean()),
        value_error(values, truth),
        choice_regret(values, truth),
    )


def measure(network: NeuralInverse, cases: int, seed: int, noises: Sequence[float] = NOISES) -> np.ndarray:
    """Every measure of every solver, ``(noises, cases, solvers, measures)``.

    Cases whose worlds need more rows than the network gives are decoded with as many as it gives.
    """
    found = np.empty((len(noises), cases, len(SOLVERS), len(MEASURES)))
    for number in range(cases):
        case = random_case(np.random.default_rng([seed, number]), whole_steps=True)
        if case.settings.steps > network.steps:
            raise InputError(f"the network gives {network.steps} rows; random worlds have up to 200: train for 200.")
        for n, noise in enumerate(noises):
            problem = case.problem(noise, seed=number, gammas=network.gammas)
            timelines = _timelines(problem, case, network)
            found[n, number] = [_measured(timelines[name], case) for name in SOLVERS]
    return found


def report(network: NeuralInverse, cases: int, seed: int) -> tuple[dict[str, Any], str]:
    """Numbers and a table: mean, median and the value that nine tenths of the cases stay below.

    ``missed`` are the noises, of those above 0, at which the network's median distance is not the least.

    Raises:
        InputError: a number of cases out of range.
    """
    if not 1 <= cases <= MOST_CASES:
        raise InputError(f"cases is {cases}; it must be from 1 to {MOST_CASES:,}.")
    found = measure(network, cases, seed)
    rows = []
    lines = [
        f"{cases} random worlds (seed {seed}), {len(network.gammas)} discounts from {network.gammas[0]:g} to "
        f"{network.gammas[-1]:g}; means, and in brackets medians and nine tenths",
        f"{'noise':>6}  {'solver':14} " + "".join(f"{name:>24}" for name in MEASURES),
    ]
    for n, noise in enumerate(NOISES):
        for s, solver in enumerate(SOLVERS):
            means = found[n, :, s].mean(axis=0)
            medians, most = np.quantile(found[n, :, s], [0.5, 0.9], axis=0)
            rows.append({"noise": noise, "solver": solver} | {
                name: dict(zip(MEASURES, each.tolist(), strict=True))
                for name, each in (("mean", means), ("median", medians), ("nine tenths", most))
            })  # fmt: skip
            cells = [f"{a:.3g} ({b:.2g}, {c:.2g})" for a, b, c in zip(means, medians, most, strict=True)]
            lines.append(f"{noise:6g}  {solver:14} " + "".join(f"{cell:>24}" for cell in cells))
        better = np.mean(found[n, :, -1, 0] < found[n, :, 0, 0])
        rows.append({"noise": noise, "neural nearer than tikhonov gcv": float(better)})
        lines.append(f"{'':6}  neural is nearer than tikhonov gcv in {better:.0%} of the worlds")
    medians = np.median(found[..., 0], axis=1)  # (noises, solvers)
    missed = [noise for noise, each in zip(NOISES, medians, strict=True) if noise and each[-1] > each.min()]
    numbers = {"cases": cases, "seed": seed, "trained": network.about, "rows": rows, "missed": missed}
    return numbers, "\n".join(lines)
