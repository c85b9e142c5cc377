"""The discrete Laplace (Z) transform between tau-space and gamma-space (paper, Eq. 10)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from laplace_core.caching import cached
from laplace_core.errors import InputError

MAX_STEPS = 2_000


class Factors(NamedTuple):
    """SVD of the transform, F = U diag(s) V^T with U ``(G, r)``, s ``(r,)`` decreasing, Vt ``(r, K)``."""

    U: np.ndarray
    s: np.ndarray
    Vt: np.ndarray


def transform_matrix(gammas: np.ndarray, steps: int, time_step: float = 1.0) -> np.ndarray:
    """F[g, tau] = gamma_g^(tau * time_step), shape ``(G, steps)``: gamma-space = F @ tau-space.

    The paper writes T + 1 columns; here there are exactly ``steps``, tau = 0 .. steps - 1.

    Raises:
        InputError: discounts outside (0, 1), steps outside 1..2000, time_step outside (0, 1].
    """
    gammas = np.asarray(gammas, dtype=float)
    if gammas.ndim != 1 or not gammas.size or not np.all((gammas > 0) & (gammas < 1)):
        raise InputError("discounts must be a list of numbers between 0 and 1, both excluded.")
    if not 1 <= steps <= MAX_STEPS:
        raise InputError(f"steps is {steps}; it must be from 1 to {MAX_STEPS:,}.")
    if not 0.0 < time_step <= 1.0:
        raise InputError(f"time-step is {time_step:g}; it must be above 0 and at most 1.")
    return gammas[:, None] ** (np.arange(steps) * time_step)


def transform_factors(gammas: np.ndarray, steps: int, time_step: float = 1.0) -> Factors:
    """The cached SVD of :func:`transform_matrix`; the arrays are read-only and shared."""
    return _factors(np.asarray(gammas, dtype=float).tobytes(), int(steps), float(time_step))


@cached(32)
def _factors(gammas: bytes, steps: int, time_step: float) -> Factors:
    matrix = transform_matrix(np.frombuffer(gammas), steps, time_step)
    factors = Factors(*np.linalg.svd(matrix, full_matrices=False))
    for array in factors:
        array.setflags(write=False)
    return factors
