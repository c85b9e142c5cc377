"""The race track: two episodes side by side under one cursor, and their returns until the deadline, in the browser.

The browser gets a race once (:mod:`app.track.payload`); to move the cursor needs no server. When it comes to rest
Python hears the step, so that the link holds it.
"""

from __future__ import annotations

import hashlib
import json
import struct
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path

import streamlit as st

from app import chart
from app.lens import modules
from app.served import served
from app.track.payload import payload

_HERE = Path(__file__).resolve().parent
_HELD = 4
"""Races that a browser keeps (track.js); what it holds is not sent again."""
COLOURS = ("#0072B2", "#D55E00")
"""Of the left and the right side, here and in the picture of many races; two of Okabe and Ito's."""


def track(
    data: bytes, at: int, key: str, names: Sequence[str], action_names: Sequence[str],
    on_step: Callable[[int], None], seconds: float = 0.05,
) -> None:  # fmt: skip
    """Draw a race.

    Args:
        data: from :func:`payload`.
        at: how many steps are over under the cursor.
        names: of the left and the right side.
        on_step: called with the steps at which the cursor came to rest, before the rerun, as a widget's callback.
        seconds: that a step is shown for while it plays.
    """
    known = st.session_state.setdefault(f"_track {key}", {"revision": 0, "held": []})
    digest = hashlib.sha256(data).hexdigest()[:16]
    if known.get("id") != digest or known.get("at") != at:
        known.update(id=digest, at=at, revision=known["revision"] + 1)
    widget = f"track {key}"

    def heard() -> None:
        found = st.session_state[widget].rested
        if not isinstance(found, Mapping):
            return
        if "missing" in found:
            known["held"] = []
            return
        known["held"] = [digest, *(each for each in known["held"] if each != digest)][:_HELD]
        step = found.get("step")
        whole = isinstance(step, int | float) and not isinstance(step, bool) and 0 <= step < 1e6
        if whole and found.get("id") == digest:
            known["at"] = int(step)
            on_step(int(step))

    told = {
        "id": digest, "revision": known["revision"], "at": at, "names": list(names), "actions": list(action_names),
        "seconds": seconds, "colours": COLOURS,
    }  # fmt: skip
    text = json.dumps(told).encode()
    sent = b"" if digest in known["held"] else data
    message = struct.pack("<I", len(text)) + text + sent
    _component()(key=widget, data=message, on_rested_change=heard, height="content")


@cache
def _component() -> Callable:
    stub = (_HERE / "stub.js").read_text(encoding="utf-8").replace("__ADDRESS__", track_js())
    css = (_HERE / "style.css").read_text(encoding="utf-8")
    return st.components.v2.component("laplace_track", js=stub, css=css, isolate_styles=False)


@cache
def track_js() -> str:
    """The address of the track as one module."""
    return served("laplace-track.js", script().encode())


@cache
def script() -> str:
    own = (_HERE / "track.js").read_text(encoding="utf-8")
    return modules("maths", "drawing", "controls") + chart.joined(own)


__all__ = ["COLOURS", "payload", "script", "track", "track_js"]
