"""Which discounts to learn for the deadlines and the noise of the present case: grids judged, and one designed."""

from __future__ import annotations

from collections.abc import Hashable
from typing import Any

import numpy as np
import streamlit as st

from app.components.waiting import attempt, offer, progress
from app.components.widgets import download
from app.session import store
from app.session.jobs import Wish, background
from app.view.compute import study_for
from laplace_core.inverse.grids import Judged, judged, task_for
from laplace_core.subjects import View
from laplace_core.supervise.jobs import Kind, Progress

MOST_KEPT = 12
SECONDS = 5e-4
"""Of a design, by the number of discounts times the horizon."""
MOST_DISCOUNTS = 100
_judged: Kind[tuple[Judged, ...]] = Kind("judged grids", MOST_KEPT, line=background)


def wish(count: int, horizon: int, noise: float, value_gamma: float) -> Wish[tuple[Judged, ...]]:
    """Grids of so many discounts, judged for all deadlines up to a horizon."""

    def make(report: Progress) -> tuple[Judged, ...]:
        return judged(task_for(horizon, noise, value_gamma=value_gamma), count, report)

    key: Hashable = (count, horizon, noise, value_gamma)
    seconds = 1.0 + count * horizon * SECONDS
    return Wish(_judged, key, make, lambda: seconds, slot="grids", lower="lower gammas or steps")


def section(view: View) -> None:
    """A closed section; a button begins the work."""
    box = st.expander("Design the discounts for this noise and these deadlines", key="grids", on_change="rerun")
    if not box.open:
        return
    study = study_for(view)
    s, space = study.settings, study.gamma_space
    count = min(MOST_DISCOUNTS, len(space.gammas))
    horizon = int(np.clip(study.horizons[-1], 2, 1000))
    asked = wish(count, horizon, float(s.noise_level or s.noise), s.value_gamma)
    with box:
        job = asked.look()
        if job is None:
            words = f"{count} discounts, deadlines up to {horizon}, noise {s.noise_level or s.noise:g}."
            offer(asked, "Judge grids", key="judge_grids", words=words)
        elif job.going:
            progress(job, "Judging grids: {done} of {of}", asked.cancel, key="cancel_grids")
        else:
            found = attempt(job.result)
            if found is not None:
                _table(found, count, of_world=view.world is not None)


def _table(found: tuple[Judged, ...], count: int, *, of_world: bool) -> None:
    rows = [{"Grid": each.name, "Error of V_T": each.error, "alpha": each.alpha, "Discounts": len(each.gammas),
             "Smallest gamma": each.gammas[0], "Largest gamma": each.gammas[-1]} for each in found]  # fmt: skip
    event: Any = st.dataframe(rows, hide_index=True, width="stretch", on_select="rerun", selection_mode="single-row",
                              key="judged")  # fmt: skip
    picked = found[event.selection.rows[0]] if event.selection.rows else None
    left, right = st.columns([3, 1], vertical_alignment="center")
    named = picked is not None and picked.name != "designed"
    label = f"Use {picked.name}" if picked is not None and named else "Choose a row with a named grid to use it"
    left.button(label, disabled=not (named and of_world), on_click=_use, args=(picked, count), key="use_grid")
    shown = picked or found[0]
    lines = "gamma\n" + "".join(f"{gamma!r}\n" for gamma in shown.gammas.tolist())
    download(f"CSV of {shown.name}", lines, "gammas.csv", place=right, width="stretch")


def _use(grid: Judged, count: int) -> None:
    """Callback: the study takes the discounts of a grid; alpha is chosen again."""
    spacing = grid.name.partition(",")[0]
    bounds: tuple[float | None, float | None] = (float(grid.gammas[0]), float(grid.gammas[-1]))
    if spacing == "paper":
        bounds = (None, None)
    store.apply_changes({
        "spacing": spacing, "gammas": None if spacing == "paper" else count, "gamma_min": bounds[0],
        "gamma_max": bounds[1],
    })  # fmt: skip
