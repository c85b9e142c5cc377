"""What can be looked at: the listed worlds, and what a person brings along."""

from __future__ import annotations

import json
import re
from collections.abc import Hashable, Mapping
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from app import session
from app.link import pack, unpack
from laplace_core import (
    PRESETS,
    GammaSpace,
    InputError,
    Settings,
    Study,
    World,
    load_world,
    study,
    study_of_gamma_space,
)
from laplace_core.learned import Learned, parse_learned, read_learned
from laplace_core.learned.reading import study_settings
from laplace_core.saved import read_gamma_space, states_of
from laplace_core.settings import BY_NAME, ENCODING_NAMES, Resolved, resolve, resolve_for_gamma_space
from laplace_core.worlds import TOY_TEXT, dump_world, parse_world, timeline_world

WORLDS = (*PRESETS, *(f"gym:{name}" for name in TOY_TEXT))
FIRST_WORLD = "two_branch"
OWN, TIMELINE, DATA = "own", "timeline", "data"
BROUGHT = (OWN, TIMELINE, DATA)
TITLES = {OWN: "Your own world", TIMELINE: "Your own timeline", DATA: "Your own gamma-space"}
DATA_IS_GONE = (
    "The link shows a gamma-space from a file, which stays with the person who opened it: open the file again."
)
PARAM, LEARN = "p.", "l."
"""Prefixes of world parameters and of settings of learning, in the session and in the URL."""
SHIPPED = Path(__file__).resolve().parent.parent / "checkpoints"

Values = Mapping[str, Any]


def packed_timeline(rows: list[dict], rest: str) -> str:
    return pack(json.dumps({"rest": rest, "rows": [[row.get(name) for name in TIMELINE_COLUMNS] for row in rows]}))


TIMELINE_COLUMNS = ("action", "tau", "reward", "probability")
_FIRST_ROWS = [("now", 0, 5.0, 1.0), ("later", 3, 3.0, 0.6), ("later", 8, 10.0, 0.8)]
FIRST_TIMELINE = packed_timeline([dict(zip(TIMELINE_COLUMNS, row, strict=True)) for row in _FIRST_ROWS], "zero")


def timeline_rows_of(word: str) -> tuple[list[dict], str]:
    """Rows and what the rest of a step does, from a packed timeline.

    Raises:
        InputError: not a packed timeline.
    """
    try:
        told = json.loads(unpack(word))
        rows = [dict(zip(TIMELINE_COLUMNS, row, strict=True)) for row in told["rows"]]
        return rows, str(told["rest"])
    except (ValueError, TypeError, KeyError, RecursionError):
        raise InputError("the link holds no timeline; copy it again in full.") from None


@lru_cache(maxsize=16)
def _timeline(word: str) -> World:
    return timeline_world(*timeline_rows_of(word))


@lru_cache(maxsize=16)
def own_world(word: str) -> World:
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


@dataclass(frozen=True)
class GammaSpaceFile:
    """An uploaded ``.npz``, checked, and how many states it holds."""

    name: str
    data: bytes
    states: int


def gamma_space_files() -> Mapping[str, GammaSpaceFile]:
    """The gamma-space that this session has opened, by digest; one at a time."""
    return session.opened(GammaSpaceFile)


def open_gamma_space(name: str, data: bytes) -> str:
    """Check an uploaded gamma-space and keep it for this session; returns its digest.

    Raises:
        InputError: not such a file.
    """
    read_gamma_space(data, name=name)
    return session.keep_opened(GammaSpaceFile(name, data, states_of(data, name=name)), data)


class Subject(Hashable, Protocol):
    """What can be looked at: a world, what was learned of it, or a gamma-space that came without a world.

    Equal subjects show the same, so that what is cached for one is found again.
    """

    @property
    def world(self) -> World | None:
        """Where the truth comes from; None where there is only a gamma-space."""

    @property
    def learner(self) -> Learner | None:
        """What was learned of the world, where that is looked at."""

    @property
    def gamma_space(self) -> GammaSpace | None:
        """The one that is looked at where there is no world to make it from."""

    @property
    def action_names(self) -> tuple[str, ...]: ...

    @property
    def places(self) -> np.ndarray | None:
        """Of a network's sensitivities on the axis of its activation, ``(H,)``, in units of 1/slope."""

    @property
    def added(self) -> int:
        """How many of the discounts between two that were trained are interpolated."""

    def study(self, settings: Resolved) -> Study:
        """The subject, looked at through these settings.

        Raises:
            InputError: settings that do not fit the subject.
        """


