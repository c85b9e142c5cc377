"""A rollout as an ``.npz`` file: every array, and a JSON string ``settings`` with the arguments that reproduce it."""

from __future__ import annotations

import io
import json
from typing import Any

import numpy as np

from laplace_core.acting.rollout import Rollout

_ARRAYS = (
    "observations", "actions", "rewards", "values", "greedy_values", "differs", "predicted", "received", "surprise",
)  # fmt: skip


def rollout_arrays(rollout: Rollout) -> dict[str, Any]:
    """Arrays by name, steps first: those of :class:`Rollout`; its ``spaces`` are called as in every file of ours."""
    arrays = {name: getattr(rollout, name) for name in _ARRAYS}
    if rollout.spaces is not None:
        arrays |= {
            "gamma_space": rollout.spaces, "constant_channel": rollout.constants,
            "gammas": rollout.gammas, "thetas": rollout.thetas, "open_ends": np.array(1),
        }  # fmt: skip
    reported = ("environment", "seed", "rule", "horizon", "gamma", "acting_gamma", "terminated")
    return arrays | {"settings": np.array(json.dumps({name: getattr(rollout, name) for name in reported}))}


def rollout_npz(rollout: Rollout) -> bytes:
    file = io.BytesIO()
    np.savez_compressed(file, **rollout_arrays(rollout))
    return file.getvalue()
