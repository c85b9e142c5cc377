"""What really comes, simulated in the background: of one state where there is chance, else of many states."""

from __future__ import annotations

from functools import lru_cache

from app.components.lens.payload import Simulated
from app.session.background import Told, Work
from app.session.shelf import Shelf
from laplace_core.acting.continuations import Continuations, Outcomes, continue_from, outcomes_of_states
from laplace_core.acting.rollout import Rollout
from laplace_core.acting.simulated_truth import empirical
from laplace_core.agents.agent import Agent
from laplace_core.environments import vector
from laplace_core.training.checkpoint import Loaded

MOST_KEPT = 8
"""Simulations, of less than a megabyte each."""
COUNT, EPISODES, EACH = 100, 20, 10
STEPS = 200

Simulation = Work[Continuations | Outcomes]
_kept: Shelf[Simulation] = Shelf(MOST_KEPT)


def _key(
    loaded: Loaded, rollout: Rollout, step: int, action: int, *, own: bool
) -> tuple[Agent | Rollout | object, ...]:
    if vector.chance(loaded.environment):
        return loaded.agent, rollout, step, action, own
    return loaded.agent, (rollout.rule, rollout.horizon, rollout.gamma) if own else None


def found(loaded: Loaded, rollout: Rollout, step: int, action: int, *, own: bool) -> Simulation | None:
    """The simulation for this state and first action, if one was begun; ``own``: under the rollout's own rule."""
    return _kept.get(_key(loaded, rollout, step, action, own=own))


def begin(loaded: Loaded, rollout: Rollout, step: int, action: int, *, own: bool) -> None:
    """Begin it, unless it was."""
    key = _key(loaded, rollout, step, action, own=own)

    def make(told: Told) -> Continuations | Outcomes:
        if vector.chance(loaded.environment):
            return continue_from(
                loaded.agent, rollout, step, action=action, count=COUNT, steps=STEPS, own=own, progress=told
            )
        like = rollout if own else None
        return outcomes_of_states(
            loaded.agent, loaded.environment, episodes=EPISODES, each=EACH, steps=STEPS, like=like, progress=told
        )

    _kept.take(key, lambda: Work(make))


@lru_cache(maxsize=MOST_KEPT)
def for_lens(one: Simulation, agent: Agent, action: int) -> Simulated:
    """What the lens draws of finished continuations; the same object for the same ones."""
    came = one.result()
    assert isinstance(came, Continuations)  # of many states the lens draws nothing
    return Simulated(action, empirical(agent, came))
