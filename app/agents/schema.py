"""The state of the page of trained agents: from a link to an observation and what the agent sees of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from app.catalogue import checkpoints
from app.view.schema import ACTION, DRAWN, LOOK, OLD_SWITCHES, check_reached
from laplace_core import InputError, Settings
from laplace_core.acting.deadlines import suited_steps
from laplace_core.agents.capabilities import HasGammaSpace
from laplace_core.caching import cached
from laplace_core.code.interpolation import with_added
from laplace_core.environments import Environment, environment_of
from laplace_core.exchange.links import Check, Entries, Old, Schema, Values
from laplace_core.parameters import Parameter
from laplace_core.payloads.state import ADDED
from laplace_core.study.settings import ENCODING_NAMES, Resolved, resolve_for_gamma_space
from laplace_core.subjects import Observed, View
from laplace_core.trained import rollouts
from laplace_core.training.checkpoint import Loaded

OBSERVED = "o."  # prefix of the components of an observation
# A network's gamma-space is known to a hundredth or so: less regularisation shows its error and not its timeline.
DEFAULTS = {"alpha": 1.0}
_READING = {name: parameter for name, parameter in DRAWN.items() if name not in (*ENCODING_NAMES, "state")}
_LOOKING = {parameter.name: parameter for parameter in (ACTION, LOOK, ADDED)}
_IDLE = ("clip", "paper_grid")


def opening() -> Values:
    return {"checkpoint": checkpoints.shipped()[0]} if checkpoints.shipped() else {}


def _of_agent(values: Values) -> dict[str, Parameter]:
    """What a link may say of the agent that it names, and of what this agent observes."""
    if "checkpoint" not in values:
        return {}
    loaded = checkpoints.checkpoint(str(values["checkpoint"]))
    scene = environment_of(loaded.environment)
    states = Parameter("state", None, help="State that is observed.", kind=str, choices=scene.states)
    own = {"state": states} if scene.states else {}
    return {**_READING, **_LOOKING, **rollouts.parameters(loaded.agent), **own}


def _components(values: Values) -> dict[str, Parameter]:
    """The components of an observation, by their places."""
    if "checkpoint" not in values:
        return {}
    scene = environment_of(checkpoints.checkpoint(str(values["checkpoint"])).environment)
    return {
        str(i): Parameter(component.name, component.start, component.low, component.high, "", float)
        for i, component in enumerate(scene.components)
    }


def _action_is_known(values: Values) -> None:
    if "checkpoint" in values and "action" in values:
        actions = environment_of(checkpoints.checkpoint(str(values["checkpoint"])).environment).actions
        if values["action"] not in actions:
            raise InputError(f"action {str(values['action'])[:40]!r} is none of {', '.join(actions)}.")


def _is_reached(name: str) -> Check:
    def test(values: Values) -> None:
        if "checkpoint" in values and name in values:
            loaded = checkpoints.checkpoint(str(values["checkpoint"]))
            check_reached(name, values, _settings_of(loaded, values))

    return Check(test, drops=(name,))


def _deadline_is_reached(values: Values) -> None:
    if "checkpoint" in values and values.get(rollouts.HORIZON) is not None:
        limit = rollouts.limit_of(checkpoints.checkpoint(str(values["checkpoint"])))
        if values[rollouts.HORIZON] > limit:
            raise InputError(f"{rollouts.HORIZON} {values[rollouts.HORIZON]:,} is longer than any episode, {limit:,}.")


LINK = Schema(
    opening=opening,
    # The lens of version 0.2 wrote these two here as well, where they never did anything.
    old=(*(each for each in OLD_SWITCHES if each.name not in _IDLE), *(Old(name, None) for name in _IDLE)),
    steps=(
        *checkpoints.NAMED,
        Entries(_of_agent),
        Entries(_components, prefix=OBSERVED),
        Check(_action_is_known, drops=("action",)),
        _is_reached("horizon"),
        _is_reached("used"),
        Check(_deadline_is_reached, drops=(rollouts.HORIZON,)),
    ),
)


def action_of(scene: Environment, values: Mapping[str, Any]) -> int:
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
        raise InputError(f"{checkpoints.titled(loaded)} has no gamma-space to look at.")
    return Observed(
        with_added(agent.gamma_space(np.array(observation)), added), action_names, agent.sensitivities.places, added
    )


def view_of(
    loaded: Loaded, scene: Environment, values: Mapping[str, Any], observation: tuple[float, ...] | None = None
) -> View:
    """What the page shows.

    Args:
        observation: in place of the one that the values describe.

    Raises:
        InputError: values that do not fit each other.
    """
    seen, added = observation or observation_of(scene, values), int(values.get("added", 0))
    observed = observe(loaded, seen, scene.actions, added)
    return View(observed, _settings_of(loaded, values), action_of(scene, values))


def _settings_of(loaded: Loaded, values: Mapping[str, Any]) -> Resolved:
    given = {name: value for name, value in values.items() if name in _READING}
    steps = suited_steps(loaded.environment)  # as on the page of worlds; elsewhere it has the usual length
    usual = DEFAULTS | ({} if steps is None else {"steps": steps})
    return resolve_for_gamma_space(Settings(world=loaded.environment, **(usual | given)), loaded.settings.discounts())
