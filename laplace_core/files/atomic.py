"""Files that appear whole or not at all.

Until it is whole a file has no name, where the system knows of such files, and so nothing is left of it if the process
is killed. Elsewhere it has another name for the time being, and what a killed process left is cleared away when the
same file is written again.
"""

from __future__ import annotations

import contextlib
import errno
import glob
import os
import secrets
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from laplace_core.errors import InputError

_NAMELESS: int = getattr(os, "O_TMPFILE", 0)
_ENDING = ".tmp"
_STALE = 3600.0  # seconds: nobody who still writes lets so many pass


@contextmanager
def atomic_write(path: str | Path) -> Iterator[BinaryIO]:
    """A binary file that takes the place of ``path`` when the block ends well.

    If the block fails, ``path`` stays as it was and nothing else is left behind.

    Raises:
        InputError: the folder is missing or not writable, or writing failed.
    """
    path = Path(path)
    temporary: Path | None = None
    try:
        if path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        with contextlib.suppress(FileNotFoundError):
            path.lstat()  # refuses a name that is too long before anything is made for it
        handle = _nameless(path.parent)
        if handle is None:
            _clear(path)
            handle, name = tempfile.mkstemp(suffix=_ENDING, prefix=path.name, dir=path.parent)
            temporary = Path(name)
    except OSError as error:
        raise _refusal(path, error) from None
    except ValueError:  # a zero byte, or a character that the file system cannot hold
        raise InputError(f"{path.name!r} cannot be the name of a file.") from None
    try:
        with os.fdopen(handle, "wb") as file:
            yield file
            file.flush()
            if temporary is None:
                temporary = path.with_name(f".{secrets.token_hex(8)}{_ENDING}")
                # By way of a descriptor of any folder the system follows the link, which leads to the file itself.
                os.link(f"/proc/self/fd/{file.fileno()}", temporary, src_dir_fd=file.fileno())
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except OSError as error:
        _drop(temporary)
        raise _refusal(path, error) from None
    except BaseException:
        _drop(temporary)
        raise


def _nameless(folder: Path) -> int | None:
    """A new file without a name, which is gone with this process unless it gets one; None where there are none."""
    if not _NAMELESS or not Path("/proc/self/fd").is_dir():
        return None
    try:
        return os.open(folder, _NAMELESS | os.O_WRONLY, 0o600)
    except OSError as error:
        if error.errno in (errno.EOPNOTSUPP, errno.EISDIR, errno.EINVAL):  # a file system that knows no such files
            return None
        raise


def _clear(path: Path) -> None:
    """Remove what processes that were killed have left of this file, an hour ago or earlier."""
    for left in path.parent.glob(f"{glob.escape(path.name)}*{_ENDING}"):
        with contextlib.suppress(OSError):
            if left.stat().st_mtime < time.time() - _STALE:
                left.unlink()


def _drop(temporary: Path | None) -> None:
    if temporary is not None:
        with contextlib.suppress(OSError):  # it was never made
            temporary.unlink()


def write_whole(path: Path, data: bytes) -> None:
    """Put ``data`` at ``path`` so that a reader sees the old file or the new one, whatever happens in between.

    Raises:
        InputError: the folder is missing, full or not writable.
    """
    with atomic_write(path) as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


def _refusal(path: Path, error: OSError) -> InputError:
    return InputError(f"{path} cannot be written: {(error.strerror or 'unknown error').lower()}.")
