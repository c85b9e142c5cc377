"""Tau-space changed by hand: gamma-space and the choice follow (the paper's memory extension)."""

from __future__ import annotations

import streamlit as st

from app.components.chart import chart
from app.components.widgets import field
from app.session import store
from app.session.typed import in_markdown
from app.view.compute import study_for
from laplace_core import InputError, figures
from laplace_core.parameters import Parameter
from laplace_core.payloads.inverse_words import chosen_over
from laplace_core.study.edited import Edit, edit
from laplace_core.subjects import View

EDIT = "m."
"""Prefix of the entries of an edit, in the session and in the link."""
PARAMETERS = (
    Parameter("horizon", 0, 0, 2000, "The episode is stopped after this number of steps; 0 means never."),
    Parameter("gamma", 1.0, 0.5, 1.0, "Probability that the episode continues after each step."),
    Parameter("worst", 1.0, 0.01, 1.0, "Value a step by the mean of this share of its worst outcomes; 1 counts all."),
)
_TITLES = {"horizon": "Stop after (steps)", "gamma": "Probability to continue", "worst": "Share of the worst outcomes"}


def section(view: View) -> None:
    """A closed section, open where a link has changed something."""
    given = {each.name: store.chosen()[EDIT + each.name] for each in PARAMETERS if EDIT + each.name in store.chosen()}
    box = st.expander("Edit tau-space: stop early, change the discount, weigh risk", key="memory", on_change="rerun",
                      expanded=bool(given))  # fmt: skip
    if not box.open:
        return
    with box:
        for place, parameter in zip(st.columns(len(PARAMETERS)), PARAMETERS, strict=True):
            name = parameter.name
            field(parameter, parameter.default, _TITLES[name], key=EDIT + name, place=place)
        try:
            _pictures(view, wanted(given))
        except InputError as error:
            st.error(in_markdown(error))


def wanted(given: dict[str, float]) -> Edit:
    """The edit of the values that are set by hand."""
    stop = given.get("horizon") or None
    return Edit(stop, float(given.get("gamma", 1.0)), float(given.get("worst", 1.0)))


def _pictures(view: View, change: Edit) -> None:
    study = study_for(view)
    found, names = edit(study, change), study.action_names
    before, after = (chosen_over(study, actions) for actions in (found.actions, found.new_actions))
    st.caption(in_markdown(f"As decoded: {before} Changed: {after}" if change.changes else f"As decoded: {before}"))
    left, right = st.columns(2)
    chart(figures.edited_values(found, study.horizons, names), "edited values",
          "Values over the deadline, before and after the change.", place=left)  # fmt: skip
    chart(figures.edited_gamma_space(found, names), "edited gamma-space",
          "Gamma-space over the time constants, before and after the change.", place=right)  # fmt: skip
