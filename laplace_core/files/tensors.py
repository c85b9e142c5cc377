"""Files of named tensors, in the safetensors format: bounded in size, then checked by safetensors, then by a schema.

Nothing in such a file is ever unpickled or run, and no tensor is made before the header fits the schema.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.files.strict_json import parse_json

SHORTEST = 10  # bytes: a length and the header {}


@dataclass(frozen=True)
class TensorFile:
    """A file whose size and header have the right form; its tensors are made when they are asked for.

    Attributes:
        name: what sentences call the file.
        metadata: texts by name; what they say is for the reader to check.
        entries: what the header says of each tensor, not yet checked.
    """

    name: str
    metadata: Mapping[str, str]
    entries: Mapping[str, Any]
    content: bytes

    def load(
        self, dtypes: Collection[str], shapes: Mapping[str, tuple[str, tuple[int, ...]]] | None = None
    ) -> dict[str, np.ndarray]:
        """The tensors, as arrays of their own.

        Args:
            dtypes: those that a tensor may have, as safetensors writes them, such as "F32".
            shapes: dtype and shape of every tensor that there must be, and of no other; None allows any names and
                shapes.

        Raises:
            InputError: a tensor that is missing, unknown, or of another dtype or shape; or tensors that do not fill
                the file without gap or overlap.
        """
        from safetensors import SafetensorError
        from safetensors.numpy import load

        if shapes is not None:
            _check_names(self.entries, shapes)
        for key, entry in self.entries.items():
            tensor = f"the tensor {key[:60]!r} in {self.name}"
            if not isinstance(entry, dict) or set(entry) != {"dtype", "shape", "data_offsets"}:
                raise InputError(f"{tensor} must have dtype, shape and data_offsets.")
            dtype, shape = (None, None) if shapes is None else shapes[key]
            if entry["dtype"] not in (list(dtypes) if dtype is None else [dtype]):
                wanted = dtype or " or ".join(dtypes)
                raise InputError(f"{tensor} is {str(entry['dtype'])[:20]}; it must be {wanted}.")
            if shape is not None and entry["shape"] != list(shape):
                raise InputError(f"{tensor} has shape {str(entry['shape'])[:60]}; it must be {list(shape)}.")
        try:
            return load(self.content)
        except (SafetensorError, ValueError, KeyError, OverflowError):
            raise InputError(
                f"the tensors do not lie in {self.name} as its header says: it is cut short, padded or changed."
            ) from None


def _check_names(names: Collection[str], wanted: Collection[str]) -> None:
    for key in names:
        if key not in wanted:
            raise InputError(f"there is an unknown tensor {key[:40]!r}; known are {', '.join(wanted)}.")
    for key in wanted:
        if key not in names:
            raise InputError(f"the tensor {key!r} is missing.")


def parse_tensor_file(content: bytes, name: str, *, most_bytes: int, most_header: int) -> TensorFile:
    """Check the size and the header of a file.

    Args:
        name: what sentences call the file.
        most_bytes: that the file may have.
        most_header: bytes that its header may have.

    Raises:
        InputError: larger, cut short, or no safetensors file.
    """
    if len(content) > most_bytes:
        raise InputError(f"{name} is larger than {most_bytes:,} bytes; a file of this kind is not.")
    if len(content) < SHORTEST:
        raise InputError(f"{name} is not a .safetensors file: it has {len(content)} bytes.")
    length = int.from_bytes(content[:8], "little")
    if not 2 <= length <= min(most_header, len(content) - 8):
        raise InputError(f"{name} is not a .safetensors file, or it is cut short: its header does not fit.")
    header = parse_json(content[8 : 8 + length], f"the header of {name}")
    if not isinstance(header, dict):
        raise InputError(f"the header of {name} is not one JSON object.")
    metadata = header.pop("__metadata__", None)
    if not isinstance(metadata, dict) or not all(isinstance(value, str) for value in metadata.values()):
        raise InputError(f"{name} does not say what it holds: its metadata is missing or no text.")
    return TensorFile(name, metadata, header, content)


def read_bytes(path: str | Path, name: str, *, most_bytes: int) -> bytes:
    """The content of a plain file; never more than ``most_bytes`` of it are in memory.

    Args:
        name: what sentences call the file.

    Raises:
        InputError: no file, a folder, pipe or device in its place, or one that is larger.
    """
    try:
        # Opened without waiting, so that a pipe in the place of a file is seen and not waited for.
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    except OSError as error:
        raise InputError(f"{name} cannot be read: {(error.strerror or 'unknown error').lower()}.") from None
    except ValueError:  # a zero byte in the name
        raise InputError(f"{Path(path).name!r} cannot be the name of a file.") from None
    try:
        status = os.fstat(handle)
        if not stat.S_ISREG(status.st_mode):
            raise InputError(f"{name} is {'a directory' if stat.S_ISDIR(status.st_mode) else 'no plain file'}.")
        if status.st_size > most_bytes:
            raise InputError(f"{name} is larger than {most_bytes:,} bytes: it has {status.st_size:,}.")
        with os.fdopen(handle, "rb", closefd=False) as file:
            return file.read(most_bytes + 1)[: status.st_size]
    except OSError as error:
        raise InputError(f"{name} cannot be read: {(error.strerror or 'unknown error').lower()}.") from None
    finally:
        os.close(handle)
