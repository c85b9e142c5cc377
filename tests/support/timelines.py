"""Random feasible timelines, and the masses over the discounts that they leave."""

from __future__ import annotations

import numpy as np


def timelines(rng: np.random.Generator, actions: int, steps: int, bins: int) -> np.ndarray:
    """Masses ``(actions, steps, bins)`` that add up to a survival which begins at 1 and never rises."""
    ends = rng.dirichlet(np.full(steps, 0.3), size=actions)
    survival = np.cumsum(ends[:, ::-1], axis=1)[:, ::-1]
    return rng.dirichlet(np.full(bins, 0.3), size=(actions, steps)) * survival[..., None]


def noisy_masses(masses: np.ndarray, deviations: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Masses ``(..., G, B)`` whose tails have independent errors."""
    return masses - np.diff(deviations[:, None] * rng.normal(size=masses.shape), axis=-1, append=0.0)
