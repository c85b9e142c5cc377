"""Bumps of a decoded timeline of expected rewards, and how probable it is that each is real.

A bump that is real survives: fresh noise, another alpha and another solver show it as well. How often it does, how far
it stands out and where it lies go into log odds that were fitted to worlds of known truth
(``python -m laplace_core report inverse-bumps --fit``); how right they are on other worlds: ``report inverse-bumps``.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np

from laplace_core.code.gamma_space import GammaSpace
from laplace_core.inverse.bands import Layers, Solver, layer_noise, layers_of, tikhonov_of_layers
from laplace_core.inverse.feasible import feasible
from laplace_core.inverse.nonnegative import nonnegative

SHARE = 0.5
"""Of a bump's contrast, that another timeline must show for the bump to be in it."""
LEAST_PROMINENCE = 0.1
"""Of the largest expected reward in size; smaller bumps are not looked at."""
ALPHAS = (0.5, 1.0, 2.0)
"""Multiples of alpha at which a bump must survive."""
DRAWS = 8
"""Of noise, in which a bump must survive."""
COEFFICIENTS = Path(__file__).with_suffix(".json")
FEATURES = (
    "one", "linear", "nonnegative", "feasible", "nonnegative squared", "feasible squared", "noise", "noise squared",
    "height", "height squared", "peak", "width",
)  # fmt: skip
"""1; the shares of draws that show the bump, by solver, and squares of two of them; logarithms of its contrast over the
deviation that noise gives its peak, of its contrast over the largest expected reward, of the row of its peak, and of
how many rows it has."""


@dataclass(frozen=True)
class Bump:
    """A stretch of rows whose expected reward stands out.

    Attributes:
        start: first row of it, at half of its height.
        peak: the row where it is largest.
        stop: the row after its last one.
        sign: 1 of a reward, -1 of a cost.
        contrast: how much its mean lies beyond that of the rows at either side, in units of reward.
        probability: that it is real; see :class:`Calibration`.
    """

    start: int
    peak: int
    stop: int
    sign: int
    contrast: float
    probability: float = float("nan")


def contrast(rewards: np.ndarray, start: int, stop: int, sign: int) -> np.ndarray:
    """Mean of the rows of a stretch beyond the larger mean of its two sides, ``(..., K)`` to ``(...)``.

    A side is as many rows as the stretch has, at most those that are there; the beginning of time is no side.
    """
    signed, width = sign * rewards, stop - start
    sides = [signed[..., max(0, start - width) : start], signed[..., stop : stop + width]]
    means = [side.mean(axis=-1) for side in sides if side.shape[-1]]
    inside = signed[..., start:stop].mean(axis=-1)
    return np.asarray(inside - (np.maximum.reduce(means) if means else 0.0))


def find_bumps(rewards: np.ndarray) -> list[Bump]:
    """The bumps of one timeline of expected rewards ``(K,)``, in the order of time."""
    from scipy.signal import find_peaks, peak_widths  # slow to import

    size = float(np.abs(rewards).max(initial=0.0))
    found = []
    for sign in (1, -1) if size > 0.0 else ():
        padded = np.concatenate([[0.0], sign * rewards, [0.0]])  # a reward at the first step is a bump as well
        peaks = find_peaks(padded, prominence=LEAST_PROMINENCE * size)[0]
        peaks = peaks[padded[peaks] > 0.0]
        _, _, left, right = peak_widths(padded, peaks, rel_height=0.5)
        for peak, low, high in zip(peaks - 1, np.ceil(left).astype(int) - 1, np.floor(right).astype(int), strict=True):
            start, stop = max(0, min(low, peak)), min(len(rewards), max(high, peak + 1))
            size_of = float(contrast(rewards, start, stop, sign))
            if size_of > 0.0:
                found.append(Bump(int(start), int(peak), int(stop), sign, size_of))
    return sorted(found, key=lambda bump: bump.peak)


def is_in(bump: Bump, rewards: np.ndarray) -> np.ndarray:
    """Whether a timeline shows a bump: bool ``(...)`` for expected rewards ``(..., K)``."""
    return np.asarray(contrast(rewards, bump.start, bump.stop, bump.sign) >= SHARE * bump.contrast)


