"""The pictures of the page of the inverse, all of which follow one alpha while it is dragged in the browser.

The browser gets the components of the data once (:mod:`laplace_core.payloads.inverse`), and Python the state when it is
released. The protocol is described in :mod:`laplace_core.exchange.messages`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import streamlit as st

from app import session
from app.components import assets
from laplace_core.exchange import messages
from laplace_core.payloads.inverse import Band
from laplace_core.payloads.inverse_words import Rule, Said
from laplace_core.payloads.packing import pack

_HELD = 2
"""Payloads that a browser keeps (js/inverse/inverse.js)."""
AXES = ("gamma", "time")
"""What discounts are drawn over: gamma itself, or its time constant."""


@dataclass(frozen=True)
class State:
    """The state of the pictures: alpha, the deadline T in steps of the world, and the axis of the discounts."""

    alpha: float
    horizon: float
    axis: str


def inverse(
    data: bytes, state: State, key: str, *, said: Said, rules: Mapping[str, Rule], rule: str | None,
    on_release: Callable[[State], None], certified: Sequence[tuple[float, int]] | None = None,
    band: Band | None = None,
) -> None:  # fmt: skip
    """Draw the pictures.

    Args:
        data: from :func:`laplace_core.payloads.inverse.payload`.
        state: what is seen.
        rules: by name, what the rules of the payload are called.
        rule: the one that chose alpha; None of an alpha that was set by hand.
        on_release: called with a state that was released, before the rerun, as a widget's callback.
        certified: horizons, and the action that is certainly best there, -1 where none is.
        band: of a solver that is not linear, at the alpha of the state.
    """
    widget, digest = f"inverse {key}", messages.name_of(data)
    channel, shown = session.channel(widget), asdict(state)
    sent = channel.show(digest, shown)
    header = {
        "name": key,
        "id": digest,
        "revision": channel.revision,
        "state": sent,
        "said": {**asdict(said), "state": shown},
        "rules": {name: asdict(each) for name, each in rules.items()},
        "rule": rule,
        "certified": None if certified is None else [list(each) for each in certified],
        "band": None if band is None else band._asdict(),
    }

    def released() -> None:
        answer = st.session_state[widget].released
        if isinstance(answer, Mapping) and (channel.answered(answer, _HELD) or "state" in answer):
            found = checked(answer.get("state"), state)
            on_release(State(**channel.release(asdict(found), answer.get("revision"))))

    packed = pack(header, channel.due(digest, data))
    assets.component("inverse")(key=widget, data=packed, on_released_change=released, height="content")


def checked(reported: object, state: State) -> State:
    """A state from the browser, which is not to be trusted; what makes no sense is taken from ``state``."""
    given = reported if isinstance(reported, Mapping) else {}
    alpha, horizon = (_positive(given.get(name), most) for name, most in (("alpha", 1e6), ("horizon", 2000.0)))
    axis = given.get("axis")
    return State(
        state.alpha if alpha is None else alpha,
        state.horizon if horizon is None else horizon,
        str(axis) if axis in AXES else state.axis,
    )


def _positive(value: Any, most: float) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return float(value) if 0.0 < value <= most else None
