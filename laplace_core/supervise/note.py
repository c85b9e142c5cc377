"""Notes in the folder of a process: which process it is, and its error messages."""

from __future__ import annotations

import json
import os
import stat
from contextlib import suppress
from dataclasses import asdict
from pathlib import Path

import psutil

from laplace_core.errors import InputError
from laplace_core.files.atomic import write_whole
from laplace_core.files.strict_json import parse_json
from laplace_core.supervise.process import Process, here

FILE = "process.json"
PLAIN = os.O_RDONLY
"""Flags to open a file in a folder of ours: no link is followed, no pipe waited for, where the system knows of them."""
for _flag in ("O_NOFOLLOW", "O_NONBLOCK", "O_BINARY"):
    PLAIN |= getattr(os, _flag, 0)
_MOST_BYTES = 10_000
_MOST_ERRORS = 10_000


def write_process(folder: Path, process: Process) -> None:
    """Record the process that works on this folder."""
    write_whole(folder / FILE, json.dumps(asdict(process)).encode())


def read_process(folder: Path) -> Process | None:
    """The process that worked on it last; None if none has, or the note is not one."""
    text = read_small(folder / FILE, _MOST_BYTES)
    try:
        about = parse_json(text or "", FILE)
        pid, started, place = about["pid"], about["started"], about.get("place", here())
    except (InputError, TypeError, KeyError, AttributeError):
        return None
    if isinstance(started, str):
        started = _started_in_0_2(started)
    if type(pid) is not int or not 1 < pid < 2**31 or type(started) not in (int, float) or not 0 <= started < 1e12:
        return None
    return Process(pid, float(started), place) if isinstance(place, str) else None


def _started_in_0_2(word: str) -> float:
    """The time in a note of version 0.2, whose processes may still run: the boot's name and clock ticks since then.

    0, which is no process's time, if the machine has been started again or the note is of another system.
    """
    with suppress(OSError, ValueError, OverflowError):
        boot, ticks = word.split()
        if boot == Path("/proc/sys/kernel/random/boot_id").read_text().strip():
            return float(psutil.boot_time()) + int(ticks) / os.sysconf("SC_CLK_TCK")
    return 0.0


def read_small(path: Path, most: int) -> str | None:
    """The text of a plain file of at most ``most`` bytes; None for anything else, a link or a pipe among it."""
    try:
        handle = os.open(path, PLAIN)
        try:
            data = os.read(handle, most + 1) if stat.S_ISREG(os.fstat(handle).st_mode) else None
        finally:
            os.close(handle)
        return None if data is None or len(data) > most else data.decode()
    except (OSError, ValueError):
        return None


def _tail(path: Path, most: int) -> bytes:
    """The last bytes of a plain file, at most so many; none of anything else."""
    try:
        handle = os.open(path, PLAIN)
        try:
            status = os.fstat(handle)
            if not stat.S_ISREG(status.st_mode):
                return b""
            os.lseek(handle, max(0, status.st_size - most), os.SEEK_SET)
            return os.read(handle, most)
        finally:
            os.close(handle)
    except OSError:
        return b""


def last_line(errors: Path) -> str:
    """The last line of a process's error messages, at most 300 characters; empty if there are none."""
    lines = _tail(errors, _MOST_ERRORS).decode(errors="replace").strip().splitlines()
    return " ".join(lines[-1].split())[:300] if lines else ""


def refusal_in(line: str) -> str | None:
    """The sentence with which the command line refused to go on; None if the line is something else."""
    return line.removeprefix("laplace: ") if line.startswith("laplace: ") else None
