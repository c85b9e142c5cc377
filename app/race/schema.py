"""The parameters that a link of the race page may hold: the agents, the rules, the deadline, the start."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from app.catalogue import checkpoints, training_runs
from laplace_core import InputError
from laplace_core.exchange.links import Check, Entries, Schema, Values, by_name
from laplace_core.parameters import Parameter
from laplace_core.trained import races
from laplace_core.trained.races import Control

AGENT, AGAINST = "checkpoint", "d.against"
FIRST_AGENT = "laplace_LunarLander-v3"
"""What a visitor without a link sees: an environment in which a deadline matters."""
RIVAL = Parameter(AGAINST, None, help="Another agent of this environment.", kind=str)


def opening() -> Values:
    listed = checkpoints.names()
    return {AGENT: FIRST_AGENT if FIRST_AGENT in listed else listed[0]} if listed else {}


def rivals(name: str, environment: str) -> tuple[str, ...]:
    """Other agents of the same environment."""
    return tuple(other for other in checkpoints.names() if other != name and _environment(other) == environment)


def _environment(name: str) -> str | None:
    """Of a run without opening its checkpoint: there may be many."""
    if name.startswith(checkpoints.RUN):
        settings = training_runs.queue().get(name.removeprefix(checkpoints.RUN)).settings
        return None if settings is None else settings.environment
    return checkpoints.checkpoint(name).environment


def _is_rival(values: Values) -> None:
    """The other agent is one of the same environment, and can be opened."""
    if AGAINST not in values or AGENT not in values:
        return
    environment = checkpoints.checkpoint(str(values[AGENT])).environment
    if values[AGAINST] not in rivals(str(values[AGENT]), environment):
        raise InputError(f"{str(values[AGAINST])[:40]!r} is not another agent of {environment}.")
    checkpoints.checkpoint(str(values[AGAINST]))


def _of_race(values: Values) -> dict[str, Parameter]:
    if AGENT not in values:
        return {}
    other = checkpoints.checkpoint(str(values[AGAINST])) if AGAINST in values else None
    return races.parameters(checkpoints.checkpoint(str(values[AGENT])), other)


LINK = Schema(
    opening=opening,
    steps=(
        *checkpoints.NAMED,
        Entries(by_name(RIVAL)),
        Check(_is_rival, drops=(AGAINST,)),
        Entries(_of_race),
    ),
)


def control_of(values: Mapping[str, Any]) -> Control:
    """The race of a page's values.

    Raises:
        InputError: an agent that is there no longer.
    """
    right = checkpoints.checkpoint(str(values[AGENT]))
    left = checkpoints.checkpoint(str(values[AGAINST])) if AGAINST in values else right
    return races.control_of(values, left, right)
