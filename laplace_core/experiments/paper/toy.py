"""The toy MDP of Figure 4 as the paper decoded it, from values of any origin."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from laplace_core.study.horizon import choose_actions
from laplace_core.study.pipeline import Study
from laplace_core.study.settings import Settings

ROWS = ("paper", "none")
"""Rows rescaled to 1, as the paper's are, and rows left alone."""
EPISODES, SEEDS = 2_000, 5


def settings_for(normalise: str, **more: Any) -> Settings:
    """Fifteen discounts evenly in 1 / log gamma, 150 sensitivities on [-2, 12] of slope 25, K = 3, alpha .2."""
    grid: dict[str, Any] = {"gammas": 15, "spacing": "inverse-log", "gamma_min": 0.01, "gamma_max": 0.99}
    rewards: dict[str, Any] = {"thetas": 150, "theta_min": -2.0, "theta_max": 12.0, "slope": 25.0}
    return Settings(alpha=0.2, steps=3, normalise=normalise, **(grid | rewards | more))


def reading(study: Study) -> dict[str, Any]:
    """E[r_tau] of both actions ``(2, 3)``, their V_3 ``(2,)``, and the action that is chosen."""
    values = study.decoded.horizon_values[:, -1]
    return {
        "expected_reward": np.round(study.decoded.expected_reward, 4).tolist(),
        "values": np.round(values, 4).tolist(),
        "action": int(choose_actions(values[:, None], study.decoded.scale)[0]),
    }


def readings(study: Callable[[str], Study]) -> dict[str, Any]:
    """The reading with each treatment of the rows."""
    return {normalise: reading(study(normalise)) for normalise in ROWS}
