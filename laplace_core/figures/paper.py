"""Figures of the paper's experiments, from the numbers of their committed results."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

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
    probability_scale,
    staircase,
    translucent,
)

TALL = 340
_PAPER = "#d6336c"
_ON_THE_RIGHT = {
    "orientation": "v", "x": 1.0, "xanchor": "right", "y": 0.0, "yanchor": "bottom", "font": {"size": 10},
    "bgcolor": "rgba(128,128,128,0.12)",
}  # fmt: skip
Law = tuple[np.ndarray, np.ndarray]
"""Locations and masses of a distribution."""


def codes_of_a_return(truth: Law, codes: Mapping[str, Law]) -> Figure:
    """P(return at most x): the true one, and each code as it was learned."""
    low, high = float(truth[0].min()), float(truth[0].max())
    room = 0.05 * (high - low)
    traces: list[Trace] = []
    for i, (name, law) in enumerate({"true": truth, **codes}.items()):
        x, y = staircase(*law, low - room, high + room)
        line = {"shape": "hv", "width": 4 if i == 0 else 1.8, "color": NEUTRAL if i == 0 else ACTION_COLOURS[i - 1]}
        label = in_plotly(name)
        traces.append({"type": "scatter", "x": x, "y": y, "mode": "lines", "line": line, "name": label,
                       "hovertemplate": f"{label}<br>return %{{x:.3g}}<br>P %{{y:.3f}}<extra></extra>"})  # fmt: skip
    return build(
        "the return by each code, learned (first seed)",
        traces,
        height=TALL,
        legend=_ON_THE_RIGHT,
        xaxis=axis("return", range=[low - room, high + room]),
        yaxis=axis("P(return at most this)", range=[-0.02, 1.04]),
    )


def decoded_rewards(cases: Mapping[str, np.ndarray], actions: Sequence[str]) -> Figure:
    """E[reward] at each step, a bar an action, a panel a case of two rows by two.

    Args:
        cases: ``(A, K)`` by what the panel is called, four of them.
    """
    traces, layout, words = [], {}, []
    top = 1.08 * max(float(each.max()) for each in cases.values())
    for i, (name, rewards) in enumerate(cases.items()):
        column, row, end = i % 2, i // 2, "" if i == 0 else str(i + 1)
        across, up = ([0.0, 0.47], [0.53, 1.0])[column], ([0.58, 0.94], [0.0, 0.36])[row]
        last = row == 1
        layout[f"xaxis{end}"] = axis("step tau" if last else "", domain=across, anchor=f"y{end}", dtick=1)
        layout[f"yaxis{end}"] = axis("E[reward]" if column == 0 else "", domain=up, anchor=f"x{end}", range=[0, top],
                                     showticklabels=column == 0)  # fmt: skip
        for action, label in enumerate(actions):
            hover = f"{in_plotly(name)}<br>{in_plotly(label)}, tau %{{x}}<br>%{{y:.2f}}<extra></extra>"
            traces.append({"type": "bar", "x": list(range(rewards.shape[1])), "y": rewards[action], "xaxis": f"x{end}",
                           "yaxis": f"y{end}", "name": in_plotly(label), "legendgroup": label, "showlegend": i == 0,
                           "marker": {"color": action_colour(action)}, "hovertemplate": hover})  # fmt: skip
        words.append({"text": in_plotly(name), "showarrow": False, "font": {"size": 11}, "xref": "paper",
                      "yref": "paper", "x": across[0], "xanchor": "left", "y": up[1], "yanchor": "bottom"})  # fmt: skip
    return build(
        "expected reward, decoded", traces, margin={"t": 62}, height=TALL, annotations=words, barmode="group", **layout
    )


def timelines(panels: Mapping[str, np.ndarray], rewards: Sequence[float]) -> Figure:
    """The probability of each reward at each step: a map a panel, rewards across, steps up.

    Args:
        panels: ``(K, V)`` by what the panel is called.
        rewards: ``(V,)``.
    """
    traces, layout, words = [], {}, []
    width, names = 1.0 / len(panels), [f"{reward:g}" for reward in rewards]
    for i, (name, chances) in enumerate(panels.items()):
        end = "" if i == 0 else str(i + 1)
        across = [i * width, (i + 0.9) * width]
        traces.append({"type": "heatmap", "z": chances.tolist(), "x": names, "xaxis": f"x{end}", "yaxis": f"y{end}",
                       "colorscale": probability_scale(), "zmin": -0.125, "zmax": 0.5, "showscale": False,
                       "hovertemplate": f"{in_plotly(name)}<br>reward %{{x}}, tau %{{y}}<br>probability %{{z:.3f}}"
                                        "<extra></extra>"})  # fmt: skip
        layout[f"xaxis{end}"] = axis("reward", domain=across, anchor=f"y{end}", type="category")
        layout[f"yaxis{end}"] = axis("step tau" if i == 0 else "", anchor=f"x{end}", dtick=1, showticklabels=i == 0)
        words.append({"text": in_plotly(name), "showarrow": False, "font": {"size": 11}, "xref": "paper",
                      "yref": "paper", "x": across[0], "xanchor": "left", "y": 1.0, "yanchor": "bottom"})  # fmt: skip
    return build("probability of each reward", traces, margin={"t": 56}, height=TALL, annotations=words, **layout)


@dataclass(frozen=True, eq=False)
class Banded:
    """A curve of several seeds, such as their interquartile mean, and its band, ``(N,)`` each.

    Attributes:
        raw: the curve before smoothing.
    """

    name: str
    colour: str
    places: np.ndarray
    low: np.ndarray
    middle: np.ndarray
    high: np.ndarray
    raw: np.ndarray | None = None


@dataclass(frozen=True, eq=False)
class Panel:
    """Curves with one pair of axes."""

    title: str
    across: str
    bands: Sequence[Banded]


_PANEL, _BETWEEN = 150, 62
"""Height of a panel, and of what lies between two, in pixels."""


def banded_curves(title: str, panels: Sequence[Panel], upwards: str = "return", **options: object) -> Figure:
    """Panels beneath each other: lines with bands, and faint what they were before smoothing.

    Args:
        upwards: what the vertical axes show; ``options`` go to plotly for them.
    """
    traces: list[Trace] = []
    layout, words, names = {}, [], set()
    inner = len(panels) * _PANEL + (len(panels) - 1) * _BETWEEN
    for i, panel in enumerate(panels):
        end, top = "" if i == 0 else str(i + 1), inner - i * (_PANEL + _BETWEEN)
        up = [max(0.0, (top - _PANEL) / inner), top / inner]
        layout[f"xaxis{end}"] = axis(panel.across, anchor=f"y{end}", rangemode="tozero")
        layout[f"yaxis{end}"] = axis(upwards, domain=up, anchor=f"x{end}", **options)
        words.append({"text": in_plotly(panel.title), "showarrow": False, "font": {"size": 11}, "xref": "paper",
                      "yref": "paper", "x": 0.0, "xanchor": "left", "y": up[1], "yanchor": "bottom"})  # fmt: skip
        for band in panel.bands:
            name = in_plotly(band.name)
            common = {"type": "scatter", "mode": "lines", "xaxis": f"x{end}", "yaxis": f"y{end}", "name": name,
                      "legendgroup": name}  # fmt: skip
            around = np.concatenate([band.low, band.high[::-1]])
            traces.append({**common, "x": np.concatenate([band.places, band.places[::-1]]), "y": around,
                           "fill": "toself", "fillcolor": translucent(band.colour, 0.1), "line": {"width": 0},
                           "hoverinfo": "skip", "showlegend": False})  # fmt: skip
            if band.raw is not None:
                traces.append({**common, "x": band.places, "y": band.raw, "showlegend": False, "hoverinfo": "skip",
                               "line": {"color": translucent(band.colour, 0.35), "width": 0.8}})  # fmt: skip
            hover = f"{name}<br>{panel.across} %{{x:,.0f}}<br>%{{y:.4g}}, from %{{customdata[0]:.4g}} to "
            traces.append({**common, "x": band.places, "y": band.middle, "showlegend": name not in names,
                           "customdata": np.stack([band.low, band.high], axis=-1),
                           "line": {"color": band.colour, "width": 1.8},
                           "hovertemplate": f"{hover}%{{customdata[1]:.4g}}<extra></extra>"})  # fmt: skip
            names.add(name)
    return build(
        title,
        traces,
        margin={"l": 56, "t": 58, "b": 44},
        height=inner + 58 + 44,
        legend=_ON_THE_RIGHT,
        annotations=words,
        **layout,
    )


@dataclass(frozen=True)
class Spread:
    """A number with its interval, and the paper's where there is one."""

    name: str
    group: str
    mean: float
    interval: Sequence[float]
    paper: float | None = None


