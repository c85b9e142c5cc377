"""The agents that ship: scores of every seed that was trained, and whether they lasted while training."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.experiments.shipping import MOST_BYTES, curves_of, manifest


def report(folder: Path) -> tuple[list[dict[str, Any]], str]:
    """Every agent of a folder's manifest, after its file was checked against the entry.

    The score is that of a seed's best checkpoint, by its evaluations while training. What it says nothing of stands
    below it: the last of those evaluations, and the lowest of them in the second half of the training.

    Raises:
        InputError: no manifest, or an agent or its training curve is missing or another one.
    """
    entries = manifest(folder)
    if not entries:
        raise InputError(f"{folder} has no manifest.json: name a folder of agents that ship.")
    rows = [_row(folder, entry) for entry in entries]
    return rows, "\n\n".join(map(_text, rows))


def _row(folder: Path, entry: dict[str, Any]) -> dict[str, Any]:
    path = folder / Path(str(entry["file"])).name
    try:
        data = path.read_bytes() if path.stat().st_size <= MOST_BYTES else b""
    except OSError as error:
        raise InputError(f"{path} cannot be read: {(error.strerror or 'unknown error').lower()}.") from None
    if hashlib.sha256(data).hexdigest() != entry.get("sha256"):
        raise InputError(f"{path} is not the file that manifest.json tells of: take both from one place.")
    algorithm, environment = path.stem.rsplit("_", 1)
    scores = sorted(curves_of(folder, entry), key=lambda curve: curve.seed)
    evaluations = [np.array(curve.scores) for curve in scores]
    try:
        if not entry["scores"]:
            raise ValueError
        return {
            "algorithm": algorithm,
            "environment": environment,
            "file": path.name,
            "seed": int(entry["seed"]),
            "picked": str(entry["picked"]),
            "episodes": int(entry["episodes"]),
            "scores": [float(score) for score in entry["scores"]],
            "last": [float(each[-1]) for each in evaluations],
            "lowest": [float(each[len(each) // 2 :].min()) for each in evaluations],
        }
    except (KeyError, TypeError, ValueError, IndexError):
        raise InputError(f"manifest.json lacks entries about {path.name}: ship it again.") from None


def _text(row: dict[str, Any]) -> str:
    median, lowest = np.median(row["scores"]), min(row["scores"])
    return "\n".join(
        [
            f"{row['algorithm']} {row['environment']}: median {median:.1f}, lowest {lowest:.1f}; "
            f"seed {row['seed']} ships ({row['picked']})",
            _line(f"best checkpoint, {row['episodes']} episodes", row["scores"]),
            _line("last evaluation while training", row["last"]),
            _line("lowest of the second half", row["lowest"]),
            f"  evaluate {row['file']} --seed {row['seed']}   gives the shipped seed's score",
        ]
    )


def _line(name: str, values: Sequence[float]) -> str:
    return f"  {name:<32}" + "".join(f"{value:>8.1f}" for value in values)
