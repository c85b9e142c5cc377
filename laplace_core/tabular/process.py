"""Learning in a separate process that a page can watch: no thread, no shell, and an end within a second.

The process is the command ``learn``; what passes between the two are files in one folder: the world where it is no
preset, lines of progress, and a snapshot that is always whole.
"""

from __future__ import annotations

import json
import os
import threading
from pathlib import Path

from laplace_core.errors import InputError
from laplace_core.parameters import as_text
from laplace_core.study.settings import flag
from laplace_core.supervise import Worker, command
from laplace_core.tabular.files import read_learned
from laplace_core.tabular.model import Learned
from laplace_core.tabular.settings import LEARN_SCHEMA, LearnSettings, resolve_learning
from laplace_core.worlds import World, dump_world, load_world, parse_world

PATIENCE = 0.7
"""Seconds that a process is given to end when it is asked to, before it is killed."""


def start(world: World | str, settings: LearnSettings, folder: str | Path) -> Run:
    """Begin to learn; returns at once.

    Args:
        world: a world, or the text of a world file.
        folder: an existing one, for this run alone.

    Raises:
        InputError: what the command would refuse, raised before a process is started; or a folder that cannot be used.
    """
    world = parse_world(world) if isinstance(world, str) else world
    settings = resolve_learning(settings, world)
    folder = Path(folder).resolve()
    try:
        if _is_named(world):
            words = [world.source, *(word for name, value in world.params for word in _param(name, value))]
        else:
            (folder / "world.json").write_text(dump_world(world), encoding="utf-8")
            words = [str(folder / "world.json")]
        for parameter in LEARN_SCHEMA:
            words += [flag(parameter), as_text(getattr(settings, parameter.name))]
        learned, progress = folder / "learned.safetensors", folder / "progress.jsonl"
        words += ["--out", str(learned), "--progress", str(progress), "--parent", str(os.getpid())]
        worker = Worker.start(folder, command("learn", *words))
    except OSError as error:
        raise InputError(f"learning cannot start: {(error.strerror or 'unknown error').lower()}.") from None
    return Run(worker, learned, progress)


def _is_named(world: World) -> bool:
    """Whether source and parameters are enough to build this very world again."""
    if not world.source or world.source.lower().endswith(".json"):
        return False
    try:
        return load_world(world.source, dict(world.params)) is world
    except InputError:
        return False


def _param(name: str, value: object) -> list[str]:
    return ["--param", f"{name}={as_text(value)}"]


class Run:
    """A learning process and what it has written so far; every method returns at once but ``cancel``."""

    def __init__(self, worker: Worker, learned: Path, progress: Path):
        self._worker, self._learned, self._progress = worker, learned, progress
        self._lock = threading.Lock()  # a page may be drawn twice at a time
        self._seen: tuple[tuple[int, ...], Learned] | None = None
        self._lines: list[dict[str, object]] = []
        self._offset = 0
        self._cancelled = False

    @property
    def finished(self) -> bool:
        """Whether the process has ended, for whatever reason."""
        return self._worker.ended

    @property
    def cancelled(self) -> bool:
        return self._cancelled

    @property
    def error(self) -> str | None:
        """One sentence if the process ended without finishing and without being stopped."""
        end = self._worker.end
        if end is None or end.status == 0 or self._cancelled:
            return None
        return end.refusal or (
            f"learning ended unexpectedly, with status {end.status}; "
            "start it again, with fewer seeds if memory was short."
        )

    def history(self) -> list[dict[str, object]]:
        """All lines of progress so far; see :attr:`laplace_core.tabular.Learning.progress`."""
        with self._lock:
            try:
                with self._progress.open("rb") as file:
                    file.seek(self._offset)
                    new = file.read()
            except OSError:  # not there yet
                return list(self._lines)
            whole = new[: new.rfind(b"\n") + 1]  # the last line may still be in the making
            self._offset += len(whole)
            self._lines += [json.loads(line) for line in whole.splitlines()]
            return list(self._lines)

    def progress(self) -> dict[str, object] | None:
        """The last line of progress, None before the first."""
        lines = self.history()
        return lines[-1] if lines else None

    def snapshot(self) -> Learned | None:
        """What has been learned so far, None before the first snapshot; the same object until a new one is there."""
        with self._lock:
            try:
                status = self._learned.stat()
            except OSError:
                return None
            stamp = status.st_mtime_ns, status.st_size, status.st_ino
            if self._seen is None or self._seen[0] != stamp:
                self._seen = stamp, read_learned(self._learned)
            return self._seen[1]

    def cancel(self) -> None:
        """End the process, within a second; the last snapshot stays."""
        if self.finished:
            return
        self._cancelled = True
        self._worker.stop(PATIENCE)
