"""Groups of widgets. Each shows what holds now and keeps what the person sets."""

from __future__ import annotations

import streamlit as st

from app.catalogue.names import world_title
from app.components.widgets import number
from app.session import store
from app.view import subjects
from app.worlds import actions, sources
from laplace_core import PRESETS, World
from laplace_core.study.settings import BY_NAME, Resolved
from laplace_core.worlds import parameters_of

_TITLES = {
    "gammas": "Discounts",
    "spacing": "Spacing",
    "gamma_min": "Smallest gamma",
    "gamma_max": "Largest gamma",
    "thetas": "Sensitivities",
    "theta_spacing": "Spacing",
    "theta_min": "Smallest theta",
    "theta_max": "Largest theta",
    "steps": "Rows K",
    "time_step": "Time step",
    "acting_gamma": "Acting gamma",
    "policy": "Target policy",
}
WORDS = {
    "shared": "shared: one policy",
    "per_gamma": "per gamma: each its own",
}
_MOST_NAMES = 1000


def world_group() -> None:
    """World and its parameters."""
    key = store.show("world", actions.world_name())
    here = actions.world_name()
    brought = [name for name in sources.BROUGHT if name != sources.DATA or here == sources.DATA]
    st.selectbox("World", (*sources.WORLDS, *brought), key=key, on_change=actions.choose_world, format_func=world_title)
    if here in PRESETS:
        st.caption(PRESETS[here].summary)
    parameters = parameters_of(here)
    long_names = any(len(parameter.name) > 11 for parameter in parameters)
    columns = st.columns(1 if long_names else 2) if parameters else []
    for i, parameter in enumerate(parameters):
        with columns[i % len(columns)]:
            number(f"p.{parameter.name}", parameter, parameter.default, parameter.name)


def state_group(world: World, settings: Resolved) -> None:
    """The state looked at; the action is chosen in the lens."""
    if world.n_states <= _MOST_NAMES:
        key = store.show("state", settings.state)
        st.selectbox("State", world.states, key=key, on_change=store.keep, args=(key,), help=BY_NAME["state"].help)
        return
    index = world.state_index(subjects.state_in(settings))
    store.put("state_index", index)
    st.number_input("State", 0, world.n_states - 1, key="state_index", on_change=_keep_state, args=(world,))
    st.caption(settings.state)


def state_of_file(states: int) -> None:
    """The state looked at in a gamma-space from a file."""
    if states > 1:
        store.put("state_index", int(store.chosen().get("state", 0)))
        st.number_input("State", 0, states - 1, key="state_index", on_change=_keep_index)


def _keep_index() -> None:
    store.choose("state", str(st.session_state["state_index"]))


def _keep_state(world: World) -> None:
    store.choose("state", world.states[int(st.session_state["state_index"])])


def grid_group(settings: Resolved, *, decided: bool = False) -> None:
    """Discounts, sensitivities, target policy, length: what is learned.

    ``decided`` leaves out what an agent that learned before has decided.
    """
    if settings.policy is None:  # a file's gamma-space: only the reading is left to choose
        _field("acting_gamma", settings.acting_gamma)
        _pair("steps", "time_step", settings)
        return
    if decided:
        st.caption(f"{settings.gammas} discounts, policy {settings.policy}: decided when the agent learned.")
    else:
        _choice("policy", settings.policy)
        _field("acting_gamma", settings.acting_gamma)
        st.caption("Discount grid")
        _choice("spacing", settings.spacing)
        if settings.spacing != "paper":
            _field("gammas", settings.gammas)
            _pair("gamma_min", "gamma_max", settings)
    st.caption("Reward sensitivities")
    _choice("theta_spacing", settings.theta_spacing)
    _field("thetas", settings.thetas)
    _pair("theta_min", "theta_max", settings)
    st.caption("Timeline")
    _pair("steps", "time_step", settings)


def _choice(name: str, value: str | None) -> None:
    key = store.show(name, value)
    st.selectbox(
        _TITLES[name], BY_NAME[name].choices, key=key, on_change=store.keep, args=(key,), help=BY_NAME[name].help,
        format_func=lambda word: WORDS.get(word, word),
    )  # fmt: skip


def _pair(first: str, second: str, settings: Resolved) -> None:
    left, right = st.columns(2)
    with left:
        _field(first, getattr(settings, first))
    with right:
        _field(second, getattr(settings, second))


def _field(name: str, value: object) -> None:
    number(name, BY_NAME[name], value, _TITLES[name])
