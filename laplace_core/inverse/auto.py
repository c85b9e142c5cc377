"""The selector ``auto``: alpha by a linear formula whose coefficients were fitted to worlds of known truth.

Rules such as cross-validation make the *prediction* of gamma-space best. What a timeline needs is more smoothing, by a
factor that depends on the transform, and no rule knows it. Here log alpha is a weighted sum of a few numbers that any
problem has (:data:`FEATURES`), among them two rules that need no noise level: marginal likelihood and quasi-optimality,
both on the masses that are to be decoded. The coefficients are those which come nearest to the alphas whose timelines
are nearest to the truth (``python -m laplace_core report auto``), one set for each solver, with and without
deviations of the discounts. How good the result is on other worlds: ``python -m laplace_core study``.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np

from laplace_core.errors import InputError
from laplace_core.inverse.components import Energies, Sweep, reached
from laplace_core.inverse.linear import shares_kept, shares_lost

FEATURES = ("one", "likelihood", "quasiopt", "masses", "constant", "steps", "time_step", "largest")
"""1; logarithms of the alphas of greatest marginal likelihood and of quasi-optimality; of the mean square of the masses
and of that of the tails; of the number of rows, of the time from one to the next, and of the largest singular value."""
COEFFICIENTS = Path(__file__).with_suffix(".json")
_ALPHAS = 120
_LEAST = 1e-30


def features(sweep: Sweep) -> np.ndarray:
    """The numbers of a problem by which alpha is chosen, ``(8,)``.

    Args:
        sweep: of a whole space.
    """
    spectrum = sweep.spectrum
    s = spectrum.s[spectrum.usable]
    largest = float(s[0]) if s.size else spectrum.largest
    outside = np.trace(sweep.outside, axis1=-2, axis2=-1)
    tails = float(sweep.energy.sum() + outside.sum()) / (len(sweep.energy) * sweep.columns)
    rows, time_step = len(spectrum.rows), sweep.time_step
    return np.array(
        [
            1.0,
            np.log(likelihood_alpha(sweep)),
            np.log(quasi_optimal_alpha(sweep)),
            np.log(sweep.masses.total + _LEAST),
            np.log(tails + _LEAST),
            np.log(rows),
            np.log(time_step),
            np.log(largest),
        ]
    )


def auto_alpha(sweep: Sweep) -> float:
    """The alpha of ``auto`` for a problem.

    Raises:
        InputError: a solver that has no coefficients.
    """
    known = _coefficients()
    if sweep.target not in known:
        raise InputError(f"alpha auto is for the solvers {', '.join(known)}, not for {sweep.target}.")
    weights = known[sweep.target]["equal" if sweep.spectrum.weights is None else "weighted"]
    low, high = sweep.alphas[0], sweep.alphas[-1]
    return float(np.clip(np.exp(features(sweep) @ weights), low, high))


@cache
def _coefficients() -> dict[str, dict[str, np.ndarray]]:
    """By solver, and by whether the discounts are weighted."""
    text = COEFFICIENTS.read_text(encoding="utf-8")
    return {
        solver: {weighting: np.array(numbers) for weighting, numbers in sets.items()}
        for solver, sets in json.loads(text)["coefficients"].items()
    }


def _grid(sweep: Sweep) -> np.ndarray:
    s = sweep.spectrum.s[sweep.spectrum.usable]
    return np.geomspace(s[-1] / 100.0, 10.0 * s[0], _ALPHAS) if s.size else np.array([sweep.spectrum.largest])


def _smoothed(sweep: Sweep, energies: Energies) -> np.ndarray:
    """Energies of the components that are smoothed, ``(r - free,)``."""
    return energies.components[sweep.spectrum.free :]


def likelihood_alpha(sweep: Sweep) -> float:
    """Alpha of greatest marginal likelihood of the masses, where L x and the errors are normal and independent.

    n log(sum of lost e) - m sum of log lost, with e the energy and lost the share of each component that Tikhonov
    leaves, over m columns (Wahba, Ann. Statist. 13 (1985) 1378).
    """
    alphas = _grid(sweep)
    lost = shares_lost(sweep.spectrum, alphas, "tikhonov")[:, reached(sweep.spectrum)][:, sweep.spectrum.free :]
    count = lost.shape[1]
    if not count:
        return float(alphas[0])
    misfit = lost @ _smoothed(sweep, sweep.masses) + sweep.masses.outside
    curve = count * np.log(misfit + _LEAST) - np.log(lost).sum(axis=1)
    return float(alphas[np.argmin(curve)])


def quasi_optimal_alpha(sweep: Sweep) -> float:
    """Alpha at which the masses that are decoded with Tikhonov change least, between the singular values."""
    alphas = _grid(sweep)
    s = sweep.spectrum.s[sweep.spectrum.usable]
    if alphas.size == 1:
        return float(alphas[0])
    kept = shares_kept(sweep.spectrum, alphas, "tikhonov")[:, reached(sweep.spectrum)][:, sweep.spectrum.free :]
    changes = (np.diff(kept, axis=0) ** 2) @ _smoothed(sweep, sweep.masses)
    here = (alphas[:-1] >= min(s[-1] / 2.0, s[0] / 100.0)) & (alphas[:-1] <= s[0])
    changes = np.where(here, changes, np.inf)
    return float(alphas[changes.size - 1 - np.argmin(changes[::-1])])
