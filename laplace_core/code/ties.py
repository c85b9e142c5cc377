"""One rule for ties in all choices of actions, and one floor below which a number is only rounding."""

from __future__ import annotations

import numpy as np

TIE_TOLERANCE = 1e-9
"""Two values that differ by this share of the better one are equal."""

ROUNDING = 1e-12
"""A number below this share of the terms that it was computed from is rounding: some 4,500 times the precision of
float64, which the products and solves of one study never lose, in Python or in JavaScript."""


def tie_size(best: np.ndarray | float, scale: np.ndarray | float) -> np.ndarray:
    """The largest difference of two values that count as equal, in the shape of ``best``.

    Args:
        best: the better value.
        scale: size of the terms that the values are sums of; terms that cancel leave their rounding behind.
    """
    return np.maximum(TIE_TOLERANCE * np.abs(best), ROUNDING * np.abs(scale))


def greedy_action(values: np.ndarray, axis: int = -1, scale: np.ndarray | float | None = None) -> np.ndarray:
    """Index of the largest value along ``axis``; ties (:func:`tie_size`) go to the lowest index.

    Args:
        scale: size of the terms that the values are sums of, a number or without ``axis``; default: the largest
            value in size.
    """
    values = np.asarray(values, dtype=float)
    best = values.max(axis=axis, keepdims=True)
    size = np.abs(values).max(axis=axis, keepdims=True)
    if scale is not None:
        given = np.asarray(scale, dtype=float)
        size = np.maximum(size, np.expand_dims(given, axis) if given.ndim else given)
    return np.argmax(values >= best - tie_size(best, size), axis=axis)