class _Plain:
    """What most subjects lack."""

    @property
    def learner(self) -> Learner | None:
        return None

    @property
    def places(self) -> np.ndarray | None:
        return None

    @property
    def added(self) -> int:
        return 0


@dataclass(frozen=True)
class Exact(_Plain):
    """A world, solved exactly; equal where the world is the same object."""

    world: World

    @property
    def gamma_space(self) -> None:
        return None

    @property
    def action_names(self) -> tuple[str, ...]:
        return self.world.actions

    def study(self, settings: Resolved) -> Study:
        return study(self.world, settings)


@dataclass(frozen=True, eq=False)
class FromFile(_Plain):
    """A gamma-space from a file, which may follow another convention and is looked at for that."""

    gamma_space: GammaSpace

    @property
    def world(self) -> None:
        return None

    @property
    def action_names(self) -> tuple[str, ...]:
        return tuple(f"action {a}" for a in range(len(self.gamma_space.values)))

    def study(self, settings: Resolved) -> Study:
        return study_of_gamma_space(self.gamma_space, settings)


@lru_cache(maxsize=8)
def _from_file(data: bytes, state: str | None) -> FromFile:
    return FromFile(read_gamma_space(data, state))


@dataclass(frozen=True, eq=False)
class Learner:
    """What was learned of a world, through the eyes of one seed, or of the mean of all (``index`` None)."""

    world: World
    learned: Learned
    index: int | None

    @property
    def learner(self) -> Learner:
        return self

    @property
    def gamma_space(self) -> None:
        return None

    @property
    def places(self) -> None:
        return None

    @property
    def added(self) -> int:
        return 0

    @property
    def action_names(self) -> tuple[str, ...]:
        return self.world.actions

    def study(self, settings: Resolved) -> Study:
        return study(self.world, settings, learned=self.basis(self.world.state_index(state_in(settings))))

    def basis(self, state: int) -> np.ndarray:
        """The reward-indicator basis of a state, ``(A, G, V)``."""
        tables = self.learned.basis[:, state].astype(float)
        return tables.mean(axis=0) if self.index is None else tables[self.index]

    @property
    def tables(self) -> np.ndarray:
        """The reward-indicator basis of every state, ``(S, A, G, V)``."""
        tables = self.learned.basis.astype(float)
        return tables.mean(axis=0) if self.index is None else tables[self.index]

    @property
    def policy(self) -> np.ndarray:
        return self.learned.policies[self.index or 0]


@cache
def shipped_agents() -> tuple[str, ...]:
    """Names of the learned agents that come with the workbench."""
    return tuple(sorted(path.stem for path in SHIPPED.glob("*_td.safetensors")))


@lru_cache(maxsize=8)
def shipped_agent(name: str) -> Learned:
    if name not in shipped_agents():
        raise InputError(f"no agent {name[:40]!r} comes with the workbench; there are: {', '.join(shipped_agents())}.")
    return read_learned(SHIPPED / f"{name}.safetensors")


def opened_agents() -> Mapping[str, Learned]:
    """The agent that this session has opened from a file, by digest; one at a time."""
    return session.opened(Learned)


def open_agent(name: str, data: bytes) -> str:
    """Check an uploaded agent and keep it for this session; returns its digest.

    Raises:
        InputError: not such a file.
    """
    return session.keep_opened(parse_learned(data, name), data)


def agent(name: str) -> Learned:
    """An agent by the name that a link gives it.

    Raises:
        InputError: it neither ships with the workbench nor was opened here.
    """
    return opened_agents()[name] if name in opened_agents() else shipped_agent(name)


