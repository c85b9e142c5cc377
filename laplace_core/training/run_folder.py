"""The folder of a run: ``config.json``, ``metrics.jsonl``, ``resume.safetensors``, ``best`` and ``last.safetensors``;
while it is trained, the lock is taken and ``process.json`` says by which process.

The metrics are appended to as events happen; a resume point remembers how long they were, and they are cut back to
that when a run goes on from it.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any, TextIO

import numpy as np

from laplace_core.agents.settings import SETTINGS, LoopSettings
from laplace_core.errors import InputError
from laplace_core.files.atomic import write_whole
from laplace_core.files.strict_json import parse_json
from laplace_core.files.tensor_file import read_tensors, write_tensors
from laplace_core.files.tensors import read_bytes
from laplace_core.supervise import FILE as PROCESS
from laplace_core.supervise import Process, read_process, take, write_process
from laplace_core.training.disk import check_free
from laplace_core.training.events import Event

MAX_RESUME_BYTES = 4_000_000_000
FILES = (
    "config.json", "metrics.jsonl", "resume.safetensors", "best.safetensors", "last.safetensors", "process.json",
    "progress.json", "job.json", "errors.txt",
)  # fmt: skip
"""All that a run has in its folder, each a plain file."""
_MOST_CONFIG, _MOST_METRICS = 100_000, 10_000_000_000  # bytes
RUN_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,120}")
"""The form of a run's name."""


class RunFolder:
    """A run's files.

    Args:
        settings: of a new run; None to go on with the one that is there.
        most_bytes: that all runs beside it, and this one, may hold on disk; None is as much as there is.

    Raises:
        InputError: a new run where there is one already, none where one should be, files that are not a run's, or a
            run that another process trains at this moment.
    """

    def __init__(
        self, path: str | Path, settings: LoopSettings | None, *, resume: bool, most_bytes: int | None = None
    ) -> None:
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
        self._most_bytes = most_bytes
        other, self._process = read_process(self.path), Process.of(os.getpid())
        self._lock = take(self.path)
        if self._lock is None or (other is not None and not self._process.same(other) and other.alive):
            who = "another process" if other is None or not other.near else f"the process {other.pid}"
            if self._lock is not None:
                self._lock.release()  # that of version 0.2 knows no lock
            raise InputError(f"{self.path.name} is being trained by {who}: end that one first.")
        try:
            _check_files(self.path)
            for half in self.path.glob("*.safetensors*.tmp"):  # half-written by a process that was killed
                half.unlink(missing_ok=True)
            write_process(self.path, self._process)
        except OSError as error:
            self._lock.release()
            raise InputError(
                f"{self.path.name} cannot be used: {(error.strerror or 'unknown error').lower()}."
            ) from None
        except BaseException:
            self._lock.release()
            raise

    def load(self) -> tuple[dict[str, np.ndarray], dict[str, Any]] | None:
        """The resume point; None if the run was stopped before there was one."""
        if not self.resume_point.exists():
            return None
        return read_tensors(self.resume_point, MAX_RESUME_BYTES)

    def open_metrics(self, length: int) -> None:
        """Cut the metrics to their length at the resume point, 0 for a new run, and append from there."""
        with self._writing(self.metrics):
            self.metrics.touch()
            if self.metrics.stat().st_size < length:
                raise InputError(
                    f"{self.metrics.name} is shorter than it was at the resume point: it was changed by hand."
                )
            os.truncate(self.metrics, length)
            self._file = self.metrics.open("a", encoding="utf-8")

    def write(self, event: Event) -> None:
        """Append an event to the metrics."""
        assert self._file is not None  # :meth:`open_metrics` is called first
        with self._writing(self.metrics):
            self._file.write(json.dumps({"event": type(event).__name__, **asdict(event)}) + "\n")
            self._file.flush()

    def save(self, arrays: dict[str, np.ndarray], about: dict[str, Any]) -> None:
        """Replace the resume point; the metrics so far belong to it.

        Raises:
            InputError: there is no room for it; then the last one stays.
        """
        assert self._file is not None  # :meth:`open_metrics` is called first
        check_free(self.path.parent, sum(array.nbytes for array in arrays.values()), self._most_bytes)
        with self._writing(self.metrics):
            os.fsync(self._file.fileno())
            about = about | {"metrics_bytes": self.metrics.stat().st_size}
        write_tensors(self.resume_point, arrays, about)

    @contextlib.contextmanager
    def _writing(self, path: Path) -> Iterator[None]:
        """An error of the system as one sentence about this file."""
        try:
            yield
        except OSError as error:
            raise InputError(f"{path} cannot be written: {(error.strerror or 'unknown error').lower()}.") from None

    def close(self) -> None:
        if self._file is not None:
            with contextlib.suppress(OSError):  # of what is written last on a full disk, which was refused before
                self._file.close()
        if self._process.same(read_process(self.path)):
            (self.path / PROCESS).unlink(missing_ok=True)
        if self._lock is not None:
            self._lock.release()


def _check_files(path: Path) -> None:
    """Refuse a folder in which another thing has the name of one of a run's files.

    Raises:
        InputError: naming the first of them.
    """
    for name in FILES:
        file = path / name
        if file.is_symlink() or (file.exists() and not file.is_file()):
            raise InputError(f"{path.name}/{name} is no plain file: move it away, and resume the run.")


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
    return settings_from_json(_read_text(path, _MOST_CONFIG), path.name)


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
    name = Path(path) / "metrics.jsonl"
    lines = _read_text(name, _MOST_METRICS).splitlines(keepends=True)
    try:
        return [json.loads(line) for line in lines if line.endswith("\n")]
    except ValueError:
        raise InputError(f"{name} has a line that is not JSON: it was changed by hand.") from None


def _read_text(path: Path, most: int) -> str:
    try:
        return read_bytes(path, str(path), most_bytes=most).decode()
    except UnicodeDecodeError:
        raise InputError(f"{path.name!r} is not a text file.") from None
