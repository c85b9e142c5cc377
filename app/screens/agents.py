"""Trained agents: an agent's gamma-space for an observation, decoded, read and drawn in the same way as a world's."""

from __future__ import annotations

import streamlit as st

from app.agents import peer, returns, rollout_form, truth
from app.agents.card import card
from app.agents.jobs import Rolling
from app.agents.schema import LINK
from app.catalogue import checkpoints
from app.components.waiting import attempt
from app.components.widgets import left_out, select, upload
from app.session import store
from app.session.typed import in_markdown
from app.view import compute, explain, export, feasible, panels, solver
from laplace_core import InputError
from laplace_core.agents.capabilities import HasGammaSpace
from laplace_core.environments import Environment, environment_of
from laplace_core.payloads.state import LIVE
from laplace_core.trained import rollouts
from laplace_core.trained.observations import OBSERVED, observation_of, settings_of, view_of
from laplace_core.training.checkpoint import Loaded


def page() -> None:
    store.open_page("agents", LINK)
    with st.sidebar:
        _choose()
        left_out(checkpoints.left_out())
        name = store.chosen().get("checkpoint")
        if name is None:
            st.info("No trained agent is here yet: open a checkpoint, or train one with `laplace train`.")
            return
        loaded = attempt(lambda: checkpoints.checkpoint(str(name)))
        if loaded is None:  # a run that was removed meanwhile
            return
        scene = environment_of(loaded.environment)
        card(str(name), loaded, scene)
        wish = rollout_form.asked(loaded)
        rolling = None if wish is None else wish.look()
        rollout_form.form(loaded)
        if wish is None:
            _observation(scene)
        else:
            rollout_form.beside(rolling, scene)
        if isinstance(loaded.agent, HasGammaSpace):
            _inverse(loaded)
    explain.guide("agents")
    above = st.container()  # whether or not there is something in it, the lens keeps its place
    if wish is not None and (rolling is None or rolling.going):
        with above:
            rollout_form.under_way(wish, rolling)
        rolling = None  # until it is done, the pictures stay as they are
    _view(loaded, scene, rolling)


def _choose() -> None:
    names = checkpoints.names()
    if names:
        select("Agent", names, store.show("checkpoint", names[0]), checkpoints.title, keep=store.begin_anew)
    upload("Open a checkpoint (.safetensors)", ["safetensors", "json", "npz"], "agent_file", _opened)


def _opened(name: str, data: bytes) -> None:
    store.replace_all({"checkpoint": checkpoints.open_checkpoint(name, data)})


def _observation(scene: Environment) -> None:
    if scene.states:
        select("State", scene.states, store.show("state", scene.states[0]))
        return
    for i, component in enumerate(scene.components):
        key = store.show(f"{OBSERVED}{i}", component.start)
        unit = f" ({component.unit})" if component.unit else ""
        step = (component.high - component.low) / 100.0
        st.slider(f"{component.name}{unit}", component.low, component.high, step=step, key=key, format="%.2f",
                  on_change=store.keep, args=(key,))  # fmt: skip


def _inverse(loaded: Loaded) -> None:
    settings = attempt(lambda: settings_of(loaded, store.chosen()))
    if settings is None:
        return
    solver.solver_and_rule(settings)
    box = st.expander("Noise level, weights, filter", key="assuming", on_change="rerun")
    if box.open:
        with box:
            solver.noise_and_weights(settings)
            solver.discount_filter(settings)


@st.fragment
def _view(loaded: Loaded, scene: Environment, rolling: Rolling | None) -> None:
    if store.sidebar_is_stale():
        st.rerun()
    store.write_url()
    rolled = None if rolling is None else attempt(rolling.result)
    if rolling is not None and rolled is None:
        return
    if rolled is not None:
        store.clamp(rollouts.AT, len(rolled.rollout) - 1)
    if not isinstance(loaded.agent, HasGammaSpace):
        peer.view(loaded, scene, rolled)
        return
    rollout, values, simulated, at = None, dict(store.chosen()), None, 0
    observation, follows = observation_of(scene, values), rolled is not None and "action" not in values
    if rolled is not None:
        rollout, at = rolled.rollout, rollouts.step_of(values, rolled.rollout)
        observation = rollouts.observation_at(rollout, at)
        if follows:
            values["action"] = scene.actions[rollout.actions[at]]
    above = st.container()
    try:
        view = view_of(loaded, scene, values, observation)
        base = feasible.linear(view_of(loaded, scene, store.without(*LIVE), observation))
        with above:
            view, coming = feasible.drawn(view)
        compute.study_for(view)
    except InputError as error:
        st.error(in_markdown(error))
        return
    lead = followed = None
    if rolled is not None and rollout is not None:
        lead, followed = rollout_form.lead(rolled, at), rollouts.followed(rollout, at)
        with above:
            rollout_form.show(rolled, scene, view)
            simulated = truth.ask(view, loaded, rollout, at)
    panels.pictures(view, base, lead=lead, followed=followed, simulated=simulated, follows=follows,
                    coming=coming)  # fmt: skip
    if rollout is not None:
        truth.section(view, loaded, rollout, at)
    name, alpha = view.subject.action_names[view.action], compute.study_for(view).settings.alpha
    returns.section(loaded, observation, view.action, name, alpha=alpha, rollout=rollout, step=at)
    panels.artefacts(view, coming)
    export.agent_footer(view)


page()
