"""Every solver on the present case, with the alpha of one rule, in a table that can be sorted and downloaded."""

from __future__ import annotations

from typing import Any

import streamlit as st

from app.components.widgets import download
from app.inverse import compute
from app.session import store
from app.view.compute import study_for
from laplace_core.inverse.selectors import TYPED
from laplace_core.inverse.titles import SOLVER_TITLES
from laplace_core.study.course import Ranked
from laplace_core.subjects import View

COLUMNS = {
    "solver": "Solver",
    "alpha": "alpha",
    "distance": "W1 (steps)",
    "relative_error": "Relative error (L2)",
    "variation": "Total variation",
    "value_error": "Error of V_T",
    "regret": "Regret",
    "seconds": "Time (s)",
}
"""Fields of :class:`laplace_core.study.course.Ranked` and of its errors, and their titles."""


def section(view: View) -> None:
    """A closed section; the solvers are run once it is opened."""
    box = st.expander("Leaderboard: every solver with its own alpha", key="leaderboard", on_change="rerun")
    if not box.open:
        return
    chosen = study_for(view).settings.selector
    rule = "auto" if chosen == TYPED else chosen
    with box:
        rows = compute.ranked(view, rule)
        event: Any = st.dataframe(
            [_shown(row) for row in rows], hide_index=True, width="stretch", on_select="rerun",
            selection_mode="single-row", key="ranking",
        )  # fmt: skip
        left, right = st.columns([3, 1], vertical_alignment="center")
        picked = event.selection.rows
        left.button(
            f"Show {SOLVER_TITLES[rows[picked[0]].solver]}" if picked else "Choose a row to use its solver",
            disabled=not picked, on_click=_open, args=(rows[picked[0]].solver if picked else "", rule),
        )  # fmt: skip
        download("CSV", lambda: _csv(rows), "solvers.csv", place=right, width="stretch")


def _cells(row: Ranked) -> dict[str, Any]:
    found = {"solver": row.solver, "alpha": row.alpha, "seconds": row.seconds, **row.errors._asdict()}
    return {name: found[name] for name in COLUMNS}


def _shown(row: Ranked) -> dict[str, Any]:
    titled = {COLUMNS[name]: value for name, value in _cells(row).items()}
    return titled | {COLUMNS["solver"]: SOLVER_TITLES[row.solver]}


def _csv(rows: tuple[Ranked, ...]) -> str:
    lines = [list(COLUMNS), *(["" if cell is None else str(cell) for cell in _cells(row).values()] for row in rows)]
    return "".join(",".join(line) + "\n" for line in lines)


def _open(solver: str, rule: str) -> None:
    """Callback: show a solver with the alpha of its row."""
    store.choose("solver", solver)
    store.choose("selector", rule)
    store.choose("alpha", None)
