"""What steps of each agent cost on this machine: measured once, for estimates of work before it is begun."""

from __future__ import annotations

from weakref import WeakKeyDictionary

from laplace_core import InputError
from laplace_core.acting.cost import StepCost, step_cost
from laplace_core.agents.agent import Agent

_known: WeakKeyDictionary[Agent, dict[tuple[str, str, bool], StepCost]] = WeakKeyDictionary()
_NOTHING = StepCost(0.0, 0.0, 0.0)


def cost_of(
    agent: Agent, environment: str, rule: str = "greedy", horizon: int | None = None, *, pictures: bool = False
) -> StepCost:  # fmt: skip
    """The cost of a step; nothing for a rule that does not suit the agent, which the work itself refuses."""
    known, key = _known.setdefault(agent, {}), (environment, rule, pictures)
    if key not in known:
        try:
            known[key] = step_cost(agent, environment, rule, horizon=horizon, pictures=pictures)
        except InputError:
            return _NOTHING
    return known[key]
