"""Timelines drawn directly, without a world: what the neural inverse learns from and grids are designed for.

An episode lasts for ever, ends with a constant chance, after a certain number of steps, or around it. While it lasts,
its reward has a distribution that stays, changes from phase to phase, alternates or drifts; single steps may differ,
and the last step may pay an extra reward. A timeline is a mixture of up to three such episodes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from laplace_core.inverse.transform import transform_matrix


@dataclass(frozen=True, eq=False)
class Timelines:
    """N timelines, and how they go on after their last row.

    Attributes:
        masses: ``(N, K, B)``, probability of each bin at each step.
        beyond: ``(N, C, B)``, masses at row K of each of the C components of a mixture.
        endings: ``(N, C)``, their chance of ending at each later step.
    """

    masses: np.ndarray
    beyond: np.ndarray
    endings: np.ndarray

    def transformed(self, gammas: np.ndarray) -> np.ndarray:
        """Masses over the discounts, ``(N, G, B)``; what lies after the last row is a geometric series."""
        steps = self.masses.shape[1]
        later = gammas[:, None, None] ** steps / (1.0 - gammas[:, None, None] * (1.0 - self.endings))  # (G, N, C)
        rows = np.tensordot(self.masses, transform_matrix(gammas, steps), axes=(1, 1))  # (N, B, G), by one product
        return np.swapaxes(rows, 1, 2) + np.einsum("gnc,ncb->ngb", later, self.beyond)


MOST_COMPONENTS = 3


def draw_timelines(rng: np.random.Generator, count: int, steps: int, bins: int) -> Timelines:
    """``count`` random timelines of ``steps`` rows, whose rewards lie in at most five of the ``bins``."""
    masses = np.zeros((count, steps, bins))
    beyond, endings = np.zeros((count, MOST_COMPONENTS, bins)), np.zeros((count, MOST_COMPONENTS))
    for n in range(count):
        components = int(rng.choice([1, 2, 3], p=[0.6, 0.25, 0.15]))
        used = rng.choice(bins, min(bins, int(rng.integers(1, 6))), replace=False)
        weights = rng.dirichlet(np.ones(components))
        for c in range(components):
            alive, endings[n, c] = _survival(rng, steps)
            paid = _phases(rng, steps + 1, used.size)
            rows = alive[:, None] * paid
            if rng.random() < 0.4:  # the last step pays something of its own
                last = alive - np.append(alive[1:], alive[-1] * (1.0 - endings[n, c]))
                rows = (alive - last)[:, None] * paid
                rows[:, rng.integers(used.size)] += last
            masses[n][:, used] += weights[c] * rows[:-1]
            beyond[n, c, used] = weights[c] * rows[-1]
    if bins > 2:  # the activation blurs a reward over neighbouring bins
        blurred = rng.random(count) < 0.7
        for n in np.flatnonzero(blurred).tolist():
            blur = _blur(rng, bins)
            masses[n], beyond[n] = masses[n] @ blur, beyond[n] @ blur
    return Timelines(masses, beyond, endings)


def _log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def _survival(rng: np.random.Generator, steps: int) -> tuple[np.ndarray, float]:
    """Survival at rows 0 to K, ``(K+1,)``, and the chance of ending after that."""
    tau = np.arange(steps + 1)
    kind = rng.choice(4, p=[0.2, 0.25, 0.35, 0.2])
    if kind == 0:
        return np.ones(steps + 1), 0.0
    if kind == 1:
        ending = 1.0 / _log_uniform(rng, 1.1, 5.0 * steps)
        return (1.0 - ending) ** tau, ending
    length = _log_uniform(rng, 1.0, 2.0 * steps)
    if kind == 2:
        return np.where(tau < np.ceil(length), 1.0, 0.0), 1.0 / steps
    width = length * rng.uniform(0.05, 0.5)
    alive = 1.0 / (1.0 + np.exp(np.clip((tau - length) / width, -50.0, 50.0)))
    alive = np.append(1.0, alive[1:])
    ending = 1.0 - alive[-1] / alive[-2] if alive[-2] > 0.0 else 1.0
    return alive, float(np.clip(ending, 0.0, 1.0))


def _distribution(rng: np.random.Generator, bins: int) -> np.ndarray:
    return np.eye(bins)[rng.integers(bins)] if rng.random() < 0.6 else rng.dirichlet(np.ones(bins))


def _phases(rng: np.random.Generator, steps: int, bins: int) -> np.ndarray:
    """Distribution of the reward of an episode that still runs, ``(steps, bins)``."""
    changes = sorted({int(_log_uniform(rng, 1.0, steps)) for _ in range(rng.choice(5, p=[0.3, 0.3, 0.2, 0.1, 0.1]))})
    paid = np.zeros((steps, bins))
    for first, last in zip([0, *changes], [*changes, steps], strict=True):
        paid[first:last] = _distribution(rng, bins)
    if rng.random() < 0.15:  # alternating
        paid[:: int(rng.integers(2, 9))] = _distribution(rng, bins)
    if rng.random() < 0.2:  # drifting
        share = np.exp(-np.arange(steps) / _log_uniform(rng, 1.0, steps))[:, None]
        paid = share * _distribution(rng, bins) + (1.0 - share) * paid
    for _ in range(rng.choice(4, p=[0.5, 0.25, 0.15, 0.1])):  # single steps
        paid[int(_log_uniform(rng, 1.0, steps)) - 1] = _distribution(rng, bins)
    return paid


def _blur(rng: np.random.Generator, bins: int) -> np.ndarray:
    """Rows that share a mass between its bin and its neighbours, ``(bins, bins)``; each sums to 1."""
    side = rng.uniform(0.0, 0.35, size=2)
    blur = np.eye(bins) * (1.0 - side.sum()) + np.eye(bins, k=1) * side[0] + np.eye(bins, k=-1) * side[1]
    blur[0, 0] += side[1]
    blur[-1, -1] += side[0]
    return blur
