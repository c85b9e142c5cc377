"""World files that must be refused: one valid document, broken at every place in every way.

``CASES`` holds (id, text of the file, words that the refusal must contain).
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from copy import deepcopy

from tests.support.malformed_tables import NEAR_ENDS, NEAR_NUMBERS

VALID = {
    "name": "my_world",
    "states": ["start", "short", "long"],
    "actions": ["left", "right"],
    "start": {"start": 1.0},
    "transitions": [
        {"state": "start", "action": "left", "next": {"short": 1.0}, "reward": {"0": 1.0}},
        {"state": "start", "action": "right", "next": {"long": 0.5, "short": 0.5}, "reward": {"0": 1.0}},
        {"state": "short", "action": "*", "next": {"END": 1.0}, "reward": {"5": 0.25, "4": 0.75}},
        {"state": "long", "action": "left", "next": {"END": 1.0}, "reward": {"10": 1.0}},
        {
            "state": "long",
            "action": "right",
            "outcomes": [{"p": 0.25, "next": "END", "reward": 10}, {"p": 0.75, "next": "long", "reward": -1.5}],
        },
    ],
}
TEXT = json.dumps(VALID)
JOINT = 4
"""The place of the entry with joint outcomes."""

HUGE = 10**400
NOT_A_NAME = (None, True, 7, 1.5, [], {}, ["start"], {"start": 1})
BAD_NAMES = ("", "x" * 101, "two\nlines", "\x00", "\ud800", "\u202e", "END", "*")
NOT_A_LIST = (None, True, 0, 1.5, "", "start", {}, {"start": 1.0}, [])
NOT_A_TABLE = (None, True, 0, 1.5, "", "END", [], ["END"], [["END", 1.0]], {})
NOT_A_PROBABILITY = (None, True, False, "1.0", "", [], [1.0], {}, {"p": 1}, -1e-9, -1, 1.00001, 2, 1e300, HUGE, -HUGE)
NOT_A_REWARD = (None, True, "10", "", [], [10], {}, 1e10, -1e300, HUGE)
ODD_REWARDS = (
    *("nan", "NaN", "inf", "-inf", "Infinity", "1_0", "", " 5", "5 ", "5\n", "0x10", "1e", "e5", ".", "+", "-", "--5"),
    *("1,5", "1/2", "5.0.0", "\uff15", "\u0665", "\u00b2", "\u2212" + "5", "five", "None", "true", "5j", "1e5.0"),
    *("1e999", "-1e999", "1e10", "1e99999", "9" * 400, "1" * 100_000 + "x", "\x00", "5;", "[5]", '"5"', "5f", "1d5"),
)
RAW = {
    "empty": "",
    "blank": " \n\t",
    "a byte order mark": "\ufeff" + TEXT,
    "a trailing comma": TEXT[:-1] + ",}",
    "a comment": "// a world\n" + TEXT,
    "single quotes": TEXT.replace('"', "'"),
    "two documents": TEXT + TEXT,
    "words after the end": TEXT + " and more",
    "a line break in a name": TEXT.replace("my_world", "my\nworld"),
    "an octal number": TEXT.replace("0.25", "010", 1),
    "a hexadecimal number": TEXT.replace("0.25", "0x1", 1),
    "a plus sign": TEXT.replace("0.25", "+0.25", 1),
    "a bare point": TEXT.replace("0.25", ".25", 1),
    "a broken escape": TEXT.replace("my_world", "\\x41"),
    "python words": TEXT.replace("1.0", "None"),
    "yaml": "name: my_world\nstates: [start]\n",
    "xml": "<world/>",
}


def _changed(path: tuple, value: object) -> str:
    document = deepcopy(VALID)
    holder = document
    for key in path[:-1]:
        holder = holder[key]
    holder[path[-1]] = value
    return json.dumps(document)


def _without(path: tuple) -> str:
    document = deepcopy(VALID)
    holder = document
    for key in path[:-1]:
        holder = holder[key]
    del holder[path[-1]]
    return json.dumps(document)


def _places() -> Iterator[tuple[tuple, tuple, tuple[str, ...]]]:
    """Every place of ``VALID``: its path, the values that it cannot take, and what the refusal must name."""
    yield ("name",), (*NOT_A_NAME, *BAD_NAMES[:-2]), ("'name'",)
    for key in ("states", "actions", "transitions"):
        yield (key,), NOT_A_LIST, (f"'{key}'", "list")
    for key, twice in (("states", "long"), ("actions", "right")):
        yield (key, 0), NOT_A_NAME, (f"'{key}'", "name in quotes")
        yield (key, 0), (*BAD_NAMES, twice), (key[:-1],)
    yield ("start",), (*NOT_A_TABLE, {"nowhere": 1.0}, {"END": 1.0}, {"start": 1.0, "nowhere": 0.0}), ("'start'",)
    yield ("start", "start"), (*NOT_A_PROBABILITY, 0.0, 0.99999), ("'start'",)
    for number, entry in enumerate(VALID["transitions"]):
        here, where = ("transitions", number), f"transitions[{number}]"
        yield here, (None, True, 7, "start", [], ["start", "left"], {}), (where,)
        yield (*here, "state"), (*NOT_A_NAME, "nowhere", "END", "*", "", "START", "start "), (where, "state")
        yield (*here, "action"), (*NOT_A_NAME, "up", "END", "", "Left"), (where, "action")
        if number == JOINT:
            continue
        for key in ("next", "reward"):
            yield (*here, key), NOT_A_TABLE, (where, f"'{key}'")
            for name in entry[key]:
                yield (*here, key, name), (*NOT_A_PROBABILITY, 0.0), (where, f"'{key}'")
        yield (*here, "next"), ({"nowhere": 1.0}, {"*": 1.0}, {"end": 1.0}, {"END": 1.0, "up": 0.0}), (where, "state")
    yield ("transitions", 0, "reward"), tuple({text: 1.0} for text in ODD_REWARDS), ("transitions[0]", "reward")
    where = f"transitions[{JOINT}]"
    yield ("transitions", JOINT, "outcomes"), NOT_A_LIST, (where, "'outcomes'", "list")
    for row in (0, 1):
        here = ("transitions", JOINT, "outcomes", row)
        yield here, (None, True, 7, "END", [], {}, [0.25, "END", 10]), (where, f"outcomes[{row}]", "p, next and reward")
        yield (*here, "p"), NOT_A_PROBABILITY, (where, f"outcomes[{row}]", "'p'")
        yield (*here, "p"), (0.0, 0.5, 1.0), (where, "add up to")
        yield (*here, "next"), (*NOT_A_NAME, "nowhere", "*", "end", ""), (where, f"outcomes[{row}]", "state")
        yield (*here, "reward"), NOT_A_REWARD, (where, f"outcomes[{row}]", "'reward'")


def _keys() -> Iterator[tuple[str, str, tuple[str, ...]]]:
    """Keys that are missing, unknown or there twice, in every object."""
    for key in ("states", "actions", "transitions"):
        yield f"no {key}", _without((key,)), (f"'{key}'",)
    yield "unknown key", _changed(("rewards",), {}), ("'rewards'",)
    for number, entry in enumerate(VALID["transitions"]):
        where = f"transitions[{number}]"
        for key in entry:
            yield f"no {key} in {where}", _without(("transitions", number, key)), (where,)
        yield f"unknown key in {where}", _changed(("transitions", number, "prob"), 1.0), (where, "'prob'")
    for key in ("p", "next", "reward"):
        place = ("transitions", JOINT, "outcomes", 1)
        yield f"no {key} in an outcome", _without((*place, key)), (f"transitions[{JOINT}]", "outcomes[1]")
        yield f"{key} renamed", _changed((*place, key.upper()), 1), (f"transitions[{JOINT}]", "outcomes[1]")
    for number, member in enumerate(
        ('"name": "my_world"', '"start": 1.0', '"state": "short"', '"5": 0.25', '"p": 0.75')
    ):
        twice = TEXT.replace(member, f"{member}, {member}", 1)
        yield f"twice {number}", twice, (member.split(":")[0].strip('"'), "twice")
    many = "".join(f'"key {i}": 0, ' for i in range(60_000))
    yield "the last of many twice", f'{{{many}"key 59999": 0}}', ("'key 59999'", "twice")


def _sums() -> Iterator[tuple[str, str, tuple[str, ...]]]:
    """Probabilities that miss 1 by more than 1e-6."""
    for off in (1e-5, -1e-5, 0.1, -0.5):
        entry = ("transitions", 1, "next")
        yield f"next off by {off}", _changed(entry, {"long": 0.5, "short": 0.5 + off}), ("transitions[1]", "'next'")
        entry = ("transitions", 2, "reward")
        yield f"reward off by {off}", _changed(entry, {"5": 0.5, "4": 0.5 + off}), ("transitions[2]", "'reward'")
        entry = ("transitions", JOINT, "outcomes", 0, "p")
        yield f"outcomes off by {off}", _changed(entry, max(0.25 + off, 0.0)), (f"transitions[{JOINT}]", "add up to")
        yield f"start off by {off}", _changed(("start",), {"start": 0.5, "long": 0.5 + off}), ("'start'", "add up to")


def _coverage() -> Iterator[tuple[str, str, tuple[str, ...]]]:
    """Pairs that no entry covers, or that two do."""
    for number, entry in enumerate(VALID["transitions"]):
        yield f"no transitions[{number}]", _without(("transitions", number)), ("no transition covers", entry["state"])
        twice = [*VALID["transitions"], entry]
        yield f"transitions[{number}] twice", _changed(("transitions",), twice), ("transitions[5]", entry["state"])
    yield "a state more", _changed(("states",), [*VALID["states"], "new"]), ("no transition covers", "'new'")
    yield "an action more", _changed(("actions",), ["left", "right", "up"]), ("no transition covers", "'up'")
    many = [f"s{i}" for i in range(5_001)]
    yield "5,001 states", _changed(("states",), ["start", *many[1:]]), ("5001 states", "5,000")
    yield "5,001 actions", _changed(("actions",), many), ("5001 actions", "5,000")


def _texts() -> Iterator[tuple[str, str, tuple[str, ...]]]:
    """Texts that are no JSON document, or none that could be a world."""
    for literal in ("NaN", "Infinity", "-Infinity"):
        for number, place in enumerate(('"p": 0.25', '"reward": 10', '"5": 0.25', '"start": 1.0')):
            text = TEXT.replace(place, f"{place.split(':')[0]}: {literal}", 1)
            yield f"{literal} at {number}", text, (literal, "finite")
    for literal in ("1e999", "-1e999"):
        for number, place in enumerate(('"p": 0.25', '"reward": 10', '"5": 0.25', '"start": 1.0')):
            text = TEXT.replace(place, f"{place.split(':')[0]}: {literal}", 1)
            yield f"{literal} at {number}", text, ("Infinity", "must be a number")
    yield "5,000 digits", TEXT.replace("0.25", "9" * 5_000, 1), ("digits",)
    for bracket in ("[", '{"a":', '[{"a":'):
        yield f"100,000 times {bracket}", bracket * 100_000, ("nested",)
    for value in (None, True, 7, "world", [], [VALID], {}):
        yield f"document {value!r:.20}", json.dumps(value), ()
    for name, text in RAW.items():
        yield name, text, ("the world file is not JSON",)
    for offset in range(1, len(TEXT), len(TEXT) // 60):
        yield f"cut at {offset}", TEXT[:offset], ("the world file is not JSON", "line 1")


def _all_cases() -> Iterator[tuple[str, str, tuple[str, ...]]]:
    for path, values, named in _places():
        for number, value in enumerate(values):
            yield f"{'.'.join(map(str, path))}={value!r:.25}#{number}", _changed(path, value), named
    for catalogue in (_keys, _sums, _coverage, _texts):
        yield from catalogue()


CASES = list(_all_cases())


def _near_rewards() -> Iterator[tuple[str, str, str | None]]:
    for number in (0, 2):
        for text in NEAR_NUMBERS:
            yield f"reward {text!r}", _changed(("transitions", number, "reward"), {text: 1.0}), "reward"
    for text in ("5.0", "+5", "5e0", "05", "5.", "500e-2"):
        yield f"reward {text!r}", _changed(("transitions", 2, "reward"), {text: 0.25, "4": 0.75}), None
    for value in (5, 5.0, "5", [5], [5, 1], [[5, 1]], {"value": 5, "p": 1}, {"mean": 5}, {"5": "1"}, {"5": "100%"}):
        for number in range(JOINT):
            yield f"reward {value!r}", _changed(("transitions", number, "reward"), value), f"transitions[{number}]"


def _near_successors() -> Iterator[tuple[str, str, str | None]]:
    named = ("short", "END", 1, -1, ["short"], [["short", 1]], ["short", 1], {"state": "short", "p": 1}, {"short": "1"})
    for value in (*named, *({text: 1.0} for text in NEAR_ENDS), {"Short": 1.0}, {"short ": 1.0}, {"1": 1.0}):
        for number in range(JOINT):
            yield f"next {value!r}", _changed(("transitions", number, "next"), value), f"transitions[{number}]"
    for text in (*NEAR_ENDS, "Long", "long ", "2", 2, None, ["END"], {"END": 1}):
        yield f"next {text!r}", _changed(("transitions", JOINT, "outcomes", 0, "next"), text), "outcomes[0]"


def _near_probabilities() -> Iterator[tuple[str, str, str | None]]:
    for path in (("next", "short"), ("reward", "0")):
        for value in ("1", "1.0", "100%", 100, [1.0], {"p": 1}, True, None, -1, 1.5, "1/1", 0.999):
            yield f"{path} {value!r}", _changed(("transitions", 0, *path), value), "transitions[0]"
    for value in ("0.25", "25%", 25, [0.25], True, None, -0.25, "1/4", 0.2, ".25"):
        yield f"p {value!r}", _changed(("transitions", JOINT, "outcomes", 0, "p"), value), f"transitions[{JOINT}]"
    for value in ("start", 0, ["start"], [1, 0, 0], {"start": 100}, {"start": "1"}, {"Start": 1}, {"0": 1}, {"*": 1}):
        yield f"start {value!r}", _changed(("start",), value), "'start'"


def _near_keys() -> Iterator[tuple[str, str, str | None]]:
    for key in ("p", "prob", "probability", "to", "next_state", "done", "terminal", "terminated", "comment", "_note",
                "Reward", "rewards", "gamma", "discount"):  # fmt: skip
        for number in (0, 2, JOINT):
            yield f"{key} in an entry", _changed(("transitions", number, key), 1), f"transitions[{number}]"
    for key in ("gamma", "discount", "terminal", "terminal_states", "initial", "initial_state", "start_state", "P", "R",
                "n_states", "rewards", "goal", "horizon", "version", "description", "$schema", "Start"):  # fmt: skip
        yield f"{key} beside the others", _changed((key,), 1), repr(key)
    for value in ("any", "all", "**", "left,right", "left|right", ["left", "right"], 0, None, "Left", " left", "LEFT"):
        yield f"action {value!r}", _changed(("transitions", 2, "action"), value), "transitions[2]"
    for key in ("states", "actions"):
        for value in (3, "start,short,long", {"start": 0}, [0, 1, 2], [{"name": "start"}], ["start", "start"]):
            yield f"{key} {value!r}", _changed((key,), value), key[:-1]


NEAR = [case for kind in (_near_rewards, _near_successors, _near_probabilities, _near_keys) for case in kind()]
"""(what it is, text, word of the refusal; None where the text means the world of ``VALID``), in other conventions."""
