"""Useful deadlines for an agent in its environment, and the discount that corresponds to a deadline."""

from __future__ import annotations

from functools import cache

from laplace_core.acting import rules
from laplace_core.acting.rollout import length_of
from laplace_core.agents.agent import Agent
from laplace_core.agents.capabilities import HasDiscounts
from laplace_core.environments import GYMNASIUM_ENVIRONMENTS
from laplace_core.study.settings import Settings, resolve
from laplace_core.worlds import load_world

USUAL = 50
"""Steps of a race where nothing says how long a timeline suits."""


def rules_of_race(agent: Agent) -> tuple[str, ...]:
    """Rules that an agent can race by; one that takes the time to go has no reason for another."""
    names = rules.rules_of(agent)
    return names[:1] if names[0] == "own" else names


@cache
def suited_steps(environment: str) -> int | None:
    """The recommended length of the timeline of a tabular world; None for any other environment."""
    if environment in GYMNASIUM_ENVIRONMENTS:
        return None
    return resolve(Settings(world=environment), load_world(environment)).steps


def longest_horizon(agent: Agent, environment: str) -> int:
    """The latest end of an episode; in a tabular world, a multiple of the recommended length."""
    limit, suited = length_of(agent, environment, None), suited_steps(environment)
    return limit if suited is None else min(limit, 4 * suited)


def usual_horizon(agent: Agent, environment: str) -> int:
    """The default deadline of a race."""
    return min(suited_steps(environment) or USUAL, longest_horizon(agent, environment))


def trained_discount(agent: Agent, gamma: float | None) -> float | None:
    """The nearest one that the agent has learned; None for the acting one, or where there is no choice."""
    if gamma is None or not isinstance(agent, HasDiscounts):
        return None
    head = int(abs(agent.gammas - float(gamma)).argmin())
    return None if head == agent.acting_head else float(agent.gammas[head])
