"""A deadline race: one start, two ways to act, side by side until T; then the same from many starts."""

from __future__ import annotations

import streamlit as st

from app import raced, state
from app.parts import race_field, racing
from app.races import Control, Racing
from laplace_core import InputError


def page() -> None:
    state.open_page("race", raced.LINK)
    with st.sidebar:
        st.html('<div class="brand">Laplace code workbench</div>')
        racing.choose()
        if raced.AGENT not in state.chosen():
            st.info("No trained agent is here yet: train one on the page Train, or open one on Trained agents.")
            return
        try:
            control = raced.control_of(state.chosen())
        except InputError as error:  # a run that was removed meanwhile
            st.error(str(error))
            return
        racing.form(control)
    state.write_url()
    one = racing.begun(control)
    if one.going:
        st.fragment(racing.progress, run_every=racing.LOOK_EVERY)(one, "Racing")
        st.html('<div class="race-room"></div>')  # where the race will be
        return
    if racing.refused(one):
        return
    _view(control, one)
    race_field.section(control)


@st.fragment
def _view(control: Control, one: Racing) -> None:
    """While the cursor moves nothing else is drawn anew."""
    state.write_url()
    racing.show(control, one)


page()
