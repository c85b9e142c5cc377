"""The subjects of the workbench, and a view: one subject under resolved settings, at one action."""

from __future__ import annotations

import re
from collections.abc import Hashable
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from laplace_core.caching import cached
from laplace_core.code.gamma_space import GammaSpace
from laplace_core.errors import InputError
from laplace_core.study.npz import read_gamma_space, states_of
from laplace_core.study.pipeline import Study, study, study_of_gamma_space
from laplace_core.study.settings import Resolved
from laplace_core.tabular import Learned
from laplace_core.worlds import World, dump_world


class Subject(Hashable, Protocol):
    """A subject: a world, the learned values of a world, or a gamma-space without a world.

    Equal subjects show the same, so that what is cached for one is found again.
    """

    @property
    def world(self) -> World | None:
        """The world, which gives the truth; None if there is only a gamma-space."""

    @property
    def learner(self) -> Learner | None:
        """The learner, if the subject is learned."""

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


@dataclass(frozen=True)
class Exact:
    """A world, solved exactly; equal where the world is the same object."""

    world: World
    learner = gamma_space = places = None
    added = 0

    @property
    def action_names(self) -> tuple[str, ...]:
        return self.world.actions

    def study(self, settings: Resolved) -> Study:
        return study(self.world, settings)


@dataclass(frozen=True, eq=False)
class FromFile:
    """A gamma-space from a file, which may follow another convention and is looked at for that."""

    gamma_space: GammaSpace
    world = learner = places = None
    added = 0

    @property
    def action_names(self) -> tuple[str, ...]:
        return tuple(f"action {a}" for a in range(len(self.gamma_space.values)))

    def study(self, settings: Resolved) -> Study:
        return study_of_gamma_space(self.gamma_space, settings)


@dataclass(eq=False)
class GammaSpaceFile:
    """A gamma-space in ``.npz``, checked, how many states it holds, and the state of it that was looked at last."""

    name: str
    data: bytes
    states: int
    shown: tuple[str | None, FromFile]

    @classmethod
    def opened(cls, name: str, data: bytes) -> GammaSpaceFile:
        """The file of this name and content.

        Raises:
            InputError: not such a file.
        """
        first = FromFile(read_gamma_space(data, name=name))
        return cls(name, data, states_of(data, name=name), (None, first))

    def at(self, state: str | None) -> FromFile:
        """The gamma-space of a state; the same object while no other state is looked at.

        Raises:
            InputError: no such state.
        """
        if self.shown[0] != state:
            self.shown = state, FromFile(read_gamma_space(self.data, state))
        return self.shown[1]


@dataclass(frozen=True, eq=False)
class Learner:
    """The learned values of a world, of one seed or of the mean of all seeds (``index`` None)."""

    world: World
    learned: Learned
    index: int | None
    gamma_space = places = None
    added = 0

    @property
    def learner(self) -> Learner:
        return self

    @property
    def action_names(self) -> tuple[str, ...]:
        return self.world.actions

    def study(self, settings: Resolved) -> Study:
        return study(self.world, settings, learned=self.basis(self.world.state_index(state_in(settings))))

    def basis(self, state: int) -> np.ndarray:
        """The reward-indicator basis of a state, ``(A, G, V)``."""
        return self._seen(self.learned.basis[:, state])

    @property
    def tables(self) -> np.ndarray:
        """The reward-indicator basis of every state, ``(S, A, G, V)``."""
        return self._seen(self.learned.basis)

    def _seen(self, tables: np.ndarray) -> np.ndarray:
        return tables.astype(float).mean(axis=0) if self.index is None else tables[self.index].astype(float)

    @property
    def policy(self) -> np.ndarray:
        return self.learned.policies[self.index or 0]


@dataclass(frozen=True, eq=False)
class Observed:
    """The gamma-space of a trained agent for one observation.

    Attributes:
        gamma_space: at the discounts that were trained, and ``added`` interpolated ones in every gap between them.
        places: ``(H,)``, of the sensitivities on the axis of the activation, in units of 1/slope.
    """

    gamma_space: GammaSpace
    action_names: tuple[str, ...]
    places: np.ndarray
    added: int = 0
    world = learner = None

    def study(self, settings: Resolved) -> Study:
        """Its convention is ours, so nothing is looked for; actions have the environment's names."""
        space = replace(self.gamma_space, places=self.places)
        return replace(study_of_gamma_space(space, settings, own_convention=False), action_names=self.action_names)


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
    """One state of one subject under resolved settings.

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

    @property
    def settings_on_disk(self) -> Resolved:
        """The settings by which a command repeats it: what was learned is read from its file."""
        if self.learner is None:
            return self.settings
        shown = self.learner.index
        params = () if shown is None else (("seed_index", shown),)
        return replace(self.settings, world=learned_file(self.learner.world), params=params)

    def to_python(self, *, from_file: bool = False) -> str:
        """A script that repeats it.

        Args:
            from_file: whether its world is read from a file, by the name that the settings give it.
        """
        if self.learner is None:
            return self.settings.to_python(f'read_world("{self.settings.world}")' if from_file else None)
        settings = self.settings.to_python().partition("settings = Settings(")[2]
        imports, line = "Settings", f"result = study_of(learned, settings, {self.learner.index})"
        if self.learner.index is None:
            imports = "Settings, study"
            line = (
                "tables = learned.basis[:, learned.world.state_index(settings.state)]  # a table a seed\n"
                "result = study(learned.world, settings, learned=tables.astype(float).mean(axis=0))"
            )
        return "\n".join(
            [
                f"from laplace_core import {imports}",
                f"from laplace_core.tabular import read_learned{'' if self.learner.index is None else ', study_of'}",
                "",
                f'learned = read_learned("{self.settings_on_disk.world}")',
                "settings = Settings(" + settings.replace("result = study(world, settings)", line),
            ]
        )


@cached(16)
def about(learned: Learned, world: World) -> Learned:
    """The same tables about the world object that the page holds, so that what is cached per world is found again."""
    return replace(learned, world=world)


@cached(16)
def fits(learned: Learned, world: World) -> bool:
    """Whether an agent from a file learned this very world."""
    return dump_world(learned.world) == dump_world(world)


@cached(32)
def learner(world: World, learned: Learned, index: int | None) -> Learner:
    """The same object for the same words, so that what is cached per learner is found again."""
    return Learner(world, learned, index)


def shown_seed(learned: Learned, word: str) -> int | None:
    """The index of the learner that a link names; None for the mean of several."""
    seeds = len(learned.basis)
    if seeds == 1:
        return 0
    return min(int(word), seeds - 1) if word.isdecimal() else None


def learned_file(world: World) -> str:
    """The file name of a learner of a world."""
    return f"{plain_name(world)}_td.safetensors"


def plain_name(world: World) -> str:
    """A world's name as part of a file's name."""
    return re.sub(r"[^A-Za-z0-9_-]+", "_", world.name)[:40].strip("_") or "world"
