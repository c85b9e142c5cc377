"""The subjects of the page Inverse: a world, a trained agent's start state, or a gamma-space from a file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from app import session
from app.components.inverse import AXES
from app.inverse import measured
from laplace_core import PRESETS, InputError, Settings, World, load_world
from laplace_core.caching import cached
from laplace_core.exchange.links import Values
from laplace_core.parameters import Parameter
from laplace_core.payloads.link import PARAM
from laplace_core.study.npz import read_gamma_space
from laplace_core.study.settings import BY_NAME, ENCODING_NAMES, Resolved, resolve, resolve_for_gamma_space
from laplace_core.subjects import Exact, FromFile, Observed, Subject, View
from laplace_core.worlds import TOY_TEXT

WORLDS = (*PRESETS, *(f"gym:{name}" for name in TOY_TEXT))
KINDS = {"world": "World", "agent": "Trained agent", "data": "File"}
"""What can be looked at, by the entry of a link that names it."""
OPENING: Mapping[str, Any] = {"world": "two_branch", "action": "long", "noise": 0.001}
"""The paper's Fig. 4 with noise: what a visitor without a link sees."""
NETWORK_NOISE = 0.01
"""What a trained network's values are taken to be off by, where nothing is said."""
STUDIED = (
    "state", "noise", "noise_seed", "noise_level", "solver", "selector", "weighting", "alpha", "gammas", "spacing",
    "gamma_min", "gamma_max", "thetas", "steps", "horizon", "policy",
)  # fmt: skip
"""Settings of the study that a link of this page may hold."""
AXIS = Parameter("axis", "time", help="Horizontal axis of the pictures over discounts.", choices=AXES)
DATA_IS_GONE = "This link needs your gamma-space file, which a link cannot hold: open the file again."


@dataclass(frozen=True, eq=False)
class OpenedSpace:
    """A gamma-space that this session has opened, of the first state that its file holds."""

    name: str
    subject: FromFile


def open_file(name: str, data: bytes) -> str:
    """Keep a file's gamma-space for this session; returns its digest.

    Raises:
        InputError: not such a file.
    """
    return session.keep_opened(OpenedSpace(name, FromFile(read_gamma_space(data, name=name))), data)


def kind_of(values: Values) -> str:
    """The kind of subject of the values, one of :data:`KINDS`."""
    return next((kind for kind in ("agent", "data") if kind in values), "world")


def world_of(values: Values) -> World | None:
    """The world of a view; None of an agent and of a file.

    Raises:
        InputError: the values name no world that exists.
    """
    if kind_of(values) != "world":
        return None
    params = {key.removeprefix(PARAM): value for key, value in values.items() if key.startswith(PARAM)}
    return load_world(str(values.get("world", OPENING["world"])), params)


def view_of(values: Values) -> View:
    """The view of a set of values.

    The discounts always count by the deviation of their error unless a link says otherwise: alpha set by hand and
    alpha by a rule are then of one problem, so that they can be compared.

    Raises:
        InputError: values that do not fit each other.
    """
    given: dict[str, Any] = {"selector": "auto", "weighting": "deviation"}
    given |= {name: value for name, value in values.items() if name in STUDIED}
    if values.get("alpha") is not None and "selector" not in values:
        given["selector"] = "typed"
    noise = float(given.get("noise") or 0.0)
    kind = kind_of(values)
    if given.get("noise_level") is None:
        given["noise_level"] = noise or (NETWORK_NOISE if kind == "agent" else None)
    subject: Subject
    settings: Resolved
    if kind == "world":
        world = world_of(values)
        assert world is not None  # it is of that kind
        params = tuple(sorted((k.removeprefix(PARAM), v) for k, v in values.items() if k.startswith(PARAM)))
        subject = Exact(world)
        settings = resolve(Settings(world=world.source or world.name, params=params, **given), world)
        if values.get("measured"):
            subject, settings = measured.seen(values, world, settings)
    else:
        name, subject = _agent(str(values["agent"])) if kind == "agent" else _file(str(values["data"]))
        space = subject.gamma_space
        assert space is not None  # neither has a world
        given = {each: value for each, value in given.items() if each not in (*ENCODING_NAMES, "state")}
        settings = resolve_for_gamma_space(Settings(world=name, **given), space.gammas)
    names = subject.action_names
    action = names.index(values["action"]) if values.get("action") in names else 0
    return View(subject, settings, action)


def _file(digest: str) -> tuple[str, FromFile]:
    found = session.opened(OpenedSpace).get(digest)
    if found is None:
        raise InputError(DATA_IS_GONE)
    return found.name, found.subject


def agents() -> tuple[str, ...]:
    """Names of the shipped agents that have a gamma-space."""
    from app.catalogue import checkpoints  # it brings the network library along, which no world needs

    return tuple(name for name in checkpoints.shipped() if name.startswith("laplace_"))


@cached(16)
def _agent(name: str) -> tuple[str, Observed]:
    """The environment of a shipped agent, and its observation at the start of an episode."""
    from app.catalogue import checkpoints  # as above
    from laplace_core.agents.capabilities import HasGammaSpace
    from laplace_core.environments import environment_of

    if name not in agents():
        raise InputError(f"There is no shipped agent {name[:40]!r} that has a gamma-space.")
    loaded = checkpoints.checkpoint(name)
    scene, agent = environment_of(loaded.environment), loaded.agent
    if not isinstance(agent, HasGammaSpace):
        raise InputError(f"{name} has no gamma-space: choose a Laplace DQN agent.")
    start = np.eye(len(scene.states))[0] if scene.states else np.array([part.start for part in scene.components])
    return loaded.environment, Observed(agent.gamma_space(start), scene.actions, agent.sensitivities.places)


def parameters() -> dict[str, Parameter]:
    """The parameters of :data:`STUDIED`, by name."""
    return {name: BY_NAME[name] for name in STUDIED}
