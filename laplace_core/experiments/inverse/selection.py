"""The study of the inverse: worlds x noises x grids x solvers x selectors, with the truth beside them.

Worlds are random ones (:func:`laplace_core.experiments.inverse.random_cases.random_case`), or listed ones by name, each
with several draws of its noise. For each world, noise and grid (a job) every solver decodes with the alpha of each
selector and with every alpha of a sweep, of which the one of least distance from the truth is the best that any
selector could have chosen. ``distance`` is :func:`laplace_core.inverse.distances.mean_time_distance` (Wasserstein-1
over time), mean over the actions; ``regret`` is :func:`laplace_core.inverse.distances.choice_regret`.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from laplace_core.code.encoding import PAPER_GAMMAS, discount_grid
from laplace_core.errors import InputError
from laplace_core.experiments.inverse.random_cases import RandomCase, listed_case, random_case
from laplace_core.experiments.inverse.table_file import TableFile
from laplace_core.inverse import LINEAR, SELECTORS, SOLVERS, Problem, choose_alpha, is_linear, solve
from laplace_core.inverse.components import sweep_alphas
from laplace_core.inverse.distances import (
    choice_regret,
    mean_time_distance,
    relative_error,
    total_variation,
    value_error,
)  # fmt: skip
from laplace_core.inverse.linear import shares_kept
from laplace_core.inverse.solvers import selecting, spectrum_for
from laplace_core.supervise.parallel import in_parallel
from laplace_core.worlds import PRESETS, TOY_TEXT

NOISES = (1e-4, 1e-3, 1e-2)
GRIDS = ("paper", "inverse-log", "log")
ALPHAS = 41
"""Alphas of a sweep, of a solver that is linear."""
FEW_ALPHAS = 9
"""The same of one that is not, each of which takes a tenth of a second or more."""
RANDOM = "random"
WORLDS = (RANDOM, *PRESETS, *(f"gym:{name}" for name in TOY_TEXT))
"""What can be studied: random worlds, or a listed world by its name."""
TIMES = {"nonnegative": 5.0, "feasible": 85.0}
"""Seconds of a solver over those of a linear one, about, with all selectors."""
SWEEPING = 0.25
"""Of the seconds of a linear solver with all selectors, the share that the sweep for the best alpha takes."""
NO_SELECTOR = "best"
"""In place of a selector: the alpha of least distance, which only somebody who knows the truth can choose."""
COLUMNS = ("case", "noise", "grid", "solver", "selector", "alpha", "distance", "least", "regret", "regret_at_least",
           "relative_error", "variation", "value_error", "degrees")  # fmt: skip
"""Of the table: ``least`` is the distance of the best alpha, ``regret_at_least`` the regret there."""
Row = dict[str, Any]


class Job(NamedTuple):
    """One world, noise and grid; ``case`` is the number of a random world, or a name and the number of a draw."""

    case: int | str
    noise: float
    grid: str


@dataclass(frozen=True)
class Plan:
    """The plan of a study.

    Attributes:
        cases: how many random worlds, counted from 0, and how many draws of the noise of each listed world.
        seed: of the random worlds, and of the first draw of a listed one.
        worlds: of ``WORLDS``.

    Raises:
        InputError: names that there are not, or a number out of range.
    """

    cases: int = 100
    noises: Sequence[float] = NOISES
    grids: Sequence[str] = GRIDS
    solvers: Sequence[str] = ("tikhonov", "tikhonov1", "tikhonov2")
    selectors: Sequence[str] = tuple(name for name in SELECTORS)
    seed: int = 0
    worlds: Sequence[str] = (RANDOM,)

    def __post_init__(self) -> None:
        known = {"world": (self.worlds, WORLDS), "grid": (self.grids, GRIDS), "solver": (self.solvers, tuple(SOLVERS)),
                 "selector": (self.selectors, tuple(SELECTORS))}  # fmt: skip
        for what, (given, names) in known.items():
            for name in given:
                if name not in names:
                    raise InputError(f"{what} {name[:40]!r} is not one of {', '.join(names)}.")
            if len(set(given)) < len(given) or not given:
                raise InputError(f"name each {what} of the study once, and at least one.")
        if not self.noises or not all(np.isfinite(noise) and 0.0 < noise <= 1.0 for noise in self.noises):
            raise InputError("the noise of a study must be numbers above 0 and at most 1.")
        if not 1 <= self.cases <= 100_000:
            raise InputError(f"the study has {self.cases} worlds; it must be from 1 to 100,000.")

    def jobs(self) -> list[Job]:
        """Every world, noise and grid, world by world."""
        cases = [i if world == RANDOM else f"{world}:{i}" for world in self.worlds for i in range(self.cases)]
        return [Job(case, noise, grid) for case in cases for noise in self.noises for grid in self.grids]

    @property
    def size(self) -> int:
        """How many jobs there are."""
        return len(self.worlds) * self.cases * len(self.noises) * len(self.grids)

    @property
    def rows_of_a_job(self) -> int:
        """How many rows of the table each job has."""
        return sum(1 + (len(self.selectors) if SOLVERS[solver].has_alpha else 0) for solver in self.solvers)


def gammas_of(grid: str) -> np.ndarray:
    """Fifteen discounts from .01 to .99."""
    return np.array(PAPER_GAMMAS) if grid == "paper" else discount_grid(15, grid, 0.01, 0.99)


def rows_of(job: Job, plan: Plan) -> list[Row]:
    """The rows of one job."""
    case, draw = _case(job, plan.seed)
    problem = case.problem(job.noise, seed=draw, gammas=gammas_of(job.grid))
    rows = []
    for solver in plan.solvers:
        measured = _Measured(case, problem, solver)
        for selector, alpha in _alphas(problem, solver, plan.selectors):
            rows.append(dict(zip(COLUMNS, (*job, solver, selector, *measured.row(alpha)), strict=True)))
    return rows


def _case(job: Job, seed: int) -> tuple[RandomCase, int]:
    """The world of a job, and the seed of its noise."""
    name, _, number = str(job.case).rpartition(":")
    if name:
        return listed_case(name), seed + int(number)
    return random_case(np.random.default_rng([seed, int(number)])), int(number)


def _alphas(problem: Problem, solver: str, selectors: Sequence[str]) -> list[tuple[str, float | None]]:
    """The alpha of every selector; None is the best one."""
    if not SOLVERS[solver].has_alpha:
        return [(NO_SELECTOR, None)]
    noise = problem.deviations
    chosen: list[tuple[str, float | None]] = []
    for name in selectors:
        alpha = choose_alpha(problem, solver, name, noise=noise).value
        assert isinstance(alpha, float)  # one for all bins
        chosen.append((name, alpha))
    return [(NO_SELECTOR, None), *chosen]


class _Measured:
    """One solver on one problem: what each alpha gives."""

    def __init__(self, case: RandomCase, problem: Problem, solver: str):
        self._case, self._problem, self._solver = case, problem, solver
        self._truth = case.values_of(case.rewards)
        near = _Linear(case, problem, solver).measured if is_linear(solver) else self._solved
        self._near: Callable[[float], tuple[float, float]] = cache(near)
        count = ALPHAS if is_linear(solver) else FEW_ALPHAS
        linear = selecting(solver)
        alphas = sweep_alphas(spectrum_for(problem, linear), linear, count) if SOLVERS[solver].has_alpha else np.ones(1)
        self._best = min(alphas.tolist(), key=lambda alpha: self._near(alpha)[0])

    def row(self, alpha: float | None) -> tuple[Any, ...]:
        """The columns from ``alpha`` on; None is the alpha of least distance."""
        alpha = self._best if alpha is None else alpha
        distance, regret = self._near(alpha)
        # A selector may hit an alpha between those of the sweep that is better still.
        least, regret_at_least = min(self._near(self._best), self._near(alpha))
        case, solution = self._case, solve(self._problem, self._solver, alpha)
        return (
            alpha, distance, least, regret, regret_at_least,
            float(relative_error(solution.masses, case.masses).mean()),
            float(total_variation(solution.masses, case.masses).mean()),
            value_error(case.values_of(solution.masses @ case.worth), self._truth),
            float(np.mean(solution.degrees_of_freedom)),
        )  # fmt: skip

    def _solved(self, alpha: float) -> tuple[float, float]:
        """Distance and regret, from the solution itself."""
        case, masses = self._case, solve(self._problem, self._solver, alpha).masses
        distance = mean_time_distance(masses, case.masses, case.settings.time_step).mean()
        return float(distance), choice_regret(case.values_of(masses @ case.worth), self._truth)


class _Linear:
    """Distance and regret of a linear solver at any alpha, from components that are summed over time beforehand."""

    def __init__(self, case: RandomCase, problem: Problem, solver: str):
        self._case, self._kind, self._spectrum = case, LINEAR[solver].filter, spectrum_for(problem, solver)
        spectrum, truth = self._spectrum, case.masses
        self._parts = spectrum.U.T @ spectrum.weighted(problem.masses)  # (A, r, B)
        self._running, self._true = np.cumsum(spectrum.rows, axis=0), np.cumsum(truth, axis=-2)
        self._worths = self._parts @ case.worth  # (A, r)
        mass = np.abs(truth).sum(axis=(-2, -1))
        self._mass, self._values = np.where(mass > 0.0, mass, 1.0), case.values_of(case.rewards)

    def measured(self, alpha: float) -> tuple[float, float]:
        kept = shares_kept(self._spectrum, np.array([alpha]), self._kind)[0]
        off = self._running @ (kept[:, None] * self._parts) - self._true
        distance = self._case.settings.time_step * np.abs(off).sum(axis=(-2, -1)) / self._mass
        values = self._case.values_of((kept * self._worths) @ self._spectrum.rows.T)
        return float(distance.mean()), choice_regret(values, self._values)


@cache
def _seconds_of_one() -> float:
    """Of this thread's work: one linear solver with all selectors on one case, once all that it imports is there."""
    plan = Plan(cases=1, noises=(1e-3,), grids=("paper",), solvers=("tikhonov",))
    (job,) = plan.jobs()
    rows_of(job, plan)
    began = time.thread_time()
    rows_of(job, plan)
    return time.thread_time() - began


