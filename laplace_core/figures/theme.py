"""Colours, layout and transport that every figure shares."""

from __future__ import annotations

import base64
import html
import json
from typing import Any

import numpy as np

Figure = dict[str, Any]
"""A plotly figure as a dictionary of data and layout."""
Trace = dict[str, Any]
"""One trace of a figure, or a part of its layout."""

# Six of Okabe and Ito's palette and two more: distinct to all, also with colour blindness, on light and on dark.
ACTION_COLOURS = ("#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#8B46FF", "#7A5C28")
HEIGHT = 292
NEUTRAL = "#8a8f98"

_VIRIDIS = ("#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725")
UNDER_RANGE = 0.25
"""Share of the positive limit that is drawn below zero, in magenta: negative probability must not look like none."""


def action_colour(action: int) -> str:
    return ACTION_COLOURS[action % len(ACTION_COLOURS)]


def translucent(colour: str, opacity: float = 0.22) -> str:
    """A ``#rrggbb`` colour as seen through."""
    red, green, blue = (int(colour[i : i + 2], 16) for i in (1, 3, 5))
    return f"rgba({red},{green},{blue},{opacity})"


def probability_scale() -> list[list[object]]:
    """Viridis from zero upwards, magenta below; for limits (-UNDER_RANGE * m, m)."""
    zero = UNDER_RANGE / (1.0 + UNDER_RANGE)
    last = len(_VIRIDIS) - 1
    above = [[zero + (1.0 - zero) * i / last, colour] for i, colour in enumerate(_VIRIDIS)]
    return [[0.0, "#d63af9"], [0.75 * zero, "#a01090"], *above]


def staircase(locations: np.ndarray, masses: np.ndarray, low: float, high: float) -> tuple[np.ndarray, np.ndarray]:
    """Corners of P(x at most this) from ``low`` to ``high``, to be drawn with the line shape 'hv'."""
    order = np.argsort(locations)
    places, below = locations[order], np.cumsum(masses[order]) / np.sum(masses)
    first, inside = below[places <= low][-1:].sum(), (places > low) & (places < high)
    reached = below[places <= high][-1:].sum()
    return np.concatenate([[low], places[inside], [high]]), np.concatenate([[first], below[inside], [reached]])


_AXIS = {"zeroline": False, "tickfont": {"size": 11}}


def in_plotly(text: object) -> str:
    """A text from outside for a label, legend, hover text or its custom data, shown exactly as it was typed.

    Plotly reads tags such as ``<b>`` and ``<a>`` in all of them, and fills in values at ``%{``.
    """
    return html.escape(str(text), quote=False).replace("%{", "&#37;{").replace("$", "&#36;")


def axis(title: str = "", **options: object) -> dict[str, Any]:
    """An axis in the common style; ``options`` go to plotly as they are."""
    return {**_AXIS, "title": {"text": title, "standoff": 4, "font": {"size": 12}}, **options}


def build(title: str, traces: list[dict[str, Any]], margin: dict[str, int] | None = None, **layout: object) -> Figure:
    """A figure in the common style, as a plain dictionary.

    Plotly's own classes validate every property again on each draw, which costs more than all the mathematics
    before it; a test does so once for every figure instead. The page fills in fonts and backgrounds.
    """
    common = {
        "title": {"text": f"<b>{title}</b>", "font": {"size": 14}, "x": 0.0, "y": 0.985, "yanchor": "top"},
        "height": HEIGHT,
        "margin": {"l": 48, "r": 8, "t": 34, "b": 36, **(margin or {})},
        "legend": {
            "orientation": "h",
            "x": 0.0,
            "xanchor": "left",
            "y": 1.0,
            "yanchor": "bottom",
            "font": {"size": 11},
            "traceorder": "normal",
        },
        "hoverlabel": {"align": "left"},
    }
    return {"data": traces, "layout": {**common, **layout}}


def to_json(figure: Figure) -> str:
    """The figure as plotly.js reads it, arrays packed."""
    return json.dumps(figure, default=_packed, allow_nan=False)


def _packed(value: object) -> object:
    """Large arrays as base64 of single floats, plotly's typed-array form; small ones, and numbers, as they are."""
    if isinstance(value, np.generic):
        return value.item()
    if not isinstance(value, np.ndarray):
        raise TypeError(f"a figure cannot hold {type(value).__name__}")
    if value.size < 32 or value.dtype.kind != "f":
        return value.tolist()
    data = base64.b64encode(np.ascontiguousarray(value, dtype="<f4").tobytes()).decode()
    return {"dtype": "f4", "bdata": data, "shape": ", ".join(map(str, value.shape))}
