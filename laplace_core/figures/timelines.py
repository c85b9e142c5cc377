"""Ranges over several learners of one world: rewards and survival over tau, values over the horizon."""

from __future__ import annotations

import numpy as np

from laplace_core import Study
from laplace_core.figures.theme import NEUTRAL, Figure, Trace, action_colour, axis, build, in_plotly, translucent
from laplace_core.tabular import Band, Bands


def rewards_and_survival(study: Study, action: int, bands: Bands) -> Figure:
    """E[r_tau] and the chance that the episode still runs, decoded against true, for one action.

    The range over the learners lies behind the lines.
    """
    step, taus, decoded, truth = study.settings.time_step, study.taus, study.decoded, study.truth
    few = len(taus) <= 60
    traces: list[Trace] = []

    def line(name: str, values: np.ndarray, mode: str = "lines", **style: object) -> Trace:
        hover = f"tau %{{x:g}}<br>{name} %{{y:.3g}}<extra></extra>"
        return {"type": "scatter", "x": taus, "y": values[action] / step, "name": name, "mode": mode,
                "hovertemplate": hover, **style}  # fmt: skip

    if truth is not None:
        whose = "" if study.settings.policy == "shared" else f" (policy of gamma {study.settings.acting_gamma:g})"
        bars = line(f"true reward{whose}", truth.expected_reward)
        del bars["mode"]
        marker = {"color": "rgba(138,143,152,0.30)", "line": {"color": NEUTRAL, "width": 1}}
        traces.append({**bars, "type": "bar", "width": 0.8 * step, "marker": marker})
        shape = {"color": NEUTRAL, "width": 1, "shape": "hvh" if few else "linear"}
        traces.append(line("true survival", truth.survival, line=shape, yaxis="y2"))
    band = _band(taus, bands.expected_reward, action, step, colour=action_colour(action), yaxis="y")
    traces.append({**band, "showlegend": True, "name": "range over seeds"})
    traces.append(_band(taus, bands.survival, action, step, colour=NEUTRAL, yaxis="y2"))
    colour = {"color": action_colour(action), "width": 2}
    traces.append(line("decoded reward", decoded.expected_reward, "lines+markers" if few else "lines", line=colour))
    dots = {"color": NEUTRAL, "width": 2, "dash": "dot"}
    traces.append(line("decoded survival", decoded.survival, line=dots, yaxis="y2"))
    span = _least_span(study)
    values = np.concatenate([trace["y"] for trace in traces if trace.get("yaxis", "y") == "y"])
    low, high = min(0.0, float(np.min(values))), max(0.0, float(np.max(values)))
    flat = {"range": [-span, span]} if high - low < span else {}
    return build(
        "rewards and survival over the seeds",
        traces,
        margin={"t": 84},
        xaxis=axis("future step tau", anchor="y2"),
        yaxis=axis("expected reward", domain=[0.38, 1.0], zeroline=True, **flat),
        yaxis2=axis("survival", domain=[0.0, 0.3], range=[-0.2, 1.3], tickvals=[0, 1], zeroline=True),
    )


def _band(taus: np.ndarray, band: Band, action: int, step: float, *, colour: str, yaxis: str) -> Trace:
    """The range over all learners, as an area."""
    edge = np.concatenate([band.high[action], band.low[action][::-1]]) / step
    return {"type": "scatter", "x": np.concatenate([taus, taus[::-1]]), "y": edge, "yaxis": yaxis, "fill": "toself",
            "fillcolor": translucent(colour), "line": {"width": 0}, "mode": "lines", "hoverinfo": "skip",
            "showlegend": False}  # fmt: skip


