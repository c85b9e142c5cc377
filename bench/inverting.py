"""Constrained inverses: time of one call of the non-negative and of the feasible solver."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from bench.report import Figure, Goal
from bench.timing import interleaved, spread
from laplace_core import Settings, load_world, study
from laplace_core.inverse.feasible import feasible
from laplace_core.inverse.nonnegative import nonnegative
from laplace_core.inverse.problem import Problem, problem_of

SUBJECT = "Constrained inverses"
ALPHA = 0.01


def problem(gammas: int, thetas: int, steps: int, actions: int) -> Problem:
    settings = Settings(world="cliff_grid", gammas=gammas, thetas=thetas, steps=steps, noise=1e-3)
    found = problem_of(study(load_world("cliff_grid"), settings).gamma_space, steps)
    return Problem(found.masses[:actions], found.gammas, steps)


def figures() -> Iterator[Figure]:
    small, large = problem(15, 112, 200, 4), problem(100, 249, 60, 1)
    seconds = interleaved(
        {
            "non-negative": (lambda: nonnegative(small, ALPHA), 1),
            "feasible": (lambda: feasible(small, ALPHA), 1),
            "feasible, large": (lambda: feasible(large, ALPHA), 1),
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
