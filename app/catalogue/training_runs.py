"""The training runs of this server: one folder, one queue for all sessions, and the curves of each run."""

from __future__ import annotations

import os
import stat
import tempfile
import threading
from functools import cache, lru_cache
from pathlib import Path

from laplace_core import InputError
from laplace_core.agents.settings import LoopSettings
from laplace_core.training.curves import Curves, Reader
from laplace_core.training.queue import Queue, Run

VARIABLE = "LAPLACE_RUNS"
"""Names another folder for the runs than ``runs`` beside the application."""
_one = threading.Lock()  # two sessions that open at once make one queue
_ROOT = Path(__file__).resolve().parents[2]


def folder() -> Path:
    """Where the runs are kept; where nothing can be written beside the application, a temporary folder."""
    if os.environ.get(VARIABLE):
        return Path(os.environ[VARIABLE]).resolve()
    wanted = _ROOT / "runs"
    return wanted if os.access(wanted if wanted.exists() else _ROOT, os.W_OK) else _temporary()


@cache
def _temporary() -> Path:
    """The same after a restart of the server, unless somebody else has taken its name."""
    user = os.getuid() if hasattr(os, "getuid") else 0  # where users have no numbers, each has a folder of their own
    wanted = Path(tempfile.gettempdir()) / f"laplace_runs_{user}"
    try:
        wanted.mkdir(mode=0o700, exist_ok=True)
        status = wanted.lstat()
        if stat.S_ISDIR(status.st_mode) and status.st_uid == user:
            return wanted
    except OSError:
        pass
    return Path(tempfile.mkdtemp(prefix="laplace_runs_"))


def queue() -> Queue:
    """The queue of this server.

    Raises:
        InputError: no folder for runs can be made.
    """
    with _one:
        return _queue(folder())


@lru_cache(maxsize=1)
def _queue(path: Path) -> Queue:
    return Queue(path)


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


@lru_cache(maxsize=64)
def _reader(path: Path) -> Reader:
    return Reader(path)


def best(run: Run) -> Path | None:
    """The checkpoint of the best evaluation so far; None before the first."""
    path = run.folder / "best.safetensors"
    return path if path.is_file() and not path.is_symlink() else None


def settings_of(run: Run) -> LoopSettings:
    """The settings of a run whose folder holds some that can be read."""
    assert run.settings is not None  # others are neither drawn nor compared
    return run.settings


def curves(run: Run) -> Curves:
    """The curves of a run so far; the same object while nothing is new."""
    return _reader(run.folder / "metrics.jsonl").look()


def behind(run: Run) -> bool:
    """Whether there was more to read than one look takes."""
    return _reader(run.folder / "metrics.jsonl").behind
