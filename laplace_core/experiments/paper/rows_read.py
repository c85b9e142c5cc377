"""Returns of an agent that acts on its decoded timeline until T, with rows rescaled to 1 and with rows left alone.

All else is what the library does, but for the hard deadline, which is the paper's: as many rows as time to go, the
trained discounts, open ends. Alpha is chosen on starts of its own for each reading, as in table 1. All agents start
alike, so that differences between them are paired.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.acting.evaluation import FIRST_SEED, evaluate, played
from laplace_core.agents.capabilities import HasGammaSpace
from laplace_core.errors import InputError
from laplace_core.experiments.paper.result_files import BEST
from laplace_core.experiments.paper.table1 import ALPHAS, TUNING_SEED, by_decoding
from laplace_core.training.checkpoint import load_checkpoint

EPISODES, TUNED = 100, 20
FAULTS = {"rescaled": ("rescaled", "hard"), "left alone": ("hard",)}
"""Names in :data:`.table1.FAULTS` by the reading."""


def returns_by_rows(folder: Path, horizons: Sequence[int]) -> dict[str, Any]:
    """By ``T 50`` and so on: ``returns`` of greedy episodes, and of both readings with their alpha.

    Raises:
        InputError: no agent with a gamma-space.
    """
    loaded = load_checkpoint(folder / BEST)
    agent = loaded.agent
    if not isinstance(agent, HasGammaSpace):
        raise InputError(f"{folder} holds no agent with a gamma-space, which could be decoded.")
    acting = float(agent.gammas[agent.acting_head])
    found: dict[str, Any] = {}
    for length in horizons:

        def returns(reading: str, alpha: float, starts: range, length: int = length) -> np.ndarray:
            choose = by_decoding(agent, acting, length, FAULTS[reading], alpha=alpha)
            return played(choose, loaded.environment, starts, length).returns

        greedy = evaluate(agent, loaded.environment, episodes=EPISODES, horizon=length)
        found[f"T {length}"] = {"greedy": {"returns": np.round(greedy.returns, 2).tolist()}}
        for reading in FAULTS:
            tuning = range(TUNING_SEED, TUNING_SEED + TUNED)
            tuned = {alpha: float(returns(reading, alpha, tuning).mean()) for alpha in ALPHAS}
            best = max(tuned, key=lambda alpha: tuned[alpha])
            reported = returns(reading, best, range(FIRST_SEED, FIRST_SEED + EPISODES))
            found[f"T {length}"][reading] = {"alpha": best, "returns": np.round(reported, 2).tolist()}
    return found
