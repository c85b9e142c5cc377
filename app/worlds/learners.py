"""Learners at work: each in a process of its own, watched through its files, a few at a time on a server."""

from __future__ import annotations

import atexit
import shutil
import tempfile
import threading
from functools import cache
from pathlib import Path
from typing import Any

from laplace_core import InputError
from laplace_core.tabular import Learned, LearnSettings
from laplace_core.tabular.process import Run, start
from laplace_core.worlds import World

MOST_RUNNING = 4
"""Learners that run at the same time on this server; the next one waits for a place."""
MOST_KEPT = 4
"""Runs that a session keeps; the oldest leaves first."""

_lock = threading.Lock()
_running: list[Run] = []


@cache
def _room() -> Path:
    """A folder for the files of all runs of this server, gone with it."""
    room = Path(tempfile.mkdtemp(prefix="laplace_runs_"))

    def clear() -> None:
        for run in _running:
            run.cancel()
        shutil.rmtree(room, ignore_errors=True)

    atexit.register(clear)
    return room


class Watched:
    """One run: waiting for a place, running, or at its end."""

    def __init__(self, world: World, settings: LearnSettings):
        self._world, self._settings = world, settings
        self._run: Run | None = None
        self._folder: Path | None = None
        self._refused: str | None = None
        self._given_up = False

    @property
    def waiting(self) -> bool:
        """Whether it still has to wait; asking takes a place if there is one."""
        with _lock:
            if self._run is None and not self._given_up and self._refused is None:
                _running[:] = [run for run in _running if not run.finished]
                if len(_running) < MOST_RUNNING:
                    self._begin()
        return self._run is None and not self._given_up and self._refused is None

    def _begin(self) -> None:
        try:
            self._folder = Path(tempfile.mkdtemp(dir=_room()))
            self._run = start(self._world, self._settings, self._folder)
            _running.append(self._run)
        except InputError as error:
            self._refused = str(error)
        except OSError:
            self._refused = "this server has no temporary folder for what is learned: its owner may set TMPDIR to one."

    @property
    def running(self) -> bool:
        return self.waiting or (self._run is not None and not self._run.finished)

    @property
    def error(self) -> str | None:
        return self._refused or (self._run.error if self._run else None)

    def progress(self) -> dict[str, Any] | None:
        return self._run.progress() if self._run else None

    def learned(self) -> Learned | None:
        """The last snapshot; the same object until there is a new one."""
        return self._run.snapshot() if self._run else None

    def cancel(self) -> None:
        """Stop within a second; what was learned so far stays."""
        self._given_up = True
        if self._run:
            self._run.cancel()

    def forget(self) -> None:
        self.cancel()
        if self._folder:
            shutil.rmtree(self._folder, ignore_errors=True)


class Runs:
    """The runs of one session, by what they learn."""

    def __init__(self) -> None:
        self._runs: dict[str, Watched] = {}

    def get(self, key: str) -> Watched | None:
        return self._runs.get(key)

    @property
    def running(self) -> bool:
        return any(run.running for run in self._runs.values())

    def begin(self, key: str, world: World, settings: LearnSettings) -> Watched:
        """The run of this key: the one there is, or a new one; others that still run are cancelled."""
        for other, run in self._runs.items():
            if other != key and run.running:
                run.cancel()
        if key not in self._runs:
            self._runs[key] = Watched(world, settings)
        while len(self._runs) > MOST_KEPT:
            self._runs.pop(next(iter(self._runs))).forget()
        return self._runs[key]

    def again(self, key: str) -> None:
        """Drop a run, so that it may begin anew."""
        if key in self._runs:
            self._runs.pop(key).forget()

    def __del__(self) -> None:  # the session is over: nobody looks at its runs any more
        for run in self._runs.values():
            run.forget()
