"""A reward timeline drawn by hand, as a world: what is true of a world is then true of the drawing.

A row says that after ``action``, at step ``tau``, ``reward`` comes with ``probability``. The world has a state
"start", and after every action its own chain, one state for each step, which every action walks along.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal

import numpy as np

from laplace_core.errors import InputError
from laplace_core.files.packed_text import pack, unpack
from laplace_core.worlds.model import END, MAX_OUTCOMES, MAX_STATES, PROBABILITY_TOLERANCE, Outcome, World
from laplace_core.worlds.table import is_blank_row, name_in, number_in, probability_in

TIMELINE_RESTS = ("zero", "ended")
"""What the rest of a step's probability means: ``zero`` pays 0 and goes on, ``ended`` is over by then."""

MAX_TAU = 500
TIMELINE_COLUMNS = ("action", "tau", "reward", "probability")

Step = dict[float, float]
"""P(reward, alive) of one step."""


def timeline_world(rows: Iterable[Mapping[str, object]], rest: str = "zero", name: str = "timeline") -> World:
    """A world whose timeline from the state "start" is the one of the rows: P(r_tau = reward, alive | action).

    A chain ends after the last step of its action. Under ``rest`` "zero" it runs until then for certain; under
    "ended" the probabilities of a step add up to the chance to be alive, which starts at 1 and never rises, and a
    step without rows pays 0 to those who are alive before it.

    Raises:
        InputError: the first row that makes no sense, by its number from 1, or the first step that does not add up.
    """
    if rest not in TIMELINE_RESTS:
        raise InputError(f"rest must be one of {', '.join(TIMELINE_RESTS)}, not {str(rest)[:40]!r}.")
    drawn = _read(rows)
    names = list(drawn)
    lengths = [max(steps) + 1 for steps in drawn.values()]
    if sum(lengths) - len(lengths) + 1 > MAX_STATES:
        raise InputError(f"the timelines have {sum(lengths):,} steps; a world has at most {MAX_STATES:,}: draw fewer.")
    states, outcomes = ["start"], []
    size = 0
    for a, action in enumerate(names):
        first = len(states)  # the state of step 1; step 0 happens in "start"
        states += [f"{action}, tau {tau}" for tau in range(1, lengths[a])]
        for tau, (step, goes_on) in enumerate(_walk(action, drawn[action], lengths[a], rest)):
            here: int | Literal["start"] = "start" if tau == 0 else first + tau - 1
            onwards = (END, 0.0) if tau == lengths[a] - 1 else (first + tau, goes_on)
            size += 2 * len(step) * (1 if tau == 0 else len(names))
            if size > MAX_OUTCOMES:
                raise InputError(
                    f"the timelines make more than {MAX_OUTCOMES:,} outcomes: draw fewer rewards or actions."
                )
            outcomes += _outcomes(here, a, len(names), step, onwards=onwards[0], goes_on=onwards[1])
    longest = max(lengths) - 1
    suggested = {"gammas": 50, "alpha": 1e-3, "steps": longest + 3}
    return World.from_outcomes(name, states, names, outcomes, suggested=suggested)


def timeline_rows(
    timeline: np.ndarray, rewards: np.ndarray, actions: Sequence[str], digits: int = 4
) -> list[dict[str, object]]:
    """Rows that :func:`timeline_world` reads under "ended", from P(r_tau = rewards[v], alive | a), ``(A, N, V)``.

    Probabilities are whole multiples of 10^-digits. At every step they add up to the rounded survival, the largest
    remainders being rounded up, so that rounding never makes survival rise.
    """
    unit = 10**digits
    rows = []
    for action, steps in zip(actions, timeline[:, : MAX_TAU + 1], strict=True):
        for tau, masses in enumerate(steps):
            scaled = np.clip(masses, 0.0, None) * unit
            counts = np.floor(scaled + 1e-9)
            left = int(np.rint(scaled.sum()) - counts.sum())
            if left > 0:
                counts[np.argsort(counts - scaled, kind="stable")[:left]] += 1
            rows += [
                {"action": action, "tau": tau, "reward": float(reward), "probability": float(count / unit)}
                for reward, count in zip(rewards, counts, strict=True)
                if count > 0
            ]
    return rows


