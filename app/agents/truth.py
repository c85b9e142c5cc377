"""Truth by simulation: a line over the lens that begins it, and under the lens what the lens does not show of it."""

from __future__ import annotations

from functools import lru_cache

import streamlit as st

from app.agents import truth_jobs
from app.agents.episode import AFTER
from app.agents.truth_jobs import COUNT, EACH, EPISODES, STEPS, Simulation
from app.catalogue import rules
from app.components.chart import chart
from app.components.lens import Simulated
from app.session import store
from app.view.subjects import Subject, View
from laplace_core import InputError, figures
from laplace_core.acting.continuations import Outcomes, steps_known
from laplace_core.acting.rollout import Rollout
from laplace_core.acting.simulated_truth import Confronted, confront, confront_states
from laplace_core.environments import vector
from laplace_core.figures.theme import HEIGHT
from laplace_core.training.checkpoint import Loaded

LOOK_EVERY = 0.5  # seconds between two looks at a simulation in the making


def ask(view: View, loaded: Loaded, rollout: Rollout, step: int) -> Simulated | None:
    """The line over the lens: a button, then progress, then what is drawn; returns what the lens draws of it."""
    own = _own(rollout)
    found = truth_jobs.found(loaded, rollout, step, view.action, own=own)
    with st.container(key="truth"):
        shares = [6.4, 1.8] if rollout.of_the_values else [5.2, 2.6, 1.8]
        words, *picker, button = st.columns(shares, vertical_alignment="center", gap="small")
        if picker:
            key, titles = store.show(AFTER, "values"), _titles(rollout)
            picker[0].selectbox(
                "Control of what is simulated", list(titles), key=key, format_func=lambda name: titles.get(name, name),
                label_visibility="collapsed", on_change=store.keep, args=(key,),
                help="Tau-space predicts one policy; under another one, what comes is another process.",
            )  # fmt: skip
        if found is not None and found.going:
            with words:
                st.fragment(_progress, run_every=LOOK_EVERY)(found)
            button.button("Cancel", key="cancel simulation", width="stretch", on_click=found.cancel)
            return None
        words.caption(_told(view, loaded, rollout, step))
        button.button(
            "Simulate", key="simulate", width="stretch", disabled=found is not None, on_click=truth_jobs.begin,
            args=(loaded, rollout, step, view.action), kwargs={"own": own},
            help="Does the decoded timeline come true? Hold it against what really comes.",
        )  # fmt: skip
    if found is None or not vector.chance(loaded.environment):
        return None
    try:
        return truth_jobs.for_lens(found, loaded.agent, view.action)
    except InputError as error:
        st.error(str(error))
        return None


def section(view: View, loaded: Loaded, rollout: Rollout, step: int) -> None:
    """Under the lens, once there is a simulation: its calibration, which follows alpha; of many states, their means."""
    found = truth_jobs.found(loaded, rollout, step, view.action, own=_own(rollout))
    if found is None or found.going:
        return
    try:
        confronted = _confronted(found, loaded, view.subject, view.action, alpha=view.settings.alpha)
    except InputError as error:
        st.error(str(error))
        return
    st.html('<div class="panel-title">does the decoded timeline come true?</div>')
    left, right = st.columns([1, 2], gap="small")
    with left:
        alt = "Predicted against observed probability that a reward exceeds a sensitivity."
        chart(figures.to_json(figures.calibration_plot(confronted)), "calibration", alt, HEIGHT)
    with right:
        if vector.chance(loaded.environment):
            st.caption(_summary(confronted, view))
            return
        alt = "Expected reward, survival and W1 distance over future steps, decoded and simulated, means over states."
        chart(figures.to_json(figures.simulated_timeline(confronted)), "simulated", alt, HEIGHT)


def _own(rollout: Rollout) -> bool:
    return not rollout.of_the_values and store.chosen().get(AFTER) == "rule"


def _titles(rollout: Rollout) -> dict[str, str]:
    rule = rules.title_of(rollout.rule).split(" (")[0].removeprefix("for T: ")
    if rollout.gamma:
        rule = f"greedy at γ {rollout.gamma:.4g}"
    return {"values": f"greedy at γ {rollout.acting_gamma:.4g}", "rule": f"as rolled out: {rule}"}


def _told(view: View, loaded: Loaded, rollout: Rollout, step: int) -> str:
    """What is simulated, or was; then what it says where tau-space predicts something else."""
    own = _own(rollout)
    then = _titles(rollout)["rule" if own else "values"].removeprefix("as rolled out: ")
    if vector.chance(loaded.environment):
        steps = steps_known(loaded.agent, rollout, step, STEPS, own=own)
        limit = "to the deadline" if steps < STEPS else "without a time limit"
        action = view.subject.action_names[view.action]
        words = f"{COUNT} continuations of {steps} steps, {limit}: {action}, then {then}."
    else:
        words = f"{loaded.environment} has no chance in it: what came is all that can come from here. For calibration, "
        words += f"{EACH} states of each of {EPISODES} episodes, {then}."
    if own:
        words += f" Tau-space predicts greedy at γ {rollout.acting_gamma:.4g}: this is another process."
    return words


def _summary(found: Confronted, view: View) -> str:
    return (
        f"Calibration: how often a reward exceeded θ where tau-space says so with some probability, over "
        f"{len(found.reward)} steps and all θ, at α {view.settings.alpha:g}; bars of two standard errors.  \n"
        f"W1, in reward: how far the rewards of a step are from those that tau-space predicts, 0 once it is over; "
        f"{found.distance.mean():.3g} on average over the steps. Grey in the strip beside tau-space: what chance alone "
        f"makes with {found.simulated.count} continuations, {found.simulated.chance.mean():.3g} on average."
    )


def _progress(found: Simulation) -> None:
    if not found.going:
        st.rerun()
    share = found.done / found.of if found.of else 0.0
    st.progress(share, f"Simulating: {found.done} of {found.of}" if found.of else "Simulating: preparing")


@lru_cache(maxsize=16)
def _confronted(found: Simulation, loaded: Loaded, subject: Subject, action: int, *, alpha: float) -> Confronted:
    came = found.result()
    if isinstance(came, Outcomes):
        return confront_states(loaded.agent, came, alpha)
    assert subject.gamma_space is not None  # an agent was observed: there is no world to make one from
    return confront(loaded.agent, subject.gamma_space, action, came, alpha=alpha)
