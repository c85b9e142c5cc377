"""The command line's ``grid`` verb: which discounts to learn."""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING

from laplace_core.cli.options import checked_number

if TYPE_CHECKING:
    from laplace_core.inverse.grids import Judged, Task


def add_grid(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``grid`` to the verbs."""
    grid = verbs.add_parser(
        "grid",
        help="design a grid of discounts for a longest horizon and a noise",
        description="The discounts from which V_T is read best for every horizon up to the longest, beside the grids "
        "that can be chosen by name: the errors are relative, over timelines that are drawn at random.",
    )
    grid.add_argument("--gammas", default="15", metavar="N", help="number of discounts (default: 15)")
    grid.add_argument("--horizon", default="100", metavar="T", help="longest horizon, in steps (default: 100)")
    grid.add_argument(
        "--noise", default="0.001", metavar="S",
        help="standard deviation of (1 - gamma) Q, in units of the usual reward (default: 0.001)",
    )  # fmt: skip
    grid.add_argument("--gamma-max", default="0.999", metavar="G", help="largest discount to try (default: 0.999)")
    grid.add_argument("--value-gamma", default="0.99", metavar="G", help="discount of the values (default: 0.99)")
    grid.add_argument("--seed", default="0", metavar="N", help="seed of the timelines (default: 0)")
    grid.add_argument("--json", action="store_true", help="print JSON")
    grid.set_defaults(run=_grid)


def _grid(options: argparse.Namespace) -> None:
    from laplace_core.inverse import grids  # scipy's optimisers are slow to import

    count = checked_number("gammas", options.gammas, int, 2, high=100)
    horizon = checked_number("horizon", options.horizon, int, 2, high=grids.LONGEST)
    task = grids.task_for(
        horizon,
        checked_number("noise", options.noise, float, 0.0, high=1.0),
        value_gamma=checked_number("value-gamma", options.value_gamma, float, 1e-6, high=1.0),
        seed=checked_number("seed", options.seed, int, 0, high=2**31 - 1),
    )
    highest = checked_number("gamma-max", options.gamma_max, float, 0.5, high=0.999999)
    judged = grids.judged_grids(task, count, gamma_max=highest)
    if options.json:
        numbers = {
            "horizons": task.horizons.tolist(), "noise": task.noise, "value_gamma": task.value_gamma,
            "grids": [
                {"name": each.name, "gammas": each.gammas.tolist(), "alpha": each.alpha, "error": each.error,
                 "by_horizon": each.by_horizon.tolist()}
                for each in judged
            ],
        }  # fmt: skip
        print(json.dumps(numbers, indent=1))
        return
    print("\n".join(_lines(judged, task)))


def _lines(judged: list[Judged], task: Task) -> list[str]:
    best = judged[0]
    shown = [1, len(task.horizons) // 2, len(task.horizons) - 1]
    lines = [
        f"{len(best.gammas)} discounts for horizons up to {task.horizons[-1]}, noise {task.noise:g}",
        f"{'grid':18} {'discounts':>9} {'from':>8} {'to':>8} {'alpha':>8} {'error':>8}"
        + "".join(f"{f'T = {task.horizons[i]}':>9}" for i in shown),
    ]
    lines += [
        f"{each.name:18} {len(each.gammas):9} {each.gammas[0]:8.4g} {each.gammas[-1]:8.4g} {each.alpha:8.2g} "
        f"{each.error:8.4f}" + "".join(f"{each.by_horizon[i]:9.4f}" for i in shown)
        for each in judged
    ]
    return [*lines, f"designed: {' '.join(f'{gamma:.6g}' for gamma in best.gammas)}"]