def _read(rows: Iterable[Mapping[str, object]]) -> dict[str, dict[int, Step]]:
    """Timelines by action and step; rows of the same reward at the same step are added up."""
    drawn: dict[str, dict[int, Step]] = {}
    totals: dict[tuple[str, int], float] = {}
    for number, row in enumerate(rows, 1):
        if is_blank_row(row, TIMELINE_COLUMNS):
            continue
        action = name_in(row, "action", number)
        if len(action) > 80 or not action.isprintable() or action in ("END", "*"):
            raise InputError(f"row {number}, action must be 1 to 80 printable characters, not END or *.")
        tau = number_in(row, "tau", number)
        if not 0 <= tau <= MAX_TAU or tau != int(tau):
            raise InputError(f"row {number}, tau is {tau:g}; it must be a whole number from 0 to {MAX_TAU}.")
        reward, probability = number_in(row, "reward", number), probability_in(row, number)
        step = drawn.setdefault(action, {}).setdefault(int(tau), {})
        reward = reward + 0.0  # -0 is 0
        step[reward] = step.get(reward, 0.0) + probability
        total = totals[action, int(tau)] = totals.get((action, int(tau)), 0.0) + probability
        if total > 1.0 + PROBABILITY_TOLERANCE:
            raise InputError(
                f"row {number} brings the probabilities of action {action[:40]!r} at tau {int(tau)} to "
                f"{total:.9g}; they must not exceed 1."
            )
    if not drawn:
        raise InputError("the timeline has no rows; draw at least one reward.")
    return drawn


def _walk(action: str, steps: dict[int, Step], length: int, rest: str) -> Iterator[tuple[Step, float]]:
    """For every step of a chain: P(reward | alive), and the chance to be alive at the step after it."""
    alive = 1.0
    for tau in range(length):
        step = {reward: p for reward, p in steps.get(tau, {}).items() if p > 0}
        if rest == "zero":
            left = 1.0 - sum(step.values())
            if left > 1e-12 or not step:
                step[0.0] = step.get(0.0, 0.0) + left
            total = following = 1.0
        else:
            if tau not in steps and alive > 0:
                step = {0.0: alive}
            total = sum(step.values())
            following = sum(steps[tau + 1].values()) if tau + 1 in steps else total
            _check_alive(action, tau, total, following)
        if not step:  # nobody is left, and nothing of this state is ever seen
            step, total = {0.0: 1.0}, 1.0
        yield {reward: p / total for reward, p in step.items()}, min(1.0, following / total)
        alive = following


def _check_alive(action: str, tau: int, total: float, following: float) -> None:
    if tau == 0 and abs(total - 1.0) > PROBABILITY_TOLERANCE:
        raise InputError(
            f"the probabilities of action {action[:40]!r} at tau 0 add up to {total:.9g}; the first step always "
            "happens, so they must add up to 1."
        )
    if following > total + PROBABILITY_TOLERANCE:
        raise InputError(
            f"the probabilities of action {action[:40]!r} rise from {total:.9g} at tau {tau} to {following:.9g} at "
            f"tau {tau + 1}; an episode that has ended does not come back."
        )


def _outcomes(
    here: int | Literal["start"], action: int, n_actions: int, step: Step, *, onwards: int, goes_on: float
) -> list[Outcome]:
    """One step of a chain: in "start" under its own action only, later under every action alike."""
    state, actions = (0, [action]) if here == "start" else (here, range(n_actions))
    ways = [(onwards, goes_on), (END, 1.0 - goes_on)]
    return [
        Outcome(state, a, p * q, successor, reward)
        for a in actions
        for reward, p in step.items()
        for successor, q in ways
        if p * q > 0
    ]


def packed_timeline(rows: Iterable[Mapping[str, object]], rest: str) -> str:
    """The rows of a timeline and its rest as one word."""
    return pack(json.dumps({"rest": rest, "rows": [[row.get(name) for name in TIMELINE_COLUMNS] for row in rows]}))


_FIRST_ROWS = [("now", 0, 5.0, 1.0), ("later", 3, 3.0, 0.6), ("later", 8, 10.0, 0.8)]
FIRST_TIMELINE = packed_timeline([dict(zip(TIMELINE_COLUMNS, row, strict=True)) for row in _FIRST_ROWS], "zero")


def timeline_rows_of(word: str) -> tuple[list[dict[str, Any]], str]:
    """Rows and what the rest of a step does, from a packed timeline.

    Raises:
        InputError: not a packed timeline.
    """
    try:
        timeline = json.loads(unpack(word))
        rows = [dict(zip(TIMELINE_COLUMNS, row, strict=True)) for row in timeline["rows"]]
        return rows, str(timeline["rest"])
    except (ValueError, TypeError, KeyError, RecursionError):
        raise InputError("the link holds no timeline; copy it again in full.") from None
