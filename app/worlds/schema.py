"""The parameters that a link of the page Worlds may hold, and the pinned view in it."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace

from app.catalogue import tabular
from app.worlds import sources
from app.worlds.sources import LEARN
from app.worlds.story import STORY
from laplace_core import InputError, Settings, World
from laplace_core.exchange.links import Check, Entries, Schema, Values, by_name, check_of
from laplace_core.files.packed_text import unpack
from laplace_core.parameters import Parameter
from laplace_core.payloads.link import ACTION, DRAWN, LOOK, OLD_SWITCHES, PARAM, check_reached
from laplace_core.study.pipeline import grids
from laplace_core.study.settings import BY_NAME, resolve
from laplace_core.tabular import LEARN_SCHEMA
from laplace_core.worlds import parameters_of

OPENING = {"world": sources.FIRST_WORLD, "normalise": "paper"}
"""The paper's Fig. 4c: what a visitor without a link sees."""

WORLD = (
    Parameter("world", OPENING["world"], help="What the page shows.", kind=str),
    Parameter(sources.OWN, None, help="Your own world, packed.", kind=str),
    Parameter(sources.TIMELINE, None, help="Your own timeline, packed.", kind=str),
    Parameter(sources.DATA, None, help="Your own gamma-space, named by the digest of its file.", kind=str),
)
"""What decides which other entries there are."""

VIEW = (
    ACTION,
    LOOK,
    Parameter(
        "compare", "tau-space", help="Space in which A and B are compared.", choices=("tau-space", "gamma-space")
    ),
    Parameter("source", "exact", help="Whether gamma-space is exact or learned.", choices=("exact", "learned")),
    Parameter("agent", None, help="An agent that learned before.", kind=str),
    Parameter("run", None, help="The run of learning that is shown.", kind=str),
    Parameter("learner", "mean", help="The learner shown, or the mean of all.", choices=("mean", *"01234567")),
    Parameter("edit", "no", help="Whether the world is shown as a table.", choices=("no", "yes")),
    STORY,
)
"""How it is looked at, beside the settings of the study."""

PIN = Parameter("pin", None, help="The view pinned as A, packed.", kind=str)


def _is_listed(values: Values) -> None:
    world = str(values["world"])
    if world not in (*sources.WORLDS, *sources.BROUGHT) or (world in sources.BROUGHT and world not in values):
        raise InputError(f"The link asks for an unknown world, {world[:40]!r}; the opening view is shown instead.")


def _was_brought_whole(values: Values) -> None:
    if values["world"] in sources.BROUGHT:
        sources.world_of(values)


def _is_one_of(name: str, members: Callable[[World], tuple[str, ...]]) -> Check:
    def test(values: Values) -> None:
        world = sources.world_of(values)
        if world is not None and name in values and values[name] not in members(world):
            raise InputError(f"{name} {str(values[name])[:40]!r} is not in {values['world']}.")

    return Check(test, drops=(name,))


def _grids_fit(values: Values) -> None:
    world = sources.world_of(values)
    if world is not None:
        given = {name: value for name, value in values.items() if name in BY_NAME}
        grids(resolve(Settings(world=values["world"], **given), world))


def _is_reached(name: str) -> Check:
    """A horizon, or steps used of one, that the timeline of the view is long enough for."""

    def test(values: Values) -> None:
        world = sources.world_of(values)
        if world is None or name not in values:
            return
        given = {name: value for name, value in values.items() if name in BY_NAME}
        check_reached(name, values, resolve(Settings(world=values["world"], **given), world))

    return Check(test, drops=(name,))


def _learner_is_there(values: Values) -> None:
    """Of a run that a link names, its settings tell how many learners there are."""
    shown = str(values.get("learner", "mean"))
    if values.get("source") != "learned" or not shown.isdecimal():
        return
    asked = values.get(f"{LEARN}seeds", by_name(*LEARN_SCHEMA)["seeds"].default)
    count = len(tabular.agent(values["agent"]).basis) if "agent" in values else int(str(asked))
    if int(shown) >= count:
        raise InputError(f"learner {shown} is not there: {count} learned, of which the first is 0.")


def _file_is_open(digest: str) -> None:
    if digest not in sources.gamma_space_files():
        raise InputError(sources.DATA_IS_GONE)


_ENTRIES = (
    Entries(by_name(*WORLD)),
    Check(_is_listed, lead=""),
    Entries(lambda values: by_name(*parameters_of(values["world"])), PARAM, owner=lambda values: str(values["world"])),
    Entries({**DRAWN, **by_name(*VIEW)}),
    Entries(by_name(*LEARN_SCHEMA), prefix=LEARN),
)
_CHECKS = (
    check_of("agent", tabular.agent, drops=("agent",)),
    Check(_was_brought_whole),
    Check(sources.world_of, drops=(f"{PARAM}*",)),
    _is_one_of("state", lambda world: world.states),
    _is_one_of("action", lambda world: world.actions),
    Check(_grids_fit, drops=("gamma*", "theta*")),
    _is_reached("horizon"),
    _is_reached("used"),
    Check(_learner_is_there, drops=("learner",)),
)
PINNED = Schema(
    opening=lambda: OPENING,
    assumed=lambda: {"world": OPENING["world"]},
    old=OLD_SWITCHES,
    steps=(*_ENTRIES, *_CHECKS),
)
"""A view that is pinned: it holds no other pinned view."""

LINK = replace(
    PINNED,
    steps=(
        *_ENTRIES,
        Entries(by_name(PIN)),
        *_CHECKS,
        check_of("pin", lambda word: unpinned(word), drops=("pin",)),
        check_of("data", _file_is_open, lead=""),  # a link carries no file: it has to be open in this session
    ),
)


def unpinned(word: str) -> Values:
    """The values of a pinned view.

    Raises:
        InputError: not a pinned view.
    """
    try:
        query = {str(name): str(value) for name, value in json.loads(unpack(word)).items() if name != "pin"}
    except (ValueError, AttributeError, RecursionError):
        raise InputError("the link holds no pinned view; copy it again in full.") from None
    values, notes = PINNED.read(query)
    if notes:
        raise InputError(f"the pinned view is not valid: {notes[0]}")
    return values
