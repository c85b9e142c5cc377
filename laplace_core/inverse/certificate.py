"""Certified decisions: which of two actions is worth more at a horizon, whatever feasible timeline fits the values.

Given the values of an action up to their noise, many timelines are possible. The smallest and the largest V_T over all
of them are the optima of a linear programme; no alpha is involved. If the smallest of one action is above the largest
of the other, the first is better, and the chance that this is wrong is at most 1 - confidence.

A programme over all masses would be large. The mean of the sensitivities' channels above the lowest one,

    v = sum_h w_h Q_h / sum_h w_h,  w_h the widths of the trapezoid rule,

is itself the transform of a timeline, 0 <= v_tau <= survival_tau, and E[r_tau] = theta_1 survival_tau + sum_h w_h v_tau
up to the quantisation of rewards (see :func:`quantisation`). So two timelines an action are enough: survival, which
starts at 1 and never rises, and v below it. More ``layers`` cut the sensitivities into several such means, each below
the one before.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from laplace_core.code.encoding import sigmoid
from laplace_core.code.gamma_space import GammaSpace
from laplace_core.errors import InputError
from laplace_core.inverse.axis import Axis, axis_of, growth_for
from laplace_core.inverse.channels import channel_gains, layered

CONFIDENCE = 0.99
LAYERS = 3


@dataclass(frozen=True, eq=False)
class Certificate:
    """What all feasible timelines that fit agree on.

    Attributes:
        low: smallest V_T of each action, ``(A,)``; nan where no feasible timeline fits its values.
        high: the largest, ``(A,)``.
        confidence: probability that all of these bounds hold at once.
        quantisation: how far a reward can be from what the sensitivities count it as, in units of reward.
    """

    low: np.ndarray
    high: np.ndarray
    confidence: float
    quantisation: float

    @property
    def consistent(self) -> bool:
        """Whether some feasible timeline fits the values of every action."""
        return bool(np.isfinite(self.low).all())

    def margin(self, a: int, b: int) -> tuple[float, float]:
        """Smallest and largest V_T[a] - V_T[b]."""
        return float(self.low[a] - self.high[b]), float(self.high[a] - self.low[b])

    def better(self, a: int, b: int) -> int | None:
        """The action that is certainly worth more; None if that is undecided."""
        smallest, largest = self.margin(a, b)
        return a if smallest > 0.0 else b if largest < 0.0 else None

    @property
    def best(self) -> int | None:
        """The action that is certainly worth at least as much as every other; None if that is undecided."""
        for a in range(len(self.low)):
            if all(self.better(a, b) == a for b in range(len(self.low)) if b != a):
                return a
        return None


def certify(
    gamma_space: GammaSpace,
    horizon: int,
    deviations: np.ndarray,
    *,
    value_gamma: float = 0.99,
    slope: float | None = None,
    rewards: tuple[float, float] | None = None,
    confidence: float = CONFIDENCE,
    independent: bool = True,
    layers: int = LAYERS,
) -> Certificate:
    """Bounds on V_T of every action of a gamma-space, all of which hold at once with the given confidence.

    Args:
        horizon: T, whole steps of the world.
        deviations: ``(G,)``, standard deviation of the error of one value at each discount; errors are normal.
        slope: of the activation, where ``gamma_space`` does not know it by its places; without either, the smallest
            quantisation that any slope has is not known, and half a spacing is taken.
        rewards: smallest and largest reward that the world has; default: the outermost sensitivities.
        independent: whether errors of different sensitivities are independent. If not, they are taken to be the same
            at all of them, which is the worst case.
        layers: means of sensitivities, at least 1.

    Raises:
        InputError: a horizon, deviations, confidence or layers that make no sense.
    """
    _check(gamma_space, horizon, deviations, confidence=confidence, layers=layers)
    axis = axis_of(gamma_space.gammas, horizon, growth=growth_for(deviations, gamma_space.gammas))
    channels, weights, widths = layered(gamma_space, layers)
    gains = channel_gains(weights, independent=independent)
    fit = _Fit(axis, deviations, gains, len(channels), confidence)
    rounding = quantisation(gamma_space.thetas, _slope(gamma_space, slope), rewards)
    discounts = value_gamma ** axis.steps[:horizon]
    sizes = np.concatenate([gamma_space.thetas[:1], widths])
    low, high = np.full(len(channels), np.nan), np.full(len(channels), np.nan)
    for a, values in enumerate(channels):
        bounds = fit.bounds(values, discounts, sizes, rounding)
        if bounds is not None:
            low[a], high[a] = bounds
    return Certificate(low, high, confidence, rounding)


def _slope(gamma_space: GammaSpace, slope: float | None) -> np.ndarray | None:
    """slope * theta, ``(H,)``."""
    return gamma_space.places if slope is None else slope * gamma_space.thetas


def quantisation(
    thetas: np.ndarray, places: np.ndarray | None, rewards: tuple[float, float] | None = None
) -> float:  # fmt: skip
    """Largest |theta_1 + sum_h w_h f_h(r) - r| over rewards r, in units of reward.

    Args:
        places: slope * theta, ``(H,)``; None where it is not known, and then half of the widest spacing is returned.
        rewards: smallest and largest r; default: the outermost thetas.
    """
    if places is None:
        return float(np.diff(thetas).max() / 2.0)
    low, high = rewards or (float(thetas[0]), float(thetas[-1]))
    r = np.linspace(low, high, 4_001)
    at = np.interp(r, thetas, places)
    below, above = r < thetas[0], r > thetas[-1]
    first, last = np.diff(places)[[0, -1]] / np.diff(thetas)[[0, -1]]
    at[below], at[above] = places[0] + (r[below] - thetas[0]) * first, places[-1] + (r[above] - thetas[-1]) * last
    active = sigmoid(at[:, None] - places)
    counted = thetas[0] + (active[:, 1:] + active[:, :-1]) / 2.0 @ np.diff(thetas)
    return float(np.abs(counted - r).max())


class _Fit:
    """The linear programme of one action: constraints that do not depend on its values."""

    def __init__(self, axis: Axis, deviations: np.ndarray, gains: np.ndarray, actions: int, confidence: float) -> None:
        from scipy.sparse import bmat, eye, kron, vstack  # slow to import
        from scipy.special import ndtri

        count, stretches = len(axis.size), len(axis.first)
        channels = len(gains)
        # Rotated to the singular vectors, whitened errors stay independent and of variance 1, and each number says as
        # much about the timeline as it can. Those that say less than the noise are left out, by the transform alone.
        U, s, Vt = np.linalg.svd(axis.transform / deviations[:, None], full_matrices=False)
        rows = s[:, None] * Vt
        reach = np.abs(rows).sum(axis=1)
        kept = [np.flatnonzero(reach > gain) for gain in gains]
        tests = 2 * actions * sum(map(len, kept))
        self.quantile = float(ndtri(1.0 - (1.0 - confidence) / tests))
        self.rotation = [U[:, k].T / deviations / (gain * self.quantile) for k, gain in zip(kept, gains, strict=True)]
        blocks = [rows[k] / (gain * self.quantile) for k, gain in zip(kept, gains, strict=True)]
        data = bmat([[b if i == j else None for j in range(channels)] for i, b in enumerate(blocks)])
        rising = eye(stretches - 1, count, k=1) - eye(stretches - 1, count)
        above = kron(eye(channels - 1, channels, k=1) - eye(channels - 1, channels), eye(count))
        self.system = vstack([data, -data, bmat([[rising, kron(np.zeros((1, channels - 1)), rising)]]), above]).tocsr()
        self.count, self.channels = count, channels

    def bounds(
        self, values: np.ndarray, discounts: np.ndarray, sizes: np.ndarray, rounding: float
    ) -> tuple[float, float] | None:
        """Smallest and largest value, or None if no feasible timeline fits the ``values``, ``(channels, G)``."""
        from scipy.optimize import linprog  # slow to import

        aims = np.concatenate([turn @ channel for turn, channel in zip(self.rotation, values, strict=True)])
        right = np.concatenate([aims + 1.0, 1.0 - aims, np.zeros(self.system.shape[0] - 2 * len(aims))])
        limits = [(0.0, 1.0)] * (self.count * self.channels)
        limits[0] = (1.0, 1.0)  # the first step happens
        ends = []
        for sign in (1.0, -1.0):
            weights = np.zeros((self.channels, self.count))
            weights[:, : len(discounts)] = np.outer(sizes, discounts)
            weights[0, : len(discounts)] -= sign * rounding * discounts
            found = linprog(sign * weights.ravel(), A_ub=self.system, b_ub=right, bounds=limits, method="highs")
            if found.status == 2:
                return None
            ends.append(sign * found.fun if found.status == 0 else -sign * np.inf)
        return ends[0], ends[1]


def _check(
    gamma_space: GammaSpace, horizon: int, deviations: np.ndarray, *, confidence: float, layers: int
) -> None:  # fmt: skip
    if horizon < 1 or horizon != int(horizon):
        raise InputError(f"the horizon is {horizon:g}; a certificate needs a whole number of steps, at least 1.")
    deviations = np.asarray(deviations)
    if deviations.shape != gamma_space.gammas.shape or not np.all(np.isfinite(deviations) & (deviations > 0)):
        raise InputError(f"deviations must be {gamma_space.gammas.size} numbers above 0, one for each discount.")
    if not 0.0 < confidence < 1.0:
        raise InputError(f"confidence is {confidence:g}; it must lie between 0 and 1.")
    if layers < 1:
        raise InputError(f"layers is {layers}; it must be at least 1.")
