"""Certified decisions: how often they are claimed, and how often a claim is wrong."""

from __future__ import annotations

from typing import Any

import numpy as np

from laplace_core.experiments.inverse.spaces import draw_space
from laplace_core.inverse.certificate import certify

NOISES = (1e-5, 1e-4, 1e-3, 1e-2)
CLEAR = 0.05
"""Of the largest value in size: margins above it ought to be decided."""
MOST_WRONG, LEAST_DECIDED, DECIDED_AT = 0.01, 0.5, 1e-4


def report(cases: int, seed: int) -> tuple[dict[str, Any], str]:
    """Numbers and text: two actions of each of ``cases`` random worlds at a random horizon, at every noise."""
    rows: list[dict[str, Any]] = []
    for noise in NOISES:
        rng = np.random.default_rng([seed, 1])  # the same worlds at every noise
        found = np.array([_case(rng, noise) for _ in range(cases)])
        claimed, wrong, clear, missed = found.T.astype(bool)
        rows.append(
            {
                "noise": noise, "cases": cases, "claimed": int(claimed.sum()), "wrong": int(wrong.sum()),
                "clear": int(clear.sum()), "clear_claimed": int((clear & claimed).sum()), "missed": int(missed.sum()),
            }
        )  # fmt: skip
    lines = [
        f"Certified decisions on {cases:,} random worlds (seed {seed}), two actions, a random horizon",
        "noise    claimed   wrong   true margin above 5%   of these claimed   true value out of bounds",
    ]
    for r in rows:
        share = r["clear_claimed"] / max(1, r["clear"])
        cells = f"{r['claimed'] / cases:7.1%} {r['wrong']:7d} {r['clear']:22d} {share:18.1%} {r['missed']:26d}"
        lines.append(f"{r['noise']:<8g} {cells}")
    return {"seed": seed, "rows": rows}, "\n".join(lines)


def shortfalls(numbers: dict[str, Any]) -> list[str]:
    """Missed goals."""
    missed = [f"wrong claims at {r['noise']:g}" for r in numbers["rows"] if r["wrong"] > MOST_WRONG * r["cases"]]
    for r in numbers["rows"]:
        if r["noise"] == DECIDED_AT and r["clear_claimed"] < LEAST_DECIDED * r["clear"]:
            missed.append(f"claims at {r['noise']:g}")
    return missed


def _case(rng: np.random.Generator, noise: float) -> tuple[bool, bool, bool, bool]:
    """Claimed; claimed and wrong; truly clear; a true value outside its bounds."""
    space = draw_space(rng, actions=2)
    horizon = int(rng.integers(1, space.steps + 1))
    values = space.study.truth.horizon_values
    rewards = space.world.reward_values
    found = certify(
        space.noisy(noise, rng), horizon, space.deviations(noise), value_gamma=space.study.settings.value_gamma,
        slope=space.study.settings.slope, rewards=(float(rewards[0]), float(rewards[-1])),
    )  # fmt: skip
    true = values[:, horizon - 1]
    margin, better = float(true[0] - true[1]), found.better(0, 1)
    wrong = better is not None and (margin if better == 0 else -margin) < 0.0
    outside = bool(np.any((true < found.low - 1e-9) | (true > found.high + 1e-9)))
    return better is not None, wrong, abs(margin) > CLEAR * np.abs(values).max(), outside
