"""The inverse: time of one call of the solvers with constraints, and of all rules that choose alpha."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from bench.report import Figure, Goal
from bench.timing import interleaved, spread
from laplace_core import Settings, load_world, study
from laplace_core.inverse.components import Sweep, sweep_of
from laplace_core.inverse.feasible import feasible
from laplace_core.inverse.nonnegative import nonnegative
from laplace_core.inverse.problem import Problem, problem_of
from laplace_core.inverse.selectors import SELECTORS, chosen_index, curves_of

SUBJECT = "The inverse"
ALPHA = 0.01
ALPHAS = 200


def problem(gammas: int, thetas: int, steps: int, actions: int) -> Problem:
    settings = Settings(world="cliff_grid", gammas=gammas, thetas=thetas, steps=steps, noise=1e-3)
    found = problem_of(study(load_world("cliff_grid"), settings).gamma_space, steps)
    return Problem(found.masses[:actions], found.gammas, steps)


def selected(given: Problem) -> dict[str, int]:
    """The index of the alpha that each rule chooses, from the data on: nothing is kept between two calls."""
    sweep: Sweep = sweep_of(given, "tikhonov", alphas=np.geomspace(1e-6, 100.0, ALPHAS), noise=np.full(100, 1e-3))
    return {rule: int(chosen_index(rule, curve)[0]) for rule, curve in curves_of(sweep).items()}


def figures() -> Iterator[Figure]:
    wide = problem(100, 498, 200, 4)
    assert set(selected(wide)) == set(SELECTORS)
    small, large = problem(15, 112, 200, 4), problem(100, 249, 60, 1)
    seconds = interleaved(
        {
            "non-negative": (lambda: nonnegative(small, ALPHA), 1),
            "feasible": (lambda: feasible(small, ALPHA), 1),
            "feasible, large": (lambda: feasible(large, ALPHA), 1),
            "selectors": (lambda: selected(wide), 1),
        },
        rounds=5,
    )
    for name, given, goal in (
        ("non-negative", small, 0.1),
        ("feasible", small, 1.0),
        ("feasible, large", large, 3.0),
    ):
        sizes = f"{np.shape(given.masses)} masses, K = {given.steps}, alpha {ALPHA:g}, noise .001"
        yield Figure(SUBJECT, f"{name}, time of one call", spread(seconds[name]), "s", sizes, Goal("<", goal))
    sizes = f"{np.shape(wide.masses)} masses, K = {wide.steps}, {len(SELECTORS)} rules, {ALPHAS} alphas"
    yield Figure(SUBJECT, "all selectors, time of one call", spread(seconds["selectors"]), "s", sizes, Goal("<", 0.05))
