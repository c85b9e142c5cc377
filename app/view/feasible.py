"""The feasible timeline of a large view: computed in the background, while the page shows the linear one."""

from __future__ import annotations

from dataclasses import replace

import streamlit as st
from streamlit.delta_generator import DeltaGenerator

from app.components.waiting import offer, progress
from app.session.jobs import Wish, background, leave
from app.view import compute
from laplace_core import Study
from laplace_core.inverse.feasible import MOST_TOGETHER
from laplace_core.inverse.interior import calling
from laplace_core.inverse.solvers import selecting
from laplace_core.subjects import View
from laplace_core.supervise.jobs import Job, Kind, Progress

SOLVER, SLOT = "feasible", "feasible"
AT_ONCE = 0.3
"""Seconds of estimate up to which the timeline is computed before the page is drawn."""
SOON = 0.6
"""Seconds that the timeline is waited for, so that what is soon done is drawn once."""
SECONDS_A_NUMBER = 2e-6
"""Of all actions, discounts, rows and bins together, about."""
STEPS = 30
"""Newton steps that are usual."""
MOST_KEPT = 8
_timelines: Kind[tuple[Study, Study | None]] = Kind("feasible timelines", MOST_KEPT, line=background)


def linear(view: View) -> View:
    """The view by the linear solver that alpha is chosen by, where its own takes long; else the view itself."""
    if view.settings.solver != SOLVER:
        return view
    return replace(view, settings=replace(view.settings, solver=selecting(SOLVER)))


def drawn(view: View) -> tuple[View, str | None]:
    """The view as it can be drawn now, and in words above it what is still to come.

    Returns:
        the view itself and None; or, while its timeline is computed and after that was cancelled, that of
        :func:`linear` and the name of the solver that it stands in for.

    Raises:
        InputError: settings that do not fit each other.
    """
    if view.settings.solver != SOLVER:
        leave(SLOT)
        return view, None
    shown = linear(view)
    compute.study_for(shown)  # it refuses what the other would refuse, and at once
    seconds = _seconds(view)
    if seconds <= AT_ONCE:
        leave(SLOT)
        return view, None
    if compute.is_known(view):
        leave(SLOT)
        _said_of_what_is_there()
        return view, None
    base = compute.unread(view)
    wish = wish_for(base, seconds)
    job = wish.look()
    if job is not None:
        job.wait(SOON)
    if job is not None and not job.going and not job.gone:
        compute.remember(base, *job.result())  # or raises the sentence that refuses it
        compute.is_known(view)
        _said_of_what_is_there()
        return view, None
    _said(wish, job)
    return shown, SOLVER


def wish_for(view: View, seconds: float) -> Wish[tuple[Study, Study | None]]:
    """The timeline of a view as a job of this session; the one that it wanted before ends, unless another wants it.

    Args:
        seconds: an estimate of how long it takes.
    """
    return Wish(
        _timelines, (view.subject, view.settings), lambda progress: _made(view, progress), lambda: seconds, SLOT,
        "lower gammas, thetas or steps", by_itself=float("inf"),
    )  # fmt: skip


def _said(wish: Wish[tuple[Study, Study | None]], job: Job[tuple[Study, Study | None]] | None) -> None:
    with _line():
        if job is None or not job.going:
            line, button = st.columns([3, 2], vertical_alignment="center")
            offer(
                wish, "Compute the feasible timeline", key="compute_feasible", words="This is the linear timeline.",
                place=line, button_place=button,
            )  # fmt: skip
        else:
            words = "The feasible timeline is being computed; this is the linear one."
            progress(job, words, wish.cancel, key="cancel_feasible")


def _said_of_what_is_there() -> None:
    with _line():
        st.caption("This is the feasible timeline.")


def _line() -> DeltaGenerator:
    """One line above the pictures, as high whatever it says: what comes and goes in it moves no picture."""
    return st.container(key="feasible_timeline")


def _made(view: View, progress: Progress) -> tuple[Study, Study | None]:
    """The study, and the one that the lens draws from where that is another one."""
    actions, discounts, thetas = compute.study_for(linear(view)).gamma_space.values.shape
    together = max(1, MOST_TOGETHER // (discounts * (thetas + 1) * view.settings.steps))  # actions that are, about
    done, of = 0, STEPS * -(-actions // together)

    def step() -> None:
        nonlocal done
        progress(min(done, of), of)
        done += 1

    with calling(step):
        return compute.made(view)


def _seconds(view: View) -> float:
    """An estimate of how long the timeline takes."""
    space = compute.study_for(linear(view)).gamma_space
    actions, discounts, thetas = space.values.shape
    numbers = actions * discounts * (thetas + 1) * view.settings.steps
    return SECONDS_A_NUMBER * numbers * (view.settings.steps if view.settings.fold else 1)
