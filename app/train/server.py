"""The limits of this server and their use."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import streamlit as st

from app.catalogue import training_runs
from app.session import jobs
from laplace_core.agents import ENVIRONMENTS as KNOWN
from laplace_core.caching import BUDGET
from laplace_core.supervise.limits import ENVIRONMENTS, limits, may_train
from laplace_core.training.disk import held
from laplace_core.training.queue import Run


class Use(NamedTuple):
    """One limit: its subject, how much is used, the unit, and the environment variable that sets it."""

    what: str
    used: float
    limit: float
    unit: str
    variable: str


def server(runs: Sequence[Run]) -> None:
    """The section of the page, closed at first."""
    box = st.expander("Server", key="server", on_change="rerun")
    if not box.open:
        return
    with box:
        rows = ["| | used | limit | set by |", "|---|---:|---:|---|"]
        for use in (*_of_runs(runs), *_of_sessions()):
            rows.append(f"| {use.what} | {use.used:,.0f} {use.unit} | {use.limit:,.0f} {use.unit} | `{use.variable}` |")
        st.markdown("\n".join(rows))
        allowed = [each for each in KNOWN if may_train(each)]
        if len(allowed) < len(KNOWN):
            st.caption(f"Trained on here: {', '.join(allowed) or 'nothing'} (`{ENVIRONMENTS}`).")
        st.caption(_who())


def _of_runs(runs: Sequence[Run]) -> list[Use]:
    granted = limits()
    return [
        Use("Training runs at once", sum(run.at_work for run in runs), granted.trainings, "", "LAPLACE_TRAININGS"),
        Use("Disk of all runs", held(training_runs.queue().folder) / 1e6, granted.disk, "MB", "LAPLACE_DISK"),
    ]


def _of_sessions() -> list[Use]:
    granted, background, learners = limits(), jobs.background().usage(), jobs.learners().usage()
    return [
        Use("Caches and opened files together", BUDGET.bytes / 1e6, granted.memory, "MB", "LAPLACE_MEMORY"),
        Use("Background jobs that wait", background.waiting, granted.jobs_in_line, "", "LAPLACE_JOBS_IN_LINE"),
        Use("Tabular learners at once", learners.running, granted.learners, "", "LAPLACE_LEARNERS"),
    ]


def _who() -> str:
    if limits().read_only:
        return "Runs are shown and cannot be changed here (`LAPLACE_READ_ONLY`)."
    if not limits().owners:
        return "Everybody may stop, resume, download and remove every run (`LAPLACE_OWNERS`)."
    return (
        "Everybody sees all runs. Only the browser that started a run can stop, resume, download or remove it; a "
        "cookie identifies that browser. A run from the command line has no owner (`LAPLACE_OWNERS`)."
    )
