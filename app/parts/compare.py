"""A view pinned as A beside the present one, B, and where they differ."""

from __future__ import annotations

import json
from html import escape

import streamlit as st

from app import compute, sources, state
from app.chart import chart
from app.figures.theme import HEIGHT
from app.link import pack
from app.parts import learning
from app.query import query_of, unpinned
from app.sources import View
from laplace_core import InputError

_UNSAID = ("pin", "edit", "compare", "look", "run", "own", "timeline")


def pin_button() -> None:
    """Pin what is seen as A; again to pin something else."""
    st.button("Pin as A", on_click=_pin, width="stretch", help="Keep this view; whatever you change is B, beside it.")


def _pin() -> None:
    values = {name: value for name, value in state.chosen().items() if name not in ("pin", "edit")}
    state.choose("pin", pack(json.dumps({"world": state.world_name(), **query_of(values)})))


def _differs(pinned: dict[str, object]) -> str:
    """In words, what was set otherwise in A and in B."""
    a, b = ({**query_of(values), "world": str(values.get("world"))} for values in (pinned, state.chosen()))
    names = [name for name in (*a, *b) if a.get(name) != b.get(name) and name not in _UNSAID]
    names = list(dict.fromkeys(names))
    if not names:
        return '<div class="artefact">Nothing is set otherwise yet.</div>'
    told = [
        f"{which}: " + ", ".join(f"{name} {values.get(name, 'by default')[:24]}" for name in names[:5])
        for which, values in (("A", a), ("B", b))
    ]
    return f'<div class="artefact">{escape(" · ".join(told))}</div>'


def comparison(view: View) -> None:
    """Three pictures: A, B, and B minus A; and a sentence."""
    if "pin" not in state.chosen():
        return
    try:
        values = unpinned(str(state.chosen()["pin"]))
        world = sources.world_of(values)
        learned, coming = (None, False) if world is None else learning.learned_in(values, world)
        if coming:
            st.info("A was learned, and is learned again from its seed; it stands here in a moment.")
            return
        pinned = sources.view_of(values, learned)
        compute.study_for(pinned)
    except InputError as error:
        st.warning(f"A cannot be shown any more: {error}")
        return
    title, choice, unpin = st.columns([3.2, 1, 0.7], vertical_alignment="center")
    title.html(f'<div class="panel-title">A, pinned, against B, what you see above</div>{_differs(values)}')
    with choice:
        key = state.show("compare", "tau-space")
        st.segmented_control("Space", ("tau-space", "gamma-space"), key=key, on_change=state.keep, args=(key,),
                             label_visibility="collapsed", required=True)  # fmt: skip
    with unpin:
        st.button("Unpin", on_click=state.choose, args=("pin", None), width="stretch")
    what = state.chosen().get("compare", "tau-space").replace("-", "_")
    sentence, figures = compute.comparison(pinned, view, what)
    for column, (name, figure) in zip(st.columns(3, gap="small"), figures.items(), strict=False):
        with column:
            chart(figure, f"compare {name}", f"{what.replace('_', '-')}: {name}", HEIGHT, what)
    st.caption(sentence)
