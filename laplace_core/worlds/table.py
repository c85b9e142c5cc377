"""A world as the rows of an editable table, and back.

One row is one outcome: state, action, probability, reward, next. What comes back from a table may hold anything in
any cell; it is refused with one sentence that names the row, counted from 1.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.parameters import NUMBER, as_text
from laplace_core.worlds.model import (
    END,
    MAX_OUTCOMES,
    MAX_REWARD,
    PROBABILITY_TOLERANCE,
    Outcome,
    World,
)

COLUMNS = ("state", "action", "probability", "reward", "next")


def world_rows(world: World) -> list[dict[str, Any]]:
    """Every outcome as a row of names and numbers, in the order of states and actions; next "END" terminates."""
    following = (*world.states, "END")  # END is -1: the last
    columns = (world.state, world.action, world.probability, world.reward, world.next_state)
    return [
        dict(zip(COLUMNS, (world.states[s], world.actions[a], p, r, following[successor]), strict=True))
        for s, a, p, r, successor in zip(*(column.tolist() for column in columns), strict=True)
    ]


def as_cells(rows: Iterable[Mapping[str, Any]]) -> list[dict[str, str | None]]:
    """Rows as a table on a page holds them, every cell a text.

    Cells of numbers may leave out what they cannot read: 2,5 becomes 25 and 1.5 steps become 15. What is typed into a
    text comes as it is, and what is no number is refused here.
    """
    return [{name: None if value is None else as_text(value) for name, value in row.items()} for row in rows]


def from_cells(row: Mapping[str, Any]) -> dict[str, Any]:
    """A row of a table of texts with its numbers as numbers; of a blank row nothing is left."""
    texts = {name: str(value).strip() for name, value in row.items() if value is not None}
    return {
        name: (int if name == "tau" else float)(float(text)) if NUMBER.fullmatch(text) and name != "action" else text
        for name, text in texts.items()
    }


def with_rows(world: World, rows: Iterable[Mapping[str, Any]]) -> World:
    """The world of the rows of a table that was opened with another one.

    Raises:
        InputError: as of :func:`world_from_rows`.
    """
    kept = ("name", "states", "actions", "start", "suggested", "positions")
    return world_from_rows(rows, **{name: getattr(world, name) for name in kept})


def world_from_rows(
    rows: Iterable[Mapping[str, Any]],
    *,
    name: str = "my_world",
    states: Sequence[str] | None = None,
    actions: Sequence[str] | None = None,
    start: Mapping[str, float] | np.ndarray | None = None,
    suggested: Mapping[str, Any] | None = None,
    positions: np.ndarray | None = None,
) -> World:
    """A world from the rows of a table. Blank rows are left out, and rows of probability 0 have no effect.

    Args:
        states, actions: names that are known beforehand, in their order; a new name in its column is added after
            them, in the order of appearance.
        start: P(first state), by name, or an array in the order of ``states``; the first state if None.
        positions: ``(len(states), 2)``; left out where the rows add a state, which would have no place.

    Raises:
        InputError: the first row that makes no sense, or the first state and action whose rows do not add up.
    """
    read = [(number, row) for number, row in enumerate(rows, 1) if not is_blank_row(row, COLUMNS)]
    if not read:
        raise InputError("the table has no rows; a world needs at least one.")
    if len(read) > MAX_OUTCOMES:
        raise InputError(f"the table has {len(read):,} rows; a world has at most {MAX_OUTCOMES:,}.")
    known = list(states or ())
    state_index = _indexed("state", known, read)
    action_index = _indexed("action", list(actions or ()), read)
    outcomes = [_outcome(number, row, state_index, action_index) for number, row in read]
    _check_totals(outcomes, list(state_index), list(action_index))
    grown = len(state_index) > len(known)
    return World.from_outcomes(
        name,
        state_index,
        action_index,
        [row for row in outcomes if row.probability > 0],
        start=_start(start, state_index, len(known)),
        suggested=suggested,
        positions=None if grown else positions,
    )


def rescaled(rows: Iterable[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """The same rows with the probabilities of every state and action divided by their sum.

    Raises:
        InputError: a row without a state, action or probability, or probabilities that add up to 0.
    """
    copies = [dict(row) for row in rows]
    totals: dict[tuple[str, str], float] = {}
    read = []
    for number, row in enumerate(copies, 1):
        if is_blank_row(row, COLUMNS):
            continue
        pair = (name_in(row, "state", number), name_in(row, "action", number))
        probability = probability_in(row, number, largest=MAX_REWARD)
        totals[pair] = totals.get(pair, 0.0) + probability
        read.append((row, pair, probability))
    for (state, action), total in totals.items():
        if total == 0:
            raise InputError(
                f"the probabilities of state {state[:40]!r}, action {action[:40]!r} are all 0: nothing to rescale."
            )
    for row, pair, probability in read:
        row["probability"] = probability / totals[pair]
    return copies


def is_blank_row(row: Mapping[str, Any], columns: Sequence[str]) -> bool:
    """Whether none of the columns holds anything."""
    return all(_is_blank(row.get(column)) for column in columns)


def name_in(row: Mapping[str, Any], column: str, number: int) -> str:
    """The name in a cell, without the blanks around it.

    Raises:
        InputError: an empty cell or anything but text.
    """
    value = row.get(column)
    if _is_blank(value):
        raise InputError(f"row {number} has no {column}: fill it in or delete the row.")
    if not isinstance(value, str):
        raise InputError(f"row {number}, {column} is {_show(value)}; it must be a name.")
    return value.strip()


def number_in(row: Mapping[str, Any], column: str, number: int, largest: float = MAX_REWARD) -> float:
    """The number in a cell, as a number or as text.

    Raises:
        InputError: an empty cell, no number, or one outside +-``largest``.
    """
    value: Any = row.get(column)
    if _is_blank(value):
        raise InputError(f"row {number} has no {column}: fill it in or delete the row.")
    if isinstance(value, str) and NUMBER.fullmatch(value.strip()):
        value = float(value)
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | float | np.integer | np.floating):
        point = ", with a point before its decimals" if isinstance(value, str) and "," in value else ""
        raise InputError(f"row {number}, {column} is {_show(value)}; it must be a number{point}.")
    size: Any = abs(value)
    if not size <= largest:
        raise InputError(f"row {number}, {column} is {_show(value)}; it must be a number within +-{largest:g}.")
    return float(value)


def probability_in(row: Mapping[str, Any], number: int, largest: float = 1.0 + PROBABILITY_TOLERANCE) -> float:
    """The probability in a row, from 0 to ``largest``."""
    value = number_in(row, "probability", number)
    if not 0.0 <= value <= largest:
        raise InputError(f"row {number}, probability is {value:.9g}; it must lie between 0 and 1.")
    return value


def _is_blank(value: object) -> bool:
    """Whether a table shows nothing for it: None, an empty text, NaN, or pandas' own NA and NaT."""
    if value is None or (isinstance(value, str) and not value.strip()):
        return True
    try:
        return bool(value != value)
    except (TypeError, ArithmeticError):  # NA is neither equal to itself nor not
        return True
    except ValueError:  # an array
        return False