def world_values(world: World) -> dict[str, Any]:
    """The values that make a page show this world, whether it has a name here or not."""
    if world.source in WORLDS:
        return {"world": world.source, **{PARAM + name: value for name, value in world.params}}
    return {"world": OWN, OWN: pack(dump_world(world))}


@lru_cache(maxsize=16)
def about(learned: Learned, world: World) -> Learned:
    """The same tables about the world object that the page holds, so that what is cached per world is found again."""
    return replace(learned, world=world)


@lru_cache(maxsize=16)
def fits(learned: Learned, world: World) -> bool:
    """Whether an agent from a file learned this very world."""
    return dump_world(learned.world) == dump_world(world)


@lru_cache(maxsize=32)
def learner(world: World, learned: Learned, index: int | None) -> Learner:
    """The same object for the same words, so that what is cached per learner is found again."""
    return Learner(world, learned, index)


@dataclass(frozen=True, eq=False)
class Observed:
    """What a trained agent has learned for one observation.

    Attributes:
        gamma_space: at the discounts that were trained, and ``added`` interpolated ones in every gap between them.
        places: ``(H,)``, of the sensitivities on the axis of the activation, in units of 1/slope.
    """

    gamma_space: GammaSpace
    action_names: tuple[str, ...]
    places: np.ndarray
    added: int = 0

    @property
    def world(self) -> None:
        return None

    @property
    def learner(self) -> None:
        return None

    def study(self, settings: Resolved) -> Study:
        """Its convention is ours, so nothing is looked for; actions have the environment's names."""
        space = replace(self.gamma_space, places=self.places)
        found = study_of_gamma_space(space, settings, own_convention=False)
        return replace(found, action_names=self.action_names)


def state_in(settings: Resolved) -> str:
    """The state that settings of a world look from.

    Raises:
        InputError: the settings leave it open; those of a world never do.
    """
    if settings.state is None:
        raise InputError("state is not decided: resolve the settings with their world first.")
    return settings.state


@dataclass(frozen=True)
class View:
    """One state of one subject, looked at through resolved settings.

    Attributes:
        subject: the world; what was learned of it; or a gamma-space without a world,
            from a file or from a trained agent.
    """

    subject: Subject
    settings: Resolved
    action: int

    @property
    def world(self) -> World | None:
        return self.subject.world

    @property
    def learned(self) -> Learned | None:
        return None if self.learner is None else self.learner.learned

    @property
    def learner(self) -> Learner | None:
        return self.subject.learner


def view_of(values: Values, learned: Learned | None = None) -> View:
    """What a set of values shows: exact, or as it was learned.

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
        subject = opened = _from_file(file.data, None if state is None else str(state))
        given = {name: value for name, value in given.items() if name not in ENCODING_NAMES}
        settings = resolve_for_gamma_space(Settings(world=file.name, **given), opened.gamma_space.gammas)
    else:
        params = tuple(sorted((k.removeprefix(PARAM), v) for k, v in values.items() if k.startswith(PARAM)))
        wanted = Settings(world=world.source or file_name(world), params=params, **given)
        subject = Exact(world)
        if learned is not None:
            wanted = replace(wanted, paper_grid=None)  # it learned at its own discounts
            wanted = study_settings(learned.settings, wanted)
            subject = learner(world, learned, _shown_seed(values, learned))
        settings = resolve(wanted, world)
    names = subject.action_names
    action = names.index(values["action"]) if values.get("action") in names else 0
    return View(subject, settings, action)


def _shown_seed(values: Values, learned: Learned) -> int | None:
    seeds = len(learned.basis)
    shown = str(values.get("learner", "mean"))
    if seeds == 1:
        return 0
    return min(int(shown), seeds - 1) if shown.isdecimal() else None


def plain_name(world: World) -> str:
    """A world's name as part of a file's name."""
    return re.sub(r"[^A-Za-z0-9_-]+", "_", world.name)[:40].strip("_") or "world"


def file_name(world: World) -> str:
    """What the file of a world that somebody brought or edited is called."""
    return f"{plain_name(world)}.json"
