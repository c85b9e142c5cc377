"""What really comes, simulated in the background: of one state where there is chance, else of many states."""

from __future__ import annotations

import threading
from collections import OrderedDict

from app.background import Told, Work
from laplace_core.agents.agent import Agent
from laplace_core.training import environments
from laplace_core.training.checkpoint import Loaded
from laplace_core.training.continuations import Continuations, Outcomes, continue_from, outcomes_of_states
from laplace_core.training.rollout import Rollout

MOST_KEPT = 8
"""Simulations, of less than a megabyte each."""
COUNT, EPISODES, EACH = 100, 20, 10
STEPS = 200

Simulation = Work[Continuations | Outcomes]
_kept: OrderedDict[tuple, Simulation] = OrderedDict()
_lock = threading.Lock()


def _key(loaded: Loaded, rollout: Rollout, step: int, action: int) -> tuple[Agent | Rollout | int, ...]:
    if environments.chance(loaded.environment):
        return loaded.agent, rollout, step, action
    return (loaded.agent,)


def found(loaded: Loaded, rollout: Rollout, step: int, action: int) -> Simulation | None:
    """The simulation for this state and first action, if one was begun."""
    one = _kept.get(_key(loaded, rollout, step, action))
    return None if one is None or one.gone else one


def begin(loaded: Loaded, rollout: Rollout, step: int, action: int) -> None:
    """Begin it, unless it was."""
    key = _key(loaded, rollout, step, action)

    def make(told: Told) -> Continuations | Outcomes:
        if environments.chance(loaded.environment):
            return continue_from(loaded.agent, rollout, step, action, COUNT, STEPS, told=told)
        return outcomes_of_states(loaded.agent, loaded.environment, EPISODES, EACH, STEPS, told=told)

    with _lock:
        if key not in _kept or _kept[key].gone:
            _kept[key] = Work(make)
        _kept.move_to_end(key)
        while len(_kept) > MOST_KEPT:
            _kept.popitem(last=False)[1].cancel()
