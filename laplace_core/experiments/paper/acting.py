"""The paper's promise: acting for another horizon through tau-space, by every solver of the inverse.

LunarLander agents act for T steps by the tau-space that a solver decodes for every observation. The selector ``auto``
chooses its alpha for each. Beside them stand greedy, matched, fading and ``certified``, which is greedy unless another
action is certainly better; its noise level is chosen on starts of its own (``TUNED``). Slow solvers act in fewer
episodes and with fewer agents, from the first of the same starts, so that all differences are paired.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from laplace_core.acting.bootstrap import interval, mean_interval
from laplace_core.acting.evaluation import evaluate
from laplace_core.experiments.paper.measurement import Measurement, Options, Result, Row
from laplace_core.experiments.paper.table1 import CHECKPOINTS, HORIZONS, SEEDS, TUNED, TUNING_SEED
from laplace_core.training.checkpoint import load_checkpoint

RULES = ("greedy", "matched", "fading")
SOLVERS = {"tikhonov": (3, 40), "tikhonov1": (3, 20), "neural": (3, 20), "nonnegative": (3, 20), "feasible": (1, 10)}
"""Agents and episodes of each solver."""
IN_FULL = {"nonnegative": (1, 10)}
"""The same of whole episodes, where a solver takes minutes for each."""
LONGEST = {"neural": 200, "feasible": 50}
"""The longest T of a solver: the neural inverse that ships has 200 rows, and the feasible one takes days for more."""
NOISES = (1e-3, 3e-3, 1e-2)
"""Noise levels that ``certified`` chooses from."""
SOFTNESS = 0.2


def _measure(part: Options) -> Result:
    loaded = load_checkpoint(CHECKPOINTS / f"{part['agent']}.safetensors")
    common: dict[str, Any] = {"horizon": part["horizon"], "episodes": part["episodes"], "softness": SOFTNESS}
    if part["rule"] == "certified":
        tuned = {
            f"{noise:g}": float(
                evaluate(
                    loaded.agent, loaded.environment, **common | {"episodes": TUNED}, rule="certified",
                    noise_level=noise, first_seed=TUNING_SEED,
                ).mean
            )
            for noise in NOISES
        }  # fmt: skip
        best = max(tuned, key=lambda noise: tuned[noise])
        scores = evaluate(loaded.agent, loaded.environment, **common, rule="certified", noise_level=float(best))
        return {"noise_level": float(best), "tuned": tuned, "returns": np.round(scores.returns, 2).tolist()}
    if part["rule"] in RULES:
        del common["softness"]
    else:
        common |= {"rule": "decoded", "solver": part["rule"], "selector": "auto"}
    scores = evaluate(loaded.agent, loaded.environment, **{"rule": part["rule"], **common})
    return {"returns": np.round(scores.returns, 2).tolist()}


def _parts() -> list[Options]:
    parts: list[Options] = []
    for horizon in HORIZONS:
        for rule in RULES:
            parts += [{"agent": seed, "rule": rule, "horizon": horizon, "episodes": 100} for seed in SEEDS]
        for solver, (agents, episodes) in (SOLVERS | (IN_FULL if horizon is None else {})).items():
            if (horizon or 1_000) <= LONGEST.get(solver, 1_000):
                parts += [
                    {"agent": seed, "rule": solver, "horizon": horizon, "episodes": episodes}
                    for seed in SEEDS[:agents]
                ]  # fmt: skip
    parts += [
        {"agent": seed, "rule": "certified", "horizon": horizon, "episodes": 20}
        for horizon in (50, 100)
        for seed in SEEDS[:2]
    ]
    return parts


def _summary(rows: Sequence[Row]) -> Result:
    """Of each T and rule the mean return, and the paired difference from greedy, matched and fading, with intervals."""
    returns: dict[str, dict[str, dict[str, np.ndarray]]] = {}
    for row in rows:
        part = row["part"]
        here = returns.setdefault(f"T {part['horizon'] or 'full'}", {}).setdefault(part["rule"], {})
        here[part["agent"]] = np.array(row["result"]["returns"])
    return {column: {rule: _row(own, rules) for rule, own in rules.items()} for column, rules in returns.items()}


def _row(own: Mapping[str, np.ndarray], rules: Mapping[str, Mapping[str, np.ndarray]]) -> Result:
    stacked = np.stack(list(own.values()))
    entry: Result = {"mean": round(float(stacked.mean()), 2), "agents": len(stacked), "episodes": stacked.shape[1]}
    for name in RULES:
        others = rules.get(name, {})
        if not set(own) <= set(others):
            continue
        difference = stacked - np.stack([others[agent][: stacked.shape[1]] for agent in own])
        wide = interval(difference) if len(difference) > 1 else mean_interval(difference[0])
        entry[f"against {name}"] = {
            "mean": round(float(difference.mean()), 2), "interval": np.round(wide, 2).tolist()
        }  # fmt: skip
    return entry


EXPERIMENT = Measurement(
    name="acting",
    title="Acting through tau-space on LunarLander",
    question="Does the tau-space of any solver act better for T than greedy, matched and fading do?",
    parts=_parts(),
    measure=_measure,
    summary=_summary,
)
