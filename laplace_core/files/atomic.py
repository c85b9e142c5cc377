"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from laplace_core.errors import InputError


@contextmanager
def atomic_write(path: str | Path) -> Iterator[BinaryIO]:
    """A binary file that takes the place of ``path`` when the block ends well.

    If the block fails, ``path`` stays as it was and nothing else is left behind.

    Raises:
        InputError: the folder is missing or not writable, or writing failed.
    """
    path = Path(path)
    try:
        handle, temporary = tempfile.mkstemp(suffix=".tmp", prefix=path.name, dir=path.parent)
    except OSError as error:
        raise _refusal(path, error) from None
    except ValueError:  # a zero byte, or a character that the file system cannot hold
        raise InputError(f"{path.name!r} cannot be the name of a file.") from None
    try:
        with os.fdopen(handle, "wb") as file:
            yield file
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except OSError as error:
        Path(temporary).unlink(missing_ok=True)
        raise _refusal(path, error) from None
    except BaseException:
        Path(temporary).unlink(missing_ok=True)
        raise


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
