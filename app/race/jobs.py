"""Races in the making and those made last, one or many: caches for all sessions of this server."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from app.components.track.payload import payload
from app.session.background import Told, Work
from app.session.shelf import Shelf
from laplace_core.acting.race import Entrant, Race, Races, race, races
from laplace_core.environments import GYMNASIUM_ENVIRONMENTS
from laplace_core.training.checkpoint import Loaded

MOST_KEPT = 12
"""Races of either kind. A race of two times 1,000 steps has some 6 MB of pictures, twice."""


@dataclass(frozen=True)
class Control:
    """Who races by what rule to which deadline; ``gamma`` is the discount of a greedy left side."""

    left: Loaded
    left_rule: str
    gamma: float | None
    right: Loaded
    right_rule: str
    horizon: int

    @property
    def environment(self) -> str:
        return self.right.environment

    @property
    def entrants(self) -> tuple[Entrant, Entrant]:
        left = Entrant(self.left.agent, self.left_rule, self.gamma)
        return left, Entrant(self.right.agent, self.right_rule)


class Racing(Work[tuple[Race, bytes]]):
    """One race, and the same packed for the track."""

    def __init__(self, control: Control, start: int):
        pictures = control.environment in GYMNASIUM_ENVIRONMENTS

        def make(told: Told) -> tuple[Race, bytes]:
            found = race(
                control.environment, *control.entrants, start, horizon=control.horizon, pictures=pictures, progress=told
            )
            return found, payload(found)

        super().__init__(make)


class Field(Work[tuple[Races, dict[str, Any]]]):
    """Races from many starts, and what they come to."""

    def __init__(self, control: Control, count: int):
        def make(told: Told) -> tuple[Races, dict[str, Any]]:
            found = races(control.environment, *control.entrants, control.horizon, count=count, progress=told)
            return found, found.summary()

        super().__init__(make)


_racing: Shelf[Racing] = Shelf(MOST_KEPT)
_fields: Shelf[Field] = Shelf(MOST_KEPT)


def racing(control: Control, start: int) -> Racing:
    """The race of a control from a start: the one there is, or a new one; the oldest makes room."""
    return _racing.take((control, start), lambda: Racing(control, start))


def field(control: Control, count: int) -> Field:
    """The races of a control from the first so many starts."""
    return _fields.take((control, count), lambda: Field(control, count))
