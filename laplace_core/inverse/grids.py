"""Which discounts to learn: the grid that answers the horizons of interest best, for their number and the noise.

A grid is judged by how well V_T can be read from values at its discounts, for horizons from 1 to the longest, over many
timelines that are drawn without a world (:mod:`laplace_core.inverse.timelines`). The reading is the product's: weights
w = (F F^T + alpha^2 I)^-1 F d, at the alpha that reads best over all of them. Its mean squared error is what the
weights miss of exact values (bias) and the noise of the values that they pass on, sum_g (w_g noise / (1 - gamma_g))^2.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.optimize import minimize

from laplace_core.code.encoding import GAMMA_SPACINGS, discount_grid
from laplace_core.errors import InputError
from laplace_core.inverse.timelines import Timelines, draw_timelines
from laplace_core.inverse.transform import MAX_STEPS, transform_matrix

ALPHAS = np.geomspace(1e-7, 10.0, 33)
"""Those that a reading may have, in singular values of the transform."""
LONGEST = MAX_STEPS // 2
_BINS = 6


@dataclass(frozen=True, eq=False)
class Judged:
    """A grid, and how well it answers.

    Attributes:
        alpha: with which it reads best.
        error: root of the mean, over horizons, of E[(error of V_T)^2] / E[V_T^2].
        by_horizon: the same at each horizon of the task, ``(n,)``.
    """

    name: str
    gammas: np.ndarray
    alpha: float
    error: float
    by_horizon: np.ndarray


@dataclass(frozen=True, eq=False)
class Task:
    """What a grid is to be good for: timelines of expected reward, horizons, and the noise of values.

    Attributes:
        horizons: T, int ``(n,)``.
        value_gamma: discount of V_T.
        noise: standard deviation of (1 - gamma) Q, in units of the root mean square of rewards.
        rewards: ``(N, 1)`` column of expected rewards each, for :meth:`Timelines.transformed`.
    """

    horizons: np.ndarray
    value_gamma: float
    noise: float
    rewards: Timelines

    def targets(self, steps: int) -> np.ndarray:
        """d(tau) of each horizon, ``(n, steps)``: gamma^tau before the deadline, 0 after it."""
        tau = np.arange(steps)
        return np.where(tau < self.horizons[:, None], self.value_gamma**tau, 0.0)

    @cached_property
    def truth(self) -> np.ndarray:
        """V_T of each timeline and horizon, ``(N, n)``."""
        return self.rewards.masses[..., 0] @ self.targets(self.rewards.masses.shape[1]).T

    @cached_property
    def sizes(self) -> np.ndarray:
        """E[V_T^2] of each horizon, ``(n,)``: what an error of V_T is compared with."""
        return (self.truth**2).mean(axis=0)

    def judge(self, gammas: np.ndarray, name: str = "") -> Judged:
        """A grid ``(G,)`` at the alpha of :data:`ALPHAS` that reads best."""
        targets = self.targets(self.rewards.masses.shape[1])
        values = self.rewards.transformed(gammas)[..., 0]  # (N, G)
        passed_on = (self.noise / (1.0 - gammas)) ** 2
        squares = np.array(
            [
                (((values @ w - self.truth) ** 2).mean(axis=0) + passed_on @ w**2) / self.sizes
                for w in readout_of_all_alphas(gammas, targets)
            ]
        )
        best = int(np.argmin(squares.mean(axis=1)))
        return Judged(name, gammas, float(ALPHAS[best]), float(np.sqrt(squares[best].mean())), np.sqrt(squares[best]))


def readout_of_all_alphas(gammas: np.ndarray, targets: np.ndarray) -> np.ndarray:
    """Weights of every alpha and target, ``(alphas, G, n)``: :func:`laplace_core.study.horizon.readout_weights`."""
    F = transform_matrix(gammas, targets.shape[1])
    U, s, Vt = np.linalg.svd(F, full_matrices=False)
    usable = s > max(F.shape) * np.finfo(float).eps * s[0]
    filters = np.where(usable, s / (s**2 + ALPHAS[:, None] ** 2), 0.0)
    return U @ (filters[..., None] * (Vt @ targets.T))


def task_for(
    horizon: int, noise: float, *, value_gamma: float = 0.99, samples: int = 1_000, seed: int = 0
) -> Task:  # fmt: skip
    """The task of answering every horizon up to ``horizon``, evenly in its logarithm.

    Raises:
        InputError: a number out of range.
    """
    if not 2 <= horizon <= LONGEST:
        raise InputError(f"horizon is {horizon}; it must be from 2 to {LONGEST:,} steps.")
    if not 0.0 <= noise <= 1.0:
        raise InputError(f"noise is {noise:g}; it must be from 0 to 1.")
    if not 0.0 < value_gamma <= 1.0:
        raise InputError(f"the discount of values is {value_gamma:g}; it must be above 0 and at most 1.")
    rng = np.random.default_rng(seed)
    drawn = draw_timelines(rng, samples, 2 * horizon, _BINS)  # rewards also come after the last deadline
    worth = rng.normal(size=(samples, _BINS, 1))
    rewards = Timelines(drawn.masses @ worth, drawn.beyond @ worth, drawn.endings)
    horizons = np.unique(np.round(np.geomspace(1, horizon, 16)).astype(int))
    return Task(horizons, value_gamma, noise, rewards)


def standard_grids(count: int, low: float = 0.01, high: float = 0.99) -> dict[str, np.ndarray]:
    """The grids that can be chosen by name, with ``count`` discounts each but for the paper's, which are fifteen."""
    return {name: discount_grid(count, name, low, high) for name in GAMMA_SPACINGS}


