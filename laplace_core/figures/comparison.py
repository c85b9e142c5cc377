"""Two spaces on one grid, and their difference."""

from __future__ import annotations

import numpy as np

from laplace_core.figures.theme import UNDER_RANGE, Figure, Trace, axis, build, probability_scale
from laplace_core.study.compare import Difference

_DIVERGING = [[0.0, "#2166ac"], [0.25, "#92c5de"], [0.5, "rgba(140,140,140,0)"], [0.75, "#f4a582"], [1.0, "#b2182b"]]
_LABELLED = 9  # rows that get a tick


def comparison(difference: Difference) -> dict[str, Figure]:
    """Maps of A, of B (one colour scale) and of B - A (zero in the middle)."""
    a, b, change = difference.a, difference.b, difference.difference
    limit = max(float(a.max()), float(b.max())) or 1.0
    widest = float(np.abs(change).max()) or 1.0
    common = {"colorscale": probability_scale(), "zmin": -UNDER_RANGE * limit, "zmax": limit}
    diverging = {"colorscale": _DIVERGING, "zmin": -widest, "zmax": widest}
    return {
        "A": _map("A", difference, a, common),
        "B": _map("B", difference, b, common),
        "B - A": _map("B - A", difference, change, diverging),
    }


def _map(name: str, difference: Difference, values: np.ndarray, scale: Trace) -> Figure:
    tau = difference.what == "tau_space"
    unit, rows = ("probability", "future step tau") if tau else ("discounted steps", "discount gamma")
    bar = {"thickness": 8, "len": 1.0, "x": 1.01, "xpad": 0, "tickfont": {"size": 10}, "nticks": 5}
    hover = f"theta %{{customdata[1]:.3g}}<br>{rows} %{{customdata[0]:.4g}}<br>%{{z:.3g}}<extra></extra>"
    places, across = _columns(difference.columns)
    heat = {
        "type": "heatmap",
        "x": places,
        "y": np.arange(len(difference.rows)),
        "z": values,
        "customdata": np.stack(np.meshgrid(difference.rows, difference.columns, indexing="ij"), axis=-1),
        "hovertemplate": hover,
        "colorbar": {**bar, "title": {"text": unit, "side": "right", "font": {"size": 10}}},
        **scale,
    }
    ticks = np.unique(
        np.linspace(0, len(difference.rows) - 1, min(_LABELLED, len(difference.rows))).round().astype(int)
    )
    labels = [f"{difference.rows[i]:.3g}" for i in ticks]
    return build(
        name,
        [heat],
        showlegend=False,
        xaxis=axis("sensitivity theta (reward)", showgrid=False, **across),
        yaxis=axis(rows, showgrid=False, tickvals=ticks, ticktext=labels, range=[-0.5, len(difference.rows) - 0.5]),
    )


def _columns(thetas: np.ndarray) -> tuple[np.ndarray, Trace]:
    """Where columns are drawn, ``(M,)``, and how that axis is labelled: all are equally wide, as in the lens.

    Of unevenly spaced ones the labels are 0 and the powers of ten between the outermost.
    """
    steps = np.diff(thetas)
    if steps.size < 2 or np.allclose(steps, steps[0], rtol=1e-3):
        return thetas, {}
    places = np.arange(thetas.size)
    powers = 10.0 ** np.arange(-2, 7)
    ticks = np.concatenate([-powers, [0.0], powers])
    ticks = ticks[(ticks > thetas[0]) & (ticks < thetas[-1])]
    at = np.interp(ticks, thetas, places)
    # From the middle outwards, so that 0 stays and what would be written over it does not.
    labelled: list[int] = []
    for i in np.argsort(np.abs(ticks), kind="stable"):
        if all(abs(at[i] - at[j]) > thetas.size / 10 for j in labelled):
            labelled.append(int(i))
    labelled.sort()
    return places, {"tickvals": at[labelled], "ticktext": [f"{ticks[i]:g}" for i in labelled]}
