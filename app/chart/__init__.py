"""A plotly chart that is updated in place.

``st.plotly_chart`` mounts a chart anew, twice, whenever its figure changes, and loses zoom and camera. This
component keeps its div and hands every new figure to ``Plotly.react``.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from pathlib import Path

import streamlit as st

from app.served import plotly_js

_HERE = Path(__file__).resolve().parent


def chart(
    figure: str,
    key: str,
    alt: str,
    height: int,
    *,
    revision: str = "",
    on_click: Callable[[], None] | None = None,
) -> object | None:
    """Draw a figure and return the first custom datum of a point that was clicked just now, if any.

    Args:
        figure: a plotly figure as JSON.
        alt: what the picture shows, for those who cannot see it.
        height: pixels, reserved before anything is drawn so that the page does not jump.
        revision: zoom and camera are kept as long as this stays the same.
        on_click: called before the rerun; without it clicks are ignored.
    """
    data = {"figure": figure, "alt": alt, "height": height, "revision": revision, "name": key}
    result = _component()(
        key=f"chart {key}",
        data={**data, "clickable": on_click is not None},
        on_clicked_change=on_click or _ignore,
        height="content",
    )
    return result.clicked


def _ignore() -> None:
    """Streamlit wants a callback for every trigger that a component may report."""


@cache
def _component() -> Callable:
    return st.components.v2.component("laplace_chart", js=loading() + script("plot", "chart"), isolate_styles=False)


def preload() -> None:
    """Let the browser fetch plotly.js while the server still computes the first figure; call it early."""
    st.html(f"<script>{loading()}</script>", unsafe_allow_javascript=True)


@cache
def loading() -> str:
    """A script that loads plotly.js once for a page."""
    return script("load").replace("__ADDRESS__", plotly_js())


@cache
def script(*names: str) -> str:
    """Modules of this folder as one, the default export last: their imports from each other fall away."""
    return joined("\n".join((_HERE / f"{name}.js").read_text(encoding="utf-8") for name in names))


def joined(lines: str) -> str:
    """Modules written one after the other, as one."""
    lines = re.sub(r"^import .*? from '[./a-z]*';\n", "", lines, flags=re.MULTILINE)
    return re.sub(r"^export (?!default)", "", lines, flags=re.MULTILINE)