def tuned(task: Task, count: int, spacing: str, *, gamma_max: float = 0.999) -> Judged:
    """The best first and last discount of the spacings ``log`` and ``inverse-log``, which can be chosen by name."""
    _check(count, gamma_max)
    power, longest = POWERS[spacing], -1.0 / np.log(gamma_max)
    found = _fitted(task, count, longest, lambda x: np.append(x, power), _first(task, longest))
    gammas = np.exp(-1.0 / found)
    return task.judge(discount_grid(count, spacing, float(gammas[0]), float(gammas[-1])), f"{spacing}, tuned")


def design(task: Task, count: int, *, gamma_max: float = 0.999, rounds: int = 4) -> Judged:
    """The best grid of ``count`` discounts that was found for a task, at most ``gamma_max`` each.

    First the best of a family: time constants -1 / log(gamma) from a shortest to a longest one, evenly in a power of
    them. Power 1 is the spacing ``inverse-log`` and power 0 is ``log``. It competes with these two, tuned, and with the
    standard grids of as many discounts. Then one discount after the other is moved between its neighbours, by steps
    that are halved, as long as that helps.

    Raises:
        InputError: a number of discounts or a bound out of range.
    """
    _check(count, gamma_max)
    longest = -1.0 / np.log(gamma_max)
    starts = [grid for grid in standard_grids(count).values() if len(grid) == count and grid[-1] <= gamma_max]
    starts += [tuned(task, count, spacing, gamma_max=gamma_max).gammas for spacing in POWERS]
    found = _fitted(task, count, longest, lambda x: x, np.append(_first(task, longest), 0.3))
    best = min([*starts, np.exp(-1.0 / found)], key=lambda grid: task.judge(grid).error)
    times = _descended(lambda x: _error_of(task, x), -1.0 / np.log(best), longest, rounds=rounds)
    return min((task.judge(grid, "designed") for grid in (best, np.exp(-1.0 / times))), key=lambda each: each.error)


def judged_grids(task: Task, count: int, *, gamma_max: float = 0.999) -> list[Judged]:
    """The designed grid, those that can be chosen by name, with their bounds tuned and as they are, in this order."""
    named = [task.judge(grid, name) for name, grid in standard_grids(count).items()]
    return [
        design(task, count, gamma_max=gamma_max),
        *(tuned(task, count, spacing, gamma_max=gamma_max) for spacing in POWERS),
        *named,
    ]


