"""Scores of trainings, and the judgements that compare them: what the entries that are trained share. No torch here."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from laplace_core.experiments.paper import EXPERIMENTS
from laplace_core.experiments.paper.claims.entry import AGREES, DIFFERS, IN_PART, NEW, Finding, Line, Results
from laplace_core.experiments.paper.claims.words import spread

Judge = Callable[[Results], Finding | None]
SOLVED = 475.0
"""Mean return from which CartPole-v1 counts as solved, by gymnasium's own threshold."""


def scores_of(cell: Mapping[str, Any]) -> list[float]:
    """Of every seed that is finished, the best checkpoint's mean over 100 episodes."""
    return [float(row["best"]["score"]) for row in cell["trainings"]]


def cells_of(results: Results) -> dict[str, list[float]]:
    """Scores by the label of a cell; none where no seed is finished."""
    return {cell["label"]: scores_of(cell) for cell in results.cells if cell["trainings"]}


def learning(results: Results, label: str) -> list[float]:
    """Of every seed the mean of all evaluations while training: the sooner it learns, the higher."""
    rows = [row for cell in results.cells if cell["label"] == label for row in cell["trainings"]]
    return [float(np.mean(row["evaluations"]["scores"])) for row in rows]


def lines_of(name: str, paper: Mapping[str, str]) -> Callable[[Results], list[Line]]:
    """A line for each planned cell; ``paper`` has the paper's number by its label."""

    def lines(results: Results) -> list[Line]:
        found = cells_of(results)
        return [
            Line(cell.label, paper.get(cell.label, ""), spread(found[cell.label]) if cell.label in found else "")
            for cell in EXPERIMENTS[name].cells
        ]

    return lines


def above(high: Sequence[float], low: Sequence[float]) -> str:
    """Whether one setting scores higher than another: clearly, if its lowest seed is above the other's highest."""
    if min(high) > max(low):
        return AGREES
    return DIFFERS if np.mean(high) <= np.mean(low) else IN_PART


def higher(better: str, worse: str, told: str) -> Judge:
    """Judges a claim that one cell scores higher than another; ``told`` has both, as ``{better}`` and ``{worse}``."""

    def judge(results: Results) -> Finding | None:
        found = cells_of(results)
        if better not in found or worse not in found:
            return None
        state = above(found[better], found[worse])
        rest = {AGREES: "no seeds overlap", DIFFERS: "that is no gain", IN_PART: "the seeds overlap"}[state]
        words = told.format(better=spread(found[better]), worse=spread(found[worse]))
        return Finding(state, f"{words}: {rest}.")

    return judge


def beside(one: str, other: str, told: str) -> Judge:
    """Says how two cells score, where the paper has nothing of it; ``told`` has both, as ``{one}`` and ``{other}``."""

    def judge(results: Results) -> Finding | None:
        found = cells_of(results)
        if one not in found or other not in found:
            return None
        return Finding(NEW, told.format(one=spread(found[one]), other=spread(found[other])))

    return judge
