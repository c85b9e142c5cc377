"""The trainings of experiments as run folders: which there are, how far each is, and how fast. No torch here."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from laplace_core.agents.settings import LoopSettings
from laplace_core.errors import InputError
from laplace_core.experiments.paper.experiment import Cell, Experiment, run_name, shortened
from laplace_core.supervise import is_taken, read_process
from laplace_core.training.progress import read_progress
from laplace_core.training.run_folder import read_config, read_metrics

MISSING, PART, FINISHED = "missing", "part", "finished"
_FILES = ("config.json", "metrics.jsonl", "best.safetensors", "last.safetensors", "resume.safetensors")


@dataclass(frozen=True)
class Training:
    """A planned training and its run folder.

    Attributes:
        cell: whose settings it has.
        settings: the complete ones, with the seed.
        recorded: its row in a file of results, which holds also where its run folder is on another machine.
    """

    cell: Cell
    settings: LoopSettings
    folder: Path
    recorded: Mapping[str, Any] | None = field(default=None, compare=False, repr=False)

    @property
    def name(self) -> str:
        return self.folder.name

    @property
    def events(self) -> list[dict[str, Any]]:
        """The events of the run so far; empty where there is no run."""
        return read_metrics(self.folder) if (self.folder / "metrics.jsonl").exists() else []

    @property
    def state(self) -> str:
        """``missing``, ``part`` or ``finished``, which it is as well where only its result is left.

        Raises:
            InputError: the folder holds a run of other settings.
        """
        return FINISHED if self.recorded is not None else self.folder_state

    @property
    def folder_state(self) -> str:
        """``missing``, ``part`` or ``finished``, by its run folder alone.

        Raises:
            InputError: the folder holds a run of other settings.
        """
        if not (self.folder / "config.json").exists():
            return MISSING
        if read_config(self.folder / "config.json") != self.settings:
            raise InputError(f"{self.folder} was made with other settings: name another --runs folder.")
        if not all((self.folder / name).exists() for name in ("last.safetensors", "best.safetensors")):
            return PART
        # The last checkpoint is written a moment before the last evaluation is.
        over = any(event["event"] == "Evaluation" and event["step"] >= self.settings.steps for event in self.events)
        return FINISHED if over else PART

    @property
    def busy(self) -> bool:
        """Whether a process trains it at this moment."""
        process = read_process(self.folder)
        return (process is not None and process.alive) or is_taken(self.folder)

    @property
    def step(self) -> int:
        """Steps trained so far."""
        if self.recorded is not None:
            return self.settings.steps
        progress = read_progress(self.folder)
        step = max([0 if progress is None else progress.step, *(event["step"] for event in self.events[-1:])])
        return min(step, self.settings.steps)


def trainings_of(
    experiments: Sequence[Experiment], runs: Path, steps: int | None = None, *,
    recorded: Mapping[str, Mapping[str, Any]] | None = None,
) -> dict[str, list[Training]]:  # fmt: skip
    """The trainings of every experiment by its name; those that several need are equal.

    Args:
        runs: the folder that all runs are in.
        steps: shortens every training to so many.
        recorded: rows of results by the name of their run; what has one needs no training.
    """
    trainings, known = {}, recorded or {}
    for experiment in experiments:
        trainings[experiment.name] = [
            Training(cell, short, runs / run_name(short), known.get(run_name(short)))
            for cell in experiment.cells
            for settings in cell.trainings()
            for short in [settings if steps is None else shortened(settings, steps)]
        ]
    return trainings


def once_each(trainings: dict[str, list[Training]]) -> list[Training]:
    """Every run once, in the order of the experiments."""
    once: dict[str, Training] = {}
    for training in (each for several in trainings.values() for each in several):
        once.setdefault(training.name, training)
    return list(once.values())


class Speeds:
    """Steps a second of finished trainings, by which the time that others will take is estimated.

    Args:
        measured: settings, steps and seconds of finished trainings.
    """

    def __init__(self, measured: Sequence[tuple[LoopSettings, float]]):
        self._measured = measured

    def of(self, settings: LoopSettings) -> float | None:
        """The mean of the same settings with other seeds, else of the same environment; None where there is neither."""
        near = [speed for each, speed in self._measured if each.environment == settings.environment]
        speeds = self._same(settings) or near
        return sum(speeds) / len(speeds) if speeds else None

    def rough(self, settings: LoopSettings) -> bool:
        """Whether that is the speed of other settings."""
        return self.of(settings) is not None and not self._same(settings)

    def _same(self, settings: LoopSettings) -> list[float]:
        kind = _without_seed(settings)
        return [speed for each, speed in self._measured if _without_seed(each) == kind]


def _without_seed(settings: LoopSettings) -> dict[str, Any]:
    return {"algorithm": settings.ALGORITHM, **settings.as_dict(), "seed": None}


@dataclass(frozen=True)
class Budget:
    """The cost of the trainings that are left.

    Attributes:
        finished: how many of them are.
        steps: to go, of those that are not.
        hours: to go, as far as the speed is known.
        rough: trainings for which it is the speed of other settings in the same environment.
        unknown: trainings whose speed is not known.
    """

    trainings: Sequence[Training]
    speeds: Speeds

    @cached_property
    def _left(self) -> list[tuple[Training, int]]:
        return [(each, each.settings.steps - each.step) for each in self.trainings if each.state != FINISHED]

    @property
    def finished(self) -> int:
        return len(self.trainings) - len(self._left)

    @property
    def steps(self) -> int:
        return sum(left for _, left in self._left)

    @property
    def hours(self) -> float:
        speeds = [(left, self.speeds.of(each.settings)) for each, left in self._left]
        return sum(left / speed for left, speed in speeds if speed) / 3600.0

    @property
    def rough(self) -> int:
        return sum(self.speeds.rough(each.settings) for each, _ in self._left)

    @property
    def unknown(self) -> int:
        return sum(self.speeds.of(each.settings) is None for each, _ in self._left)

    def as_dict(self) -> dict[str, Any]:
        return {
            "trainings": len(self.trainings),
            "finished": self.finished,
            "steps": self.steps,
            "hours": round(self.hours, 2),
            "rough_speed": self.rough,
            "unknown_speed": self.unknown,
        }


def adopt(folder: Path, trainings: Sequence[Training]) -> Training:
    """Copy a run that was made elsewhere to the folder of the training whose settings it has; whole or not at all.

    Returns:
        the training.

    Raises:
        InputError: no run, one that no experiment needs, one that is there already, or one that is being trained.
    """
    settings = read_config(folder / "config.json")
    wanted = next((training for training in trainings if training.settings == settings), None)
    if wanted is None:
        raise InputError(f"no experiment needs a training with the settings of {folder}: name another run.")
    process = read_process(folder)
    if process is not None and process.alive:
        raise InputError(f"{folder} is being trained by the process {process.pid}: end that one first.")
    if wanted.folder_state != MISSING:
        raise InputError(
            f"{wanted.folder} is there already, {wanted.folder_state}: remove it to adopt {folder} in its place."
        )
    try:
        wanted.folder.parent.mkdir(parents=True, exist_ok=True)
        copy = Path(tempfile.mkdtemp(prefix=".adopted_", dir=wanted.folder.parent))
    except OSError as error:
        raise _refusal(wanted.folder, error) from None
    try:
        for name in _FILES:
            if (folder / name).is_file() and not (folder / name).is_symlink():
                shutil.copy2(folder / name, copy / name)
        copy.chmod(0o755)
        copy.rename(wanted.folder)
    except OSError as error:
        raise _refusal(wanted.folder, error) from None
    finally:
        shutil.rmtree(copy, ignore_errors=True)
    return wanted


def _refusal(path: Path, error: OSError) -> InputError:
    return InputError(f"{path} cannot be written: {(error.strerror or 'unknown error').lower()}.")
