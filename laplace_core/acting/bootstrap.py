"""Bootstrap intervals of a mean difference: means of samples redrawn from the measured ones (Efron 1979)."""

from __future__ import annotations

import numpy as np
from scipy.special import ndtri, stdtrit

DRAWS = 20_000
_AT_ONCE = 1_000  # draws: their numbers take some 4 MB for 500 episodes


def interval(differences: np.ndarray, draws: int = DRAWS, seed: int = 0) -> list[float]:
    """95% interval of the mean of ``(agents, starts)`` differences, every agent from the same starts.

    Agents are drawn, each with all it did, and starts are drawn, each for all agents: what several agents share by
    starting alike is not averaged away by having several. Means drawn from a handful of agents lie closer together than
    they should: their distances from the mean are stretched by t's quantile for so many over the normal one, and by
    the root of n / (n - 1) (Hesterberg 2015, on percentile intervals of small samples).
    """
    rng = np.random.default_rng(seed)
    agents, starts = differences.mean(axis=1), differences.mean(axis=0)
    means = starts.mean() + _off_the_mean(starts, draws, rng)
    if len(agents) > 1:
        degrees = len(agents) - 1
        stretch = stdtrit(degrees, 0.975) / ndtri(0.975) * np.sqrt(len(agents) / degrees)
        means += stretch * _off_the_mean(agents, draws, rng)
    return np.quantile(means, [0.025, 0.975]).tolist()


def mean_interval(values: np.ndarray, draws: int = DRAWS, seed: int = 0) -> list[float]:
    """95% interval of the mean of ``(N,)`` independent values."""
    off = _off_the_mean(values, draws, np.random.default_rng(seed))
    return np.quantile(values.mean() + off, [0.025, 0.975]).tolist()


def _off_the_mean(values: np.ndarray, draws: int, rng: np.random.Generator) -> np.ndarray:
    """Bootstrap means of values ``(N,)`` less their own mean, ``(draws,)``; many draws at a time."""
    parts = [values[rng.integers(len(values), size=(_AT_ONCE, len(values)))].mean(axis=1)
             for _ in range(-(-draws // _AT_ONCE))]  # fmt: skip
    return np.concatenate(parts)[:draws] - values.mean()
