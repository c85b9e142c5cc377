"""The state of a page as URL values, and back: a typed whitelist, never trusted."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from app import sources
from app.link import translated, unpack
from app.sources import LEARN, PARAM
from laplace_core import InputError, Settings
from laplace_core.learned import LEARN_SCHEMA
from laplace_core.parameters import Parameter, as_text, parse_named
from laplace_core.pipeline import grids
from laplace_core.settings import BY_NAME, resolve
from laplace_core.worlds import parameters_of

OPENING = {"world": sources.FIRST_WORLD, "normalise": "paper"}
"""The paper's Fig. 4c: what a visitor without a link sees."""

VIEW = (
    Parameter("action", None, help="Action whose spaces are shown.", kind=str),
    Parameter("look", "heatmap", help="How the spaces are drawn.", choices=("heatmap", "surface")),
    Parameter("own", None, help="Your own world, packed.", kind=str),
    Parameter("timeline", None, help="Your own timeline, packed.", kind=str),
    Parameter("data", None, help="Your own gamma-space, by the digest of its file.", kind=str),
    Parameter("pin", None, help="The view pinned as A, packed.", kind=str),
    Parameter(
        "compare", "tau-space", help="Which space A and B are compared in.", choices=("tau-space", "gamma-space")
    ),
    Parameter("source", "exact", help="Whether gamma-space is exact or learned.", choices=("exact", "learned")),
    Parameter("agent", None, help="An agent that learned before.", kind=str),
    Parameter("run", None, help="The run of learning that is looked at.", kind=str),
    Parameter("learner", "mean", help="The learner shown, or the mean of all.", choices=("mean", *"01234567")),
    Parameter("edit", "no", help="Whether the world is open as a table.", choices=("no", "yes")),
)
"""What is looked at, beside the settings of the study."""


def parse_query(query: Mapping[str, str]) -> tuple[dict[str, Any], list[str]]:
    """State and notes from URL values; the values are checked as strictly as those of the command line."""
    found: dict[str, Any] = {}
    notes: list[str] = []
    query = translated(query)
    world = query.get("world", OPENING["world"])
    if world not in (*sources.WORLDS, *sources.BROUGHT) or (world in sources.BROUGHT and world not in query):
        notes.append(f"The link asks for an unknown world, {world[:40]!r}; this is the opening view instead.")
        return dict(OPENING), notes
    found["world"] = world
    known = {**BY_NAME, **{parameter.name: parameter for parameter in VIEW}}
    known |= {LEARN + parameter.name: parameter for parameter in LEARN_SCHEMA}
    for name, text in query.items():
        try:
            if name.startswith(PARAM):
                bare = name.removeprefix(PARAM)
                found[name] = parse_named(world, parameters_of(world), {bare: text})[bare]
            elif name in known:
                found[name] = known[name].parse(text)
            elif name != "world":
                notes.append(f"The link has an entry {name[:40]!r} that means nothing here.")
        except InputError as error:
            notes.append(f"Left out of the link: {error}")
    if "agent" in found:
        try:
            sources.agent(str(found["agent"]))
        except InputError as error:
            notes.append(f"Left out of the link: {error}")
            del found["agent"]
    if "pin" in found:
        try:
            unpinned(found["pin"])
        except InputError as error:
            del found["pin"]
            notes.append(f"Left out of the link: {error}")
    if world == sources.DATA:
        return found, notes
    try:
        built = sources.world_of(found)
    except InputError as error:
        notes.append(f"Left out of the link: {error}")
        if world in sources.BROUGHT:
            return dict(OPENING), notes
        found = {name: value for name, value in found.items() if not name.startswith(PARAM)}
        built = sources.world_of(found)
    assert built is not None  # only a gamma-space from a file has no world
    for name, members in (("state", built.states), ("action", built.actions)):
        if name in found and found[name] not in members:
            notes.append(f"Left out of the link: {name} {str(found.pop(name))[:40]!r} is not in {world}.")
    try:
        values = {name: value for name, value in found.items() if name in BY_NAME}
        grids(resolve(Settings(world=world, **values), built))
    except InputError as error:
        notes.append(f"Left out of the link: {error}")
        found = {name: value for name, value in found.items() if not name.startswith(("gamma", "theta"))}
    return found, notes


def query_of(values: Mapping[str, Any]) -> dict[str, str]:
    return {name: as_text(value) for name, value in values.items()}


def unpinned(word: str) -> dict[str, Any]:
    """The values of a pinned view.

    Raises:
        InputError: not a pinned view.
    """
    try:
        query = {str(name): str(value) for name, value in json.loads(unpack(word)).items() if name != "pin"}
    except (ValueError, AttributeError, RecursionError):
        raise InputError("the link holds no pinned view; copy it again in full.") from None
    found, notes = parse_query(query)
    if notes:
        raise InputError(f"the pinned view does not hold: {notes[0]}")
    return found


def read_link(query: Mapping[str, str]) -> tuple[dict[str, Any], list[str]]:
    """:func:`parse_query`, and what this session lacks: a file that a link cannot carry."""
    found, notes = parse_query(query)
    if "data" in found and found["data"] not in sources.gamma_space_files():
        return dict(OPENING), [*notes, sources.DATA_IS_GONE]
    return found, notes
