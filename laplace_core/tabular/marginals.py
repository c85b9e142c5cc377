"""A decoded tau-space as what it stands for: a law of the reward of each step."""

from __future__ import annotations

import numpy as np

_STEEPEST, _HALVINGS = 40.0, 50
"""Of the tilt, over the whole range of rewards: what is left at its other end is e^-40 of what there was."""


def marginals(tau_space: np.ndarray, midpoints: np.ndarray) -> np.ndarray:
    """Chances of every reward at every step, none below 0 and at most 1 together: what is left to 1 pays nothing.

    Masses below 0, which only an inverse can make, count as 0. Alone that would move the mean reward of the step by
    more than anything else an inverse does: where steps of -1 hide behind steps of +1, only the latter stay. So what is
    left of such a row is tilted, q proportional to p exp(c r), as the law closest to it in relative entropy with the
    mean and the total of the row. A row above 1 is rescaled to 1 likewise; one whose total is too small for its mean
    has a larger one, and one whose rewards are too small comes as near to it as they allow.

    Args:
        tau_space: of one action, ``(K, H-1)``.
        midpoints: reward of each column, ``(H-1,)``.

    Returns:
        ``(K, H-1)``.
    """
    chances = np.where(tau_space > 1e-9, tau_space, 0.0)
    totals = np.clip(tau_space.sum(axis=1), 0.0, 1.0)
    off = np.flatnonzero((tau_space < -1e-9).any(axis=1) | (chances.sum(axis=1) > 1.0 + 1e-9))
    chances[off] = _tilted(chances[off], totals[off], tau_space[off] @ midpoints, midpoints)
    return chances


def _tilted(chances: np.ndarray, totals: np.ndarray, means: np.ndarray, midpoints: np.ndarray) -> np.ndarray:
    """Rows ``(K, M)`` with these totals and, where it can be, means, ``(K,)``; by halving, as a mean grows with c."""
    span = float(np.ptp(midpoints)) or 1.0
    places, there = (midpoints - midpoints.mean()) / span, chances > 0
    farthest = np.where(
        means > 0, np.where(there, midpoints, 0.0).max(axis=1), np.where(there, midpoints, 0.0).min(axis=1)
    )
    least = np.divide(means, farthest, out=np.zeros(len(means)), where=farthest != 0)
    totals = np.clip(np.maximum(totals, least), 0.0, 1.0)

    def rows(tilt: np.ndarray) -> np.ndarray:
        weights = chances * np.exp(tilt[:, None] * places)
        return weights * (totals / np.maximum(weights.sum(axis=1), 1e-300))[:, None]

    low, high = np.full(len(chances), -_STEEPEST), np.full(len(chances), _STEEPEST)
    for _ in range(_HALVINGS):
        middle = (low + high) / 2.0
        below = rows(middle) @ midpoints < means
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return rows((low + high) / 2.0)
