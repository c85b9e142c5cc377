"""A timeline before and after it was changed by hand: values over the horizon, and gamma-space."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from laplace_core.code.gamma_space import GammaSpace
from laplace_core.figures.theme import Figure, Trace, action_colour, axis, build, in_plotly
from laplace_core.study.edited import Edited


def edited_values(edited: Edited, horizons: np.ndarray, names: Sequence[str]) -> Figure:
    """V_T of every action over T, dotted before and drawn through after."""
    return build(
        "values over the horizon",
        _pairs(horizons, edited.values, edited.new_values, names, across="T"),
        margin={"l": 56},
        xaxis=axis("deadline T (steps)"),
        yaxis=axis("value V<sub>T</sub>"),
    )


def edited_gamma_space(edited: Edited, names: Sequence[str]) -> Figure:
    """(1 - gamma) Q of every action over the time constants of the discounts, dotted before."""
    times = -1.0 / np.log(edited.before.gammas)
    return build(
        "gamma-space: value a step",
        _pairs(times, _value(edited.before), _value(edited.after), names, across="time constant"),
        margin={"l": 56},
        xaxis=axis("time constant of gamma (steps)", type="log"),
        yaxis=axis("(1 - gamma) value"),
    )


def _value(space: GammaSpace) -> np.ndarray:
    return np.asarray((1.0 - space.gammas) * (space.differences @ space.bin_values))


def _pairs(x: np.ndarray, before: np.ndarray, after: np.ndarray, names: Sequence[str], *, across: str) -> list[Trace]:
    traces: list[Trace] = []
    for a, name in enumerate(map(in_plotly, names)):
        for when, values, dash in (("before", before, "dot"), ("after", after, "solid")):
            traces.append({
                "type": "scatter", "mode": "lines", "x": x, "y": values[a], "name": name,
                "showlegend": when == "after", "line": {"color": action_colour(a), "width": 2, "dash": dash},
                "hovertemplate": f"{across} %{{x:.3g}}<br>{name} {when} %{{y:.4g}}<extra></extra>",
            })  # fmt: skip
    return traces
