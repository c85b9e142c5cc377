"""Solvers and rules for alpha on many worlds whose truth is known: in the background, drawn, downloadable."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import streamlit as st

from app import session
from app.components.chart import chart
from app.components.waiting import attempt, offer, progress
from app.components.widgets import download, field
from app.session import store
from app.session.jobs import Wish, background
from app.session.typed import in_markdown
from laplace_core.exchange.links import Values, by_name
from laplace_core.experiments.inverse.measuring import OPTIONS, PARAMETERS, Measuring, measuring, plan_of, words_in
from laplace_core.experiments.inverse.selection import NO_SELECTOR, RANDOM, seconds_to_measure
from laplace_core.figures.inverse_study import behind_the_best, study_heights
from laplace_core.inverse.titles import RULE_TITLES, SOLVER_TITLES
from laplace_core.supervise.jobs import Kind
from laplace_core.worlds.titles import world_title

STUDY = "s."
"""Prefix of the entries of a study, in the session and in the link."""
MOST_KEPT = 12
DRAW_EVERY = 2.0  # seconds between two pictures of a study that is measured
_BY_NAME = by_name(*PARAMETERS)
_LISTS: dict[str, tuple[str, Callable[[str], str]]] = {
    "worlds": ("Worlds", lambda name: "Random worlds" if name == RANDOM else world_title(name)),
    "grids": ("Grids", str),
    "solvers": ("Solvers", SOLVER_TITLES.__getitem__),
    "selectors": ("Alpha rules", RULE_TITLES.__getitem__),
}
_studies: Kind[Measuring] = Kind("measured studies", MOST_KEPT, line=background)


@dataclass
class _Held:
    """The study of this session; its measured rows stay when it is cancelled."""

    study: Measuring | None = None


def given(values: Values) -> dict[str, Any]:
    """The values set by hand that belong to a study, by the names of its parameters."""
    return {name.removeprefix(STUDY): value for name, value in values.items() if name.startswith(STUDY)}


def section() -> None:
    """A closed section, open where a link has set something; a button begins the work."""
    values = given(store.chosen())
    box = st.expander("Study solvers and rules on many worlds", key="study", on_change="rerun", expanded=bool(values))
    if not box.open:
        return
    with box:
        _form(values)
        plan = attempt(lambda: plan_of(values))
        if plan is not None:
            _measured(measuring(plan))


def _form(values: dict[str, Any]) -> None:
    left, middle, right = st.columns([3, 1, 1])
    _list("worlds", values, left)
    field(_BY_NAME["cases"], _BY_NAME["cases"].default, "Cases of each world", key=f"{STUDY}cases", place=middle)
    field(_BY_NAME["seed"], _BY_NAME["seed"].default, "Seed of cases", key=f"{STUDY}seed", place=right)
    left, right = st.columns([3, 2])
    _list("solvers", values, left)
    key = store.show(f"{STUDY}noises", _BY_NAME["noises"].default)
    right.text_input("Noise levels", key=key, on_change=store.keep, args=(key,), help=_BY_NAME["noises"].help)
    left, right = st.columns([3, 2])
    _list("selectors", values, left)
    _list("grids", values, right)


def _list(name: str, values: dict[str, Any], place: Any) -> None:
    """A box for several words, which is kept as one text."""
    (title, named), parameter = _LISTS[name], _BY_NAME[name]
    shown = store.put(f"{STUDY}{name} box", words_in(str(values.get(name, parameter.default))))
    place.multiselect(title, OPTIONS[name], key=shown, format_func=named, on_change=_keep_list, args=(name,),
                      help=parameter.help)  # fmt: skip


def _keep_list(name: str) -> None:
    """Callback of a box for several words."""
    store.choose(f"{STUDY}{name}", ",".join(st.session_state[f"{STUDY}{name} box"]))


def _measured(study: Measuring) -> None:
    session.part(_Held).study = study
    plan = study.plan
    wish = Wish(
        _studies, plan, study.measure, lambda: seconds_to_measure(plan) * (1.0 - study.done / plan.size), "study",
        "lower its worlds, noises, grids or solvers", by_itself=0.0,
    )  # fmt: skip
    job = wish.look()
    if job is not None and job.refusal:
        st.error(in_markdown(job.refusal))
        _studies.drop(plan)
    elif job is not None and job.going:
        progress(job, "Measured {done} of {of} worlds, noises and grids", wish.cancel, key="cancel_study")
        st.fragment(_pictures, run_every=DRAW_EVERY)(study)
        return
    elif job is None:
        begun = f"{study.done:,} of {plan.size:,} cases are measured." if study.done else f"{plan.size:,} cases."
        offer(wish, "Measure the rest" if study.done else "Run the study", key="run_study", words=begun)
    _pictures(study)


def _pictures(study: Measuring) -> None:
    sums = [entry for entry in study.sums() if entry["selector"] != NO_SELECTOR]
    if sums:
        for what, place in zip(("ratio", "excess"), st.columns(2), strict=True):
            chart(behind_the_best(sums, what, RULE_TITLES, SOLVER_TITLES), f"study {what}",
                  f"Medians and 90% quantiles of the {what} of every solver and rule.", study_heights(sums),
                  place=place)  # fmt: skip
    if study.done:
        download("CSV of all cases", lambda: study.table, "inverse_study.csv", width="stretch")
