"""Decoded timelines beside simulated ones."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from laplace_core.figures.theme import ACTION_COLOURS, NEUTRAL, Figure, axis, build, translucent

if TYPE_CHECKING:  # it brings torch along, which no figure needs
    from laplace_core.acting.simulated_truth import Confronted

_DECODED, _SIMULATED = ACTION_COLOURS[0], "#d6336c"


def simulated_timeline(confronted: Confronted) -> Figure:
    """Expected reward, survival and how far tau-space is off, over future steps; bands of two standard errors."""
    taus, simulated = np.arange(len(confronted.reward), dtype=float), confronted.simulated
    traces = []
    for i, (name, decoded, mean, error) in enumerate((
        ("E[r]", confronted.reward, simulated.reward, simulated.reward_error),
        ("alive", confronted.survival, simulated.survival, simulated.survival_error),
    )):  # fmt: skip
        place, first = {"yaxis": "y" if i == 0 else "y2"}, i == 0
        edge = np.concatenate([mean + 2 * error, (mean - 2 * error)[::-1]])
        hover = f"{name}<br>tau %{{x}}: %{{y:.3g}}<extra></extra>"
        traces += [
            {"type": "scatter", "x": np.concatenate([taus, taus[::-1]]), "y": edge, "fill": "toself", "mode": "lines",
             "fillcolor": translucent(_SIMULATED), "line": {"width": 0}, "hoverinfo": "skip", "showlegend": False,
             **place},
            {"type": "scatter", "x": taus, "y": mean, "mode": "lines", "name": "simulated", "showlegend": first,
             "line": {"color": _SIMULATED, "width": 1.6}, "hovertemplate": hover, **place},
            {"type": "scatter", "x": taus, "y": decoded, "mode": "lines", "name": "decoded", "showlegend": first,
             "line": {"color": _DECODED, "width": 2.2}, "hovertemplate": hover, **place},
        ]  # fmt: skip
    traces.append(
        {"type": "scatter", "x": taus, "y": confronted.distance, "mode": "lines", "yaxis": "y3", "showlegend": False,
         "line": {"color": NEUTRAL, "width": 1.8}, "hovertemplate": "W1 at tau %{x}: %{y:.3g}<extra></extra>"}
    )  # fmt: skip
    return build(
        "decoded and simulated timeline",
        traces,
        margin={"l": 56, "t": 52},
        xaxis=axis("future step τ", anchor="y3"),
        yaxis=axis("E[r]", domain=[0.62, 1.0]),
        yaxis2=axis("alive", domain=[0.31, 0.55], rangemode="tozero"),
        yaxis3=axis("W1", domain=[0.0, 0.24], rangemode="tozero"),
    )


def calibration_plot(confronted: Confronted) -> Figure:
    """Predicted against observed probability that a reward exceeds a sensitivity; bars of two standard errors."""
    c = confronted.calibration
    sizes = 5.0 + 2.0 * np.log10(c.counts)
    traces = [
        {"type": "scatter", "x": [0.0, 1.0], "y": [0.0, 1.0], "mode": "lines", "hoverinfo": "skip",
         "line": {"color": NEUTRAL, "width": 1.2, "dash": "dot"}, "showlegend": False},
        {"type": "scatter", "x": c.predicted, "y": c.observed, "mode": "markers+lines", "showlegend": False,
         "marker": {"color": _DECODED, "size": sizes}, "line": {"color": _DECODED, "width": 1.2},
         "customdata": c.counts,
         "error_y": {"type": "data", "array": 2.0 * c.errors, "color": _DECODED, "thickness": 1.2},
         "hovertemplate": "predicted %{x:.3g}, observed %{y:.3g}<br>%{customdata:,} predictions<extra></extra>"},
    ]  # fmt: skip
    return build(
        "calibration of P(r > θ, alive)",
        traces,
        margin={"l": 56},
        xaxis=axis("predicted probability"),
        yaxis=axis("observed", range=[-0.05, 1.05]),
    )