def spreads(title: str, rows: Sequence[Spread], unit: str) -> Figure:
    """A dot a row with its interval, the first row on top; a colour a group; open diamonds for the paper's numbers."""
    names = list(dict.fromkeys(in_plotly(row.name) for row in rows))
    groups = list(dict.fromkeys(row.group for row in rows))
    traces: list[Trace] = []
    for i, group in enumerate(groups):
        mine = [row for row in rows if row.group == group]
        told, colour = [row for row in mine if row.paper is not None], ACTION_COLOURS[i % len(ACTION_COLOURS)]
        common = {"type": "scatter", "mode": "markers", "orientation": "h", "offsetgroup": group}
        traces.append({
            **common, "name": in_plotly(group), "x": [row.mean for row in mine],
            "y": [in_plotly(row.name) for row in mine], "marker": {"size": 8, "color": colour},
            "error_x": {"type": "data", "array": [row.interval[1] - row.mean for row in mine], "symmetric": False,
                        "arrayminus": [row.mean - row.interval[0] for row in mine], "thickness": 1.4, "width": 4},
            "hovertemplate": f"%{{y}}, {in_plotly(group)}<br>%{{x:.1f}}<extra></extra>",
        })  # fmt: skip
        if told:
            traces.append({
                **common, "name": "the paper", "x": [row.paper for row in told], "showlegend": i == 0,
                "y": [in_plotly(row.name) for row in told],
                "marker": {"size": 10, "symbol": "diamond-open", "color": colour, "line": {"width": 2}},
                "hovertemplate": f"%{{y}}, {in_plotly(group)}, the paper<br>%{{x:.1f}}<extra></extra>",
            })  # fmt: skip
    return build(
        title,
        traces,
        margin={"l": 8, "t": 80},  # in a narrow window the legend has two lines
        height=max(220, 130 + (22 + 8 * len(groups)) * len(names)),
        hovermode="closest",
        scattermode="group",  # rows of one name lie beneath each other
        xaxis=axis(unit, zeroline=True),
        yaxis=axis("", automargin=True, categoryorder="array", categoryarray=names[::-1]),
    )


