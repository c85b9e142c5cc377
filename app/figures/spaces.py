"""Gamma-space and tau-space, as heatmaps and as the paper's surfaces."""

from __future__ import annotations

import numpy as np

from app.figures.theme import TRUTH, TRUTH_HALO, UNDER_RANGE, Figure, axis, build, probability_scale
from laplace_core import Study

_FOOT = 0.02  # a true reward is outlined down to this share of its row's peak
_FEW_ROWS = 16


def gamma_space(study: Study, action: int, surface: bool = False) -> Figure:
    """Q[g, h] - Q[g, h+1] over sensitivity and discount, in discounted counts."""
    values, gammas = study.gamma_space.differences[action], study.gamma_space.gammas
    limit = float(values.max()) or 1.0
    hover = "theta %{x:.3g}<br>gamma %{customdata:.3f}<br>%{z:.3g} discounted steps<extra></extra>"
    custom = np.repeat(gammas[:, None], values.shape[1], axis=1)
    rows = _rows_axis("discount gamma", gammas)
    return _space(values, study.midpoints, limit, hover, custom, surface, "gamma-space", "discounted steps", rows, [])


def tau_space(study: Study, action: int, surface: bool = False) -> Figure:
    """P[tau, h] over reward and future step, with the truth outlined."""
    step = study.settings.time_step
    values = study.decoded.tau_space[action] / step
    truth = None if study.truth is None else study.truth.tau_space[action] / step
    limit = probability_limit(study)
    hover = "reward %{x:.3g}<br>tau %{customdata:g}<br>probability %{z:.3g}<extra></extra>"
    custom = np.repeat(study.taus[:, None], values.shape[1], axis=1)
    outline = []
    if truth is not None:
        outline = _ridges(truth, study.midpoints, limit) if surface else _outline(truth, study.gamma_space.thetas)
    rows = _rows_axis("future step tau", study.taus)
    return _space(values, study.midpoints, limit, hover, custom, surface, "tau-space", "probability", rows, outline)


def probability_limit(study: Study) -> float:
    """Top of the colour scale: it knows the world and the encoding, but not alpha, horizon or normalisation."""
    if study.truth is None:
        return float(np.abs(study.decoded.tau_space).max() / study.settings.time_step) or 1.0
    return float(study.truth.tau_space.max() / study.settings.time_step) or 1.0


def _space(values, midpoints, limit, hover, custom, surface, name, unit, rows_axis, outline) -> Figure:
    rows, low = np.arange(len(values)), -UNDER_RANGE * limit
    data = {"x": midpoints, "y": rows, "z": values, "customdata": custom, "hovertemplate": hover}
    data["colorscale"] = probability_scale()
    if surface:
        traces = [{"type": "surface", **data, "cmin": low, "cmax": limit, "showscale": False}, *outline]
        heights = [min(low, float(values.min())), max(limit, float(values.max()))]
        return build(
            name,
            traces,
            margin={"l": 0, "r": 0, "t": 28, "b": 0},
            showlegend=False,
            scene=_scene(rows_axis, heights, unit),
        )
    bar = {"thickness": 8, "len": 1.0, "x": 1.01, "xpad": 0, "tickfont": {"size": 10}, "nticks": 5}
    bar["title"] = {"text": unit, "side": "right", "font": {"size": 10}}
    traces = [{"type": "heatmap", **data, "zmin": low, "zmax": limit, "colorbar": bar}, *outline]
    return build(
        name,
        traces,
        showlegend=False,
        xaxis=axis("sensitivity theta (reward)", showgrid=False),
        yaxis=axis(rows_axis["title"]["text"], showgrid=False, range=[-0.5, len(values) - 0.5]) | _ticks(rows_axis),
    )


def _scene(rows_axis: dict[str, object], heights: list[float], unit: str) -> dict[str, object]:
    small = {"tickfont": {"size": 9}}
    return {
        "xaxis": {"title": {"text": "theta", "font": {"size": 11}}, **small},
        "yaxis": {"title": {"text": rows_axis["title"]["text"], "font": {"size": 11}}, **_ticks(rows_axis), **small},
        "zaxis": {"title": {"text": unit, "font": {"size": 11}}, "range": heights, **small},
        "camera": {"eye": {"x": -1.45, "y": -1.75, "z": 1.05}, "center": {"x": 0.0, "y": 0.0, "z": -0.2}},
        "aspectratio": {"x": 1.25, "y": 1.25, "z": 0.7},
    }


def _rows_axis(title: str, labels: np.ndarray) -> dict[str, object]:
    """About six labelled rows, evenly spaced; rows are drawn at equal heights whatever they stand for."""
    stride = next(n for n in (1, 2, 5, 10, 20, 50, 100, 200, 500) if len(labels) / n <= 8)
    shown = np.arange(0, len(labels), stride)
    return {"title": {"text": title}, "tickvals": shown, "ticktext": [f"{labels[i]:.3g}" for i in shown]}


def _ticks(rows_axis: dict[str, object]) -> dict[str, object]:
    return {name: rows_axis[name] for name in ("tickvals", "ticktext")}


def _outline(truth: np.ndarray, thetas: np.ndarray) -> list[dict]:
    """Boxes around the cells where the true probability rises above the foot of its row's peak.

    With many rows only the sides are drawn: caps would hide what they enclose.
    """
    half, capped = (0.46, True) if len(truth) <= _FEW_ROWS else (0.5, False)
    x: list[float | None] = []
    y: list[float | None] = []
    least = 1e-3 * truth.max()
    for tau, row in enumerate(truth):
        high = row > max(_FOOT * row.max(), least)
        flips = np.flatnonzero(np.diff(np.concatenate([[False], high, [False]]).astype(int)))
        for first, last in zip(flips[::2], flips[1::2], strict=True):
            left, right, low, top = float(thetas[first]), float(thetas[last]), tau - half, tau + half
            x += [left, right, right, left, left, None] if capped else [left, left, None, right, right, None]
            y += [low, low, top, top, low, None] if capped else [low, top, None, low, top, None]
    common = {"type": "scatter", "x": x, "y": y, "mode": "lines", "hoverinfo": "skip"}
    line = {"color": TRUTH, "width": 1.5 if capped else 1}
    return [
        {**common, "line": {"color": TRUTH_HALO, "width": 3.5}, "name": "halo"},
        {**common, "line": line, "name": "truth"},
    ]


def _ridges(truth: np.ndarray, midpoints: np.ndarray, limit: float) -> list[dict]:
    """One line a step: the true row, floating on the surface."""
    x: list[float | None] = []
    y: list[float | None] = []
    z: list[float | None] = []
    for tau, row in enumerate(truth):
        if row.max() > 1e-3 * limit:
            x += [*midpoints.tolist(), None]
            y += [tau] * len(midpoints) + [None]
            z += [*row.tolist(), None]
    line = {"color": "#ff7f0e", "width": 4}
    return [
        {
            "type": "scatter3d",
            "x": x,
            "y": y,
            "z": z,
            "mode": "lines",
            "line": line,
            "hoverinfo": "skip",
            "name": "truth",
        }
    ]
