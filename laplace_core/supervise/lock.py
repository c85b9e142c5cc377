"""A lock in the folder of a run: one process at a time works there, whatever container or server it belongs to.

The system gives the lock back when its process ends, however it ends. Unlike the number of a process it means the same
in every container that shares the folder.
"""

from __future__ import annotations

from pathlib import Path

from filelock import FileLock, Timeout

from laplace_core.errors import InputError

LOCK = ".lock"
PATIENCE = 2.0
"""Seconds that a process waits for the lock: a process that only tests whether it is free holds it for a moment."""


def lock_of(folder: Path) -> FileLock:
    """The lock of a folder, not taken yet; any thread may give it back."""
    return FileLock(folder / LOCK, mode=0o644, thread_local=False, poll_interval=0.01)


def take(folder: Path) -> FileLock | None:
    """Take the lock of a folder, to be given back by ``release()``; None if another process has it.

    Raises:
        InputError: a folder in which no lock can be made.
    """
    lock = lock_of(folder)
    try:
        lock.acquire(timeout=PATIENCE)
    except Timeout:
        return None
    except OSError as error:
        raise InputError(f"{folder / LOCK} cannot be locked: {(error.strerror or 'unknown error').lower()}.") from None
    return lock


def is_taken(folder: Path) -> bool:
    """Whether a process has the lock; false if the lock file cannot be read."""
    lock = lock_of(folder)
    try:
        if not (folder / LOCK).is_file():
            return False
        lock.acquire(timeout=0)
    except Timeout:
        return True
    except OSError:
        return False
    lock.release()
    return False
