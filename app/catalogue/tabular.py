"""Agents that learned a tabular world: those that come with the workbench, and the one that this session has opened."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path

from app import session
from laplace_core import InputError
from laplace_core.caching import cached
from laplace_core.tabular import Learned, parse_learned, read_learned

SHIPPED = Path(__file__).resolve().parents[2] / "checkpoints"


@cache
def shipped_agents() -> dict[str, str | None]:
    """Names of the learned agents that come with the workbench; with a sentence where the file is damaged."""
    return {path.stem: _refusal(path) for path in sorted(SHIPPED.glob("*_td.safetensors"))}


def _refusal(path: Path) -> str | None:
    try:
        _read(path)
    except InputError as error:
        return str(error)
    return None


@cached(8, fixed=True)
def _read(path: Path) -> Learned:
    return read_learned(path)


def shipped_agent(name: str) -> Learned:
    if name not in shipped_agents():
        raise InputError(f"no agent {name[:40]!r} comes with the workbench; there are: {', '.join(shipped_agents())}.")
    return _read(SHIPPED / f"{name}.safetensors")


def opened_agents() -> Mapping[str, Learned]:
    """The agent that this session has opened from a file, by digest; one at a time."""
    return session.opened(Learned)


def open_agent(name: str, data: bytes) -> str:
    """Check an uploaded agent and keep it for this session; returns its digest.

    Raises:
        InputError: not such a file.
    """
    return session.keep_opened(parse_learned(data, name), data)


def agent(name: str) -> Learned:
    """An agent by the name that a link gives it.

    Raises:
        InputError: it neither ships with the workbench nor was opened here.
    """
    return opened_agents()[name] if name in opened_agents() else shipped_agent(name)
