"""The sidebar of the pages that show a world: the subject, and how it was learned."""

from __future__ import annotations

import streamlit as st

from app.session import store
from app.session.typed import in_markdown
from app.view import solver
from app.worlds import actions, bring, controls, learning, sources
from app.worlds.schema import OPENING
from laplace_core import InputError


def groups() -> bool:
    """All groups of controls; False if the settings make no view, and then an error is shown."""
    controls.world_group()
    try:
        world = sources.world_of(store.chosen())
        if world is not None:
            actions.drop_missing(world)
        learned, _ = learning.current(world) if world is not None else (None, None)
        view = sources.view_of(store.chosen(), learned)
    except InputError as error:
        st.error(in_markdown(error))
        st.button("Undo the last change", on_click=store.undo)
        st.button("Back to the opening view", on_click=actions.go_to, kwargs=OPENING)
        return False
    if world is None:
        file = sources.gamma_space_files()[str(store.chosen()["data"])]
        space = view.subject.gamma_space
        if space is not None:
            st.caption(f"{in_markdown(file.name)}: {len(space.gammas)} discounts, {len(space.thetas)} sensitivities")
        controls.state_of_file(file.states)
    else:
        controls.state_group(world, view.settings)
        learning.source_group(world)
    solver.solver_and_rule(view.settings)
    bring.open_group(world)
    noise = st.expander("Noise level, weights, filter", key="assuming", on_change="rerun")
    if noise.open:
        with noise:
            solver.noise_and_weights(view.settings)
            solver.discount_filter(view.settings)
    grids = st.expander("Discounts, sensitivities, policy", key="learning", on_change="rerun")
    if grids.open:
        with grids:
            controls.grid_group(view.settings, decided="agent" in store.chosen())
    st.button("Reset world and settings", on_click=actions.reset, width="stretch")
    return True
