"""What widgets report: a touch is kept, an echo of what a widget showed before the server changed it is not."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import pytest
import streamlit as st

from app import session
from app.session import store
from app.worlds import actions
from laplace_core.exchange.echoes import Shown, is_echo


@pytest.fixture(autouse=True)
def alone(monkeypatch):
    """A session of one page, without a browser."""
    monkeypatch.setattr(st, "session_state", {})
    session.current().page = "worlds"


def report(**values: object) -> None:
    """An event of the browser: every widget that looks changed to the server calls back."""
    for name, value in values.items():
        st.session_state[name] = value
        store.keep(name)


@dataclass(frozen=True)
class Row:
    """One row of the table of :func:`is_echo`."""

    reports: str
    by_hand: frozenset[bool]
    others: frozenset[bool]
    dropped: bool


def table() -> list[Row]:
    """The table, as the docstring has it: cells are at least two blanks apart."""
    assert is_echo.__doc__ is not None
    lines = [line.strip() for line in is_echo.__doc__.splitlines()]
    first, head, last = (place for place, line in enumerate(lines) if line.startswith("====="))
    assert lines[first + 1 : head] == ["it reports              by hand      others report  it is     because"], (
        "the columns that are read here"
    )
    words = {"no": frozenset({False}), "yes": frozenset({True}), "no or yes": frozenset({False, True})}
    rows = []
    for line in lines[head + 1 : last]:
        reports, by_hand, others, outcome, _ = (cell.strip() for cell in line.split("  ") if cell)
        rows.append(Row(reports, words[by_hand], words[others], {"dropped": True, "kept": False}[outcome]))
    return rows


SHOWN = Shown("now", "before")
VALUES = {"what it shows": "now", "what it showed before": "before", "something else": "else"}
CASES = list(product(VALUES, (False, True), (False, True)))


def row_of(reports: str, *, by_hand: bool, others: bool) -> Row:
    rows = [row for row in table() if row.reports == reports and by_hand in row.by_hand and others in row.others]
    assert len(rows) == 1, "the table has one row for every case"
    return rows[0]


def test_the_rule_is_its_table(subtests):
    for reports, by_hand, others in CASES:
        with subtests.test(reports=reports, by_hand=by_hand, others=others):
            row = row_of(reports, by_hand=by_hand, others=others)
            assert is_echo(VALUES[reports], SHOWN, by_hand=by_hand, others=others) == row.dropped


def test_the_table_has_no_row_beside_these_cases():
    assert {row.reports for row in table()} == set(VALUES)


@pytest.mark.parametrize(("reports", "by_hand", "others"), CASES)
def test_a_page_keeps_and_drops_by_the_table(reports, by_hand, others):
    """The same through the page: a widget that the server changed, alone or beside one that a person touches."""
    store.put("widget", "before")
    if by_hand:
        store.choose("widget", "now")
    store.put("widget", "now")
    store.show("other", 1)
    report(widget=VALUES[reports], **({"other": 2} if others else {}))
    expected = {"other": 2} if others else {}
    if not row_of(reports, by_hand=by_hand, others=others).dropped:
        expected["widget"] = VALUES[reports]
    elif by_hand:
        expected["widget"] = "now"
    assert store.chosen() == expected


@pytest.mark.parametrize("others", [False, True])
def test_after_a_touch_nothing_was_shown_before(others):
    """What a person changed showed nothing before: to go back to it by hand is no echo, whoever reports beside it."""
    assert not is_echo("before", Shown("now"), by_hand=True, others=others)


def test_a_widget_that_merely_shows_what_it_shows_is_no_other_one():
    """The second row of others: beside widgets that nobody touched, to go back is a person's."""
    store.put("normalise", "paper")
    store.put("normalise", "none")
    store.put("horizon", 40.0)
    report(normalise="paper", horizon=40.0)
    assert store.chosen() == {"normalise": "paper"}


def test_the_last_report_of_a_widget_counts():
    """The first of two events was not looked at, because a third thing ended the run of the page."""
    store.show("alpha", 0.1)
    report(alpha=0.2)
    report(alpha=0.1)
    assert store.chosen() == {}


def test_a_touched_widget_is_kept():
    store.show("alpha", 0.1)
    report(alpha=0.2)
    assert store.chosen() == {"alpha": 0.2}


def test_what_merely_shows_what_it_showed_is_not():
    store.show("alpha", 0.1)
    store.put("horizon", 40.0)
    report(alpha=0.1, horizon=40.0)
    assert store.chosen() == {}


def test_a_remedy_is_not_undone_by_the_widget_that_still_shows_what_was_before():
    store.show("normalise", "paper")
    store.show("alpha", 0.1)
    store.apply_changes({"normalise": "none"})
    store.show("normalise", "paper")  # now none
    report(alpha=0.2, normalise="paper")  # alpha was moved before the browser had drawn the remedy
    assert store.chosen() == {"normalise": "none", "alpha": 0.2}


def test_alone_the_same_report_is_a_person_who_goes_back():
    store.show("normalise", "paper")
    store.apply_changes({"normalise": "none"})
    store.show("normalise", "paper")
    report(normalise="paper")
    assert store.chosen() == {"normalise": "paper"}


def test_going_back_at_once_to_what_was_shown_counts():
    store.show("alpha", 0.1)
    report(alpha=0.2)
    assert store.chosen() == {"alpha": 0.2}
    report(alpha=0.1)  # before the page was drawn again
    assert store.chosen() == {"alpha": 0.1}


def test_parameters_of_a_world_that_was_left_stay_behind():
    st.session_state["world"] = "cliff_grid"
    store.show("p.early", 2)
    actions.choose_world()
    report(**{"p.early": 2})
    assert store.chosen() == {"world": "cliff_grid"}


def test_going_back_and_forth_by_hand_is_never_an_echo():
    store.show("normalise", "none")
    store.put("horizon", 3.0)
    report(normalise="survival")
    store.show("normalise", "none")  # now survival
    report(normalise="none", horizon=3.0)  # back by hand, beside an echo
    assert store.chosen() == {"normalise": "none"}
    store.show("normalise", "none")
    store.show("alpha", 0.1)
    report(normalise="survival", alpha=0.2)  # both at once, one of them to what it showed before
    assert store.chosen() == {"normalise": "survival", "alpha": 0.2}
