"""Truth by simulation, under the lens: what is decoded for the state under the cursor against what really comes."""

from __future__ import annotations

from functools import lru_cache

import streamlit as st

from app import figures, simulations
from app.chart import chart
from app.figures.theme import HEIGHT
from app.simulations import COUNT, EACH, EPISODES, STEPS, Simulation
from app.sources import Observed, View
from laplace_core import InputError
from laplace_core.training import environments
from laplace_core.training.checkpoint import Loaded
from laplace_core.training.rollout import Rollout
from laplace_core.training.simulated_truth import Confronted, confront, confront_states

LOOK_EVERY = 0.5  # seconds between two looks at a simulation in the making


def section(view: View, loaded: Loaded, rollout: Rollout, step: int) -> None:
    """A button; then progress; then two pictures, which follow alpha."""
    st.html('<div class="panel-title">does the decoded timeline come true?</div>')
    found = simulations.found(loaded, rollout, step, view.action)
    if found is None:
        words, button = st.columns([5, 1], vertical_alignment="center")
        words.caption(_offer(loaded, view, step))
        button.button("Simulate", key="simulate", width="stretch",
                      on_click=simulations.begin, args=(loaded, rollout, step, view.action))  # fmt: skip
        return
    if found.going:
        st.fragment(_progress, run_every=LOOK_EVERY)(found)
        return
    try:
        confronted = _confronted(found, loaded, view.subject, view.action, view.settings.alpha)
    except InputError as error:
        st.error(str(error))
        return
    st.caption(_told(loaded, confronted, view, step))
    left, right = st.columns([2, 1], gap="small")
    with left:
        alt = "Expected reward, survival and W1 distance over future steps, decoded and simulated."
        chart(figures.to_json(figures.simulated_timeline(confronted)), "simulated", alt, HEIGHT)
    with right:
        alt = "Predicted against observed probability that a reward exceeds a sensitivity."
        chart(figures.to_json(figures.calibration_plot(confronted)), "calibration", alt, HEIGHT)


def _offer(loaded: Loaded, view: View, step: int) -> str:
    if environments.chance(loaded.environment):
        return (
            f"{COUNT} continuations of {STEPS} steps from step {step}, {_action(view)} first and greedy at the acting "
            "discount from there, past the time limit."
        )
    return (
        f"{loaded.environment} has no chance in it: every continuation of a state is the same. In its place, {EACH} "
        f"states of each of {EPISODES} greedy episodes, and what came after them without a time limit."
    )


def _action(view: View) -> str:
    return view.subject.action_names[view.action]


def _told(loaded: Loaded, found: Confronted, view: View, step: int) -> str:
    if environments.chance(loaded.environment):
        what = f"{found.count} continuations from step {step}, {_action(view)} first, then greedy"
    else:
        what = f"{found.count} states of {EPISODES} greedy episodes, because {loaded.environment} has no chance in it"
    return (
        f"{what}; at α {view.settings.alpha:g}. Bands and bars are two standard errors. W1 is the area between decoded "
        "and simulated P(r > θ, alive), in units of reward."
    )


def _progress(found: Simulation) -> None:
    if not found.going:
        st.rerun()
    left, right = st.columns([6, 1], vertical_alignment="center")
    share = found.done / found.of if found.of else 0.0
    left.progress(share, f"Simulating: {found.done} of {found.of}" if found.of else "Simulating: preparing")
    right.button("Cancel", key="cancel simulation", width="stretch", on_click=found.cancel)


@lru_cache(maxsize=16)
def _confronted(found: Simulation, loaded: Loaded, subject: Observed, action: int, alpha: float) -> Confronted:
    if environments.chance(loaded.environment):
        return confront(subject.gamma_space, action, found.result(), alpha)
    return confront_states(loaded.agent, found.result(), alpha)
