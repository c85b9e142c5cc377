"""The lens: the same view with the inverse in the browser, so that pictures move while a control is dragged."""

from __future__ import annotations

import streamlit as st

from app import compute, sources, state
from app.lens import PRESETS, Released, checked, lens, presets_for, state_of, values_of
from app.parts import learning, sidebar
from laplace_core import InputError


def page() -> None:
    if not sidebar.begin():
        return
    _view()


@st.fragment
def _view() -> None:
    if state.sidebar_is_stale():
        st.rerun()
    state.write_url()
    try:
        world = sources.world_of(state.chosen())
        learned = learning.current(world)[0] if world is not None else None
        view = sources.view_of(state.chosen(), learned)
        found = compute.study_for(view)
        data = compute.lens_payload(view)
    except InputError as error:
        st.error(str(error))
        sidebar.undo_button()
        return
    state.worked()
    horizon = float(found.horizons[compute.row_of(view)])
    shown = state_of(state.chosen(), view.settings, horizon, view.action)

    def heard(released: Released) -> None:
        if released.preset is not None:
            state.go_to(**PRESETS[released.preset])
            return
        changes = values_of(checked(released.state, found), shown, found.action_names)
        for name, value in changes.items():
            state.choose(name, value)

    lens(data, shown, "worlds", shown, presets_for(view) if view.world is not None else (), heard)


page()
