"""What an in-browser component is sent: a small JSON with every answer, and a payload once.

The browser keeps the last few payloads by name; Python counts along, and hears when it was wrong.
"""

from __future__ import annotations

import hashlib
import json
import struct
from collections.abc import Mapping, Sequence
from typing import Any


def name_of(data: bytes) -> str:
    """What the browser knows a payload by."""
    return hashlib.sha256(data).hexdigest()[:16]


def pack(told: Mapping[str, Any], data: bytes) -> bytes:
    """A length, JSON and the payload, which begins on a multiple of 8 bytes."""
    text = json.dumps(told).encode()
    text += b" " * (-(len(text) + 4) % 8)
    return struct.pack("<I", len(text)) + text + data


def held(before: Sequence[str], name: str, answer: object, most: int) -> list[str]:
    """Names of the payloads that a browser holds, the last one used first, after an answer to ``name``."""
    if isinstance(answer, Mapping) and "missing" in answer:
        return []
    return [name, *(each for each in before if each != name)][:most]
