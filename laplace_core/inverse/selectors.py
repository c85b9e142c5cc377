"""Selectors, the rules that choose alpha: each is a function over a sweep, of which the smallest value is taken.

With r the weighted residual, G discounts, m columns that share one alpha, d the degrees of freedom of a column and
n = G m numbers in all. Only ``discrepancy`` needs the size of the error. Sources: Hansen, Discrete Inverse Problems
(2010), chapter 5, for ``gcv``, ``lcurve``, ``discrepancy`` and ``ncp``; Lukas, Inverse Problems 22 (2006) 1883, for
``rgcv``; Hurvich and Tsai, Biometrika 76 (1989) 297, for ``aic``; McQuarrie, Stat. Probab. Lett. 44 (1999) 79, for
``bic``; Edwards and Stoll, J. Magn. Reson. 288 (2018) 58, for ``corner``; Tikhonov, Glasko and Kriksin, Dokl. Akad.
Nauk 248 (1979) 531, for ``quasiopt``.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.inverse.auto import auto_alpha, is_fitted
from laplace_core.inverse.components import Sweep, sweep_of
from laplace_core.inverse.problem import Problem

AUTO = "fitted"
"""The rule that ``auto`` stands for."""
ROBUSTNESS = 0.9
"""Share of plain cross-validation in ``rgcv``; the rest is weighed by how much of the noise is fitted."""
NOTHING_LEFT = 1e-13
"""Share of the degrees of freedom up to which the residual is rounding, and says nothing."""
TYPED = "typed"


def _log(values: np.ndarray) -> np.ndarray:
    """Logarithm of sums of squares; of 0, that of the smallest number."""
    return np.log(np.maximum(values, np.finfo(float).tiny))


def gcv(sweep: Sweep) -> np.ndarray:
    """Generalised cross-validation: (|r|^2 / n) / ((G - d) / G)^2, ``(n, a)``."""
    share = sweep.left / sweep.discounts
    return np.divide(
        sweep.residual / (sweep.discounts * sweep.columns),
        share**2,
        out=np.full_like(sweep.residual, np.inf),
        where=share > NOTHING_LEFT,
    )


def rgcv(sweep: Sweep) -> np.ndarray:
    """Robust generalised cross-validation: gcv times (c + (1 - c) tr(A^2) / G), with A the influence matrix."""
    fitted = ((1.0 - sweep.lost) ** 2).sum(axis=-1) / sweep.discounts
    return gcv(sweep) * (ROBUSTNESS + (1.0 - ROBUSTNESS) * fitted)


def loo(sweep: Sweep) -> np.ndarray:
    """Leaving one discount out: mean over discounts and columns of (r_g / (1 - A_gg))^2.

    For Tikhonov of any order this is the error with which a fit without discount g predicts it, at the same penalty
    alpha * scale; for the other solvers it is the same expression.
    """
    reached = sweep.spectrum.U[:, : sweep.lost.shape[-1]]
    left = sweep.lost @ (reached**2).T + (1.0 - (reached**2).sum(axis=-1))  # 1 - A_gg, (a, G)
    power = sweep.power(np.eye(sweep.discounts))
    terms = np.divide(power, left**2, out=np.full_like(power, np.inf), where=left > NOTHING_LEFT)
    return terms.sum(axis=-1) / (sweep.discounts * sweep.columns)


def aic(sweep: Sweep) -> np.ndarray:
    """Akaike's criterion, corrected for small samples: n log(|r|^2 / n) + 2 k n / (n - k - 1), with k = m d."""
    return _criterion(sweep, price=2.0, spare=1.0)


def bic(sweep: Sweep) -> np.ndarray:
    """Bayesian criterion, corrected for small samples: n log(|r|^2 / n) + k n log(n) / (n - k - 2), with k = m d."""
    return _criterion(sweep, price=math.log(sweep.discounts * sweep.columns), spare=2.0)


def _criterion(sweep: Sweep, *, price: float, spare: float) -> np.ndarray:
    """n log(|r|^2 / n) + price k n / (n - k - spare); without the correction it would reward a fit of everything."""
    numbers = sweep.discounts * sweep.columns
    room = sweep.columns * sweep.left - spare
    fitted = price * sweep.columns * sweep.degrees * numbers
    penalty = np.divide(fitted, room, out=np.full_like(room, np.inf), where=room > 0)
    return numbers * _log(sweep.residual / numbers) + penalty


def _bends(sweep: Sweep) -> tuple[np.ndarray, np.ndarray]:
    """The L-curve: logarithms of the norms of the residual and of L x, ``(n, a)`` each."""
    return 0.5 * _log(sweep.residual), 0.5 * _log(sweep.size)


