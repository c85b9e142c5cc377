"""Whether a bump that is called real with some probability is real that often."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from laplace_core.experiments.inverse.spaces import draw_space, one_action
from laplace_core.inverse.bands import (
    bump_probability,
    features,
    is_in,
    layer_noise,
    layers_of,
    survivals,
    tikhonov_of_layers,
)

MOST_ROWS = 60
DRAWS = 8
EDGES = (0.0, 0.2, 0.4, 0.6, 0.8, 1.0)
FITTED_ON = 10**6
"""Added to the seed of worlds that the calibration is fitted on, so that they are others."""
MOST_OFF = 0.05
FEWEST = 100
"""Bumps in a class, for it to be judged."""


def report(cases: int, seed: int) -> tuple[dict[str, Any], str]:
    """Numbers and text: predicted probability against the share that is real, by class, on ``cases`` worlds."""
    shares, ratios, real = _drawn(cases, seed)
    predicted = bump_probability(shares, ratios)
    rows = []
    for low, high in pairwise(EDGES):
        inside = (predicted >= low) & ((predicted < high) | (high == 1.0))
        if inside.any():
            rows.append(
                {
                    "low": low, "high": high, "bumps": int(inside.sum()),
                    "predicted": float(predicted[inside].mean()), "real": float(real[inside].mean()),
                }
            )  # fmt: skip
    lines = [f"{real.size} bumps of {cases} random worlds (seed {seed}): {real.mean():.0%} are real"]
    lines.append("probability     bumps   predicted    real")
    lines += [
        f"{r['low']:.1f} to {r['high']:.1f} {r['bumps']:12d} {r['predicted']:11.1%} {r['real']:7.1%}" for r in rows
    ]
    return {"seed": seed, "rows": rows, "bumps": int(real.size)}, "\n".join(lines)


def shortfalls(numbers: dict[str, Any]) -> list[str]:
    """Classes whose share is further from what was predicted than it should be."""
    judged = [r for r in numbers["rows"] if r["bumps"] >= FEWEST]
    return [f"{r['low']:.1f} to {r['high']:.1f}" for r in judged if abs(r["predicted"] - r["real"]) > MOST_OFF]


def fit(cases: int, seed: int) -> list[float]:
    """The log odds of :data:`laplace_core.inverse.bands.CALIBRATION`, by maximum likelihood on other worlds."""
    from scipy.optimize import minimize

    shares, ratios, real = _drawn(cases, seed + FITTED_ON)
    known, target = features(shares, ratios), real.astype(float)

    def loss(weights: np.ndarray) -> float:
        odds = known @ weights
        return float(np.logaddexp(0.0, odds).sum() - target @ odds + 0.05 * (weights[1:] ** 2).sum())

    return [round(float(weight), 2) for weight in minimize(loss, np.zeros(known.shape[1])).x]


def _drawn(cases: int, seed: int, first: int = 0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Shares, contrast over noise, and whether it is real, of every bump of one action of each world."""
    found = []
    for number in range(first, first + cases):
        rng = np.random.default_rng([seed, 3, number])
        space = draw_space(rng)
        action = int(rng.integers(space.world.n_actions))
        noise = float(np.exp(rng.uniform(np.log(1e-4), np.log(1e-2))))
        alpha = float(100.0 * noise * np.exp(0.7 * rng.normal()))
        rows = min(space.steps, MOST_ROWS)
        values = one_action(space.noisy(noise, rng), action)
        layers = layers_of(values, rows, space.deviations(noise))
        deviation = layer_noise(layers, alpha)
        truth = space.study.truth.expected_reward[action, :rows]
        for bump, shares in survivals(layers, alpha, tikhonov_of_layers, draws=DRAWS, seed=number)[0]:
            found.append((*shares, bump.contrast / deviation[bump.peak], bool(is_in(bump, truth))))
    table = np.array(found, dtype=float).reshape(-1, 5)
    return table[:, :3], table[:, 3], table[:, 4] > 0.5
