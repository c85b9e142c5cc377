"""How sure a mean difference is, by drawing anew from what was measured (Efron 1979)."""

from __future__ import annotations

import numpy as np

DRAWS = 20_000


def interval(differences: np.ndarray, draws: int = DRAWS, seed: int = 0) -> list[float]:
    """95% interval of the mean of ``(agents, episodes)`` differences: agents are drawn, then episodes of each."""
    rng = np.random.default_rng(seed)
    agents, episodes = differences.shape
    means = np.empty(draws)
    for i in range(draws):
        drawn = differences[rng.integers(agents, size=agents)]
        means[i] = np.take_along_axis(drawn, rng.integers(episodes, size=drawn.shape), axis=1).mean()
    return np.quantile(means, [0.025, 0.975]).tolist()
