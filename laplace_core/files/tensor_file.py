"""Files of named arrays and one JSON object about them, in the safetensors format: written whole or not at all.

They are read by :mod:`laplace_core.files.tensors`; which arrays there must be depends on the object, and their reader
checks it.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import safetensors.numpy

from laplace_core.errors import InputError
from laplace_core.files.atomic import write_whole
from laplace_core.files.strict_json import parse_json
from laplace_core.files.tensors import parse_tensor_file, read_bytes

MAX_HEADER = 1_000_000  # bytes; a header has some hundred per array
_DTYPES = ("BOOL", "I32", "I64", "F32", "F64")
_KEY = "laplace"


def write_tensors(path: Path, arrays: dict[str, np.ndarray], about: dict[str, Any]) -> None:
    """Write arrays and the JSON object about them."""
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
    return parse_tensors(read_bytes(path, repr(name), most_bytes=limit), name, limit)


def parse_tensors(data: bytes, name: str, limit: int) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """The same from the content of a file of this name."""
    name = repr(name)
    file = parse_tensor_file(data, name, most_bytes=limit, most_header=MAX_HEADER)
    about = _about(file.metadata, name)
    return file.load(_DTYPES), about


def _about(metadata: Mapping[str, str], name: str) -> dict[str, Any]:
    if set(metadata) != {_KEY}:
        raise InputError(f"{name} does not say what it holds: its metadata must be one text named {_KEY!r}.")
    about = parse_json(metadata[_KEY], f"the metadata of {name}")
    if not isinstance(about, dict):
        raise InputError(f"the metadata of {name} is not a JSON object.")
    return about
