"""Trained agents: what one has learned for an observation, through the same decode, reading and drawing as a world."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import streamlit as st

from app import checkpoints, compute, controls, state
from app.observations import Scene, scene_of
from app.parts import export, panels
from app.query import VIEW
from app.sources import View
from laplace_core import InputError, Settings
from laplace_core.parameters import Parameter
from laplace_core.settings import BY_NAME, ENCODING_NAMES, resolve_for_gamma_space
from laplace_core.training.checkpoint import Loaded

OBSERVED = "o."  # prefix of the components of an observation
# A network's gamma-space is known to a hundredth or so: less regularisation shows its error and not its timeline.
DEFAULTS = {"alpha": 1.0}
_READING = {name: parameter for name, parameter in BY_NAME.items() if name not in ENCODING_NAMES}
_LOOKING = {parameter.name: parameter for parameter in VIEW if parameter.name in ("action", "horizon", "look")}


def opening() -> dict[str, object]:
    return {"checkpoint": checkpoints.shipped()[0]} if checkpoints.shipped() else {}


def parse_query(query: Mapping[str, str]) -> tuple[dict[str, object], list[str]]:
    """State and notes from URL values."""
    found, notes = dict(opening()), []
    try:
        if "checkpoint" in query:
            checkpoints.checkpoint(query["checkpoint"])
            found["checkpoint"] = query["checkpoint"]
    except InputError as error:
        return found, [f"Left out of the link: {error}"]
    if "checkpoint" not in found:
        return {}, []
    scene = scene_of(checkpoints.checkpoint(str(found["checkpoint"])).environment)
    known = {**_READING, **_LOOKING}
    known |= {
        f"{OBSERVED}{i}": Parameter(component.name, component.start, component.low, component.high, "", float)
        for i, component in enumerate(scene.components)
    }
    known["state"] = Parameter("state", None, 0, 0, "State that is observed.", str, scene.states)
    for name, text in query.items():
        if name == "checkpoint":
            continue
        if name not in known:
            notes.append(f"The link has an entry {name[:40]!r} that means nothing here.")
            continue
        try:
            found[name] = known[name].parse(text)
        except InputError as error:
            notes.append(f"Left out of the link: {error}")
    return found, notes


def page() -> None:
    state.load_url("agents", opening(), parse_query)
    state.settled()
    for note in state.notes():
        st.warning(note)
    with st.sidebar:
        st.html('<div class="brand">Laplace code workbench</div>')
        _choose()
        name = state.chosen().get("checkpoint")
        if name is None:
            st.info("No trained agent is here yet: open a checkpoint, or train one with `laplace train`.")
            return
        loaded = checkpoints.checkpoint(str(name))
        scene = scene_of(loaded.environment)
        _card(loaded, scene)
        _observation(scene)
        action = _action(scene)
        st.session_state["action"] = scene.actions[action]
        st.selectbox("Action", scene.actions, key="action", on_change=state.keep, args=("action",))
    _view(loaded, scene)


def _choose() -> None:
    names = (*checkpoints.shipped(), *checkpoints.opened())
    if names:
        key = state.show("checkpoint", names[0])
        st.selectbox("Agent", names, key=key, on_change=_chosen, format_func=_title)
    st.file_uploader("Open a checkpoint (.safetensors)", type=["safetensors"], key="agent_file", on_change=_uploaded)
    if "_agent_refused" in st.session_state:
        st.error(st.session_state["_agent_refused"])


def _title(name: str) -> str:
    return "opened file" if name in checkpoints.opened() else name.replace("_", " ")


def _chosen() -> None:
    state.replace_all({"checkpoint": st.session_state["checkpoint"]})


def _uploaded() -> None:
    st.session_state.pop("_agent_refused", None)
    file = st.session_state["agent_file"]
    if file is None:
        return
    try:
        state.replace_all({"checkpoint": checkpoints.open_checkpoint(file.name, file.getvalue())})
    except InputError as error:
        st.session_state["_agent_refused"] = str(error)


def _card(loaded: Loaded, scene: Scene) -> None:
    settings = loaded.settings
    score = "not evaluated" if loaded.score is None else f"{loaded.score:.1f} over {loaded.episodes} episodes"
    st.caption(scene.title)
    st.caption(
        f"{loaded.algorithm}, seed {loaded.seed}, {loaded.step:,} steps; return {score}. "
        f"{len(loaded.agent.gammas)} discounts to {settings.gamma_max:g}, {len(loaded.agent.thetas)} sensitivities, "
        f"{settings.network}, {settings.parametrisation}."
    )


def _observation(scene: Scene) -> None:
    if scene.states:
        key = state.show("state", scene.states[0])
        st.selectbox("State", scene.states, key=key, on_change=state.keep, args=(key,))
        return
    for i, component in enumerate(scene.components):
        key = state.show(f"{OBSERVED}{i}", component.start)
        unit = f" ({component.unit})" if component.unit else ""
        step = (component.high - component.low) / 100.0
        st.slider(f"{component.name}{unit}", component.low, component.high, step=step, key=key, format="%.2f",
                  on_change=state.keep, args=(key,))  # fmt: skip


def _action(scene: Scene) -> int:
    name = state.chosen().get("action")
    return scene.actions.index(name) if name in scene.actions else 0


def observation_of(scene: Scene, values: Mapping[str, object]) -> tuple[float, ...]:
    """The observation that the values describe; a tabular state is a one-hot vector."""
    if scene.states:
        at = scene.states.index(str(values.get("state", scene.states[0])))
        return tuple(np.eye(len(scene.states))[at])
    return tuple(float(values.get(f"{OBSERVED}{i}", part.start)) for i, part in enumerate(scene.components))


def view_of(loaded: Loaded, scene: Scene, values: Mapping[str, object]) -> View:
    """What the page shows.

    Raises:
        InputError: values that do not fit each other.
    """
    subject = checkpoints.observe(loaded, observation_of(scene, values), scene.actions)
    given = {name: value for name, value in values.items() if name in _READING and name != "state"}
    settings = resolve_for_gamma_space(Settings(world=loaded.environment, **(DEFAULTS | given)), loaded.agent.gammas)
    return View(subject, settings, _action(scene), values.get("horizon"))


@st.fragment
def _view(loaded: Loaded, scene: Scene) -> None:
    state.write_url()
    try:
        view = view_of(loaded, scene, state.chosen())
        found = compute.study_for(view)
    except InputError as error:
        st.error(str(error))
        return
    above = st.container()
    panels.panels(view)
    with above:
        panels.verdict(view)
    controls.live_group(found, float(found.horizons[compute.row_of(view)]))
    export.agent_footer(view)


page()
