"""One sentence on whether the decoded values choose well, and if not, which artefact is to blame.

The cause is found by experiment: an artefact causes a wrong choice if its remedy makes the choice right. A constant
horizon does not touch the first choice of an episode but later ones; it is blamed where acting by the time to go
takes its loss away.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from laplace_core.artifacts import Artefact, Remedy, find_artefacts
from laplace_core.artifacts.deadline import constant_horizon
from laplace_core.artifacts.look import Look
from laplace_core.errors import InputError
from laplace_core.horizon import regret
from laplace_core.pipeline import Study, study
from laplace_core.ties import TIE_TOLERANCE, greedy_action
from laplace_core.worlds import load_world

VALUE_TOLERANCE = 0.1
"""Decoded values within this share of the largest true value count as right for the right reason."""


@dataclass(frozen=True)
class Verdict:
    """``right``: the best action, on values that hold. ``lucky``: the best action, on values that do not, or in an
    episode that then goes wrong because its horizon is kept constant.

    ``wrong``: another action. ``unknown``: there is no world to compare with.
    """

    kind: Literal["right", "lucky", "wrong", "unknown"]
    sentence: str
    chosen: int
    best: int | None = None
    regret: float = 0.0
    cause: Artefact | None = None
    cause_action: str | None = None

    @property
    def remedies(self) -> tuple[Remedy, ...]:
        return self.cause.remedies if self.cause else ()


def judge(found: Study, row: int) -> Verdict:
    """The verdict at the horizon of one row, ``found.horizons[row]``."""
    decoded, truth, names = found.decoded, found.truth, found.action_names
    values = decoded.horizon_values[:, row]
    chosen = int(greedy_action(values))
    at = f"At T = {found.horizons[row]:g}"
    numbers = _numbers(values, chosen, names)
    if truth is None:
        return Verdict("unknown", f"{at} the decoded values choose {names[chosen]}{numbers}.", chosen)
    best = int(greedy_action(truth.optimum[:, row]))
    lost = float(regret(truth.optimum[:, [row]], np.array([chosen]))[0])
    if _is_wrong(found, row):
        cause, where = _cause(found, row)
        sentence = f"{at} the decoded values choose {names[chosen]}{numbers}; the best is {names[best]}."
        sentence = f"{sentence} {_blame(found, cause, where, row)}"
        return Verdict("wrong", sentence, chosen, best, lost, cause, where)
    elsewhere = _wrong_elsewhere(found, row)
    true = truth.horizon_values[:, row]
    if len(names) == 1:
        sentence = f"{at} the decoded value is {_two(values[0])}; the true one is {_two(true[0])}."
    else:
        sentence = f"{at} the decoded values choose {names[chosen]}{numbers}, and no action is better."
    if _value_error(found, row) <= VALUE_TOLERANCE:
        constant = constant_horizon(Look(found, chosen, found.horizons[row]))
        if constant is None:
            return Verdict("right", sentence + elsewhere, chosen, best)
        later = f" But with the same T at every step, {constant.shown}. Cause: {constant.name}. {constant.sentence}"
        return Verdict("lucky", sentence + later + elsewhere, chosen, best, 0.0, constant, names[chosen])
    off = int(np.argmax(np.abs(values - true)))
    cause, where = _cause(found, row)
    blame = f"Cause: {_named(found, cause, where)}." if cause else "No single setting explains it."
    if len(names) > 1:
        sentence += f" But {names[off]} is worth {_two(true[off])}, not {_two(values[off])}."
    return Verdict("lucky", f"{sentence} {blame}{elsewhere}", chosen, best, 0.0, cause, where)


def _numbers(values: np.ndarray, chosen: int, names: tuple[str, ...]) -> str:
    """The chosen value against the next best, with the digits that tell them apart."""
    if len(values) < 2:
        return ""
    others = np.where(np.arange(len(values)) == chosen, -np.inf, values)
    rival = int(np.argmax(others))
    if values[rival] >= values[chosen] - TIE_TOLERANCE * max(1.0, abs(values[chosen])):
        return f" (a tie at {_two(values[chosen])})"
    digits = next((n for n in (2, 3, 4) if round(values[chosen], n) != round(values[rival], n)), 2)
    whose = f" for {names[rival]}" if len(values) > 2 else ""
    return f" ({_two(values[chosen], digits)} v {_two(values[rival], digits)}{whose})"


def _two(value: float, digits: int = 2) -> str:
    """Two decimals, or more, and never a negative zero."""
    return f"{round(float(value), digits) + 0.0:.{digits}f}"


def _wrong_elsewhere(found: Study, row: int) -> str:
    """The other horizons at which the choice is wrong, as ranges: the strip of the page in words."""
    wrong = _wrong_rows(found)
    wrong[row] = False
    edges = np.flatnonzero(np.diff([0, *wrong, 0]))
    if not edges.size:
        return ""
    ranges = [
        f"{found.horizons[first]:g}" + (f" to {found.horizons[last - 1]:g}" if last - first > 1 else "")
        for first, last in zip(edges[::2], edges[1::2], strict=True)
    ]
    shown = ", ".join(ranges[:4]) + (", ..." if len(ranges) > 4 else "")
    return f" The choice is wrong at T = {shown}."


def _wrong_rows(found: Study) -> np.ndarray:
    """Whether the chosen action loses anything, beyond a tie, against the best; bool ``(K,)``, one a horizon."""
    optimum = found.truth.optimum
    tie = TIE_TOLERANCE * np.maximum(1.0, np.abs(optimum.max(axis=0)))
    return regret(optimum, found.decoded.actions) > tie


def _is_wrong(found: Study, row: int) -> bool:
    return bool(_wrong_rows(found)[row])


def _value_error(found: Study, row: int) -> float:
    true = found.truth.horizon_values[:, row]
    scale = max(np.abs(true).max(), 1e-2 * np.abs(found.world.reward_values).max(), 1e-9)
    return float(np.abs(found.decoded.horizon_values[:, row] - true).max() / scale)


def _all_artefacts(found: Study) -> list[tuple[Artefact, str]]:
    """Artefacts of every action, each kind once, at its largest, with the action's name."""
    largest: dict[str, tuple[Artefact, str]] = {}
    for action, name in enumerate(found.action_names):
        for artefact in find_artefacts(found, action):
            if artefact.name not in largest or artefact.size > largest[artefact.name][0].size:
                largest[artefact.name] = (artefact, name)
    return list(largest.values())


