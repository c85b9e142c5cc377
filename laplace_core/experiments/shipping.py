"""Checkpoints that ship: one seed of several, picked by rule, with a manifest of where it comes from.

The seed shipped is the one with the median score, so that what a person opens is what the algorithm does, not the luck
of its best run. Of an even number the lower of the two in the middle is taken.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import numpy as np

from laplace_core.agents.settings import LoopSettings
from laplace_core.errors import InputError
from laplace_core.experiments import training
from laplace_core.training.command import settings_of
from laplace_core.training.tensor_file import parse_json, write_whole

MANIFEST = "manifest.json"
PICKED = "median score over the seeds"
MOST_BYTES, MOST_TOGETHER = 8_000_000, 40_000_000


def ship(algorithm: str, environment: str, seeds: int, runs: Path, folder: Path) -> dict[str, object]:
    """Evaluate every seed, copy the median one's best checkpoint to ``folder`` and enter it in the manifest there.

    Returns:
        the entry.

    Raises:
        InputError: a run is missing or unfinished, or the files would be too large to ship.
    """
    for seed in range(seeds):
        run = runs / training.run_name(algorithm, environment, seed)
        if not (run / "last.safetensors").exists():
            raise InputError(f"{run} is not finished: train it first.")
    rows = training.report(algorithm, environment, seeds, 0.0, runs)[0]["seeds"]
    scores = np.array([row["score"] for row in rows])
    picked = int(np.argsort(scores, kind="stable")[(seeds - 1) // 2])
    run = runs / training.run_name(algorithm, environment, picked)
    data = (run / "best.safetensors").read_bytes()
    name = f"{algorithm}_{environment}.safetensors"
    others = sum(path.stat().st_size for path in folder.glob("*.safetensors") if path.name != name)
    if len(data) > MOST_BYTES or others + len(data) > MOST_TOGETHER:
        raise InputError(f"{name} has {len(data):,} bytes: too large to ship.")
    settings = settings_of(algorithm, environment, {"seed": picked})
    entry = {
        "file": name,
        "sha256": hashlib.sha256(data).hexdigest(),
        "command": command(settings),
        "seed": picked,
        "picked": PICKED,
        "episodes": training.EPISODES,
        "scores": [round(score, 2) for score in scores.tolist()],
        "score": round(float(scores[picked]), 2),
        "standard_error": round(rows[picked]["standard_error"], 2),
    }
    write_whole(folder / name, data)
    entries = {each["file"]: each for each in manifest(folder)} | {name: entry}
    text = json.dumps([entries[file] for file in sorted(entries)], indent=1) + "\n"
    write_whole(folder / MANIFEST, text.encode())
    return entry


def command(settings: LoopSettings) -> str:
    """The command that trains it: the settings file of its algorithm and environment, and the seed."""
    return f"python -m laplace_core train {settings.ALGORITHM} {settings.environment} --seed {settings.seed}"


def manifest(folder: Path) -> list[dict[str, object]]:
    """Entries of a folder's manifest; none if it has no manifest."""
    path = folder / MANIFEST
    if not path.exists():
        return []
    found = parse_json(path.read_bytes(), path.name)
    if not isinstance(found, list) or not all(isinstance(entry, dict) and "file" in entry for entry in found):
        raise InputError(f"{path.name} must be a list of entries that each name a file.")
    return found
