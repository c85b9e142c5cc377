"""The transform taken apart for a solver: which components the data have, and what each of them stands for in time.

A linear solver minimises |W (F x - z)|^2 + alpha^2 |L x|^2, or filters the same components in another way. W weighs the
discounts and L is a difference of neighbouring rows, of order 0 (L is the identity), 1 or 2. The generalised singular
value decomposition of (W F, L) makes one number of each component, and all solvers and all rules for the choice of
alpha work on these numbers.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from laplace_core.caching import cached
from laplace_core.errors import InputError
from laplace_core.inverse.transform import transform_factors, transform_matrix

ORDERS = (0, 1, 2)


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Components of W F against L: W F ``rows`` = U diag(1 .. 1, s), with L ``rows`` orthonormal but for the free ones.

    **One scale for alpha.** W is scaled so that the largest singular value of W F is that of F, and L so that the
    largest generalised singular value is that as well. So alpha is in the same unit for all weights and orders: at
    alpha = s[0], which is the largest singular value of F, Tikhonov takes half of the strongest component, and
    components with s below alpha are suppressed. Deviations that are all equal change nothing. A difference operator
    leaves ``order`` components free: a constant, and at order 2 a straight line, are never smoothed.

    Attributes:
        U: ``(G, r)``, orthonormal directions of the weighted data, the free ones first.
        s: ``(r - free,)``, generalised singular values, decreasing.
        rows: ``(K, r)``, the timeline that belongs to each component.
        free: how many components L does not smooth: 0 at order 0.
        weights: ``(G,)``, diagonal of W; None where every discount counts alike.
        scale: what the difference of neighbouring rows is multiplied by.
        largest: the largest singular value of F.
    """

    U: np.ndarray
    s: np.ndarray
    rows: np.ndarray
    free: int
    weights: np.ndarray | None
    scale: float
    largest: float

    @property
    def usable(self) -> np.ndarray:
        """Which of ``s`` are more than rounding, bool: those above max(G, K) eps of the largest."""
        return usable(self.s, max(len(self.U), len(self.rows)))

    def weighted(self, values: np.ndarray) -> np.ndarray:
        """W times what lies over the discounts, ``(..., G, n)``."""
        return values if self.weights is None else self.weights[:, None] * values


def usable(singular_values: np.ndarray, size: int) -> np.ndarray:
    """Which singular values, decreasing, are more than rounding: above ``size`` * eps of the largest."""
    return singular_values > size * np.finfo(float).eps * singular_values[:1]


def difference_operator(steps: int, order: int) -> np.ndarray:
    """L before it is scaled, ``(max(0, steps - order), steps)``: differences of neighbours, taken ``order`` times.

    Nothing is assumed about what lies before the first row or after the last one.
    """
    return np.diff(np.eye(steps), n=order, axis=0) if steps > order else np.zeros((0, steps))


def spectrum_of(
    gammas: np.ndarray, steps: int, time_step: float = 1.0, order: int = 0, deviations: np.ndarray | None = None
) -> Spectrum:
    """The cached :class:`Spectrum` of a transform; its arrays are read-only and shared.

    Args:
        order: of the difference operator.
        deviations: ``(G,)``, standard deviation of the error at each discount, in any unit; rows are divided by it.

    Raises:
        InputError: deviations that are not G numbers above 0, or fewer discounts than components are free.
    """
    gammas, weights = np.asarray(gammas, dtype=float), None
    if deviations is not None:
        deviations = np.asarray(deviations, dtype=float)
        if deviations.shape != gammas.shape or not np.all(np.isfinite(deviations) & (deviations > 0)):
            raise InputError(f"deviations must be {gammas.size} numbers above 0, one for each discount.")
        if np.any(deviations != deviations[0]):
            weights = (deviations.min() / deviations).tobytes()
    if order not in ORDERS:
        raise InputError(f"the order of the difference is {order}; it must be one of 0, 1 and 2.")
    return _spectrum(gammas.tobytes(), int(steps), float(time_step), order=order, weights=weights)


@cached(32)
def _spectrum(gammas: bytes, steps: int, time_step: float, *, order: int, weights: bytes | None) -> Spectrum:
    grid = np.frombuffer(gammas)
    plain = transform_factors(grid, steps, time_step)
    largest = float(plain.s[0])
    if weights is None and order == 0:
        return Spectrum(plain.U, plain.s, plain.Vt.T, 0, None, 1.0, largest)
    transform, scaled = transform_matrix(grid, steps, time_step), None
    if weights is not None:
        scaled = np.frombuffer(weights).copy()
        scaled *= largest / np.linalg.norm(scaled[:, None] * transform, 2)
        transform = scaled[:, None] * transform
    if order == 0:
        U, s, Vt = np.linalg.svd(transform, full_matrices=False)
        found = Spectrum(U, s, Vt.T, 0, scaled, 1.0, largest)
    else:
        U, s, rows, free = _against_differences(transform, order)
        scale = float(s[0] / largest) if s.size else 1.0
        rows[:, free:] /= scale
        found = Spectrum(U, s / scale, rows, free, scaled, scale, largest)
    for array in (found.U, found.s, found.rows, found.weights):
        if array is not None:
            array.setflags(write=False)
    return found


def _against_differences(transform: np.ndarray, order: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, int]:
    """U, s, rows and the number of free components for the difference operator of an order, before it is scaled.

    The transformation to standard form (Elden 1977; Hansen, Rank-Deficient and Discrete Ill-Posed Problems, 2.3): what
    L does not see is fitted first, without a penalty; the rest is a problem of order 0 in the differences y = L x. A
    running sum is a right inverse of a difference, so that no K x K matrix is formed.
    """
    discounts, steps = transform.shape
    free = min(order, steps)
    if discounts < free:
        raise InputError(f"differences of order {order} need at least {free} discounts; there is {discounts}.")
    # What L does not see: polynomials below its order, orthonormal.
    unseen = np.linalg.qr(np.vander(np.linspace(-1.0, 1.0, steps), free, increasing=True))[0]
    Q, R = np.linalg.qr(transform @ unseen, mode="complete")
    fitted, rest, R = Q[:, :free], Q[:, free:], R[:free]
    if steps == free:
        return fitted, np.zeros(0), np.linalg.solve(R.T, unseen.T).T, free
    summed = transform  # F times the running sums
    for _ in range(order):
        summed = np.cumsum(summed[:, :0:-1], axis=1)[:, ::-1]
    U, s, Vt = np.linalg.svd(rest.T @ summed, full_matrices=False)
    rows = Vt.T
    for _ in range(order):
        rows = np.cumsum(np.pad(rows, ((1, 0), (0, 0))), axis=0)
    rows = rows - unseen @ np.linalg.solve(R, fitted.T @ (summed @ Vt.T))
    free_rows = np.linalg.solve(R.T, unseen.T).T  # unseen @ inv(R)
    return np.hstack([fitted, rest @ U]), s, np.hstack([free_rows, rows]), free
