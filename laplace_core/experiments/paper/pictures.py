"""The picture of each entry that has one, from the raw results: a figure, and what it shows in words."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.agents.settings import algorithm_title
from laplace_core.experiments import shipped_agents
from laplace_core.experiments.paper.claims import Found
from laplace_core.experiments.paper.claims.deadlines import TITLES, columns, of_paper
from laplace_core.experiments.shipping import TrainingCurve
from laplace_core.figures import paper as figures
from laplace_core.figures.paper import Spread
from laplace_core.figures.theme import Figure, action_colour
from laplace_core.figures.training import Band, shipped_curves
from laplace_core.worlds.titles import world_title

CANNOT_DRAW = (LookupError, TypeError, ValueError, AttributeError, ArithmeticError)
"""What drawing raises where a file holds something else than was written."""
_COMPARED = ("laplace", "c51", "qrdqn", "dqn")
_CHANCE = 0.5


@dataclass(frozen=True)
class Picture:
    """A figure, and what it shows for those who cannot see it."""

    figure: Figure
    alt: str


def picture(found: Found, shipped: Path) -> Picture | None:
    """The picture of an entry; None where nothing of it is measured.

    Args:
        shipped: the folder of the agents that ship.
    """
    if not found.results.finished:
        return None
    return _shipped(shipped) if found.entry.name == "fig3" else _DRAWN.get(found.entry.name, _trained)(found)


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


def _shipped(folder: Path) -> Picture:
    environment = "LunarLander-v3"
    curves = shipped_agents.curves_for(folder, environment)
    bands = [
        Band.of(algorithm_title(name), action_colour(i), curves[name])
        for i, name in enumerate(_COMPARED)
        if name in curves
    ]
    title = f"{world_title(environment)}: evaluations, {max(len(each) for each in curves.values())} seeds"
    alt = f"Evaluations over the steps of training on {environment}, from the lowest to the highest seed."
    return Picture(shipped_curves(title, bands), alt)


def _trained(found: Found) -> Picture:
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


_DRAWN: dict[str, Callable[[Found], Picture]] = {
    "fig1_5": _codes,
    "fig4": _toy,
    "fig6": _chain,
    "aliasing": _aliasing,
    "table1": _deadlines,
    "acting": _acting,
}
"""What is drawn of each entry but of figure 3; trainings of any other are drawn as curves."""
