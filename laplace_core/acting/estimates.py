"""Estimated seconds of acting on this machine: the time of a step, times the number of steps.

Every episode counts at its full length: these are upper bounds.
"""

from __future__ import annotations

from collections.abc import Sequence

from laplace_core.acting import return_laws
from laplace_core.acting.cost import cost_of
from laplace_core.acting.evaluation import AT_ONCE
from laplace_core.acting.race import Entrant
from laplace_core.acting.return_laws import steps_until_cut
from laplace_core.acting.rollout import Rollout, acting_gamma, length_of
from laplace_core.agents.agent import Agent
from laplace_core.environments import vector


def of_rollout(agent: Agent, environment: str, rule: str, horizon: int | None, *, pictures: bool) -> float:
    """One episode under a rule."""
    steps = length_of(agent, environment, horizon)
    return steps * cost_of(agent, environment, rule, horizon, pictures=pictures).of()


def of_continuations(agent: Agent, rollout: Rollout, step: int, count: int, *, steps: int, own: bool) -> float:
    """Continuations of a state; each one first repeats the episode up to that state."""
    cost = cost_of(agent, rollout.environment, _rule_after(rollout, own=own), rollout.horizon)
    return step * count * cost.step + steps * cost.of(count)


def of_outcomes(agent: Agent, rollout: Rollout, episodes: int, *, steps: int, own: bool) -> float:
    """The rewards after many states of several episodes: each episode is acted beyond its last state."""
    cost = cost_of(agent, rollout.environment, _rule_after(rollout, own=own), rollout.horizon)
    return episodes * 2 * steps * cost.of()


def _rule_after(rollout: Rollout, *, own: bool) -> str:
    return rollout.rule.replace("decoded", "readout") if own else "greedy"


def of_returns(agents: Sequence[Agent], rollout: Rollout, step: int) -> float:
    """Returns of several agents from one state of an episode, each under its own greedy policy."""
    count = return_laws.COUNT if vector.chance(rollout.environment) else 1
    costs = [(agent, cost_of(agent, rollout.environment)) for agent in agents]
    past = step * count * sum(cost.step for _, cost in costs)
    return past + sum(steps_until_cut(acting_gamma(agent)) * cost.of(count) for agent, cost in costs)


def of_races(
    environment: str, entrants: Sequence[Entrant], horizon: int, count: int = 1, *, pictures: bool = False
) -> float:  # fmt: skip
    """Races from many starts: groups of episodes run side by side, first of one side and then of the other."""
    groups = [min(AT_ONCE, count - first) for first in range(0, count, AT_ONCE)]
    costs = [cost_of(one.agent, environment, one.rule, horizon, pictures=pictures) for one in entrants]
    return sum(horizon * cost.of(together) for cost in costs for together in groups)
