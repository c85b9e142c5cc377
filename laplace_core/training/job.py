"""The queue's note in the folder of a run: whether it is to be trained, and why it failed."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from laplace_core.agents.settings import LoopSettings
from laplace_core.errors import InputError
from laplace_core.files.atomic import write_whole
from laplace_core.files.strict_json import parse_json
from laplace_core.supervise import read_small
from laplace_core.training.run_folder import RUN_NAME, settings_from_json

_MOST_CONFIG = 100_000  # bytes


@dataclass(frozen=True)
class Job:
    """What the queue notes of a run.

    Attributes:
        wanted: "run", "stop", "fail" once it has failed, or "later": its process was asked to end from outside, as when
            a machine is shut down, and the next queue lets it go on.
        ticket: decides who is next.
        begun: whether a process was started for it.
    """

    wanted: str
    ticket: int
    begun: bool = False
    error: str | None = None


def read_job(path: Path) -> Job:
    """The queue's note; a run from elsewhere has none, and is not to be trained."""
    try:
        job = Job(**parse_json(read_small(path / "job.json", 10_000) or "", "job.json"))
    except (InputError, TypeError):
        return Job("stop", 0)
    sane = job.wanted in ("run", "stop", "fail", "later") and type(job.ticket) is int and isinstance(job.begun, bool)
    return job if sane and (job.error is None or isinstance(job.error, str)) else Job("stop", 0)


def write_job(path: Path, job: Job) -> None:
    write_whole(path / "job.json", json.dumps(vars(job)).encode())


def run_folders(folder: Path) -> list[Path]:
    try:
        return [path for path in folder.iterdir() if RUN_NAME.fullmatch(path.name) and is_run(path)]
    except OSError:
        return []


def is_run(path: Path) -> bool:
    config = path / "config.json"
    return path.is_dir() and not path.is_symlink() and config.is_file() and not config.is_symlink()


@lru_cache(maxsize=512)
def settings_in(config: Path, born: float) -> tuple[LoopSettings | None, str]:
    """Settings, or why there are none; read once for a time of writing."""
    try:
        return settings_from_json(read_small(config, _MOST_CONFIG) or "", config.name), ""
    except InputError as refused:
        return None, str(refused)


def born_at(path: Path) -> float:
    try:
        return (path / "config.json").stat().st_mtime
    except OSError:
        return 0.0
