"""The lens: gamma-space, tau-space and what is read from them, moving in the browser as fast as it draws.

The inverse is linear. The browser gets its factors once per world, grid and policy
(:mod:`laplace_core.payloads.lens`) and computes everything else; Python gets the state when a control is released.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import streamlit as st

from app import session
from app.components import assets
from laplace_core.exchange import messages
from laplace_core.inverse import SOLVERS
from laplace_core.payloads.packing import pack

_HELD = 2
"""Payloads that a browser keeps (js/lens/models.js); what it holds is not sent again."""


@dataclass(frozen=True)
class Preset:
    """A view worth seeing.

    Attributes:
        values: what a page has to hold to show it.
        here: whether ``state`` shows it in the present lens, in the world and on the grids that it needs.
    """

    name: str
    values: Mapping[str, Any]
    here: bool
    state: Mapping[str, Any]


@dataclass(frozen=True)
class Released:
    """A report of the browser: the state of the lens when a control is released, or another request.

    Attributes:
        preset: a view that needs another world.
        remedy: index of a remedy of the verdict.
        picked: a state clicked in the graph of the world.
        pin: whether the view is to be kept as A, or no longer.
        solver: another solver that was asked for.
        story: a step of the guided story; 0 ends it.
        follow: whether the action that was taken is to be shown at every step, or the one of ``state``.
    """

    state: dict[str, Any]
    preset: str | None = None
    remedy: int | None = None
    picked: int | None = None
    pin: bool | None = None
    solver: str | None = None
    story: int | None = None
    follow: bool | None = None


@dataclass(frozen=True)
class Said:
    """The library's verdict on the state that is passed; remedies by their labels.

    ``tone`` is ok, bad, warn (a right choice on wrong values), smeared or ruined (a right choice over such a timeline)
    or unknown.
    """

    tone: str
    sentence: str
    remedies: tuple[str, ...] = ()


@dataclass(frozen=True)
class Graph:
    """The world as a plotly figure in JSON, in words, and what its zoom belongs to."""

    figure: str
    alt: str
    revision: str


@dataclass(frozen=True)
class Pin:
    """The view that is pinned as A, on a page that can pin one.

    Attributes:
        pinned: whether there is one.
        state: that of the lens at A, where it can be drawn from the payload of the present view.
        keep: pins the present view (True) or lets A go (False).
    """

    pinned: bool
    state: Mapping[str, Any] | None
    keep: Callable[[bool], None]


def lens(
    data: bytes,
    state: Mapping[str, Any],
    key: str,
    *,
    base: Mapping[str, Any] | None = None,
    presets: Sequence[Preset] = (),
    on_release: Callable[[Released], None] | None = None,
    said: Said | None = None,
    world: Graph | None = None,
    pin: Pin | None = None,
    lead: Mapping[str, Any] | None = None,
    followed: Mapping[str, Any] | None = None,
    rule: str | None = None,
    coming: str | None = None,
    follows: bool = False,
    story: Mapping[str, Any] | None = None,
) -> None:
    """Draw the lens; the state that is released has to pass through :func:`laplace_core.payloads.state.checked`.

    The protocol is described in :mod:`laplace_core.exchange.messages`.

    Args:
        data: from :func:`laplace_core.payloads.lens.payload`.
        state: what the controls hold; :func:`laplace_core.payloads.state.state_of`.
        base: where Reset leads; default: ``state``.
        on_release: called before the rerun, as a widget's callback.
        said: the verdict on ``state``; without it the lens judges by itself.
        world: drawn in the first place; without it the fit over the discounts stands there.
        pin: how a view is kept as A, where it can be.
        lead: ``id`` and ``step`` of the episode whose player (:mod:`app.components.player`) the lens follows.
        followed: what was observed, to be drawn on the timeline; see :func:`laplace_core.trained.rollouts.followed`.
        rule: the title of the rule that chose alpha; None of an alpha that was set by hand.
        coming: the solver whose timeline is being computed, while that of another one is drawn: it is not offered.
        follows: whether the action that is shown is the one that was taken, at every step.
        story: the guided story, where the page has one: the step ``at`` that is shown, and all ``steps``.
    """
    widget, digest = f"lens {key}", messages.name_of(data)
    channel = session.channel(widget)
    sent = channel.show(digest, state)
    header = {
        "name": key,
        "id": digest,
        "revision": channel.revision,
        "state": sent,
        "base": dict(base or sent),
        "presets": [{"name": each.name, "here": each.here, "state": dict(each.state)} for each in presets],
        "said": None if said is None else {**asdict(said), "state": dict(state)},
        "world": None if world is None else asdict(world),
        "pinnable": pin is not None,
        "pinned": pin is not None and pin.pinned,
        "pin": None if pin is None or pin.state is None else dict(pin.state),
        "lead": None if lead is None else dict(lead),
        "followed": None if followed is None else dict(followed),
        "rule": rule,
        "coming": coming,
        "follows": follows,
        "story": None if story is None else dict(story),
        "plotly": assets.plotly_js(),
    }

    def released() -> None:
        answer = st.session_state[widget].released
        if not isinstance(answer, Mapping) or (not channel.answered(answer, _HELD) and "state" not in answer):
            return
        report = _released(answer, presets)
        report = replace(report, state=channel.release(report.state, answer.get("revision")))
        if on_release is not None:
            on_release(report)

    packed = pack(header, channel.due(digest, data))
    assets.component("lens", "entry")(key=widget, data=packed, on_released_change=released, height="content")


def _released(report: Mapping[str, Any], presets: Sequence[Preset]) -> Released:
    """What the browser says, which is not to be trusted: ``checked`` looks at the state value by value."""
    state, preset, pin, solver, follow = (report.get(name) for name in ("state", "preset", "pin", "solver", "follow"))
    remedy, picked, story = (_index(report.get(name)) for name in ("remedy", "picked", "story"))
    return Released(
        dict(state) if isinstance(state, Mapping) else {},
        preset if preset in [each.name for each in presets] else None,
        remedy,
        picked,
        pin if isinstance(pin, bool) else None,
        solver if isinstance(solver, str) and solver in SOLVERS else None,
        story,
        follow if isinstance(follow, bool) else None,
    )


def _index(value: object) -> int | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return int(value) if 0 <= value < 2**31 else None


def standalone(data: bytes, state: Mapping[str, Any], base: Mapping[str, Any] | None = None) -> str:
    """The lens as one HTML file that works without a network."""
    held = {"state": dict(state), "base": dict(base or state), "payload": base64.b64encode(data).decode()}
    place = '<script id="held" type="application/json">'
    return assets.offline_page().replace(place, place + json.dumps(held).replace("<", "\\u003c"), 1)
