"""The tabular workbench: one state of a world, from its gamma-space to the action of every horizon."""

from __future__ import annotations

import streamlit as st

from app import compute, sources, state
from app.lens import LIVE, presets_for
from app.parts import bring, compare, export, learning, panels, sidebar
from laplace_core import InputError

LOOK_EVERY = 0.7  # seconds between two looks at a learner


def page() -> None:
    if not sidebar.begin():
        return
    running = learning.at_work()
    st.fragment(_view, run_every=LOOK_EVERY if running else None)(running=running)


def _view(*, running: bool) -> None:
    """The main area. Its own controls rerun only this, and leave the sidebar alone."""
    if state.sidebar_is_stale():
        st.rerun()
    state.write_url()
    try:
        world = sources.world_of(state.chosen())
        learned, watched = learning.current(world) if world is not None else (None, None)
        view = sources.view_of(state.chosen(), learned)
        base = sources.view_of(state.without(*LIVE), learned)
        compute.study_for(view)
    except InputError as error:
        st.error(str(error))
        sidebar.undo_button()
        return
    state.worked()
    learning.strip(view, watched)
    panels.pictures(view, base, presets=presets_for(view) if view.world is not None else ())
    panels.artefacts(view)
    learning.pictures(view)
    export.footer(view)
    compare.comparison(view)
    bring.editor(view)
    if not running:  # what is learned changes under the search
        panels.explain(view)
    if learning.at_work() != running:  # learning began or ended: look oftener, or no more
        st.rerun()


page()
