"""A process: its number, its start time, so that another process with a reused number differs, and where it runs, so
that one of another container or machine differs as well."""

from __future__ import annotations

import contextlib
import os
import platform
import subprocess
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import psutil

import laplace_core

ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
"""Environment variables of a process that uses one core and leaves the others free."""
PATIENCE = 1.5
"""Seconds that a process is given to end when it is asked to, before it is killed."""
_SAME = 2.0
"""Seconds by which two readings of the time of birth may differ: the system knows its own start to a second only."""


@cache
def here() -> str:
    """The namespace of process numbers: every container has its own."""
    with contextlib.suppress(OSError, AttributeError):
        boot = Path("/proc/sys/kernel/random/boot_id").read_text(encoding="ascii").strip()
        return f"{boot} {os.readlink('/proc/self/ns/pid')}"
    return platform.node()


@dataclass(frozen=True)
class Process:
    """A process, running or ended.

    Attributes:
        started: when it began, in seconds since 1970; 0 if it was already over when this object was made.
        place: where its number is valid, see :func:`here`.
    """

    pid: int
    started: float
    place: str = field(default_factory=here)

    @classmethod
    def of(cls, pid: int) -> Process:
        """The process that has this number now."""
        return cls(pid, _began(_running(pid)))

    @property
    def near(self) -> bool:
        """Whether it can be seen and ended from here; not if it is in another container."""
        return self.place == here()

    @property
    def alive(self) -> bool:
        """Whether it runs here; a zombie, for which its parent has not waited yet, does not."""
        return self._running_process() is not None

    def _running_process(self) -> psutil.Process | None:
        process = _running(self.pid) if self.near else None
        return process if process is not None and abs(_began(process) - self.started) < _SAME else None

    def same(self, other: Process | None) -> bool:
        """Whether both are one process."""
        if other is None or (self.pid, self.place) != (other.pid, other.place):
            return False
        return abs(self.started - other.started) < _SAME

    def ask(self) -> None:
        """Ask this process alone to end, and return at once; nothing happens if it is over."""
        process = self._running_process()
        if process is not None:
            with contextlib.suppress(psutil.Error):  # it is over by now, or belongs to somebody else
                process.terminate()

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
        process = self._running_process()
        if process is None:
            return []
        try:
            return [process, *process.children(recursive=True)]
        except psutil.Error:
            return [process]


def start(words: Sequence[str], errors: Path) -> subprocess.Popen[bytes]:
    """Begin a process that uses one thread, has no input, and writes its error messages to ``errors``.

    It belongs to no terminal, so that Ctrl-C at the server does not reach it.

    Raises:
        OSError: the file cannot be made, or the process not be started.
    """
    errors.unlink(missing_ok=True)
    # Never through a link that somebody put there; at the end of the file, whoever else has written to it.
    with open(errors, "xb", opener=lambda path, flags: os.open(path, flags | os.O_APPEND, 0o644)) as file:
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
        process = psutil.Process(pid)
    except psutil.Error:
        return None
    return process if _runs(process) else None


def _began(process: psutil.Process | None) -> float:
    """When a process began, 0 if there is none."""
    try:
        return 0.0 if process is None else float(process.create_time())
    except psutil.Error:
        return 0.0


def _runs(process: psutil.Process) -> bool:
    try:
        return bool(process.is_running()) and process.status() not in (psutil.STATUS_ZOMBIE, psutil.STATUS_DEAD)
    except psutil.Error:
        return False
