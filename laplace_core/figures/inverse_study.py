"""A study of the inverse: how far each rule for alpha stays behind the best alpha, solver beside solver."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from laplace_core.figures.theme import Figure, Trace, action_colour, axis, build

_ROW, _LINE, _HEAD = 30, 14, 90  # pixels: of a rule, of a solver's line in the legend, and of title and axis
_TITLES = {"ratio": "W1 over that of the best alpha", "excess": "excess regret over that of the best alpha"}
_AXES = {"ratio": "times the least W1", "excess": "share of the range of values"}


def study_heights(sums: Sequence[Mapping[str, Any]]) -> int:
    """Pixels of :func:`behind_the_best`."""
    rules, solvers = ({entry[name] for entry in sums} for name in ("selector", "solver"))
    return _HEAD + _ROW * max(2, len(rules)) + _LINE * len(solvers)


def behind_the_best(
    sums: Sequence[Mapping[str, Any]], what: str, rules: Mapping[str, str], solvers: Mapping[str, str]
) -> Figure:
    """Median of every solver and rule as a dot, and a line to nine tenths of the cases.

    Args:
        sums: of :func:`laplace_core.experiments.inverse.selection_report.summed`, without those of the best alpha.
        what: ``ratio`` of the distances or ``excess`` of the regrets.
        rules, solvers: their titles, by name.
    """
    names = list(dict.fromkeys(str(entry["selector"]) for entry in sums))
    used = list(dict.fromkeys(str(entry["solver"]) for entry in sums))
    traces: list[Trace] = []
    for place, solver in enumerate(used):
        own = [entry for entry in sums if entry["solver"] == solver]
        median = np.array([entry[what]["median"] for entry in own])
        most = np.array([entry[what]["nine tenths"] for entry in own])
        shift = (place + 1) / (len(used) + 1) - 0.5  # beside each other, within the row of the rule
        traces.append({
            "type": "scatter", "mode": "markers", "name": solvers[solver], "x": median,
            "y": np.array([names.index(entry["selector"]) + 0.8 * shift for entry in own]),
            "error_x": {"type": "data", "symmetric": False, "array": np.maximum(0.0, most - median),
                        "arrayminus": np.zeros(len(own)), "thickness": 2, "width": 5},
            "marker": {"color": action_colour(place), "size": 9}, "cliponaxis": False,
            "customdata": [[rules[entry["selector"]], entry["cases"], high]
                           for entry, high in zip(own, most.tolist(), strict=True)],
            "hovertemplate": f"{solvers[solver]}, %{{customdata[0]}}<br>median %{{x:.3g}}, 90% %{{customdata[2]:.3g}}"
                             "<br>%{customdata[1]} cases<extra></extra>",
        })  # fmt: skip
    across = axis(_AXES[what], **({"type": "log"} if what == "ratio" else {"rangemode": "tozero"}))
    return build(
        _TITLES[what], traces, margin={"l": 118, "t": 58, "r": 14}, height=study_heights(sums), xaxis=across,
        yaxis=axis(tickvals=list(range(len(names))), ticktext=[rules[name] for name in names], autorange="reversed",
                   range=[len(names) - 0.5, -0.5]),
    )  # fmt: skip