def _cause(found: Study, row: int) -> tuple[Artefact, str] | tuple[None, None]:
    """The first artefact whose remedy puts the choice (or, if it was right, the values) right, and its action."""
    wrong, horizon = _is_wrong(found, row), found.horizons[row]
    for artefact, name in _all_artefacts(found):
        for remedy in artefact.remedies:
            repaired = _repaired(found, remedy)
            if repaired is None or repaired.horizons[-1] < horizon:
                continue
            at = repaired.row_at(horizon)
            if not (_is_wrong(repaired, at) if wrong else _value_error(repaired, at) > VALUE_TOLERANCE):
                return artefact, name
    return None, None


def _repaired(found: Study, remedy: Remedy) -> Study | None:
    """The study under a remedy, on the same policy and learned basis; None where that cannot be had."""
    settings = remedy.apply(found.settings)
    if found.learned is not None and settings.policy != found.settings.policy:
        return None  # what was learned under one target policy says nothing of another
    try:
        world = load_world(settings.world, dict(settings.params)) if remedy.changes_world else found.world
        return study(world, settings, found.policy, found.learned)
    except InputError:  # a remedy may ask for more than a study may hold
        return None


def _named(found: Study, cause: Artefact, where: str) -> str:
    return cause.name if len(found.action_names) == 1 else f"{cause.name}, in {where}"


def _blame(found: Study, cause: Artefact | None, where: str | None, row: int) -> str:
    if cause is not None:
        return f"Cause: {_named(found, cause, where)}. {cause.sentence}"
    optimum = found.truth.optimum[:, row]
    follows = greedy_action(found.truth.horizon_values[:, row])
    if optimum.max() - optimum[follows] > TIE_TOLERANCE * max(1.0, abs(optimum.max())):
        return (
            f"No artefact of the inverse: even the true timeline is that of the policy for gamma "
            f"{found.settings.acting_gamma:g}, which does not aim at this deadline."
        )
    return "No single remedy is enough: the margin is below what the inverse resolves with these discounts."
