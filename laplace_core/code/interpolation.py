"""Discounts that were never learned, put between those that were.

(1 - gamma) Q is a probability and varies smoothly with the logarithm of the time constant -1 / log gamma; between two
neighbours it is drawn as a straight line there. A mean of two values that some future could have is again such a
value: probabilities stay probabilities, and what falls with theta goes on falling. On trained networks a cubic is no
better (``python -m laplace_core report interpolation``), for their neighbours differ by their errors.

Nothing is learned in this way. What is added is a mean of what is there, and only weighs it otherwise.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from laplace_core.code.gamma_space import GammaSpace
from laplace_core.errors import InputError

MOST_ADDED = 3
"""Between any two neighbours."""


def log_times(gammas: np.ndarray) -> np.ndarray:
    """log of the time constants -1 / log gamma, in steps, shape of ``gammas``."""
    return np.log(-1.0 / np.log(gammas))


def with_between(gammas: np.ndarray, count: int) -> np.ndarray:
    """Discounts ``(G,)`` and ``count`` more in every gap, evenly in log time; ``(G + (G - 1) count,)``.

    Those that were there, at every (count + 1)-th place, keep their very values.

    Raises:
        InputError: count outside 0..3.
    """
    if not 0 <= count <= MOST_ADDED:
        raise InputError(f"{count} discounts between neighbours; it must be from 0 to {MOST_ADDED}.")
    gammas = np.asarray(gammas, dtype=float)
    places = np.linspace(0.0, gammas.size - 1, gammas.size + (gammas.size - 1) * count)
    times = np.interp(places, np.arange(gammas.size), log_times(gammas))
    finer = np.exp(-1.0 / np.exp(times))
    finer[:: count + 1] = gammas
    return finer


def mixing(gammas: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """B with Q at ``wanted`` = B Q at ``gammas``, ``(W, G)``: linear in log time of (1 - gamma) Q.

    Raises:
        InputError: a discount outside those that were learned.
    """
    gammas, wanted = np.asarray(gammas, dtype=float), np.asarray(wanted, dtype=float)
    if wanted.min() < gammas[0] or wanted.max() > gammas[-1]:
        raise InputError(f"discounts can be added from {gammas[0]:.4g} to {gammas[-1]:.4g} only.")
    shares = np.array([np.interp(log_times(wanted), log_times(gammas), one) for one in np.eye(gammas.size)]).T
    return shares * (1.0 - gammas) / (1.0 - wanted)[:, None]


def with_added(space: GammaSpace, count: int) -> GammaSpace:
    """A gamma-space with ``count`` interpolated discounts between any two neighbours."""
    if not count:
        return space
    gammas = with_between(space.gammas, count)
    mix = mixing(space.gammas, gammas)
    return replace(space, values=mix @ space.values, constant=space.constant @ mix.T, gammas=gammas)


def left_out(values: np.ndarray, gammas: np.ndarray) -> np.ndarray:
    """The error of interpolation at each learned discount that is left out: (1 - gamma) times the error.

    The gap is then twice as wide, so this is more than what is missed inside a gap.

    Args:
        values: ``(..., G, n)``, gamma-space.

    Returns:
        ``(..., G - 2, n)``, a probability each, for every discount but the outermost two.
    """
    gammas = np.asarray(gammas, dtype=float)
    off = [
        mixing(gammas[[i - 1, i + 1]], gammas[i : i + 1]) @ values[..., [i - 1, i + 1], :] - values[..., [i], :]
        for i in range(1, gammas.size - 1)
    ]
    if not off:
        return np.zeros((*values.shape[:-2], 0, values.shape[-1]))
    return np.abs(np.concatenate(off, axis=-2)) * (1.0 - gammas[1:-1, None])
