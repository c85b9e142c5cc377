"""Agents that learned a tabular world: those that come with the workbench, and the one that this session has opened."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from app import session
from laplace_core.tabular import Learned, parse_learned, shipped

SHIPPED = Path(__file__).resolve().parents[2] / "checkpoints"


def learners() -> dict[str, str | None]:
    """Names of the learned agents that come with the workbench; with a sentence where the file is damaged."""
    return shipped.names(SHIPPED)


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
    return opened_agents()[name] if name in opened_agents() else shipped.load(SHIPPED, name)
