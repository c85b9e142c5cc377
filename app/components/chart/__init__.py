"""A plotly chart that is updated in place.

``st.plotly_chart`` mounts a chart anew, twice, whenever its figure changes, and loses zoom and camera. This
component keeps its div and hands every new figure to ``Plotly.react``.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import streamlit as st

from app.components import assets


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
    data["plotly"] = assets.plotly_js()
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
    return st.components.v2.component("laplace_chart", js=assets.stub("chart/chart.js"), isolate_styles=False)


def preload() -> None:
    """Let the browser fetch plotly.js while the server still computes the first figure; call it early."""
    address = f"new URL('{assets.module('chart/plotly.js')}', document.baseURI).href"
    loading = f"import({address}).then((module) => module.loadPlotly('{assets.plotly_js()}'))"
    st.html(f"<script>{loading}</script>", unsafe_allow_javascript=True)
