"""A button that copies a text to the clipboard, in the browser."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import streamlit as st

from app.components import assets


def copy_button(label: str, text: str, key: str) -> None:
    """Copy ``text`` on a click; where the browser allows no clipboard, show it to be copied by hand."""
    _component()(key=key, data={"label": label, "text": text})


@cache
def _component() -> Callable:
    return st.components.v2.component("laplace_copy", js=assets.stub("copy/copy.js"), isolate_styles=False)
