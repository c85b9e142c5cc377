"""The tabular workbench: one state of a world, from its gamma-space to the action of every horizon."""

from __future__ import annotations

import streamlit as st

from app import compute, controls, sources, state
from app.parts import bring, compare, export, learning, panels
from app.query import OPENING, read_link
from laplace_core import InputError

LOOK_EVERY = 0.7  # seconds between two looks at a learner


def page() -> None:
    state.load_url("worlds", OPENING, read_link)
    state.settled()
    for note in state.notes():
        st.warning(note)
    with st.sidebar:
        st.html('<div class="brand">Laplace code workbench</div>')
        controls.world_group()
        try:
            world = sources.world_of(state.chosen())
            if world is not None:
                state.drop_missing(world)
            learned, _ = learning.current(world) if world is not None else (None, None)
            view = sources.view_of(state.chosen(), learned)
        except InputError as error:
            st.error(str(error))
            _undo_button()
            st.button("Back to the opening view", on_click=state.go_to, kwargs=OPENING)
            return
        if world is None:
            file = sources.gamma_space_files()[str(state.chosen()["data"])]
            st.caption(f"{file.name}: {len(view.subject.gammas)} discounts, {len(view.subject.thetas)} sensitivities")
            controls.look_group_of_file(file.states, tuple(f"action {a}" for a in range(view.actions)), view.action)
        else:
            controls.look_group(world, view.settings, view.action)
            learning.source_group(world)
        bring.open_group(world)
        grids = st.expander("Discounts, sensitivities, policy", key="learning", on_change="rerun")
        if grids.open:
            with grids:
                controls.grid_group(view.settings, decided="agent" in state.chosen())
        more = st.expander("Noise and acting", key="more", on_change="rerun")
        if more.open:
            with more:
                controls.study_group(view.settings)
        st.button("Reset to the world's own settings", on_click=state.reset, width="stretch")
    running = learning.at_work()
    st.fragment(_view, run_every=LOOK_EVERY if running else None)(running)


def _undo_button() -> None:
    st.button("Undo the last change", on_click=state.undo)


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
        _undo_button()
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
