"""Folders to write into, also where the file system is read-only; and folders that are named by their content."""

from __future__ import annotations

import contextlib
import hashlib
import os
import shutil
import stat
import tempfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path

_NAME_LENGTH = 12


def writable(wanted: Path, name: str) -> Path:
    """The folder that is wanted, which need not be there yet; where it cannot be written, :func:`temporary`.

    Raises:
        OSError: there is no temporary folder either.
    """
    return wanted if os.access(wanted if wanted.exists() else wanted.parent, os.W_OK) else temporary(name)


@cache
def temporary(name: str) -> Path:
    """A temporary folder of this user, the same after a restart, unless somebody else has taken its name."""
    user = os.getuid() if hasattr(os, "getuid") else 0  # where users have no numbers, each has a folder of their own
    wanted = Path(tempfile.gettempdir()) / f"{name}_{user}"
    with contextlib.suppress(OSError):
        wanted.mkdir(mode=0o700, exist_ok=True)
        status = wanted.lstat()
        if stat.S_ISDIR(status.st_mode) and status.st_uid == user:
            return wanted
    return Path(tempfile.mkdtemp(prefix=f"{name}_"))


def publish(parent: Path, content: Mapping[str, bytes]) -> Path:
    """A folder of these files, by their paths within it; it is made whole, or by another process at the same moment.

    Its name is that of its content: who knows the name never reads an old one.
    """
    folder = parent / name_by_content(*(part for name, data in content.items() for part in (name.encode(), data)))
    if folder.is_dir():
        return folder
    parent.mkdir(parents=True, exist_ok=True)
    made = Path(tempfile.mkdtemp(prefix=".", dir=parent))
    try:
        for name, data in content.items():
            (made / name).parent.mkdir(parents=True, exist_ok=True)
            (made / name).write_bytes(data)
        made.chmod(0o755)
        os.rename(made, folder)
    except OSError:
        if not folder.is_dir():
            raise
    finally:
        shutil.rmtree(made, ignore_errors=True)
    return folder


def name_by_content(*parts: bytes) -> str:
    """A short name for texts of bytes."""
    digest = hashlib.sha256()
    for part in parts:
        digest.update(hashlib.sha256(part).digest())
    return digest.hexdigest()[:_NAME_LENGTH]
