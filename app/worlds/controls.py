"""Groups of widgets. Each shows the present value and keeps the value that the user sets."""

from __future__ import annotations

from collections.abc import Sequence

import streamlit as st

from app.components.widgets import field, select
from app.session import store
from app.session.typed import in_markdown
from app.worlds import actions, sources
from laplace_core import PRESETS, World
from laplace_core.payloads.link import PARAM
from laplace_core.study.settings import BY_NAME, Resolved
from laplace_core.subjects import state_in
from laplace_core.worlds import parameters_of
from laplace_core.worlds.titles import world_title

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
WORDS = {"shared": "shared: one policy", "per_gamma": "per gamma: one policy for each"}
_MOST_NAMES = 1000


def world_group() -> None:
    """World and its parameters."""
    here = actions.world_name()
    brought = [name for name in sources.BROUGHT if name != sources.DATA or here == sources.DATA]
    select("World", (*sources.WORLDS, *brought), store.show("world", here), world_title, keep=actions.choose_world)
    if here in PRESETS:
        st.caption(PRESETS[here].summary)
    parameters = parameters_of(here)
    long_names = any(len(parameter.name) > 11 for parameter in parameters)
    columns = st.columns(1 if long_names else 2) if parameters else []
    for i, parameter in enumerate(parameters):
        place, key = columns[i % len(columns)], f"{PARAM}{parameter.name}"
        field(parameter, parameter.default, parameter.name, key=key, place=place)


def state_group(world: World, settings: Resolved) -> None:
    """The state looked at; the action is chosen in the lens."""
    if world.n_states <= _MOST_NAMES:
        select("State", world.states, store.show("state", settings.state), help=BY_NAME["state"].help)
        return
    _state_index(world.state_index(state_in(settings)), world.states)
    st.caption(in_markdown(settings.state))


def state_of_file(states: int) -> None:
    """The state looked at in a gamma-space from a file."""
    if states > 1:
        _state_index(int(store.chosen().get("state", 0)), [str(state) for state in range(states)])


def _state_index(index: int, names: Sequence[str]) -> None:
    """The number of a state, of which a link holds the name."""

    def keep() -> None:
        store.choose("state", names[int(st.session_state["state_index"])])

    st.number_input("State", 0, len(names) - 1, key=store.put("state_index", index), on_change=keep)


def grid_group(settings: Resolved, *, decided: bool = False) -> None:
    """Discounts, sensitivities, target policy, length: what is learned.

    ``decided`` leaves out what an agent that learned before has decided.
    """
    if settings.policy is None:  # a file's gamma-space: only the reading is left to choose
        _fields(settings, "acting_gamma")
        _fields(settings, "steps", "time_step")
        return
    if decided:
        st.caption(f"{settings.gammas} discounts, policy {settings.policy}: fixed when the agent learned.")
    else:
        _fields(settings, "policy")
        _fields(settings, "acting_gamma")
        st.caption("Discount grid")
        _fields(settings, "spacing")
        if settings.spacing != "paper":
            _fields(settings, "gammas")
            _fields(settings, "gamma_min", "gamma_max")
    st.caption("Reward sensitivities")
    _fields(settings, "theta_spacing")
    _fields(settings, "thetas")
    _fields(settings, "theta_min", "theta_max")
    st.caption("Timeline")
    _fields(settings, "steps", "time_step")


def _fields(settings: Resolved, *names: str) -> None:
    """One setting, or two side by side."""
    for place, name in zip(st.columns(len(names)), names, strict=True):
        field(BY_NAME[name], getattr(settings, name), _TITLES[name], titles=WORDS, place=place)
