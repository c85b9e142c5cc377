"""A header and blocks of numbers as one string of bytes, which a browser reads without copying it."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterable, Mapping
from typing import Any


def pack(header: Mapping[str, Any], data: bytes) -> bytes:
    """A length, JSON and the payload, which begins on a multiple of 8 bytes."""
    text = json.dumps(header).encode()
    text += b" " * (-(len(text) + 4) % 8)
    return struct.pack("<I", len(text)) + text + data


def packed_blocks(blocks: Iterable[tuple[str, str, bytes, Any]]) -> tuple[dict[str, list[Any]], bytes]:
    """Blocks given by name, kind, content and size, each put on a multiple of 8 bytes.

    Returns:
        Kind, place and size of each block by its name, and all contents as one.
    """
    table, contents, at = {}, [], 0
    for name, kind, content, size in blocks:
        table[name] = [kind, at, size]
        contents.append(content + b"\0" * (-len(content) % 8))
        at += len(contents[-1])
    return table, b"".join(contents)
