"""A plotly chart that is updated in place.

``st.plotly_chart`` mounts a chart again, twice, whenever its figure changes, and loses zoom and camera. This
component keeps its div and hands every new figure to ``Plotly.react``.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import nullcontext

import streamlit as st
from streamlit.delta_generator import DeltaGenerator

from app.components import assets
from laplace_core.figures.theme import HEIGHT, Figure, to_json


def chart(
    figure: str | Figure, key: str, alt: str, height: int = HEIGHT, *, revision: str = "",
    on_click: Callable[[], None] | None = None, place: DeltaGenerator | None = None,
) -> None:  # fmt: skip
    """Draw a figure; the first custom datum of a point that is clicked is ``clicked`` in the state of ``chart KEY``.

    Args:
        figure: a plotly figure, or one as JSON.
        alt: what the picture shows, for those who cannot see it.
        height: pixels, reserved before anything is drawn so that the page does not jump.
        revision: zoom and camera are kept as long as this stays the same.
        on_click: called before the rerun; without it clicks are ignored.
        place: where to draw it; by default here.
    """
    data = {"figure": figure if isinstance(figure, str) else to_json(figure), "alt": alt, "height": height, "name": key}
    data |= {"revision": revision, "plotly": assets.plotly_js(), "clickable": on_click is not None}
    draw = assets.component("chart")
    with place or nullcontext():
        draw(key=f"chart {key}", data=data, on_clicked_change=on_click or _ignore, height="content")


def _ignore() -> None:
    """Streamlit wants a callback for every trigger that a component may report."""


def preload() -> None:
    """Let the browser fetch plotly.js while the server still computes the first figure; call it early."""
    address = f"new URL('{assets.module('chart/plotly.js')}', document.baseURI).href"
    loading = f"import({address}).then((module) => module.loadPlotly('{assets.plotly_js()}'))"
    st.html(f"<script>{loading}</script>", unsafe_allow_javascript=True)
