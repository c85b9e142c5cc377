"""Two spaces on one grid, and their difference."""

from __future__ import annotations

import numpy as np

from laplace_core.figures.theme import UNDER_RANGE, Figure, Trace, axis, build, probability_scale
from laplace_core.study.compare import Difference

_DIVERGING = [[0.0, "#2166ac"], [0.25, "#92c5de"], [0.5, "rgba(140,140,140,0)"], [0.75, "#f4a582"], [1.0, "#b2182b"]]
_LABELLED = 9  # rows that get a tick
MOST_ROWS, MOST_COLUMNS = 240, 400
"""Cells of a map, about as many as it has pixels on a screen."""


def comparison(difference: Difference) -> dict[str, Figure]:
    """Maps of A, of B (one colour scale) and of B - A (zero in the middle).

    Where there are more values than pixels, a cell of each map shows the one of its own block that is farthest from 0,
    and its place: see :func:`thinning`.
    """
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


def thinning(difference: Difference) -> str:
    """A sentence about the cells of the maps; empty if a cell is a single value."""
    high, wide = _block(difference.a.shape)
    if (high, wide) == (1, 1):
        return ""
    return f"Each cell shows one of {high} x {wide} values, the one farthest from 0; point at it for its place."


def _block(shape: tuple[int, ...]) -> tuple[int, int]:
    """Rows and columns of which one value is drawn."""
    return -(-shape[0] // MOST_ROWS), -(-shape[1] // MOST_COLUMNS)


def farthest(values: np.ndarray, block: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Row and column of the value of each block that is farthest from 0, int ``(k, m)`` each, from ``(K, M)``.

    The first one where several are equally far. The last blocks may be smaller.
    """
    (rows, columns), (high, wide) = values.shape, block
    down, across = -(-rows // high), -(-columns // wide)
    sizes = np.full((down * high, across * wide), -1.0)
    sizes[:rows, :columns] = np.abs(values)
    blocks = sizes.reshape(down, high, across, wide).swapaxes(1, 2).reshape(down, across, high * wide)
    at = blocks.argmax(axis=-1)
    return np.arange(down)[:, None] * high + at // wide, np.arange(across) * wide + at % wide


def _centres(places: np.ndarray, size: int) -> np.ndarray:
    """Where blocks of a size are drawn: the mean of their places."""
    firsts = np.arange(0, len(places), size)
    return np.add.reduceat(places, firsts) / np.diff(np.append(firsts, len(places)))


def _map(name: str, difference: Difference, values: np.ndarray, scale: Trace) -> Figure:
    tau = difference.what == "tau_space"
    unit, rows = ("probability", "future step tau") if tau else ("discounted steps", "discount gamma")
    bar = {"thickness": 8, "len": 1.0, "x": 1.01, "xpad": 0, "tickfont": {"size": 10}, "nticks": 5}
    hover = f"theta %{{customdata[1]:.3g}}<br>{rows} %{{customdata[0]:.4g}}<br>%{{z:.3g}}<extra></extra>"
    places, across = _columns(difference.columns)
    block = _block(values.shape)
    row, column = farthest(values, block)
    heat = {
        "type": "heatmap",
        "x": _centres(places, block[1]),
        "y": _centres(np.arange(len(difference.rows)), block[0]),
        "z": values[row, column],
        "customdata": np.stack([difference.rows[row], difference.columns[column]], axis=-1),
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
