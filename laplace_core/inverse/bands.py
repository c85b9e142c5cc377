"""What of a decoded timeline of expected rewards is noise, what is smoothing, and which of its bumps are real."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from laplace_core.code.gamma_space import GammaSpace, bin_differences
from laplace_core.inverse.axis import axis_of
from laplace_core.inverse.channels import channel_gains, layered
from laplace_core.inverse.feasible import feasible
from laplace_core.inverse.linear import decode_matrix
from laplace_core.inverse.nonnegative import nonnegative
from laplace_core.inverse.problem import Problem, Solution

LAYERS = 3
SHARE = 0.5
"""Of a bump's contrast, that another timeline must show for the bump to be in it."""
LEAST_PROMINENCE = 0.1
"""Of the largest expected reward in size; smaller bumps are not looked at."""
ALPHAS = (0.5, 1.0, 2.0)
"""Multiples of alpha at which a bump must survive."""

Solver = Callable[[Problem, float], Solution]


@dataclass(frozen=True, eq=False)
class Layers:
    """A gamma-space cut into few wide bins (:mod:`laplace_core.inverse.channels`), with the noise of their channels.

    Attributes:
        problem: masses ``(A, G, B)``; its deviations are those of the constant channel.
        sizes: what each bin counts as in the expected reward, ``(B,)``.
        gains: deviation of each channel over that of the constant one, ``(B,)``.
    """

    problem: Problem
    sizes: np.ndarray
    gains: np.ndarray

    def of_action(self, action: int) -> Layers:
        """The layers of one action alone."""
        return replace(self, problem=replace(self.problem, masses=self.problem.masses[action : action + 1]))

    def redrawn(self, clean: np.ndarray, draws: int, seed: int) -> Problem:
        """Fresh noise on clean masses, as a problem of shape ``(draws, A, G, B)``."""
        deviations = self.problem.deviations
        assert deviations is not None  # layers_of gives them
        normal = np.random.default_rng(seed).normal(size=(draws, *clean.shape))
        errors = deviations[:, None] * self.gains * normal
        return replace(self.problem, masses=clean - np.diff(errors, axis=-1, append=0.0))


@dataclass(frozen=True, eq=False)
class Bands:
    """Errors of decoded expected rewards.

    Attributes:
        noise: standard deviation of what the noise of the values makes of each row, ``(A, K)``.
        bias: what the inverse adds to the reference timeline by smoothing it, ``(A, K)``.
        reference: expected rewards of the feasible timeline that stands for the truth, ``(A, K)``.
        values: the reference over the discounts, with what comes after the last row, ``(A, G)``: whatever a linear
            inverse makes of them, less the reference, is its bias. None where the bias was found by draws.
    """

    noise: np.ndarray
    bias: np.ndarray
    reference: np.ndarray
    values: np.ndarray | None = None


def bands(
    gamma_space: GammaSpace, steps: int, alpha: float, deviations: np.ndarray, *, time_step: float = 1.0,
    independent: bool = True, matrix: np.ndarray | None = None,
) -> Bands:  # fmt: skip
    """The bands of a linear inverse, exact for the noise; bias is that on the feasible timeline that fits best.

    Args:
        deviations: ``(G,)``, standard deviation of the error of one value at each discount.
        independent: whether errors of different sensitivities are; if not, they are taken to be the same at all.
        matrix: of another linear inverse, ``(K, G)``; default: Tikhonov's at ``alpha``.

    Raises:
        InputError: deviations or alpha that make no sense.
    """
    inverse = decode_matrix(gamma_space.gammas, steps, alpha, time_step) if matrix is None else matrix
    noise = reward_gain(gamma_space, independent=independent) * np.sqrt(inverse**2 @ np.asarray(deviations) ** 2)
    layers = layers_of(gamma_space, steps, deviations, time_step=time_step, independent=independent)
    fitted = feasible(layers.problem, 0.0)
    reference = fitted.masses @ layers.sizes
    axis = axis_of(gamma_space.gammas, steps, time_step)
    assert fitted.beyond is not None  # a feasible solution always has it
    whole = np.concatenate([reference, fitted.beyond @ layers.sizes], axis=-1)
    values = whole @ axis.transform.T
    bias = values @ inverse.T - reference
    return Bands(np.broadcast_to(noise, reference.shape), bias, reference, values)


def reward_gain(gamma_space: GammaSpace, *, independent: bool = True) -> float:
    """Standard deviation of the error of the expected reward at a discount over that of one value there.

    Args:
        independent: whether errors of different sensitivities are; if not, they are taken to be the same at all.
    """
    of_values, of_constant = _counts(gamma_space)
    if independent:
        return float(np.hypot(np.linalg.norm(of_values), of_constant))
    return float(abs(of_values.sum() + of_constant))


def bands_by_draws(
    solver: Solver, layers: Layers, alpha: float, *, draws: int = 50, seed: int = 0,
    progress: Callable[[int, int], None] | None = None,
) -> Bands:  # fmt: skip
    """The bands of any solver, from draws of noise around the feasible timeline that fits best.

    Args:
        progress: called with how many draws are decoded, and of how many; they are then decoded one after another.
    """
    fitted = feasible(layers.problem, 0.0)
    reference = fitted.masses @ layers.sizes
    drawn = layers.redrawn(layers.problem.masses - fitted.residual, draws, seed)
    if progress is None:
        rewards = solver(drawn, alpha).masses @ layers.sizes
    else:
        each = []
        for done, masses in enumerate(drawn.masses):
            progress(done, draws)
            each.append(solver(replace(drawn, masses=masses), alpha).masses @ layers.sizes)
        rewards = np.array(each)
    return Bands(rewards.std(axis=0, ddof=1), rewards.mean(axis=0) - reference, reference)


