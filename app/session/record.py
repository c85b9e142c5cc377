"""The record of one session (one tab of a browser), under one key of Streamlit's session state.

Streamlit's other keys are those of widgets. No other module puts anything into ``st.session_state`` under a name of
its own. What one part of a page has to remember, and nobody else asks for,
is a dataclass of that part (:func:`part`). This module knows no page.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, TypeVar

import streamlit as st

from laplace_core import InputError
from laplace_core.caching import BUDGET, Cache, weigh
from laplace_core.exchange.echoes import Shown
from laplace_core.exchange.messages import Channel

KEY = "session"
"""Of the record in ``st.session_state``."""

Kind = TypeVar("Kind")


@dataclass
class PageState:
    """The state of one page, kept while another one is shown.

    Attributes:
        chosen: values set by hand, by name.
        notes: what was left out of the link that the page was opened with.
        written: the link that the page has written into the address bar; None before the first time.
        worked: values set by hand that could be shown last.
    """

    chosen: dict[str, Any] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    written: dict[str, str] | None = None
    worked: dict[str, Any] = field(default_factory=dict)


@dataclass
class Session:
    """The record.

    Attributes:
        page: name of the page that is shown.
        pages: what is kept of each page, by its name.
        widgets: what each widget shows, by its key.
        reports: what widgets have reported, by their keys, since :func:`app.session.store.chosen` last looked.
        touched: whether a widget, and not the browser's Back, is behind this run. What the address bar says may then be
            a moment old.
        sidebar_stale: whether something that the sidebar shows was changed from the main area.
        refusals: why something that a person gave was not taken, by the key of the widget or form.
        opened: files that this session has opened, by their kind and digest; one of each kind.
        channels: to the components in the browser, by the key of their widgets.
        parts: see :func:`part`.
    """

    page: str = ""
    pages: dict[str, PageState] = field(default_factory=dict)
    widgets: dict[str, Shown] = field(default_factory=dict)
    reports: dict[str, Any] = field(default_factory=dict)
    touched: bool = False
    sidebar_stale: bool = False
    refusals: dict[str, str] = field(default_factory=dict)
    opened: dict[type, dict[str, Any]] = field(default_factory=dict)
    channels: dict[str, Channel] = field(default_factory=dict)
    parts: dict[type, Any] = field(default_factory=dict)

    @property
    def shown_page(self) -> PageState:
        return self.pages.setdefault(self.page, PageState())


def current() -> Session:
    """The record of the session that this code runs for."""
    if KEY not in st.session_state:
        st.session_state[KEY] = Session()
    record: Session = st.session_state[KEY]
    return record


def part(kind: type[Kind]) -> Kind:
    """The one object of a class that this session holds; the first call makes it, without arguments.

    The class has to live in a module and not in the script of a page, which Streamlit runs again every time.
    """
    parts = current().parts
    if kind not in parts:
        parts[kind] = kind()
    held: Kind = parts[kind]
    return held


def channel(widget: str) -> Channel:
    """The channel to the component with this key."""
    return current().channels.setdefault(widget, Channel())


def opened(kind: type[Kind]) -> Mapping[str, Kind]:
    """The file of a kind that this session has opened, by its digest; none or one."""
    return current().opened.get(kind, {})


_OPENED: Cache[object] = Cache("files that sessions have opened", 10_000, fixed=True)


def keep_opened(file: object, data: bytes) -> str:
    """Keep what was read from a file until the session ends, in place of the last one of its kind.

    Returns:
        the digest of ``data``.

    Raises:
        InputError: the files of all sessions together would take more than half of the server's memory for caches.
    """
    digest, record = hashlib.sha256(data).hexdigest()[:12], current()
    key, before = (id(record), type(file)), record.opened.get(type(file))
    _OPENED.drop_content(key)
    if not _OPENED.put(key, file) or BUDGET.fixed > BUDGET.limit // 2:
        _OPENED.pop(key)
        record.opened.pop(type(file), None)
        raise InputError(
            f"this file takes {weigh(file).bytes / 1e6:,.0f} MB, and the files that are open on this server may take "
            f"{BUDGET.limit / 2e6:,.0f} MB together: open a smaller one, or close other tabs that have opened one."
        )
    if before is None:
        BUDGET.drop_with_owner(record, _OPENED, key)
    record.opened[type(file)] = {digest: file}
    return digest
