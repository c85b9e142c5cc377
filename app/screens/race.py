"""A deadline race: one start, two ways to act, side by side until T; then the same from many starts."""

from __future__ import annotations

import streamlit as st

from app.components.waiting import progress, result
from app.race import field, form, schema
from app.race.jobs import Control
from app.session import store
from laplace_core import InputError
from laplace_core.acting.race import Race


def page() -> None:
    store.open_page("race", schema.LINK)
    with st.sidebar:
        st.html('<div class="brand">Laplace code workbench</div>')
        form.choose()
        if schema.AGENT not in store.chosen():
            st.info("No trained agent is here yet: train one on the page Train, or open one on Trained agents.")
            return
        try:
            control = schema.control_of(store.chosen())
        except InputError as error:  # a run that was removed meanwhile
            st.error(str(error))
            return
        form.form(control)
    store.write_url()
    work = form.begun(control)
    if work.going:
        progress(work, *form.RACING)
        st.html('<div class="race-room"></div>')  # where the race will be
        return
    one = result(work)
    if one is not None:
        _view(control, *one)
        field.section(control)


@st.fragment
def _view(control: Control, one: Race, packed: bytes) -> None:
    """While the cursor moves nothing else is drawn anew."""
    store.write_url()
    form.show(control, one, packed)


page()
