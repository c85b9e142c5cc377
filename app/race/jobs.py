"""Races in the making and those made last, one or many: caches for all sessions of this server."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from app.components.track.payload import payload
from app.session.background import Progress, Work
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


_racing: Shelf[tuple[Race, bytes]] = Shelf(MOST_KEPT)
_fields: Shelf[tuple[Races, dict[str, Any]]] = Shelf(MOST_KEPT)


def racing(control: Control, start: int) -> Work[tuple[Race, bytes]]:
    """The race of a control from a start, and the same packed for the track; the oldest makes room."""

    def make(progress: Progress) -> tuple[Race, bytes]:
        horizon, pictures = control.horizon, control.environment in GYMNASIUM_ENVIRONMENTS
        run = race(control.environment, *control.entrants, start, horizon=horizon, pictures=pictures, progress=progress)
        return run, payload(run)

    return _racing.take((control, start), make)


def field(control: Control, count: int) -> Work[tuple[Races, dict[str, Any]]]:
    """The races of a control from the first so many starts, and their summary."""

    def make(progress: Progress) -> tuple[Races, dict[str, Any]]:
        runs = races(control.environment, *control.entrants, control.horizon, count=count, progress=progress)
        return runs, runs.summary()

    return _fields.take((control, count), make)
