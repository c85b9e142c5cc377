"""Races, one or many, that are begun and done: shared by all sessions of this server."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from app.session.jobs import Wish, background
from laplace_core.acting import estimates
from laplace_core.acting.race import Entrant, Race, Races, race, races
from laplace_core.environments import GYMNASIUM_ENVIRONMENTS
from laplace_core.payloads.track import payload
from laplace_core.supervise.jobs import Kind, Progress
from laplace_core.training.checkpoint import Loaded

MOST_KEPT = 12
"""Races of either kind, once they were seen. One of two times 1,000 steps has some 6 MB of pictures, twice."""


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


_racing: Kind[tuple[Race, bytes]] = Kind("races", MOST_KEPT, line=background)
_fields: Kind[tuple[Races, dict[str, Any]]] = Kind("races from many starts", MOST_KEPT, line=background)


def racing(control: Control, start: int) -> Wish[tuple[Race, bytes]]:
    """The race of a control from a start, and the same packed for the track."""
    horizon, pictures = control.horizon, control.environment in GYMNASIUM_ENVIRONMENTS

    def make(progress: Progress) -> tuple[Race, bytes]:
        run = race(control.environment, *control.entrants, start, horizon=horizon, pictures=pictures, progress=progress)
        return run, payload(run)

    def estimate() -> float:
        return estimates.of_races(control.environment, control.entrants, horizon, pictures=pictures)

    return Wish(_racing, (control, start), make, estimate, slot="race", lower="lower T or choose quicker rules")


def field(control: Control, count: int) -> Wish[tuple[Races, dict[str, Any]]]:
    """The races of a control from the first so many starts, and their summary."""

    def make(progress: Progress) -> tuple[Races, dict[str, Any]]:
        runs = races(control.environment, *control.entrants, control.horizon, count=count, progress=progress)
        return runs, runs.summary()

    def estimate() -> float:
        return estimates.of_races(control.environment, control.entrants, control.horizon, count)

    lower = "lower T or the number of starts, or choose quicker rules"
    return Wish(_fields, (control, count), make, estimate, slot="field", lower=lower)
