"""What of a decoded timeline of expected rewards is noise, and what is smoothing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from laplace_core.code.gamma_space import GammaSpace, bin_differences
from laplace_core.inverse.axis import axis_of
from laplace_core.inverse.channels import channel_gains, channel_weights, layered
from laplace_core.inverse.feasible import feasible
from laplace_core.inverse.linear import decode_matrix
from laplace_core.inverse.problem import Problem, Solution, problem_of

LAYERS = 3

Solver = Callable[[Problem, float], Solution]


@dataclass(frozen=True, eq=False)
class Layers:
    """A gamma-space cut into bins (:mod:`laplace_core.inverse.channels`), with the noise of their channels.

    Attributes:
        problem: masses ``(A, G, B)``; its deviations are those of the constant channel.
        sizes: what each bin counts as in the expected reward, ``(B,)``.
        gains: error of each channel that each of N independent errors makes, over the deviation of the constant one,
            ``(B, N)``.
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
        normal = np.random.default_rng(seed).normal(size=(draws, *clean.shape[:-1], self.gains.shape[1]))
        errors = deviations[:, None] * (normal @ self.gains.T)
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
        independent: whether errors of different sensitivities are; if not, they are the same within each of the
            layers, as :func:`laplace_core.inverse.channels.channel_gains` has it.
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
        independent: whether errors of different sensitivities are; if not, they are the same within each of the
            layers, as :func:`laplace_core.inverse.channels.channel_gains` has it.
    """
    of_values, of_constant = _counts(gamma_space)
    if independent:
        return float(np.hypot(np.linalg.norm(of_values), of_constant))
    weights, _ = channel_weights(gamma_space.thetas, LAYERS)
    return float(np.hypot(np.linalg.norm((weights > 0.0) @ of_values), of_constant))


def bands_by_draws(
    solver: Solver, layers: Layers, alpha: float, *, draws: int = 50, seed: int = 0,
    progress: Callable[[int, int], None] | None = None,
) -> Bands:  # fmt: skip
    """The bands of any solver, from draws of noise around the feasible timeline that fits best.

    Args:
        layers: :func:`bins_of` of a solver that is not linear.
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
    """A gamma-space in few wide bins, for whatever is linear or looks at the expected reward as a whole.

    Args:
        deviations: ``(G,)``, standard deviation of the error of one value at each discount.
        independent: whether errors of different sensitivities are; if not, they are the same within each of the
            layers, as :func:`laplace_core.inverse.channels.channel_gains` has it.
    """
    channels, weights, widths = layered(gamma_space, LAYERS)
    masses = -np.diff(np.swapaxes(channels, -1, -2), axis=-1, append=0.0)
    problem = Problem(masses, gamma_space.gammas, steps, time_step, np.asarray(deviations, dtype=float))
    sizes = gamma_space.thetas[0] + np.concatenate([[0.0], np.cumsum(widths)])
    return Layers(problem, sizes, np.diag(channel_gains(weights, independent=independent)))


def bins_of(
    gamma_space: GammaSpace, steps: int, deviations: np.ndarray, *, time_step: float = 1.0, independent: bool = True
) -> Layers:
    """A gamma-space in its own bins, for a solver that is not linear: what it makes of their noise is not what it makes
    of the noise of wide bins, in which a mass that is held at 0 hides among others.

    Args:
        deviations, independent: as in :func:`layers_of`.
    """
    problem = problem_of(gamma_space, steps, time_step, np.asarray(deviations, dtype=float))
    sizes, count = np.zeros(problem.masses.shape[-1]), gamma_space.thetas.size
    sizes[slice(None) if gamma_space.open_ends else slice(1, -1)] = gamma_space.bin_values
    weights, _ = channel_weights(gamma_space.thetas, LAYERS)
    of_values = np.eye(count) if independent else (weights > 0.0).T.astype(float)
    gains = np.zeros((1 + count, 1 + of_values.shape[1]))
    gains[0, 0], gains[1:, 1:] = 1.0, of_values
    return Layers(problem, sizes, gains)


def layer_noise(layers: Layers, alpha: float, matrix: np.ndarray | None = None) -> np.ndarray:
    """Standard deviation that noise gives each row of a linear decode of the layers, ``(K,)``; default: Tikhonov's."""
    problem = layers.problem
    assert problem.deviations is not None  # layers_of gives them
    gain = np.linalg.norm(layers.gains.T @ np.diff(layers.sizes, prepend=0.0))
    inverse = decode_matrix(problem.gammas, problem.steps, alpha, problem.time_step) if matrix is None else matrix
    return np.asarray(gain * np.sqrt(inverse**2 @ problem.deviations**2))


def tikhonov_of_layers(problem: Problem, alpha: float) -> Solution:
    """Tikhonov of order 0, rows of one weight: the picture that the pages draw."""
    masses = decode_matrix(problem.gammas, problem.steps, alpha, problem.time_step) @ problem.masses
    return Solution(masses, problem.masses - problem.transform @ masses, np.zeros(masses.shape[:-2]))
