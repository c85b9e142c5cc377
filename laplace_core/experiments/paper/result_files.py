"""The files of results: one of every run, one of every experiment. No torch here."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from laplace_core.agents.settings import LoopSettings
from laplace_core.errors import InputError
from laplace_core.experiments.paper.experiment import Experiment
from laplace_core.experiments.paper.runs import Training
from laplace_core.files.strict_json import parse_json

BEST = "best.safetensors"
"""In the folder of a run: its best checkpoint, by the evaluations while training."""
RESULT = "result.json"
"""In the folder of a run: its row, so that an experiment which needs the run as well evaluates nothing again."""
_MOST_BYTES = 50_000_000


def result_file(folder: Path, name: str) -> Path:
    """The file of an experiment of this name."""
    return folder / f"{name}.json"


def cells_in(path: Path) -> list[dict[str, Any]]:
    """The cells of an experiment's file; none where there is no file.

    Raises:
        InputError: a file that is no result: it is not written over.
    """
    if not path.exists():
        return []
    try:
        cells = parse_json(path.read_bytes()[:_MOST_BYTES], path.name)["cells"]
        if all(isinstance(row["run"], str) for cell in cells for row in cell["trainings"]):
            return cells
    except (OSError, TypeError, KeyError):
        pass
    raise InputError(f"{path} is no result of an experiment: move it away, or name another --out folder.")


def contents(path: Path) -> dict[str, Any] | None:
    """The contents of an experiment's file, trained or measured; None if there is no file.

    Raises:
        InputError: a file that is no result.
    """
    if not path.exists():
        return None
    try:
        about = parse_json(path.read_bytes()[:_MOST_BYTES], path.name)
        rows = about["cells"] if "cells" in about else about["results"]
        if isinstance(rows, list) and all(isinstance(row, dict) for row in rows):
            return dict(about)
    except (OSError, TypeError, KeyError):
        pass
    raise InputError(f"{path.name} is no result of an experiment: move it away, and make it again.")


def recorded_rows(experiments: Sequence[Experiment], folder: Path) -> dict[str, dict[str, Any]]:
    """The rows in the files of the experiments, by the name of their run, without what one experiment alone reads.

    Raises:
        InputError: a file that is no result.
    """
    cells = (cell for each in experiments for cell in cells_in(result_file(folder, each.name)))
    rows = (row for cell in cells for row in cell["trainings"])
    return {row["run"]: {name: value for name, value in row.items() if name != "reading"} for row in rows}


def measured_speeds(
    experiments: Sequence[Experiment], trainings: Sequence[Training], folder: Path
) -> list[tuple[LoopSettings, float]]:
    """Settings and steps a second of the trainings whose rows are in their run folders or in the experiments' files."""
    rows = list(recorded_rows(experiments, folder).values())
    for training in trainings:
        with contextlib.suppress(OSError, ValueError):  # not finished yet
            rows.append(json.loads((training.folder / RESULT).read_text()))
    planned, speeds = {training.name: training.settings for training in trainings}, {}
    for row in rows:
        with contextlib.suppress(KeyError, TypeError, ZeroDivisionError):
            speeds[row["run"]] = row["steps"] / row["seconds"]
    return [(planned[name], speed) for name, speed in speeds.items() if name in planned]
