"""Background jobs of races, one or many; all sessions of this server share them."""

from __future__ import annotations

from typing import Any

from app.session.jobs import Wish, background
from laplace_core.acting.race import Race, Races
from laplace_core.supervise.jobs import Kind
from laplace_core.trained import races
from laplace_core.trained.races import Control

MOST_KEPT = 12
"""Races of either kind, once they were seen. One of two times 1,000 steps has some 6 MB of pictures, twice."""
_racing: Kind[tuple[Race, bytes]] = Kind("races", MOST_KEPT, line=background)
_fields: Kind[tuple[Races, dict[str, Any]]] = Kind("races from many starts", MOST_KEPT, line=background)


def racing(control: Control, start: int) -> Wish[tuple[Race, bytes]]:
    """The race of a control from a start, and the same packed for the track."""
    return Wish.of(_racing, races.racing(control, start))


def field(control: Control, count: int) -> Wish[tuple[Races, dict[str, Any]]]:
    """The races of a control from the first so many starts, and their summary."""
    return Wish.of(_fields, races.field(control, count))
