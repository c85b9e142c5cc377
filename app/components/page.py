"""What every page begins with: its title in the browser, its heading, and a link that skips to its picture."""

from __future__ import annotations

import json
from html import escape

import streamlit as st

from app.components import assets

NAME = "Laplace code workbench"


def begin(title: str, *, skip: str, heading: bool = True) -> None:
    """Name the page and give its readers a way past the sidebar.

    Args:
        title: of the page, before the name of the workbench.
        skip: words of the link that the Tab key reaches first.
        heading: whether the page needs a heading of the first level; it is unseen, as the navigation shows the same.
    """
    st.set_page_config(page_title=f"{title} · {NAME}")
    address = f"new URL('{assets.module('skip/skip.js')}', document.baseURI).href"
    linked = f"<script>import({address}).then((module) => module.skipLink({json.dumps(skip)}))</script>"
    unseen = f'<h1 class="unseen">{escape(title)}</h1>' if heading else ""
    st.html(unseen + linked, unsafe_allow_javascript=True)
