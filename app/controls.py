"""Groups of widgets. Each shows what holds now and keeps what the person sets."""

from __future__ import annotations

import numpy as np
import streamlit as st

from app import sources, state
from laplace_core import PRESETS, Settings, Study, World
from laplace_core.parameters import Parameter
from laplace_core.settings import BY_NAME
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
    "normalise": "Row normalisation",
    "alpha": "alpha, regularisation",
    "slope": "slope (1/reward)",
    "softness": "softness of the deadline",
    "noise": "noise in gamma-space",
    "noise_seed": "Seed of the noise",
    "deadline": "Acting with",
}
WORDS = {
    "none": "none: keep survival",
    "survival": "by survival",
    "paper": "paper: every row to 1",
    "shared": "shared: one policy",
    "per_gamma": "per gamma: each its own",
    "time_to_go": "the time to go",
    "constant": "constant T at every step",
}
_MOST_NAMES = 1000


def world_group() -> None:
    """World and its parameters."""
    key = state.show("world", state.world_name())
    here = state.world_name()
    brought = [name for name in sources.BROUGHT if name != sources.DATA or here == sources.DATA]
    st.selectbox("World", (*sources.WORLDS, *brought), key=key, on_change=state.choose_world, format_func=world_title)
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


def look_group(world: World, settings: Settings, action: int) -> None:
    """State and action looked at."""
    if world.n_states <= _MOST_NAMES:
        key = state.show("state", settings.state)
        st.selectbox("State", world.states, key=key, on_change=state.keep, args=(key,), help=BY_NAME["state"].help)
    else:
        index = world.state_index(settings.state)
        state.put("state_index", index)
        st.number_input("State", 0, world.n_states - 1, key="state_index", on_change=_keep_state, args=(world,))
        st.caption(settings.state)
    _action(world.actions, action)


def look_group_of_file(states: int, names: tuple[str, ...], action: int) -> None:
    """State and action of a gamma-space from a file."""
    if states > 1:
        state.put("state_index", int(state.chosen().get("state", 0)))
        st.number_input("State", 0, states - 1, key="state_index", on_change=_keep_index)
    _action(names, action)


def _keep_index() -> None:
    state.choose("state", str(st.session_state["state_index"]))


def _action(names: tuple[str, ...], action: int) -> None:
    state.put("action", names[action])
    help_ = "Action whose spaces are shown."
    st.selectbox("Action", names, key="action", on_change=state.keep, args=("action",), help=help_)


def _keep_state(world: World) -> None:
    state.choose("state", world.states[int(st.session_state["state_index"])])


def grid_group(settings: Settings, decided: bool = False) -> None:
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


def live_group(found: Study, horizon: float) -> None:
    """The controls that move the picture, right under it."""
    settings = found.settings
    first, second, third, fourth, fifth = st.columns([1, 1, 1, 1, 1.1], gap="medium")
    with first:
        _logarithmic("alpha", settings.alpha, 1e-6, 10.0)
    with second:
        if settings.slope is None:  # a file's gamma-space: its slope was chosen where it was learned
            _noise(settings)
        else:
            _logarithmic("slope", settings.slope, min(0.1, settings.slope), max(1000.0, settings.slope))
    with third:
        _horizon(found, horizon)
    with fourth:
        key = state.show("softness", settings.softness)
        high = max(1.0, settings.softness)
        st.slider(
            _TITLES[key], 0.0, high, step=0.05, key=key, on_change=state.keep, args=(key,), help=BY_NAME[key].help
        )
    with fifth:
        _choice("normalise", settings.normalise)


def study_group(settings: Settings) -> None:
    """What is added to or done with a gamma-space, beside the inverse."""
    _noise(settings)
    if settings.noise:
        _field("noise_seed", settings.noise_seed)
    if settings.policy is not None:
        _choice("deadline", settings.deadline)


def _noise(settings: Settings) -> None:
    stops = sorted({0.0, settings.noise, *(float(f"{stop:.1g}") for stop in np.geomspace(1e-7, 1e-1, 19))})
    key = state.show("noise", settings.noise)
    st.select_slider(
        _TITLES[key], stops, key=key, on_change=state.keep, args=(key,), help=BY_NAME[key].help, format_func=_short
    )


def _horizon(found: Study, horizon: float) -> None:
    key = "horizon"
    state.put(key, horizon)  # the nearest that exists: a shorter world may not reach what was asked for
    step, last = found.settings.time_step, float(found.horizons[-1])
    shown = "%d" if step == 1 else "%.3g"
    if len(found.horizons) == 1:
        st.slider("horizon T", 0.0, last, key=key, disabled=True, format=shown)
        return
    st.slider(
        "horizon T (steps)", float(found.horizons[0]), last, step=float(step), key=key, format=shown,
        on_change=state.keep, args=(key,), help="Deadline T, in steps of the world.",
    )  # fmt: skip


def _logarithmic(name: str, value: float, low: float, high: float) -> None:
    """A slider over a logarithmic scale of two significant digits; a value from elsewhere joins the scale."""
    stops = {float(f"{stop:.2g}") for stop in np.geomspace(low, high, int(20 * np.log10(high / low)) + 1)}
    extra = st.session_state.setdefault(f"_stops_{name}", set())
    extra.add(value)
    options = sorted(stops | extra)
    key = state.show(name, value)
    st.select_slider(
        _TITLES[name], options, key=key, on_change=state.keep, args=(key,), help=BY_NAME[name].help, format_func=_short
    )


def _short(value: float) -> str:
    return f"{value:g}"


def _choice(name: str, value: str) -> None:
    key = state.show(name, value)
    st.selectbox(
        _TITLES[name], BY_NAME[name].choices, key=key, on_change=state.keep, args=(key,), help=BY_NAME[name].help,
        format_func=lambda word: WORDS.get(word, word),
    )  # fmt: skip


def _pair(first: str, second: str, settings: Settings) -> None:
    left, right = st.columns(2)
    with left:
        _field(first, getattr(settings, first))
    with right:
        _field(second, getattr(settings, second))


def _field(name: str, value: object) -> None:
    number(name, BY_NAME[name], value, _TITLES[name])


def number(key: str, parameter: Parameter, value: object, label: str) -> None:
    state.show(key, value)
    kept = {"key": key, "on_change": state.keep, "args": (key,), "help": parameter.help}
    if parameter.type is bool:
        st.checkbox(label, **kept)
    elif parameter.choices:
        st.selectbox(label, parameter.choices, **kept)
    elif parameter.type is int:
        st.number_input(label, int(parameter.low), int(parameter.high), step=1, **kept)
    else:
        step = 0.01 if parameter.high <= 1 else 0.5
        if parameter.default:  # a small number moves by its last digit
            step = min(step, float(f"1e{int(np.floor(np.log10(abs(parameter.default))))}"))
        st.number_input(label, float(parameter.low), float(parameter.high), step=step, format="%g", **kept)
