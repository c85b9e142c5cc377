"""Discount grids, reward sensitivities and the activation between them.

The Laplace code learns one value for every discount ``gamma`` and every reward
threshold ``theta``; this module makes both grids and the activation
``f_h(r) = sigmoid(slope * (r - theta_h))`` that a threshold answers a reward with
(paper, section 3 and Eq. 9).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from laplace_core.errors import InputError

PAPER_GAMMAS = (0.01, 0.108, 0.206, 0.304, 0.402, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.81, 0.87, 0.93, 0.99)
"""Five linearly spaced discounts in each range of the paper's multiplexer (section 3.3)."""

GAMMA_SPACINGS = ("inverse-log", "log", "linear", "paper")
THETA_SPACINGS = ("uniform", "gaussian", "asinh")
THETA_SCALE_HELP = (
    "Standard deviation of gaussian spacing, or the reward where asinh turns logarithmic; 0 follows the range."
)


def discount_grid(count: int, spacing: str = "inverse-log", low: float = 0.01, high: float = 0.99) -> np.ndarray:
    """Discounts in increasing order, shape ``(count,)``, each inside (0, 1).

    ``inverse-log`` is uniform in 1/log(gamma), i.e. in the time constant (paper, 2.2);
    ``log`` has log-spaced time constants -1/log(gamma); ``linear`` is uniform in gamma;
    ``paper`` is the fixed grid ``PAPER_GAMMAS`` and ignores the other arguments.

    Raises:
        InputError: unknown spacing, fewer than two discounts, or bounds outside 0 < low < high < 1.
    """
    if spacing not in GAMMA_SPACINGS:
        raise InputError(f"spacing {spacing!r} is not one of {', '.join(GAMMA_SPACINGS)}.")
    if spacing == "paper":
        return np.array(PAPER_GAMMAS)
    if count < 2:
        raise InputError(f"gammas is {count}; a discount grid needs at least 2.")
    if not 0.0 < low < high < 1.0:
        raise InputError(f"discounts must satisfy 0 < gamma-min < gamma-max < 1, not {low!r} and {high!r}.")
    if spacing == "linear":
        grid = np.linspace(low, high, count)
    elif spacing == "inverse-log":
        grid = np.exp(1.0 / np.linspace(1.0 / np.log(low), 1.0 / np.log(high), count))
    else:
        grid = np.exp(-1.0 / np.geomspace(-1.0 / np.log(low), -1.0 / np.log(high), count))
    grid[[0, -1]] = low, high  # the round trip through the logarithm may miss the bounds by an ulp
    if not np.all(np.diff(grid) > 0):
        raise InputError(
            f"{count} discounts do not fit between {low!r} and {high!r}: move gamma-min and gamma-max apart."
        )
    return grid


def sensitivity_grid(
    count: int, low: float, high: float, spacing: str = "uniform", scale: float | None = None
) -> np.ndarray:
    """Reward thresholds in increasing order, shape ``(count,)``, from ``low`` to ``high``.

    ``uniform``; ``gaussian`` puts them at the quantiles of a normal law around the middle of the
    range (paper B.3), cut at the range's ends; ``asinh`` is uniform in asinh(theta / scale), dense near zero.

    Args:
        scale: in units of reward. ``gaussian``: the standard deviation (default: a quarter of the range).
            ``asinh``: where the spacing turns from linear to logarithmic
            (default: a hundredth of the largest bound).

    Raises:
        InputError: unknown spacing, fewer than two thresholds, empty range, or scale <= 0.
    """
    if spacing not in THETA_SPACINGS:
        raise InputError(f"theta spacing {spacing!r} is not one of {', '.join(THETA_SPACINGS)}.")
    if count < 2:
        raise InputError(f"thetas is {count}; at least 2 sensitivities are needed.")
    if not (np.isfinite(low) and np.isfinite(high) and low < high):
        raise InputError(f"theta-min must be below theta-max, both finite, not {low!r} and {high!r}.")
    if scale is not None and not (np.isfinite(scale) and scale > 0):
        raise InputError(f"theta scale must be positive, not {scale:g}.")
    if spacing == "uniform":
        grid = np.linspace(low, high, count)
    elif spacing == "asinh":
        scale = theta_scale(low, high, spacing, scale)
        grid = scale * np.sinh(np.linspace(np.arcsinh(low / scale), np.arcsinh(high / scale), count))
    else:
        from scipy.special import ndtr, ndtri  # slow to import, and only needed here

        middle, scale = (low + high) / 2.0, theta_scale(low, high, spacing, scale)
        first, last = ndtr((np.array([low, high]) - middle) / scale)
        grid = middle + scale * ndtri(np.linspace(first, last, count))
    grid[[0, -1]] = low, high
    if not np.all(np.diff(grid) > 0):
        raise InputError(
            f"{count} sensitivities do not fit between {low!r} and {high!r} at spacing {spacing!r}: widen the range"
            f"{' or the theta scale' if scale else ''}."
        )
    return grid


