"""Two spaces on one grid, and their difference."""

from __future__ import annotations

import numpy as np

from app.figures.theme import UNDER_RANGE, Figure, axis, build, probability_scale
from laplace_core.compare import Difference

_DIVERGING = [[0.0, "#2166ac"], [0.25, "#92c5de"], [0.5, "rgba(140,140,140,0)"], [0.75, "#f4a582"], [1.0, "#b2182b"]]
_LABELLED = 9  # rows that get a tick


def comparison(found: Difference) -> dict[str, Figure]:
    """Maps of A, of B (one colour scale) and of B - A (zero in the middle)."""
    a, b, change = found.a, found.b, found.difference
    limit = max(float(a.max()), float(b.max())) or 1.0
    widest = float(np.abs(change).max()) or 1.0
    common = {"colorscale": probability_scale(), "zmin": -UNDER_RANGE * limit, "zmax": limit}
    diverging = {"colorscale": _DIVERGING, "zmin": -widest, "zmax": widest}
    return {
        "A": _map("A", found, a, common),
        "B": _map("B", found, b, common),
        "B - A": _map("B - A", found, change, diverging),
    }


def _map(name: str, found: Difference, values: np.ndarray, scale: dict[str, object]) -> Figure:
    tau = found.what == "tau_space"
    unit, rows = ("probability", "future step tau") if tau else ("discounted steps", "discount gamma")
    bar = {"thickness": 8, "len": 1.0, "x": 1.01, "xpad": 0, "tickfont": {"size": 10}, "nticks": 5}
    hover = f"theta %{{x:.3g}}<br>{rows} %{{customdata:.4g}}<br>%{{z:.3g}}<extra></extra>"
    heat = {
        "type": "heatmap",
        "x": found.columns,
        "y": np.arange(len(found.rows)),
        "z": values,
        "customdata": np.repeat(found.rows[:, None], values.shape[1], axis=1),
        "hovertemplate": hover,
        "colorbar": {**bar, "title": {"text": unit, "side": "right", "font": {"size": 10}}},
        **scale,
    }
    ticks = np.unique(np.linspace(0, len(found.rows) - 1, min(_LABELLED, len(found.rows))).round().astype(int))
    labels = [f"{found.rows[i]:.3g}" for i in ticks]
    return build(
        name,
        [heat],
        showlegend=False,
        xaxis=axis("sensitivity theta (reward)", showgrid=False),
        yaxis=axis(rows, showgrid=False, tickvals=ticks, ticktext=labels, range=[-0.5, len(found.rows) - 0.5]),
    )
