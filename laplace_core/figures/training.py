"""Figures of training: returns over steps, run beside run, and predicted and observed returns at every discount."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from laplace_core.figures.theme import NEUTRAL, Figure, Trace, axis, build, in_plotly, translucent
from laplace_core.training.curves import Curves

TALL, CARD = 330, 132
_MANY = 200  # episodes, which would hide what lies behind them
_LEGEND = {
    "orientation": "v", "x": 1.0, "xanchor": "right", "y": 0.0, "yanchor": "bottom", "font": {"size": 10},
    "tracegroupgap": 0, "bgcolor": "rgba(128,128,128,0.12)",  # the page paints it in its own colour
}  # fmt: skip
_BARE = {"showticklabels": False, "showgrid": False}
_SHADES = ("#4f6bdc", "#2a9d8f", "#e0a030", "#d1495b")
"""From the smallest discount to the largest: of middling lightness, to be read on light and on dark."""


@dataclass(frozen=True, eq=False)
class Line:
    """One run in a figure."""

    name: str
    colour: str
    curves: Curves


class Scored(Protocol):
    """Evaluations of one seed while it was trained; see :class:`laplace_core.experiments.shipping.TrainingCurve`."""

    @property
    def seed(self) -> int: ...

    @property
    def steps(self) -> Sequence[float]: ...

    @property
    def scores(self) -> Sequence[float]: ...

    @property
    def errors(self) -> Sequence[float]: ...


@dataclass(frozen=True, eq=False)
class Band:
    """Evaluations of several seeds as they are drawn: their median between the lowest and the highest, ``(N,)``."""

    name: str
    colour: str
    steps: np.ndarray
    lowest: np.ndarray
    median: np.ndarray
    highest: np.ndarray

    @classmethod
    def of(cls, name: str, colour: str, curves: Sequence[Scored]) -> Band:
        """Seeds are evaluated a few steps apart: all are read, linearly, at the steps of the one that ends first."""
        steps = np.asarray(min((curve.steps for curve in curves), key=lambda steps: steps[-1]), dtype=float)
        scores = np.array([np.interp(steps, curve.steps, curve.scores) for curve in curves])
        return cls(name, colour, steps, scores.min(axis=0), np.median(scores, axis=0), scores.max(axis=0))


def learning_curves(title: str, lines: Sequence[Line], steps: int, shipped: Sequence[Band] = ()) -> Figure:
    """Returns of episodes while training, faint and smoothed, and evaluation scores with their standard errors.

    Args:
        steps: of the longest run.
        shipped: evaluations of the agents that ship, to be drawn behind.
    """
    raw, smooth, scores = [], [], []
    for line in lines:
        c, common = line.curves, {"type": "scatter", "legendgroup": line.name, "name": in_plotly(line.name)}
        hover = f"{in_plotly(line.name)}<br>step %{{x:,.0f}}<br>"
        faint = 0.25 if len(c.returns) < _MANY else 0.1
        raw.append({**common, "x": c.episode_steps, "y": c.returns, "mode": "lines", "showlegend": False,
                    "hoverinfo": "skip", "line": {"color": translucent(line.colour, faint), "width": 1}})  # fmt: skip
        smooth.append({**common, "x": c.episode_steps, "y": c.smooth, "mode": "lines", "showlegend": False,
                       "line": {"color": line.colour, "width": 1.4, "dash": "dot"},
                       "hovertemplate": f"{hover}return while training %{{y:.4g}}<extra></extra>"})  # fmt: skip
        evaluated = hover + "evaluation %{y:.4g} +- %{error_y.array:.2g}<extra></extra>"
        scores.append({**common, "x": c.steps, "y": c.scores, "mode": "lines+markers", "showlegend": True,
                       "error_y": {"type": "data", "array": c.errors, "thickness": 1.2, "width": 2},
                       "line": {"color": line.colour, "width": 2.2}, "marker": {"size": 5},
                       "hovertemplate": evaluated})  # fmt: skip
    return build(
        title,
        [*(trace for band in shipped for trace in _banded(band)), *raw, *smooth, *scores],  # what matters lies on top
        margin={"l": 56},
        height=TALL,
        legend=_LEGEND,
        xaxis=axis("step", range=[0, 1.02 * steps]),
        yaxis=axis("return"),
        annotations=_note("no episode has ended yet") if not any(len(line.curves.returns) for line in lines) else [],
    )


def shipped_curves(title: str, bands: Sequence[Band]) -> Figure:
    """Evaluations of the agents that ship, algorithm beside algorithm."""
    return build(
        title,
        [trace for band in bands for trace in _banded(band, shade=0.07, dash="solid")],
        margin={"l": 56},
        height=TALL,
        legend=_LEGEND,
        xaxis=axis("step", rangemode="tozero"),
        yaxis=axis("return"),
    )


def _banded(band: Band, shade: float = 0.14, dash: str = "dash") -> list[Trace]:
    common = {"type": "scatter", "legendgroup": band.name, "name": band.name}
    around = np.concatenate([band.lowest, band.highest[::-1]])
    return [
        {**common, "x": np.concatenate([band.steps, band.steps[::-1]]), "y": around, "mode": "lines", "fill": "toself",
         "fillcolor": translucent(band.colour, shade), "line": {"width": 0}, "hoverinfo": "skip", "showlegend": False},
        {**common, "x": band.steps, "y": band.median, "mode": "lines", "showlegend": True,
         "line": {"color": band.colour, "width": 1.8, "dash": dash},
         "customdata": np.stack([band.lowest, band.highest], axis=-1),
         "hovertemplate": f"{band.name}<br>step %{{x:,.0f}}<br>median %{{y:.4g}}, from %{{customdata[0]:.4g}} to "
                          "%{customdata[1]:.4g}<extra></extra>"},
    ]  # fmt: skip


def score_curve(curves: Sequence[Scored], step: int) -> Figure:
    """Evaluations while training, small: the first curve with its standard errors, those of other seeds faint.

    Args:
        step: of the checkpoint, marked on the first curve.
    """
    traces = []
    for i, curve in reversed(list(enumerate(curves))):
        main = i == 0
        traces.append({
            "type": "scatter", "x": curve.steps, "y": curve.scores, "mode": "lines", "showlegend": False,
            "line": {"color": "#0b7285" if main else translucent(NEUTRAL, 0.45), "width": 2 if main else 1},
            **({"error_y": {"type": "data", "array": curve.errors, "thickness": 1, "width": 0}} if main else {}),
            "hovertemplate": f"seed {curve.seed}, step %{{x:,.0f}}<br>return %{{y:.4g}}<extra></extra>",
        })  # fmt: skip
    first = curves[0]
    if step in first.steps:
        traces.append({
            "type": "scatter", "x": [step], "y": [first.scores[first.steps.index(step)]], "mode": "markers",
            "marker": {"size": 8, "color": "#e8a100"}, "showlegend": False,
            "hovertemplate": "this checkpoint, step %{x:,.0f}<br>return %{y:.4g}<extra></extra>",
        })  # fmt: skip
    return build(
        "",
        traces,
        margin={"l": 40, "r": 6, "t": 6, "b": 32},
        height=CARD,
        xaxis=axis("step of training", nticks=4),
        yaxis=axis("return", nticks=4),
    )


def discount_errors(curves: Curves, gammas: np.ndarray, steps: int, first: int) -> Figure:
    """Predicted minus observed discounted return at the start, a line a discount, in reward a step.

    Args:
        gammas: ``(G,)``.
        steps: of the whole run.
        first: step of the first evaluation, for as long as there is none.
    """
    has_values = curves.values.shape == (len(curves.steps), len(gammas)) and len(curves.steps) > 0
    traces = []
    for index, gamma in enumerate(gammas if has_values else ()):
        error = (curves.values[:, index] - curves.discounted[:, index]) * (1.0 - gamma)
        there = np.isfinite(error)  # an older part of the run may have no values
        traces.append({
            "type": "scatter", "x": curves.steps[there], "y": error[there], "mode": "lines+markers",
            "showlegend": False,
            "line": {"color": _shade(index, len(gammas)), "width": 1.5}, "marker": {"size": 3.5},
            "hovertemplate": f"gamma {gamma:.3g}<br>step %{{x:,.0f}}<br>%{{y:+.3g}} a step<extra></extra>",
        })  # fmt: skip
    many = len(gammas) > 1
    if traces and many:
        traces.append(_colour_bar(gammas))
    return build(
        "values too high or too low" + (", by discount" if many else f", gamma {gammas[0]:g}"),
        traces,
        margin={"l": 56, "r": 12},
        height=TALL,
        xaxis=axis("step", range=[0, 1.02 * steps], **({} if traces else _BARE)),
        yaxis=axis("(value - return) (1 - gamma)", zeroline=bool(traces), **({} if traces else _BARE)),
        annotations=[] if traces else _note(_coming(curves, first)),
    )


def values_by_discount(curves: Curves, gammas: np.ndarray, colour: str, first: int) -> Figure:
    """The last evaluation: predicted and observed discounted return from the start, over the discounts."""
    has_values = curves.values.shape[1] == len(gammas) and len(curves.steps) > 0
    traces = []
    if has_values:
        reach = 1.0 / (1.0 - gammas)
        hover = "gamma %{customdata:.3g}<br>%{y:.4g}<extra>"
        common = {"type": "scatter", "x": reach, "customdata": gammas}
        traces = [
            {**common, "y": curves.discounted[-1], "mode": "lines", "name": "observed",
             "error_y": {"type": "data", "array": curves.discounted_errors[-1], "thickness": 1, "width": 3},
             "line": {"color": NEUTRAL, "width": 5},
             "hovertemplate": "gamma %{customdata:.3g}<br>%{y:.4g} +- %{error_y.array:.2g}<extra>observed</extra>"},
            {**common, "y": curves.values[-1], "mode": "lines+markers", "name": "predicted",
             "line": {"color": colour, "width": 1.5}, "marker": {"size": 6},
             "hovertemplate": f"{hover}predicted</extra>"},
        ]  # fmt: skip
    return build(
        f"value at the start, step {curves.steps[-1]:,.0f}" if has_values else "value at the start",
        traces,
        margin={"l": 52, "t": 58},
        height=TALL,
        xaxis=axis("1 / (1 - gamma), steps", type="log", dtick=1, **({} if has_values else _BARE)),
        yaxis=axis("discounted return", **({} if has_values else _BARE)),
        annotations=[] if has_values else _note(_coming(curves, first)),
    )


def _coming(curves: Curves, first: int) -> str:
    if len(curves.steps):
        return "the evaluations of this run have no values"
    return f"after the first evaluation, at step {first:,}"


def _note(text: str) -> list[Trace]:
    where = {"xref": "paper", "yref": "paper", "x": 0.5, "y": 0.5}
    return [{"text": text, "showarrow": False, "font": {"size": 12, "color": NEUTRAL}, **where}]


def _shade(index: int, of: int) -> str:
    place = (len(_SHADES) - 1) * index / max(1, of - 1)
    low = min(int(place), len(_SHADES) - 2)
    pair = [[int(shade[i : i + 2], 16) for i in (1, 3, 5)] for shade in _SHADES[low : low + 2]]
    mixed = [round(a + (place - low) * (b - a)) for a, b in zip(*pair, strict=True)]
    return "#" + "".join(f"{part:02x}" for part in mixed)


def _colour_bar(gammas: np.ndarray) -> Trace:
    """No points, only the colour scale of the discounts."""
    last = len(gammas) - 1
    ticks = sorted({round(last * share) for share in (0.0, 1 / 3, 2 / 3, 1.0)})
    return {
        "type": "scatter", "x": [None], "y": [None], "mode": "markers", "showlegend": False, "hoverinfo": "skip",
        "marker": {
            "color": [0], "cmin": 0, "cmax": max(1, last), "showscale": True,
            "colorscale": [[i / (len(_SHADES) - 1), shade] for i, shade in enumerate(_SHADES)],
            "colorbar": {
                "title": {"text": "gamma", "font": {"size": 11}}, "thickness": 8, "outlinewidth": 0, "len": 0.95,
                "tickvals": ticks, "ticktext": [f"{gammas[i]:.3g}" for i in ticks], "tickfont": {"size": 10},
            },
        },
    }  # fmt: skip
