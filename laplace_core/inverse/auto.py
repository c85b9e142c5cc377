"""The selector ``auto``: alpha by a small network that was fitted to worlds of known truth.

Rules such as cross-validation make the *prediction* of gamma-space best. What a timeline needs is more smoothing, by a
factor that depends on the transform and on the data, and no rule knows it. Here log alpha is a function of a few
numbers that any problem has (:data:`FEATURES`): among them two rules that need no noise level, marginal likelihood and
quasi-optimality, both on the masses that are to be decoded, and a profile of what Tikhonov would leave of the masses at
a dozen alphas (:data:`PROFILE`). For each linear solver and the non-negative one, with and without deviations of the
discounts, a network of two hidden layers gives log alpha; for the feasible one, of which examples are few, a weighted
sum of the first eight numbers and of what the network says for Tikhonov. Both are those which come nearest to the
alphas whose timelines are nearest to the truth (``python -m laplace_core report auto``). How good the result is on
other worlds: ``python -m laplace_core study``.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.inverse.components import Energies, Sweep, reached
from laplace_core.inverse.linear import shares_kept, shares_lost

PROFILE = 12
"""Alphas of the profile, from 1e-5 to 1 times the largest singular value."""
SUMMED = ("one", "likelihood", "quasiopt", "masses", "constant", "steps", "time_step", "largest")
"""1; logarithms of the alphas of greatest marginal likelihood and of quasi-optimality; of the mean square of the masses
and of that of the tails; of the number of rows, of the time from one to the next, and of the largest singular value. Of
a slow solver the sum goes over these and the log alpha of Tikhonov's network."""
FEATURES = (*SUMMED, *(f"{name} {i}" for name in ("misfit", "lost") for i in range(PROFILE)))
"""These, then logarithms of the profile: of the share of the masses' energy that Tikhonov leaves, and of how many
components it loses."""
FARTHEST = 3.0
"""Standard deviations from the mean of the examples at which a feature counts as no farther."""
COEFFICIENTS = Path(__file__).with_suffix(".json")
_ALPHAS = 120
_LEAST, _LEAST_LOST = 1e-30, 1e-9


def features(sweep: Sweep) -> np.ndarray:
    """The numbers of a problem by which alpha is chosen, ``(32,)``.

    Args:
        sweep: of a whole space.
    """
    spectrum = sweep.spectrum
    s = spectrum.s[spectrum.usable]
    largest = float(s[0]) if s.size else spectrum.largest
    outside = np.trace(sweep.outside, axis1=-2, axis2=-1)
    tails = float(sweep.energy.sum() + outside.sum()) / (len(sweep.energy) * sweep.columns)
    rows, time_step = len(spectrum.rows), sweep.time_step
    lost = _lost(sweep, np.geomspace(1e-5, 1.0, PROFILE) * largest)
    misfit = lost @ _smoothed(sweep, sweep.masses) + sweep.masses.outside
    return np.concatenate(
        [
            [
                1.0,
                np.log(likelihood_alpha(sweep)),
                np.log(quasi_optimal_alpha(sweep)),
                np.log(sweep.masses.total + _LEAST),
                np.log(tails + _LEAST),
                np.log(rows),
                np.log(time_step),
                np.log(largest),
            ],
            np.log(misfit + _LEAST) - np.log(sweep.masses.total + _LEAST),
            np.log(np.maximum(lost.sum(axis=1), _LEAST_LOST)),
        ]
    )


@dataclass(frozen=True, eq=False)
class Network:
    """Log alpha from features: two hidden layers of tanh over standardised features.

    Attributes:
        mean, scale: of the features of the examples, ``(32,)``.
        layers: weights ``(out, in)`` and biases ``(out,)`` of each layer.
    """

    mean: np.ndarray
    scale: np.ndarray
    layers: tuple[tuple[np.ndarray, np.ndarray], ...]

    def log_alpha(self, numbers: np.ndarray) -> np.ndarray:
        """``(...)`` for features ``(..., 32)``."""
        seen = np.clip((numbers - self.mean) / self.scale, -FARTHEST, FARTHEST)
        for weights, biases in self.layers[:-1]:
            seen = np.tanh(seen @ weights.T + biases)
        weights, biases = self.layers[-1]
        return (seen @ weights.T + biases)[..., 0]


def auto_alpha(sweep: Sweep) -> float:
    """The alpha of ``auto`` for a problem.

    Raises:
        InputError: a solver that has no coefficients.
    """
    networks, sums = _fitted()
    weighting = "equal" if sweep.spectrum.weights is None else "weighted"
    numbers = features(sweep)
    if sweep.target in networks:
        log_alpha = float(networks[sweep.target][weighting].log_alpha(numbers))
    elif sweep.target in sums:
        log_alpha = float(summed(numbers, networks["tikhonov"][weighting]) @ sums[sweep.target][weighting])
    else:
        known = ", ".join((*networks, *sums))
        raise InputError(f"alpha auto works for the solvers {known}, not for {sweep.target}: choose another rule.")
    return float(np.clip(np.exp(log_alpha), sweep.alphas[0], sweep.alphas[-1]))


def is_fitted(solver: str) -> bool:
    """Whether ``auto`` has coefficients for a solver."""
    return any(solver in known for known in _fitted())


def summed(numbers: np.ndarray, tikhonov: Network) -> np.ndarray:
    """What the sum of a slow solver goes over, ``(..., 9)``, from features ``(..., 32)``."""
    return np.concatenate([numbers[..., : len(SUMMED)], tikhonov.log_alpha(numbers)[..., None]], axis=-1)


@cache
def _fitted() -> tuple[dict[str, dict[str, Network]], dict[str, dict[str, np.ndarray]]]:
    """Networks and weights of sums, by solver and by whether the discounts are weighted."""
    held = json.loads(COEFFICIENTS.read_text(encoding="utf-8"))
    networks = {
        solver: {weighting: network_of(numbers) for weighting, numbers in sets.items()}
        for solver, sets in held["networks"].items()
    }
    sums = {
        solver: {weighting: np.array(numbers) for weighting, numbers in sets.items()}
        for solver, sets in held["coefficients"].items()
    }
    return networks, sums


def network_of(numbers: dict[str, Any]) -> Network:
    """A network from plain lists."""
    layers = tuple((np.array(weights), np.array(biases)) for weights, biases in numbers["layers"])
    return Network(np.array(numbers["mean"]), np.array(numbers["scale"]), layers)


def _lost(sweep: Sweep, alphas: np.ndarray) -> np.ndarray:
    """Share of each smoothed component that Tikhonov leaves at each alpha, ``(a, r - free)``."""
    lost = shares_lost(sweep.spectrum, alphas, "tikhonov")[:, reached(sweep.spectrum)]
    return lost[:, sweep.spectrum.free :]


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
    lost = _lost(sweep, alphas)
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
