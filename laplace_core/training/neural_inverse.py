"""Training the neural inverse of one grid of discounts, on timelines that are drawn without a world.

The networks, and how they are run, are described in :mod:`laplace_core.inverse.neural`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from laplace_core.errors import InputError
from laplace_core.inverse.neural import (
    MOST_DISCOUNTS,
    NOISE_RANGE,
    NeuralInverse,
    inputs_of,
    scaled_factors,
    shapes,
)
from laplace_core.inverse.timelines import Timelines, draw_timelines
from laplace_core.inverse.transform import transform_matrix

BINS = 8
"""Of a training timeline; at most five of them are used, so that empty ones are learned as well."""
MOST_STEPS = 500


@dataclass(frozen=True)
class Progress:
    """Mean loss of the updates since the last report, in steps by their distance, and how many updates were made."""

    update: int
    loss: float


def train(
    gammas: np.ndarray, steps: int, *, seed: int = 0, updates: int = 6_000, samples: int = 16_000, batch: int = 96,
    report: Callable[[Progress], None] = lambda progress: None,
) -> NeuralInverse:  # fmt: skip
    """Networks for these discounts and this many rows; the same seed gives the same networks.

    Every update sees ``batch`` of ``samples`` timelines with new noise, of a size that is drawn again for each: evenly
    in its logarithm, over all sizes that the networks are for. The loss is the distance in time
    (:func:`laplace_core.inverse.distances.time_distance`), where a row counts in inverse proportion to its time: an
    error of a tenth of the time that has passed costs the same, late or early.

    Raises:
        InputError: a grid or numbers that networks are not made for.
    """
    gammas = np.asarray(gammas, dtype=float)
    transform_matrix(gammas, 2)  # refuses what are no discounts
    if not 2 <= gammas.size <= MOST_DISCOUNTS or not np.all(np.diff(gammas) > 0):
        raise InputError(f"the discounts must be 2 to {MOST_DISCOUNTS} increasing numbers.")
    if not 2 <= steps <= MOST_STEPS:
        raise InputError(f"steps is {steps}; a neural inverse has from 2 to {MOST_STEPS} rows.")
    rng = np.random.default_rng(seed)
    pool = draw_timelines(rng, samples, steps, BINS)
    values = _values(pool, gammas)
    weights = _initial(gammas.size, steps, seed)
    optimiser = torch.optim.Adam(weights.values(), lr=2e-3)
    schedule = torch.optim.lr_scheduler.LambdaLR(optimiser, lambda at: 0.5 * (1.0 + np.cos(np.pi * at / updates)))
    truth = torch.from_numpy(pool.masses.astype(np.float32))
    Vt = torch.from_numpy(scaled_factors(gammas.tobytes(), steps)[2].astype(np.float32))
    importance = 1.0 / (torch.arange(steps) + 2.0)
    since: list[float] = []
    for update in range(1, updates + 1):
        chosen = rng.integers(samples, size=batch)
        seen = inputs_of(*_noisy(rng, values[chosen], gammas, steps))
        tensors = [torch.from_numpy(part.astype(np.float32)) for part in seen]
        loss = _loss(weights, tensors, truth[torch.from_numpy(chosen)], Vt, importance=importance)
        optimiser.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(weights.values(), 1.0)
        optimiser.step()
        schedule.step()
        since.append(float(loss.detach()))
        if update % 100 == 0 or update == updates:
            report(Progress(update, float(np.mean(since))))
            since = []
    arrays = {name: weight.detach().numpy().astype(np.float64) for name, weight in weights.items()}
    return NeuralInverse(gammas, steps, arrays, {"seed": seed, "updates": updates, "samples": samples, "batch": batch})


def _values(pool: Timelines, gammas: np.ndarray) -> np.ndarray:
    """Exact masses over the discounts, ``(N, G, B)``."""
    parts = np.array_split(np.arange(len(pool.masses)), max(1, len(pool.masses) // 1000))
    return np.concatenate(
        [
            Timelines(pool.masses[some], pool.beyond[some], pool.endings[some]).transformed(gammas) for some in parts
        ]
    )  # fmt: skip


def _noisy(
    rng: np.random.Generator, values: np.ndarray, gammas: np.ndarray, steps: int
) -> tuple[np.ndarray, np.ndarray, int, np.ndarray]:
    """Arguments of ``inputs_of``: independent noise on the constant channel and on every tail, not on the masses."""
    low, high = np.log(NOISE_RANGE)
    noise = np.exp(rng.uniform(low, high, size=len(values)))
    errors = rng.normal(size=values.shape) * noise[:, None, None] / (1.0 - gammas)[:, None]
    return values + errors - np.pad(errors[..., 1:], [(0, 0), (0, 0), (0, 1)]), gammas, steps, noise


def _initial(discounts: int, steps: int, seed: int) -> dict[str, Tensor]:
    """Weights as He draws them, the last layer near 0: the first timeline is the linear inverse's."""
    generator = torch.Generator().manual_seed(seed)
    weights = {}
    for name, shape in shapes(discounts, steps).items():
        if name.endswith("bias"):
            weights[name] = torch.zeros(shape)
            if name == "survival.2.bias":
                weights[name] -= 4.0  # an episode rarely ends at any one step
        else:
            size = (2.0 / shape[1]) ** 0.5 * (0.01 if ".2." in name else 1.0)
            weights[name] = torch.randn(shape, generator=generator) * size
        weights[name].requires_grad_()
    return weights


def _network(weights: dict[str, Tensor], x: Tensor, name: str) -> Tensor:
    for layer in range(3):
        x = torch.nn.functional.silu(x) if layer else x
        x = torch.nn.functional.linear(x, weights[f"{name}.{layer}.weight"], weights[f"{name}.{layer}.bias"])
    return x


def onto_rows(masses: Tensor, sums: Tensor) -> Tensor:
    """:func:`laplace_core.inverse.neural.onto_rows`, with gradients."""
    ordered = masses.sort(dim=-1, descending=True).values
    excess = (ordered.cumsum(dim=-1) - sums[..., None]) / torch.arange(1, masses.shape[-1] + 1)
    last = ((ordered > excess).sum(dim=-1, keepdim=True) - 1).clamp(min=0)
    return torch.relu(masses - excess.gather(-1, last))


def _loss(
    weights: dict[str, Tensor], seen: list[Tensor], truth: Tensor, Vt: Tensor, *, importance: Tensor
) -> Tensor:  # fmt: skip
    bins, linear, scale, constant = seen
    free = (scale * (linear @ Vt + _network(weights, bins, "bins"))).transpose(-1, -2)  # (N, K, B)
    ending = torch.sigmoid(_network(weights, constant, "survival"))
    survival = torch.cat([torch.ones(len(ending), 1), torch.cumprod(1.0 - ending, dim=-1)], dim=-1)
    rows = onto_rows(free, survival)

    def distance(difference: Tensor) -> Tensor:
        return (difference.cumsum(dim=1).abs() * importance[:, None]).sum(dim=(1, 2)).mean()

    # What is cut off at 0 has no gradient: the masses before that are compared as well, for a part of the loss.
    ends = ((survival - truth.sum(dim=-1)).abs() * importance).sum(dim=1).mean()
    return distance(rows - truth) + 0.2 * distance(free - truth) + ends
