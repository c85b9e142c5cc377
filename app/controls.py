"""Groups of widgets. Each shows what holds now and keeps what the person sets."""

from __future__ import annotations

import math
from typing import Any

import streamlit as st

from app import sources, state, world_actions
from laplace_core import PRESETS, World
from laplace_core.parameters import Parameter
from laplace_core.settings import BY_NAME, Resolved
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
    key = state.show("world", world_actions.world_name())
    here = world_actions.world_name()
    brought = [name for name in sources.BROUGHT if name != sources.DATA or here == sources.DATA]
    st.selectbox(
        "World", (*sources.WORLDS, *brought), key=key, on_change=world_actions.choose_world, format_func=world_title
    )
    if here in PRESETS:
        st.caption(PRESETS[here].summary)
    parameters = parameters_of(here)
    long_names = any(len(parameter.name) > 11 for parameter in parameters)
    columns = st.columns(1 if long_names else 2) if parameters else []
    for i, parameter in enumerate(parameters):
        with columns[i % len(columns)]:
            number(f"p.{parameter.name}", parameter, parameter.default, parameter.name)


def world_title(name: str) -> str:
    if name in sources.TITLES:
        return sources.TITLES[name]
    return PRESETS[name].title if name in PRESETS else name.replace("gym:", "gymnasium ")


def state_group(world: World, settings: Resolved) -> None:
    """The state looked at; the action is chosen in the lens."""
    if world.n_states <= _MOST_NAMES:
        key = state.show("state", settings.state)
        st.selectbox("State", world.states, key=key, on_change=state.keep, args=(key,), help=BY_NAME["state"].help)
        return
    index = world.state_index(sources.state_in(settings))
    state.put("state_index", index)
    st.number_input("State", 0, world.n_states - 1, key="state_index", on_change=_keep_state, args=(world,))
    st.caption(settings.state)


def state_of_file(states: int) -> None:
    """The state looked at in a gamma-space from a file."""
    if states > 1:
        state.put("state_index", int(state.chosen().get("state", 0)))
        st.number_input("State", 0, states - 1, key="state_index", on_change=_keep_index)


def _keep_index() -> None:
    state.choose("state", str(st.session_state["state_index"]))


def _keep_state(world: World) -> None:
    state.choose("state", world.states[int(st.session_state["state_index"])])


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
    key = state.show(name, value)
    st.selectbox(
        _TITLES[name], BY_NAME[name].choices, key=key, on_change=state.keep, args=(key,), help=BY_NAME[name].help,
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


def number(key: str, parameter: Parameter, value: object, label: str) -> None:
    state.show(key, value)
    kept: dict[str, Any] = {"key": key, "on_change": state.keep, "args": (key,), "help": parameter.help}
    if parameter.type is bool:
        st.checkbox(label, **kept)
    elif parameter.choices:
        st.selectbox(label, parameter.choices, **kept)
    elif parameter.type is int:
        low, high = parameter.bounds
        st.number_input(label, int(low), int(high), step=1, **kept)
    else:
        low, high = parameter.bounds
        step = 0.01 if high <= 1 else 0.5
        if parameter.default:  # a small number moves by its last digit
            step = min(step, 10.0 ** math.floor(math.log10(abs(float(parameter.default)))))
        st.number_input(label, float(low), float(high), step=step, format="%g", **kept)
