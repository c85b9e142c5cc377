"""Progress of a run: one small file in its folder, which the training process replaces every half second."""

from __future__ import annotations

import json
import math
import os
import time
from collections import deque
from dataclasses import asdict, dataclass
from pathlib import Path

from laplace_core.errors import InputError
from laplace_core.files.atomic import atomic_write
from laplace_core.files.strict_json import parse_json
from laplace_core.supervise import read_small

FILE = "progress.json"
EVERY = 0.5
"""Seconds between two notes."""
_WINDOW = 60  # notes over which the speed is measured


@dataclass(frozen=True)
class Progress:
    """The content of the file.

    Attributes:
        pid: of the process that wrote it.
        steps_per_second: over the last half minute, evaluations included; None before it is known.
    """

    pid: int
    step: int
    of: int
    steps_per_second: float | None

    @property
    def seconds_left(self) -> float | None:
        if not self.steps_per_second:
            return None
        return max(0, self.of - self.step) / self.steps_per_second


class ProgressFile:
    """Writes the file, rarely enough to cost nothing."""

    def __init__(self, folder: Path, of: int):
        self._path, self._of = folder / FILE, of
        self._notes: deque[tuple[float, int]] = deque(maxlen=_WINDOW)

    def at(self, step: int, *, last: bool = False) -> None:
        """The run has reached this step."""
        now = time.monotonic()
        if self._notes and now - self._notes[-1][0] < EVERY and not last:
            return
        self._notes.append((now, step))
        (first, begun), rate = self._notes[0], None
        if now > first and step > begun:
            rate = round((step - begun) / (now - first), 3)
        with atomic_write(self._path) as file:
            file.write(json.dumps(asdict(Progress(os.getpid(), step, self._of, rate))).encode())


def read_progress(folder: Path) -> Progress | None:
    """The last note; None if there is none, or if the file is not one."""
    try:
        about = parse_json(read_small(folder / FILE, 10_000) or "", FILE)
        progress = Progress(**about)
    except (InputError, TypeError):
        return None
    rate = progress.steps_per_second
    sane = all(type(value) is int and 0 <= value < 2**53 for value in (progress.pid, progress.step, progress.of))
    if not sane or not (rate is None or (type(rate) in (int, float) and math.isfinite(rate) and rate >= 0)):
        return None
    return progress
