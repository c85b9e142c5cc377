"""What widgets report: a touch is kept, an echo of what a widget showed before the server changed it is not."""

from __future__ import annotations

import pytest
import streamlit as st

from app import state


@pytest.fixture(autouse=True)
def session(monkeypatch):
    """A session of one page, without a browser."""
    monkeypatch.setattr(st, "session_state", {"_page": "worlds"})
    return st.session_state


def report(**values: object) -> None:
    """An event of the browser: every widget that looks changed to the server calls back."""
    for name, value in values.items():
        st.session_state[name] = value
        state.keep(name)


def test_a_touched_widget_is_kept():
    state.show("alpha", 0.1)
    report(alpha=0.2)
    assert state.chosen() == {"alpha": 0.2}


def test_what_merely_shows_what_it_showed_is_not():
    state.show("alpha", 0.1)
    state.put("horizon", 40.0)
    report(alpha=0.1, horizon=40.0)
    assert state.chosen() == {}


def test_a_remedy_is_not_undone_by_the_widget_that_still_shows_what_was_before():
    state.show("normalise", "paper")
    state.show("alpha", 0.1)
    state.apply_changes({"normalise": "none"})
    state.show("normalise", "paper")  # now none
    report(alpha=0.2, normalise="paper")  # alpha was moved before the browser had drawn the remedy
    assert state.chosen() == {"normalise": "none", "alpha": 0.2}


def test_alone_the_same_report_is_a_person_who_goes_back():
    state.show("normalise", "paper")
    state.apply_changes({"normalise": "none"})
    state.show("normalise", "paper")
    report(normalise="paper")
    assert state.chosen() == {"normalise": "paper"}


def test_going_back_at_once_to_what_was_shown_counts():
    state.show("alpha", 0.1)
    report(alpha=0.2)
    assert state.chosen() == {"alpha": 0.2}
    report(alpha=0.1)  # before the page was drawn anew
    assert state.chosen() == {"alpha": 0.1}


def test_parameters_of_a_world_that_was_left_stay_behind():
    st.session_state["world"] = "cliff_grid"
    state.show("p.early", 2)
    state.choose_world()
    report(**{"p.early": 2})
    assert state.chosen() == {"world": "cliff_grid"}


def test_going_back_and_forth_by_hand_is_never_an_echo():
    state.show("normalise", "none")
    state.put("horizon", 3.0)
    report(normalise="survival")
    state.show("normalise", "none")  # now survival
    report(normalise="none", horizon=3.0)  # back by hand, beside an echo
    assert state.chosen() == {"normalise": "none"}
    state.show("normalise", "none")
    state.show("alpha", 0.1)
    report(normalise="survival", alpha=0.2)  # both at once, one of them to what it showed before
    assert state.chosen() == {"normalise": "survival", "alpha": 0.2}
