"""Truth by simulation: a row over the lens that begins it, and under the lens what the lens does not show of it."""

from __future__ import annotations

import streamlit as st

from app.agents import jobs
from app.agents.episode import AFTER
from app.agents.jobs import COUNT, EACH, EPISODES, STEPS
from app.components.chart import chart
from app.components.waiting import attempt, offer, progress
from app.components.widgets import select
from app.session import store
from laplace_core import figures
from laplace_core.acting.continuations import Continuations, Outcomes, steps_known
from laplace_core.acting.rollout import Rollout
from laplace_core.acting.rules import title_of
from laplace_core.acting.simulated_truth import Confronted, confront, confront_states, empirical
from laplace_core.agents.agent import Agent
from laplace_core.caching import cached
from laplace_core.environments import vector
from laplace_core.payloads.lens import Simulated
from laplace_core.subjects import Subject, View
from laplace_core.training.checkpoint import Loaded

_HELP = "Compare the decoded timeline with simulated continuations."


def ask(view: View, loaded: Loaded, rollout: Rollout, step: int) -> Simulated | None:
    """The row over the lens: a button, then progress, then what is drawn; returns what the lens draws of it."""
    own = _own(rollout)
    wish = jobs.truth(loaded, rollout, step, view.action, own=own)
    job = wish.look()
    with st.container(key="truth"):
        shares = [6.4, 1.8] if rollout.of_the_values else [5.2, 2.6, 1.8]
        words, *picker, button = st.columns(shares, vertical_alignment="center", gap="small")
        if picker:
            titles, key, label = _titles(rollout), store.show(AFTER, "values"), "Control of what is simulated"
            place, help = picker[0], "Tau-space predicts one policy; under another one, what comes is another process."
            select(label, list(titles), key, titles, place=place, label_visibility="collapsed", help=help)
        if job is None:
            told = _words(view, loaded, rollout, step)
            offer(wish, "Simulate", key="simulate", words=told, place=words, button_place=button, help=_HELP)
            return None
        if job.going:
            with words:
                progress(job, "Simulating: {share:.0%}")
            button.button("Cancel", key="cancel simulation", width="stretch", on_click=wish.cancel)
            return None
        words.caption(_words(view, loaded, rollout, step))
        button.button("Simulate", key="simulate", width="stretch", disabled=True, help=_HELP)
    if not vector.chance(loaded.environment):
        return None
    simulated = attempt(job.result)
    return None if simulated is None else _for_lens(simulated, loaded.agent, view.action)


def section(view: View, loaded: Loaded, rollout: Rollout, step: int) -> None:
    """Under the lens, once there is a simulation: its calibration, which follows alpha; of many states, their means."""
    job = jobs.truth(loaded, rollout, step, view.action, own=_own(rollout)).look()
    simulated = None if job is None or job.going else attempt(job.result)
    if simulated is None:
        return
    confronted = _confronted(simulated, loaded, view.subject, view.action, alpha=view.settings.alpha)
    st.html('<div class="panel-title">does the decoded timeline come true?</div>')
    left, right = st.columns([1, 2], gap="small")
    alt = "Predicted against observed probability that a reward exceeds a sensitivity."
    chart(figures.calibration_plot(confronted), "calibration", alt, place=left)
    if vector.chance(loaded.environment):
        right.caption(_summary(confronted, view))
        return
    alt = "Expected reward, survival and W1 distance over future steps, decoded and simulated, means over states."
    chart(figures.simulated_timeline(confronted), "simulated", alt, place=right)


def _own(rollout: Rollout) -> bool:
    return not rollout.of_the_values and store.chosen().get(AFTER) == "rule"


def _titles(rollout: Rollout) -> dict[str, str]:
    rule = title_of(rollout.rule).split(" (")[0].removeprefix("for T: ")
    if rollout.gamma:
        rule = f"greedy at γ {rollout.gamma:.4g}"
    return {"values": f"greedy at γ {rollout.acting_gamma:.4g}", "rule": f"as rolled out: {rule}"}


def _words(view: View, loaded: Loaded, rollout: Rollout, step: int) -> str:
    """What is simulated, or was; then what it says where tau-space predicts something else."""
    own = _own(rollout)
    then = _titles(rollout)["rule" if own else "values"].removeprefix("as rolled out: ")
    if vector.chance(loaded.environment):
        steps = steps_known(loaded.agent, rollout, step, STEPS, own=own)
        limit = "to the deadline" if steps < STEPS else "without a time limit"
        action = view.subject.action_names[view.action]
        words = f"{COUNT} continuations of {steps} steps, {limit}: {action}, then {then}."
    else:
        words = f"{loaded.environment} has no chance in it: what followed is all that can follow from here. "
        words += f"For calibration, {EACH} states of each of {EPISODES} episodes, {then}."
    if own:
        words += f" Tau-space predicts greedy at γ {rollout.acting_gamma:.4g}: this is another process."
    return words


def _summary(confronted: Confronted, view: View) -> str:
    sample = confronted.simulated
    return (
        f"Calibration: how often a reward exceeded θ where tau-space says so with some probability, over "
        f"{len(confronted.reward)} steps and all θ, at α {view.settings.alpha:g}; bars of two standard errors.  \n"
        f"W1, in reward: how far the rewards of a step are from those that tau-space predicts, 0 once it is over; "
        f"{confronted.distance.mean():.3g} on average over the steps. Grey in the strip beside tau-space: what chance "
        f"alone makes with {sample.count} continuations, {sample.chance.mean():.3g} on average."
    )


@cached(8)
def _for_lens(simulated: Continuations | Outcomes, agent: Agent, action: int) -> Simulated:
    """What the lens draws of continuations; the same object for the same ones."""
    assert isinstance(simulated, Continuations)  # of many states the lens draws nothing
    return Simulated(action, empirical(agent, simulated))


@cached(16)
def _confronted(
    simulated: Continuations | Outcomes, loaded: Loaded, subject: Subject, action: int, *, alpha: float
) -> Confronted:
    if isinstance(simulated, Outcomes):
        return confront_states(loaded.agent, simulated, alpha)
    assert subject.gamma_space is not None  # an agent was observed: there is no world to make one from
    return confront(loaded.agent, subject.gamma_space, action, simulated, alpha=alpha)
