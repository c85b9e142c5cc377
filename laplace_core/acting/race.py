"""A race against a deadline: two ways to act from the same start, and which has the larger return after T steps.

Start k of a race is the start seed ``FIRST_START`` + k. Training draws its start seeds below 10^9, the evaluations
while training lie from 10^12 and those after it from 2 * 10^12 (:mod:`laplace_core.acting.evaluation`): the starts of
a race are held out, no agent was trained or chosen on them. Where an environment has chance in it after the start, both
sides draw the same random numbers as long as they act alike.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from laplace_core.acting.bootstrap import mean_interval
from laplace_core.acting.evaluation import evaluate
from laplace_core.acting.rollout import Rollout, nearest_head, one_thread, roll_out
from laplace_core.acting.rules import Options
from laplace_core.agents.agent import Agent
from laplace_core.errors import InputError

FIRST_START = 2 * 10**9
MOST_START = 10**8
"""Largest k: all starts lie below 2^31, so that a rollout can be asked for each of them."""
MOST_RACES = 500
LEVEL = 1e-9
"""Returns that differ by less are equal: sums of the same rewards in another order."""

_USUAL = Options()
Progress = Callable[[int, int], None]
"""Called with (done, total); an exception that it raises cancels the work."""


@dataclass(frozen=True, eq=False)
class Entrant:
    """One side: an agent, the rule it acts by, for ``greedy`` another discount than the acting one, and options."""

    agent: Agent
    rule: str = "greedy"
    gamma: float | None = None
    options: Options = _USUAL


@dataclass(frozen=True, eq=False)
class Race:
    """Two episodes from start ``start``, each of at most ``horizon`` steps; they may end sooner."""

    start: int
    horizon: int
    left: Rollout
    right: Rollout

    @property
    def difference(self) -> float:
        """Return of the right side less that of the left, undiscounted, in units of reward."""
        return float(self.right.rewards.sum() - self.left.rewards.sum())

    @property
    def parting(self) -> int | None:
        """The first step, from 0, at which the actions differ; None if there is none."""
        common = min(len(self.left), len(self.right))
        differ = np.flatnonzero(self.left.actions[:common] != self.right.actions[:common])
        return int(differ[0]) if differ.size else None


@dataclass(frozen=True, eq=False)
class Races:
    """N races to the same deadline.

    Attributes:
        starts: ``(N,)``; left, right: ``(N,)``, undiscounted returns within ``horizon`` steps.
        left_lengths, right_lengths: ``(N,)``, steps taken.
    """

    environment: str
    horizon: int
    starts: np.ndarray
    left: np.ndarray
    right: np.ndarray
    left_lengths: np.ndarray
    right_lengths: np.ndarray

    @property
    def differences(self) -> np.ndarray:
        """``(N,)``: right less left, start by start; a mere rounding error is 0."""
        differences = self.right - self.left
        return np.where(np.abs(differences) <= LEVEL * np.maximum(1.0, np.abs(self.left)), 0.0, differences)

    def summary(self) -> dict[str, Any]:
        """Means, mean difference, its standard error and 95% bootstrap interval over starts, and shares of starts."""
        differences, count = self.differences, len(self.starts)
        return {
            "starts": count,
            "left": float(self.left.mean()),
            "right": float(self.right.mean()),
            "difference": float(differences.mean()),
            "standard_error": float(differences.std(ddof=1) / np.sqrt(count)),
            "interval": mean_interval(differences),
            "better": float((differences > 0).mean()),
            "equal": float((differences == 0).mean()),
            "worse": float((differences < 0).mean()),
        }

    def notable(self) -> dict[str, int]:
        """The starts with the smallest, the middle and the largest difference; of equals the first."""
        order = np.argsort(self.differences, kind="stable")
        best = int(np.argmax(self.differences))
        middle = order[(len(order) - 1) // 2]
        return {name: int(self.starts[i]) for name, i in (("worst", order[0]), ("median", middle), ("best", best))}


def race(
    environment: str, left: Entrant, right: Entrant, start: int, *, horizon: int, pictures: bool = False,
    progress: Progress | None = None,
) -> Race:  # fmt: skip
    """Two rollouts from one start.

    Args:
        start: k, from 0 to ``MOST_START``.
        horizon: T, in steps; both sides are stopped after so many.
        pictures: whether to keep a frame of every step.
        progress: called with (done, total) in steps of both sides; an exception that it raises cancels the race.

    Raises:
        InputError: arguments that do not fit, or a rule that an agent has not learned enough for.
    """
    _check_start(start)
    sides = []
    for i, one in enumerate((left, right)):
        half = _half(progress, i)
        sides.append(
            roll_out(
                one.agent, environment, FIRST_START + int(start), rule=one.rule, horizon=horizon, gamma=one.gamma,
                options=one.options, pictures=pictures, spaces=False, progress=half,
            )
        )  # fmt: skip
    return Race(int(start), horizon, *sides)


def races(
    environment: str, left: Entrant, right: Entrant, horizon: int, *, count: int = 100, first: int = 0,
    progress: Progress | None = None,
) -> Races:  # fmt: skip
    """Races from the starts ``first`` to ``first + count - 1``, all episodes of one side in step; no pictures.

    Args:
        progress: called with (done, total) in steps of both sides; an exception that it raises cancels the races.

    Raises:
        InputError: arguments that do not fit, or a rule that an agent has not learned enough for.
    """
    _check_start(first)
    if not 2 <= count <= MOST_RACES:
        raise InputError(f"the number of starts is {count}; it must be from 2 to {MOST_RACES}.")
    scores = []
    with one_thread():
        for i, one in enumerate((left, right)):
            head, _ = nearest_head(one.agent, one.rule, one.gamma)
            scores.append(
                evaluate(
                    one.agent, environment, episodes=count, horizon=horizon, rule=one.rule,
                    first_seed=FIRST_START + first, progress=_half(progress, i),
                    **asdict(replace(one.options, head=head)),
                )
            )  # fmt: skip
    a, b = scores
    return Races(environment, horizon, first + np.arange(count), a.returns, b.returns, a.lengths, b.lengths)


def _check_start(start: int) -> None:
    if not 0 <= start <= MOST_START:
        raise InputError(f"the start is {start}; it must be from 0 to {MOST_START:,}.")


def _half(progress: Progress | None, which: int) -> Progress | None:
    """Report the progress of one of two equal halves as that of the whole."""
    return None if progress is None else lambda done, of: progress(which * of + done, 2 * of)
