"""Train what experiments need, one training after another, and save the result of each."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from laplace_core.errors import InputError
from laplace_core.experiments.paper import results
from laplace_core.experiments.paper.experiment import Experiment
from laplace_core.experiments.paper.runs import FINISHED, MISSING, Training, once_each
from laplace_core.training.loop import train
from laplace_core.training.progress import ProgressFile


@dataclass(frozen=True)
class Done:
    """The outcome of one training.

    Attributes:
        row: its result; None where there is none.
        trouble: why not, in a sentence.
    """

    training: Training
    row: dict[str, Any] | None = None
    trouble: str | None = None


def reproduce(
    experiments: Sequence[Experiment],
    trainings: dict[str, list[Training]],
    out: Path,
    stop: Callable[[], object],
    *,
    begins: Callable[[Training], None],
    collect: bool = False,
) -> Iterator[Done]:
    """Finish every training of the experiments; the file of each experiment always holds the results so far.

    A training that another process is at is left to that one; one that fails does not keep the others from theirs.

    Args:
        trainings: by the name of the experiment.
        out: the folder of the experiments' files.
        stop: called between two steps; when it returns True, the present training writes a resume point and all ends.
        begins: called with every training before it is started or resumed.
        collect: train nothing, and score what is finished.
    """
    for experiment in experiments:  # what other experiments have trained already
        results.write(experiment, trainings[experiment.name], out)
    for training in once_each(trainings):
        if stop():
            return
        try:
            if training.state != FINISHED:
                if collect:
                    continue
                if training.busy:
                    yield Done(training, trouble="another process trains it: it is left to that one.")
                    continue
                begins(training)
                _train(training, stop)
                if stop():
                    return
            known = results.saved_row(training) is not None
            done = Done(training, results.row_of(training))
            needed = [each for each in experiments if any(training.name == one.name for one in trainings[each.name])]
            for experiment in needed:  # the row is in every file before anything else is measured
                if not known:
                    results.write(experiment, trainings[experiment.name], out)
            for experiment in needed:
                if experiment.reading and results.saved_reading(experiment, training, out) is None:
                    results.reading_of(experiment, training)
                    results.write(experiment, trainings[experiment.name], out)
        except InputError as error:
            done = Done(training, trouble=str(error))
        yield done


def _train(training: Training, stop: Callable[[], object]) -> None:
    """To its end, or to where it was stopped."""
    there = training.state != MISSING
    progress, step = ProgressFile(training.folder, training.settings.steps), training.step
    for event in train(None if there else training.settings, training.folder, resume=there, stop=lambda: bool(stop())):
        step = event.step
        progress.at(step)
    progress.at(step, last=True)
