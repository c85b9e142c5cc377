"""Whether a bump that is called real with some probability is real that often."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from laplace_core.experiments.inverse.spaces import draw_space, one_action
from laplace_core.inverse.bands import layers_of
from laplace_core.inverse.bumps import FEATURES, Calibration, calibration, is_in, judged

MOST_ROWS = 60
EDGES = (0.0, 0.2, 0.4, 0.6, 0.8, 1.0)
KNOTS = (-5.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 5.0)
"""Of the first guess of the log odds; see :class:`laplace_core.inverse.bumps.Calibration`."""
FITTED_ON = 10**6
"""Added to the seed of worlds that the calibration is fitted on, so that they are others."""
MOST_OFF = 0.05
FEWEST = 100
"""Bumps in a class, for it to be judged."""
_STEPS, _RIDGE, _FARTHEST = 60, 0.05, 500.0


def report(cases: int, seed: int) -> tuple[dict[str, Any], str]:
    """Numbers and text: predicted probability against the share that is real, by class, on ``cases`` worlds."""
    numbers, real = _drawn(cases, seed)
    predicted = calibration().probability(numbers)
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


def fit(cases: int, seed: int) -> dict[str, Any]:
    """The numbers of :class:`laplace_core.inverse.bumps.Calibration`, those of greatest likelihood on other worlds."""
    numbers, real = _drawn(cases, seed + FITTED_ON)
    fitted = fitted_calibration(numbers, real)
    return {
        "command": f"python -m laplace_core report inverse-bumps --fit --cases {cases}", "features": list(FEATURES),
        "weights": np.round(fitted.weights, 3).tolist(), "knots": fitted.knots.tolist(),
        "log_odds": np.round(fitted.log_odds, 3).tolist(),
    }  # fmt: skip


def fitted_calibration(numbers: np.ndarray, real: np.ndarray) -> Calibration:
    """The calibration for features ``(n, 12)`` of bumps of which ``real``, bool ``(n,)``, are."""
    weights, knots = _likeliest(numbers, real), np.array(KNOTS)
    guess = np.clip(numbers @ weights, knots[0], knots[-1])
    between = np.array([np.interp(guess, knots, one) for one in np.eye(len(knots))]).T
    log_odds = np.maximum.accumulate(_likeliest(between, real))  # a larger guess never means a smaller probability
    return Calibration(weights, knots, log_odds)


def _likeliest(numbers: np.ndarray, real: np.ndarray) -> np.ndarray:
    """Weights of a logistic regression, by Newton's method with a slight ridge."""
    weights, target = np.zeros(numbers.shape[1]), real.astype(float)
    for _ in range(_STEPS):
        chances = 1.0 / (1.0 + np.exp(-np.clip(numbers @ weights, -_FARTHEST, _FARTHEST)))
        slope = numbers.T @ (chances - target) + _RIDGE * weights
        curvature = (numbers.T * (chances * (1.0 - chances))) @ numbers + _RIDGE * np.eye(len(weights))
        move = np.linalg.solve(curvature, slope)
        weights = weights - move / max(1.0, float(np.abs(move).max()))  # a step of at most 1
    return weights


def _drawn(cases: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Features, ``(n, 12)``, and whether it is real, bool ``(n,)``, of every bump of one action of each world."""
    found: list[np.ndarray] = [np.zeros((0, len(FEATURES)))]
    real: list[bool] = []
    for number in range(cases):
        rng = np.random.default_rng([seed, 3, number])
        space = draw_space(rng)
        action = int(rng.integers(space.world.n_actions))
        noise = float(np.exp(rng.uniform(np.log(1e-4), np.log(1e-2))))
        alpha = float(100.0 * noise * np.exp(0.7 * rng.normal()))
        rows = min(space.steps, MOST_ROWS)
        values = one_action(space.noisy(noise, rng), action)
        layers = layers_of(values, rows, space.deviations(noise))
        truth = space.study.truth.expected_reward[action, :rows]
        ((bumps, numbers),) = judged(layers, alpha, seed=number)
        found.append(numbers)
        real += [bool(is_in(bump, truth)) for bump in bumps]
    return np.concatenate(found), np.array(real, dtype=bool)