def theta_scale(low: float, high: float, spacing: str, scale: float | None = None) -> float:
    """The scale of ``gaussian`` or ``asinh`` spacing, in units of reward; see :func:`sensitivity_grid`."""
    if scale is not None:
        return scale
    return (high - low) / 4.0 if spacing == "gaussian" else max(abs(low), abs(high)) / 100.0


def sigmoid(x: np.ndarray | float) -> np.ndarray:
    """1 / (1 + exp(-x)) without overflow, to full precision in both tails, in the shape of ``x``."""
    small = np.exp(-np.abs(x))
    return np.where(np.asarray(x) >= 0, 1.0, small) / (1.0 + small)


def theta_midpoints(thetas: np.ndarray) -> np.ndarray:
    """Midpoints between neighbouring thresholds, shape ``(H-1,)`` (paper, below Eq. 9)."""
    thetas = np.asarray(thetas, dtype=float)
    return (thetas[1:] + thetas[:-1]) / 2.0


def activation(rewards: np.ndarray, thetas: np.ndarray, slope: float) -> np.ndarray:
    """f_h(r) = sigmoid(slope * (r - theta_h)), shape ``rewards.shape + (H,)``.

    ``slope`` is in 1/reward; the paper's Heaviside step is the limit slope -> infinity (``np.inf`` is
    accepted and gives 1/2 at r = theta, the sigmoid's own limit).
    """
    if not slope > 0:
        raise InputError(f"slope must be positive, not {slope:g}.")
    distance = np.subtract.outer(np.asarray(rewards, dtype=float), np.asarray(thetas, dtype=float))
    if np.isinf(slope):
        return np.heaviside(distance, 0.5)
    return sigmoid(slope * distance)


def bin_masses(rewards: np.ndarray, thetas: np.ndarray, slope: float) -> np.ndarray:
    """f_h(r) - f_{h+1}(r): the mass a reward leaves at each midpoint, shape ``rewards.shape + (H-1,)``."""
    return -np.diff(activation(rewards, thetas, slope), axis=-1)


_BLOCK = 1_000_000
"""Numbers of a matrix of rewards by sensitivities that are made at a time where only its products are wanted."""


def encoded(weights: np.ndarray, rewards: np.ndarray, thetas: np.ndarray, slope: float) -> np.ndarray:
    """weights @ activation: what rewards leave at each sensitivity, ``(..., V)`` to ``(..., H)``, block by block."""
    parts = [weights @ activation(rewards, part, slope) for part in _blocks(thetas, rewards.size)]
    return parts[0] if len(parts) == 1 else np.concatenate(parts, axis=-1)


def smeared(weights: np.ndarray, rewards: np.ndarray, thetas: np.ndarray, slope: float) -> np.ndarray:
    """weights @ bin_masses: what rewards leave at each midpoint, ``(..., V)`` to ``(..., H-1)``, block by block."""
    parts = [weights @ bin_masses(rewards, part, slope) for part in _blocks(thetas, rewards.size, overlap=1)]
    return parts[0] if len(parts) == 1 else np.concatenate(parts, axis=-1)


def read_at_midpoints(rewards: np.ndarray, thetas: np.ndarray, slope: float) -> tuple[np.ndarray, np.ndarray]:
    """The mass of each reward that lies at midpoints, and the sum of masses times midpoints, ``(V,)`` each."""
    middles, held, proxy = theta_midpoints(thetas), [], []
    for part in _blocks(rewards, thetas.size):
        masses = bin_masses(part, thetas, slope)
        held.append(masses.sum(axis=-1))
        proxy.append(masses @ middles)
    return np.concatenate(held), np.concatenate(proxy)


