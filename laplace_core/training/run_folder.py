"""The folder of a run: ``config.json``, ``metrics.jsonl``, ``resume.safetensors``, ``best`` and ``last.safetensors``;
while it is trained, ``process.json`` says by which process.

The metrics are appended to as events happen; a resume point remembers how long they were, and they are cut back to
that when a run goes on from it.
"""

from __future__ import annotations

import json
import os
import re
from dataclasses import asdict
from pathlib import Path
from typing import Any, TextIO

import numpy as np

from laplace_core.agents.settings import SETTINGS, LoopSettings
from laplace_core.errors import InputError
from laplace_core.files.atomic import write_whole
from laplace_core.files.strict_json import parse_json
from laplace_core.files.tensor_file import read_tensors, write_tensors
from laplace_core.supervise import FILE as PROCESS
from laplace_core.supervise import Process, read_process, write_process
from laplace_core.training.events import Event

MAX_RESUME_BYTES = 4_000_000_000
RUN_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,120}")
"""What a run may be called where it is asked for by name."""


class RunFolder:
    """A run's files.

    Args:
        settings: of a new run; None to go on with the one that is there.

    Raises:
        InputError: a new run where there is one already, none where one should be, files that are not a run's, or a
            run that another process trains at this moment.
    """

    def __init__(self, path: str | Path, settings: LoopSettings | None, *, resume: bool) -> None:
        self.path = Path(path)
        self.metrics, self.resume_point = self.path / "metrics.jsonl", self.path / "resume.safetensors"
        self.best, self.last = self.path / "best.safetensors", self.path / "last.safetensors"
        config = self.path / "config.json"
        if resume:
            self.settings = read_config(config)
            if settings is not None and settings != self.settings:
                raise InputError(f"{self.path.name} was begun with other settings: leave them out to resume it.")
        else:
            if settings is None:
                raise InputError("a new run needs settings.")
            if config.exists():
                raise InputError(f"{self.path.name} holds a run already: resume it, or choose another folder.")
            self.settings = settings
            new_run(self.path, settings)
        self._file: TextIO | None = None
        other, self._process = read_process(self.path), Process.of(os.getpid())
        if other is not None and not self._process.same(other) and other.alive:
            raise InputError(f"{self.path.name} is being trained by the process {other.pid}: end that one first.")
        for half in self.path.glob("*.safetensors*.tmp"):  # half-written by a process that was killed
            half.unlink(missing_ok=True)
        write_process(self.path, self._process)

    def load(self) -> tuple[dict[str, np.ndarray], dict[str, Any]] | None:
        """The resume point; None if the run was stopped before there was one."""
        if not self.resume_point.exists():
            return None
        return read_tensors(self.resume_point, MAX_RESUME_BYTES)

    def open_metrics(self, length: int) -> None:
        """Cut the metrics to their length at the resume point, 0 for a new run, and append from there."""
        self.metrics.touch()
        if self.metrics.stat().st_size < length:
            raise InputError(f"{self.metrics.name} is shorter than it was at the resume point: it was changed by hand.")
        os.truncate(self.metrics, length)
        self._file = self.metrics.open("a", encoding="utf-8")

    def write(self, event: Event) -> None:
        """Append an event to the metrics."""
        assert self._file is not None  # :meth:`open_metrics` is called first
        self._file.write(json.dumps({"event": type(event).__name__, **asdict(event)}) + "\n")
        self._file.flush()

    def save(self, arrays: dict[str, np.ndarray], about: dict[str, Any]) -> None:
        """Replace the resume point; the metrics so far belong to it."""
        assert self._file is not None  # :meth:`open_metrics` is called first
        os.fsync(self._file.fileno())
        about = about | {"metrics_bytes": self.metrics.stat().st_size}
        write_tensors(self.resume_point, arrays, about)

    def close(self) -> None:
        if self._file is not None:
            self._file.close()
        if self._process.same(read_process(self.path)):
            (self.path / PROCESS).unlink(missing_ok=True)


def new_run(path: Path, settings: LoopSettings) -> None:
    """A folder that holds no more than settings: to resume it is to begin it.

    Raises:
        InputError: the folder cannot be made.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = (error.strerror or "unknown error").lower()
        raise InputError(f"the folder {path.name} cannot be made: {reason}.") from None
    about = {"algorithm": settings.ALGORITHM, "settings": settings.as_dict()}
    write_whole(path / "config.json", (json.dumps(about, indent=1) + "\n").encode())


def read_config(path: Path) -> LoopSettings:
    """The settings of a run.

    Raises:
        InputError: no run there, or not one of ours.
    """
    return settings_from_json(_read_text(path), path.name)


def settings_from_json(text: str, name: str) -> LoopSettings:
    """Settings from ``{"algorithm": ..., "settings": {...}}``; those left out have their defaults."""
    about = parse_json(text, name)
    if not isinstance(about, dict) or not isinstance(about.get("settings"), dict):
        raise InputError(f"{name} must hold 'algorithm' and 'settings'.")
    if not isinstance(about.get("algorithm"), str) or about["algorithm"] not in SETTINGS:
        raise InputError(f"{name} must name one of the algorithms {', '.join(SETTINGS)}.")
    return SETTINGS[about["algorithm"]].parse(about["settings"])


def read_metrics(path: str | Path) -> list[dict[str, Any]]:
    """Events of a run folder's metrics as dictionaries; a last line that is still being written is left out."""
    lines = _read_text(Path(path) / "metrics.jsonl").splitlines(keepends=True)
    return [json.loads(line) for line in lines if line.endswith("\n")]


def _read_text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(f"{path} cannot be read: {(error.strerror or 'unknown error').lower()}.") from None
    except ValueError:
        raise InputError(f"{path.name!r} is not a text file.") from None
