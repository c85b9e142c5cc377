"""Trained agents: what one has learned for an observation, through the same decode, reading and drawing as a world."""

from __future__ import annotations

from typing import Any

import streamlit as st

from app import session
from app.agents import episode, peer, returns, rollout_form, truth
from app.agents.card import card
from app.agents.rollout_jobs import Rolling
from app.agents.schema import LINK, OBSERVED, observation_of, view_of
from app.catalogue import checkpoints
from app.catalogue.scenes import Scene, scene_of
from app.components.lens import LIVE
from app.session import store
from app.view import compute, export, panels
from laplace_core import InputError
from laplace_core.acting.rollout import Rollout
from laplace_core.agents.capabilities import HasGammaSpace
from laplace_core.training.checkpoint import Loaded


def page() -> None:
    store.open_page("agents", LINK)
    with st.sidebar:
        st.html('<div class="brand">Laplace code workbench</div>')
        _choose()
        name = store.chosen().get("checkpoint")
        if name is None:
            st.info("No trained agent is here yet: open a checkpoint, or train one with `laplace train`.")
            return
        try:
            loaded = checkpoints.checkpoint(str(name))
        except InputError as error:  # a run that was removed meanwhile
            st.error(str(error))
            return
        scene = scene_of(loaded.environment)
        card(str(name), loaded, scene)
        asked = rollout_form.asked(loaded)
        rollout_form.form(loaded)
        if asked is not None:
            rollout_form.beside(asked, scene)
        if asked is None:
            _observation(scene)
    above = st.container()  # whether or not there is something in it, the lens keeps its place
    if asked is not None and asked.going:
        with above:
            st.fragment(rollout_form.progress, run_every=rollout_form.LOOK_EVERY)(asked)
        asked = None  # until it is done, the pictures stay as they are
    _view(loaded, scene, asked)


def _choose() -> None:
    names = checkpoints.names()
    if names:
        key = store.show("checkpoint", names[0])
        st.selectbox("Agent", names, key=key, on_change=_chosen, format_func=checkpoints.title)
    st.file_uploader("Open a checkpoint (.safetensors)", type=["safetensors"], key="agent_file", on_change=_uploaded)
    if "agent_file" in session.current().refusals:
        st.error(session.current().refusals["agent_file"])


def _chosen() -> None:
    store.replace_all({"checkpoint": st.session_state["checkpoint"]})


def _uploaded() -> None:
    session.current().refusals.pop("agent_file", None)
    file = st.session_state["agent_file"]
    if file is None:
        return
    try:
        store.replace_all({"checkpoint": checkpoints.open_checkpoint(file.name, file.getvalue())})
    except InputError as error:
        session.current().refusals["agent_file"] = str(error)


def _observation(scene: Scene) -> None:
    if scene.states:
        key = store.show("state", scene.states[0])
        st.selectbox("State", scene.states, key=key, on_change=store.keep, args=(key,))
        return
    for i, component in enumerate(scene.components):
        key = store.show(f"{OBSERVED}{i}", component.start)
        unit = f" ({component.unit})" if component.unit else ""
        step = (component.high - component.low) / 100.0
        st.slider(f"{component.name}{unit}", component.low, component.high, step=step, key=key, format="%.2f",
                  on_change=store.keep, args=(key,))  # fmt: skip


@st.fragment
def _view(loaded: Loaded, scene: Scene, asked: Rolling | None) -> None:
    store.write_url()
    if not isinstance(loaded.agent, HasGammaSpace):
        peer.view(loaded, scene, asked)
        return
    observation, simulated, at, above = None, None, 0, st.container()
    rollout: Rollout | None = None
    lead: dict[str, Any] | None = None
    followed: dict[str, Any] | None = None
    try:
        if asked is not None:
            rollout = asked.rollout()
            at = episode.step_of(store.chosen(), rollout)
            observation = episode.observation_at(rollout, at)
            lead, followed = rollout_form.lead(asked, at), episode.followed(rollout, at)
        view = view_of(loaded, scene, store.chosen(), observation)
        base = view_of(loaded, scene, store.without(*LIVE), observation)
        compute.study_for(view)
    except InputError as error:
        st.error(str(error))
        return
    if asked is not None and rollout is not None:
        with above:
            rollout_form.show(asked, scene, view)
            simulated = truth.ask(view, loaded, rollout, at)
    panels.pictures(view, base, lead=lead, followed=followed, simulated=simulated)
    if rollout is not None:
        truth.section(view, loaded, rollout, at)
    seen = observation or observation_of(scene, store.chosen())
    name = view.subject.action_names[view.action]
    returns.section(loaded, seen, view.action, name, alpha=view.settings.alpha, rollout=rollout, step=at)
    panels.artefacts(view)
    export.agent_footer(view)


page()
