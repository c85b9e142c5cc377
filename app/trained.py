"""The state of the page of trained agents: from a link to an observation and what the agent sees of it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from app import checkpoints, rolled
from app.lens.state import ADDED
from app.link import read_values, translated
from app.observations import Scene, scene_of
from app.query import VIEW
from app.sources import View
from laplace_core import InputError, Settings, load_world
from laplace_core.environments import GYMNASIUM_ENVIRONMENTS
from laplace_core.parameters import Parameter
from laplace_core.settings import BY_NAME, ENCODING_NAMES, resolve, resolve_for_gamma_space
from laplace_core.training.checkpoint import Loaded

OBSERVED = "o."  # prefix of the components of an observation
# A network's gamma-space is known to a hundredth or so: less regularisation shows its error and not its timeline.
DEFAULTS = {"alpha": 1.0}
_READING = {name: parameter for name, parameter in BY_NAME.items() if name not in ENCODING_NAMES}
_LOOKING = {parameter.name: parameter for parameter in VIEW if parameter.name in ("action", "look")}
_LOOKING["added"] = ADDED


def opening() -> dict[str, Any]:
    return {"checkpoint": checkpoints.shipped()[0]} if checkpoints.shipped() else {}


def parse_query(query: Mapping[str, str]) -> tuple[dict[str, Any], list[str]]:
    """State and notes from URL values."""
    notes: list[str] = []
    found = dict(opening())
    # The lens of version 0.2 wrote these here as well, where they never did anything.
    query = {name: text for name, text in translated(query).items() if name not in ("clip", "paper_grid")}
    try:
        if "checkpoint" in query:
            checkpoints.checkpoint(query["checkpoint"])
            found["checkpoint"] = query["checkpoint"]
    except InputError as error:
        return found, [f"Left out of the link: {error}"]
    if "checkpoint" not in found:
        return {}, []
    loaded = checkpoints.checkpoint(str(found["checkpoint"]))
    scene = scene_of(loaded.environment)
    known = {**_READING, **_LOOKING, **rolled.parameters(loaded.agent)}
    known |= {
        f"{OBSERVED}{i}": Parameter(component.name, component.start, component.low, component.high, "", float)
        for i, component in enumerate(scene.components)
    }
    known.pop("state")
    if scene.states:
        known["state"] = Parameter("state", None, help="State that is observed.", kind=str, choices=scene.states)
    values, more = read_values(query, known, ("checkpoint",))
    return found | values, notes + more


def action_of(scene: Scene, values: Mapping[str, Any]) -> int:
    name = values.get("action")
    return scene.actions.index(name) if name in scene.actions else 0


def observation_of(scene: Scene, values: Mapping[str, Any]) -> tuple[float, ...]:
    """The observation that the values describe; a tabular state is a one-hot vector."""
    if scene.states:
        at = scene.states.index(str(values.get("state", scene.states[0])))
        return tuple(np.eye(len(scene.states))[at])
    return tuple(float(values.get(f"{OBSERVED}{i}", part.start)) for i, part in enumerate(scene.components))


def view_of(
    loaded: Loaded, scene: Scene, values: Mapping[str, Any], observation: tuple[float, ...] | None = None
) -> View:
    """What the page shows.

    Args:
        observation: in place of the one that the values describe.

    Raises:
        InputError: values that do not fit each other.
    """
    seen, added = observation or observation_of(scene, values), int(values.get("added", 0))
    observed = checkpoints.observe(loaded, seen, scene.actions, added)
    given = {name: value for name, value in values.items() if name in _READING and name != "state"}
    usual = DEFAULTS | _steps(loaded.environment)
    settings = resolve_for_gamma_space(
        Settings(world=loaded.environment, **(usual | given)), loaded.settings.discounts()
    )
    return View(observed, settings, action_of(scene, values))


@cache
def _steps(environment: str) -> dict[str, int]:
    """How long the timeline of a tabular world is, as on its own page; others have the usual length."""
    if environment in GYMNASIUM_ENVIRONMENTS:
        return {}
    world = load_world(environment)
    return {"steps": resolve(Settings(world=environment), world).steps}
