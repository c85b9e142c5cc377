"""A trained agent and one observation: the observation, its gamma-space, and a view of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from laplace_core.acting.deadlines import suited_steps
from laplace_core.agents.capabilities import HasGammaSpace
from laplace_core.caching import cached
from laplace_core.code.interpolation import with_added
from laplace_core.environments import Environment
from laplace_core.errors import InputError
from laplace_core.payloads.link import DRAWN
from laplace_core.study.settings import ENCODING_NAMES, Resolved, Settings, resolve_for_gamma_space
from laplace_core.subjects import Observed, View
from laplace_core.training.checkpoint import Loaded
from laplace_core.worlds.titles import plain

OBSERVED = "o."  # prefix of the components of an observation
# A network's gamma-space is known to a hundredth or so: less regularisation shows its error and not its timeline.
DEFAULTS = {"alpha": 1.0}
READING = {name: parameter for name, parameter in DRAWN.items() if name not in (*ENCODING_NAMES, "state")}


def titled(loaded: Loaded) -> str:
    """An agent as a person reads it."""
    return f"{plain(loaded.environment)} · {loaded.settings.TITLE}"


def action_of(scene: Environment, values: Mapping[str, Any]) -> int:
    """The action that the values name, else the first."""
    name = values.get("action")
    return scene.actions.index(name) if name in scene.actions else 0


def observation_of(scene: Environment, values: Mapping[str, Any]) -> tuple[float, ...]:
    """The observation that the values describe; a tabular state is a one-hot vector."""
    if scene.states:
        at = scene.states.index(str(values.get("state", scene.states[0])))
        return tuple(np.eye(len(scene.states))[at])
    return tuple(float(values.get(f"{OBSERVED}{i}", part.start)) for i, part in enumerate(scene.components))


@cached(64)
def observe(
    loaded: Loaded, observation: tuple[float, ...], action_names: tuple[str, ...], added: int = 0
) -> Observed:  # fmt: skip
    """The same object for the same observation, so that what is cached for it is found again.

    ``added`` interpolated discounts go into every gap between those that were trained.

    Raises:
        InputError: an agent without a gamma-space.
    """
    agent = loaded.agent
    if not isinstance(agent, HasGammaSpace):
        raise InputError(f"{titled(loaded)} has no gamma-space: choose a Laplace DQN agent.")
    return Observed(
        with_added(agent.gamma_space(np.array(observation)), added), action_names, agent.sensitivities.places, added
    )


def view_of(
    loaded: Loaded, scene: Environment, values: Mapping[str, Any], observation: tuple[float, ...] | None = None
) -> View:
    """The view of the page.

    Args:
        observation: in place of the one that the values describe.

    Raises:
        InputError: values that do not fit each other.
    """
    seen, added = observation or observation_of(scene, values), int(values.get("added", 0))
    observed = observe(loaded, seen, scene.actions, added)
    return View(observed, settings_of(loaded, values), action_of(scene, values))


def settings_of(loaded: Loaded, values: Mapping[str, Any]) -> Resolved:
    """The settings of a view: those that the values hold, and for the rest what suits agents."""
    given = {name: value for name, value in values.items() if name in READING}
    steps = suited_steps(loaded.environment)  # as on the page of worlds; elsewhere it has the usual length
    usual = DEFAULTS | ({} if steps is None else {"steps": steps})
    return resolve_for_gamma_space(Settings(world=loaded.environment, **(usual | given)), loaded.settings.discounts())
