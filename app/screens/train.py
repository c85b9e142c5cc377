"""Training: agents of any algorithm on any environment; each run is its own process and outlives the page."""

from __future__ import annotations

import streamlit as st

from app.catalogue import checkpoints, training_runs
from app.components.owner import keep_owner
from app.components.waiting import attempt
from app.components.widgets import left_out
from app.session import store
from app.train import cards, form, pictures, searches, server
from app.train.schema import LINK, OPENING
from app.view import explain
from laplace_core.supervise.limits import limits
from laplace_core.training.queue import Run

LOOK_EVERY = 1.0  # seconds between two looks at the runs, while one is going


def page() -> None:
    store.open_page("train", LINK)
    if limits().owners and not limits().read_only:
        keep_owner()
    with st.sidebar:
        form.form()
        left_out(checkpoints.left_out())
    explain.guide("train")
    going = attempt(lambda: _going(training_runs.queue().runs()))
    if going is not None:
        st.fragment(_view, run_every=LOOK_EVERY if going else None)(going=going)
        st.fragment(searches.searches)()


def _going(runs: list[Run]) -> bool:
    return any(run.going or (run.settings is not None and training_runs.behind(run)) for run in runs)


def _view(*, going: bool) -> None:
    store.write_url()
    queue = training_runs.queue()
    runs = queue.runs()
    if any(run.going for run in runs):
        queue.wake()  # another server, that has ended since, may have left them in its queue
    if queue.trouble:
        st.error(f"The queue is paused: {queue.trouble}")
    if not runs:
        st.info("There is no run yet. A run trains in its own process, so you may close this page meanwhile.")
        if not limits().read_only:
            st.button("Train Laplace DQN on CartPole", type="primary", on_click=_first)
        pictures.shipped(str(store.chosen().get("environment", OPENING["environment"])))
        server.server(runs)
        return
    looked = pictures.looked_at(runs)
    if looked is not None:
        pictures.pictures(runs, looked)
    cards.cards(runs, looked)
    server.server(runs)
    if _going(runs) != going:  # a run began or the last one ended: look oftener, or no more
        st.rerun()


def _first() -> None:
    """Callback: the small default."""
    store.replace_all({})
    form.start()


page()
