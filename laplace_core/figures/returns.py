"""Return distributions of trained agents: of every action, along an episode, and agent by agent, with observed ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from laplace_core.figures.theme import (
    ACTION_COLOURS,
    NEUTRAL,
    Figure,
    Trace,
    action_colour,
    axis,
    build,
    in_plotly,
    staircase,
    translucent,
)

if TYPE_CHECKING:  # it brings torch along, which no figure needs
    from laplace_core.acting.return_laws import ReturnLaw, SimulatedReturns

OBSERVED = "#d6336c"
_LEARNED = ACTION_COLOURS[0]
_ROW, _GAP, _TOP, _BOTTOM = 84, 30, 46, 40  # pixels
BOOTSTRAPPED = 0.05
"""Weight of the bootstrap value in the return of a truncated episode above which the return is drawn dotted."""
_TAIL = 0.002  # mass at either end of a law that the axis need not reach


@dataclass(frozen=True, eq=False)
class ReturnRow:
    """One agent: the return law that it has learned, and the observed returns of its own policy, if there are any."""

    name: str
    law: ReturnLaw
    observed: SimulatedReturns | None = None


def rows_height(count: int) -> int:
    """Pixels of :func:`returns_side_by_side`."""
    return _TOP + count * _ROW + (count - 1) * _GAP + _BOTTOM


def returns_side_by_side(rows: Sequence[ReturnRow]) -> Figure:
    """P(return at most x), a panel an agent: learned and observed, the area between them, which is W1, shaded.

    The band around the observed law is two standard errors of a share of N.
    """
    laws = [(row.law.locations, row.law.masses) for row in rows] + [row.observed.law for row in rows if row.observed]
    low, high = _range(laws)
    height = rows_height(len(rows)) - _TOP - _BOTTOM
    traces, layout, words = [], {}, []
    for i, row in enumerate(rows):
        number = "" if i == 0 else str(i + 1)
        place, first, name = {"xaxis": "x", "yaxis": f"y{number}"}, i == 0, in_plotly(row.name)
        top = 1.0 - i * (_ROW + _GAP) / height
        layout[f"yaxis{number}"] = axis("", domain=[max(0.0, top - _ROW / height), top], range=[-0.04, 1.04],
                                        tickvals=[0, 0.5, 1])  # fmt: skip
        words.append({"text": f"<b>{name}</b>", "x": 0.0, "xref": "paper", "xanchor": "left", "y": top,
                      "yref": "paper", "yanchor": "bottom", "showarrow": False, "font": {"size": 12}})  # fmt: skip
        if row.observed is not None:
            words.append({"text": f"W1 {row.observed.distance(row.law):.3g}", "x": 1.0, "xref": "paper",
                          "xanchor": "right", "y": top, "yref": "paper", "yanchor": "bottom", "showarrow": False,
                          "font": {"size": 12}})  # fmt: skip
            traces += _observed(row.observed, low, high, place, first=first)
        x, y = staircase(row.law.locations, row.law.masses, low, high)
        fill = {"fill": "tonexty", "fillcolor": translucent(_LEARNED, 0.16)} if row.observed is not None else {}
        traces.append({
            "type": "scatter", "x": x, "y": y, "mode": "lines", "name": "learned", "showlegend": first,
            "line": {"color": _LEARNED, "width": 2, "shape": "hv"}, **fill, **place,
            "hovertemplate": f"{name}<br>learned: return at most %{{x:.3g}}: %{{y:.0%}}<extra></extra>",
        })  # fmt: skip
        traces.append(_mean_mark(row.law.mean, _LEARNED, f"{name}<br>learned mean", place))
        if row.observed is not None:
            traces.append(_mean_mark(row.observed.mean[0], OBSERVED, f"{name}<br>observed mean", place))
    return build(
        "",
        traces,
        margin={"l": 36, "t": _TOP, "b": _BOTTOM},
        height=height + _TOP + _BOTTOM,
        legend={"orientation": "h", "x": 0.0, "xanchor": "left", "y": 1.0 + 22 / height, "yanchor": "bottom",
                "font": {"size": 11}, "traceorder": "normal"},
        annotations=words,
        xaxis=axis("discounted return x, in reward", range=[low, high],
                   anchor=f"y{len(rows)}" if len(rows) > 1 else "y"),
        **layout,
    )  # fmt: skip


def _observed(observed: SimulatedReturns, low: float, high: float, place: Trace, *, first: bool) -> list[Trace]:
    """The observed law and its band; the next trace may fill up to it."""
    x, y = staircase(*observed.law, low, high)
    count = len(observed.returns)
    error = 2.0 * np.sqrt(np.clip(y * (1.0 - y), 0.0, None) / count)
    common = {"type": "scatter", "x": x, "mode": "lines", **place}
    edge = {**common, "line": {"width": 0, "shape": "hv"}, "hoverinfo": "skip", "showlegend": False}
    name = f"observed ({count} times)" if count > 1 else "observed (always)"
    band = [
        {**edge, "y": np.clip(y - error, 0.0, 1.0)},
        {**edge, "y": np.clip(y + error, 0.0, 1.0), "fill": "tonexty", "fillcolor": translucent(OBSERVED, 0.25)},
    ]
    line = {**common, "y": y, "name": name, "showlegend": first,
            "line": {"color": OBSERVED, "width": 1.6, "shape": "hv"},
            "hovertemplate": "observed: return at most %{x:.3g}: %{y:.0%}<extra></extra>"}  # fmt: skip
    return [*(band if count > 1 else []), line]


def _mean_mark(mean: float, colour: str, words: str, place: Trace) -> Trace:
    """A small triangle on the zero line."""
    return {"type": "scatter", "x": [mean], "y": [0.0], "mode": "markers", "showlegend": False, "cliponaxis": False,
            "marker": {"symbol": "triangle-up", "size": 9, "color": colour}, **place,
            "hovertemplate": f"{words} %{{x:.4g}}<extra></extra>"}  # fmt: skip


def _range(laws: Sequence[tuple[np.ndarray, np.ndarray]]) -> tuple[float, float]:
    """A range that holds nearly all the mass of every law, and a little room."""
    ends = []
    for locations, masses in laws:
        below = np.cumsum(masses) / np.sum(masses)
        inside = locations[np.searchsorted(below, [_TAIL, 1.0 - _TAIL]).clip(max=len(locations) - 1)]
        ends.append(inside)
    low, high = float(np.min(ends)), float(np.max(ends))
    room = 0.04 * (high - low) or 0.5
    return low - room, high + room


def returns_of_actions(laws: Sequence[ReturnLaw], names: Sequence[str], highlighted: int) -> Figure:
    """P(return at most x) after every action, as learned, with the means; the highlighted action is heavier."""
    low, high = _range([(law.locations, law.masses) for law in laws])
    traces, names = [], [in_plotly(name) for name in names]
    for a, (law, name) in enumerate(zip(laws, names, strict=True)):
        x, y = staircase(law.locations, law.masses, low, high)
        traces.append({
            "type": "scatter", "x": x, "y": y, "mode": "lines", "name": name,
            "line": {"color": action_colour(a), "width": 3 if a == highlighted else 1.6, "shape": "hv"},
            "hovertemplate": f"{name}<br>return at most %{{x:.3g}}: %{{y:.0%}}<extra></extra>",
        })  # fmt: skip
    for a, (law, name) in enumerate(zip(laws, names, strict=True)):
        traces.append(_mean_mark(law.mean, action_colour(a), f"{name}<br>mean", {}))
    return build(
        f"learned return of every action, γ {laws[0].gamma:g}",
        traces,
        margin={"l": 52, "t": 52},
        xaxis=axis("discounted return x, in reward", range=[low, high]),
        yaxis=axis("P(return ≤ x)", range=[-0.04, 1.04]),
    )


def values_of_actions(values: np.ndarray, names: Sequence[str], gamma: float, highlighted: int) -> Figure:
    """A bar an action: ``values`` ``(A,)``, discounted returns."""
    names = [in_plotly(name) for name in names]
    edges = [{"width": 2.5 if a == highlighted else 0, "color": NEUTRAL} for a in range(len(names))]
    bars = [
        {"type": "bar", "orientation": "h", "x": [value], "y": [name], "showlegend": False,
         "marker": {"color": action_colour(a), "line": edges[a]}, "text": [f"{value:.4g}"], "cliponaxis": False,
         "hovertemplate": f"{name}<br>%{{x:.4g}}<extra></extra>"}
        for a, (value, name) in enumerate(zip(values, names, strict=True))
    ]  # fmt: skip
    low, high = min(0.0, float(np.min(values))), max(0.0, float(np.max(values)))
    return build(
        f"learned value of every action, γ {gamma:g}",
        bars,
        margin={"l": 92, "t": 40},
        bargap=0.45,
        xaxis=axis("expected discounted return, in reward", range=[1.12 * low, 1.12 * high] if high > low else [0, 1]),
        yaxis=axis("", autorange="reversed"),
    )


def values_over_time_to_go(values: np.ndarray, names: Sequence[str], gamma: float, left: int | None) -> Figure:
    """Values ``(T, A)`` of a fixed-horizon agent over T = 1, 2, ..., and the T of the step under the cursor."""
    horizons = np.arange(1, len(values) + 1)
    traces = [
        {"type": "scatter", "x": horizons, "y": values[:, a], "mode": "lines", "name": name,
         "line": {"color": action_colour(a), "width": 2},
         "hovertemplate": f"{name}<br>T %{{x}}: %{{y:.4g}}<extra></extra>"}
        for a, name in enumerate(map(in_plotly, names))
    ]  # fmt: skip
    return build(
        f"learned value of the next T steps, γ {gamma:g}",
        traces,
        margin={"l": 52, "t": 52},
        shapes=[] if left is None else [_cursor(left)],
        xaxis=axis("time to go T (steps)"),
        yaxis=axis("value, in reward"),
    )


def returns_over_episode(
    observed: np.ndarray,
    predicted: np.ndarray,
    quantiles: np.ndarray | None,
    step: int,
    *,
    gamma: float,
    truncated: bool,
) -> Figure:
    """Predicted and observed discounted return of the action taken at each step.

    Args:
        observed, predicted: ``(N,)``.
        quantiles: ``(N, 5)`` at 10, 25, 50, 75 and 90%, drawn as two bands; None for a mean alone.
        step: under the cursor.
        truncated: whether the episode was truncated, so that observed returns are bootstrapped from the agent's value;
            where that value has more than ``BOOTSTRAPPED`` of the weight, the line is dotted.
    """
    steps, traces = np.arange(len(observed)), []
    for outer, share, opacity in ((0, 80, 0.14), (1, 50, 0.22)):
        if quantiles is None:
            break
        edge = np.concatenate([quantiles[:, -1 - outer], quantiles[::-1, outer]])
        traces.append({
            "type": "scatter", "x": np.concatenate([steps, steps[::-1]]), "y": edge, "fill": "toself", "mode": "lines",
            "fillcolor": translucent(_LEARNED, opacity), "line": {"width": 0}, "hoverinfo": "skip",
            "name": f"{share}%",
        })  # fmt: skip
    bootstrapped = truncated & (gamma ** (len(observed) - steps) > BOOTSTRAPPED)
    lines = [
        ("predicted", steps, predicted, _LEARNED, "solid"),
        ("observed", steps[~bootstrapped], observed[~bootstrapped], OBSERVED, "solid"),
    ]
    if bootstrapped.any():
        lines.append(("observed, then bootstrap", steps[bootstrapped], observed[bootstrapped], OBSERVED, "dot"))
    for name, x, y, colour, dash in lines:
        traces.append({
            "type": "scatter", "x": x, "y": y, "mode": "lines", "name": name,
            "line": {"color": colour, "width": 1.8, "dash": dash},
            "hovertemplate": f"step %{{x}}<br>{name} %{{y:.4g}}<extra></extra>",
        })  # fmt: skip
    return build(
        f"along the episode, action taken, γ {gamma:g}",
        traces,
        margin={"l": 52, "t": 52},
        shapes=[_cursor(step, "#ff9f1c")],
        xaxis=axis("step of the episode"),
        yaxis=axis("discounted return, in reward"),
    )


def _cursor(at: float, colour: str = NEUTRAL) -> Trace:
    line = {"color": colour, "width": 1.8, "dash": "dash" if colour == NEUTRAL else "solid"}
    return {"type": "line", "x0": at, "x1": at, "y0": 0, "y1": 1, "xref": "x", "yref": "paper", "line": line}
