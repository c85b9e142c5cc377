"""One sentence on whether the decoded values choose well, and if not, which artefact is to blame.

The cause is found by experiment: an artefact causes a wrong choice if its remedy makes the choice right.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from laplace_core.artifacts import Artefact, Remedy, find_artefacts
from laplace_core.errors import InputError
from laplace_core.horizon import regret
from laplace_core.pipeline import Study, study
from laplace_core.ties import TIE_TOLERANCE, greedy_action
from laplace_core.worlds import load_world

VALUE_TOLERANCE = 0.1
"""Decoded values within this share of the largest true value count as right for the right reason."""


@dataclass(frozen=True)
class Verdict:
    """``right``: the best action, on values that hold. ``lucky``: the best action, on values that do not.

    ``wrong``: another action. ``unknown``: there is no world to compare with.
    """

    kind: Literal["right", "lucky", "wrong", "unknown"]
    sentence: str
    chosen: int
    best: int | None = None
    regret: float = 0.0
    cause: Artefact | None = None

    @property
    def remedies(self) -> tuple[Remedy, ...]:
        return self.cause.remedies if self.cause else ()


def judge(found: Study, row: int) -> Verdict:
    """The verdict at the horizon of one row, ``found.horizons[row]``."""
    decoded, truth, names = found.decoded, found.truth, found.action_names
    values = decoded.horizon_values[:, row]
    chosen = int(greedy_action(values))
    at = f"At T = {found.horizons[row]:g}"
    numbers = _numbers(values, chosen)
    if truth is None:
        return Verdict("unknown", f"{at} the decoded values choose {names[chosen]}{numbers}.", chosen)
    best = int(greedy_action(truth.optimum[:, row]))
    lost = float(regret(truth.optimum[:, [row]], np.array([chosen]))[0])
    wrong = _is_wrong(found, row)
    if wrong:
        cause = _cause(found, row)
        sentence = f"{at} the decoded values choose {names[chosen]}{numbers}; the best is {names[best]}."
        return Verdict("wrong", f"{sentence} {_blame(found, row, cause)}", chosen, best, lost, cause)
    if found.world.n_actions == 1:
        true = truth.horizon_values[0, row]
        sentence = f"{at} the decoded value is {_two(values[0])}; the true one is {_two(true)}."
    else:
        sentence = f"{at} the decoded values choose {names[chosen]}{numbers}, and no action is better."
    off = _value_error(found, row)
    if off <= VALUE_TOLERANCE:
        return Verdict("right", f"{sentence} {_confirmation(found, row)}".strip(), chosen, best)
    cause = _cause(found, row)
    because = f"Cause: {cause.name}." if cause else "No single setting explains it: the resolution of the inverse does."
    return Verdict("lucky", f"{sentence} But a value is off by {100 * off:.0f}%. {because}", chosen, best, 0.0, cause)


def _numbers(values: np.ndarray, chosen: int) -> str:
    if len(values) < 2:
        return ""
    rival = np.delete(values, chosen).max()
    return f" ({_two(values[chosen])} v {_two(rival)})"


def _two(value: float) -> str:
    """Two decimals, and never a negative zero."""
    return f"{round(value, 2) + 0.0:.2f}"


def _confirmation(found: Study, row: int) -> str:
    if found.world.n_actions == 1:
        return ""
    true = found.truth.horizon_values[:, row]
    order = np.argsort(-true, kind="stable")[:2]
    return "True: " + ", ".join(f"{found.action_names[a]} {_two(true[a])}" for a in order) + "."


def _is_wrong(found: Study, row: int) -> bool:
    """Whether the chosen action loses anything, beyond a tie, against the best."""
    optimum = found.truth.optimum[:, row]
    chosen = greedy_action(found.decoded.horizon_values[:, row])
    return bool(optimum.max() - optimum[chosen] > TIE_TOLERANCE * max(1.0, abs(optimum.max())))


def _value_error(found: Study, row: int) -> float:
    true = found.truth.horizon_values[:, row]
    scale = max(np.abs(true).max(), 1e-2 * np.abs(found.world.reward_values).max(), 1e-9)
    return float(np.abs(found.decoded.horizon_values[:, row] - true).max() / scale)


def _all_artefacts(found: Study) -> list[Artefact]:
    """Artefacts of every action, each kind once, at its largest."""
    largest: dict[str, Artefact] = {}
    for action in range(len(found.action_names)):
        for artefact in find_artefacts(found, action):
            if artefact.name not in largest or artefact.size > largest[artefact.name].size:
                largest[artefact.name] = artefact
    return list(largest.values())


def _cause(found: Study, row: int) -> Artefact | None:
    """The first artefact whose remedy puts the choice (or, if it was right, the values) right."""
    wrong = _is_wrong(found, row)
    for artefact in _all_artefacts(found):
        for remedy in artefact.remedies:
            repaired = _repaired(found, remedy)
            if repaired is None or row >= repaired.settings.steps:
                continue
            if not (_is_wrong(repaired, row) if wrong else _value_error(repaired, row) > VALUE_TOLERANCE):
                return artefact
    return None


def _repaired(found: Study, remedy: Remedy) -> Study | None:
    settings = remedy.apply(found.settings)
    try:
        world = load_world(settings.world, dict(settings.params)) if remedy.changes_world else found.world
        return study(world, settings)
    except InputError:  # a remedy may ask for more than a study may hold
        return None


def _blame(found: Study, row: int, cause: Artefact | None) -> str:
    if cause is not None:
        return f"Cause: {cause.name}. {cause.sentence}"
    optimum = found.truth.optimum[:, row]
    follows = greedy_action(found.truth.horizon_values[:, row])
    if optimum.max() - optimum[follows] > TIE_TOLERANCE * max(1.0, abs(optimum.max())):
        return (
            f"No artefact of the inverse: even the true timeline is that of the policy for gamma "
            f"{found.settings.acting_gamma:g}, which does not aim at this deadline."
        )
    return "No single remedy is enough: the margin is below what the inverse resolves with these discounts."
