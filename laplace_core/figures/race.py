"""Many races: the difference of every start."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from laplace_core.figures.theme import NEUTRAL, Figure, Trace, axis, build, in_plotly, translucent

if TYPE_CHECKING:  # it brings torch along, which no figure needs
    from laplace_core.acting.race import Races

_BINS = 36
_CURSOR = "#ff9f1c"


def differences(
    races: Races, mean: float, interval: tuple[float, float], start: int,
    *, colours: tuple[str, str], names: tuple[str, str],
) -> Figure:  # fmt: skip
    """A dot a start over its difference, right less left, piled up as a histogram; mean, interval, and zero.

    Args:
        start: the one that is shown above, ringed if it is among them.
        colours: of the left side, whose starts lie below 0, and of the right side; names: of both.
    """
    x = races.differences
    height, reach = piles(x)
    colour = np.where(x > 0, colours[1], np.where(x < 0, colours[0], NEUTRAL))
    size = float(np.clip(260.0 / reach, 4.0, 10.0))
    top = reach + 1.5
    hover = "start %{customdata[0]}: %{customdata[1]:.1f} v %{customdata[2]:.1f}<br>difference %{x:+.1f}"
    traces: list[Trace] = [
        {"type": "scatter", "x": [*interval, *interval[::-1]], "y": [0.0, 0.0, top, top], "fill": "toself",
         "mode": "lines", "line": {"width": 0}, "fillcolor": translucent(NEUTRAL), "hoverinfo": "skip",
         "name": "95% of the mean", "showlegend": True},
        {"type": "scatter", "x": [mean, mean], "y": [0.0, top], "mode": "lines", "name": "mean",
         "line": {"color": NEUTRAL, "width": 2.2}, "hoverinfo": "skip"},
        {"type": "scatter", "x": x, "y": height, "mode": "markers", "showlegend": False,
         "marker": {"color": colour.tolist(), "size": size},
         "customdata": np.column_stack([races.starts, races.left, races.right]).tolist(),
         "hovertemplate": hover + "<extra></extra>"},
    ]  # fmt: skip
    at = np.flatnonzero(races.starts == start)
    if at.size:
        traces.append(
            {"type": "scatter", "x": x[at], "y": height[at], "mode": "markers", "name": f"start {start}",
             "marker": {"color": "rgba(0,0,0,0)", "size": size + 5, "line": {"color": _CURSOR, "width": 2.4}},
             "hoverinfo": "skip"}
        )  # fmt: skip
    zero = {"type": "line", "x0": 0, "x1": 0, "yref": "paper", "y0": 0, "y1": 1,
            "line": {"color": NEUTRAL, "width": 1.2, "dash": "dot"}}  # fmt: skip
    return build(
        "difference of return, one dot for each start",
        traces,
        margin={"t": 54},
        shapes=[zero],
        hovermode="closest",
        xaxis=axis(in_plotly(f"{names[1]} less {names[0]} (reward)")),
        yaxis=axis("starts", range=[0.0, top], rangemode="tozero"),
    )


def piles(x: np.ndarray) -> tuple[np.ndarray, int]:
    """The height of each dot, ``(N,)``, from 1: its rank among those of its bin; and the largest height."""
    low, high = float(x.min()), float(x.max())
    width = (high - low) / _BINS or 1.0
    bins = np.minimum(((x - low) / width).astype(int), _BINS - 1)
    height = np.empty(len(x), dtype=float)
    for one in np.unique(bins):
        members = np.flatnonzero(bins == one)
        height[members[np.argsort(x[members], kind="stable")]] = 1.0 + np.arange(members.size)
    return height, int(height.max())
