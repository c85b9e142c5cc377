"""The shared part of the player and the race track: data sent to the browser once, under a cursor over its steps.

To move the cursor needs no server. When it comes to rest Python gets the step, so that the link holds it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import streamlit as st

from app import session
from app.components import assets
from laplace_core.exchange import messages
from laplace_core.payloads.packing import pack

HELD = 4
"""Payloads of each kind that a browser keeps (js/cursor/cursor.js)."""


def under_cursor(
    kind: str, key: str, data: bytes, *, at: int, extra: Mapping[str, Any], on_step: Callable[[int], None] | None
) -> None:
    """Draw a component whose script is built on js/cursor/cursor.js.

    Args:
        kind: of component; ``kind`` and ``key`` are its widget's name.
        data: the payload.
        at: the step under the cursor.
        extra: what else it needs, with every answer.
        on_step: called with the step at which the cursor came to rest, before the rerun, as a widget's callback.
    """
    widget = f"{kind} {key}"
    channel, digest = session.channel(widget), messages.name_of(data)
    channel.place(digest, at)

    def rested() -> None:
        answer = st.session_state[widget].rested
        if not isinstance(answer, Mapping):
            return
        channel.answered(answer, HELD)
        step = answer.get("step")
        number = isinstance(step, int | float) and not isinstance(step, bool)
        if step is not None and number and 0 <= step < 1e6 and answer.get("id") == digest:
            channel.release(int(step), answer.get("revision"))
            if on_step is not None:
                on_step(int(step))

    packed = pack({"id": digest, "revision": channel.revision, "at": at, **extra}, channel.due(digest, data))
    assets.component(kind)(key=widget, data=packed, on_rested_change=rested, height="content")