def shares(title: str, bars: Mapping[str, float], chance: float) -> Figure:
    """A bar for each share, and where chance alone would be."""
    names, last = [in_plotly(name) for name in bars], len(bars) - 1
    colours = [ACTION_COLOURS[0] if i == last else NEUTRAL for i in range(len(bars))]
    bar = {"type": "bar", "orientation": "h", "x": list(bars.values()), "y": names, "marker": {"color": colours},
           "hovertemplate": "%{y}: %{x:.0%}<extra></extra>"}  # fmt: skip
    line = {"type": "line", "x0": chance, "x1": chance, "yref": "paper", "y0": 0, "y1": 1,
            "line": {"color": _PAPER, "width": 1.4, "dash": "dot"}}  # fmt: skip
    label = {"text": "chance", "showarrow": False, "x": chance, "yref": "paper", "y": 1.0, "yanchor": "bottom",
             "font": {"size": 11, "color": _PAPER}}  # fmt: skip
    return build(
        title,
        [bar],
        margin={"l": 8, "t": 52},
        height=max(220, 110 + 30 * len(names)),
        shapes=[line],
        annotations=[label],
        xaxis=axis("share distinguished", range=[0, 1.02], tickformat=".0%"),
        yaxis=axis("", automargin=True, categoryorder="array", categoryarray=names[::-1]),
    )
