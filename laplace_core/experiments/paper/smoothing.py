"""Learning curves made smooth, as the paper's are."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np


def smoothed(returns: Sequence[float], reach: int) -> np.ndarray:
    """Convolution with a box: at each place the mean of ``reach`` neighbours on either side, as far as there are."""
    values, count = np.asarray(returns, dtype=float), len(returns)
    summed = np.concatenate([[0.0], np.cumsum(values)])
    low, high = np.maximum(np.arange(count) - reach, 0), np.minimum(np.arange(count) + reach + 1, count)
    return np.asarray((summed[high] - summed[low]) / (high - low))
