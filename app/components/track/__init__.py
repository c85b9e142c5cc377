"""The race track: two episodes side by side under one cursor, and their returns until the deadline, in the browser.

The browser gets a race once (:mod:`laplace_core.payloads.track`); to move the cursor needs no server. When it comes to
rest Python gets the step, so that the link holds it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from app.components.cursor import under_cursor

COLOURS = ("#0072B2", "#D55E00")
"""Of the left and the right side, here and in the picture of many races; two of Okabe and Ito's."""


def track(
    data: bytes, at: int, key: str, names: Sequence[str], *, action_names: Sequence[str],
    on_step: Callable[[int], None], seconds: float = 0.05,
) -> None:  # fmt: skip
    """Draw a race.

    Args:
        data: from :func:`laplace_core.payloads.track.payload`.
        at: how many steps are over under the cursor.
        names: of the left and the right side.
        on_step: called with the steps at which the cursor came to rest, before the rerun, as a widget's callback.
        seconds: that a step is shown for while it plays.
    """
    extra = {"names": list(names), "actions": list(action_names), "seconds": seconds, "colours": COLOURS}
    under_cursor("track", key, data, at=at, extra=extra, on_step=on_step)
