"""One rule for ties, wherever an action is chosen."""

from __future__ import annotations

import numpy as np

TIE_TOLERANCE = 1e-9


def greedy_action(values: np.ndarray, axis: int = -1) -> np.ndarray:
    """Index of the largest value along ``axis``; ties within 1e-9 go to the lowest index.

    The tolerance is relative to the best value once that exceeds 1, where rounding alone would otherwise
    decide between equal actions.
    """
    values = np.asarray(values, dtype=float)
    best = values.max(axis=axis, keepdims=True)
    scale = np.maximum(1.0, np.abs(best))
    return np.argmax(values >= best - TIE_TOLERANCE * scale, axis=axis)
