"""Horizon adaptation: one rule for every T against greedy and against the matched discount of the same agents.

All agents and rules act from the same start seeds. A difference is taken episode by episode; its interval is a
bootstrap over agents and over starts, see :func:`laplace_core.acting.bootstrap.interval`: few agents make a wide one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from laplace_core.acting.bootstrap import interval
from laplace_core.acting.evaluation import evaluate
from laplace_core.acting.rules import suited
from laplace_core.errors import InputError
from laplace_core.training.checkpoint import Loaded, load_checkpoint

AGAINST = ("greedy", "matched")
NOTHING: Mapping[str, float] = MappingProxyType({})


def report(
    paths: Sequence[Path],
    rule: str,
    horizons: Sequence[int | None],
    episodes: int,
    *, seed: int,
    options: dict[str, float],
    references: Sequence[Path] = (),
) -> tuple[dict[str, Any], str]:  # fmt: skip
    """Numbers and a table.

    Args:
        paths: checkpoints of one environment.
        horizons: T of each row; None is the environment's own limit.
        seed: which start seeds.
        options: of the rule, as in :func:`laplace_core.acting.evaluation.evaluate`.
        references: baselines, checkpoints of that environment, each by the rule that suits it: a fixed-horizon agent
            acts by the time to go that it has learned.

    Raises:
        InputError: no checkpoints, or of several environments.
    """
    agents, others = ([load_checkpoint(path) for path in several] for several in (paths, references))
    if len({agent.environment for agent in (*agents, *others)}) != 1:
        raise InputError("name the checkpoints of one environment.")
    rows = []
    for horizon in horizons:
        rows.append(_row(agents, rule, horizon, episodes, seed=seed, options=options))
        if others:
            rows[-1]["references"] = [
                float(_returns(each, suited(each.agent, horizon), horizon, episodes, seed=seed).mean())
                for each in others
            ]
    numbers = {
        "environment": agents[0].environment, "agents": [str(path) for path in paths], "rule": rule,
        "options": options, "episodes": episodes, "seed": seed, "references": [str(path) for path in references],
        "rows": rows,
    }  # fmt: skip
    return numbers, _table(numbers)


def _row(
    agents: list[Loaded], rule: str, horizon: int | None, episodes: int, *, seed: int, options: dict[str, float]
) -> dict[str, Any]:
    returns = {
        name: np.array(
            [
                _returns(each, name, horizon, episodes, seed=seed, options=options if name == rule else {})
                for each in agents
            ]
        )
        for name in (*AGAINST, rule)
    }
    row = {"horizon": horizon, "means": {name: each.mean(axis=1).tolist() for name, each in returns.items()}}
    for name in AGAINST:
        difference = returns[rule] - returns[name]
        row[f"against {name}"] = {
            "mean": float(difference.mean()),
            "agents": difference.mean(axis=1).tolist(),
            "interval": interval(difference),
        }
    return row


def _returns(
    loaded: Loaded, rule: str, horizon: int | None, episodes: int, *, seed: int, options: Mapping[str, float] = NOTHING
) -> np.ndarray:
    """``(episodes,)``."""
    how: dict[str, Any] = {"horizon": horizon, "rule": rule, **options}
    return evaluate(loaded.agent, loaded.environment, episodes=episodes, seed=seed, **how).returns


def _table(numbers: dict[str, Any]) -> str:
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
            difference = row[f"against {name}"]
            low, high = difference["interval"]
            line += f"  {difference['mean']:+9.1f} {f'{low:+.1f} to {high:+.1f}':>16}"
        lines.append(line)
    if numbers["references"]:
        each = ", ".join(
            f"T = {row['horizon'] or 'full'}: {' '.join(f'{mean:.1f}' for mean in row['references'])}"
            for row in numbers["rows"]
        )
        lines.append(f"beside them {', '.join(Path(path).stem for path in numbers['references'])}: {each}")
    for row in numbers["rows"]:
        each = ", ".join(f"{a:.1f} -> {b:.1f}" for a, b in zip(row["means"]["greedy"], row["means"][rule], strict=True))
        lines.append(f"T = {row['horizon'] or 'full'}, each agent, greedy -> {rule}: {each}")
    return "\n".join(lines)
