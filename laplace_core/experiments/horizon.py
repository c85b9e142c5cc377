"""Horizon adaptation: one rule for every T against greedy and against the matched discount of the same agents.

All agents and rules act from the same start seeds. A difference is taken episode by episode; its interval is a
bootstrap that draws agents first and, within each, episodes, so that few agents make a wide one.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from laplace_core.errors import InputError
from laplace_core.training.bootstrap import interval
from laplace_core.training.checkpoint import Loaded, load_checkpoint
from laplace_core.training.evaluation import evaluate

AGAINST = ("greedy", "matched")


def report(
    paths: Sequence[Path],
    rule: str,
    horizons: Sequence[int | None],
    episodes: int,
    seed: int,
    options: dict[str, float],
) -> tuple[dict[str, object], str]:  # fmt: skip
    """Numbers and a table.

    Args:
        paths: checkpoints of one environment.
        horizons: T of each row; None is the environment's own limit.
        seed: which start seeds.
        options: of the rule, as in :func:`laplace_core.training.evaluation.evaluate`.

    Raises:
        InputError: no checkpoints, or of several environments.
    """
    agents = [load_checkpoint(path) for path in paths]
    if len({agent.environment for agent in agents}) != 1:
        raise InputError("name the checkpoints of one environment.")
    rows = [_row(agents, rule, horizon, episodes, seed, options) for horizon in horizons]
    numbers = {
        "environment": agents[0].environment, "agents": [str(path) for path in paths], "rule": rule,
        "options": options, "episodes": episodes, "seed": seed, "rows": rows,
    }  # fmt: skip
    return numbers, _table(numbers)


def _row(
    agents: list[Loaded], rule: str, horizon: int | None, episodes: int, seed: int, options: dict[str, float]
) -> dict[str, object]:
    returns = {
        name: np.array(
            [
                evaluate(
                    each.agent, each.environment, episodes, seed, horizon=horizon, rule=name,
                    **(options if name == rule else {}),
                ).returns
                for each in agents
            ]
        )
        for name in (*AGAINST, rule)
    }  # fmt: skip
    told = {"horizon": horizon, "means": {name: each.mean(axis=1).tolist() for name, each in returns.items()}}
    for name in AGAINST:
        difference = returns[rule] - returns[name]
        told[f"against {name}"] = {
            "mean": float(difference.mean()),
            "agents": difference.mean(axis=1).tolist(),
            "interval": interval(difference),
        }
    return told


def _table(numbers: dict[str, object]) -> str:
    rule, count = numbers["rule"], len(numbers["agents"])
    lines = [
        f"{numbers['environment']}: {rule} against {' and '.join(AGAINST)}, {count} agents x {numbers['episodes']} "
        f"episodes from common start seeds ({numbers['seed']})",
        f"{'T':>5}  " + "  ".join(f"{name:>8}" for name in (*AGAINST, rule))
        + "".join(f"  {'- ' + name:>9} {'95% interval':>16}" for name in AGAINST),
    ]  # fmt: skip
    for row in numbers["rows"]:
        means = "  ".join(f"{np.mean(row['means'][name]):8.1f}" for name in (*AGAINST, rule))
        line = f"{row['horizon'] or 'full':>5}  {means}"
        for name in AGAINST:
            found = row[f"against {name}"]
            low, high = found["interval"]
            line += f"  {found['mean']:+9.1f} {f'{low:+.1f} to {high:+.1f}':>16}"
        lines.append(line)
    for row in numbers["rows"]:
        each = ", ".join(f"{a:.1f} -> {b:.1f}" for a, b in zip(row["means"]["greedy"], row["means"][rule], strict=True))
        lines.append(f"T = {row['horizon'] or 'full'}, each agent, greedy -> {rule}: {each}")
    return "\n".join(lines)