def values_over_horizon(study: Study, row: int, bands: Bands) -> Figure:
    """V_T of every action over T, its range over the learners, the share of them that chooses it, and the best one."""
    horizons, decoded, truth = study.horizons, study.decoded, study.truth
    names = tuple(map(in_plotly, study.action_names))
    mode = "lines+markers" if len(horizons) <= 40 else "lines"
    traces: list[Trace] = []
    for a, name in enumerate(names):
        line = {"type": "scatter", "x": horizons, "name": name}
        colour = action_colour(a)
        if truth is not None:
            hover = f"T %{{x:g}}<br>true {name} %{{y:.3f}}<extra></extra>"
            style = {"mode": "lines", "line": {"color": colour, "width": 1.5, "dash": "dot"}, "showlegend": False}
            traces.append({**line, **style, "y": truth.horizon_values[a], "hovertemplate": hover})
        hover = f"T %{{x:g}}<br>decoded {name} %{{y:.3f}}<extra></extra>"
        style = {"mode": mode, "line": {"color": colour, "width": 2}, "marker": {"size": 5}}
        traces.append({**line, **style, "y": decoded.horizon_values[a], "hovertemplate": hover})
    traces += _value_bands(horizons, bands)
    traces += _shares(horizons, names, bands.action_share)
    if truth is not None:
        traces.append(_strip(horizons, names, {"best": truth.optimal_action}))
    at = float(horizons[row])
    cursor = {"type": "line", "x0": at, "x1": at, "y0": 0, "y1": 1, "xref": "x", "yref": "paper"}
    return build(
        "values and choices over the seeds",
        traces,
        margin={"l": 56, "t": 40 + 19 * _legend_rows(study.action_names)},
        shapes=[{**cursor, "line": {"color": NEUTRAL, "width": 1.5, "dash": "dash"}}],
        xaxis=axis("horizon T (steps)", anchor="y2"),
        yaxis=axis("value V<sub>T</sub>", domain=[0.24, 1.0], **_value_range(study)),
        yaxis2=axis(domain=[0.0, 0.09], showgrid=False),
        barmode="stack",
        bargap=0.04,
        yaxis3=axis("", domain=[0.1, 0.21], range=[0, 1], showgrid=False, tickvals=[0.5], ticktext=["seeds"]),
    )


def _value_bands(horizons: np.ndarray, bands: Bands) -> list[Trace]:
    """The range of every action's values over all learners."""
    return [
        _band(horizons, bands.horizon_values, a, 1.0, colour=action_colour(a), yaxis="y")
        for a in range(len(bands.action_share))
    ]


def _shares(horizons: np.ndarray, names: tuple[str, ...], share: np.ndarray) -> list[Trace]:
    """Stacked bars: the share of learners that choose each action at each horizon."""
    return [
        {"type": "bar", "x": horizons, "y": share[a], "yaxis": "y3", "marker": {"color": action_colour(a)},
         "showlegend": False, "hovertemplate": f"T %{{x:g}}<br>{name}: %{{y:.0%}} of the seeds<extra></extra>"}
        for a, name in enumerate(names)
    ]  # fmt: skip


def _least_span(study: Study) -> float:
    """Below this a difference is rounding, and an axis should not blow it up."""
    return 1e-3 * float(study.midpoints[-1] - study.midpoints[0])


def _value_range(study: Study) -> dict[str, list[float]]:
    values = [study.decoded.horizon_values] + ([study.truth.horizon_values] if study.truth is not None else [])
    low, high = float(np.min(values)), float(np.max(values))
    return {} if high - low >= _least_span(study) else {"range": [low - 1.0, high + 1.0]}


def _legend_rows(names: tuple[str, ...], width: int = 290) -> int:
    """Rows that a legend of these names fills at about ``width`` pixels."""
    return int(np.ceil(sum(50 + 6.5 * len(name) for name in names) / width))


def _strip(horizons: np.ndarray, names: tuple[str, ...], strips: dict[str, np.ndarray]) -> Trace:
    """One coloured cell a horizon and strip."""
    count = max(2, len(names))
    scale = [[edge, action_colour(i)] for i in range(count) for edge in (i / count, (i + 1) / count)]
    return {
        "type": "heatmap",
        "x": horizons,
        "y": list(strips),
        "z": np.array(list(strips.values())),
        "zmin": -0.5,
        "zmax": count - 0.5,
        "colorscale": scale,
        "showscale": False,
        "customdata": [[names[a] for a in actions] for actions in strips.values()],
        "hovertemplate": "T %{x:g}<br>%{y}: %{customdata}<extra></extra>",
        "xgap": 1 if len(horizons) <= 60 else 0,
        "ygap": 2,
        "yaxis": "y2",
    }
