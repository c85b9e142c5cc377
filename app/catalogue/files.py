"""Which page opens a file that somebody brings."""

from __future__ import annotations

from laplace_core import InputError
from laplace_core.files.tensors import parse_tensor_file
from laplace_core.tabular.files import MAX_BYTES, MAX_HEADER

TITLES = {"worlds": "Worlds", "agents": "Trained agents"}
"""What the navigation calls the pages that open files."""
_WHAT = {"json": "a world", "npz": "a gamma-space"}


def home_of(name: str, data: bytes) -> tuple[str, str] | None:
    """The page that opens a file, and what the file is; None where only its reader can tell."""
    ending = name.lower().rpartition(".")[2]
    if ending in _WHAT:
        return "worlds", _WHAT[ending]
    try:
        metadata = parse_tensor_file(data, "it", most_bytes=MAX_BYTES, most_header=MAX_HEADER).metadata
    except InputError:
        return None
    if "laplace" in metadata:
        return "agents", "the checkpoint of a trained agent"
    return ("worlds", "an agent that learned a tabular world") if "kind" in metadata else None
