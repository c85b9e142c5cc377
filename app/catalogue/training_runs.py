"""The training runs of this server: one folder, one queue for all sessions, and the curves of each run."""

from __future__ import annotations

import os
import threading
from functools import lru_cache
from pathlib import Path

from app.session import owner
from laplace_core import InputError
from laplace_core.agents.settings import LoopSettings
from laplace_core.files.folders import writable
from laplace_core.supervise.limits import Limits, limits, may_train
from laplace_core.training.curves import Curves, Reader
from laplace_core.training.job import owner_of
from laplace_core.training.queue import Queue, Run

VARIABLE = "LAPLACE_RUNS"
"""Names another folder for the runs than ``runs`` beside the application."""
PATIENCE = 1.5
"""Seconds that a page waits for the end of a run which it has stopped; after that the run's card says how far it is."""
_one = threading.Lock()  # two sessions that open at once make one queue
_ROOT = Path(__file__).resolve().parents[2]


def folder() -> Path:
    """Where the runs are kept; where nothing can be written beside the application, a temporary folder.

    Raises:
        InputError: nothing can be written anywhere.
    """
    if os.environ.get(VARIABLE):
        return Path(os.environ[VARIABLE]).resolve()
    wanted = _ROOT / "runs"
    try:
        return writable(wanted, "laplace_runs")
    except OSError:  # there is no temporary folder either
        raise InputError(
            f"training runs have no folder: neither {wanted} nor a temporary one can be written; set {VARIABLE}."
        ) from None


def queue() -> Queue:
    """The queue of this server, within its limits.

    Raises:
        InputError: no folder for runs can be made.
    """
    with _one:
        return _queue(folder(), limits())


@lru_cache(maxsize=1)
def _queue(path: Path, granted: Limits) -> Queue:
    return Queue(
        path,
        granted.trainings,
        most_bytes=granted.disk * 10**6,
        allowed=may_train,
        read_only=granted.read_only,
    )


def wake() -> None:
    """Runs that a stopped server has left go on, whichever page is opened first."""
    try:
        _wake(folder())
    except InputError:  # the page of runs will say so
        return


@lru_cache(maxsize=1)
def _wake(path: Path) -> None:
    if path.is_dir():
        queue().wake()


def may_change(run: Run) -> bool:
    """Whether this browser may stop, resume, remove and download a run: it began it, or the run is nobody's."""
    if limits().read_only:
        return False
    begun_by = owner_of(run.folder)
    return not limits().owners or begun_by is None or begun_by == owner.digest()


def begin(settings: LoopSettings) -> str:
    """A new run of this browser; returns its name.

    Raises:
        InputError: what :meth:`laplace_core.training.queue.Queue.add` refuses.
    """
    return queue().add(settings, owner.digest() if limits().owners else None)


def change(what: str, name: str) -> None:
    """Something that is done with a run, by its name: "stop", "end_at_once", "resume" or "remove".

    Raises:
        InputError: what the queue refuses, or a run of another browser.
    """
    runs = queue()
    if not may_change(runs.get(name)):
        raise InputError(f"{name} was started in another browser: it can be changed only there.")
    if what == "stop":
        runs.stop(name, patience=PATIENCE)
    else:
        {"end_at_once": runs.end_at_once, "resume": runs.resume, "remove": runs.remove}[what](name)


@lru_cache(maxsize=64)
def _reader(path: Path) -> Reader:
    return Reader(path)


def curves(run: Run) -> Curves:
    """The curves of a run so far; the same object while nothing is new."""
    return _reader(run.folder / "metrics.jsonl").look()


def behind(run: Run) -> bool:
    """Whether there was more to read than one look takes."""
    return _reader(run.folder / "metrics.jsonl").behind
