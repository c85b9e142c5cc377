"""The player: an episode under a cursor that moves in the browser, and the lens beside it follows.

The browser gets the episode once (:mod:`app.player.payload`). While the cursor moves, the player hands the lens the
gamma-space of each step; when it comes to rest Python hears the step, and the lens gets the exact one from there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import streamlit as st

from app import chart, cursor
from app.cursor import under_cursor
from app.lens import modules
from app.player.payload import payload
from app.served import served

_HERE = Path(__file__).resolve().parent


def player(
    data: bytes, at: int, key: str, names: Sequence[tuple[str, str]], *, action_names: Sequence[str],
    on_step: Callable[[int], None] | None = None, seconds: float = 0.05, flags: Mapping[str, Any] | None = None,
) -> None:  # fmt: skip
    """Draw the player.

    Args:
        data: from :func:`payload`.
        at: the step under the cursor.
        names: of the numbers of an observation, with their units; none for a tabular world.
        on_step: called with the step at which the cursor came to rest, before the rerun, as a widget's callback.
        seconds: that a step is shown for while it plays.
        flags: from :func:`app.flagging.for_player`; None while they are looked for, and the player asks again.
    """
    told = {"names": list(names), "actions": list(action_names), "seconds": seconds, "flags": flags}
    under_cursor(_component(), "player", key, data, at=at, told=told, on_step=on_step)


@cache
def _component() -> Callable:
    stub = (_HERE / "stub.js").read_text(encoding="utf-8").replace("__ADDRESS__", player_js())
    css = (_HERE / "style.css").read_text(encoding="utf-8")
    return st.components.v2.component("laplace_player", js=stub, css=css, isolate_styles=False)


@cache
def player_js() -> str:
    """The address of the player as one module."""
    return served("laplace-player.js", script().encode())


@cache
def script() -> str:
    own = "\n".join((_HERE / f"{name}.js").read_text(encoding="utf-8") for name in ("reel", "peers", "player"))
    shared = modules("algebra", "network", "model", "maths", "drawing", "controls")
    return shared + chart.joined(f"{cursor.script()}\n{own}")


__all__ = ["payload", "player", "player_js", "script"]
