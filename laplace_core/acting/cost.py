"""The time of acting on this machine, measured on a few steps before the work begins.

Episodes may end before their deadline, and most do: what is estimated from full lengths is an upper bound.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from weakref import WeakKeyDictionary

import numpy as np

from laplace_core.acting.frames import picture_of
from laplace_core.acting.rollout import RANDOM, judge_of, length_of, one_thread
from laplace_core.agents.agent import Agent
from laplace_core.code.ties import greedy_action
from laplace_core.environments import vector
from laplace_core.errors import InputError

FEW = 3
"""Observations in the larger of two batches: what one more costs is a third of what they cost above the smaller."""
REPEATS, ENOUGH = 10, 0.05
"""A measurement is done so often at the most, and not again after so many seconds; the shortest counts."""

Clock = Callable[[], float]


@dataclass(frozen=True)
class StepCost:
    """Seconds of the parts of a step.

    Attributes:
        choice: of one call of the rule, however many observations it gets; each: of every observation in it.
        step: of one environment; picture: of drawing it, 0 where nothing is drawn.
    """

    choice: float
    each: float
    step: float
    picture: float = 0.0

    def of(self, together: int = 1) -> float:
        """Seconds of one step of ``together`` environments side by side."""
        return self.choice + together * (self.each + self.step + self.picture)


def step_cost(
    agent: Agent, environment: str, rule: str = "greedy", *, horizon: int | None = None, gamma: float | None = None,
    pictures: bool = False, clock: Clock = time.thread_time,
) -> StepCost:  # fmt: skip
    """Measure the first steps of an episode under a rule.

    Args:
        rule, horizon, gamma: as of :func:`laplace_core.acting.rollout.roll_out`.
        pictures: whether every step is drawn.
        clock: seconds of work; by default those of this thread alone, whatever else the machine does.

    Raises:
        InputError: a rule that the agent has not learned enough for, or a discount that does not fit.
    """
    judge, _ = judge_of(agent, rule, length_of(agent, environment, horizon), gamma=gamma)
    env, action = vector.make(environment, pictures=pictures), 0
    try:
        seen = env.reset(seed=0)[0].ravel()[None]
        choice = each = 0.0
        if judge is not None and rule != RANDOM:
            with one_thread():
                one, few = (_least(partial(judge, seen.repeat(n, axis=0), 0), clock) for n in (1, FEW))
                action = int(greedy_action(judge(seen, 0)[0]))
            each = min(one, max(0.0, few - one) / (FEW - 1))
            choice = one - each

        def step() -> None:
            if any(env.step(action)[2:4]):
                env.reset(seed=0)

        took = _least(step, clock)
        return StepCost(choice, each, took, _least(lambda: picture_of(env), clock) if pictures else 0.0)
    finally:
        env.close()


def _least(work: Callable[[], object], clock: Clock) -> float:
    """Seconds of the quickest of a few repetitions, after one that does not count: it prepares what the others find."""
    work()
    took: list[float] = []
    while len(took) < REPEATS and sum(took) < ENOUGH:
        began = clock()
        work()
        took.append(clock() - began)
    return float(np.min(took))


_known: WeakKeyDictionary[Agent, dict[tuple[str, str, bool], StepCost]] = WeakKeyDictionary()
_NOTHING = StepCost(0.0, 0.0, 0.0)


def cost_of(
    agent: Agent, environment: str, rule: str = "greedy", horizon: int | None = None, *, pictures: bool = False
) -> StepCost:  # fmt: skip
    """The same, measured once and cached; zero for a rule that does not suit the agent, which the work refuses."""
    known, key = _known.setdefault(agent, {}), (environment, rule, pictures)
    if key not in known:
        try:
            known[key] = step_cost(agent, environment, rule, horizon=horizon, pictures=pictures)
        except InputError:
            return _NOTHING
    return known[key]
