"""Linear solvers: each is one cached matrix that leads from gamma-space to tau-space."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from laplace_core.caching import cached
from laplace_core.code.ties import ROUNDING
from laplace_core.errors import InputError
from laplace_core.inverse.spectrum import Spectrum, spectrum_of, usable
from laplace_core.inverse.transform import transform_matrix


@dataclass(frozen=True)
class Filter:
    """How a linear solver treats a component with singular value s > 0; functions of s and alpha, elementwise.

    Attributes:
        kept: what the data of the component are multiplied by; 1/s gives all of it back.
        lost: share of the component that stays in the residual, 1 - s kept, without cancellation.
    """

    kept: Callable[[np.ndarray, np.ndarray], np.ndarray]
    lost: Callable[[np.ndarray, np.ndarray], np.ndarray]


def iterations_of(alpha: np.ndarray, largest: float) -> np.ndarray:
    """Iterations that an alpha stands for, (largest / alpha)^2 in whole numbers, at least 1; infinity at alpha 0.

    After n iterations, components with s well above largest / sqrt(n) are fitted and those below are not: so many
    iterations smooth about as Tikhonov does at alpha = largest / sqrt(n).
    """
    with np.errstate(divide="ignore", over="ignore"):
        return np.maximum(1.0, np.round((largest / alpha) ** 2))


def _log_left(s: np.ndarray, alpha: np.ndarray) -> np.ndarray:
    """Logarithm of the share that the iteration has not fitted: n log(1 - s^2 / largest^2)."""
    with np.errstate(divide="ignore"):  # the largest component is fitted at once
        return iterations_of(alpha, float(s[0])) * np.log1p(-((s / s[0]) ** 2))


FILTERS: Mapping[str, Filter] = {
    "tikhonov": Filter(lambda s, a: s / (s**2 + a**2), lambda s, a: a**2 / (s**2 + a**2)),
    "truncated": Filter(lambda s, a: (s >= a) / s, lambda s, a: (s < a) * 1.0),
    "damped": Filter(lambda s, a: 1.0 / (s + a), lambda s, a: a / (s + a)),
    "iterative": Filter(lambda s, a: -np.expm1(_log_left(s, a)) / s, lambda s, a: np.exp(_log_left(s, a))),
}


@dataclass(frozen=True)
class LinearSolver:
    """A filter of components, and the order of the difference operator that they are taken against."""

    filter: str
    order: int = 0


LINEAR: Mapping[str, LinearSolver] = {
    "tikhonov": LinearSolver("tikhonov"),
    "tikhonov1": LinearSolver("tikhonov", 1),
    "tikhonov2": LinearSolver("tikhonov", 2),
    "tsvd": LinearSolver("truncated"),
    "dsvd": LinearSolver("damped"),
    "iterative": LinearSolver("iterative"),
}
"""``tikhonov`` to ``tikhonov2`` minimise |W (F x - z)|^2 + alpha^2 |L x|^2; ``tsvd`` keeps components with s >= alpha;
``dsvd`` multiplies them by s / (s + alpha), a gentler slope. ``iterative`` is the iteration that the paper found too
slow (3.1), x <- x + F^T (z - F x) / s[0]^2 from x = 0, which its components give in closed form; alpha sets the number
of iterations (:func:`iterations_of`)."""


def filter_factors(
    singular_values: np.ndarray, alpha: float | np.ndarray, size: int, kind: str = "tikhonov"
) -> np.ndarray:
    """How much of each component comes back, ``(..., r)`` for alpha ``(...)``: of Tikhonov s / (s^2 + alpha^2).

    Components below ``size`` * eps of the largest hold nothing but rounding and are dropped, so that
    alpha = 0 is the pseudo-inverse. ``size`` is the larger dimension of the transform.

    Raises:
        InputError: alpha negative or not finite.
    """
    return _filtered(FILTERS[kind].kept, singular_values, alpha, size, dropped=0.0)


def _filtered(
    of: Callable[[np.ndarray, np.ndarray], np.ndarray],
    singular_values: np.ndarray,
    alpha: float | np.ndarray,
    size: int,
    *,
    dropped: float,
) -> np.ndarray:
    s, alphas = np.asarray(singular_values, dtype=float), np.asarray(alpha, dtype=float)
    bad = alphas[~(np.isfinite(alphas) & (alphas >= 0))]
    if bad.size:
        raise InputError(f"alpha is {bad[0]:g}; it must be zero or a positive number.")
    factors = np.full((*alphas.shape, s.size), dropped)
    used = usable(s, size)
    if used.any():
        factors[..., used] = of(s[used], alphas[..., None])
    return factors


def shares_lost(spectrum: Spectrum, alpha: float | np.ndarray, kind: str) -> np.ndarray:
    """Share of each component that stays in the residual, ``(..., r)`` for alpha ``(...)``; 0 for the free ones."""
    lost = _filtered(FILTERS[kind].lost, spectrum.s, alpha, max(len(spectrum.U), len(spectrum.rows)), dropped=1.0)
    return np.concatenate([np.zeros((*lost.shape[:-1], spectrum.free)), lost], axis=-1)


def shares_kept(spectrum: Spectrum, alpha: float | np.ndarray, kind: str) -> np.ndarray:
    """What the data of each component are multiplied by, ``(..., r)`` for alpha ``(...)``; 1 for the free ones."""
    kept = filter_factors(spectrum.s, alpha, max(len(spectrum.U), len(spectrum.rows)), kind)
    return np.concatenate([np.ones((*kept.shape[:-1], spectrum.free)), kept], axis=-1)


def linear_solver(name: str) -> LinearSolver:
    """The linear solver of a name.

    Raises:
        InputError: there is none of that name.
    """
    if name not in LINEAR:
        raise InputError(f"solver {name!r} has no decode matrix; those that have one are {', '.join(LINEAR)}.")
    return LINEAR[name]


def decode_matrix(
    gammas: np.ndarray,
    steps: int,
    alpha: float,
    time_step: float = 1.0,
    *,
    solver: str = "tikhonov",
    deviations: np.ndarray | None = None,
) -> np.ndarray:
    """D, shape ``(steps, G)``, cached and read-only: tau-space = D @ gamma-space.

    By default D = V diag(s / (s^2 + alpha^2)) U^T, which minimises |F x - z|^2 + alpha^2 |x|^2 (Tikhonov). It is
    linear, so it may be applied to the differences between neighbouring sensitivities or to the tails alike.

    Args:
        alpha: regularisation, in singular values of the transform for every solver
            (:class:`laplace_core.inverse.spectrum.Spectrum` says how).
        solver: one of ``LINEAR``.
        deviations: ``(G,)``, standard deviation of the error at each discount; None if all count alike.

    Raises:
        InputError: a solver that is not linear, alpha negative, or deviations that do not fit.
    """
    linear_solver(solver)
    of = None if deviations is None else np.asarray(deviations, dtype=float).tobytes()
    grid = np.asarray(gammas, dtype=float).tobytes()
    return _decode_matrix(grid, int(steps), float(alpha), float(time_step), solver=solver, deviations=of)


@cached(64)
def _decode_matrix(
    gammas: bytes, steps: int, alpha: float, time_step: float, *, solver: str, deviations: bytes | None
) -> np.ndarray:
    known = None if deviations is None else np.frombuffer(deviations)
    spectrum = spectrum_of(np.frombuffer(gammas), steps, time_step, LINEAR[solver].order, known)
    factors = shares_kept(spectrum, alpha, LINEAR[solver].filter)
    matrix = (spectrum.rows * factors) @ spectrum.U.T
    if spectrum.weights is not None:
        matrix *= spectrum.weights
    matrix.setflags(write=False)
    return matrix


def decode(
    values: np.ndarray,
    gammas: np.ndarray,
    steps: int,
    alpha: float,
    time_step: float = 1.0,
    *,
    solver: str = "tikhonov",
    deviations: np.ndarray | None = None,
) -> np.ndarray:
    """Tau-space of anything that lies over the discounts: ``(..., G, H)`` to ``(..., steps, H)``.

    Args:
        values: gamma-space (tails or differences); the last two axes are discount and sensitivity.
        alpha, solver, deviations: as in :func:`decode_matrix`.

    Raises:
        InputError: the discount axis does not match ``gammas``, or as :func:`decode_matrix`.
    """
    values = np.asarray(values)
    if values.ndim < 2 or values.shape[-2] != len(gammas):
        raise InputError(
            f"gamma-space of shape {values.shape} does not have {len(gammas)} discounts on its second to last axis."
        )
    return decode_matrix(gammas, steps, alpha, time_step, solver=solver, deviations=deviations) @ values


def rounding_of_rows(values: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """The mass below which a decoded row holds nothing but rounding, ``(..., G, H)`` to ``(..., steps)``.

    By Cauchy and Schwarz a row of D times the values has at most the mass |D_k| |m|, with m_g the sum of the sizes of
    the values of one discount; the rounding of its computation is a tiny share of that, ``ties.ROUNDING``.

    Args:
        matrix: D, ``(steps, G)``.
    """
    sizes = np.linalg.norm(np.abs(values).sum(axis=-1), axis=-1)
    return ROUNDING * sizes[..., None] * np.linalg.norm(matrix, axis=-1)


def resolution_matrix(gammas: np.ndarray, steps: int, alpha: float, time_step: float = 1.0) -> np.ndarray:
    """R = D F, shape ``(steps, steps)``: row tau is the averaging kernel through which step tau is seen."""
    return decode_matrix(gammas, steps, alpha, time_step) @ transform_matrix(gammas, steps, time_step)
