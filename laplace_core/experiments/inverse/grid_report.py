"""Grids of discounts on random worlds: another generator than the one that they were designed for."""

from __future__ import annotations

from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.experiments.inverse.random_cases import RandomCase, random_case
from laplace_core.inverse.grids import Judged, Task, judged_grids, task_for
from laplace_core.planning import reward_indicator_basis, reward_timeline
from laplace_core.study.horizon import readout_weights

MOST_CASES = 10_000


def world_error(grid: Judged, task: Task, case: RandomCase) -> float:
    """Error of V_T in a random world, over all horizons and actions, in the units of :meth:`Task.judge`.

    Those are the root mean square of the rewards of the world and, at each horizon, the size of V_T that it brings.
    """
    steps = task.rewards.masses.shape[1]
    targets = task.targets(steps)
    weights = readout_weights(grid.gammas, targets, grid.alpha)  # (n, G)
    rewards = case.world.reward_values
    truth = reward_timeline(case.world, case.state, case.policy, steps) @ rewards @ targets.T  # (A, n)
    basis = reward_indicator_basis(case.world, case.state, grid.gammas, [case.policy] * len(grid.gammas))
    bias = (basis @ rewards) @ weights.T - truth
    size = np.sqrt((rewards**2).mean())
    passed_on = weights**2 @ (task.noise * size / (1.0 - grid.gammas)) ** 2
    return float(np.sqrt((((bias**2).mean(axis=0) + passed_on) / task.sizes).mean())) / size


def report(count: int, horizon: int, noise: float, cases: int, *, seed: int) -> tuple[dict[str, Any], str]:
    """Numbers and a table.

    The error in all worlds together is the root of their mean square, as in the design itself. ``missed`` are the
    grids as they are, of as many discounts, by which it is smaller than by the designed one.

    Raises:
        InputError: a number out of range.
    """
    if not 1 <= cases <= MOST_CASES:
        raise InputError(f"cases is {cases}; it must be from 1 to {MOST_CASES:,}.")
    task = task_for(horizon, noise)
    grids = judged_grids(task, count)
    drawn = [random_case(np.random.default_rng([seed, number]), whole_steps=True) for number in range(cases)]
    paid = [case for case in drawn if np.any(case.rewards)]
    errors = np.array([[world_error(grid, task, case) for case in paid] for grid in grids])
    lines = [
        f"{count} discounts for horizons up to {horizon}, noise {noise:g}: relative error of V_T over timelines drawn "
        f"directly, and over {len(paid)} random worlds (seed {seed})",
        f"{'grid':18} {'alpha':>9} {'timelines':>10} {'worlds':>10} {'median':>10} {'nine tenths':>12} "
        f"{'designed nearer':>16}",
    ]
    together = {grid.name: float(np.sqrt((each**2).mean())) for grid, each in zip(grids, errors, strict=True)}
    rows = []
    for grid, each in zip(grids, errors, strict=True):
        nearer = float((errors[0] < each).mean())
        median, most = (float(quantile) for quantile in np.quantile(each, [0.5, 0.9]))
        rows.append({
            "grid": grid.name, "gammas": grid.gammas.tolist(), "alpha": grid.alpha, "error": grid.error,
            "worlds": {
                "error": together[grid.name], "median": median, "nine tenths": most, "designed nearer": nearer,
            },
        })  # fmt: skip
        share = "" if grid is grids[0] else f"{nearer:.0%}"
        lines.append(
            f"{grid.name:18} {grid.alpha:9.2g} {grid.error:10.4f} {together[grid.name]:10.4f} {median:10.4f} "
            f"{most:12.4f} {share:>16}"
        )
    usual = [grid.name for grid in grids[1:] if "tuned" not in grid.name and len(grid.gammas) == count]
    numbers = {
        "gammas": count, "horizon": horizon, "noise": noise, "cases": len(paid), "seed": seed, "rows": rows,
        "missed": [name for name in usual if together[name] < together["designed"]],
    }  # fmt: skip
    return numbers, "\n".join(lines)
