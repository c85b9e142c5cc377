"""The picture of each entry that has one, from the raw results: a figure, and what it shows in words."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from laplace_core.acting.bootstrap import interquartile_band
from laplace_core.experiments.paper.claims import Found
from laplace_core.experiments.paper.claims.curves import at_episodes, at_steps, over_episodes
from laplace_core.experiments.paper.claims.deadlines import TITLES, columns, of_paper
from laplace_core.experiments.paper.claims.readings import difference, held_out_errors
from laplace_core.experiments.paper.fig3 import ALGORITHMS, ENVIRONMENTS
from laplace_core.experiments.paper.termination import ENDINGS, HORIZONS, READINGS
from laplace_core.experiments.shipping import TrainingCurve
from laplace_core.figures import paper as figures
from laplace_core.figures.paper import Spread
from laplace_core.figures.theme import Figure, action_colour
from laplace_core.figures.training import Band, shipped_curves
from laplace_core.worlds.titles import world_title

CANNOT_DRAW = (LookupError, TypeError, ValueError, AttributeError, ArithmeticError)
"""What drawing raises where a file holds something else than was written."""
_CHANCE = 0.5
_REACH, _LEAST_REACH = 0.02, 5
"""Smoothing over episodes: on either side this share of the longest training, and so many at least."""


@dataclass(frozen=True)
class Picture:
    """A figure, and what it shows for those who cannot see it."""

    figure: Figure
    alt: str


def picture(found: Found) -> Picture | None:
    """The picture of an entry; None where nothing of it is measured."""
    if not found.results.there or found.entry.name == "search":  # which the page Train draws
        return None
    return _DRAWN.get(found.entry.name, _trained)(found)


def _codes(found: Found) -> Picture:
    first = found.results.rows[0]["result"]
    laws = {name: _law(code) for name, code in first["codes"].items() if "locations" in code}
    names = ", ".join(laws)
    return Picture(figures.codes_of_a_return(_law(first["truth"]), laws), f"The return by the codes {names}.")


def _law(code: dict[str, Any]) -> tuple[np.ndarray, np.ndarray]:
    return np.array(code["locations"]), np.array(code["masses"])


def _toy(found: Found) -> Picture:
    """The mean of the learners that are tables, which are the paper's; of what else there is without them."""
    rows = found.results.rows
    shown = [row for row in rows if row["part"]["values"] == "tabular"] or rows
    cases = {
        f"{ending}, rows {rows}": np.mean([row["result"][key][how]["expected_reward"] for row in shown], axis=0)
        for key, ending in (("plain", "plain"), ("auxiliary", "auxiliary states"))
        for how, rows in (("paper", "rescaled"), ("none", "left alone"))
    }
    alt = (
        "Decoded expected reward of both actions at steps 0 to 2, with and without auxiliary states and rescaled rows."
    )
    return Picture(figures.decoded_rewards(cases, ("action 0: 5 at once", "action 1: 10 at step 2")), alt)


def _chain(found: Found) -> Picture:
    panels = {}
    for values, name in (("exact", "exact"), ("tabular", "a table"), ("network", "a network")):
        mine = [row["result"]["probabilities"] for row in found.results.rows if row["part"]["values"] == values]
        if mine:
            panels[name] = np.mean(mine, axis=0)
    rewards = (-2.0, -1.0, 1.0, 2.0)
    alt = f"Decoded probability of the rewards -2, -1, 1 and 2 at each step: {', '.join(panels)}."
    return Picture(figures.timelines(panels, rewards), alt)


def _aliasing(found: Found) -> Picture:
    bars = {name: each["right"] / each["of"] for name, each in found.results.summary.items()}
    alt = "Share of the codes of two states that are distinguished, by the kind of code."
    return Picture(figures.shares("codes of two states, distinguished", bars, _CHANCE), alt)