def seconds_to_measure(plan: Plan) -> float:
    """About how long a study takes in one process of this machine."""
    share = SWEEPING + (1.0 - SWEEPING) * len(plan.selectors) / len(SELECTORS)
    each = sum(TIMES.get(solver, 1.0) for solver in plan.solvers) * share * _seconds_of_one()
    return each * plan.size


def run(
    plan: Plan, path: Path, *, processes: int = 1, cluster: str | None = None
) -> Iterator[tuple[int, int]]:  # fmt: skip
    """Measure all jobs that are not in the table yet; their rows are in the file as soon as they are measured.

    Args:
        path: a CSV file; one that is there is gone on with.
        processes, cluster: as in :func:`laplace_core.supervise.parallel.in_parallel`.

    Yields:
        how many jobs are done, and of how many.

    Raises:
        InputError: a file that is no table of such a study.
    """
    jobs, table = plan.jobs(), TableFile(path, COLUMNS, ("case", "noise", "grid"), about=f"seed {plan.seed}")
    counts = table.counts()
    complete = {key for key, count in counts.items() if count == plan.rows_of_a_job}
    left = [job for job in jobs if table.key(job._asdict()) not in complete]
    if any(table.key(job._asdict()) in counts for job in left):
        raise InputError(f"{path} is a study of other solvers or selectors: name another file with --out.")
    done = len(jobs) - len(left)
    yield done, len(jobs)
    for _, rows in in_parallel(partial(rows_of, plan=plan), left, processes, cluster):
        table.append(rows)
        done += 1
        yield done, len(jobs)
