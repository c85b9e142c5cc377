"""The sidebar of the page Inverse: the subject, its noise, the solver, the rule for alpha and the grid."""

from __future__ import annotations

import streamlit as st

from app.components.widgets import field, left_out, select, upload
from app.inverse import measured, subjects
from app.session import store
from app.session.typed import in_markdown
from app.view import solver
from laplace_core import World
from laplace_core.payloads.link import PARAM
from laplace_core.study.settings import BY_NAME, Resolved, ResolvedForWorld
from laplace_core.subjects import View
from laplace_core.worlds import parameters_of
from laplace_core.worlds.titles import world_title

_OF_SUBJECT = ("world", "agent", "data", "state", "action", "alpha", "horizon", "gammas", "spacing", "gamma_min",
               "gamma_max", "thetas", "steps")  # fmt: skip
"""Entries that another subject does not take over; its noise and solver it does."""
_FILE = "gamma_space_file"
POLICIES = {"shared": "shared: one policy", "per_gamma": "per gamma: one policy for each"}


def subject() -> bool:
    """The controls of the subject; False while there is none."""
    kinds = list(subjects.KINDS)
    asked = st.session_state.get("kind") == "data"  # a file that is still to be opened
    here = "data" if asked else subjects.kind_of(store.chosen())
    st.segmented_control(
        "Subject", kinds, format_func=subjects.KINDS.__getitem__, key=store.put("kind", here), on_change=_other_kind,
        width="stretch", required=True,
    )  # fmt: skip
    if here == "agent":
        from app.catalogue import checkpoints  # it brings the network library along, which no world needs

        left_out(checkpoints.left_out())
        if not subjects.agents():
            return False
        select("Agent", subjects.agents(), store.show("agent", subjects.agents()[0]), checkpoints.title, keep=_look_at)
        st.caption("The values that this agent has learned for the start state.")
    elif here == "data":
        upload("Open a gamma-space (.npz)", ["npz"], _FILE, _opened, anywhere=True)
        return "data" in store.chosen()
    else:
        name = store.show("world", subjects.OPENING["world"])
        select("World", subjects.WORLDS, name, world_title, keep=_look_at)
        parameters = parameters_of(str(st.session_state[name]))
        columns = st.columns(2) if parameters else []
        for i, parameter in enumerate(parameters):
            place, key = columns[i % 2], f"{PARAM}{parameter.name}"
            field(parameter, parameter.default, parameter.name, key=key, place=place)
    return True


def _other_kind() -> None:
    kind = st.session_state["kind"]
    if kind == "agent" and subjects.agents():
        _go_to(agent=subjects.agents()[0])
    elif kind == "world":
        _go_to(world=subjects.OPENING["world"])


def _look_at(key: str) -> None:
    """Callback of a box with worlds or agents."""
    _go_to(**{key: st.session_state[key]})


def _opened(name: str, data: bytes) -> None:
    _go_to(data=subjects.open_file(name, data))


def _go_to(**values: object) -> None:
    """Change the subject: noise, solver and rule stay, unless alpha was set by hand."""
    kept = {name: value for name, value in store.chosen().items()
            if name not in _OF_SUBJECT and not name.startswith(PARAM)}  # fmt: skip
    store.replace_all(kept | values)


def settings(view: View, world: World | None) -> None:
    """State, action, noise, solver, rule and grid."""
    s = view.settings
    if world is not None and len(world.states) <= 1000:
        select("State", world.states, store.show("state", s.state), help=BY_NAME["state"].help)
    names = view.subject.action_names
    select("Action", names, store.show("action", names[view.action]), help="Action whose timeline is shown.")
    measures = world is not None and isinstance(s, ResolvedForWorld) and measured.controls(store.chosen(), world, s)
    if not measures:
        left, right = st.columns(2)
        field(BY_NAME["noise"], s.noise, "Noise", place=left)
        field(BY_NAME["noise_seed"], s.noise_seed, "Seed", place=right)
    solver.solver_and_rule(s)
    with st.expander("Noise level, discounts, sensitivities"):
        _more(s)
    st.button("Reset", on_click=_reset, width="stretch")


def _more(s: Resolved) -> None:
    solver.noise_and_weights(s)
    if s.policy is None:
        field(BY_NAME["steps"], s.steps, "Rows K")
        return
    field(BY_NAME["policy"], s.policy, "Target policy", titles=POLICIES)
    field(BY_NAME["spacing"], s.spacing, "Spacing of the discounts")
    if s.spacing != "paper":
        field(BY_NAME["gammas"], s.gammas, "Discounts")
        left, right = st.columns(2)
        field(BY_NAME["gamma_min"], s.gamma_min, "Smallest", place=left)
        field(BY_NAME["gamma_max"], s.gamma_max, "Largest", place=right)
    left, right = st.columns(2)
    field(BY_NAME["thetas"], s.thetas, "Sensitivities", place=left)
    field(BY_NAME["steps"], s.steps, "Rows K", place=right)


def _reset() -> None:
    kind = subjects.kind_of(store.chosen())
    name = store.chosen().get(kind, subjects.OPENING["world"])
    store.replace_all({kind: name})


def refused(sentence: str) -> None:
    """The error of settings that make no view, with a button to go back."""
    st.error(in_markdown(sentence))
    st.button("Undo the last change", on_click=store.undo)
