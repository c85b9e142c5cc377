"""A plotly chart that is updated in place.

``st.plotly_chart`` mounts a chart anew, twice, whenever its figure changes, and loses zoom and camera. This
component keeps its div and hands every new figure to ``Plotly.react``.
"""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable
from functools import cache
from pathlib import Path

import plotly
import streamlit as st

_HERE = Path(__file__).resolve().parent
_SERVED = _HERE.parent / "static" / "plotly.min.js"


def chart(
    figure: str,
    key: str,
    alt: str,
    height: int,
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
    return st.components.v2.component("laplace_chart", js=script("load", "plot", "chart"), isolate_styles=False)


def preload() -> None:
    """Let the browser fetch plotly.js while the server still computes the first figure; call it early."""
    publish_plotly_js()
    st.html(f"<script>{script('load')}</script>", unsafe_allow_javascript=True)


@cache
def script(*names: str) -> str:
    """Modules of this folder as one, the default export last: their imports from each other fall away."""
    return joined("\n".join((_HERE / f"{name}.js").read_text(encoding="utf-8") for name in names))


def joined(lines: str) -> str:
    """Modules written one after the other, as one."""
    lines = re.sub(r"^import .*? from '[./a-z]*';\n", "", lines, flags=re.MULTILINE)
    return re.sub(r"^export (?!default)", "", lines, flags=re.MULTILINE)


def publish_plotly_js() -> None:
    """Put the plotly.js of the installed plotly package where Streamlit serves it from.

    On a read-only file system this is done beforehand (``python -m app.chart``).
    """
    source = Path(plotly.__file__).parent / "package_data" / "plotly.min.js"
    if _SERVED.exists() and _SERVED.stat().st_size == source.stat().st_size:
        return
    _SERVED.parent.mkdir(exist_ok=True)
    partial = _SERVED.with_suffix(".part")
    shutil.copyfile(source, partial)
    partial.replace(_SERVED)
