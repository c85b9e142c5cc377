"""Bootstrap intervals of means and interquartile means: samples redrawn from the measured ones (Efron 1979)."""

from __future__ import annotations

from itertools import combinations_with_replacement

import numpy as np
from scipy.special import factorial, ndtri, stdtrit
from scipy.stats import trim_mean

from laplace_core.errors import InputError

DRAWS = 20_000
MOST_SEEDS = 7
"""Of an interquartile band: 1,716 samples, where 10 seeds would have 92,378."""
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


def interquartile_band(curves: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Interquartile mean over a handful of seeds, and its 95% bootstrap band (Agarwal et al. 2021).

    The mean leaves out the lowest and the highest quarter of the seeds, rounded down. In place of random draws every
    sample with replacement is taken, with its probability: n seeds have (2n - 1 choose n) of them.

    Args:
        curves: ``(n, N)``, a row a seed, of at most ``MOST_SEEDS``.

    Returns:
        lower end, interquartile mean and upper end, ``(N,)`` each.
    """
    count = len(curves)
    if not 1 <= count <= MOST_SEEDS:
        raise InputError(f"{count} seeds; a bootstrap over all samples takes from 1 to {MOST_SEEDS}.")
    samples = np.array(list(combinations_with_replacement(range(count), count)))
    times = (samples[:, :, None] == np.arange(count)).sum(axis=1)  # how often each seed is in a sample
    chances = factorial(count) / factorial(times).prod(axis=1) / float(count) ** count
    means = trim_mean(curves[samples], 0.25, axis=1)
    order = np.argsort(means, axis=0, kind="stable")
    reached = np.cumsum(chances[order], axis=0)
    ranked = np.take_along_axis(means, order, axis=0)
    ends = [ranked[(reached < level - 1e-12).sum(axis=0), np.arange(ranked.shape[1])] for level in (0.025, 0.975)]
    return ends[0], trim_mean(curves, 0.25, axis=0), ends[1]
