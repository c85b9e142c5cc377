"""The coefficients of the selector ``auto``, fitted to random worlds of known truth.

Every world is decoded from several grids of discounts, with noise of several sizes, by every linear solver with many
alphas. Alphas whose distance from the truth is at most ``GOOD`` times the least are good. The coefficients are those
whose alphas lie in or nearest to these intervals, in the logarithm, by least absolute deviations.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from laplace_core.code.encoding import PAPER_GAMMAS, discount_grid
from laplace_core.experiments.inverse.random_cases import random_case
from laplace_core.files.plain_json import as_json
from laplace_core.inverse import LINEAR, solve
from laplace_core.inverse.auto import FEATURES, features
from laplace_core.inverse.components import sweep_of
from laplace_core.inverse.distances import mean_time_distance
from laplace_core.inverse.problem import Problem
from laplace_core.supervise.parallel import in_parallel

SEED = 1000
"""Of the worlds that are fitted; studies use others."""
PROBLEMS = 4
"""Of each world, each with a grid and a noise of its own."""
ALPHAS, FEW_ALPHAS = np.geomspace(1e-6, 100.0, 56), np.geomspace(1e-5, 10.0, 13)
"""Of a linear solver, and of a slow one."""
SLOW, SLOW_WORLDS, SLOW_PROBLEMS = ("nonnegative", "feasible"), 60, 1
"""Slow solvers, and how many worlds and problems of each they are fitted to."""
GOOD, NEAR = 1.2, 1.3
NOTHING = 1e-6
WEIGHTINGS = ("weighted", "equal")
_ROUNDS, _LEAST_DEVIATION, _RIDGE = 60, 0.3, 1e-2


class Example(NamedTuple):
    """One problem and one solver: its features ``(8,)``, and the distance at each of ``alphas``."""

    world: int
    solver: str
    weighting: str
    features: np.ndarray
    alphas: np.ndarray
    distances: np.ndarray


def examples_of(world: int) -> list[Example]:
    """All examples of one random world."""
    rng = np.random.default_rng([SEED, world, 1])
    case = random_case(np.random.default_rng([SEED, world]))
    examples = []
    for number in range(PROBLEMS):
        noise, gammas = 10.0 ** rng.uniform(-5.0, -1.3), _gammas(rng)
        weighted = case.problem(noise, seed=int(rng.integers(10**6)), gammas=gammas)
        equal = Problem(weighted.masses, weighted.gammas, weighted.steps, weighted.time_step)
        slow = SLOW if world < SLOW_WORLDS and number < SLOW_PROBLEMS else ()
        for weighting, problem in zip(WEIGHTINGS, (weighted, equal), strict=True):
            for solver in (*LINEAR, *slow):
                alphas = ALPHAS if solver in LINEAR else FEW_ALPHAS
                distances = [
                    mean_time_distance(
                        solve(problem, solver, alpha).masses, case.masses, case.settings.time_step
                    ).mean()
                    for alpha in alphas
                ]  # fmt: skip
                found = features(sweep_of(problem, solver))
                examples.append(Example(world, solver, weighting, found, alphas, np.maximum(distances, NOTHING)))
    return examples


def _gammas(rng: np.random.Generator) -> np.ndarray:
    if rng.random() < 0.25:
        return np.array(PAPER_GAMMAS)
    count, spacing = int(rng.choice([8, 12, 15, 20, 30, 60])), str(rng.choice(["inverse-log", "log", "linear"]))
    low, high = float(rng.choice([0.01, 0.05, 0.3])), float(rng.choice([0.9, 0.95, 0.99, 0.99, 0.995]))
    return discount_grid(count, spacing, low, high)


def fitted(examples: list[Example]) -> np.ndarray:
    """Coefficients ``(8,)``, by iteratively reweighted least squares towards the nearest good alpha."""
    good = [np.log(each.alphas[each.distances <= GOOD * each.distances.min()]) for each in examples]
    low, high = (np.array([alphas[end] for alphas in good]) for end in (0, -1))
    X = np.array([each.features for each in examples])
    weights = np.linalg.lstsq(X, (low + high) / 2.0, rcond=None)[0]
    for _ in range(_ROUNDS):
        wanted = np.clip(X @ weights, low, high)
        root = np.sqrt(1.0 / np.maximum(_LEAST_DEVIATION, np.abs(X @ weights - wanted)))
        system = np.vstack([root[:, None] * X, _RIDGE * np.eye(X.shape[1])])
        weights = np.linalg.lstsq(system, np.append(root * wanted, _RIDGE * weights), rcond=None)[0]
    return weights


def near(examples: list[Example], weights: np.ndarray) -> float:
    """Share of the examples whose distance is at most ``NEAR`` times the least."""
    ratios = [
        np.exp(np.interp(each.features @ weights, np.log(each.alphas), np.log(each.distances))) / each.distances.min()
        for each in examples
    ]
    return float(np.mean(np.array(ratios) <= NEAR))


def report(
    worlds: int, processes: int, progress: Callable[[int, int], None] = lambda done, of: None
) -> tuple[dict[str, Any], str]:
    """The file of coefficients, and a table: how near a fit to half of the worlds comes on the other half."""
    examples: list[Example] = []
    for done, (_, several) in enumerate(in_parallel(examples_of, range(worlds), processes)):
        examples += several
        progress(done + 1, worlds)
    examples.sort(key=lambda each: each.world)
    coefficients: dict[str, dict[str, list[float]]] = {}
    lines = [
        f"{worlds} worlds of seed {SEED}, {PROBLEMS} problems each; within {NEAR} of the least distance on the half "
        "that was not fitted",
        f"{'solver':11} " + " ".join(f"{name:>10}" for name in WEIGHTINGS),
    ]
    shares: dict[str, dict[str, float]] = {}
    for solver in (*LINEAR, *SLOW):
        coefficients[solver], shares[solver] = {}, {}
        for weighting in WEIGHTINGS:
            own = [each for each in examples if each.solver == solver and each.weighting == weighting]
            halves = [[each for each in own if each.world % 2 == half] for half in (0, 1)]
            crossed = [near(halves[1 - half], fitted(halves[half])) for half in (0, 1) if all(halves)]
            shares[solver][weighting] = float(np.mean(crossed)) if crossed else float("nan")
            coefficients[solver][weighting] = np.round(fitted(own), 5).tolist()
        lines.append(f"{solver:11} " + " ".join(f"{shares[solver][name]:10.1%}" for name in WEIGHTINGS))
    command = f"python -m laplace_core report auto --worlds {worlds}"
    numbers = {"command": command, "features": list(FEATURES), "coefficients": coefficients, "near": shares}
    return numbers, "\n".join(lines)


def as_file(numbers: dict[str, Any]) -> bytes:
    """The file of coefficients as JSON."""
    return as_json({name: numbers[name] for name in ("command", "features", "coefficients")})
