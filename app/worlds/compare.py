"""A view pinned as A compared with the present one, B."""

from __future__ import annotations

import json
from html import escape
from typing import Any

import streamlit as st

from app.components.chart import chart
from app.components.lens import Pin
from app.session import store
from app.session.typed import in_markdown
from app.view import compute
from app.worlds import learning, sources
from app.worlds.actions import world_name
from app.worlds.schema import unpinned
from laplace_core import InputError
from laplace_core.exchange.links import query_of
from laplace_core.files.packed_text import pack
from laplace_core.payloads.state import state_of
from laplace_core.subjects import View

_UNSAID = ("pin", "edit", "compare", "look", "run", "own", "timeline")


def pin(*, keep: bool = True) -> None:
    """Pin the present view as A, to be compared with later ones (B); or unpin A."""
    query = {"world": world_name(), **query_of(store.without("pin", "edit"))}
    store.choose("pin", pack(json.dumps(query)) if keep else None)


def _pinned() -> tuple[dict[str, Any], View | None]:
    """The values of A and its view; None while what was learned of it is learned again.

    Raises:
        InputError: A cannot be shown any more.
    """
    values = unpinned(str(store.chosen()["pin"]))
    world = sources.world_of(values)
    learned, coming = (None, False) if world is None else learning.learned_in(values, world)
    return values, None if coming else sources.view_of(values, learned)


def _state(view: View) -> dict[str, Any] | None:
    """The state of the lens at A, where it shows the same payload as the present view."""
    try:
        values, pinned = _pinned()
        if pinned is None or compute.lens_payload(pinned) != compute.lens_payload(view):
            return None
    except InputError:
        return None
    look = str(values.get("look", "heatmap"))
    return state_of(compute.study_for(pinned).settings, compute.horizon_of(pinned), action=pinned.action, look=look)


def pinning(view: View) -> Pin:
    """The data about A that the lens needs."""
    pinned = "pin" in store.chosen()
    return Pin(pinned, _state(view) if pinned else None, lambda keep: pin(keep=keep))


def _differs(pinned: dict[str, Any]) -> str:
    """The settings that differ between A and B, in words."""
    a, b = ({**query_of(values), "world": str(values.get("world"))} for values in (pinned, store.chosen()))
    names = list(dict.fromkeys(name for name in (*a, *b) if a.get(name) != b.get(name) and name not in _UNSAID))
    if not names:
        return '<div class="artefact">A and B have the same settings.</div>'
    settings = [
        f"{which}: " + ", ".join(f"{name} {values.get(name, 'by default')[:24]}" for name in names[:5])
        for which, values in (("A", a), ("B", b))
    ]
    return f'<div class="artefact">{escape(" · ".join(settings))}</div>'


def comparison(view: View) -> None:
    """Three pictures: A, B, and B minus A; and a sentence."""
    if "pin" not in store.chosen():
        return
    try:
        values, pinned = _pinned()
        if pinned is None:
            st.info("A is being learned again from its seed and will appear here soon.")
            return
        compute.study_for(pinned)
    except InputError as error:
        st.warning(f"A can no longer be shown: {in_markdown(error)}")
        return
    title, choice, away = st.columns([3.2, 1, 0.7], vertical_alignment="center")
    title.html(f'<h2 class="panel-title">A (pinned) compared with B (the view above)</h2>{_differs(values)}')
    with choice:
        key = store.show("compare", "tau-space")
        st.segmented_control("Space", ("tau-space", "gamma-space"), key=key, on_change=store.keep, args=(key,),
                             label_visibility="collapsed", required=True)  # fmt: skip
    with away:
        st.button("Unpin", on_click=pin, kwargs={"keep": False}, width="stretch")
    what = store.chosen().get("compare", "tau-space").replace("-", "_")
    sentence, figures = compute.comparison(pinned, view, what)
    for column, (name, figure) in zip(st.columns(3, gap="small"), figures.items(), strict=False):
        chart(figure, f"compare {name}", f"{what.replace('_', '-')}: {name}", revision=what, place=column)
    st.caption(in_markdown(sentence))
