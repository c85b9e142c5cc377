"""Feasible timelines: masses that are never negative and add up to a survival that never rises."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from laplace_core.errors import InputError
from laplace_core.inverse.axis import Axis, axis_of
from laplace_core.inverse.interior import solve_feasible
from laplace_core.inverse.problem import Problem, Solution

MOST_TOGETHER = 400_000
"""Numbers of the whitened systems of problems that are solved at once; a large one is solved alone."""


@dataclass(frozen=True, eq=False)
class FeasibleSolution(Solution):
    """A feasible timeline; ``beyond`` is the probability of a step in each window after the last row, ``(..., J, B)``.

    Attributes:
        axis: the columns that it lives on.
        kkt: relative KKT residual, ``(...)``.
        misfit: sum over discounts and bins of the squared weighted residual, ``(...)``.
        prices: multipliers of survival at every stretch of time and of its beginning at 1, ``(..., N + 1)``.
    """

    axis: Axis | None = None
    kkt: np.ndarray | None = None
    misfit: np.ndarray | None = None
    prices: np.ndarray | None = None


def feasible(problem: Problem, alpha: float, tolerance: float = 1e-7) -> FeasibleSolution:
    """The feasible timeline of least |W (F x - z)|^2 + alpha^2 |x|^2.

    Masses are not negative. Those of one step add up to survival, which is 1 at the first step (at most 1 if the
    problem does not start alive) and never rises, also in the windows after the last row: see
    :class:`laplace_core.inverse.axis.Axis`. With a ``time_step`` below 1 all this holds for the sums over each unit of
    time.

    The method is :mod:`laplace_core.inverse.interior`. On one problem of 15 discounts and 114 bins at K 200, with noise
    of 1e-3, it took .20 and .25 s of one thread at alpha .1 and .01, to a residual of 1e-7. PIQP 0.7, the fastest
    general sparse solver at hand, took 1.1 and 1.4 s; at (100, 251), K 60, it was .9 and 1.0 s against 3.1 and 3.3 s.
    Unlike Newton's method on the dual it needs no alpha above 0.

    Args:
        alpha: regularisation, in singular values of the transform, as of :func:`laplace_core.inverse.decode`; 0 gives a
            timeline of least misfit.
        tolerance: of the relative KKT residual.

    Raises:
        InputError: alpha negative or not finite.
    """
    if not (np.isfinite(alpha) and alpha >= 0):
        raise InputError(f"alpha is {alpha:g}; it must be zero or a positive number.")
    axis = axis_of(problem.gammas, problem.steps, problem.time_step)
    leading, (discounts, bins) = problem.masses.shape[:-2], problem.masses.shape[-2:]
    U, reduced = reduced_system(problem.weights[:, None] * axis.transform)
    data = np.swapaxes(problem.weights[:, None] * problem.masses, -1, -2).reshape(-1, bins, discounts)
    targets = data @ U
    together = max(1, MOST_TOGETHER // (bins * reduced.size))
    found = [
        solve_feasible(
            reduced, some, axis, alpha**2 * axis.size, starts_alive=problem.starts_alive, tolerance=tolerance
        )
        for some in np.split(targets, range(together, len(targets), together))
    ]
    x = np.concatenate([one.masses for one in found])
    active = x < np.concatenate([one.reduced for one in found])
    masses = np.swapaxes(x, 1, 2).reshape(*leading, len(axis.size), bins)
    unreached = ((data - targets @ U.T) ** 2).sum(axis=(1, 2))
    rows = axis.rows
    held = np.swapaxes(active, 1, 2).reshape(masses.shape)
    return FeasibleSolution(
        masses[..., :rows, :],
        problem.masses - axis.transform @ masses,
        _freedom(reduced, ~active, alpha**2 * axis.size).mean(axis=-1).reshape(leading),
        held[..., :rows, :],
        masses[..., rows:, :],
        axis,
        np.concatenate([one.kkt for one in found]).reshape(leading),
        (np.concatenate([one.misfit for one in found]) + unreached).reshape(leading),
        np.concatenate([one.prices for one in found]).reshape(*leading, -1),
    )


def reduced_system(system: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """U ``(G, r)`` and the rows ``(r, C)`` of U^T system that hold more than rounding.

    What data hold outside the range of U no timeline can reach: it is a constant of the misfit.
    """
    U, s, Vt = np.linalg.svd(system, full_matrices=False)
    kept = s > max(system.shape) * np.finfo(float).eps * s[0]
    return U[:, kept], s[kept, None] * Vt[kept]


def _freedom(A: np.ndarray, free: np.ndarray, penalty: np.ndarray) -> np.ndarray:
    """trace of A_f (A_f^T A_f + p_f)^-1 A_f^T of every bin, with A_f the free columns, ``(n, B)``.

    The constraints on survival are left out: they take away at most one parameter a step, shared by all bins.
    """
    scaled = A / np.sqrt(np.maximum(penalty, 1e-16 * (A**2).sum()))
    gram = (free[..., None, :] * scaled) @ scaled.T
    eigenvalues = np.maximum(np.linalg.eigvalsh(gram), 0.0)
    return (eigenvalues / (1.0 + eigenvalues)).sum(axis=-1)
