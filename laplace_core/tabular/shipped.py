"""The bundled agents of a folder that learned a tabular world.

A folder is looked at once: :func:`forget` is for one whose files were changed meanwhile.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from laplace_core.caching import cached
from laplace_core.errors import InputError
from laplace_core.tabular.files import read_learned
from laplace_core.tabular.model import Learned


@cache
def names(folder: Path) -> dict[str, str | None]:
    """Names of the agents; with a sentence where the file is damaged."""
    return {path.stem: _refusal(path) for path in sorted(folder.glob("*_td.safetensors"))}


def _refusal(path: Path) -> str | None:
    try:
        _load(path)
    except InputError as error:
        return str(error)
    return None


@cached(8, fixed=True)
def _load(path: Path) -> Learned:
    return read_learned(path)


def load(folder: Path, name: str) -> Learned:
    """The agent of a name.

    Raises:
        InputError: there is none, or its file is damaged.
    """
    if name not in names(folder):
        raise InputError(f"no agent {name[:40]!r} comes with the workbench; there are: {', '.join(names(folder))}.")
    return _load(folder / f"{name}.safetensors")


def forget() -> None:
    """Look at all folders again."""
    names.cache_clear()
    _load.cache_clear()
