"""How sure a mean difference is, by drawing anew from what was measured (Efron 1979)."""

from __future__ import annotations

import numpy as np

DRAWS = 20_000
_AT_ONCE = 1_000  # draws: their numbers take some 4 MB for 500 episodes


def interval(differences: np.ndarray, draws: int = DRAWS, seed: int = 0) -> list[float]:
    """95% interval of the mean of ``(agents, episodes)`` differences: agents are drawn, then episodes of each."""
    rng = np.random.default_rng(seed)
    agents, episodes = differences.shape
    means = np.empty(draws)
    for i in range(draws):
        drawn = differences[rng.integers(agents, size=agents)]
        means[i] = np.take_along_axis(drawn, rng.integers(episodes, size=drawn.shape), axis=1).mean()
    return np.quantile(means, [0.025, 0.975]).tolist()


def mean_interval(values: np.ndarray, draws: int = DRAWS, seed: int = 0) -> list[float]:
    """95% interval of the mean of ``(N,)`` independent values, many draws at a time."""
    rng = np.random.default_rng(seed)
    parts = [values[rng.integers(len(values), size=(_AT_ONCE, len(values)))].mean(axis=1)
             for _ in range(-(-draws // _AT_ONCE))]  # fmt: skip
    return np.quantile(np.concatenate(parts)[:draws], [0.025, 0.975]).tolist()
