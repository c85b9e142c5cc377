"""World files: a tabular MDP as JSON, validated before use and written in full.

The format is shown in the README. A file is refused with one sentence that names the entry at fault.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.files.strict_json import parse_json
from laplace_core.parameters import NUMBER
from laplace_core.worlds.model import END, MAX_OUTCOMES, MAX_REWARD, PROBABILITY_TOLERANCE, Outcome, World

MAX_BYTES = 50_000_000
_KEYS = {"name", "states", "actions", "start", "transitions", "positions"}


def read_world(path: str | Path) -> World:
    """Read a world file.

    Raises:
        InputError: missing, too large, not UTF-8, or not a world.
    """
    path = Path(path)
    try:
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except OSError as error:
        raise InputError(f"{path.name} cannot be read: {(error.strerror or 'unknown error').lower()}.") from None
    except ValueError:  # a zero byte, or a character that the file system cannot hold
        raise InputError(f"{path.name!r} cannot be the name of a file.") from None
    return parse_world_bytes(content, path.name)


def parse_world_bytes(content: bytes, name: str = "the world file") -> World:
    """Build a world from the content of a world file, wherever it came from: a disk, an upload.

    Args:
        name: what to call it in a refusal.

    Raises:
        InputError: too large, not UTF-8, or not a world.
    """
    return parse_world(world_text(content, name))


def world_text(content: bytes, name: str = "the world file") -> str:
    """The text of a world file: UTF-8, with or without a byte order mark, which is not part of the text.

    Args:
        name: what to call it in a refusal.

    Raises:
        InputError: too large, or another encoding.
    """
    name = name[:60] if name.isprintable() else repr(name[:60])
    if len(content) > MAX_BYTES:
        raise InputError(f"{name} is larger than {MAX_BYTES // 1_000_000} MB; a world file is not.")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:  # UTF-16 and UTF-32 of plain letters decode as well, with zeros between them
        raise InputError(f"{name} is not UTF-8 text: save it with the encoding UTF-8.")
    return text


def parse_world(text: str) -> World:
    """Build a world from the text of a world file.

    Raises:
        InputError: the first entry that makes no sense, by name.
    """
    document = parse_json(text, "the world file")
    if not isinstance(document, dict):
        raise InputError("the world file must hold one JSON object, with states, actions and transitions.")
    for key in document:
        if key not in _KEYS:
            raise InputError(f"the world file has an unknown entry {key[:40]!r}; known are {', '.join(sorted(_KEYS))}.")
    for key in ("states", "actions", "transitions"):
        if not isinstance(document.get(key), list) or not document[key]:
            raise InputError(f"{key!r} must be a list with at least one entry.")
    name = document.get("name", "my_world")
    if not isinstance(name, str) or not 1 <= len(name) <= 100 or not name.isprintable():
        raise InputError("'name' must be 1 to 100 printable characters.")
    states, actions = document["states"], document["actions"]
    for key, entries in (("states", states), ("actions", actions)):
        for entry in entries:
            if not isinstance(entry, str):
                raise InputError(f"{key!r} holds {_show(entry)}; every entry must be a name in quotes.")
    world = World.from_outcomes(
        name,
        states,
        actions,
        _parse_transitions(document["transitions"], states, actions),
        start=_parse_start(document["start"], states) if "start" in document else None,
    )
    return (
        replace(world, positions=_parse_positions(document["positions"], states)) if "positions" in document else world
    )


def dump_world(world: World) -> str:
    """The text of a world file that :func:`parse_world` turns into the same world: one transition a line."""
    start = {world.states[s]: float(world.start[s]) for s in np.flatnonzero(world.start)}
    head: dict[str, object] = {"name": world.name, "states": world.states, "actions": world.actions, "start": start}
    if world.positions is not None:
        places = np.asarray(world.positions, dtype=float).tolist()
        head["positions"] = dict(zip(world.states, places, strict=True))
    write = json.JSONEncoder(allow_nan=False).encode  # without an indent, which Python would write itself, slowly
    entries = ",\n".join(f" {write(name)}: {write(entry)}" for name, entry in head.items())
    transitions = ",\n".join(f"  {write(transition)}" for transition in _transitions(world))
    return f'{{\n{entries},\n "transitions": [\n{transitions}\n ]\n}}'


def _transitions(world: World) -> Iterator[dict[str, object]]:
    """The entry of each state and action."""
    names = (*world.states, "END")  # END is -1 and picks the last
    columns = (world.probability.tolist(), world.next_state.tolist(), world.reward.tolist())
    rows = [{"p": p, "next": names[following], "reward": reward} for p, following, reward in zip(*columns, strict=True)]
    pairs = world.state * world.n_actions + world.action
    ends = np.cumsum(np.bincount(pairs, minlength=world.n_states * world.n_actions)).tolist()
    first = 0
    for (state, action), end in zip(product(world.states, world.actions), ends, strict=True):
        yield {"state": state, "action": action, "outcomes": rows[first:end]}
        first = end


def _show(value: object) -> str:
    if isinstance(value, list | dict):
        return "a list" if isinstance(value, list) else "an object"
    return repr(value[:40]) if isinstance(value, str) else json.dumps(value)[:40]


def _number(value: object, where: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(f"{where} is {_show(value)}; it must be a number.")
    if not abs(value) <= MAX_REWARD:
        raise InputError(f"{where} is {_show(value)}; it must be a number within +-{MAX_REWARD:g}.")
    return float(value)


def _probability(value: object, where: str) -> float:
    number = _number(value, where)
    if not 0.0 <= number <= 1.0 + PROBABILITY_TOLERANCE:
        raise InputError(f"{where} is {number:.9g}; a probability lies between 0 and 1.")
    return number


def _distribution(table: object, where: str) -> dict[str, float]:
    if not isinstance(table, dict) or not table:
        raise InputError(f"{where} must be an object of probabilities, such as {{...: 1.0}}.")
    probabilities = {key: _probability(value, f"{where}, {key[:40]!r}") for key, value in table.items()}
    if abs(sum(probabilities.values()) - 1.0) > PROBABILITY_TOLERANCE:
        raise InputError(
            f"the probabilities of {where} add up to {sum(probabilities.values()):.9g}; they must add up to 1."
        )
    return probabilities


def _state(name: object, index: dict[str, int], where: str) -> int:
    if not isinstance(name, str) or name not in index:
        raise InputError(f"{where} names the state {_show(name)}, which is not in 'states'.")
    return index[name]


def _successor(name: object, index: dict[str, int], where: str) -> int:
    return END if name == "END" else _state(name, index, where)


def _parse_start(table: object, states: list[str]) -> np.ndarray:
    index = {name: i for i, name in enumerate(states)}
    start = np.zeros(len(states))
    for name, probability in _distribution(table, "'start'").items():
        start[_state(name, index, "'start'")] = probability
    return start


def _parse_positions(table: object, states: list[str]) -> np.ndarray:
    """Where to draw the states, ``(S, 2)``: all of them, so that no state is left without a place."""
    index = {name: i for i, name in enumerate(states)}
    if not isinstance(table, dict):
        raise InputError(f"'positions' is {_show(table)}; it must be an object of places, such as {{...: [0, 1]}}.")
    positions = np.empty((len(states), 2))
    for name, place in table.items():
        s = _state(name, index, "'positions'")
        where = f"'positions', {name[:40]!r}"
        if not isinstance(place, list) or len(place) != 2:
            raise InputError(f"{where} must be a pair of numbers, [x, y].")
        positions[s] = [_number(coordinate, where) for coordinate in place]
    if missing := [name for name in states if name not in table]:
        raise InputError(f"'positions' lacks the state {missing[0]!r}; place every state or leave 'positions' out.")
    positions.setflags(write=False)
    return positions


def _parse_transitions(entries: list[object], states: list[str], actions: list[str]) -> Iterator[Outcome]:
    """Outcomes of every (state, action); ``*`` fills the actions that no entry of that state names.

    A generator, so that the world checks the names of states and actions before the first entry is read.
    """
    state_index = {name: i for i, name in enumerate(states)}
    action_index = {name: i for i, name in enumerate(actions)}
    covered: dict[tuple[int, int], list[tuple[float, int, float]]] = {}
    fillers: dict[int, list[tuple[float, int, float]]] = {}
    size = 0
    for number, entry in enumerate(entries):
        where = f"transitions[{number}]"
        if not isinstance(entry, dict):
            raise InputError(f"{where} is {_show(entry)}; it must be an object with state, action, next and reward.")
        joint = "outcomes" in entry
        wanted = {"state", "action", "outcomes"} if joint else {"state", "action", "next", "reward"}
        if missing := wanted - set(entry):
            raise InputError(f"{where} lacks {sorted(missing)[0]!r}.")
        if unknown := set(entry) - wanted:
            listed = ", ".join(sorted(wanted))
            raise InputError(f"{where} has an unknown entry {sorted(unknown)[0][:40]!r}; it takes {listed}.")
        s = _state(entry["state"], state_index, where)
        rows = (_joint if joint else _independent)(entry, state_index, where)
        action = entry["action"]
        if not isinstance(action, str) or (action != "*" and action not in action_index):
            raise InputError(f"{where} names the action {_show(action)}, which is not in 'actions'.")
        if s in fillers if action == "*" else (s, action_index[action]) in covered:
            raise InputError(f"{where} covers state {states[s]!r}, action {action!r} a second time.")
        if action == "*":
            fillers[s] = rows
        else:
            covered[s, action_index[action]] = rows
        size += len(rows)
        if size > MAX_OUTCOMES:  # stop before a small file of products fills the memory
            raise InputError(f"{where} brings the world above {MAX_OUTCOMES:,} outcomes.")
    size = 0
    for s, state in enumerate(states):
        for a, action in enumerate(actions):
            outcomes = covered.get((s, a), fillers.get(s))
            if outcomes is None:
                raise InputError(f"no transition covers state {state!r}, action {action!r}; add it or use '*'.")
            size += len(outcomes)
            if size > MAX_OUTCOMES:
                raise InputError(f"the world has more than {MAX_OUTCOMES:,} outcomes.")
            yield from (Outcome(s, a, *row) for row in outcomes)


def _independent(entry: dict[str, Any], state_index: dict[str, int], where: str) -> list[tuple[float, int, float]]:
    successors = _distribution(entry["next"], f"{where}, 'next'")
    rewards: dict[float, float] = {}
    for text, p in _distribution(entry["reward"], f"{where}, 'reward'").items():
        if not NUMBER.fullmatch(text):
            raise InputError(f"{where} has the reward {text[:40]!r}; it must be a number in quotes.")
        value = _number(float(text), f"{where}, reward {text[:40]!r}")
        rewards[value] = rewards.get(value, 0.0) + p
    if len(successors) * len(rewards) > MAX_OUTCOMES:
        raise InputError(f"{where} has more than {MAX_OUTCOMES:,} combinations of next state and reward.")
    reached = [(_successor(name, state_index, where), p) for name, p in successors.items()]
    return [(p * q, successor, reward) for successor, p in reached for reward, q in rewards.items() if p * q > 0]


def _joint(entry: dict[str, Any], state_index: dict[str, int], where: str) -> list[tuple[float, int, float]]:
    if not isinstance(entry["outcomes"], list) or not entry["outcomes"]:
        raise InputError(f"{where}, 'outcomes' must be a list of objects with p, next and reward.")
    rows = []
    for number, outcome in enumerate(entry["outcomes"]):
        here = f"{where}, outcomes[{number}]"
        if not isinstance(outcome, dict) or set(outcome) != {"p", "next", "reward"}:
            raise InputError(f"{here} must have exactly p, next and reward.")
        p = _probability(outcome["p"], f"{here}, 'p'")
        rows.append(
            (p, _successor(outcome["next"], state_index, here), _number(outcome["reward"], f"{here}, 'reward'"))
        )
    total = sum(row[0] for row in rows)
    if abs(total - 1.0) > PROBABILITY_TOLERANCE:
        raise InputError(f"the probabilities of {where} add up to {total:.9g}; they must add up to 1.")
    return [row for row in rows if row[0] > 0]
