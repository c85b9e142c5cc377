"""Checkpoints that ship: one seed of several, picked by rule, with a manifest of where it comes from.

The seed shipped is the one with the median score, so that what a person opens is what the algorithm does, not the luck
of its best run. Of an even number the lower of the two in the middle is taken. Beside it lies a small file with the
evaluations while training of every seed, which show how the score was reached.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.agents.settings import LoopSettings
from laplace_core.errors import InputError
from laplace_core.experiments import training
from laplace_core.files.atomic import write_whole
from laplace_core.files.strict_json import parse_json
from laplace_core.files.tensors import read_bytes
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.training.defaults import settings_of
from laplace_core.training.run_folder import read_metrics

MANIFEST = "manifest.json"
TABULAR = "_td"
"""Ending of the names of agents that learned a tabular world; another reader opens them."""
PICKED, ALONE = "median score over the seeds", "the only seed"
MOST_BYTES, MOST_TOGETHER = 8_000_000, 40_000_000
MOST_CURVE_BYTES = 200_000


@dataclass(frozen=True)
class TrainingCurve:
    """Evaluations of one seed while it was trained, N each: step, mean return and its standard error, in reward."""

    seed: int
    steps: tuple[float, ...]
    scores: tuple[float, ...]
    errors: tuple[float, ...]


def ship(algorithm: str, environment: str, seeds: int, runs: Path, *, folder: Path) -> dict[str, Any]:
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
    rows = training.report(algorithm, environment, seeds, 0.0, folder=runs)[0]["seeds"]
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
        "picked": PICKED if seeds > 1 else ALONE,
        "episodes": training.EPISODES,
        "scores": [round(score, 2) for score in scores.tolist()],
        "score": round(float(scores[picked]), 2),
        "standard_error": round(rows[picked]["standard_error"], 2),
        "curve": write_curves(runs, algorithm, environment, seeds, folder=folder),
    }
    write_whole(folder / name, data)
    entries = {each["file"]: each for each in manifest(folder)} | {name: entry}
    text = json.dumps([entries[file] for file in sorted(entries)], indent=1) + "\n"
    write_whole(folder / MANIFEST, text.encode())
    return entry


def write_curves(runs: Path, algorithm: str, environment: str, seeds: int, *, folder: Path) -> dict[str, str]:
    """Write the evaluations while training of every seed to one file; returns its name and sha256 for the manifest."""
    curves = []
    for seed in range(seeds):
        events = read_metrics(runs / training.run_name(algorithm, environment, seed))
        evaluations = [event for event in events if event["event"] == "Evaluation"]
        columns = {"steps": "step", "scores": "score", "errors": "standard_error"}
        curves.append({"seed": seed, **{to: [round(e[of], 3) for e in evaluations] for to, of in columns.items()}})
    lines = ",\n".join(json.dumps(curve) for curve in curves)
    name, data = f"{algorithm}_{environment}.curve.json", f"[\n{lines}\n]\n".encode()
    write_whole(folder / name, data)
    return {"file": name, "sha256": hashlib.sha256(data).hexdigest()}


def curves_of(folder: Path, entry: dict[str, Any]) -> tuple[TrainingCurve, ...]:
    """The training curves that an entry of a folder's manifest names; none if it names none.

    Raises:
        InputError: the file is missing, or not one that :func:`write_curves` could have written.
    """
    reference = entry.get("curve")
    if reference is None:
        return ()
    wrong = InputError(f"the training curve of {entry['file']} must be a file beside it, with the manifest's sha256.")
    try:
        path = folder / Path(reference["file"]).name
        data = path.read_bytes() if path.stat().st_size <= MOST_CURVE_BYTES else b""
    except (OSError, KeyError, TypeError, ValueError):
        raise wrong from None
    if hashlib.sha256(data).hexdigest() != reference.get("sha256"):
        raise wrong
    try:
        curves = [
            TrainingCurve(int(each["seed"]), *(tuple(map(float, each[name])) for name in ("steps", "scores", "errors")))
            for each in parse_json(data, path.name)
        ]
    except (InputError, KeyError, TypeError, ValueError, OverflowError):
        raise wrong from None
    for curve in curves:
        columns = (curve.steps, curve.scores, curve.errors)
        if not curve.steps or len({*map(len, columns)}) > 1 or not np.isfinite(columns).all():
            raise wrong
    return tuple(curves)


def damaged(folder: Path) -> dict[str, str]:
    """One sentence for every file of a folder of shipped agents that cannot be used, by its name.

    A checkpoint with the manifest's sha256 is as it was shipped. Any other is opened, as one may lie there that the
    manifest does not know.
    """
    found: dict[str, str] = {}
    entries: dict[str, dict[str, Any]] = {}

    def tried(name: str, use: Callable[[], object]) -> None:
        try:
            use()
        except InputError as error:
            found[name] = str(error)

    tried(MANIFEST, lambda: entries.update((each["file"], each) for each in manifest(folder)))
    for path in sorted(folder.glob("*.safetensors")):
        entry = entries.get(path.name, {})
        if not path.stem.endswith(TABULAR) and not _is_as_shipped(path, entry):
            tried(path.name, partial(load_checkpoint, path))
    for name, entry in entries.items():
        tried(f"{Path(name).stem}.curve.json", partial(curves_of, folder, entry))
    return found


def _is_as_shipped(path: Path, entry: dict[str, Any]) -> bool:
    try:
        data = path.read_bytes() if path.stat().st_size <= MOST_BYTES else b""
    except OSError:
        return False
    return hashlib.sha256(data).hexdigest() == entry.get("sha256")


def command(settings: LoopSettings) -> str:
    """The command that trains it: the settings file of its algorithm and environment, and the seed."""
    return f"python -m laplace_core train {settings.ALGORITHM} {settings.environment} --seed {settings.seed}"


def manifest(folder: Path) -> list[dict[str, Any]]:
    """Entries of a folder's manifest; none if it has no manifest.

    Raises:
        InputError: a manifest that is no list of entries with the names of files.
    """
    path = folder / MANIFEST
    if not path.exists():
        return []
    entries = parse_json(read_bytes(path, path.name, most_bytes=MOST_BYTES), path.name)
    named = isinstance(entries, list) and all(
        isinstance(entry, dict) and isinstance(entry.get("file"), str) for entry in entries
    )
    if not named:
        raise InputError(f"{path.name} must be a list of entries that each name a file.")
    return entries
