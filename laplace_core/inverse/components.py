"""What the rules for alpha need to know of the data: a few numbers for each component of the transform.

Everything that a rule asks (residual, size of the solution, degrees of freedom, spectrum of the residual) follows for
every alpha from the same sums over components, so that a sweep costs no decomposition and no solution.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from laplace_core.errors import InputError
from laplace_core.inverse.linear import LINEAR, shares_kept, shares_lost
from laplace_core.inverse.problem import Problem
from laplace_core.inverse.solvers import selecting, spectrum_for
from laplace_core.inverse.spectrum import Spectrum

SWEEP = 200
"""Alphas of a sweep."""


def sweep_alphas(spectrum: Spectrum, solver: str, count: int = SWEEP) -> np.ndarray:
    """Alphas worth trying, increasing: from a hundredth of the smallest usable singular value to ten of the largest.

    At the ends everything is fitted, or hardly anything. Truncation has no more results than components: one alpha for
    each number of them, halfway to the next in the logarithm. For all other solvers ``count`` alphas, evenly spaced in
    the logarithm.
    """
    s = spectrum.s[spectrum.usable]
    if not s.size:  # nothing is smoothed, whatever alpha is
        return np.array([spectrum.largest])
    if LINEAR[solver].filter == "truncated":
        return np.sqrt(s * np.append(s[1:], s[-1] / 2.0))[::-1]
    return np.geomspace(s[-1] / 100.0, 10.0 * s[0], count)


@dataclass(frozen=True, eq=False)
class Energies:
    """Mean squares of weighted data over their columns.

    Attributes:
        components: ``(r,)``, of each component.
        outside: sum over what no component reaches.
        columns: how many.
    """

    components: np.ndarray
    outside: float
    columns: int

    @property
    def total(self) -> float:
        """Mean over the columns of the sum over the discounts."""
        return float(self.components.sum()) + self.outside


def _energies(data: np.ndarray, directions: np.ndarray) -> Energies:
    """Of weighted data ``(G, m)``."""
    parts = ((directions.T @ data) ** 2).mean(axis=-1)
    return Energies(parts, max(0.0, float((data**2).sum(axis=0).mean() - parts.sum())), data.shape[-1])


@dataclass(frozen=True, eq=False)
class Sweep:
    """A problem at many alphas: n groups of columns, each of which is given one alpha, at a alphas.

    A group is what shares one alpha, its m columns are independent data for it. Of a whole space the columns are the
    *tails*, the constant channel and the values of all sensitivities of all actions: their errors are independent and
    of one size, whereas those of neighbouring masses correlate at -1/2. Of a single bin they are its masses, one an
    action, whose error has twice the variance (the last bin is a tail, and has it once).

    Attributes:
        spectrum: the components.
        solver: the linear solver.
        alphas: ``(a,)``, increasing.
        columns: m, in each group.
        inner: ``(n, r, r)``, products of the components of the weighted data, summed over the columns.
        outside: ``(n, G, G)``, the same of what no component reaches, over the discounts.
        cross: ``(n, G, r)``, the same of the one with the other.
        expected: ``(n,)``, sum of squares that the error alone has, over all discounts and columns; None where its
            size is not known.
        masses: components of the masses themselves, of all bins and actions.
        time_step: from one row to the next, in steps of the world.
        target: the solver that alpha is for; ``solver`` itself where that is linear.
    """

    spectrum: Spectrum
    solver: str
    alphas: np.ndarray
    columns: int
    inner: np.ndarray
    outside: np.ndarray
    cross: np.ndarray
    expected: np.ndarray | None
    masses: Energies
    time_step: float
    target: str

    @property
    def discounts(self) -> int:
        return len(self.spectrum.U)

    @property
    def energy(self) -> np.ndarray:
        """Square of each component, summed over the columns, ``(n, r)``."""
        return np.diagonal(self.inner, axis1=-2, axis2=-1)

    @cached_property
    def between(self) -> np.ndarray:
        """Which alphas lie between the singular values, where alpha decides between components, bool ``(a,)``.

        Below and above them all curves are flat or straight. At least two decades count, however few components are.
        """
        s = self.spectrum.s[self.spectrum.usable]
        if not s.size:
            return np.ones(self.alphas.size, dtype=bool)
        low = min(s[-1] / 2.0, s[0] / 100.0)
        return (low <= self.alphas) & (self.alphas <= s[0])

    @cached_property
    def kept(self) -> np.ndarray:
        """What the data of each component are multiplied by, ``(a, r)``."""
        return self._reached(shares_kept)

    @cached_property
    def lost(self) -> np.ndarray:
        """Share of each component that stays in the residual, ``(a, r)``."""
        return self._reached(shares_lost)

    def _reached(self, shares: Callable[[Spectrum, np.ndarray, str], np.ndarray]) -> np.ndarray:
        kind = LINEAR[self.solver].filter
        return shares(self.spectrum, self.alphas, kind)[:, reached(self.spectrum)]

    @cached_property
    def degrees(self) -> np.ndarray:
        """Effective degrees of freedom of one column, the trace of the influence matrix, ``(a,)``."""
        return (1.0 - self.lost).sum(axis=-1)

    @cached_property
    def left(self) -> np.ndarray:
        """Degrees of freedom that are left to the residual of one column, G - ``degrees``, ``(a,)``."""
        return self.lost.sum(axis=-1) + (self.discounts - self.lost.shape[-1])

    @cached_property
    def residual(self) -> np.ndarray:
        """Sum of squares of the weighted residual, ``(n, a)``."""
        beyond = np.trace(self.outside, axis1=-2, axis2=-1)
        return beyond[:, None] + self.energy @ (self.lost**2).T

    @cached_property
    def size(self) -> np.ndarray:
        """Sum of squares of L x, ``(n, a)``: of the solution itself at order 0."""
        free = self.spectrum.free
        return self.energy[:, free:] @ (self.kept[:, free:] ** 2).T

    def power(self, functionals: np.ndarray) -> np.ndarray:
        """Squares of linear functionals of the weighted residual, summed over the columns, ``(n, a, q)``.

        The residual is what lies outside plus the lost share of each component; its squares are a quadratic form in
        these shares, and need no residual of any alpha.

        Args:
            functionals: ``(q, G)``, perhaps complex.
        """
        T = functionals
        reach = T @ self.spectrum.U[:, reached(self.spectrum)]  # (q, r)
        own = np.real(((T @ self.outside) * T.conj()).sum(axis=-1))  # (n, q)
        mixed = np.real((T.conj() @ self.cross) * reach)  # (n, q, r)
        total = own[:, None] + 2.0 * self.lost @ mixed.swapaxes(-1, -2)
        pairs = np.real(reach[:, :, None] * reach[:, None, :].conj()).reshape(len(T), -1)  # (q, r r)
        shares = (self.lost[:, :, None] * self.lost[:, None, :]).reshape(len(self.lost), -1)  # (a, r r)
        for group, inner in enumerate(self.inner):  # one after the other: all at once they would fill the memory
            total[group] += shares @ (pairs * inner.ravel()).T
        return np.maximum(total, 0.0)


def reached(spectrum: Spectrum) -> np.ndarray:
    """Which components are more than rounding, bool ``(r,)``."""
    return np.concatenate([np.ones(spectrum.free, dtype=bool), spectrum.usable])


def sweep_of(
    problem: Problem,
    solver: str,
    *,
    alphas: np.ndarray | None = None,
    noise: np.ndarray | None = None,
    each_bin: bool = False,
) -> Sweep:
    """A problem at many alphas.

    Args:
        solver: one of ``SOLVERS``. One that is not linear has no influence matrix: the sweep is then that of
            ``ALPHA_OF``, whose penalty it shares.
        alphas: increasing; default :func:`sweep_alphas`.
        noise: ``(G,)``, standard deviation of the error of one sensitivity's value at each discount, in the units of
            the masses; None where its size is not known. That of ``problem.deviations`` may be relative.
        each_bin: whether every bin has its own alpha.

    Raises:
        InputError: no such solver, or noise that does not fit.
    """
    target, solver = solver, selecting(solver)
    spectrum, masses = spectrum_for(problem, solver), problem.masses
    G, bins = masses.shape[-2:]
    stacked = masses.reshape(-1, G, bins)
    if each_bin:
        data = np.ascontiguousarray(stacked.transpose(2, 1, 0))
    else:
        tails = np.cumsum(stacked[..., ::-1], axis=-1)
        data = np.ascontiguousarray(tails.transpose(1, 0, 2)).reshape(1, G, -1)
    data = spectrum.weighted(data)
    directions = spectrum.U[:, reached(spectrum)]
    components = directions.T @ data
    outside = data - directions @ components
    expected = None
    if noise is not None:
        if np.shape(noise) != (G,) or not np.all(np.isfinite(noise) & (np.asarray(noise) > 0)):
            raise InputError(f"the noise must be {G} numbers above 0, one for each discount.")
        error = spectrum.weighted(np.asarray(noise, dtype=float)[:, None])
        variances = np.array([2.0] * (bins - 1) + [1.0]) if each_bin else np.ones(1)
        expected = variances * data.shape[-1] * float((error**2).sum())
    return Sweep(
        spectrum=spectrum,
        solver=solver,
        alphas=sweep_alphas(spectrum, solver) if alphas is None else np.asarray(alphas, dtype=float),
        columns=data.shape[-1],
        inner=components @ components.swapaxes(-1, -2),
        outside=outside @ outside.swapaxes(-1, -2),
        cross=outside @ components.swapaxes(-1, -2),
        expected=expected,
        masses=_energies(spectrum.weighted(np.moveaxis(stacked, 1, 0).reshape(G, -1)), directions),
        time_step=problem.time_step,
        target=target,
    )
