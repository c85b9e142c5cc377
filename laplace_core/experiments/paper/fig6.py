"""Figure 6: a chain that pays +-2 at steps 0 and 1 and +-1 at steps 2 and 3, in gamma-space and in tau-space.

The tau-space of exact values, of values learned in a table and of a network is compared with the true timeline, each
with the alpha of least error on a fixed list: what is measured is how much of the picture the values hold.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from laplace_core.experiments.paper.measurement import Measurement, Options, Result, Row
from laplace_core.experiments.paper.network_space import learned_by_a_network
from laplace_core.planning import reward_timeline
from laplace_core.study.pipeline import Study, study, study_of_gamma_space
from laplace_core.study.settings import Settings
from laplace_core.tabular import Learning, LearnSettings, study_of
from laplace_core.worlds import load_world

ALPHAS = (1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0)
STEPS, EPISODES, SEEDS, NETWORK_SEEDS = 6, 20_000, 5, 3
"""Two rows more than the chain has steps: nothing is paid there."""


def _measure(part: Options) -> Result:
    world = load_world("fig6_chain")
    truth = reward_timeline(world, 0, np.zeros(world.n_states, dtype=int), STEPS)[0]
    errors = {f"{alpha:g}": _error(_study(part, alpha), truth, world.reward_values) for alpha in ALPHAS}
    best = min(errors, key=lambda alpha: errors[alpha])
    shown = _study(part, float(best))
    return {
        "errors": {alpha: round(error, 5) for alpha, error in errors.items()},
        "alpha": float(best),
        "error": round(errors[best], 5),
        "survival": np.round(shown.decoded.survival[0], 4).tolist(),
        "probabilities": np.round(_by_reward(shown, world.reward_values), 4).tolist(),
    }


_LEARNED: dict[str, Any] = {}  # of the part that this process measures: it is decoded with every alpha


def _study(part: Options, alpha: float) -> Study:
    settings = Settings(alpha=alpha, steps=STEPS)
    if part["values"] == "exact":
        return study(load_world("fig6_chain"), settings)
    key = f"{part['values']} {part['seed']}"
    if key not in _LEARNED:
        _LEARNED.clear()
        _LEARNED[key] = _tabular(part) if part["values"] == "tabular" else _network(part)
    learned = _LEARNED[key]
    if part["values"] == "tabular":
        return study_of(learned, settings)
    return study_of_gamma_space(learned, settings, own_convention=False)


def _tabular(part: Options) -> Any:
    learning = Learning(load_world("fig6_chain"), LearnSettings(episodes=EPISODES, seed=int(part["seed"])))
    for _ in learning:
        pass
    return learning.snapshot()


def _network(part: Options) -> Any:
    return learned_by_a_network("fig6_chain", int(part["seed"]))


def _by_reward(shown: Study, rewards: np.ndarray) -> np.ndarray:
    """Decoded probability of each of the world's rewards, ``(K, V)``: midpoints go to the nearest."""
    nearest = np.abs(shown.midpoints[:, None] - rewards).argmin(axis=1)
    return shown.decoded.tau_space[0] @ np.eye(rewards.size)[nearest]


def _error(shown: Study, truth: np.ndarray, rewards: np.ndarray) -> float:
    """Total variation from the true probabilities, summed over the steps, as a share of their sum."""
    return float(np.abs(_by_reward(shown, rewards) - truth).sum() / (2.0 * truth.sum()))


def _summary(rows: Sequence[Row]) -> Result:
    """Least error over the alphas: mean, smallest and largest over the seeds."""
    summed = {}
    for values in ("exact", "tabular", "network"):
        errors = [row["result"]["error"] for row in rows if row["part"]["values"] == values]
        if errors:
            summed[values] = {
                "mean": round(float(np.mean(errors)), 4), "low": min(errors), "high": max(errors), "of": len(errors)
            }  # fmt: skip
    return summed


EXPERIMENT = Measurement(
    name="fig6",
    title="Figure 6: the chain of four rewards, from gamma-space to tau-space",
    question="How much of the timeline do exact values, a table and a network hold?",
    parts=[
        {"values": "exact"},
        *({"values": "tabular", "seed": seed} for seed in range(SEEDS)),
        *({"values": "network", "seed": seed} for seed in range(NETWORK_SEEDS)),
    ],
    measure=_measure,
    summary=_summary,
)