def lcurve(sweep: Sweep) -> np.ndarray:
    """Curvature of the L-curve, negative: its sharpest bend towards small norms has the smallest value.

    By central differences along the sweep, between the singular values; the two alphas at either end of the sweep have
    too few neighbours and are left out.
    """
    curve = np.full_like(sweep.residual, np.inf)
    if sweep.alphas.size < 5:
        return curve
    x, y = _bends(sweep)
    place = np.log(sweep.alphas)
    dx, dy = np.gradient(x, place, axis=-1), np.gradient(y, place, axis=-1)
    turning = dx * np.gradient(dy, place, axis=-1) - dy * np.gradient(dx, place, axis=-1)
    speed = dx**2 + dy**2
    moving = sweep.between & (
        speed > 1e-12 * speed.max(axis=-1, keepdims=True)
    )  # where nothing changes, a bend is rounding
    moving[:, :2] = moving[:, -2:] = False
    np.divide(-turning, speed**1.5, out=curve, where=moving)
    return curve


def corner(sweep: Sweep) -> np.ndarray:
    """Distance of the L-curve from its lower left corner, each axis scaled to its span between the singular values."""
    here = sweep.between

    def scaled(values: np.ndarray) -> np.ndarray:
        low, span = values.min(axis=-1, keepdims=True), np.ptp(values, axis=-1, keepdims=True)
        return np.divide(values - low, span, out=np.zeros_like(values), where=span > 0)

    curve = np.full_like(sweep.residual, np.inf)
    if here.any():
        curve[:, here] = np.hypot(*(scaled(values[:, here]) for values in _bends(sweep)))
    return curve


def discrepancy(sweep: Sweep) -> np.ndarray:
    """Morozov's principle: |r|^2 against the sum of squares that the error alone has, as a ratio.

    Raises:
        InputError: the size of the error is not known.
    """
    if sweep.expected is None:
        raise InputError("alpha by discrepancy needs the size of the error: give --noise-level.")
    return sweep.residual / sweep.expected[:, None]


def ncp(sweep: Sweep) -> np.ndarray:
    """How far the residual is from white noise along the discounts: distance of its cumulative periodogram from a line.

    The periodogram is summed over the columns; its mean over the discounts is left out.

    Raises:
        InputError: fewer than 4 discounts, which have no spectrum.
    """
    if sweep.discounts < 4:
        raise InputError(f"alpha by ncp needs at least 4 discounts; there are {sweep.discounts}.")
    power = sweep.power(np.fft.rfft(np.eye(sweep.discounts), axis=0)[1:])
    running = np.cumsum(power, axis=-1)
    total = running[..., -1:]
    running = np.divide(running, total, out=np.zeros_like(running), where=total > 0)
    count = power.shape[-1]
    return np.linalg.norm(running - np.arange(1, count + 1) / count, axis=-1)


def quasiopt(sweep: Sweep) -> np.ndarray:
    """Quasi-optimality: how much L x changes from one alpha to the next, as a norm, between the singular values.

    Beyond them nothing changes, and that says nothing.
    """
    curve = np.full_like(sweep.residual, np.inf)
    free = sweep.spectrum.free
    changes = np.diff(sweep.kept[:, free:], axis=0)
    curve[:, :-1] = np.sqrt(sweep.energy[:, free:] @ (changes**2).T)
    curve[:, ~sweep.between] = np.inf
    return curve


def fitted(sweep: Sweep) -> np.ndarray:
    """How far alpha is from the formula of :mod:`laplace_core.inverse.auto`, as a logarithm; one for all groups."""
    off = np.abs(np.log(sweep.alphas / auto_alpha(sweep)))
    return np.broadcast_to(off, (len(sweep.energy), off.size))


SELECTORS: Mapping[str, Callable[[Sweep], np.ndarray]] = {
    "gcv": gcv,
    "rgcv": rgcv,
    "loo": loo,
    "aic": aic,
    "bic": bic,
    "lcurve": lcurve,
    "corner": corner,
    "discrepancy": discrepancy,
    "ncp": ncp,
    "quasiopt": quasiopt,
    "fitted": fitted,
}
"""From a sweep to the function of alpha, ``(n, a)``, that a rule makes small; infinity where it has no value."""
ALPHA_CHOICES = (TYPED, "auto", *SELECTORS)


def chosen_index(rule: str, curve: np.ndarray) -> np.ndarray:
    """Which alpha a rule takes by its curve ``(n, a)``, int ``(n,)``: the smallest value, of equals the largest alpha.

    ``discrepancy`` takes the largest alpha whose residual is no larger than the error's, or the first one.
    """
    if rule == "discrepancy":
        return np.maximum(0, (curve <= 1.0).sum(axis=-1) - 1)
    return curve.shape[-1] - 1 - np.argmin(curve[:, ::-1], axis=-1)


