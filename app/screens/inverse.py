"""The page Inverse: alpha by dragging, the rules that choose it, and where the choice of action turns."""

from __future__ import annotations

import streamlit as st

from app.components.inverse import State, inverse
from app.components.waiting import offer, turn
from app.inverse import compute, evidence, grids, leaderboard, memory, sidebar, studies, subjects
from app.inverse.schema import LINK
from app.session import store
from app.view import explain, feasible, solver
from app.view.compute import horizon_of, is_large
from laplace_core import InputError
from laplace_core.inverse.selectors import TYPED
from laplace_core.payloads.inverse_words import NO_NOISE, OFFERED, RULES, TESTING, said
from laplace_core.subjects import View
from laplace_core.supervise.jobs import Job

LOOK_EVERY = 0.1  # seconds between two looks at a test that is not done
SOON = 0.25  # seconds that the tests of the noise are waited for, so that what is soon done is drawn once


def page() -> None:
    store.open_page("inverse", LINK)
    with st.sidebar:
        if not sidebar.subject():
            st.info("Nothing is shown yet: open a file, or choose another subject.")
            return
        try:
            view = subjects.view_of(store.chosen())
            world = subjects.world_of(store.chosen())
        except InputError as error:
            sidebar.refused(str(error))
            return
        sidebar.settings(view, world)
    explain.guide("inverse")
    store.write_url()
    try:
        with turn(needed=is_large(view)):
            view, _ = feasible.drawn(view)
            waiting = _pictures(view)
    except InputError as error:
        sidebar.refused(str(error))
        return
    store.worked()
    leaderboard.section(view)
    memory.section(view)
    grids.section(view)
    studies.section()
    if waiting:
        _await(waiting)


def _pictures(view: View) -> list[Job]:
    """Draw all pictures of a view; returns the jobs that are still running."""
    shown = compute.shown(view)
    study, key, independent = shown.study, compute.key_of(view), compute.independent(view)
    solver.shows(study.settings, weighting=False)
    banded = evidence.band(study, view.action, key, independent=independent)
    band = None if banded is None else banded.look()
    drawn = band.result() if band is not None and band.worked else None
    wish = evidence.wish(study, key, independent=independent)
    job = None if wish is None else wish.look()
    if job is not None:
        job.wait(SOON)
    found = job.result() if job is not None and job.worked else None
    lacking = NO_NOISE if wish is None else OFFERED if job is None else TESTING
    if job is not None and not job.going and found is None:
        lacking = f"Whether any timeline has these values was not tested: {job.refusal or job.why or 'cancelled'}"
    record = study.alpha_record
    state = State(study.settings.alpha, horizon_of(view), str(store.chosen().get("axis", subjects.AXIS.default)))

    def release(released: State) -> None:
        if released.alpha != state.alpha:
            solver.by_hand(released.alpha)
        if released.horizon != state.horizon:
            store.choose("horizon", released.horizon)
        if released.axis != state.axis:
            store.choose("axis", released.axis)

    inverse(
        shown.data, state, "study",
        said=said(study, shown.found, shown.course, found, lacking=lacking), rules=RULES,
        rule=None if record.rule == TYPED else record.criterion, on_release=release,
        certified=None if found is None else found.certified,
        band=drawn,
    )  # fmt: skip
    if wish is not None and job is None:
        offer(wish, "Test the values", key="test_values")
    awaited = ((job, found is not None), (band, drawn is not None))
    return [each for each, known in awaited if each is not None and not known and (each.going or each.worked)]


def _await(jobs: list[Job]) -> None:
    """Redraw the page once one of the jobs is done; any input of the user ends this run."""
    place = st.empty()
    while all(job.going for job in jobs) and not jobs[0].wait(LOOK_EVERY):
        place.empty()  # where Streamlit ends a run that nobody awaits
    st.rerun()


page()
