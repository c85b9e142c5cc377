"""The player: an episode under a cursor that moves in the browser, and the lens beside it follows.

The browser gets the episode once (:mod:`laplace_core.payloads.player`). While the cursor moves, the player hands the
lens the gamma-space of each step; when it comes to rest Python gets the step, and the lens the exact gamma-space of it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from app.components.cursor import under_cursor


def player(
    data: bytes, at: int, key: str, names: Sequence[tuple[str, str]], *, action_names: Sequence[str],
    on_step: Callable[[int], None] | None = None, seconds: float = 0.05, flags: Mapping[str, Any] | None = None,
) -> None:  # fmt: skip
    """Draw the player.

    Args:
        data: from :func:`laplace_core.payloads.player.payload`.
        at: the step under the cursor.
        names: of the numbers of an observation, with their units; none for a tabular world.
        on_step: called with the step at which the cursor came to rest, before the rerun, as a widget's callback.
        seconds: that a step is shown for while it plays.
        flags: ``alpha``, ``names`` of artefacts, and ``marks``, an integer a step with a bit a name; None while they
            are searched for: the player asks again.
    """
    extra = {"names": list(names), "actions": list(action_names), "seconds": seconds, "flags": flags}
    under_cursor("player", key, data, at=at, extra=extra, on_step=on_step)
