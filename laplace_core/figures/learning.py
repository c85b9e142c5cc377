"""Figures of learning: its curve, the rewards that several learners agree on, and the codes of one return."""

from __future__ import annotations

import numpy as np

from laplace_core.figures.theme import ACTION_COLOURS, NEUTRAL, Figure, axis, build, staircase, translucent
from laplace_core.study.pipeline import WorldStudy
from laplace_core.tabular import Bands, Learned, Returns

_NAMES = {
    "categorical": "categorical",
    "quantile": "quantile",
    "expectile": "expectile, imputed",
    "independent_steps": "Laplace, if steps were independent",
}
_POINTS = {"plain": "plain Q, a mean", "laplace": "Laplace, a mean"}
_MOST_REWARDS = 6


def learning_curve(learned: Learned) -> Figure:
    """Largest error of gamma-space, as a share of its range, and the return of the episodes, one line a seed."""
    traces = []
    for index, (seed, curve) in enumerate(zip(learned.seeds, learned.curves, strict=True)):
        line = {"width": 1.6, "color": ACTION_COLOURS[index % len(ACTION_COLOURS)]}
        common = {"type": "scatter", "x": curve["episode"], "mode": "lines", "line": line, "name": f"seed {seed}"}
        percent = 100.0 * np.maximum(curve["error"], 1e-6)
        hover = f"seed {seed}<br>episode %{{x}}<br>%{{y:.3g}}"
        traces.append({**common, "y": percent, "hovertemplate": hover + "% of the range<extra></extra>"})
        traces.append({**common, "y": curve["return"], "yaxis": "y2", "showlegend": False,
                       "hovertemplate": hover + " return<extra></extra>"})  # fmt: skip
    return build(
        "learning: error of gamma-space, return",
        traces,
        margin={"l": 56, "t": 58 if len(learned.seeds) <= 5 else 76},
        xaxis=axis("episode", anchor="y2", rangemode="tozero"),
        yaxis=axis("error (% of range)", type="log", dtick=1, exponentformat="power", domain=[0.44, 1.0]),
        yaxis2=axis("return", domain=[0.0, 0.36]),
    )


def reward_bands(bands: Bands, action: int) -> Figure:
    """How likely each reward is at each step: every learner between the edges of a band, the truth dotted.

    A reward's probability is the mass of tau-space in the sensitivities nearer to it than to any other reward.
    """
    first = bands.studies[0]
    rewards, step, taus = _shown_rewards(bands, action), first.settings.time_step, first.taus
    nearest = _nearest(first)
    traces = []
    for i, reward in enumerate(rewards):
        columns = nearest == int(np.searchsorted(first.world.reward_values, reward))
        each = np.stack([s.decoded.tau_space[action][:, columns].sum(axis=-1) for s in bands.studies]) / step
        true = first.truth.tau_space[action][:, columns].sum(axis=-1) / step
        colour = ACTION_COLOURS[i % len(ACTION_COLOURS)]
        edge = np.concatenate([each.max(axis=0), each.min(axis=0)[::-1]])
        traces += [
            {"type": "scatter", "x": np.concatenate([taus, taus[::-1]]), "y": edge, "fill": "toself", "mode": "lines",
             "fillcolor": translucent(colour), "line": {"width": 0}, "hoverinfo": "skip", "showlegend": False},
            {"type": "scatter", "x": taus, "y": each.mean(axis=0), "mode": "lines", "name": f"reward {reward:g}",
             "line": {"color": colour, "width": 2},
             "hovertemplate": f"reward {reward:g}<br>tau %{{x:g}}<br>%{{y:.3f}}<extra></extra>"},
            {"type": "scatter", "x": taus, "y": true, "mode": "lines", "showlegend": False,
             "line": {"color": colour, "width": 1.3, "dash": "dot"},
             "hovertemplate": f"reward {reward:g}, true<br>tau %{{x:g}}<br>%{{y:.3f}}<extra></extra>"},
        ]  # fmt: skip
    return build(
        "probability of each reward, all seeds",
        traces,
        margin={"t": 58},
        xaxis=axis("future step tau"),
        yaxis=axis("probability", zeroline=True),
    )


def _nearest(study: WorldStudy) -> np.ndarray:
    """Index of the reward that each midpoint is nearest to, the lower one of two; int ``(B,)``."""
    rewards = study.world.reward_values
    return np.searchsorted((rewards[1:] + rewards[:-1]) / 2.0, study.midpoints)


def _shown_rewards(bands: Bands, action: int) -> np.ndarray:
    """The rewards that are likeliest at some step, at most a handful, in order."""
    first = bands.studies[0]
    nearest = _nearest(first)
    mass = np.zeros(first.world.reward_values.size)
    np.add.at(mass, nearest, first.truth.tau_space[action].max(axis=0))
    likeliest = np.argsort(-mass)[:_MOST_REWARDS]
    return np.sort(first.world.reward_values[likeliest[mass[likeliest] > 1e-3]])


def return_laws(returns: Returns) -> Figure:
    """The cumulated distribution of the return by every code, beside the true one."""
    laws = {"true": returns.truth, **{name: returns.codes[name] for name in _NAMES}}
    low = min(float(np.min(at)) for at, mass in laws.values() if np.size(at))
    high = max(float(np.max(at)) for at, mass in laws.values() if np.size(at))
    room = 0.05 * (high - low) or 0.5
    traces = []
    for i, (name, (locations, masses)) in enumerate(laws.items()):
        x, y = staircase(locations, masses, low - room, high + room)
        true = name == "true"
        label = "true" if true else f"{_NAMES[name]} ({returns.distances[name]:.2g})"
        colour = NEUTRAL if true else ACTION_COLOURS[i - 1]
        line = {
            "shape": "hv",
            "width": 4 if true else 1.8,
            "color": colour,
            "dash": "dot" if "indep" in name else "solid",
        }
        traces.append({"type": "scatter", "x": x, "y": y, "mode": "lines", "line": line, "name": label,
                       "hovertemplate": f"{label}<br>return %{{x:.3g}}<br>P %{{y:.3f}}<extra></extra>"})  # fmt: skip
    for i, (name, label) in enumerate(_POINTS.items()):
        mean = float(returns.codes[name][0][0])
        traces.append({"type": "scatter", "x": [mean], "y": [0.04 + 0.07 * i], "mode": "markers", "name": label,
                       "marker": {"symbol": "triangle-down", "size": 10, "color": ACTION_COLOURS[4 + i]},
                       "hovertemplate": f"{label}<br>%{{x:.3f}}<extra></extra>"})  # fmt: skip
    return build(
        f"return, gamma {returns.gamma:g}: codes (W1 to the truth)",
        traces,
        legend={
            "orientation": "v",
            "x": 1.0,
            "xanchor": "right",
            "y": 0.0,
            "yanchor": "bottom",
            "font": {"size": 10},
            "bgcolor": "rgba(128,128,128,0.12)",
        },
        xaxis=axis("return", range=[low - room, high + room]),
        yaxis=axis("P(return at most this)", range=[-0.02, 1.04]),
    )
