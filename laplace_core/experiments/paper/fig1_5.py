"""Figures 1 and 5: four codes of one return, as they are exactly and as a table learns them.

The return is that of the Figure 6 chain at discount .99, a sum of four independent coins. Exactly means that the code
is computed from the true distribution: masses shared by the two nearest atoms, quantiles at the midpoints, expectiles.
The Laplace code holds no distribution of the return: its tau-space gives one only if the steps were independent, which
those of this chain are.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.optimize import brentq

from laplace_core.experiments.paper.measurement import Measurement, Options, Result, Row
from laplace_core.tabular import Learning, LearnSettings, return_distributions, wasserstein
from laplace_core.tabular.peers import impute
from laplace_core.worlds import load_world

WORLD, GAMMA, EPISODES, SEEDS = "fig6_chain", 0.99, 20_000, 5
ATOMS, QUANTILES, EXPECTILES = 51, 51, 11
Law = tuple[np.ndarray, np.ndarray]
"""Locations, increasing, and masses."""


def categorical_of(law: Law, atoms: np.ndarray) -> Law:
    """The law on fixed atoms: each location is shared by its two neighbours (Bellemare et al. 2017)."""
    place = (law[0] - atoms[0]) / (atoms[1] - atoms[0])
    masses = np.maximum(0.0, 1.0 - np.abs(place[:, None] - np.arange(atoms.size))) * law[1][:, None]
    return atoms, masses.sum(axis=0)


def quantiles_of(law: Law, count: int) -> Law:
    """Quantiles at the levels (2 i + 1) / (2 N), each with mass 1 / N (Dabney et al. 2018)."""
    levels = (2.0 * np.arange(count) + 1.0) / (2.0 * count)
    index = np.searchsorted(np.cumsum(law[1]), levels - 1e-12)
    return law[0][np.minimum(index, law[0].size - 1)], np.full(count, 1.0 / count)


def expectiles_of(law: Law, count: int) -> np.ndarray:
    """Expectiles at the levels i / (N + 1): t E(Z - e)+ = (1 - t) E(e - Z)+ (Newey & Powell 1987)."""
    locations, masses = law

    def gap(e: float, level: float) -> float:
        return float(
            level * masses @ np.maximum(locations - e, 0.0) - (1.0 - level) * masses @ np.maximum(e - locations, 0.0)
        )

    levels = np.arange(1, count + 1) / (count + 1)
    return np.array([brentq(gap, locations[0], locations[-1], args=(level,)) for level in levels])


def _measure(part: Options) -> Result:
    settings = LearnSettings(
        episodes=EPISODES, seed=int(part["seed"]), peers=True, peer_gamma=GAMMA, acting_gamma=GAMMA, atoms=ATOMS,
        quantiles=QUANTILES, expectiles=EXPECTILES,
    )  # fmt: skip
    learning = Learning(load_world(WORLD), settings)
    for _ in learning:
        pass
    learned = learning.snapshot()
    returns, peers = return_distributions(learned, 0, 0), learned.peers
    assert peers is not None
    truth = returns.truth
    levels = np.arange(1, EXPECTILES + 1) / (EXPECTILES + 1)
    exact = {
        "categorical": categorical_of(truth, peers.atoms),
        "quantile": quantiles_of(truth, QUANTILES),
        "expectile": impute(expectiles_of(truth, EXPECTILES), levels, peers.low, peers.high),
    }
    names = {"categorical": "categorical", "quantile": "quantile", "expectile": "expectile"}
    codes = {
        name: {
            "exact": round(wasserstein(exact[name], truth), 5),
            "learned": round(returns.distances[name], 5),
            "locations": np.round(returns.codes[name][0], 4).tolist(),
            "masses": np.round(returns.codes[name][1], 5).tolist(),
        }
        for name in names
    }
    steps = returns.codes["independent_steps"]
    codes["laplace, if steps were independent"] = {"learned": round(wasserstein(steps, truth), 5)}
    return {
        "truth": {"locations": np.round(truth[0], 4).tolist(), "masses": np.round(truth[1], 6).tolist()},
        "codes": codes,
    }


def _summary(rows: Sequence[Row]) -> Result:
    """Wasserstein-1 distance of each code from the true return, in reward: exact, and learned over the seeds."""
    summed: Result = {}
    for name, code in rows[0]["result"]["codes"].items():
        learned = [row["result"]["codes"][name]["learned"] for row in rows]
        summed[name] = {"exact": code.get("exact"), "learned": round(float(np.mean(learned)), 4), "low": min(learned),
                        "high": max(learned), "of": len(learned)}  # fmt: skip
    return summed


EXPERIMENT = Measurement(
    name="fig1_5",
    title="Figures 1 and 5: four codes of one return",
    question="How near do four codes come to the distribution of a return, exactly and learned?",
    parts=[{"seed": seed} for seed in range(SEEDS)],
    measure=_measure,
    summary=_summary,
)
