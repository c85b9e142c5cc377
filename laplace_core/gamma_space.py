"""Gamma-space: what is learned for one state, from a reward-indicator basis, with or without error."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from laplace_core.encoding import activation
from laplace_core.noise import normal_noise


@dataclass(frozen=True, eq=False)
class GammaSpace:
    """What was learned for one state: Q[a, g, h] and the constant channel Q[a, g].

    Attributes:
        values: ``(A, G, H)``, never increasing with h if exact.
        constant: ``(A, G)``, the constant channel: discounted steps still to come.
    """

    values: np.ndarray
    constant: np.ndarray
    gammas: np.ndarray
    thetas: np.ndarray

    @property
    def differences(self) -> np.ndarray:
        """Z[a, g, h] = Q[a, g, h] - Q[a, g, h+1], at the midpoints, shape ``(A, G, H-1)``."""
        return -np.diff(self.values, axis=-1)


def encode(basis: np.ndarray, rewards: np.ndarray, gammas: np.ndarray, thetas: np.ndarray, slope: float) -> GammaSpace:
    """gamma_space = W @ f for a reward-indicator basis ``(A, G, V)``; all that a change of slope costs."""
    return GammaSpace(basis @ activation(rewards, thetas, slope), basis.sum(axis=-1), gammas, thetas)


def with_noise(gamma_space: GammaSpace, noise: float, seed: int) -> GammaSpace:
    """Gamma-space as a learner with a random error holds it.

    Every value at discount gamma gets an independent normal error of ``noise`` / (1 - gamma), the constant channel
    too: ``noise`` is the standard deviation of (1 - gamma) Q, which is a probability.
    """
    if not noise:
        return gamma_space
    scale = noise / (1.0 - gamma_space.gammas)
    values, constant = gamma_space.values, gamma_space.constant
    values = values + scale[:, None] * normal_noise(seed, values.shape)
    constant = constant + scale * normal_noise(seed, constant.shape, skip=values.size)
    return replace(gamma_space, values=values, constant=constant)
