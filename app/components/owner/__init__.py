"""Keeps the word of :mod:`app.session.owner` in the browser, as a cookie of this site; it draws nothing."""

from __future__ import annotations

import streamlit as st

from app.components import assets
from app.session import owner

_KEY = "owner"


def keep_owner() -> None:
    """Hand the word to the browser, unless it has one: then that one is taken."""
    assets.component(_KEY)(key=_KEY, data={"name": owner.COOKIE, "word": owner.word()}, on_word_change=_told)


def _told() -> None:
    """Callback."""
    owner.take(st.session_state[_KEY].word)