def _timescales(found: Found) -> Picture:
    """Episodes until a value is accurate over the distance to the end, at three of the discounts."""
    panels = []
    for rewards in found.results.summary:
        mine = [row["result"] for row in found.results.rows if row["part"]["rewards"] == rewards]
        gammas, bands = mine[0]["gammas"], []
        for i, g in enumerate((0, len(gammas) // 2, len(gammas) - 1)):
            distances = np.array([int(left) for left in mine[0]["episodes"]])
            when = np.array([[each["episodes"][str(left)][g] for left in distances] for each in mine])
            name = f"discount {gammas[g]:.3g}"
            bands.append(
                figures.Banded(name, action_colour(i), distances, when.min(axis=0), when.mean(axis=0), when.max(axis=0))
            )
        panels.append(figures.Panel(f"rewards: {rewards}", "steps to the end", bands))
    alt = "Episodes until a value is accurate, over the steps to the end of the episode, at three discounts."
    return Picture(
        figures.banded_curves("episodes until a value is accurate", panels, "episodes", type="log", dtick=1), alt
    )


def _deadlines(found: Found) -> Picture:
    rows = [
        Spread(title, f"T {horizon}", column[name]["mean"], column[name]["interval"], of_paper(name, horizon))
        for horizon, column in columns(found.results).items()
        for name, title in TITLES.items()
        if name in column
    ]
    alt = "Returns of LunarLander that is stopped after T steps, with 95% intervals and the numbers of the paper."
    return Picture(figures.spreads("return until T, 95% intervals", rows, "return"), alt)


def _acting(found: Found) -> Picture:
    rows = [
        Spread(rule, column, row["against greedy"]["mean"], row["against greedy"]["interval"])
        for column, rules in found.results.summary.items()
        for rule, row in rules.items()
        if rule != "greedy" and "against greedy" in row
    ]
    alt = "Paired differences of the return from greedy, with 95% intervals, by rule or solver and T."
    return Picture(figures.spreads("difference from greedy, 95% intervals", rows, "return"), alt)


def _curves(found: Found) -> Picture | None:
    """Over episodes as far as there are trainings, and the evaluations of the agents that ship over steps."""
    panels = []
    for environment in ENVIRONMENTS:
        name = world_title(environment)
        rows = over_episodes(found.results, environment)
        if rows:
            longest = max(len(each["returns"]) for several in rows.values() for each in several)
            reach = max(_LEAST_REACH, round(_REACH * longest))
            bands = [_over_episodes(algorithm, each, reach) for algorithm, each in rows.items()]
            title = f"{name}: training, mean of {2 * reach + 1} and raw"
            panels.append(figures.Panel(title, "episode", bands))
        known = found.results.summary.get(environment, {})
        curves = {each: known[each]["curves"] for each in ALGORITHMS if each in known and known[each]["curves"]}
        if curves:
            count = max(map(len, curves.values()))
            bands = [_over_steps(algorithm, several) for algorithm, several in curves.items()]
            panels.append(figures.Panel(f"{name}: evaluations, {count} seeds", "step", bands))
    if not panels:
        return None
    alt = "Interquartile means of the return with 95% bootstrap bands: " + "; ".join(each.title for each in panels)
    title = "return: interquartile mean, 95% band"
    return Picture(figures.banded_curves(title, panels), f"{alt}.")


def _over_steps(algorithm: str, curves: Sequence[TrainingCurve]) -> figures.Banded:
    steps, scores = at_steps(curves)
    return _interquartile(algorithm, steps, scores)


def _over_episodes(algorithm: str, rows: Sequence[Mapping[str, Any]], reach: int) -> figures.Banded:
    places, returns = at_episodes(rows, reach)
    raw = interquartile_band(at_episodes(rows, 0)[1])[1]
    return _interquartile(algorithm, places, returns, raw)


def _interquartile(
    algorithm: str, places: np.ndarray, returns: np.ndarray, raw: np.ndarray | None = None
) -> figures.Banded:
    low, middle, high = interquartile_band(returns)
    index = list(ALGORITHMS).index(algorithm)
    return figures.Banded(ALGORITHMS[algorithm], action_colour(index), places, low, middle, high, raw)


def _held_out(found: Found) -> Picture | None:
    rows = [
        Spread(
            label, "by the network" if how == "network" else "by a line", float(np.mean(each)), (min(each), max(each))
        )
        for label, ways in held_out_errors(found.results).items()
        for how, each in ways.items()
    ]
    if not rows:
        return _trained(found)
    alt = "Mean error of the values at the seven held-out discounts, from the lowest to the highest seed."
    return Picture(figures.spreads("error at held-out discounts, lowest to highest seed", rows, "reward a step"), alt)


def _endings(found: Found) -> Picture | None:
    rows = [
        Spread(f"{ending}, rows {reading}", f"T {horizon}", *there)
        for horizon in HORIZONS
        for ending in ENDINGS[1:]
        for reading in READINGS
        if (there := difference(found.results, ending, reading, horizon)) is not None
    ]
    if not rows:
        return _trained(found)
    alt = "Paired differences of the return from agents with the plain ending, with 95% intervals."
    return Picture(figures.spreads("difference from the plain ending, 95% intervals", rows, "return"), alt)


def _trained(found: Found) -> Picture | None:
    bands = []
    for i, cell in enumerate(found.results.cells):
        curves = [
            TrainingCurve(row["seed"], *(tuple(row["evaluations"][name]) for name in ("steps", "scores", "errors")))
            for row in cell["trainings"]
        ]
        if curves:
            seeds = f"{len(curves)} seed{'s' if len(curves) > 1 else ''}"
            bands.append(Band.of(f"{cell['label']}, {seeds}", action_colour(i), curves))
    alt = (
        f"Evaluations while training, from the lowest to the highest seed, of {', '.join(band.name for band in bands)}."
    )
    return Picture(shipped_curves("evaluations while training", bands), alt)


_DRAWN: dict[str, Callable[[Found], Picture | None]] = {
    "fig1_5": _codes,
    "fig3": _curves,
    "fig4": _toy,
    "fig6": _chain,
    "aliasing": _aliasing,
    "timescales": _timescales,
    "table1": _deadlines,
    "acting": _acting,
    "interpolation": _held_out,
    "termination": _endings,
}
"""What is drawn of each entry; trainings of any other are drawn as curves."""
