"""The tabular workbench: one state of a world, from its gamma-space to the action of every horizon."""

from __future__ import annotations

import streamlit as st

from app.components.waiting import turn
from app.session import store
from app.session.typed import in_markdown
from app.view import compute, feasible, panels
from app.worlds import bring, compare, export, learners, learning, sidebar, sources, story
from app.worlds.presets import presets_for
from app.worlds.schema import LINK
from laplace_core import InputError
from laplace_core.payloads.state import LIVE
from laplace_core.subjects import View

LOOK_EVERY = 0.7  # seconds between two looks at a learner


def page() -> None:
    store.open_page("worlds", LINK)
    with st.sidebar:
        if not sidebar.groups():
            return
    running = learners.at_work()
    st.fragment(_view, run_every=LOOK_EVERY if running else None)(running=running)


def _view(*, running: bool) -> None:
    """The main area. Its own controls rerun only this, and leave the sidebar alone."""
    if store.sidebar_is_stale():
        st.rerun()
    store.write_url()
    try:
        world = sources.world_of(store.chosen())
        learned, watched = learning.current(world) if world is not None else (None, None)
        view = sources.view_of(store.chosen(), learned)
        base = sources.view_of(store.without(*LIVE), learned)
        large = compute.is_large(view)
    except InputError as error:
        _refuse(error)
        return
    with turn(needed=large):
        drawn = _pictures(view, feasible.linear(base), watched)
    if drawn and not running:  # what is learned changes under the search
        panels.explain(view)
    if learners.at_work() != running:  # learning began or ended: look oftener, or no more
        st.rerun()


def _refuse(error: InputError) -> None:
    st.error(in_markdown(error))
    st.button("Undo the last change", on_click=store.undo)


def _pictures(view: View, base: View, watched: learners.Watched | None) -> bool:
    """Draw everything of a view except the result of the search for causes; returns whether it could be drawn."""
    try:
        view, coming = feasible.drawn(view)
        compute.study_for(view)
    except InputError as error:
        _refuse(error)
        return False
    store.worked()
    learning.strip(view, watched)
    presets = presets_for(view) if view.world is not None else ()
    told = story.story(store.chosen())
    panels.pictures(view, base, presets=presets, pin=compare.pinning(view), story=told, on_story=story.show,
                    coming=coming)  # fmt: skip
    panels.artefacts(view, coming)
    learning.pictures(view)
    export.footer(view)
    compare.comparison(view)
    bring.editor(view)
    return True


page()
