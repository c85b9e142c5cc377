"""Returns of several agents from one state, simulated in the background: each goes on by its own greedy policy."""

from __future__ import annotations

from collections.abc import Sequence

from app.catalogue import checkpoints
from app.session.background import Told, Work
from app.session.shelf import Shelf
from laplace_core.acting.return_laws import SimulatedReturns, has_return_law, says_more_than_a_mean, simulate_returns
from laplace_core.acting.rollout import Rollout
from laplace_core.agents.agent import Agent
from laplace_core.training.checkpoint import Loaded

MOST_KEPT = 16
"""Comparisons, of a few kilobytes each."""

Returned = Work[tuple[SimulatedReturns, ...]]
_kept: Shelf[Returned] = Shelf(MOST_KEPT)


def beside(loaded: Loaded) -> list[Loaded]:
    """The opened agent, and then those that ship for its environment and say more than a mean."""
    others = [other for other in checkpoints.same_environment(loaded) if says_more_than_a_mean(other.agent)]
    own = [loaded] if has_return_law(loaded.agent) else []
    return own + [other for other in others if not _same(other, loaded)]


def _same(one: Loaded, other: Loaded) -> bool:
    """Whether a run or a file is what ships."""
    return one is other or (one.settings == other.settings and one.step == other.step)


def _key(agents: Sequence[Loaded], rollout: Rollout, step: int, action: int) -> tuple[Agent | Rollout | int, ...]:
    return (*(each.agent for each in agents), rollout, step, action)


def found(agents: Sequence[Loaded], rollout: Rollout, step: int, action: int) -> Returned | None:
    """The simulation for this state and first action, if one was begun."""
    return _kept.get(_key(agents, rollout, step, action))


def begin(agents: Sequence[Loaded], rollout: Rollout, step: int, action: int) -> None:
    """Begin it, unless it was."""
    key = _key(agents, rollout, step, action)

    def make(told: Told) -> tuple[SimulatedReturns, ...]:
        """Progress is a thousandth of the whole; agents count alike."""

        def of(i: int) -> Told:
            return lambda done, steps: told(round(1000 * (i + done / steps)), 1000 * len(agents))

        return tuple(
            simulate_returns(each.agent, rollout, step, action, progress=of(i)) for i, each in enumerate(agents)
        )

    _kept.take(key, lambda: Work(make))