def _counts(gamma_space: GammaSpace) -> tuple[np.ndarray, float]:
    """What each sensitivity's value, ``(H,)``, and the constant channel count in the expected reward."""
    count = gamma_space.thetas.size
    values = np.concatenate([np.eye(count), np.zeros((1, count))])
    constant = np.append(np.zeros(count), 1.0)
    counted = bin_differences(values, constant, gamma_space.open_ends) @ gamma_space.bin_values
    return counted[:-1], float(counted[-1])


def layers_of(
    gamma_space: GammaSpace, steps: int, deviations: np.ndarray, *, time_step: float = 1.0, independent: bool = True
) -> Layers:
    """A gamma-space in few wide bins.

    Args:
        deviations: ``(G,)``, standard deviation of the error of one value at each discount.
        independent: whether errors of different sensitivities are; if not, they are taken to be the same at all.
    """
    channels, weights, widths = layered(gamma_space, LAYERS)
    masses = -np.diff(np.swapaxes(channels, -1, -2), axis=-1, append=0.0)
    problem = Problem(masses, gamma_space.gammas, steps, time_step, np.asarray(deviations, dtype=float))
    sizes = gamma_space.thetas[0] + np.concatenate([[0.0], np.cumsum(widths)])
    return Layers(problem, sizes, channel_gains(weights, independent=independent))


# --- bumps ---


@dataclass(frozen=True)
class Bump:
    """A stretch of rows whose expected reward stands out.

    Attributes:
        start: first row of it, at half of its height.
        peak: the row where it is largest.
        stop: the row after its last one.
        sign: 1 of a reward, -1 of a cost.
        contrast: how much its mean lies beyond that of the rows at either side, in units of reward.
        probability: that it is real; see :func:`bump_probability`.
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
    layers: Layers, alpha: float, linear: Solver, *, draws: int = 12, seed: int = 0
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


CALIBRATION = (-2.0, 1.0, 1.0, 1.0, 1.0)
"""Log odds that a bump is real: a constant, and weights of the three shares of :func:`survivals` and of the bump's
contrast over its noise (log). Provisional numbers of the right sign: ``report inverse-bumps --fit`` prints those of
maximum likelihood on worlds of other seeds than the ones that ``report inverse-bumps`` judges."""


def bump_probability(shares: np.ndarray, contrast_over_noise: np.ndarray) -> np.ndarray:
    """Probability that bumps are real, ``(n,)``: that the true timeline shows them (:func:`is_in`).

    Args:
        shares: of :func:`survivals`, ``(n, 3)``.
        contrast_over_noise: contrast of each over the standard deviation that noise gives its peak row, ``(n,)``.
    """
    odds = features(shares, contrast_over_noise) @ np.array(CALIBRATION)
    return np.asarray(1.0 / (1.0 + np.exp(-odds)))


def features(shares: np.ndarray, contrast_over_noise: np.ndarray) -> np.ndarray:
    """What the log odds are linear in, ``(n, 5)``."""
    ratio = np.log(np.clip(contrast_over_noise, 1e-3, 1e3))
    return np.concatenate([np.ones((len(ratio), 1)), shares, ratio[:, None]], axis=1)


def bumps(
    gamma_space: GammaSpace, steps: int, alpha: float, deviations: np.ndarray, *, time_step: float = 1.0,
    independent: bool = True, seed: int = 0,
) -> list[list[Bump]]:  # fmt: skip
    """The bumps of each action's decoded expected reward, with the probability that each is real."""
    layers = layers_of(gamma_space, steps, deviations, time_step=time_step, independent=independent)
    noise = layer_noise(layers, alpha)
    found = survivals(layers, alpha, tikhonov_of_layers, seed=seed)
    return [[_judged(bump, shares, noise) for bump, shares in action] for action in found]


def _judged(bump: Bump, shares: np.ndarray, noise: np.ndarray) -> Bump:
    ratio = np.array([bump.contrast / noise[bump.peak]])
    return replace(bump, probability=float(bump_probability(shares[None], ratio)[0]))


def layer_noise(layers: Layers, alpha: float) -> np.ndarray:
    """Standard deviation that noise gives each row of the Tikhonov decode of the layers, ``(K,)``."""
    problem = layers.problem
    assert problem.deviations is not None  # layers_of gives them
    gain = np.linalg.norm(layers.gains * np.diff(layers.sizes, prepend=0.0))
    inverse = decode_matrix(problem.gammas, problem.steps, alpha, problem.time_step)
    return np.asarray(gain * np.sqrt(inverse**2 @ problem.deviations**2))


def tikhonov_of_layers(problem: Problem, alpha: float) -> Solution:
    """Tikhonov of order 0, rows of one weight: the picture that the pages draw."""
    masses = decode_matrix(problem.gammas, problem.steps, alpha, problem.time_step) @ problem.masses
    return Solution(masses, problem.masses - problem.transform @ masses, np.zeros(masses.shape[:-2]))
