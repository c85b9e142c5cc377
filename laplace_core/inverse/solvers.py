"""Every solver by its name, and the one call that serves them all."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np

from laplace_core.errors import InputError
from laplace_core.inverse.feasible import feasible
from laplace_core.inverse.linear import LINEAR, linear_solver, shares_kept, shares_lost
from laplace_core.inverse.neural import shipped_network
from laplace_core.inverse.nonnegative import nonnegative
from laplace_core.inverse.problem import Problem, Solution
from laplace_core.inverse.spectrum import Spectrum, spectrum_of


@dataclass(frozen=True)
class Solver:
    """A solver as the registry holds it.

    Attributes:
        solve: from a problem and alpha to the solution.
        linear: whether it has a decode matrix (:func:`laplace_core.inverse.decode_matrix`).
        has_alpha: whether alpha changes anything.
        work: products that a decode takes, for each of a linear one (measured at 4 x 30 x 150 x 40).
        least_work: products that every decode takes beside.
    """

    solve: Callable[[Problem, float | np.ndarray], Solution]
    linear: bool = False
    has_alpha: bool = True
    work: float = 1.0
    least_work: float = 0.0


def spectrum_for(problem: Problem, solver: str) -> Spectrum:
    """The components that a linear solver filters."""
    order = linear_solver(solver).order
    return spectrum_of(problem.gammas, problem.steps, problem.time_step, order, problem.deviations)


def solve_linear(problem: Problem, alpha: float | np.ndarray, *, solver: str) -> Solution:
    """The solution of a linear solver.

    Args:
        alpha: one number, or one for each bin, ``(B,)``.

    Raises:
        InputError: alpha of another shape, negative or not finite.
    """
    alphas = np.asarray(alpha, dtype=float)
    if alphas.shape not in ((), problem.masses.shape[-1:]):
        raise InputError(f"alpha must be one number, or one for each of the {problem.masses.shape[-1]} bins.")
    spectrum, kind = spectrum_for(problem, solver), LINEAR[solver].filter
    components = spectrum.U.T @ spectrum.weighted(problem.masses)
    kept = np.atleast_2d(shares_kept(spectrum, alphas, kind)).T  # (r, 1) or (r, B)
    fitted = 1.0 - np.atleast_2d(shares_lost(spectrum, alphas, kind))
    masses = spectrum.rows @ (kept * components)
    degrees = np.full(problem.masses.shape[:-2], fitted.sum(axis=-1).mean())
    return Solution(masses, problem.masses - problem.transform @ masses, degrees)


def _of_one_alpha(
    solve_it: Callable[[Problem, float], Solution], problem: Problem, alpha: float | np.ndarray
) -> Solution:  # fmt: skip
    """A solver that has one alpha for all bins.

    Raises:
        InputError: one alpha for each bin.
    """
    if np.ndim(alpha):
        raise InputError("this solver couples the bins: it takes one alpha for all of them.")
    return solve_it(problem, float(alpha))


def _neural(problem: Problem, alpha: float | np.ndarray) -> Solution:
    return shipped_network(problem.gammas).solve(problem)


SOLVERS: Mapping[str, Solver] = {
    **{name: Solver(partial(solve_linear, solver=name), linear=True) for name in LINEAR},
    "nonnegative": Solver(partial(_of_one_alpha, nonnegative), work=50.0, least_work=2e6),
    "feasible": Solver(partial(_of_one_alpha, feasible), work=4e3, least_work=5e8),
    "neural": Solver(_neural, has_alpha=False, work=100.0, least_work=2e6),
}
"""Every solver that settings may name; a further one is a further entry."""
ALPHA_OF = "tikhonov"
"""The linear solver by which alpha is chosen for one that is not linear: rules for alpha need an influence matrix."""


def selecting(solver: str) -> str:
    """The linear solver by which alpha is chosen for a solver."""
    return solver if is_linear(solver) else ALPHA_OF


def is_linear(solver: str) -> bool:
    """Whether a solver has a decode matrix, so that a picture is a sum of parts and values are a readout."""
    return _known(solver).linear


def solve(problem: Problem, solver: str, alpha: float | np.ndarray) -> Solution:
    """The timeline of masses that a solver finds.

    Args:
        solver: one of ``SOLVERS``.
        alpha: regularisation, in singular values of the transform, in the same unit for every solver.

    Raises:
        InputError: no such solver, or an alpha that it cannot take.
    """
    return _known(solver).solve(problem, alpha)


def _known(solver: str) -> Solver:
    if solver not in SOLVERS:
        raise InputError(f"solver {solver!r} is not one of {', '.join(SOLVERS)}.")
    return SOLVERS[solver]
