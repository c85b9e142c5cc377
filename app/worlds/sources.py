"""The subjects of the page: the listed worlds, and the user's own worlds, timelines and gamma-spaces."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from app import session
from laplace_core import PRESETS, InputError, Settings, World, load_world
from laplace_core.caching import cached
from laplace_core.exchange.links import fits as fits_in_link
from laplace_core.exchange.links import query_of
from laplace_core.files.packed_text import MOST, pack, unpack
from laplace_core.payloads.link import PARAM, Values
from laplace_core.study.settings import BY_NAME, ENCODING_NAMES, Resolved, resolve, resolve_for_gamma_space
from laplace_core.subjects import Exact, GammaSpaceFile, Subject, View, learner, plain_name, shown_seed
from laplace_core.tabular import Learned
from laplace_core.tabular.reading import study_settings
from laplace_core.worlds import TOY_TEXT, dump_world, parse_world, timeline_world
from laplace_core.worlds.timeline import timeline_rows_of

WORLDS = (*PRESETS, *(f"gym:{name}" for name in TOY_TEXT))
FIRST_WORLD = "two_branch"
OWN, TIMELINE, DATA = "own", "timeline", "data"
BROUGHT = (OWN, TIMELINE, DATA)
DATA_IS_GONE = "This link needs your gamma-space file, which a link cannot hold: open the file again."
WORLD_IS_GONE = "This link needs your world file, which is too large for a link: open the file again."
_DIGEST = re.compile(r"[0-9a-f]{12}")  # no packed word is one: all of those begin with eN
LEARN = "l."
"""Prefix of the settings of learning, in the session and in the URL."""


@cached(16)
def _timeline(word: str) -> World:
    return timeline_world(*timeline_rows_of(word))


def word_of(world: World) -> str:
    """The form of an own world in the values: all of it, packed; only the digest of a very large one.

    A link does not hold that one, but this session keeps it, in place of the last one.
    """
    text = dump_world(world)
    data = text.encode()
    return pack(text) if len(data) <= MOST else session.keep_opened(world, data)


def own_world(word: str) -> World:
    """The world of a word of :func:`word_of`.

    Raises:
        InputError: a word that was damaged, or a digest of a world that this session does not keep.
    """
    kept = session.opened(World).get(word)
    if kept is None and _DIGEST.fullmatch(word):
        raise InputError(WORLD_IS_GONE)
    return kept or _packed_world(word)


@cached(16)
def _packed_world(word: str) -> World:
    return parse_world(unpack(word))


def world_of(values: Values) -> World | None:
    """The world of a view; None where there is only a gamma-space.

    Raises:
        InputError: the values name no world that exists.
    """
    name = str(values.get("world", FIRST_WORLD))
    if name == DATA:
        return None
    if name in (OWN, TIMELINE):
        return (own_world if name == OWN else _timeline)(str(values.get(name, "")))
    return load_world(name, {key.removeprefix(PARAM): v for key, v in values.items() if key.startswith(PARAM)})


def gamma_space_files() -> Mapping[str, GammaSpaceFile]:
    """The gamma-space that this session has opened, by digest; one at a time."""
    return session.opened(GammaSpaceFile)


def open_gamma_space(name: str, data: bytes) -> str:
    """Check an uploaded gamma-space and keep it for this session; returns its digest.

    Raises:
        InputError: not such a file.
    """
    return session.keep_opened(GammaSpaceFile.opened(name, data), data)


def in_link(values: Values) -> bool:
    """Whether the link of a view holds all of it: neither too long nor with a file that only this session has."""
    kept = values.get("data") if values.get("world") == DATA else values.get(OWN)
    return fits_in_link(query_of(values)) and not _DIGEST.fullmatch(str(kept))


def world_values(world: World) -> dict[str, Any]:
    """The values that make a page show this world, whether it has a name here or not."""
    if world.source in WORLDS:
        return {"world": world.source, **{PARAM + name: value for name, value in world.params}}
    return {"world": OWN, OWN: word_of(world)}


def view_of(values: Values, learned: Learned | None = None) -> View:
    """The view of a set of values: exact or learned.

    Raises:
        InputError: values that do not fit each other.
    """
    world = world_of(values)
    given = {name: value for name, value in values.items() if name in BY_NAME}
    subject: Subject
    settings: Resolved
    if world is None:
        file = gamma_space_files().get(str(values.get("data", "")))
        if file is None:
            raise InputError(DATA_IS_GONE)
        state = given.get("state")
        subject = opened = file.at(None if state is None else str(state))
        given = {name: value for name, value in given.items() if name not in ENCODING_NAMES}
        settings = resolve_for_gamma_space(Settings(world=file.name, **given), opened.gamma_space.gammas)
    else:
        params = tuple(sorted((k.removeprefix(PARAM), v) for k, v in values.items() if k.startswith(PARAM)))
        wanted = Settings(world=world.source or file_name(world), params=params, **given)
        subject = Exact(world)
        if learned is not None:
            wanted = replace(wanted, paper_grid=None)  # it learned at its own discounts
            wanted = study_settings(learned.settings, wanted)
            subject = learner(world, learned, shown_seed(learned, str(values.get("learner", "mean"))))
        settings = resolve(wanted, world)
    names = subject.action_names
    action = names.index(values["action"]) if values.get("action") in names else 0
    return View(subject, settings, action)


def file_name(world: World) -> str:
    """The file name of a world that the user opened or edited."""
    return f"{plain_name(world)}.json"
