"""One sentence on a view: whether its choice, its values and its timeline are right, and if not, what is to blame.

A cause is named only if taking it away, and nothing else, was tried on this very view and repaired it
(:mod:`laplace_core.study.trials`); a remedy is offered on the same condition. A constant horizon does not touch the
first choice of an episode but later ones; it is blamed where acting by the time to go takes its loss away.

Finding a cause takes many runs. ``judge(..., explain=False)`` says what is wrong and leaves out why.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from laplace_core.code.ties import ROUNDING, greedy_action, tie_size
from laplace_core.inverse import is_linear
from laplace_core.study.artefacts.deadline import constant_horizon
from laplace_core.study.artefacts.look import Look
from laplace_core.study.grades import VALUE_TOLERANCE, Grade, Timeline, grade, timeline_error, timeline_grade
from laplace_core.study.horizon import regret
from laplace_core.study.pipeline import Study, WorldStudy
from laplace_core.study.trials import WHY, Remedy, Trials

MOST_REMEDIES = 3


@dataclass(frozen=True)
class Verdict:
    """The grades of a view's choice, values and timeline, and the cause of a fault.

    Attributes:
        choice: ``right``: the best action, on values that hold. ``lucky``: the best action, on values that do not, or
            in an episode that then goes wrong because its horizon is kept constant. ``wrong``: another action.
            ``unknown``: there is no world to compare with.
        timeline: grade of the tau-space of the action that is looked at; None without a world.
        timeline_error: share of that timeline's probability at the wrong step or reward.
        error: largest error of V_T, in units of reward; value_error: as a share of the largest true value.
        chosen, best: indices of actions; regret: what the choice loses, in units of reward.
        cause: what alone, taken away, repairs the view; where: the action whose value that brings nearest to the
            truth, or whose timeline it makes sound.
        remedies: what was tried on this view and repairs it, the usual choice first, at most one of them an alpha.
        exhausted: whether every single setting was tried and none repairs the view.
        searched: whether a cause was looked for, if there is anything to explain.
    """

    choice: Literal["right", "lucky", "wrong", "unknown"]
    timeline: Timeline | None
    sentence: str
    chosen: int
    best: int | None = None
    regret: float = 0.0
    error: float | None = None
    value_error: float | None = None
    timeline_error: float | None = None
    cause: Remedy | None = None
    where: str | None = None
    remedies: tuple[Remedy, ...] = ()
    exhausted: bool = False
    searched: bool = True

    @property
    def faultless(self) -> bool:
        """Whether choice, values and timeline are all right."""
        return self.choice == "right" and self.timeline == "sound"


def judge(
    study: Study, row: int, action: int | None = None, *, explain: bool = True, trials: Trials | None = None
) -> Verdict:  # fmt: skip
    """The verdict at the horizon of one row, ``study.horizons[row]``.

    Args:
        action: whose timeline is graded; default: the chosen one.
        explain: whether to search for a cause and remedies.
        trials: of this very view, where they are there already.

    Raises:
        InputError: a row or an action that the study does not have.
    """
    study.check_view(row, action)
    names, decoded, read = study.action_names, study.at(row), study.reading(row)[0]
    values = decoded.horizon_values[:, read]
    chosen = int(greedy_action(values, scale=decoded.scale))
    at = _where_read(study, row)
    numbers = _numbers(values, decoded.scale, chosen, names)
    if not isinstance(study, WorldStudy):
        words = f"the decoded values choose {names[chosen]}{numbers}"
        if len(names) == 1:
            words = f"the decoded value is {in_words(values.tolist(), decoded.scale)[0]}"
        return Verdict("unknown", None, f"{at} {words}.", chosen)
    looked_at = chosen if action is None else action
    graded, misplaced = grade(study, row), timeline_error(study, looked_at, decoded)
    verdict = Verdict(
        "wrong" if graded.wrong else "lucky" if graded.off else "right",
        timeline_grade(misplaced),
        "",
        chosen,
        graded.best,
        graded.regret,
        graded.error,
        graded.value_error,
        misplaced,
    )
    first = _first_words(study, row, graded, verdict, choice=f"{at} the decoded values choose {names[chosen]}{numbers}")
    last = ("" if graded.wrong else _wrong_elsewhere(study, row)) + _timeline_words(verdict, names[looked_at])
    if verdict.choice == "right" and study.settings.deadline == "constant":
        constant = constant_horizon(Look(study, chosen, study.horizons[row]))
        if constant is not None:
            change = replace(constant.remedies[0], name=constant.name)
            later = f" But with the same T at every step, {constant.shown}. Cause: {constant.name}. {constant.sentence}"
            sentence = first + later + last
            return replace(
                verdict, choice="lucky", sentence=sentence, cause=change, where=names[chosen], remedies=(change,)
            )
    if verdict.faultless:
        return replace(verdict, sentence=first + last)
    if not explain:
        return replace(verdict, sentence=first + last, searched=False)
    explained, why = _explained(trials or Trials(study, row, action), verdict)
    if verdict.choice == "right":  # the cause is one of the timeline
        return replace(explained, sentence=f"{first}{last}{why}")
    return replace(explained, sentence=f"{first}{why}{last}")


def _first_words(study: WorldStudy, row: int, graded: Grade, verdict: Verdict, *, choice: str) -> str:
    """The chosen action in words, and whether the choice and the values are right."""
    read, left = study.reading(row)
    decoded, names = study.at(row), study.action_names
    values, true = decoded.horizon_values[:, read], study.truth.horizon_values[:, left]
    if verdict.choice == "wrong":
        return f"{choice}; the best is {names[graded.best]}."
    off, scale = int(np.argmax(np.abs(values - true))), decoded.scale
    if len(names) == 1:
        decoded_value, truly = in_words((values[0], true[0]), scale)
        return f"{_where_read(study, row)} the decoded value is {decoded_value}; the true one is {truly}."
    sentence = f"{choice}, and no action is better."
    if verdict.choice == "right":
        return sentence
    decoded_value, truly = in_words((values[off], true[off]), scale, apart=True)
    return f"{sentence} But {names[off]} is worth {truly}, not {decoded_value}."


def _where_read(study: Study, row: int) -> str:
    read, left = study.reading(row)
    if not study.settings.used:
        return f"At T = {study.horizons[row]:g}"
    return (
        f"With {study.horizons[left]:g} of {study.horizons[row]:g} steps to go, read at T = {study.horizons[read]:g},"
    )


def _timeline_words(verdict: Verdict, name: str) -> str:
    size = verdict.timeline_error
    if verdict.timeline == "sound" or size is None:
        return ""
    if round(100 * size) <= 100:  # where all is misplaced, rounding may add to it
        return f" Timeline of {name}: {verdict.timeline}, {100 * size:.0f}% misplaced."
    return f" Timeline of {name}: ruined, off by {size:.3g} times all that truly comes."


def _explained(trials: Trials, verdict: Verdict) -> tuple[Verdict, str]:
    """The verdict with its cause, and the cause in words."""
    if not trials.affordable:
        slow = "the view is too large" if is_linear(trials.settings.solver) else "this solver takes too long for that"
        return replace(verdict, searched=False), f" Its cause was not searched for: {slow}."
    repairing = [change for change in trials.switches if trials.repairs(change)]
    repairing = _one_each(repairing)
    if trials.learned_wrong:
        cause = Remedy("", {}, "not learned yet")
        return replace(verdict, cause=cause, remedies=tuple(repairing[:MOST_REMEDIES])), _blame(cause, None)
    alpha = trials.alpha
    if alpha is not None:
        repairing.append(trials.alpha_change(alpha))
    repairing += [change for change in trials.solvers if trials.repairs(change)][:1]
    if not repairing:
        repairing = next(([change] for change in trials.grids if trials.repairs(change)), [])
    if repairing:
        cause = repairing[0]
        names = trials.study.action_names
        where = names[trials.action] if verdict.choice == "right" else _where(trials, cause)
        verdict = replace(verdict, cause=cause, where=where, remedies=tuple(repairing[:MOST_REMEDIES]))
        return verdict, _blame(cause, where if len(names) > 1 else None)
    if trials.doubtful:
        words = " Some single setting repairs it under this noise, but none under most other noise: none is named."
        return verdict, words + _not_tried(trials)
    return replace(verdict, exhausted=True), _exhausted(trials, verdict) + _not_tried(trials)


def _not_tried(trials: Trials) -> str:
    """What a search leaves out for its time."""
    names = {"nonnegative": "non-negative solver", "feasible": "feasible one"}
    if not trials.too_slow:
        return ""
    left_out = [names[str(change.changes["solver"])] for change in trials.too_slow]
    return f" Not tried, as it takes too long here: the {' and the '.join(left_out)}."


def _one_each(changes: Sequence[Remedy]) -> list[Remedy]:
    """The first of several changes of one setting: fewer rows, or the smaller step, are enough."""
    first: dict[tuple[str, ...], Remedy] = {}
    for each in changes:
        first.setdefault(tuple(each.changes), each)
    return list(first.values())


def _where(trials: Trials, change: Remedy) -> str | None:
    """The action whose value the change brings nearest to the truth."""
    trial = trials.run(change)
    if trial is None:
        return None
    before, after = _off(trials.study, trials.row), _off(trial.study, trial.row)
    return trials.study.action_names[int(np.argmax(before - after))]


def _off(study: WorldStudy, row: int) -> np.ndarray:
    """By how much the value of each action is off at the horizon of a row, ``(A,)``."""
    read, left = study.reading(row)
    return np.abs(study.at(row).horizon_values[:, read] - study.truth.horizon_values[:, left])


def _blame(cause: Remedy, where: str | None) -> str:
    return f" Cause: {cause.name}{f', in {where}' if where else ''}. {WHY[cause.name]}"


def _exhausted(trials: Trials, verdict: Verdict) -> str:
    study, row = trials.study, trials.row
    if verdict.choice == "right":
        return " No single setting makes it sound."
    if verdict.choice == "lucky":
        return f" No single setting brings the values within {100 * VALUE_TOLERANCE:.0f}%."
    left = study.reading(row)[1]
    optimum = study.truth.optimum[:, left]
    follows = greedy_action(study.truth.horizon_values[:, left])
    if optimum.max() - optimum[follows] > tie_size(optimum.max(), np.abs(optimum).max()):
        return (
            f" No single setting explains it, and even the true timeline would mislead: it is that of the policy for "
            f"gamma {study.settings.acting_gamma:g}, which does not aim at this deadline."
        )
    return " No single setting explains it."


def _numbers(values: np.ndarray, scale: float, chosen: int, names: tuple[str, ...]) -> str:
    """The chosen value against the next best, with as many digits as they differ in."""
    if len(values) < 2:
        return ""
    others = np.where(np.arange(len(values)) == chosen, -np.inf, values)
    rival = int(np.argmax(others))
    if values[rival] >= values[chosen] - tie_size(values[chosen], scale):
        return f" (a tie at {in_words((values[chosen],), scale)[0]})"
    whose = f" for {names[rival]}" if len(values) > 2 else ""
    return f" ({' v '.join(in_words((values[chosen], values[rival]), scale, apart=True))}{whose})"


def in_words(values: Sequence[float], scale: float, *, apart: bool = False) -> tuple[str, ...]:
    """Values with two decimals each, never a negative zero; with two significant digits where all are below .01.

    Args:
        scale: size of the terms that the values are sums of; what is far below it is rounding, and shown as 0.
        apart: whether to show as many more digits as tell the values apart.
    """
    largest = max(abs(float(value)) for value in values)
    kind = "g" if ROUNDING * scale < largest < 0.01 else "f"

    def rounded(digits: int) -> tuple[str, ...]:
        numbers = (float(value) if kind == "g" else round(float(value), digits) for value in values)
        return tuple(f"{number + 0.0:.{digits}{kind}}" for number in numbers)

    enough = (n for n in (2, 3, 4, 6) if len(set(rounded(n))) == len(values))
    return rounded(next(enough, 2) if apart else 2)


def _wrong_elsewhere(study: WorldStudy, row: int) -> str:
    """The other horizons at which the choice is wrong, as ranges: the strip of the page in words."""
    wrong = wrong_rows(study)
    wrong[row] = False
    edges = np.flatnonzero(np.diff([0, *wrong, 0]))
    if not edges.size:
        return ""
    ranges = [
        f"{study.horizons[first]:g}" + (f" to {study.horizons[last - 1]:g}" if last - first > 1 else "")
        for first, last in zip(edges[::2], edges[1::2], strict=True)
    ]
    listed = ", ".join(ranges[:4]) + (", ..." if len(ranges) > 4 else "")
    return f" The choice is wrong at T = {listed}."


def wrong_rows(study: WorldStudy) -> np.ndarray:
    """Whether the chosen action loses anything, beyond a tie, against the best; bool ``(K,)``, one a horizon."""
    optimum = study.truth.optimum
    tie = tie_size(optimum.max(axis=0), np.abs(optimum).max(axis=0))
    return regret(optimum, study.decoded.actions) > tie
