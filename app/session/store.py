"""The values that the user has set on a page: kept in the session, written to and read from the URL.

Only values that were set by hand (or by a link, a remedy, a preset view) are kept; everything else follows the
world or the agent. So a link holds what matters, and a changed world brings its own defaults along. This module knows
no page: what it may hold, a page says by its schema (:mod:`laplace_core.exchange.links`).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import streamlit as st

from app import session
from app.session.typed import in_markdown
from laplace_core.exchange.echoes import Shown, touches
from laplace_core.exchange.links import Schema, fits, query_of


def page_name() -> str:
    return session.current().page


def without(*names: str) -> dict[str, Any]:
    """Values set by hand, but for some."""
    return {name: value for name, value in chosen().items() if name not in names}


def chosen() -> dict[str, Any]:
    """Values set by hand, by name."""
    record = session.current()
    values = record.shown_page.chosen
    reports, record.reports = record.reports, {}
    for name, value in touches(reports, record.widgets, values).items():
        values[name] = value
        record.widgets[name] = Shown(value)
    return values


def keep(name: str) -> None:
    """Callback of the widget with key ``name``: its value is now set by hand, unless it is an echo."""
    session.current().reports[name] = st.session_state[name]
    _touch()


def choose(name: str, value: object) -> None:
    """Set a value by hand that no widget of that name holds; None takes it back."""
    if value is None:
        chosen().pop(name, None)
    else:
        chosen()[name] = value
    _touch()


def apply_changes(changes: Mapping[str, object]) -> None:
    """Set values by hand that the sidebar shows, from the main area; None takes one back."""
    for name, value in changes.items():
        choose(name, value)
    refresh_sidebar()


def replace_all(values: Mapping[str, Any]) -> None:
    """Replace all values."""
    session.current().shown_page.chosen = dict(values)
    _touch()


def begin_anew(name: str) -> None:
    """Callback of the widget with key ``name``: its value is all that is set by hand."""
    replace_all({name: st.session_state[name]})


def _touch() -> None:
    session.current().touched = True


def worked() -> None:
    """What is set now can be shown: it is what :func:`undo` returns to."""
    session.current().shown_page.worked = dict(chosen())


def undo() -> None:
    """Callback: back to the last settings that could be shown."""
    replace_all(session.current().shown_page.worked)
    refresh_sidebar()


def refresh_sidebar() -> None:
    """Something that the sidebar shows was changed from the main area: the whole page is to be drawn again."""
    session.current().sidebar_stale = True
    _touch()


def sidebar_is_stale() -> bool:
    return session.current().sidebar_stale


def show(name: str, value: object) -> str:
    """Put the present value into the widget ``name``: the value set by hand, else ``value``. Returns the key."""
    return put(name, chosen().get(name, value))


def put(name: str, value: object) -> str:
    """Put a value into the widget ``name``, and remember what it shows and showed before. Returns the key."""
    st.session_state[name] = value
    widgets = session.current().widgets
    widgets[name] = widgets.get(name, Shown()).then(value)
    return name


def open_page(page: str, schema: Schema) -> None:
    """The top of a page's script: its values, and a note about everything that its link holds in vain.

    Values come from the URL when a page is opened by a link and when the browser goes back or forward. A page that is
    come back to from another one is as it was left.
    """
    record = session.current()
    query = {name: st.query_params[name] for name in st.query_params}
    arrived, new = record.page != page, page not in record.pages
    record.page = page
    if arrived:
        record.reports.clear()  # of widgets of the page that was left
    if new:
        record.pages[page] = session.PageState(worked=dict(schema.opening()))
    kept = record.shown_page
    moved = not arrived and query != kept.written and not record.touched
    if new or moved or (arrived and query):
        kept.chosen, kept.notes = schema.read(query) if query else (dict(schema.opening()), [])
    record.sidebar_stale = False
    for note in kept.notes:
        st.warning(in_markdown(note))


def clamp(name: str, last: int) -> None:
    """Put a value that lies beyond the end of what is shown to the end, and say so: only a link can have brought it."""
    asked = chosen().get(name)
    if asked is not None and int(asked) > last:
        note = f"The link has {name} {asked:,}, which is beyond the end: {last:,} is shown."
        session.current().shown_page.notes.append(note)
        choose(name, last)
        write_url()
        st.warning(in_markdown(note))


def write_url() -> None:
    """Make the address bar a link to what is seen, or leave it empty where that would be too long for a link."""
    query, record = query_of(chosen()), session.current()
    if not fits(query):
        query = {}
    if dict(st.query_params) != query:
        st.query_params.from_dict(query)
    record.shown_page.written, record.touched = query, False