POWERS = {"inverse-log": 1.0, "log": 0.0}
"""Spacings that are members of the family, and their powers."""


def _check(count: int, gamma_max: float) -> None:
    if not 2 <= count <= 100:
        raise InputError(f"gammas is {count}; a grid is designed for 2 to 100 discounts.")
    if not 0.5 <= gamma_max < 1.0:
        raise InputError(f"gamma-max is {gamma_max:g}; it must be at least 0.5 and below 1.")


def _first(task: Task, longest: float) -> np.ndarray:
    """Logarithms of a shortest and a longest time constant to begin with."""
    return np.log([0.3, min(longest, max(1.0, float(task.horizons[-1]) / 2.0))])


def _fitted(
    task: Task, count: int, longest: float, member: Callable[[np.ndarray], np.ndarray], first: np.ndarray
) -> np.ndarray:
    """Time constants of the best member of the family, by the simplex of Nelder and Mead."""
    found = minimize(
        lambda x: _error_of(task, _family(member(x), count, longest)),
        first, method="Nelder-Mead", options={"maxfev": 80, "xatol": 1e-2, "fatol": 1e-5},
    )  # fmt: skip
    return _family(member(found.x), count, longest)


_SHORTEST = -1.0 / np.log(0.01)
"""Least time constant, in steps: a lower discount sees hardly more than the first step."""
_APART = 1.001
"""Least ratio of two neighbouring time constants."""


def _family(x: np.ndarray, count: int, longest: float) -> np.ndarray:
    """Time constants ``(count,)`` from exp(x0) to exp(x1), evenly in their power x2 (in their logarithm at 0)."""
    low, high = np.clip(np.exp(np.clip(x[:2], -10.0, 20.0)), _SHORTEST, longest)
    high = min(longest, max(high, low * _APART ** (2 * count)))
    low = min(low, high / _APART ** (2 * count))
    power = float(np.clip(x[2], -2.0, 3.0))
    if abs(power) < 1e-3:
        return np.geomspace(low, high, count)
    return np.linspace(low**power, high**power, count) ** (1.0 / power)


def _error_of(task: Task, times: np.ndarray) -> float:
    if np.any(np.diff(np.log(times)) < np.log(_APART)):
        return np.inf
    return task.judge(np.exp(-1.0 / times)).error


def _descended(
    error_of: Callable[[np.ndarray], float], times: np.ndarray, longest: float, *, rounds: int
) -> np.ndarray:  # fmt: skip
    """Coordinate descent over the logarithms of time constants, each with a step of its own."""
    logs, error = np.log(times), error_of(times)
    steps = np.full(len(times), 0.5 * float(np.diff(logs).mean()))
    for _ in range(rounds):
        before = error
        for i in np.arange(len(times))[::-1]:
            for sign in (1.0, -1.0):
                moved = logs.copy()
                moved[i] = np.clip(moved[i] + sign * steps[i], np.log(_SHORTEST), np.log(longest))
                tried = error_of(np.exp(moved)) if np.all(np.diff(moved) > 0.0) else np.inf
                if tried < error:
                    logs, error = moved, tried
                    break
            else:
                steps[i] /= 2.0
        if error > before * (1.0 - 1e-4):
            steps /= 2.0
    return np.exp(logs)


def judged(task: Task, count: int, report: Callable[[int, int], None]) -> tuple[Judged, ...]:
    """The designed grid and those that can be chosen by name, with tuned bounds and as they are."""
    report(0, 1 + len(POWERS))
    found = [task.judge(grid, name) for name, grid in standard_grids(count).items()]
    for done, spacing in enumerate(POWERS, start=1):
        found.append(tuned(task, count, spacing))
        report(done, 1 + len(POWERS))
    return (design(task, count), *found)
