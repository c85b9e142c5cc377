"""A few channels that stand for all sensitivities: the constant one, and means over neighbouring sensitivities.

A mean of sensitivities' values is the transform of a mean of their timelines: between 0 and survival, and the less the
higher its sensitivities. Tests and bounds work on these few timelines in place of one a sensitivity. Noise that is
independent between sensitivities averages out; what tells one reward from the next within a mean is lost.
"""

from __future__ import annotations

import numpy as np

from laplace_core.code.gamma_space import GammaSpace


def channel_weights(thetas: np.ndarray, layers: int) -> tuple[np.ndarray, np.ndarray]:
    """How much each sensitivity counts in each mean, ``(layers, H)`` with rows of sum 1, and the widths that they stand
    for, ``(layers,)``, in units of reward: theta_1 + their sum is theta_H (trapezoid rule).
    """
    widths = np.gradient(thetas)
    widths[[0, -1]] /= 2.0  # half a spacing at either end
    groups = np.array_split(np.arange(thetas.size), min(layers, thetas.size))
    weights = np.zeros((len(groups), thetas.size))
    for row, group in zip(weights, groups, strict=True):
        row[group] = widths[group]
    totals = weights.sum(axis=1)
    return weights / totals[:, None], totals


def channels_of(values: np.ndarray, constant: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """The constant channel and then the means, ``(..., layers + 1, G)``, of values ``(..., G, H)``."""
    means = np.swapaxes(values @ weights.T, -1, -2)
    return np.concatenate([constant[..., None, :], means], axis=-2)


def channel_gains(weights: np.ndarray, *, independent: bool) -> np.ndarray:
    """Standard deviation of each channel's error over that of one value, ``(layers + 1,)``.

    Args:
        independent: whether errors of different sensitivities are. If not, as those of one network, which errs alike at
            neighbouring sensitivities, they are taken to be the same within a mean, and independent between two means
            and of the constant channel. The same error at all of them would cancel in every difference of two: where
            the ends are closed, no noise would be left at all.
    """
    means = np.linalg.norm(weights, axis=1) if independent else np.ones(len(weights))
    return np.concatenate([[1.0], means])


def layered(gamma_space: GammaSpace, layers: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Channels of a gamma-space ``(A, layers + 1, G)``, with their weights and widths."""
    weights, widths = channel_weights(gamma_space.thetas, layers)
    return channels_of(gamma_space.values, gamma_space.constant, weights), weights, widths