def _show(value: object) -> str:
    if isinstance(value, str):
        return repr(value[:40])
    if isinstance(value, bool | np.bool_ | int | float | np.integer | np.floating):
        digits = isinstance(value, int) and value.bit_length() > 100  # repr() refuses thousands of digits
        return "a number with too many digits" if digits else str(value)[:40]
    return "neither a number nor a text"


def _indexed(column: str, known: list[str], read: list[tuple[int, Mapping[str, Any]]]) -> dict[str, int]:
    """Index of every name: the known ones, then the new ones of the column in the order of appearance."""
    index = {name: i for i, name in enumerate(known)}
    for number, row in read:
        given = row.get(column)
        name = given if isinstance(given, str) and given in index else name_in(row, column, number)
        if name == "END" or name == "*":
            raise InputError(f"row {number}, {column} is {name!r}, which is not a name of its own; name one {column}.")
        if name not in index and (len(name) > 100 or not name.isprintable()):
            raise InputError(f"row {number}, {column} must be 1 to 100 printable characters.")
        index.setdefault(name, len(index))
    return index


def _outcome(number: int, row: Mapping[str, Any], states: Mapping[str, int], actions: Mapping[str, int]) -> Outcome:
    probability, reward = probability_in(row, number), number_in(row, "reward", number)
    following = _matched(row, "next", number, states)
    if following != "END" and following not in states:
        raise InputError(f"row {number}, next is {following[:40]!r}, which is no state: give it a row, or write END.")
    state, action = _matched(row, "state", number, states), _matched(row, "action", number, actions)
    return Outcome(states[state], actions[action], probability, states.get(following, END), reward)


def _matched(row: Mapping[str, Any], column: str, number: int, known: Mapping[str, int]) -> str:
    """The name in a cell: as it stands if it is known so, else without the blanks around it."""
    given = row.get(column)
    return given if isinstance(given, str) and given in known else name_in(row, column, number)


def _check_totals(outcomes: list[Outcome], states: list[str], actions: list[str]) -> None:
    totals: dict[tuple[int, int], float] = {}
    for row in outcomes:
        pair = (row.state, row.action)
        totals[pair] = totals.get(pair, 0.0) + row.probability
    for s, state in enumerate(states):
        for a, action in enumerate(actions):
            if (s, a) not in totals:
                raise InputError(f"state {state!r} has no row for action {action!r}: add one.")
            if abs(totals[s, a] - 1.0) > PROBABILITY_TOLERANCE:
                raise InputError(
                    f"the probabilities of state {state!r}, action {action!r} add up to {totals[s, a]:.9g}; "
                    "they must add up to 1."
                )


def _start(start: Mapping[str, float] | np.ndarray | None, states: Mapping[str, int], known: int) -> np.ndarray | None:
    """P(first state) over all states, ``(S,)``."""
    if start is None:
        return None
    probabilities = np.zeros(len(states))
    if not isinstance(start, Mapping):
        if np.shape(start) != (known,):
            raise InputError(f"the start has {np.size(start)} probabilities for {known} states; give one a state.")
        probabilities[:known] = start
        return probabilities
    for name, probability in start.items():
        if name not in states:
            raise InputError(
                f"the start names the state {str(name)[:40]!r}, which has no row: add one or start elsewhere."
            )
        probabilities[states[name]] = probability
    return probabilities
