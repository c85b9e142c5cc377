"""Rollouts of trained agents: how they are acted, the work that this is, and what a link says of one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from laplace_core.acting import estimates
from laplace_core.acting.flags import Flags, flag_steps
from laplace_core.acting.return_laws import outputs_along
from laplace_core.acting.rollout import MOST_SEED, MOST_STEPS, RANDOM, Rollout, length_of, roll_out, titles_of
from laplace_core.acting.rules import RULES, for_deadline
from laplace_core.agents.agent import Agent
from laplace_core.agents.capabilities import HasDiscounts
from laplace_core.environments import GYMNASIUM_ENVIRONMENTS
from laplace_core.exchange.links import by_name
from laplace_core.inverse.solvers import selecting
from laplace_core.parameters import Parameter
from laplace_core.payloads.player import payload
from laplace_core.subjects import View
from laplace_core.supervise.jobs import Progress, Task
from laplace_core.training.checkpoint import Loaded

_FLAGS = 1e-3  # seconds that the search for artefacts takes at a step
SHOWN, SEED, RULE, HORIZON, GAMMA, AT = "r.shown", "r.seed", "r.rule", "r.horizon", "r.gamma", "r.at"
ACTION, TAKEN = "r.action", "taken"  # the action taken is an option of its own, which follows the cursor
AFTER = "r.after"
PARAMETERS = by_name(
    Parameter(SHOWN, "no", help="Whether a rollout is shown.", choices=("no", "yes")),
    Parameter(SEED, 0, 0, MOST_SEED, "Seed of the start, and of random actions."),
    Parameter(RULE, "greedy", help="Control rule.", choices=(*RULES, RANDOM)),
    Parameter(HORIZON, None, 1, MOST_STEPS, "Deadline T of the episode, in steps.", int),
    Parameter(GAMMA, None, 1e-6, 0.999999, "Discount to be greedy at.", float),
    Parameter(AT, 0, 0, MOST_STEPS, "Step under the cursor."),
    Parameter(AFTER, "values", help="Policy of the simulation from that step.", choices=("values", "rule")),
)


@dataclass(frozen=True)
class Control:
    """How an episode is acted; see :func:`laplace_core.acting.rollout.roll_out`."""

    seed: int = 0
    rule: str = "greedy"
    horizon: int | None = None
    gamma: float | None = None


@dataclass(frozen=True, eq=False)
class RolledOut:
    """One rollout.

    Attributes:
        packed: the same for the player.
        along: outputs of a peer along it, from :func:`laplace_core.acting.return_laws.outputs_along`.
    """

    rollout: Rollout
    packed: bytes
    along: dict[str, np.ndarray]


def parameters(agent: Agent[Any]) -> dict[str, Parameter]:
    """The entries of a link for a rollout of this agent."""
    rules = tuple(titles_of(agent))
    own = Parameter(RULE, rules[0], help="Control rule.", kind=str, choices=rules)
    kept = {name: one for name, one in PARAMETERS.items() if name != GAMMA or isinstance(agent, HasDiscounts)}
    shown = Parameter(ACTION, TAKEN, help="Action that is shown for an agent without a lens.", kind=str)
    return kept | {RULE: own, ACTION: shown}


def shown(values: Mapping[str, Any]) -> bool:
    return values.get(SHOWN) == "yes"


def control_of(values: Mapping[str, Any], limit: int, usual: str = "greedy") -> Control:
    """The control that a page's values describe: ``limit`` is T where an adapted rule has none, ``usual`` the rule
    where there is none."""
    seed, rule = int(values.get(SEED, 0)), str(values.get(RULE, usual))
    if for_deadline(rule):
        return Control(seed, rule, min(limit, int(values.get(HORIZON) or limit)))
    return Control(seed, rule, None, values.get(GAMMA) if rule == "greedy" else None)


def limit_of(loaded: Loaded) -> int:
    """Steps after which an episode ends at the latest."""
    return length_of(loaded.agent, loaded.environment, None)


def step_of(values: Mapping[str, Any], rollout: Rollout) -> int:
    """The step under the cursor, within the episode."""
    return min(int(values.get(AT, 0)), len(rollout) - 1)


def observation_at(rollout: Rollout, step: int) -> tuple[float, ...]:
    return tuple(float(value) for value in rollout.observations[step])


def followed(rollout: Rollout, step: int) -> dict[str, Any]:
    """The observations that the lens draws on the timeline: rewards from a step on, the action there, and the end.

    ``over`` is how many steps were left if the episode then was over, None if it was truncated.
    """
    rewards = np.asarray(rollout.rewards[step:], dtype=float)
    over = len(rollout) - step if rollout.terminated else None
    return {"rewards": rewards.tolist(), "action": int(rollout.actions[step]), "over": over}


def marks_of(flags: Flags, alpha: float) -> dict[str, Any]:
    """The marks of the player: names, and at every step a bit for each name that applies."""
    marks = flags.marks @ (1 << np.arange(len(flags.names)))
    return {"alpha": alpha, "names": list(flags.names), "marks": marks.astype(int).tolist()}


def rolling(loaded: Loaded, control: Control) -> Task[RolledOut]:
    """The rollout of an agent under a control."""
    agent, environment = loaded.agent, loaded.environment
    pictures = environment in GYMNASIUM_ENVIRONMENTS

    def make(progress: Progress) -> RolledOut:
        rollout = roll_out(agent, environment, **asdict(control), pictures=pictures, progress=progress)
        along = {} if rollout.spaces is not None else outputs_along(agent, rollout)
        return RolledOut(rollout, payload(rollout, along), along)

    def estimate() -> float:
        return estimates.of_rollout(agent, environment, control.rule, control.horizon, pictures=pictures)

    lower = "lower T or choose a quicker rule"
    return Task((agent, control), make, estimate, slot="rollout", lower=lower)


def artefacts(rolled: RolledOut, view: View) -> Task[Flags]:
    """The search for artefacts at every step under the settings of a view."""
    # Without a truth no artefact depends on how values are read; only a linear picture is a sum of artefacts.
    settings = replace(
        view.settings, softness=0.0, deadline="time_to_go", solver=selecting(view.settings.solver)
    )  # fmt: skip
    how, rollout = (settings, view.subject.added), rolled.rollout

    def make(progress: Progress) -> Flags:
        return flag_steps(rollout, *how, progress)

    return Task((rollout, how), make, lambda: _FLAGS * len(rollout), slot="artefacts")
