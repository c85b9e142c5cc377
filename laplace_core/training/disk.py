"""Disk space: how much runs hold, how much a run will need, and whether there is room for it."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

from laplace_core.errors import InputError

RESERVE = 50_000_000
"""Bytes of the file system that are left to everybody else."""


def held(folder: Path) -> int:
    """Bytes that the files of a folder and of those in it hold on disk; what cannot be looked at counts nothing."""
    total = 0
    try:
        entries = list(os.scandir(folder))
    except OSError:
        return 0
    for entry in entries:
        try:
            if entry.is_dir(follow_symlinks=False):
                total += held(Path(entry.path))
            else:
                total += entry.stat(follow_symlinks=False).st_size
        except OSError:  # gone since
            continue
    return total


def check_free(folder: Path, needed: int, most: int | None) -> None:
    """Refuse what there is no room for.

    Args:
        folder: of the runs.
        needed: bytes that are to be written, beside all that is there.
        most: that the runs may hold together; None is as much as there is.

    Raises:
        InputError: one sentence with the sizes and with what can be done.
    """
    if most is not None and needed + (there := held(folder)) > most:
        raise InputError(
            f"{_size(needed)} more are needed, and the runs hold {_size(there)} of the {_size(most)} that they may: "
            "remove runs, or lower buffer or hidden."
        )
    try:
        free = shutil.disk_usage(folder).free
    except OSError as error:
        raise InputError(f"{folder} cannot be used: {(error.strerror or 'unknown error').lower()}.") from None
    if needed > free - RESERVE:
        raise InputError(
            f"{_size(needed)} more are needed, and {_size(free)} of the disk are free: make room, or lower buffer."
        )


def _size(count: int) -> str:
    return f"{count / 1e6:,.1f} MB" if count < 1e8 else f"{count / 1e6:,.0f} MB"
