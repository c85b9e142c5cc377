"""Train what experiments need, as a list of independent jobs, and save the result of each."""

from __future__ import annotations

import contextlib
import secrets
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

from laplace_core.errors import InputError
from laplace_core.experiments.paper import results
from laplace_core.experiments.paper.experiment import Experiment
from laplace_core.experiments.paper.runs import FINISHED, MISSING, Training, once_each
from laplace_core.supervise.parallel import in_parallel
from laplace_core.training.loop import train
from laplace_core.training.progress import ProgressFile

_LOOK_EVERY = 0.5  # seconds between two looks for the end that is asked for


@dataclass(frozen=True)
class Done:
    """The outcome of one training; one that was stopped has neither a row nor trouble.

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
    processes: int = 1,
    cluster: str | None = None,
) -> Iterator[Done]:
    """Finish every training of the experiments; the file of each experiment always holds the results so far.

    A training that another process is at is left to that one; one that fails does not keep the others from theirs.

    Args:
        trainings: by the name of the experiment.
        out: the folder of the experiments' files.
        stop: called between two steps; when it returns True, all trainings under way write a resume point and all ends.
        begins: called with every training before it is started or resumed, where they are trained one by one here.
        collect: train nothing, and score what is finished.
        processes, cluster: as in :func:`laplace_core.supervise.parallel.in_parallel`.
    """
    for experiment in experiments:  # what other experiments have trained already
        results.write(experiment, trainings[experiment.name], out)
    left = []
    for training in once_each(trainings):
        try:
            row, finished = results.saved_row(training), training.state == FINISHED
        except InputError as error:
            yield Done(training, trouble=str(error))
            continue
        if row is not None and finished:
            yield _read(experiments, trainings, Done(training, row), out)
        elif finished or not collect:
            left.append(training)
    alone = cluster is None and (processes == 1 or len(left) < 2)
    with contextlib.ExitStack() as held:
        if alone:
            job = partial(_finish, stop=stop, begins=begins)
        else:
            job = partial(_finish, stop=held.enter_context(_shared(stop, left[0].folder.parent)))
        jobs = [replace(each, folder=each.folder.absolute()) for each in left]
        outcomes = held.enter_context(contextlib.closing(in_parallel(job, jobs, processes, cluster)))
        for i, outcome in outcomes:
            done = replace(outcome, training=left[i])
            if done.row is not None:
                results.save_row(done.training, done.row)
                for experiment in _needing(experiments, trainings, done.training):  # before anything else is measured
                    results.write(experiment, trainings[experiment.name], out)
                done = _read(experiments, trainings, done, out)
            if done.row is not None or done.trouble is not None:
                yield done


def _needing(
    experiments: Sequence[Experiment], trainings: dict[str, list[Training]], training: Training
) -> list[Experiment]:
    """The experiments that a training belongs to."""
    return [each for each in experiments if any(training.name == one.name for one in trainings[each.name])]


def _read(experiments: Sequence[Experiment], trainings: dict[str, list[Training]], done: Done, out: Path) -> Done:
    """Add what experiments read of a finished training, where that is not there yet."""
    try:
        for experiment in _needing(experiments, trainings, done.training):
            if experiment.reading and results.saved_reading(experiment, done.training, out) is None:
                results.reading_of(experiment, done.training)
                results.write(experiment, trainings[experiment.name], out)
    except InputError as error:
        return replace(done, row=None, trouble=str(error))
    return done


def _finish(training: Training, stop: Callable[[], object], begins: Callable[[Training], None] | None = None) -> Done:
    """Train to the end unless that is done, and score; in whatever process."""
    try:
        if stop():
            return Done(training)
        if training.state != FINISHED:
            if training.busy:
                return Done(training, trouble="another process trains it: it is left to that one.")
            if begins is not None:
                begins(training)
            _train(training, stop)
            if stop():
                return Done(training)
        return Done(training, results.row_of(training))
    except InputError as error:
        return Done(training, trouble=str(error))


@dataclass
class _Flag:
    """Whether a file is there, which says that all trainings are to stop; looked for from time to time."""

    path: Path
    seen: bool = False
    looked: float = field(default=0.0, compare=False)

    def __call__(self) -> bool:
        now = time.monotonic()
        if not self.seen and abs(now - self.looked) >= _LOOK_EVERY:
            self.looked, self.seen = now, self.path.exists()
        return self.seen


@contextlib.contextmanager
def _shared(stop: Callable[[], object], folder: Path) -> Iterator[_Flag]:
    """The wish to stop as a file, which processes of any machine that has the folder see."""
    folder.mkdir(parents=True, exist_ok=True)
    flag, over = folder.absolute() / f".stop_{secrets.token_hex(8)}", threading.Event()

    def watch() -> None:
        while not over.wait(_LOOK_EVERY):
            if stop():
                flag.touch()
                return

    watcher = threading.Thread(target=watch, daemon=True, name="passes the wish to stop on")
    watcher.start()
    try:
        yield _Flag(flag)
    finally:
        over.set()
        watcher.join()
        flag.unlink(missing_ok=True)


def _train(training: Training, stop: Callable[[], object]) -> None:
    """To its end, or to where it was stopped."""
    there = training.state != MISSING
    progress, step = ProgressFile(training.folder, training.settings.steps), training.step
    for event in train(None if there else training.settings, training.folder, resume=there, stop=lambda: bool(stop())):
        step = event.step
        progress.at(step)
    progress.at(step, last=True)
