"""Truth by simulation: a row over the lens that begins it, and the calibration under the lens."""

from __future__ import annotations

import streamlit as st

from app.agents import jobs
from app.components.chart import chart
from app.components.waiting import attempt, offer, progress
from app.components.widgets import select
from app.session import store
from app.view import compute
from laplace_core import figures
from laplace_core.acting.rollout import Rollout
from laplace_core.environments import vector
from laplace_core.payloads.lens import Simulated
from laplace_core.subjects import View
from laplace_core.trained import truths
from laplace_core.trained.rollouts import AFTER
from laplace_core.training.checkpoint import Loaded

_HELP = "Compare the decoded timeline with simulated continuations."


def ask(view: View, loaded: Loaded, rollout: Rollout, step: int) -> Simulated | None:
    """The row over the lens: a button, then progress, then a summary; returns the simulation for the lens."""
    own = _own(rollout)
    wish = jobs.truth(loaded, rollout, step, view.action, own=own)
    job = wish.look()
    with st.container(key="truth"):
        shares = [6.4, 1.8] if rollout.of_the_values else [5.2, 2.6, 1.8]
        words, *picker, button = st.columns(shares, vertical_alignment="center", gap="small")
        if picker:
            titles, key, label = truths.titles(rollout), store.show(AFTER, "values"), "Policy of the simulation"
            place, help = picker[0], "Tau-space predicts the rewards of one policy; others lead to other rewards."
            select(label, list(titles), key, titles, place=place, label_visibility="collapsed", help=help)
        if job is None:
            told = truths.words(view, loaded, rollout, step, own=own)
            offer(wish, "Simulate", key="simulate", words=told, place=words, button_place=button, help=_HELP)
            return None
        if job.going:
            with words:
                progress(job, "Simulating: {share:.0%}")
            button.button("Cancel", key="cancel simulation", width="stretch", on_click=wish.cancel)
            return None
        words.caption(truths.words(view, loaded, rollout, step, own=own))
        button.button("Simulate", key="simulate", width="stretch", disabled=True, help=_HELP)
    if not vector.chance(loaded.environment):
        return None
    simulated = attempt(job.result)
    return None if simulated is None else truths.for_lens(simulated, loaded.agent, view.action)


def section(view: View, loaded: Loaded, rollout: Rollout, step: int) -> None:
    """Under the lens, once there is a simulation: its calibration, which follows alpha; of many states, their means."""
    job = jobs.truth(loaded, rollout, step, view.action, own=_own(rollout)).look()
    simulated = None if job is None or job.going else attempt(job.result)
    if simulated is None:
        return
    confronted = truths.confronted_with(
        simulated, loaded, view.subject, view.action, alpha=compute.study_for(view).settings.alpha
    )
    st.html('<h2 class="panel-title">Decoded timeline against simulated continuations</h2>')
    left, right = st.columns([1, 2], gap="small")
    alt = "Predicted against observed probability that a reward exceeds a sensitivity."
    chart(figures.calibration_plot(confronted), "calibration", alt, place=left)
    if vector.chance(loaded.environment):
        right.caption(truths.summary(confronted, view))
        return
    alt = "Expected reward, survival and W1 distance over future steps, decoded and simulated: means over states."
    chart(figures.simulated_timeline(confronted), "simulated", alt, place=right)


def _own(rollout: Rollout) -> bool:
    return not rollout.of_the_values and store.chosen().get(AFTER) == "rule"
