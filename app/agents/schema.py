"""The state of the page of trained agents: from a link to an observation of the agent."""

from __future__ import annotations

from app.catalogue import checkpoints
from laplace_core import InputError
from laplace_core.environments import environment_of
from laplace_core.exchange.links import Check, Entries, Old, Schema, Values
from laplace_core.parameters import Parameter
from laplace_core.payloads.link import ACTION, LOOK, OLD_SWITCHES, check_reached
from laplace_core.payloads.state import ADDED
from laplace_core.trained import rollouts
from laplace_core.trained.observations import OBSERVED, READING, settings_of

_LOOKING = {parameter.name: parameter for parameter in (ACTION, LOOK, ADDED)}
_IDLE = ("clip", "paper_grid")


def opening() -> Values:
    return {"checkpoint": checkpoints.shipped()[0]} if checkpoints.shipped() else {}


def _of_agent(values: Values) -> dict[str, Parameter]:
    """The parameters that a link may have for its agent and for the observations of that agent."""
    if "checkpoint" not in values:
        return {}
    loaded = checkpoints.checkpoint(str(values["checkpoint"]))
    scene = environment_of(loaded.environment)
    states = Parameter("state", None, help="State that the agent observes.", kind=str, choices=scene.states)
    own = {"state": states} if scene.states else {}
    return {**READING, **_LOOKING, **rollouts.parameters(loaded.agent), **own}


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
            raise InputError(f"action {str(values['action'])[:40]!r} must be one of {', '.join(actions)}.")


def _is_reached(name: str) -> Check:
    def test(values: Values) -> None:
        if "checkpoint" in values and name in values:
            loaded = checkpoints.checkpoint(str(values["checkpoint"]))
            check_reached(name, values, settings_of(loaded, values))

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