def _blocks(points: np.ndarray, others: int, overlap: int = 0) -> Iterator[np.ndarray]:
    """Points in order, so many at a time that these by the others are a block; each with some of the next one's."""
    size = max(1, _BLOCK // max(1, others))
    for start in range(0, max(1, points.size - overlap), size):
        yield points[start : start + size + overlap]


def reward_distance(tau_space: np.ndarray, tails: np.ndarray, thetas: np.ndarray) -> np.ndarray:
    """Wasserstein-1 distance of each step's reward under two timelines, in units of reward, ``(..., K)``.

    An episode that is over pays 0: below 0 what counts is P(r < theta, alive), above it P(r > theta, alive). So a
    step's distance is never less than the difference of its expected rewards. What lies beyond the thetas is not seen.

    Args:
        tau_space: ``(..., K, H-1)``, probabilities.
        tails: ``(..., K, H)``, P(r > theta_h, alive) of the other.
    """
    more = np.cumsum(tau_space + np.diff(tails), axis=-1)
    return area_around_zero(np.concatenate([np.zeros_like(more[..., :1]), more], axis=-1), thetas)


def area_around_zero(
    low: np.ndarray, thetas: np.ndarray, size: Callable[[np.ndarray], np.ndarray] = np.abs
) -> np.ndarray:
    """Area under the size of cumulated masses over theta: from below at negative thetas, from above at positive ones.

    Args:
        low: ``(..., H)``, the mass below each theta; straight lines between them.
        size: of a mass, elementwise over the last axes.
    """
    at = int(np.searchsorted(thetas, 0.0))
    if 0 < at < thetas.size and thetas[at] != 0.0:
        share = -thetas[at - 1] / (thetas[at] - thetas[at - 1])
        middle = low[..., at - 1 : at] + share * (low[..., at : at + 1] - low[..., at - 1 : at])
        low, thetas = np.concatenate([low[..., :at], middle, low[..., at:]], axis=-1), np.insert(thetas, at, 0.0)
    below, above = size(low), size(low[..., -1:] - low)
    ends = np.where(theta_midpoints(thetas) < 0.0, below[..., :-1] + below[..., 1:], above[..., :-1] + above[..., 1:])
    return (ends / 2.0) @ np.diff(thetas)  # trapezoids


def softening(
    places: np.ndarray, share: float, open_ends: bool = False, rows: slice = slice(None)
) -> np.ndarray:  # fmt: skip
    """S of a softer slope: what a difference Z[j] of gamma-space leaves in each bin, shape ``(B, B)``.

    The activation is the distribution function of a logistic law. A law of ``share`` of its slope is the given one
    blurred by a third, whose characteristic function is the ratio of theirs, sinh(pi w) / sinh(pi w / share) * 1/share;
    its distribution function, in units of 1/slope, is

        1/2 + arctan(tan(pi share / 2) tanh(share x / 2)) / (pi share)

    (its density is sin(pi share) / (cosh(share x) + cos(pi share)) / (2 pi)). So softening is a linear map over theta:
    each difference goes through that function from its midpoint. At share 1 it is a step and S the identity. It is
    exact but for the width of the gaps: off by at most .008 of a probability at a slope of 2.5 / spacing.

    What is softened over an edge is lost where B = H-1, and lies in the outermost bin where the ends are open, B = H+1:
    there rows sum to 1. What an open end holds is taken to lie within one gap of its sensitivity.

    Args:
        places: ``(H,)``, slope * theta, or whatever the activation is a sigmoid of; increasing.
        share: of the slope, in (0, 1].
        rows: of S that are wanted; all of them where nothing is said.

    Raises:
        InputError: a share outside (0, 1].
    """
    if not 0.0 < share <= 1.0:
        raise InputError(f"the share of the slope is {share:g}; it must be above 0 and at most 1.")
    places = np.asarray(places, dtype=float)
    padded = np.concatenate([[2.0 * places[0] - places[1]], places, [2.0 * places[-1] - places[-2]]])
    far = np.subtract.outer(theta_midpoints(padded if open_ends else places)[rows], places)
    if share == 1.0:
        beyond = np.heaviside(far, 0.5)
    else:
        beyond = 0.5 + np.arctan(np.tan(np.pi * share / 2.0) * np.tanh(share * far / 2.0)) / (np.pi * share)
    if open_ends:
        whole, nothing = np.ones((len(far), 1)), np.zeros((len(far), 1))
        beyond = np.concatenate([whole, beyond, nothing], axis=1)
    return -np.diff(beyond, axis=-1)
