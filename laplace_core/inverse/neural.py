"""The neural inverse (paper, section 6): two small networks from masses over the discounts to a feasible timeline.

The first network looks at one bin at a time, with the same weights for all, so that any sensitivities will do. It adds
to a regularised linear inverse of the bin what the masses of real episodes look like. The second one looks at the
constant channel and gives the chance of ending at each step; their product is survival, which begins at 1 and never
increases. Each row of masses is then moved to the nearest one that is not negative and sums to survival. What remains
after the last row needs no place: survival may be above 0 there.

Both are trained for one grid of discounts (:mod:`laplace_core.training.neural_inverse`) and take the size of the
noise as an input. Here they are run in NumPy, so that no network library is loaded.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from laplace_core.caching import cached
from laplace_core.errors import InputError
from laplace_core.files.tensor_file import read_tensors, write_tensors
from laplace_core.inverse.problem import Problem, Solution
from laplace_core.inverse.transform import MAX_STEPS, transform_matrix

NOISE_RANGE = (1e-6, 0.05)
"""Standard deviations of (1 - gamma) Q that networks are trained for; others are taken for the nearest."""
ASSUMED_NOISE = 1e-3
"""Where a problem does not say its own."""
HIDDEN = 256
"""Width of the hidden layers."""
MOST_DISCOUNTS = 500
SHIPPED = Path(__file__).resolve().parents[2] / "checkpoints" / "inverse"

_KIND, _VERSION = "laplace neural inverse", 1
_MAX_BYTES = 8_000_000
_LARGEST_WEIGHT = 1e4


class Inputs(NamedTuple):
    """What the networks see of masses over the discounts.

    Attributes:
        bins: ``(..., B, 2 r + 2)``, input of the first network.
        linear: ``(..., B, r)``, coefficients of the linear inverse, before ``scale``.
        scale: ``(..., B, 1)``, size of each bin.
        constant: ``(..., r + 2)``, input of the second network.
    """

    bins: np.ndarray
    linear: np.ndarray
    scale: np.ndarray
    constant: np.ndarray


@cached(8)
def scaled_factors(gammas: bytes, steps: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """SVD of (1 - gamma) F, whose values are probabilities with the same noise at every discount."""
    grid = np.frombuffer(gammas)
    U, s, Vt = np.linalg.svd((1.0 - grid)[:, None] * transform_matrix(grid, steps), full_matrices=False)
    return U, s, Vt


def inputs_of(masses: np.ndarray, gammas: np.ndarray, steps: int, noise: np.ndarray | float) -> Inputs:
    """Inputs of both networks.

    Every bin is divided by its own size, and its coefficients in the singular vectors of the transform are damped where
    noise is larger than they are: a network need not learn to divide by small singular values.

    Args:
        masses: ``(..., G, B)``, over the discounts.
        noise: standard deviation of (1 - gamma) Q, one for all or ``(...)``.
    """
    U, s, _ = scaled_factors(np.asarray(gammas, dtype=float).tobytes(), steps)
    probabilities = np.swapaxes((1.0 - gammas)[:, None] * masses, -1, -2)  # (..., B, G)
    noise = np.asarray(noise, dtype=float)[..., None]
    # A mass is a difference of two values, so its noise is sqrt(2) times theirs.
    linear, scale, level = _damped(probabilities, np.sqrt(2.0) * noise[..., None], U, s)
    alone, size, constant_level = _damped(probabilities.sum(axis=-2), noise, U, s)
    constant = np.concatenate([np.arcsinh(alone), np.log(constant_level), np.log(size)], axis=-1)
    shared = np.broadcast_to(np.arcsinh(alone)[..., None, :], linear.shape)
    bins = np.concatenate([np.arcsinh(linear), shared, np.log(level), np.log(scale)], axis=-1)
    return Inputs(bins, linear, scale, constant)


def _damped(values: np.ndarray, noise: np.ndarray, U: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, ...]:
    """Damped coefficients by the size of the values ``(..., G)``, that size, and the noise by it."""
    scale = np.sqrt((values**2).mean(axis=-1, keepdims=True) + noise**2)
    level = noise / scale
    return values @ U / scale * (s / (s**2 + level**2)), scale, level


def onto_rows(masses: np.ndarray, sums: np.ndarray) -> np.ndarray:
    """The nearest rows ``(..., B)`` that are not negative and have these sums ``(...)``, each at least 0.

    What lies above a threshold, less the threshold, which is found among the sorted masses (Duchi et al., 2008).
    """
    ordered = np.sort(masses, axis=-1)[..., ::-1]
    excess = (np.cumsum(ordered, axis=-1) - sums[..., None]) / np.arange(1, masses.shape[-1] + 1)
    last = np.maximum((ordered > excess).sum(axis=-1, keepdims=True) - 1, 0)
    return np.maximum(masses - np.take_along_axis(excess, last, axis=-1), 0.0)


@dataclass(frozen=True, eq=False)
class NeuralInverse:
    """Trained networks of one grid of discounts.

    Attributes:
        gammas: ``(G,)``, increasing.
        steps: K, rows that they give.
        weights: by name, of the shapes that :func:`shapes` gives.
        about: how they were trained: seed, updates, samples.
    """

    gammas: np.ndarray
    steps: int
    weights: dict[str, np.ndarray]
    about: dict[str, int]

    def solve(self, problem: Problem) -> Solution:
        """The feasible timeline of a problem.

        Degrees of freedom are not defined for a network: they are nan.

        Raises:
            InputError: other discounts, more rows, or rows that do not lie a step apart.
        """
        if not matches(self.gammas, problem.gammas):
            raise InputError(f"this neural inverse was trained for other discounts: train one with {train_command()}.")
        if problem.steps > self.steps:
            raise InputError(
                f"this neural inverse gives {self.steps} rows and not {problem.steps}: lower steps, or train another "
                f"with {train_command()}."
            )
        if problem.time_step != 1.0:
            raise InputError("the neural inverse works only with a time step of 1: set time-step to 1.")
        if not problem.starts_alive:
            raise InputError("the neural inverse does not work for terminal states: choose another solver.")
        masses = self.timeline(problem.masses, noise_of(problem))[..., : problem.steps, :]
        residual = problem.masses - problem.transform @ masses
        return Solution(masses, residual, np.full(problem.masses.shape[:-2], np.nan), masses == 0.0)

    def timeline(self, masses: np.ndarray, noise: float) -> np.ndarray:
        """Masses over the discounts ``(..., G, B)`` to masses over time, ``(..., steps, B)``."""
        seen = inputs_of(masses, self.gammas, self.steps, noise)
        _, _, Vt = scaled_factors(self.gammas.tobytes(), self.steps)
        free = seen.scale * (seen.linear @ Vt + self._network(seen.bins, "bins"))  # (..., B, K)
        ending = 1.0 / (1.0 + np.exp(-np.clip(self._network(seen.constant, "survival"), -30.0, 30.0)))
        first = np.ones((*ending.shape[:-1], 1))
        survival = np.concatenate([first, np.cumprod(1.0 - ending, axis=-1)], axis=-1)
        return onto_rows(np.swapaxes(free, -1, -2), survival)

    def _network(self, x: np.ndarray, name: str) -> np.ndarray:
        """Three layers with x * sigmoid(x) between them."""
        for layer in range(3):
            if layer:
                x = x / (1.0 + np.exp(-np.clip(x, -60.0, 60.0)))
            x = x @ self.weights[f"{name}.{layer}.weight"].T + self.weights[f"{name}.{layer}.bias"]
        return x


def noise_of(problem: Problem) -> float:
    """Standard deviation of (1 - gamma) Q that a problem states, within :data:`NOISE_RANGE`."""
    if problem.deviations is None:
        return ASSUMED_NOISE
    size = float(np.sqrt(np.mean(((1.0 - problem.gammas) * problem.deviations) ** 2)))
    return float(np.clip(size, *NOISE_RANGE))


def matches(gammas: np.ndarray, others: np.ndarray) -> bool:
    """Whether two grids of discounts are the same, but for rounding of float32."""
    return gammas.shape == others.shape and bool(np.allclose(1.0 - gammas, 1.0 - others, rtol=1e-5, atol=0.0))


def train_command() -> str:
    return "`laplace train-inverse --gammas N --spacing S --steps K --out FILE.safetensors`"


def shapes(discounts: int, steps: int, hidden: int = HIDDEN) -> dict[str, tuple[int, ...]]:
    """Shapes of all weights, by name."""
    rank = min(discounts, steps)
    found: dict[str, tuple[int, ...]] = {}
    for name, first, last in (("bins", 2 * rank + 2, steps), ("survival", rank + 2, steps - 1)):
        widths = (first, hidden, hidden, last)
        for layer in range(3):
            found[f"{name}.{layer}.weight"] = (widths[layer + 1], widths[layer])
            found[f"{name}.{layer}.bias"] = (widths[layer + 1],)
    return found


# --- files ---


def save_network(network: NeuralInverse, path: str | Path) -> None:
    """Write a network as one .safetensors file, whole or not at all; weights as float32."""
    arrays = {name: array.astype(np.float32) for name, array in network.weights.items()}
    about = {"kind": _KIND, "version": _VERSION, "steps": network.steps, "hidden": HIDDEN, "trained": network.about}
    write_tensors(Path(path), arrays | {"gammas": network.gammas}, about)


def read_network(path: str | Path) -> NeuralInverse:
    """Read what :func:`save_network` wrote, from an untrusted source.

    Raises:
        InputError: one sentence for whatever is wrong first.
    """
    arrays, about = read_tensors(path, _MAX_BYTES)
    name = repr(Path(path).name)
    if about.get("kind") != _KIND or about.get("version") != _VERSION:
        raise InputError(f"{name} holds no neural inverse of this version: make one with {train_command()}.")
    if set(about) != {"kind", "version", "steps", "hidden", "trained"} or about["hidden"] != HIDDEN:
        raise InputError(f"the metadata of {name} are not those of a neural inverse.")
    steps, gammas = about["steps"], arrays.pop("gammas", None)
    if type(steps) is not int or not 2 <= steps <= MAX_STEPS:
        raise InputError(f"'steps' in {name} must be a whole number from 2 to {MAX_STEPS}.")
    if gammas is None or gammas.dtype != np.float64 or gammas.ndim != 1 or not 2 <= gammas.size <= MOST_DISCOUNTS:
        raise InputError(f"'gammas' in {name} must be 2 to {MOST_DISCOUNTS} float64 numbers.")
    if not np.all(np.diff(np.concatenate([[0.0], gammas, [1.0]])) > 0):
        raise InputError(f"'gammas' in {name} must be increasing numbers between 0 and 1.")
    wanted = shapes(gammas.size, steps)
    if set(arrays) != set(wanted):
        raise InputError(f"{name} has other tensors than a neural inverse of {gammas.size} discounts.")
    for key, shape in wanted.items():
        array = arrays[key]
        if array.shape != shape or array.dtype != np.float32:
            raise InputError(f"the tensor {key!r} in {name} must be float32 of shape {list(shape)}.")
        if not np.all(np.abs(array) <= _LARGEST_WEIGHT):  # also false for nan
            raise InputError(f"the tensor {key!r} in {name} has a weight that is too large or not a number.")
    weights = {key: array.astype(np.float64) for key, array in arrays.items()}
    return NeuralInverse(gammas, steps, weights, _trained(about["trained"], name))


def _trained(entry: Any, name: str) -> dict[str, int]:
    if not isinstance(entry, dict) or not all(type(value) is int and value >= 0 for value in entry.values()):
        raise InputError(f"'trained' in {name} must be whole numbers by name.")
    return entry


def shipped_network(gammas: np.ndarray) -> NeuralInverse:
    """The network that ships for a grid of discounts.

    Raises:
        InputError: none does; the sentence names the command that trains one.
    """
    for path in sorted(SHIPPED.glob("*.safetensors")):
        network = _read_once(path)
        if matches(network.gammas, np.asarray(gammas, dtype=float)):
            return network
    raise InputError(
        f"no neural inverse ships for these {len(gammas)} discounts: train one with {train_command()} and read it."
    )


def solve(problem: Problem) -> Solution:
    """A problem solved by the network that ships for its discounts.

    Raises:
        InputError: none does, or it is a problem that no network is for (:meth:`NeuralInverse.solve`).
    """
    return shipped_network(problem.gammas).solve(problem)


@cached(8)
def _read_once(path: Path) -> NeuralInverse:
    return read_network(path)
