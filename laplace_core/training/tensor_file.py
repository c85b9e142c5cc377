"""Files of named arrays and one JSON object, in the safetensors format: written whole or not at all, read with care.

Nothing in such a file is ever unpickled or run. The header's length, its JSON and every claim in it are held against
the bytes that are really there before the safetensors library sees them.
"""

from __future__ import annotations

import json
import math
import os
import stat
from pathlib import Path
from typing import Any

import numpy as np
import safetensors.numpy

from laplace_core.atomic import write_whole
from laplace_core.errors import InputError
from laplace_core.strict_json import parse_json

MAX_HEADER = 1_000_000  # bytes; a header has some hundred per array
_WIDTHS = {"BOOL": 1, "I32": 4, "I64": 8, "F32": 4, "F64": 8}
_KEY = "laplace"


def write_tensors(path: Path, arrays: dict[str, np.ndarray], about: dict[str, Any]) -> None:
    """Write arrays and what they are about."""
    arrays = {name: np.asarray(array, order="C") for name, array in arrays.items()}
    write_whole(path, safetensors.numpy.save(arrays, {_KEY: json.dumps(about, allow_nan=False)}))


def read_tensors(path: str | Path, limit: int) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """Arrays and the JSON object about them.

    Args:
        limit: most bytes that the file may have.

    Raises:
        InputError: no file, or not one that :func:`write_tensors` could have written.
    """
    name = Path(path).name or str(path)
    data = _read_bytes(Path(path), name, limit)
    header = _header(data, name)
    about = _about(header.pop("__metadata__", None), name)
    _check_layout(header, len(data) - 8 - int.from_bytes(data[:8], "little"), name)
    try:
        return safetensors.numpy.load(data), about
    except Exception:  # noqa: BLE001 - whatever the library still finds wrong, the file is not one of ours
        raise InputError(f"{name!r} is not a whole safetensors file.") from None


def _read_bytes(path: Path, name: str, limit: int) -> bytes:
    try:
        # Opened without waiting, so that a pipe in the place of a file is seen and not waited for.
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
        with os.fdopen(handle, "rb") as file:
            found = os.fstat(file.fileno())
            if not stat.S_ISREG(found.st_mode):
                raise InputError(f"{name!r} is not a file.")
            if found.st_size > limit:
                raise InputError(f"{name!r} has {found.st_size:,} bytes, above the limit of {limit:,}.")
            return file.read(limit + 1)[: found.st_size]
    except OSError as error:
        raise InputError(f"{name!r} cannot be read: {(error.strerror or 'unknown error').lower()}.") from None
    except ValueError:  # a zero byte in the name
        raise InputError(f"{name!r} cannot be the name of a file.") from None


def _header(data: bytes, name: str) -> dict[str, Any]:
    if data[:2] == b"PK":
        raise InputError(f"{name!r} is a zip archive, not a safetensors file.")
    if len(data) < 10:
        raise InputError(f"{name!r} is empty or too short for a safetensors file.")
    length = int.from_bytes(data[:8], "little")
    if length > min(MAX_HEADER, len(data) - 8):
        raise InputError(f"{name!r} is cut short or no safetensors file: its header would have {length:,} bytes.")
    header = parse_json(data[8 : 8 + length], f"the header of {name!r}")
    if not isinstance(header, dict):
        raise InputError(f"the header of {name!r} is not a JSON object.")
    return header


def _about(metadata: object, name: str) -> dict[str, Any]:
    if not isinstance(metadata, dict) or not isinstance(metadata.get(_KEY), str) or len(metadata) != 1:
        raise InputError(f"{name!r} does not say what it holds: its metadata must be one text named {_KEY!r}.")
    about = parse_json(metadata[_KEY], f"the metadata of {name!r}")
    if not isinstance(about, dict):
        raise InputError(f"the metadata of {name!r} is not a JSON object.")
    return about


def _check_layout(header: dict[str, Any], room: int, name: str) -> None:
    """Every array has a known type and a sane shape, and together they fill the file without gap or overlap."""
    spans = []
    for key, entry in header.items():
        shown = key[:60]
        if not isinstance(entry, dict) or set(entry) != {"dtype", "shape", "data_offsets"}:
            raise InputError(f"array {shown!r} in {name!r} is not described by dtype, shape and offsets.")
        kind, shape, offsets = entry["dtype"], entry["shape"], entry["data_offsets"]
        if not isinstance(kind, str) or kind not in _WIDTHS:
            raise InputError(f"array {shown!r} in {name!r} has an unknown dtype.")
        if not _whole_numbers(shape) or len(shape) > 8 or not _whole_numbers(offsets) or len(offsets) != 2:
            raise InputError(f"array {shown!r} in {name!r} has a shape or offsets that are not whole numbers.")
        if offsets[1] - offsets[0] != _WIDTHS[kind] * math.prod(shape):
            raise InputError(f"array {shown!r} in {name!r} does not have the bytes that its shape asks for.")
        spans.append(offsets)
    place = 0
    for first, last in sorted(spans):
        if first != place:
            raise InputError(f"the arrays in {name!r} overlap or leave a gap.")
        place = last
    if place != room:
        raise InputError(f"{name!r} is cut short or padded: its arrays need {place:,} bytes and it has {room:,}.")


def _whole_numbers(values: object) -> bool:
    return isinstance(values, list) and all(type(value) is int and 0 <= value < 2**40 for value in values)
