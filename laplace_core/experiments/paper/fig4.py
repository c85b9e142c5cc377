"""Figure 4: the toy MDP, its tau-space, and which action is chosen after there and back.

The paper's explanation is that the last reward is repeated where an episode ends early, and its remedy is auxiliary
states that pay 0 until all branches have the same length. Both are measured with rows rescaled to 1 and with rows left
alone; the values are exact, learned in a table (the paper's figure), or learned by a network.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from laplace_core.experiments.paper.measurement import Measurement, Options, Result, Row
from laplace_core.experiments.paper.network_space import learned_by_a_network
from laplace_core.experiments.paper.toy import EPISODES, ROWS, SEEDS, readings, settings_for
from laplace_core.study.pipeline import study, study_of_gamma_space
from laplace_core.study.settings import Settings
from laplace_core.tabular import Learning, LearnSettings, study_of
from laplace_core.worlds import load_world

NETWORK_SEEDS = 3


def _measure(part: Options) -> Result:
    return {
        "plain": _read(part, auxiliary=False),
        "auxiliary": _read(part, auxiliary=True),
    }


def _read(part: Options, *, auxiliary: bool) -> dict[str, Any]:
    if part["values"] == "network":
        return _of_network(int(part["seed"]), auxiliary=auxiliary)
    world = load_world("two_branch", {"auxiliary": auxiliary})
    if part["values"] == "exact":
        return readings(lambda rows: study(world, settings_for(rows)))
    grid: dict[str, Any] = {"gammas": 15, "spacing": "inverse-log", "gamma_min": 0.01, "gamma_max": 0.99}
    learning = Learning(world, LearnSettings(episodes=EPISODES, seed=int(part["seed"]), **grid))
    for _ in learning:
        pass
    learned = learning.snapshot()
    return readings(lambda rows: study_of(learned, settings_for(rows)))


def _of_network(seed: int, *, auxiliary: bool) -> dict[str, Any]:
    """Laplace DQN on the toy MDP: the network's own discounts and sensitivities, decoded as above."""
    ending = {"termination": "auxiliary"} if auxiliary else {}
    learned = learned_by_a_network("two_branch", seed, **ending)
    return readings(
        lambda rows: study_of_gamma_space(learned, Settings(alpha=0.2, steps=3, normalise=rows), own_convention=False)
    )


def _summary(rows: Sequence[Row]) -> Result:
    """Share of the learners that choose the better action, and mean V_3 of both actions."""
    summed: Result = {}
    for values in ("exact", "tabular", "network"):
        results = [row["result"] for row in rows if row["part"]["values"] == values]
        for ending in ("plain", "auxiliary"):
            for how in ROWS if results else ():
                each = [result[ending][how] for result in results]
                summed[f"{values}, {ending}, rows {how}"] = {
                    "right": sum(one["action"] == 1 for one in each),
                    "of": len(each),
                    "values": np.mean([one["values"] for one in each], axis=0).round(3).tolist(),
                }
    return summed


EXPERIMENT = Measurement(
    name="fig4",
    title="Figure 4: the toy MDP and the reward that is repeated",
    question="Which action is chosen after there and back, with auxiliary states and without, rows rescaled or not?",
    parts=[
        {"values": "exact"},
        *({"values": "tabular", "seed": seed} for seed in range(SEEDS)),
        *({"values": "network", "seed": seed} for seed in range(NETWORK_SEEDS)),
    ],
    measure=_measure,
    summary=_summary,
)
