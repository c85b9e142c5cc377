"""The lens on a page of its own: ``streamlit run tests/browser/lens_demo.py``, any link of the workbench behind it."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import streamlit as st

from app.components.lens import Released, lens
from app.worlds.presets import presets_for
from app.worlds.schema import LINK
from app.worlds.sources import view_of
from laplace_core import World, study
from laplace_core.payloads.lens import payload, structure
from laplace_core.payloads.state import checked, state_of
from laplace_core.study.settings import Resolved


@st.cache_resource(max_entries=4)
def packed(_world: World, settings: Resolved) -> bytes:
    return payload(study(_world, settings))[0]


st.set_page_config(layout="wide")
values = LINK.read(dict(st.query_params))[0]
view = view_of(values)
assert view.world is not None  # its links show worlds
found = study(view.world, view.settings)
horizon = view.settings.horizon or float(found.horizons[-1])
opening = state_of(view.settings, horizon, action=view.action)
state = st.session_state.setdefault("state", opening)
st.session_state["runs"] = st.session_state.get("runs", 0) + 1


def heard(released: Released) -> None:
    st.session_state["state"] = checked(released.state, found)
    st.session_state["asked"] = released.preset


data = packed(view.world, structure(view.settings, view.world))
if st.toggle("show the lens", value=True):
    lens(data, state, "demo", base=opening, presets=presets_for(view), on_release=heard)
if st.button("alpha 0.001 from Python"):
    st.session_state["state"] = {**state, "alpha": 0.001}
    st.rerun()
asked = f", asks for {st.session_state['asked']}" if st.session_state.get("asked") else ""
st.text(f"runs {st.session_state['runs']}, alpha {state['alpha']:g}, T {state['horizon']:g}{asked}")
