"""The saved results of finished trainings, and the small file of every experiment that they are part of."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.experiments.paper.experiment import Experiment, train_command
from laplace_core.experiments.paper.result_files import BEST, RESULT, cells_in, result_file
from laplace_core.experiments.paper.runs import Training
from laplace_core.experiments.paper.smoothing import smoothed
from laplace_core.experiments.search.objectives import EPISODES, START_SEEDS
from laplace_core.experiments.training import evaluated, seconds_behind
from laplace_core.files.atomic import write_whole
from laplace_core.files.plain_json import as_json
from laplace_core.files.strict_json import parse_json
from laplace_core.files.versions import versions
from laplace_core.training.checkpoint import load_checkpoint

POINTS = 300
"""Most points of a curve."""
_SMOOTHING = 0.02  # of all episodes, on either side
_LEAST_SMOOTHING = 5


def row_of(training: Training) -> dict[str, Any]:
    """The row of a finished training; evaluated once, then saved in its folder.

    Raises:
        InputError: a checkpoint that cannot be read, as that of a training whose weights are not finite any more.
    """
    row = saved_row(training)
    if row is None:
        row = _measured(training, EPISODES, START_SEEDS + training.settings.seed)
        save_row(training, row)
    return row


def save_row(training: Training, row: dict[str, Any]) -> None:
    """Save a row in the folder of its run, unless it is there; a node of a cluster may have a folder of its own."""
    if saved_row(training) is None:
        training.folder.mkdir(parents=True, exist_ok=True)
        write_whole(training.folder / RESULT, as_json(row))


def saved_row(training: Training) -> dict[str, Any] | None:
    """The row of a training: in its run folder, if that has one of these start seeds, else in a file of results."""
    asked = {"episodes": EPISODES, "start_seed": START_SEEDS + training.settings.seed}
    with contextlib.suppress(OSError, ValueError, KeyError, TypeError):  # not there, or not to be used
        row = json.loads((training.folder / RESULT).read_text())
        if row["run"] == training.name and {name: row["best"][name] for name in asked} == asked:
            return _with_each_episode(row, training)
    return None if training.recorded is None else _with_each_episode(dict(training.recorded), training)


def _with_each_episode(row: dict[str, Any], training: Training) -> dict[str, Any]:
    """The row with the return of each episode, which rows of earlier versions have not, if the run is there."""
    best = training.folder / BEST
    if "each_episode" not in row and best.is_file() and training.events:
        row["each_episode"] = each_episode(training.events, load_checkpoint(best).agent.acting_head)
    return row


def reading_of(experiment: Experiment, training: Training) -> dict[str, Any]:
    """What an experiment reads of a finished training; measured once, then saved in its folder.

    Raises:
        InputError: the run is not there any more, or holds no checkpoint that can be read.
    """
    assert experiment.reading is not None
    if not (training.folder / BEST).is_file():
        raise InputError(
            f"{experiment.name} needs the run folder {training.folder}, which is gone: bring it back, or name another "
            "--out folder to train it again."
        )
    found = experiment.reading(training.folder)
    write_whole(training.folder / _reading_file(experiment), as_json(found))
    return found


def saved_reading(experiment: Experiment, training: Training, folder: Path) -> dict[str, Any] | None:
    """The reading that is in the run folder, else in the file of the experiment; None where there is none."""
    with contextlib.suppress(OSError, InputError):
        path = training.folder / _reading_file(experiment)
        found = parse_json(path.read_bytes(), path.name)
        if isinstance(found, dict):
            return found
    rows = (row for cell in cells_in(result_file(folder, experiment.name)) for row in cell["trainings"])
    return next((row.get("reading") for row in rows if row["run"] == training.name), None)


def _reading_file(experiment: Experiment) -> str:
    return f"reading_{experiment.name}.json"


def write(experiment: Experiment, trainings: Sequence[Training], folder: Path) -> Path:
    """Bring the experiment's file up to date with the rows in the folders of its runs; whole or not at all.

    Rows of runs that are elsewhere stay in the file as long as the experiment still plans them.
    """
    path = result_file(folder, experiment.name)
    rows = {row["run"]: row for cell in cells_in(path) for row in cell["trainings"]}
    rows |= {training.name: row for training in trainings if (row := saved_row(training)) is not None}
    if experiment.reading is not None:
        for training in trainings:
            reading = saved_reading(experiment, training, folder)
            if training.name in rows and reading is not None:
                rows[training.name] = {**rows[training.name], "reading": reading}
    cells = []
    for cell in experiment.cells:
        planned = [training for training in trainings if training.cell is cell]
        settings = {name: value for name, value in planned[0].settings.as_dict().items() if name != "seed"}
        cells.append(
            {
                "label": cell.label,
                "algorithm": cell.algorithm,
                "environment": cell.environment,
                "changed": dict(cell.settings),
                "settings": settings,
                "seeds": [training.settings.seed for training in planned],
                "trainings": [rows[training.name] for training in planned if training.name in rows],
            }
        )
    about = {
        "experiment": experiment.name,
        "title": experiment.title,
        "question": experiment.question,
        "command": f"python -m laplace_core reproduce {experiment.name}",
        "finished": sum(len(cell["trainings"]) for cell in cells),
        "planned": len(trainings),
        "cells": cells,
    }
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"the folder {folder} cannot be made: {(error.strerror or 'unknown').lower()}.") from None
    write_whole(path, as_json(about))
    return path


def _measured(training: Training, episodes: int, start_seed: int) -> dict[str, Any]:
    """The row of one training, with the entries that docs/paper/README.md describes."""
    settings, events = training.settings, training.events
    best = load_checkpoint(training.folder / BEST)
    scores, error = evaluated(best.agent, settings.environment, episodes, start_seed)
    evaluations = [event for event in events if event["event"] == "Evaluation"]
    ended = [event for event in events if event["event"] == "Episode"]
    acting = [event for event in ended if event["head"] == best.agent.acting_head]
    made = datetime.fromtimestamp((training.folder / "last.safetensors").stat().st_mtime, UTC)
    columns = {"steps": "step", "scores": "score", "errors": "standard_error"}
    return {
        "run": training.name,
        "seed": settings.seed,
        "command": train_command(settings),
        "date": made.date().isoformat(),
        "versions": versions(),
        "steps": settings.steps,
        "seconds": round(seconds_behind(events)[-1], 1),
        "inexact_resumes": sum(event["event"] == "Resumed" for event in events),
        "best": {
            "step": max((event["step"] for event in evaluations if event["best"]), default=None),
            "episodes": episodes,
            "start_seed": start_seed,
            "score": round(scores.mean, 3),
            "standard_error": round(scores.standard_error, 3),
            "returns": np.round(scores.returns, 2).tolist(),
            "value_error": None if error is None else round(error, 3),
        },
        "last": {to: round(evaluations[-1][of], 3) for to, of in (("step", "step"), *_LAST)},
        "evaluations": {to: [round(event[of], 3) for event in evaluations] for to, of in columns.items()},
        "episodes": len(ended),
        **curves([event["episode_return"] for event in acting], [event["step"] for event in acting]),
        "each_episode": each_episode(events, best.agent.acting_head),
    }


def each_episode(events: Sequence[dict[str, Any]], acting_head: int) -> dict[str, list[float]]:
    """Of the episodes in which the acting discount behaved, without smoothing: which of all, last step and return."""
    ended = [event for event in events if event["event"] == "Episode"]
    acting = [(i, event) for i, event in enumerate(ended, start=1) if event["head"] == acting_head]
    return {
        "episodes": [i for i, _ in acting],
        "steps": [event["step"] for _, event in acting],
        "returns": [round(event["episode_return"], 2) for _, event in acting],
    }


_LAST = (("score", "score"), ("standard_error", "standard_error"), ("episodes", "episodes"))


def curves(returns: Sequence[float], steps: Sequence[int]) -> dict[str, Any]:
    """Returns of the episodes in which the acting discount behaved, smoothed, at even places of either axis.

    Args:
        returns, steps: ``(E,)``, the step at which each episode ended.

    Returns:
        ``by_episode`` and ``by_step``, each with at most ``POINTS`` places and returns, and ``smoothing``: over how
        many episodes each return is a mean.
    """
    count = len(returns)
    reach = max(_LEAST_SMOOTHING, round(_SMOOTHING * count))
    if not count:
        nothing: dict[str, list[float]] = {"returns": []}
        return {"by_episode": {"episodes": [], **nothing}, "by_step": {"steps": [], **nothing}, "smoothing": 0}
    smooth = smoothed(returns, reach)
    points = min(count, POINTS)
    picked = np.round(np.linspace(0, count - 1, points)).astype(int)
    places = np.linspace(steps[0], steps[-1], points)
    along = np.interp(places, steps, smooth)
    return {
        "by_episode": {"episodes": (picked + 1).tolist(), "returns": np.round(smooth[picked], 2).tolist()},
        "by_step": {"steps": np.round(places).astype(int).tolist(), "returns": np.round(along, 2).tolist()},
        "smoothing": 2 * reach + 1,
    }
