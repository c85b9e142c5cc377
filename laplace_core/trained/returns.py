"""Codes of the return side by side: the work of observing returns, the learned laws, and their table in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from laplace_core.acting import estimates
from laplace_core.acting.return_laws import (
    COUNT,
    INDEPENDENT,
    LEARNED,
    ReturnLaw,
    SimulatedReturns,
    has_return_law,
    return_laws,
    says_more_than_a_mean,
    simulate_returns_of,
)
from laplace_core.acting.rollout import Rollout
from laplace_core.caching import cached
from laplace_core.environments import vector
from laplace_core.supervise.jobs import Progress, Task
from laplace_core.training.checkpoint import Loaded


def returns(agents: Sequence[Loaded], rollout: Rollout, step: int, action: int) -> Task[tuple[SimulatedReturns, ...]]:
    """Returns of several agents from this state and first action: each goes on by its own greedy policy."""

    def make(progress: Progress) -> tuple[SimulatedReturns, ...]:
        return simulate_returns_of([each.agent for each in agents], rollout, step, action, progress=progress)

    def estimate() -> float:
        return estimates.of_returns([each.agent for each in agents], rollout, step)

    key = (*(each.agent for each in agents), rollout, step, action)
    return Task(key, make, estimate, slot="returns", by_itself=0.0)


def beside(loaded: Loaded, same: Sequence[Loaded]) -> list[Loaded]:
    """The opened agent, and then those of the same environment that say more than a mean."""
    others = [other for other in same if says_more_than_a_mean(other.agent)]
    own = [loaded] if has_return_law(loaded.agent) else []
    return own + [other for other in others if not _same(other, loaded)]


def _same(one: Loaded, other: Loaded) -> bool:
    """Whether a run or a file is a bundled agent."""
    return one is other or (one.settings == other.settings and one.step == other.step)


def offer(loaded: Loaded, step: int, name: str) -> str:
    """The simulation that is offered, in words; ``name`` is that of the first action."""
    times = f"{COUNT} times" if vector.chance(loaded.environment) else "once, because nothing here is random"
    return f"As learned. Simulated: {name} at step {step}, then each agent's own greedy policy, {times}."


def summary(observed: Sequence[SimulatedReturns], step: int, name: str) -> str:
    """The finished simulation, in words."""
    most, count = max(observed, key=lambda one: one.missing), len(observed[0].returns)
    times = f"{count} times" if count > 1 else "once, because nothing here is random"
    cut = f"the cut at {most.steps} steps leaves out at most {most.missing:.2g}" if most.missing else "all ended"
    return f"{name.capitalize()} at step {step}, then each agent's own greedy policy, {times}; {cut}. Shaded: W1."


@cached(128)
def law_of(loaded: Loaded, observation: tuple[float, ...], action: int, alpha: float) -> ReturnLaw:
    """The distribution that an agent predicts for one return."""
    return return_laws(loaded.agent, np.array(observation), [action], alpha)[0]


def title(loaded: Loaded, law: ReturnLaw, *, opened: bool) -> str:
    """The algorithm, and where what is drawn is not what was learned, what it is."""
    name = loaded.settings.TITLE + (" (opened)" if opened else "")
    note = loaded.settings.RETURN_LAW or ("" if law.kind == LEARNED else law.kind)
    return f"{name}, {note}" if note else name


def notes(
    agents: Sequence[Loaded], laws: Sequence[ReturnLaw], observation: tuple[float, ...], *, action: int,
    alphas: Sequence[float],
) -> str:  # fmt: skip
    """The meaning of the numbers of the table, and why the mean of an approximate law is not the agent's value."""
    words = ["All in discounted reward; ± is one standard error; by chance: W1 of as many draws from the learned law."]
    for each, law, alpha in zip(agents, laws, alphas, strict=True):
        if law.kind == INDEPENDENT:
            value = each.agent.action_values(np.array(observation)[None], each.agent.acting_head)[0, action]
            words.append(
                f"{each.settings.TITLE} knows the rewards of each step, but not how they depend on each other: its law "
                f"assumes independent steps. The agent's value is {value:.4g}; the mean of the law is lower or higher "
                f"by the error of the inverse at α {alpha:g}."
            )
            break
    return " ".join(words)
