"""Which process trains a run: its number and when it began, so that a number given out anew is not taken for it."""

from __future__ import annotations

import json
import os
import signal
import stat
import subprocess
import time
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path

from laplace_core.atomic import write_whole
from laplace_core.errors import InputError
from laplace_core.strict_json import parse_json

PATIENCE = 1.5
"""Seconds that a process is given to end after SIGTERM, before it is killed."""
FILE = "process.json"
_MOST_BYTES = 10_000


@dataclass(frozen=True)
class Process:
    """A process of this machine.

    Attributes:
        started: a word that no two processes of the same number share.
    """

    pid: int
    started: str

    @classmethod
    def of(cls, pid: int) -> Process:
        return cls(pid, _started(pid) or "over")

    @property
    def alive(self) -> bool:
        return _started(self.pid) == self.started

    def end(self) -> None:
        """SIGTERM, then SIGKILL, to the process and to what it has started; returns when it is gone."""
        for number in (signal.SIGTERM, signal.SIGKILL):
            if self.alive:
                self._signal(number)
            limit = time.monotonic() + PATIENCE
            while self.alive and time.monotonic() < limit:
                time.sleep(0.02)

    def _signal(self, number: int) -> None:
        try:
            # A group of its own is ended as one; another group is a shell's or a script's.
            if os.getpgid(self.pid) == self.pid:
                os.killpg(self.pid, number)
            else:
                os.kill(self.pid, number)
        except (ProcessLookupError, PermissionError):
            return


def write_process(folder: Path, process: Process) -> None:
    """Note who trains the run in this folder."""
    write_whole(folder / FILE, json.dumps(asdict(process)).encode())


def read_process(folder: Path) -> Process | None:
    """Who trained the run last; None if nobody has, or the note is none."""
    text = read_small(folder / FILE, _MOST_BYTES)
    try:
        about = parse_json(text or "", FILE)
        pid, started = about["pid"], about["started"]
    except (InputError, TypeError, KeyError):
        return None
    if type(pid) is not int or not 1 < pid < 2**31 or not isinstance(started, str):
        return None
    return Process(pid, started)


def read_small(path: Path, most: int) -> str | None:
    """The text of a plain file of at most ``most`` bytes; None for anything else, a link or a pipe among it."""
    try:
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
        try:
            data = os.read(handle, most + 1) if stat.S_ISREG(os.fstat(handle).st_mode) else None
        finally:
            os.close(handle)
        return None if data is None or len(data) > most else data.decode()
    except (OSError, ValueError):
        return None


def _started(pid: int) -> str | None:
    """When a process began, as a word; None if there is none, or if it is over and only its number is kept."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text(errors="replace").rpartition(")")[2].split()
        return None if fields[0] in "ZX" else f"{_boot()} {fields[19]}"
    except (FileNotFoundError, ProcessLookupError):
        if Path("/proc/self").exists():
            return None
    return _started_by_ps(pid)


@cache
def _boot() -> str:
    return Path("/proc/sys/kernel/random/boot_id").read_text().strip()


def _started_by_ps(pid: int) -> str | None:
    """The same where there is no /proc."""
    words = ["ps", "-o", "stat=,lstart=", "-p", str(pid)]
    told = subprocess.run(words, capture_output=True, text=True, check=False).stdout.split(None, 1)
    return None if len(told) < 2 or told[0].startswith("Z") else told[1].strip()
