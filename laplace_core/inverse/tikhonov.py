"""The SVD-regularised inverse: gamma-space to tau-space by one cached matrix."""

from __future__ import annotations

import numpy as np

from laplace_core.caching import cached
from laplace_core.code.ties import ROUNDING
from laplace_core.errors import InputError
from laplace_core.inverse.transform import transform_factors, transform_matrix


def filter_factors(singular_values: np.ndarray, alpha: float, size: int) -> np.ndarray:
    """s / (s^2 + alpha^2), shape of ``singular_values``: how much of each component comes back.

    Components below ``size`` * eps of the largest hold nothing but rounding and are dropped, so that
    alpha = 0 is the pseudo-inverse. ``size`` is the larger dimension of the transform.

    Raises:
        InputError: alpha negative or not finite.
    """
    if not (np.isfinite(alpha) and alpha >= 0):
        raise InputError(f"alpha is {alpha:g}; it must be zero or a positive number.")
    s = np.asarray(singular_values, dtype=float)
    usable = s > size * np.finfo(float).eps * s[0]
    return np.divide(s, s**2 + alpha**2, out=np.zeros_like(s), where=usable)


def decode_matrix(gammas: np.ndarray, steps: int, alpha: float, time_step: float = 1.0) -> np.ndarray:
    """D = V diag(s / (s^2 + alpha^2)) U^T, shape ``(steps, G)``, cached and read-only.

    D minimises |F x - z|^2 + alpha^2 |x|^2 (Tikhonov); it is linear, so it may be applied to the
    differences between neighbouring sensitivities or to the tails alike.
    """
    return _decode_matrix(np.asarray(gammas, dtype=float).tobytes(), int(steps), float(alpha), float(time_step))


@cached(64)
def _decode_matrix(gammas: bytes, steps: int, alpha: float, time_step: float) -> np.ndarray:
    grid = np.frombuffer(gammas)
    U, s, Vt = transform_factors(grid, steps, time_step)
    matrix = (Vt.T * filter_factors(s, alpha, max(grid.size, steps))) @ U.T
    matrix.setflags(write=False)
    return matrix


def decode(values: np.ndarray, gammas: np.ndarray, steps: int, alpha: float, time_step: float = 1.0) -> np.ndarray:
    """Tau-space of anything that lies over the discounts: ``(..., G, H)`` to ``(..., steps, H)``.

    Args:
        values: gamma-space (tails or differences); the last two axes are discount and sensitivity.
        alpha: regularisation, in units of the singular values of F.

    Raises:
        InputError: the discount axis does not match ``gammas``.
    """
    values = np.asarray(values)
    if values.ndim < 2 or values.shape[-2] != len(gammas):
        raise InputError(
            f"gamma-space of shape {values.shape} does not have {len(gammas)} discounts on its second to last axis."
        )
    return decode_matrix(gammas, steps, alpha, time_step) @ values


def rounding_of_rows(
    values: np.ndarray, gammas: np.ndarray, steps: int, alpha: float, time_step: float = 1.0
) -> np.ndarray:
    """The mass below which a decoded row holds nothing but rounding, ``(..., G, H)`` to ``(..., steps)``.

    By Cauchy and Schwarz a row of D times the values has at most the mass |D_k| |m|, with m_g the sum of the sizes of
    the values of one discount; the rounding of its computation is a tiny share of that, ``ties.ROUNDING``.
    """
    sizes = np.linalg.norm(np.abs(values).sum(axis=-1), axis=-1)
    return ROUNDING * sizes[..., None] * np.linalg.norm(decode_matrix(gammas, steps, alpha, time_step), axis=-1)


def resolution_matrix(gammas: np.ndarray, steps: int, alpha: float, time_step: float = 1.0) -> np.ndarray:
    """R = D F, shape ``(steps, steps)``: row tau is the averaging kernel through which step tau is seen."""
    return decode_matrix(gammas, steps, alpha, time_step) @ transform_matrix(gammas, steps, time_step)
