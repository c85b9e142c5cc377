"""Races as files: both episodes of one, and the returns of many."""

from __future__ import annotations

import csv
import io
import json
from typing import Any

import numpy as np

from laplace_core.acting.frames import animation, side_by_side
from laplace_core.acting.race import FIRST_START, Race, Races
from laplace_core.acting.rollout_file import rollout_arrays
from laplace_core.errors import InputError


def race_npz(race: Race) -> bytes:
    """The arrays of both rollouts, their names after ``left_`` and ``right_``."""
    file = io.BytesIO()
    sides = {"left": race.left, "right": race.right}
    np.savez_compressed(
        file, **{f"{side}_{name}": array for side, one in sides.items() for name, array in rollout_arrays(one).items()}
    )
    return file.getvalue()


def race_gif(race: Race, names: tuple[str, str], seconds: float) -> bytes:
    """Both episodes side by side, each under its name and its return so far, as an animation.

    Args:
        seconds: that a step is shown for.

    Raises:
        InputError: an episode without pictures.
    """
    sides = (race.left, race.right)
    if not all(side.frames for side in sides):
        raise InputError("this race has no pictures to animate.")
    returns = [np.concatenate([[0.0], np.cumsum(side.rewards)]) for side in sides]
    pictures = []
    for step in range(max(map(len, returns))):
        left, right = (min(step, len(side)) for side in sides)
        words = (f"{names[0]}: {returns[0][left]:.1f}".replace("γ", "gamma"), f"{names[1]}: {returns[1][right]:.1f}")
        pictures.append(side_by_side(race.left.frames[left], race.right.frames[right], words))
    return animation(pictures, seconds)


def races_csv(races: Races, left: str, right: str) -> str:
    """A row a start: start, start seed, both returns, their difference, and steps taken; sides by their names."""
    file = io.StringIO()
    rows = csv.writer(file, lineterminator="\n")
    names = [f"return of {left}", f"return of {right}", "difference", f"steps of {left}", f"steps of {right}"]
    rows.writerow(["start", "start seed", *names])
    columns = (races.left, races.right, races.differences, races.left_lengths, races.right_lengths)
    for i, start in enumerate(races.starts):
        rows.writerow([start, FIRST_START + start, *(column[i] for column in columns)])
    return file.getvalue()


def races_npz(races: Races, settings: dict[str, Any]) -> bytes:
    """The same as arrays, and a JSON string ``settings`` with the settings that reproduce them."""
    file = io.BytesIO()
    report = {"environment": races.environment, "horizon": races.horizon, "first_seed": FIRST_START} | settings
    np.savez_compressed(
        file, starts=races.starts, left=races.left, right=races.right, differences=races.differences,
        left_lengths=races.left_lengths, right_lengths=races.right_lengths, settings=np.array(json.dumps(report)),
    )  # fmt: skip
    return file.getvalue()
