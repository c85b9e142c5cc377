"""The quadratic programme of feasible timelines, by a primal-dual interior-point method of many problems at once::

    minimise    1/2 sum_b |A_b x_b - z_b|^2 + 1/2 sum_b p^T x_b^2
    subject to  x >= 0,  d >= 0,  sum_b x_b over a stretch of time = survival,  survival_n = sum_{m >= n} d_m,
                sum d = 1

x ``(B, C)`` are masses of B bins over the C columns of an :class:`laplace_core.inverse.axis.Axis`; d_m is the
probability that an episode ends with stretch m, the last one that it never ends. Ends that are not negative and add up
to 1 are the same as a survival that begins at 1 and never rises. Where the state may be terminal, a further end stands
for an episode that is over before its first step.

Mehrotra's predictor and corrector (Nocedal and Wright, Numerical Optimization, 16.6). A Newton step costs little,
because the bins are coupled by survival alone: with the diagonal D of p and of the barrier, (D + A^T A)^-1 is D^-1 less
a product of rank r = rows of A (Woodbury), and what is left is one system of N + 1 unknowns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import NamedTuple

import numpy as np

from laplace_core.inverse.axis import Axis

MOST_STEPS = 80
PATIENCE, EARLY = 6, 20
"""Rounding is taken to stop a problem after so many steps without a smaller residual or a gap that is smaller by a
tenth; its first steps do not count. The residual alone will not do: its gap is relative to the objective, and both may
fall together for long."""
TO_THE_EDGE = 0.995
"""Share of the way to the edge that a step goes at most."""
FACTORED_SINGLY = 48
"""Unknowns from which on a loop over factorisations is faster than the inverses of all problems at once."""


_on_step: ContextVar[Callable[[], None] | None] = ContextVar("on_step", default=None)


@contextmanager
def calling(on_step: Callable[[], None]) -> Iterator[None]:
    """Within it, every Newton step of this thread calls a function first, which may end the work by an exception."""
    before = _on_step.set(on_step)
    try:
        yield
    finally:
        _on_step.reset(before)


class Optimum(NamedTuple):
    """What the method found for n problems.

    Attributes:
        masses: x, ``(n, B, C)``, above 0.
        ends: d, ``(n, N)``; where the state may be terminal ``(n, N + 1)``, the episode that is over already last.
        prices: ``(n, N + 1)``, multipliers of survival and of the sum of the ends.
        reduced: ``(n, B, C)``, multipliers of x >= 0.
        misfit: sum_b |A_b x_b - z_b|^2, ``(n,)``.
        kkt: relative KKT residual, ``(n,)``: the largest of stationarity over the size of its terms, of the violated
            equalities, and of complementarity over the objective.
        steps: Newton steps taken, ``(n,)``.
    """

    masses: np.ndarray
    ends: np.ndarray
    prices: np.ndarray
    reduced: np.ndarray
    misfit: np.ndarray
    kkt: np.ndarray
    steps: np.ndarray


class _Point(NamedTuple):
    x: np.ndarray
    d: np.ndarray
    prices: np.ndarray
    zx: np.ndarray
    zd: np.ndarray


def solve_feasible(
    A: np.ndarray, z: np.ndarray, axis: Axis, penalty: np.ndarray, *, starts_alive: bool = True, tolerance: float = 1e-7
) -> Optimum:
    """The feasible masses of least misfit and penalty, for n problems at once.

    Args:
        A: weighted transform: one, ``(r, C)``, or one of each bin, ``(B, r, C)``, or of each problem, ``(n, B, r, C)``.
        z: weighted data, ``(n, B, r)``.
        penalty: p, ``(C,)``, not negative; 0 is allowed.
        tolerance: of the relative KKT residual. A problem that does not reach it, because rounding stops it, is
            returned as far as it came: see :attr:`Optimum.kkt`.
    """
    n, bins, _ = z.shape
    count, stretches = len(penalty), len(axis.first)
    alive = stretches - np.arange(stretches)
    start = _Point(
        x=np.broadcast_to(axis.spread(alive / stretches / np.diff(axis.first, append=count)) / bins, (n, bins, count)),
        d=np.full((n, stretches + (not starts_alive)), 1.0 / stretches),
        prices=np.zeros((n, stretches + 1)),
        zx=np.zeros((n, bins, count)),
        zd=np.zeros((n, stretches + (not starts_alive))),
    )
    gradient = _through(A, _seen(A, start.x) - z) + penalty * start.x
    size = np.abs(gradient).reshape(n, -1).mean(axis=1) + 1e-12
    level = 10.0 * size * start.x.mean(axis=(1, 2))
    point = start._replace(zx=level[:, None, None] / start.x, zd=level[:, None] / start.d)
    terms = 1.0 + np.abs(_through(A, z)).reshape(n, -1).max(axis=1)
    best, best_kkt, steps = point, np.full(n, np.inf), np.zeros(n, dtype=int)
    misfit = np.zeros(n)
    moving, since, least_gap = np.arange(n), np.zeros(n, dtype=int), np.full(n, np.inf)
    on_step = _on_step.get()
    for turn in range(MOST_STEPS):
        if on_step is not None:
            on_step()
        own, data = A[moving] if A.ndim == 4 else A, z[moving]
        residuals, kkt, fit, gap = _residuals(own, data, axis, penalty, point=point, terms=terms[moving])
        better = kkt < best_kkt[moving]
        onward = better | (gap < 0.9 * least_gap[moving])
        least_gap[moving] = np.minimum(least_gap[moving], gap)
        best = _put(best, moving[better], _Point(*(array[better] for array in point)))
        best_kkt[moving[better]], misfit[moving[better]] = kkt[better], fit[better]
        since[moving] = np.where(onward, 0, since[moving] + 1)
        still = (best_kkt[moving] > tolerance) & ((since[moving] < PATIENCE) | (turn < EARLY)) & np.isfinite(kkt)
        if not still.any():
            break
        if not still.all():
            moving, point = moving[still], _Point(*(array[still] for array in point))
            own, residuals = A[moving] if A.ndim == 4 else A, tuple(array[still] for array in residuals)
        point = _step(own, axis, penalty, point, residuals)
        steps[moving] = turn + 1
    return Optimum(best.x, best.d, best.prices, best.zx, misfit, best_kkt, steps)


def _put(all_of: _Point, where: np.ndarray, some: _Point) -> _Point:
    arrays = [np.array(array) if not array.flags.writeable else array for array in all_of]
    for array, part in zip(arrays, some, strict=True):
        array[where] = part
    return _Point(*arrays)


def _seen(A: np.ndarray, x: np.ndarray) -> np.ndarray:
    """A x, ``(n, B, r)``."""
    return x @ A.T if A.ndim == 2 else (A @ x[..., None])[..., 0]


def _through(A: np.ndarray, c: np.ndarray) -> np.ndarray:
    """A^T c, ``(n, B, C)``."""
    return c @ A if A.ndim == 2 else (c[..., None, :] @ A)[..., 0, :]


def _later(d: np.ndarray, stretches: int) -> np.ndarray:
    """Survival from the ends: sums from each stretch on, ``(n, N)``."""
    return np.cumsum(d[:, :stretches][:, ::-1], axis=1)[:, ::-1]


def _earlier(prices: np.ndarray, d: np.ndarray) -> np.ndarray:
    """What an end costs by the prices of the steps alive until it, less that of all ends, ``(n, N or N + 1)``."""
    sums = np.cumsum(prices[:, :-1], axis=1)
    if d.shape[1] > sums.shape[1]:
        sums = np.concatenate([sums, np.zeros((len(sums), 1))], axis=1)
    return sums - prices[:, -1:]


def _residuals(
    A: np.ndarray, z: np.ndarray, axis: Axis, penalty: np.ndarray, *, point: _Point, terms: np.ndarray
) -> tuple[tuple[np.ndarray, ...], np.ndarray, np.ndarray, np.ndarray]:
    """Residuals of stationarity (x, d) and of the equalities (survival, sum); relative KKT residual, misfit and gap."""
    x, d, prices, zx, zd = point
    error = _seen(A, x) - z
    of_x = _through(A, error) + penalty * x - axis.spread(prices[:, :-1])[:, None, :] - zx
    of_d = _earlier(prices, d) - zd
    of_survival = axis.survival(x.sum(axis=1)) - _later(d, len(axis.first))
    of_sum = d.sum(axis=1) - 1.0
    misfit = (error**2).sum(axis=(1, 2))
    objective = 0.5 * misfit + 0.5 * (penalty * x**2).sum(axis=(1, 2))
    gap = (x * zx).sum(axis=(1, 2)) + (d * zd).sum(axis=1)
    kkt = np.maximum.reduce(
        [
            np.maximum(np.abs(of_x).max(axis=(1, 2)), np.abs(of_d).max(axis=1)) / terms,
            np.maximum(np.abs(of_survival).max(axis=1), np.abs(of_sum)),
            gap / (1.0 + objective),
        ]
    )
    return (of_x, of_d, of_survival, of_sum), kkt, misfit, gap


def _step(A: np.ndarray, axis: Axis, penalty: np.ndarray, point: _Point, residuals: tuple[np.ndarray, ...]) -> _Point:
    """One predictor and corrector of every problem."""
    x, d, _, zx, zd = point
    of_x, of_d, of_survival, of_sum = residuals
    n, bins, count = x.shape
    stretches = len(axis.first)
    spared = 1.0 / (penalty + zx / x)
    weighted = A * spared[..., None, :]  # (n, B, r, C)
    inner = weighted @ np.swapaxes(A, -1, -2)
    rank = np.arange(A.shape[-2])
    inner[..., rank, rank] += 1.0 + 2e-13 * inner[..., rank, rank]  # what rounding may take from the identity
    whitened = _inverted(np.linalg.cholesky(inner)) @ weighted
    lumped = axis.survival(whitened).reshape(n, -1, stretches)
    free = d / zd
    later = _later(free, stretches)
    system = np.empty((n, stretches + 1, stretches + 1))
    order = np.arange(stretches)
    never_rising = np.minimum(later[:, :, None], later[:, None, :])  # that of the later of two stretches
    np.subtract(never_rising, _squares(lumped), out=system[:, :-1, :-1])
    system[:, order, order] += axis.survival(spared.sum(axis=1))
    system[:, -1, :-1] = system[:, :-1, -1] = -later
    system[:, -1, -1] = free.sum(axis=1)
    solve = _factored(system)

    def undone(f: np.ndarray) -> np.ndarray:
        """(D + A^T A)^-1 f, ``(n, B, C)``."""
        return f * spared - (np.swapaxes(whitened, -1, -2) @ (whitened @ f[..., None]))[..., 0]

    def direction(cx: np.ndarray, cd: np.ndarray) -> _Point:
        """The Newton step towards x zx - cx = 0 and d zd - cd = 0, where cx and cd are what is too much."""
        fx, fd = -of_x - cx / x, -of_d - cd / d
        right = np.empty((n, stretches + 1))
        right[:, :-1] = -of_survival - axis.survival(undone(fx).sum(axis=1)) + _later(free * fd, stretches)
        right[:, -1] = -of_sum - (free * fd).sum(axis=1)
        dp = solve(right)
        dp += solve(right - (system @ dp[..., None])[..., 0])  # one step of refinement
        dx = undone(fx + axis.spread(dp[:, :-1])[:, None, :])
        dd = free * (fd - _earlier(dp, d))
        return _Point(dx, dd, dp, -(cx + zx * dx) / x, -(cd + zd * dd) / d)

    number = bins * count + d.shape[1]
    gap = ((x * zx).sum(axis=(1, 2)) + (d * zd).sum(axis=1)) / number
    aim = direction(x * zx, d * zd)
    share = _to_the_edge(point, aim)
    reached = _moved(point, aim, share)
    left = ((reached.x * reached.zx).sum(axis=(1, 2)) + (reached.d * reached.zd).sum(axis=1)) / number
    centre = (left / gap) ** 3 * gap
    move = direction(x * zx + aim.x * aim.zx - centre[:, None, None], d * zd + aim.d * aim.zd - centre[:, None])
    return _moved(point, move, np.minimum(1.0, TO_THE_EDGE * _to_the_edge(point, move)))


def _inverted(lower: np.ndarray) -> np.ndarray:
    """Inverses of lower triangular matrices, ``(..., r, r)``, in their place."""
    from scipy.linalg.lapack import dtrtri  # slow to import

    for one in lower.reshape(-1, *lower.shape[-2:]):
        dtrtri(one.T, overwrite_c=True)  # LAPACK counts by columns: to it this is the upper triangle
    return lower


def _squares(lumped: np.ndarray) -> np.ndarray:
    """L^T L of each problem, ``(n, M, N)`` to ``(n, N, N)``; of a single one BLAS computes only one triangle."""
    if len(lumped) == 1:
        return np.asarray(lumped[0].T @ lumped[0])[None]
    return np.asarray(np.swapaxes(lumped, 1, 2) @ lumped)


def _factored(system: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
    """The solution of symmetric systems, each scaled to a diagonal of 1; rounding is kept from making one singular."""
    scale = 1.0 / np.sqrt(np.maximum(np.einsum("nii->ni", system), np.finfo(float).tiny))
    scaled = system * scale[:, :, None] * scale[:, None, :]
    at = np.arange(scaled.shape[1])
    scaled[:, at, at] += 1e-14
    if scaled.shape[1] >= FACTORED_SINGLY or len(scaled) == 1:
        from scipy.linalg.lapack import dgetrf, dgetrs  # slow to import; lu_solve checks for longer than it solves

        # LAPACK counts by columns: it is handed the transpose, which of a symmetric matrix is the same one.
        factors = [dgetrf(one.T, overwrite_a=True)[:2] for one in scaled]

        def solve(right: np.ndarray) -> np.ndarray:
            rights = zip(factors, scale * right, strict=True)
            return scale * np.array([dgetrs(*factor, one)[0] for factor, one in rights])

        return solve
    inverse = np.linalg.inv(scaled)
    return lambda right: scale * (inverse @ (scale * right)[..., None])[..., 0]


def _to_the_edge(point: _Point, move: _Point) -> np.ndarray:
    """How much of a move keeps all that must not be negative at 0 or above, at most 1 / TO_THE_EDGE, ``(n,)``."""
    n = len(point.d)
    share = np.full(n, 1.0 / TO_THE_EDGE)
    for at, along in ((point.x, move.x), (point.d, move.d), (point.zx, move.zx), (point.zd, move.zd)):
        falls = np.minimum(along / at, -1e-300).reshape(n, -1).min(axis=1)
        share = np.minimum(share, -1.0 / falls)
    return share


def _moved(point: _Point, move: _Point, share: np.ndarray) -> _Point:
    return _Point(
        *(at + share.reshape(-1, *[1] * (at.ndim - 1)) * along for at, along in zip(point, move, strict=True))
    )
