"""The tabular workbench: one state of a world, from its gamma-space to the action of every horizon."""

from __future__ import annotations

import streamlit as st

from app import compute, controls, sources, state
from app.parts import bring, compare, export, learning, panels, sidebar
from laplace_core import InputError

LOOK_EVERY = 0.7  # seconds between two looks at a learner


def page() -> None:
    if not sidebar.begin():
        return
    running = learning.at_work()
    st.fragment(_view, run_every=LOOK_EVERY if running else None)(running)


def _view(running: bool) -> None:
    """The main area. Its own controls rerun only this, and leave the sidebar alone."""
    if state.sidebar_is_stale():
        st.rerun()
    state.write_url()
    try:
        world = sources.world_of(state.chosen())
        learned, watched = learning.current(world) if world is not None else (None, None)
        view = sources.view_of(state.chosen(), learned)
        found = compute.study_for(view)
    except InputError as error:
        st.error(str(error))
        sidebar.undo_button()
        return
    state.worked()
    above = st.container()
    panels.panels(view)  # first, so that the pictures move before the words
    with above:
        panels.verdict(view)
        learning.strip(view, watched)
    controls.live_group(found, float(found.horizons[compute.row_of(view)]))
    learning.pictures(view)
    export.footer(view)
    compare.comparison(view)
    bring.editor(view)
    if learning.at_work() != running:  # learning began or ended: look oftener, or no more
        st.rerun()


page()
