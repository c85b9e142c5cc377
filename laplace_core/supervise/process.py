"""A process of this machine: its number and when it began, so that a number given out anew is not taken for it."""

from __future__ import annotations

import contextlib
import os
import subprocess
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import psutil

import laplace_core

ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
"""Environment of a process that leaves the other cores to the others."""
PATIENCE = 1.5
"""Seconds that a process is given to end when it is asked to, before it is killed."""
_SAME = 2.0
"""Seconds by which two readings of the time of birth may differ: the system knows its own start to a second only."""


@dataclass(frozen=True)
class Process:
    """A process, over or not.

    Attributes:
        started: when it began, in seconds since 1970; 0 if it was over when it was looked for.
    """

    pid: int
    started: float

    @classmethod
    def of(cls, pid: int) -> Process:
        """The process that has this number now."""
        return cls(pid, _began(_running(pid)))

    @property
    def alive(self) -> bool:
        """Whether it still runs; one that is over but not yet waited for by its parent does not."""
        return self._found() is not None

    def _found(self) -> psutil.Process | None:
        found = _running(self.pid)
        return found if found is not None and abs(_began(found) - self.started) < _SAME else None

    def same(self, other: Process | None) -> bool:
        """Whether both are one process."""
        return other is not None and self.pid == other.pid and abs(self.started - other.started) < _SAME

    def end(self, patience: float = PATIENCE) -> None:
        """Ask the process and all that it has started to end, then kill what is left; returns when they are gone.

        Args:
            patience: seconds from the request to the kill, and from the kill to the return.
        """
        family: list[psutil.Process] = []
        for act in (psutil.Process.terminate, psutil.Process.kill):
            family += [one for one in self._family() if one not in family]
            for one in family:
                with contextlib.suppress(psutil.Error):  # it is over by now, or belongs to somebody else
                    act(one)
            limit = time.monotonic() + patience
            # Not by psutil's own wait: it would take the status of our children from who started them.
            while (left := [one for one in family if _runs(one)]) and time.monotonic() < limit:
                time.sleep(0.02)
            if not left:
                return

    def _family(self) -> list[psutil.Process]:
        """The process and those that it has started, and they in turn; none if it is over."""
        found = self._found()
        if found is None:
            return []
        try:
            return [found, *found.children(recursive=True)]
        except psutil.Error:
            return [found]


def start(words: Sequence[str], errors: Path) -> subprocess.Popen[bytes]:
    """Begin a process that uses one thread, hears nothing, and writes what it complains about to ``errors``.

    It belongs to no terminal, so that Ctrl-C at the server does not reach it.

    Raises:
        OSError: the file cannot be made, or the process not be started.
    """
    errors.unlink(missing_ok=True)
    with open(errors, "xb") as file:  # never through a link that somebody put there
        return subprocess.Popen(
            words,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=file,
            cwd=Path(laplace_core.__file__).parents[1],  # where -m finds this very package
            env=os.environ | ONE_THREAD,
            start_new_session=True,
        )


def _running(pid: int) -> psutil.Process | None:
    try:
        found = psutil.Process(pid)
    except psutil.Error:
        return None
    return found if _runs(found) else None


def _began(found: psutil.Process | None) -> float:
    """When a process began, 0 if there is none."""
    try:
        return 0.0 if found is None else float(found.create_time())
    except psutil.Error:
        return 0.0


def _runs(found: psutil.Process) -> bool:
    try:
        return bool(found.is_running()) and found.status() not in (psutil.STATUS_ZOMBIE, psutil.STATUS_DEAD)
    except psutil.Error:
        return False