@dataclass(frozen=True)
class AlphaRecord:
    """How an alpha was chosen; plain numbers and words, so that it can be kept as JSON.

    Attributes:
        rule: as it was asked for: ``typed``, ``auto`` or a rule.
        value: the alpha; a tuple, one for each bin, where each has its own.
        criterion: the rule that decided; None of a typed value.
        solver: the linear solver that the rule looked at.
        alphas: every alpha that was tried.
        curve: the criterion at each of them; None where it has no value. A tuple of curves where each bin has its own.
        edge: ``lower`` or ``upper`` where the choice is the first or last alpha with a value, so that the true optimum
            may lie beyond; else ``none``. A tuple where each bin has its own.
        others: what each rule that can be computed would have chosen.
        noise: ``(G,)``, standard deviation of the error at each discount that was assumed; None if none was.
    """

    rule: str
    value: float | tuple[float, ...]
    criterion: str | None = None
    solver: str | None = None
    alphas: tuple[float, ...] = ()
    curve: tuple[Any, ...] = ()
    edge: str | tuple[str, ...] = "none"
    others: Mapping[str, float | tuple[float, ...]] = field(default_factory=dict)
    noise: tuple[float, ...] | None = None

    def as_json(self) -> str:
        """The record as strict JSON."""
        return json.dumps(asdict(self), allow_nan=False)


def choose_alpha(
    problem: Problem,
    solver: str,
    rule: str,
    *,
    noise: np.ndarray | None = None,
    each_bin: bool = False,
    alphas: np.ndarray | None = None,
) -> AlphaRecord:
    """Alpha by a rule, with the record of how it was chosen.

    One alpha for a whole space is chosen on its tails, because their errors are independent; see
    :class:`laplace_core.inverse.components.Sweep`.

    Args:
        solver: one of ``SOLVERS``; for one that is not linear the rules look at Tikhonov, whose penalty it shares.
        rule: one of ``SELECTORS``, or ``auto``.
        noise: ``(G,)``, standard deviation of the error of one sensitivity's value at each discount.
        each_bin: whether every bin has its own alpha.
        alphas: those to try, increasing.

    Raises:
        InputError: no such rule, or one that lacks what it needs.
    """
    criterion = AUTO if rule == "auto" else rule
    if criterion not in SELECTORS:
        raise InputError(f"alpha {rule!r} is neither a number nor one of auto, {', '.join(SELECTORS)}.")
    sweep = sweep_of(problem, solver, alphas=alphas, noise=noise, each_bin=each_bin)
    curves = {criterion: SELECTORS[criterion](sweep)} | curves_of(sweep, without=criterion)

    def plain(values: np.ndarray) -> Any:
        listed = values.tolist()
        return tuple(listed) if each_bin else listed[0]

    at = {name: chosen_index(name, curve) for name, curve in curves.items()}
    return AlphaRecord(
        rule=rule,
        value=plain(sweep.alphas[at[criterion]]),
        criterion=criterion,
        solver=sweep.solver,
        alphas=tuple(sweep.alphas.tolist()),
        curve=plain_curve(curves[criterion], each_bin=each_bin),
        edge=plain(_edges(curves[criterion], at[criterion])),
        others={name: plain(sweep.alphas[index]) for name, index in at.items() if name != criterion},
        noise=None if noise is None else tuple(np.asarray(noise, dtype=float).tolist()),
    )


def curves_of(sweep: Sweep, *, without: str | None = None) -> dict[str, np.ndarray]:
    """The curve of every rule that can be computed, ``(n, a)`` each."""
    lacking = {"discrepancy"} if sweep.expected is None else set()
    lacking |= {"ncp"} if sweep.discounts < 4 else set()
    lacking |= set() if is_fitted(sweep.target) else {AUTO}
    return {name: curve(sweep) for name, curve in SELECTORS.items() if name not in lacking and name != without}


def plain_curve(curve: np.ndarray, *, each_bin: bool = False) -> tuple[Any, ...]:
    """A curve ``(n, a)`` as plain numbers, None for those that are not finite."""
    listed = [tuple(value if math.isfinite(value) else None for value in one) for one in curve.tolist()]
    return tuple(listed) if each_bin else listed[0]


def _edges(curve: np.ndarray, chosen: np.ndarray) -> np.ndarray:
    """For each group, whether the choice is the first or last alpha whose value is finite."""
    finite = np.isfinite(curve)
    first = np.argmax(finite, axis=-1)
    last = curve.shape[-1] - 1 - np.argmax(finite[:, ::-1], axis=-1)
    return np.where(chosen <= first, "lower", np.where(chosen >= last, "upper", "none"))
