"""A deadline race: one start, two ways to act, side by side until T; then the same from many starts."""

from __future__ import annotations

import streamlit as st

from app.catalogue import checkpoints
from app.components.waiting import attempt
from app.components.widgets import left_out
from app.race import field, form, schema
from app.session import store
from app.view import explain
from laplace_core.acting.race import Race
from laplace_core.trained.races import Control


def page() -> None:
    store.open_page("race", schema.LINK)
    with st.sidebar:
        form.choose()
        left_out(checkpoints.left_out())
        if schema.AGENT not in store.chosen():
            st.info("No trained agent is here yet: train one on the page Train, or open one on Trained agents.")
            return
        control = attempt(lambda: schema.control_of(store.chosen()))
        if control is None:  # a run that was removed meanwhile
            return
        form.form(control)
    explain.guide("race")
    store.write_url()
    one = form.raced(control)
    if one is not None:
        _view(control, *one)
    field.section(control)


@st.fragment
def _view(control: Control, one: Race, packed: bytes) -> None:
    """A fragment: while the cursor moves, nothing else is redrawn."""
    store.write_url()
    form.show(control, one, packed)


page()
