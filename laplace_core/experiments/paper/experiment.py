"""Experiments as lists of cells, which are settings that are trained with several seeds. No torch here."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Any

from laplace_core.agents.settings import LoopSettings
from laplace_core.training.defaults import command_of, settings_of


@dataclass(frozen=True)
class Cell:
    """One curve of a figure or one row of a table.

    Attributes:
        label: what the experiment calls it.
        settings: by name, against the settings file of the algorithm and environment.
        seeds: of its trainings.
    """

    label: str
    algorithm: str
    environment: str
    settings: Mapping[str, object] = field(default_factory=dict)
    seeds: Sequence[int] = (0, 1, 2)

    def trainings(self) -> list[LoopSettings]:
        """The complete settings of every seed's training.

        Raises:
            InputError: settings that the schema refuses, or that change nothing beside the others.
        """
        return [settings_of(self.algorithm, self.environment, {**self.settings, "seed": seed}) for seed in self.seeds]


@dataclass(frozen=True)
class Experiment:
    """A figure, table or claim of the paper.

    Attributes:
        name: what ``reproduce`` calls it.
        title: what it is in the paper.
        question: what it asks.
        reading: what is measured on a finished training besides its score: numbers, lists and dictionaries of them,
            from its run folder; None where the score is all.
    """

    name: str
    title: str
    question: str
    cells: Sequence[Cell]
    reading: Callable[[Path], dict[str, Any]] | None = None


def run_name(settings: LoopSettings) -> str:
    """The folder of a training: equal settings have the same one, whichever experiments need it.

    Only what differs from the defaults of the algorithm is in its name, so that a setting which comes new leaves the
    names of all runs without it as they were.
    """
    usual = {each.name: each.default for each in fields(settings)}
    own = {name: value for name, value in settings.as_dict().items() if value != usual[name]}
    digest = hashlib.sha256(json.dumps(own, sort_keys=True).encode()).hexdigest()[:10]
    return f"{settings.ALGORITHM}_{settings.environment.replace(':', '-')}_{digest}_{settings.seed}"


def train_command(settings: LoopSettings) -> str:
    """The command that trains one run by itself."""
    return " ".join(["python -m laplace_core", *command_of(settings, f"runs/paper/{run_name(settings)}")])


def shortened(settings: LoopSettings, steps: int) -> LoopSettings:
    """The same training for a few steps, to see that it runs: it learns, evaluates and ends as a long one does."""
    return replace(
        settings,
        steps=steps,
        learning_starts=min(settings.learning_starts, max(1, steps // 2)),
        evaluate_every=min(settings.evaluate_every, steps),
        evaluate_episodes=2,
        checkpoint_every=min(settings.checkpoint_every, max(1, steps // 2)),
    )