def survivals(
    layers: Layers, alpha: float, linear: Solver, *, draws: int = DRAWS, seed: int = 0
) -> list[list[tuple[Bump, np.ndarray]]]:
    """Each bump of the linear decode of each action, and how often it survives, ``(3,)``.

    Noise is drawn around the feasible timeline that fits; each draw is decoded by the linear solver and by the
    non-negative one at three alphas (:data:`ALPHAS`), and by the feasible one at alpha. The three shares are those of
    the solvers.
    """
    fitted = feasible(layers.problem, 0.0)
    drawn = layers.redrawn(layers.problem.masses - fitted.residual, draws, seed)
    decoded = linear(layers.problem, alpha).masses @ layers.sizes
    pictures = [
        [linear(drawn, scale * alpha).masses @ layers.sizes for scale in ALPHAS],
        [nonnegative(drawn, scale * alpha).masses @ layers.sizes for scale in ALPHAS],
        [feasible(drawn, alpha, 1e-4).masses @ layers.sizes],
    ]
    return [
        [
            (bump, np.array([np.mean([is_in(bump, one[:, a]) for one in kind]) for kind in pictures]))
            for bump in find_bumps(rewards)
        ]
        for a, rewards in enumerate(decoded)
    ]


@dataclass(frozen=True, eq=False)
class Calibration:
    """From features to the log odds that a bump is real.

    The sum of weighted features is a first guess of the log odds; a function that is linear between knots turns it into
    log odds whose probabilities are as frequent as they say.

    Attributes:
        weights: of ``FEATURES``, ``(12,)``.
        knots: of the first guess, ``(m,)``, increasing.
        log_odds: at the knots, ``(m,)``.
    """

    weights: np.ndarray
    knots: np.ndarray
    log_odds: np.ndarray

    def probability(self, features: np.ndarray) -> np.ndarray:
        """``(n,)`` for features ``(n, 12)``."""
        odds = np.interp(features @ self.weights, self.knots, self.log_odds)
        return np.asarray(1.0 / (1.0 + np.exp(-odds)))


@cache
def calibration() -> Calibration:
    """The one that was fitted."""
    held = json.loads(COEFFICIENTS.read_text(encoding="utf-8"))
    return Calibration(*(np.array(held[name]) for name in ("weights", "knots", "log_odds")))


def features(bumps: Sequence[Bump], shares: np.ndarray, noise: np.ndarray, largest: float) -> np.ndarray:
    """The numbers by which bumps of one timeline are judged, ``(n, 12)``.

    Args:
        shares: of :func:`survivals`, ``(n, 3)``.
        noise: standard deviation that noise gives each row, ``(K,)``.
        largest: expected reward of the timeline, in size.
    """
    place = np.array([(bump.contrast, bump.peak, bump.stop - bump.start) for bump in bumps]).reshape(-1, 3)
    contrasts, peaks, widths = place.T
    linear, positive, possible = np.asarray(shares, dtype=float).reshape(-1, 3).T
    of_noise = np.log(np.clip(contrasts / noise[peaks.astype(int)], 1e-3, 1e3))
    height = np.log(contrasts / largest + 1e-3)
    return np.stack(
        [
            np.ones(len(bumps)), linear, positive, possible, positive**2, possible**2, of_noise, of_noise**2,
            height, height**2, np.log1p(peaks), np.log(widths),
        ],
        axis=1,
    )  # fmt: skip


def bumps(
    gamma_space: GammaSpace, steps: int, alpha: float, deviations: np.ndarray, *, time_step: float = 1.0,
    independent: bool = True, seed: int = 0, solver: Solver | None = None, matrix: np.ndarray | None = None,
) -> list[list[Bump]]:  # fmt: skip
    """The bumps of each action's decoded expected reward, with the probability that each is real.

    Args:
        solver: that decodes; default: Tikhonov with discounts that count alike.
        matrix: the linear inverse whose noise counts, ``(K, G)``; default: that of Tikhonov.
    """
    layers = layers_of(gamma_space, steps, deviations, time_step=time_step, independent=independent)
    found = judged(layers, alpha, seed=seed, solver=solver, matrix=matrix)
    chances = [calibration().probability(numbers) for _, numbers in found]
    return [
        [replace(bump, probability=float(chance)) for bump, chance in zip(of_action, its, strict=True)]
        for (of_action, _), its in zip(found, chances, strict=True)
    ]


def judged(
    layers: Layers, alpha: float, *, seed: int = 0, solver: Solver | None = None, matrix: np.ndarray | None = None
) -> list[tuple[list[Bump], np.ndarray]]:
    """The bumps of each action's decoded expected reward, and their features ``(n, 12)``; see :func:`bumps`."""
    solver = solver or tikhonov_of_layers
    noise = layer_noise(layers, alpha, matrix)
    rewards = solver(layers.problem, alpha).masses @ layers.sizes
    numbers = []
    for survived, decoded in zip(survivals(layers, alpha, solver, seed=seed), rewards, strict=True):
        found, shares = [bump for bump, _ in survived], np.array([share for _, share in survived])
        numbers.append((found, features(found, shares, noise, float(np.abs(decoded).max()))))
    return numbers
