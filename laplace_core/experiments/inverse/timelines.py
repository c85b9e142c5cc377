"""Feasible timelines against Tikhonov with its best alpha, on every preset: W1 to the truth, residuals, constraints."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from laplace_core.code.encoding import reward_distance
from laplace_core.experiments.inverse.spaces import seeds_of
from laplace_core.inverse import decode
from laplace_core.inverse.distances import mean_time_distance
from laplace_core.inverse.feasible import FeasibleSolution, feasible
from laplace_core.inverse.nonnegative import nonnegative
from laplace_core.inverse.problem import Problem, Solution, problem_of
from laplace_core.inverse.selectors import choose_alpha
from laplace_core.study.pipeline import study
from laplace_core.study.settings import Settings
from laplace_core.worlds import PRESETS, load_world

NOISES = (1e-3, 1e-2)
ALPHAS = np.geomspace(1e-4, 1e3, 36)
"""Of Tikhonov."""
FEW_ALPHAS = np.geomspace(1e-2, 1e3, 11)
"""Of the slower solvers."""
SLOW: dict[str, Callable[[Problem, float], Solution]] = {"nonnegative": nonnegative, "feasible": feasible}
MEASURES = {
    "reward": "W1 over rewards, summed over the steps, in reward",
    "time": "W1 over time, in steps: how far a unit of mass lies off on average",
}
ROWS = 60
THETAS = 40
MOST_KKT, MOST_VIOLATED = 1e-6, 1e-8


class _Measured(NamedTuple):
    """A preset with one level of noise, means over draws; the last axis of each array is that of ``MEASURES``.

    Attributes:
        empty: of a timeline without any reward, ``(2,)``, which a very large alpha of Tikhonov gives.
        tikhonov: with the alpha that is best for each draw, ``(2,)``.
        automatic: of each solver with the selector ``auto``, ``(2,)``.
        swept: of each slow solver at ``FEW_ALPHAS``, ``(a, 2)``.
        kkt: the largest relative KKT residual of the feasible solver.
        violated: the most that a constraint of it is violated by.
    """

    world: str
    empty: np.ndarray
    tikhonov: np.ndarray
    automatic: dict[str, np.ndarray]
    swept: dict[str, np.ndarray]
    kkt: float
    violated: float


def report(cases: int, seed: int) -> tuple[dict[str, Any], str]:
    """Numbers and text: the W1 of each preset, mean over ``cases`` draws of noise, by both measures.

    Tikhonov has the alpha that is best in hindsight, again for each draw. The slower solvers have one alpha for all
    presets at a level of noise, the one whose mean ratio to Tikhonov's W1 is least; beside it stands what the selector
    ``auto`` gives, which knows nothing of the truth.
    """
    rows: list[dict[str, Any]] = []
    for noise in NOISES:
        presets = [_measured(name, noise, cases, seed) for name in PRESETS]
        for m, measure in enumerate(MEASURES):
            rows += _rows(presets, noise, m, measure)
    lines = [f"Presets, mean of {cases} draws of noise (seed {seed})"]
    for measure, words in MEASURES.items():
        lines += _table(measure, words, [r for r in rows if r["measure"] == measure])
    command = f"python -m laplace_core report inverse-feasible --cases {cases} --seed {seed} --json"
    return {"command": command, "seed": seed, "cases": cases, "rows": rows}, "\n".join(lines)


def _rows(presets: list[_Measured], noise: float, m: int, measure: str) -> list[dict[str, Any]]:
    shared = {
        solver: int(np.mean([each.swept[solver][:, m] / each.tikhonov[m] for each in presets], axis=0).argmin())
        for solver in SLOW
    }
    return [
        {
            "world": each.world, "noise": noise, "measure": measure, "kkt": each.kkt, "violated": each.violated,
            "empty": float(each.empty[m]), "tikhonov": float(each.tikhonov[m]),
            **{solver: float(each.swept[solver][shared[solver], m]) for solver in SLOW},
            "feasible_best": float(each.swept["feasible"][:, m].min()),
            "alphas": {solver: float(FEW_ALPHAS[at]) for solver, at in shared.items()},
            "auto": {solver: float(distances[m]) for solver, distances in each.automatic.items()},
        }
        for each in presets
    ]  # fmt: skip


def _table(measure: str, words: str, rows: list[dict[str, Any]]) -> list[str]:
    lines = [
        "",
        words,
        f"{'':20} {'':6} {'empty':>8} {'Tikhonov':>9} {'one alpha for all presets':>24} {'feasible,':>10} "
        f"{'alpha auto':>31}",
        f"{'world':20} {'noise':>6} {'timeline':>8} {'at best':>9} {'non-negative':>13} {'feasible':>10} "
        f"{'at best':>10} "
        f"{'Tikhonov':>10} {'non-neg.':>10} {'feasible':>9} {'KKT':>8} {'violated':>9}",
    ]
    for r in rows:
        mark = "" if r["feasible"] < r["tikhonov"] else "  not below Tikhonov"
        auto = f"{r['auto']['tikhonov']:10.3f} {r['auto']['nonnegative']:10.3f} {r['auto']['feasible']:9.3f}"
        lines.append(
            f"{r['world']:20} {r['noise']:6g} {r['empty']:8.3f} {r['tikhonov']:9.3f} {r['nonnegative']:13.3f} "
            f"{r['feasible']:10.3f} {r['feasible_best']:10.3f} {auto} {r['kkt']:8.1e} {r['violated']:9.1e}{mark}"
        )
    for noise in NOISES:
        mine = [r for r in rows if r["noise"] == noise]
        counts = ", ".join(
            f"{words} on {sum(r[name] < r['tikhonov'] for r in mine)}"
            for name, words in (
                ("feasible", f"feasible with alpha {mine[0]['alphas']['feasible']:.2g}"),
                ("feasible_best", "with its best"),
                ("nonnegative", f"non-negative with alpha {mine[0]['alphas']['nonnegative']:.2g}"),
            )
        )
        lines.append(f"below Tikhonov's best at noise {noise:g}, of {len(mine)} presets: {counts}")
    return lines


def _measured(name: str, noise: float, cases: int, seed: int) -> _Measured:
    settings = Settings(world=name, thetas=THETAS, steps=ROWS)
    found = study(load_world(name), settings)
    exact, truth = found.gamma_space, found.truth.tau_space
    above = found.truth.survival[..., None] - np.cumsum(truth, axis=-1)
    tails = np.concatenate([found.truth.survival[..., None], above], axis=-1)
    tails = tails - tails[..., -1:]  # what lies beyond the thetas is not compared

    def distances(tau_space: np.ndarray) -> tuple[float, float]:
        of_rewards = reward_distance(tau_space, tails, exact.thetas).sum(axis=-1).mean()
        return float(of_rewards), float(mean_time_distance(tau_space, truth).mean())

    rng = np.random.default_rng([seed, 4])
    deviations = noise / (1.0 - exact.gammas)
    tikhonov: list[np.ndarray] = []
    automatic: dict[str, list[tuple[float, float]]] = {"tikhonov": [], **{solver: [] for solver in SLOW}}
    swept: dict[str, list[list[tuple[float, float]]]] = {solver: [] for solver in SLOW}
    kkt, violated = 0.0, 0.0
    for _ in range(cases):
        values, constant = seeds_of(exact, deviations, 1, rng)
        space = replace(exact, values=values[0], constant=constant[0])
        problem = problem_of(space, ROWS, deviations=deviations)
        pictures = [decode(space.differences, space.gammas, ROWS, float(alpha)) for alpha in ALPHAS]
        tikhonov.append(np.min([distances(picture) for picture in pictures], axis=0))
        alpha = _automatic(problem_of(space, ROWS), "tikhonov")
        automatic["tikhonov"].append(distances(decode(space.differences, space.gammas, ROWS, alpha)))
        for solver, solve_it in SLOW.items():
            solved = [solve_it(problem, float(alpha)) for alpha in (*FEW_ALPHAS, _automatic(problem, solver))]
            found_here = [distances(one.tau_space(open_ends=False)) for one in solved]
            swept[solver].append(found_here[:-1])
            automatic[solver].append(found_here[-1])
            for one in solved:
                if isinstance(one, FeasibleSolution):
                    assert one.kkt is not None  # a solution always has it
                    kkt = max(kkt, float(one.kkt.max()))
                    rise = np.diff(one.survival, axis=-1).max(initial=0.0)
                    start = np.abs(one.survival[..., 0] - 1.0).max()
                    violated = max(violated, float(rise), float(start), float(-one.masses.min()))
    return _Measured(
        name, np.array(distances(np.zeros_like(truth))), np.mean(tikhonov, axis=0),
        {solver: np.mean(each, axis=0) for solver, each in automatic.items()},
        {solver: np.mean(each, axis=0) for solver, each in swept.items()}, kkt, violated,
    )  # fmt: skip


def _automatic(problem: Problem, solver: str) -> float:
    """The alpha that ``auto`` chooses for all bins."""
    alpha = choose_alpha(problem, solver, "auto").value
    assert isinstance(alpha, float)  # one for all bins
    return alpha


def shortfalls(numbers: dict[str, Any]) -> list[str]:
    """Presets whose residual or constraints are not as demanded; where W1 is not below, the table says so."""
    return [
        f"{r['world']} at {r['noise']:g}"
        for r in numbers["rows"]
        if r["measure"] == "reward" and (r["kkt"] > MOST_KKT or r["violated"] > MOST_VIOLATED)
    ]
