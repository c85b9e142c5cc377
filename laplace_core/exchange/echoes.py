"""Whether the value that a widget reports was set by the user, or is an echo of a change by the server.

A browser reports all its widgets with each event, as it has them. One that the server has changed or replaced since
(a remedy, Back, another world) comes back with what it showed before, and looks as if somebody had touched it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Shown:
    """The value that a widget shows, and the one before the server changed it (None if the user changed it)."""

    now: Any = None
    before: Any = None

    def then(self, value: object) -> Shown:
        """The same widget after the server put a value into it."""
        return self if value == self.now else Shown(value, self.now)


def is_echo(value: object, shown: Shown, *, by_hand: bool, others: bool) -> bool:
    """Whether a reported value is an echo, which is dropped; other values are kept as set by hand.

    ======================  ===========  =============  ========  ==================================================
    it reports              by hand      others report  it is     because
    ======================  ===========  =============  ========  ==================================================
    what it shows           no           no or yes      dropped   nobody has touched it
    what it shows           yes          no or yes      kept      it was set by hand before, and still is
    what it showed before   no or yes    yes            dropped   the browser had not drawn the server's change yet
    what it showed before   no or yes    no             kept      a person took the server's change back
    something else          no or yes    no or yes      kept      only a person can have set it
    ======================  ===========  =============  ========  ==================================================

    A widget that a person has changed showed nothing before, so that to go back by hand is never an echo.

    Args:
        by_hand: whether the widget's value counts as set by hand already.
        others: whether other widgets report in the same event, those aside that are in the first row.
    """
    if value == shown.now:
        return not by_hand
    return others and value == shown.before


def touches(reports: Mapping[str, Any], widgets: Mapping[str, Shown], chosen: Mapping[str, Any]) -> dict[str, Any]:
    """The reports of one event, by widget, that the user made.

    Args:
        widgets: what each of them shows.
        chosen: what is set by hand.
    """

    def kept(among: Mapping[str, Any], *, others: bool) -> dict[str, Any]:
        return {
            name: value
            for name, value in among.items()
            if not is_echo(value, widgets.get(name, Shown()), by_hand=name in chosen, others=others)
        }

    speaking = kept(reports, others=False)
    return kept(speaking, others=len(speaking) > 1)
