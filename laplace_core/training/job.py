"""The queue's note in the folder of a run: whether it is to be trained, and why it failed."""

from __future__ import annotations

import contextlib
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
_REQUEST, _OWNER = "stop", "owner.json"


@dataclass(frozen=True)
class Job:
    """The notes of the queue about a run.

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


def ask_to_stop(path: Path) -> None:
    """Ask the process that trains a run, in any container, to end it; no effect if no file can be written."""
    with contextlib.suppress(OSError):
        (path / _REQUEST).touch()


def forget_request(path: Path) -> None:
    with contextlib.suppress(OSError):
        (path / _REQUEST).unlink(missing_ok=True)


def asked_to_stop(path: Path, since: float) -> bool:
    """Whether a file that asks for the end of a run was written after a time in seconds since 1970."""
    try:
        return (path / _REQUEST).stat().st_mtime >= since
    except OSError:
        return False


def write_owner(path: Path, owner: str) -> None:
    write_whole(path / _OWNER, json.dumps({"owner": owner}).encode())


def owner_of(path: Path) -> str | None:
    """Whose run it is, as :meth:`laplace_core.training.queue.Queue.add` was told; None for a run that is nobody's."""
    try:
        owner = parse_json(read_small(path / _OWNER, 1_000) or "", _OWNER)["owner"]
    except (InputError, TypeError, KeyError):
        return None
    return owner if isinstance(owner, str) else None


def run_folders(folder: Path) -> list[Path]:
    try:
        return [path for path in folder.iterdir() if RUN_NAME.fullmatch(path.name) and is_run(path)]
    except OSError:
        return []


def is_run(path: Path) -> bool:
    """Whether a folder holds a run; false if it cannot be read."""
    config = path / "config.json"
    try:
        return path.is_dir() and not path.is_symlink() and config.is_file() and not config.is_symlink()
    except OSError:
        return False


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
