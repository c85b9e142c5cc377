"""Evaluation of an agent: whole episodes from held-out start seeds, which no training run ever uses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from laplace_core.acting.rules import RULES, Choose, Options
from laplace_core.agents.agent import Agent
from laplace_core.agents.capabilities import HasAtoms
from laplace_core.environments import vector
from laplace_core.errors import InputError

FIRST_SEED = 2 * 10**12
"""Start seeds of :func:`evaluate`; training starts below 10^9, and evaluations while training at half of this."""
AT_ONCE = 100
"""Episodes side by side."""


@dataclass(frozen=True, eq=False)
class Scores:
    """Returns and lengths of N episodes.

    Attributes:
        returns, lengths: ``(N,)``.
        running: ``(N,)``, whether each was still running at its end.
        starts: ``(N, O)``, the first observations.
        discounted: ``(N, G)``, returns at the discounts that were asked for.
    """

    returns: np.ndarray
    lengths: np.ndarray
    running: np.ndarray
    starts: np.ndarray
    discounted: np.ndarray

    @property
    def mean(self) -> float:
        return float(self.returns.mean())

    @property
    def standard_error(self) -> float:
        return float(_standard_error(self.returns))

    @property
    def discounted_errors(self) -> np.ndarray:
        """Standard error of the mean at every discount, ``(G,)``."""
        return _standard_error(self.discounted)


def _standard_error(values: np.ndarray) -> np.ndarray:
    """Standard error of the mean over the first axis; 0 for a single value, which has none."""
    count = len(values)
    return values.std(axis=0, ddof=1) / np.sqrt(count) if count > 1 else np.zeros(values.shape[1:])


def evaluate(
    agent: Agent, environment: str, *, episodes: int = 100, seed: int = 0, horizon: int | None = None,
    softness: float = 0.2, rule: str = "greedy", alpha: float = 1.0, steps: int = 1000, stretch: float = 1.5,
    solver: str = "tikhonov", selector: str = "typed", noise_level: float | None = None,
    first_seed: int = FIRST_SEED, discounts: np.ndarray | None = None, head: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Scores:  # fmt: skip
    """Act without exploration and add up rewards.

    Args:
        horizon: T; the episode is stopped after so many steps. None leaves it to the environment's own limit.
        rule: a name in :data:`laplace_core.acting.rules.RULES`; the others are its options.
        discounts: ``(G,)``, for the discounted returns.
        head: another one than the acting head to be greedy at.
        progress: called with (done, total) in steps; an exception that it raises cancels the evaluation.

    Raises:
        InputError: arguments that do not fit, or a rule that the agent has not learned enough for.
    """
    spec = vector.spec(environment)
    if spec.observation != agent.n_observations or spec.actions != agent.n_actions:
        raise InputError(f"this agent was not trained for {environment}: its observations or actions differ.")
    if rule not in RULES:
        raise InputError(f"rule {rule[:40]!r} is not one of {', '.join(RULES)}.")
    if not 1 <= episodes <= 100_000 or not 0 <= seed <= 10**6:
        raise InputError("episodes must be from 1 to 100,000, and the seed from 0 to 1,000,000.")
    length = horizon or spec.time_limit
    if horizon is not None and not 1 <= horizon <= 10_000:
        raise InputError(f"the horizon is {horizon}; it must be from 1 to 10,000 steps.")
    choose = RULES[rule](agent, length, Options(softness, alpha, steps, stretch, head, solver, selector, noise_level))
    starts = [first_seed + seed * 100_000 + i for i in range(episodes)]
    return played(choose, environment, starts, length, discounts=discounts, progress=progress)


def played(
    choose: Choose, environment: str, starts: Sequence[int], length: int | None, *, discounts: np.ndarray | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Scores:  # fmt: skip
    """One episode from each start seed, acted by a function from observations and the step to actions.

    Args:
        length: an episode is stopped after so many steps; None leaves it to the environment.
        discounts, progress: as in :func:`evaluate`.
    """
    gammas = np.zeros(0) if discounts is None else np.asarray(discounts, dtype=float)
    groups = [list(starts[i : i + AT_ONCE]) for i in range(0, len(starts), AT_ONCE)]
    parts = []
    for i, group in enumerate(groups):
        after_step = _part_of(progress, i, len(groups), length)
        parts.append(_episodes(choose, environment, group, length, gammas=gammas, after_step=after_step))
    return Scores(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def _part_of(
    progress: Callable[[int, int], None] | None, part: int, parts: int, length: int | None
) -> Callable[[int], None]:
    """Report the progress of one part of the episodes in steps of all parts: called after each step with its time."""
    if progress is None or length is None:
        return lambda time: None
    return lambda time: progress(part * length + time, parts * length)


def _episodes(
    choose: Choose, environment: str, starts: list[int], length: int | None, *, gammas: np.ndarray, after_step: Any
) -> Any:
    """The columns of :class:`Scores`, of one episode from each start seed, all in step."""
    envs = [vector.make(environment) for _ in starts]
    observations = np.array([env.reset(seed=start)[0].ravel() for env, start in zip(envs, starts, strict=True)])
    first = observations.copy()
    returns, lengths, discounted = (
        np.zeros(len(envs)),
        np.zeros(len(envs), dtype=int),
        np.zeros((len(envs), gammas.size)),
    )
    terminated, going = np.zeros(len(envs), bool), np.arange(len(envs))
    time = 0
    while going.size and (length is None or time < length):
        actions, still = choose(observations[going], time), []
        for i, action in zip(going, actions, strict=True):
            observation, reward, terminated[i], truncated, _ = envs[i].step(int(action))
            observations[i] = observation.ravel()
            returns[i] += reward
            discounted[i] += gammas**time * reward
            lengths[i] += 1
            if not (terminated[i] or truncated):
                still.append(i)
        going, time = np.array(still, dtype=int), time + 1
        after_step(time)
    for env in envs:
        env.close()
    return returns, lengths, ~terminated, first, discounted


def own_discount(agent: Agent) -> np.ndarray | None:
    """The discount of the return that an agent's fixed atoms stand for, ``(1,)``; None where it has none."""
    return np.array([agent.acting_discount]) if isinstance(agent, HasAtoms) else None


def return_notes(agent: Agent, scores: Scores) -> list[str]:
    """A warning if observed returns lie outside an agent's fixed atoms; an empty list if none do.

    Args:
        scores: with the discounted returns at :func:`own_discount`.
    """
    if not isinstance(agent, HasAtoms):
        return []
    low, high = float(agent.atoms[0]), float(agent.atoms[-1])
    observed = scores.discounted[:, 0]
    outside = int(np.count_nonzero((observed < low) | (observed > high)))
    if not outside:
        return []
    return [
        f"{outside} of {observed.size} discounted returns, which were {observed.min():.1f} to {observed.max():.1f}, "
        f"lie outside the atoms of this agent, {low:g} to {high:g}: set v_min and v_max wider"
    ]
