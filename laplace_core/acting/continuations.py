"""Simulated continuations of an episode from one of its steps, past the environment's time limit.

A survival decoded from values knows no time limit, so the simulation has none. All continuations are given the same
past: the episode's start seed and its actions up to the step. Then each gets random numbers of its own; without that
they would be one and the same. Where an environment has no chance in it they are all the same even so: there, many
states with one outcome each take their place (:func:`outcomes_of_states`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from laplace_core.acting.rollout import Rollout, judge_of, length_of, one_thread, roll_out
from laplace_core.acting.rules import Choose, Judge, Options, for_deadline
from laplace_core.agents.agent import Agent
from laplace_core.code.ties import greedy_action
from laplace_core.environments import vector
from laplace_core.errors import InputError

MOST = 1_000
"""Continuations, and steps of each."""
_USUAL = Options()


@dataclass(frozen=True, eq=False)
class Continuations:
    """N continuations of K steps each.

    Attributes:
        rewards: ``(N, K)``; 0 where the episode is over.
        alive: ``(N, K)``, whether the step was taken: what ``survival`` predicts.
    """

    rewards: np.ndarray
    alive: np.ndarray

    @property
    def mean_reward(self) -> tuple[np.ndarray, np.ndarray]:
        """Estimate of E[r_tau], where an episode that is over counts 0, and its standard error, ``(K,)`` each."""
        return self.rewards.mean(axis=0), standard_error(self.rewards)

    @property
    def survival(self) -> tuple[np.ndarray, np.ndarray]:
        """Estimate of P(alive at tau) and its standard error, ``(K,)`` each."""
        return self.alive.mean(axis=0), standard_error(self.alive.astype(float))

    def exceeds(self, thetas: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """P(r_tau > theta, alive) and its standard error, ``(K, H)`` each: the tails that a tau-space stands for."""
        above = self.alive[..., None] & (self.rewards[..., None] > thetas)
        return above.mean(axis=0), standard_error(above.astype(float))


def standard_error(values: np.ndarray) -> np.ndarray:
    """Standard error of the mean over the first axis."""
    count = len(values)
    return values.std(axis=0, ddof=1) / np.sqrt(count) if count > 1 else np.zeros(values.shape[1:])


def steps_known(agent: Agent, rollout: Rollout, step: int, steps: int, *, own: bool) -> int:
    """How many of the next ``steps`` steps a rule decides: one for a deadline T is not defined after T."""
    if not own or not for_deadline(rollout.rule):
        return steps
    return min(steps, length_of(agent, rollout.environment, rollout.horizon) - step)


def continue_from(
    agent: Agent, rollout: Rollout, step: int, *, action: int | None = None, count: int = 100, steps: int = 200,
    seed: int = 0, own: bool = False, options: Options = _USUAL, progress: Callable[[int, int], None] | None = None,
) -> Continuations:  # fmt: skip
    """Continuations from the state before a step.

    They are greedy at the acting discount, which is the policy that the values are of; or go on under the rule of the
    episode, which is another process: then decoded and observed rewards differ by the policies as well.

    Args:
        rollout: whose start seed and actions lead there.
        action: taken first; None is the one that the episode took.
        count, steps: N and K; see :func:`steps_known`.
        seed: of the random numbers from there on.
        own: whether to go on under the episode's own rule, with the time to go that it has at each step.
        options: those of that rule.
        progress: called with (done, total) in steps, those that lead to the state and the K after it; an exception
            that it raises cancels the work.

    Raises:
        InputError: arguments out of range.
    """
    if not 0 <= step < len(rollout):
        raise InputError(f"step {step} does not exist: this episode has the steps 0 to {len(rollout) - 1}.")
    if not (1 <= count <= MOST and 1 <= steps <= MOST):
        raise InputError(f"count and steps must be from 1 to {MOST:,}.")
    if action is not None and not 0 <= action < agent.n_actions:
        raise InputError(f"action {action} does not exist: the actions are 0 to {agent.n_actions - 1}.")
    first = int(rollout.actions[step]) if action is None else action
    steps = steps_known(agent, rollout, step, steps, own=own)
    judge = _judge(agent, rollout, options) if own else lambda seen, time: agent.action_values(seen, agent.acting_head)
    told = progress or (lambda done, of: None)
    envs = [vector.make(rollout.environment, limited=False) for _ in range(count)]
    try:
        streams = np.random.SeedSequence([seed, step]).spawn(count)
        for env in envs:
            env.reset(seed=rollout.seed)
        for t, past in enumerate(rollout.actions[:step]):
            for env in envs:
                env.step(int(past))
            told(t + 1, step + steps)
        for env, stream in zip(envs, streams, strict=True):
            env.unwrapped.np_random = np.random.default_rng(stream)
        dice = np.random.default_rng(np.random.SeedSequence([seed, step, 1]))  # for random actions
        with one_thread():
            return _play(
                envs, rollout.observations[step], first, steps, past=step, choose=_choice(judge, agent.n_actions, dice),
                progress=lambda done, of: told(step + done, step + of),
            )  # fmt: skip
    finally:
        for env in envs:
            env.close()


def _judge(agent: Agent, rollout: Rollout, options: Options) -> Judge | None:
    length = length_of(agent, rollout.environment, rollout.horizon)
    rule = "readout" if rollout.rule == "decoded" else rollout.rule  # the same values, in a thousandth of the time
    return judge_of(agent, rule, length, gamma=rollout.gamma, options=options)[0]


def _choice(judge: Judge | None, actions: int, dice: np.random.Generator) -> Choose:
    if judge is None:
        return lambda seen, time: dice.integers(actions, size=len(seen))
    return lambda seen, time: greedy_action(judge(seen, time))


def _play(
    envs: list[Any],
    start: np.ndarray,
    first: int,
    steps: int,
    *,
    past: int,
    choose: Choose,
    progress: Callable[[int, int], None],
) -> Continuations:
    count = len(envs)
    rewards, alive = np.zeros((count, steps)), np.zeros((count, steps), dtype=bool)
    observations, going = np.tile(start, (count, 1)), np.arange(count)
    for t in range(steps):
        if going.size:
            actions, still = choose(observations[going], past + t) if t else np.full(count, first), []
            for i, action in zip(going, actions, strict=True):
                observation, rewards[i, t], terminated, _, _ = envs[i].step(int(action))
                observations[i], alive[i, t] = observation.ravel(), True
                if not terminated:
                    still.append(i)
            going = np.array(still, dtype=int)
        progress(t + 1, steps)
    return Continuations(rewards, alive)


@dataclass(frozen=True, eq=False)
class Outcomes:
    """Observed rewards after each of S states, on K steps.

    Attributes:
        observations: ``(S, O)``; actions: ``(S,)``, the first one taken.
        rewards, alive: ``(S, K)``, as in :class:`Continuations`.
    """

    observations: np.ndarray
    actions: np.ndarray
    rewards: np.ndarray
    alive: np.ndarray


def outcomes_of_states(
    agent: Agent, environment: str, *, episodes: int = 20, each: int = 10, steps: int = 200, seed: int = 0,
    like: Rollout | None = None, progress: Callable[[int, int], None] | None = None,
) -> Outcomes:  # fmt: skip
    """States along episodes and the rewards observed after them, without a time limit.

    Args:
        each: states of an episode, evenly spaced over its first ``steps`` steps.
        like: an episode by whose rule to act; greedy at the acting discount without one. Of a rule for a deadline T,
            states are taken from at most the first half of T, so that equally many steps are known after each.
        progress: called with (done, total) in steps of all episodes; an exception that it raises cancels the work.

    Raises:
        InputError: arguments out of range.
    """
    if not (1 <= episodes <= MOST and 1 <= each <= steps <= MOST):
        raise InputError(f"episodes and steps must be from 1 to {MOST:,}, and states of an episode at most its steps.")
    rule, gamma, length = "greedy", None, min(2 * steps, MOST)
    if like is not None:
        rule, gamma = "readout" if like.rule == "decoded" else like.rule, like.gamma
        if for_deadline(rule):
            length = length_of(agent, environment, like.horizon)
            steps = min(steps, (length + 1) // 2)
    parts: list[tuple[Any, ...]] = []
    for i in range(episodes):
        episode = roll_out(
            agent, environment, seed + i, rule=rule, horizon=length, gamma=gamma, limited=False, spaces=False,
            progress=_of_episode(progress, i, episodes),
        )  # fmt: skip
        whole = len(episode) if episode.terminated else len(episode) - steps
        for at in np.unique(np.linspace(0, max(0, min(steps, whole) - 1), each).astype(int)):
            observed = episode.rewards[at : at + steps]
            rewards, alive = np.zeros(steps), np.zeros(steps, dtype=bool)
            rewards[: len(observed)], alive[: len(observed)] = observed, True
            parts.append((episode.observations[at], episode.actions[at], rewards, alive))
    return Outcomes(*(np.array(column) for column in zip(*parts, strict=True)))


def _of_episode(progress: Callable[[int, int], None] | None, i: int, episodes: int) -> Callable[[int, int], None]:
    """Report the steps of one episode, which may end before its last, as those of all episodes."""

    def told(done: int, of: int) -> None:
        if progress is not None:
            progress(i * of + done, episodes * of)

    return told


@dataclass(frozen=True, eq=False)
class Calibration:
    """Predicted against observed probability in B bins that are not empty: means, counts, and one standard error."""

    predicted: np.ndarray
    observed: np.ndarray
    errors: np.ndarray
    counts: np.ndarray


def calibration(predicted: np.ndarray, outcomes: np.ndarray, bins: int = 10) -> Calibration:
    """Observed frequencies of events by their predicted probability; predictions outside [0, 1] are in the end bins.

    The error is sqrt(p (1 - p) / n), as if predictions were independent: those of one episode are not, so it is a
    lower bound.
    """
    predicted, outcomes = np.ravel(predicted), np.ravel(outcomes).astype(float)
    if predicted.shape != outcomes.shape:
        raise InputError(f"{predicted.size} predictions do not fit {outcomes.size} outcomes.")
    place = np.digitize(predicted, np.linspace(0.0, 1.0, bins + 1)[1:-1])
    counts = np.bincount(place, minlength=bins)
    full = counts > 0
    mean, observed = (np.bincount(place, each, bins)[full] / counts[full] for each in (predicted, outcomes))
    return Calibration(mean, observed, np.sqrt(observed * (1.0 - observed) / counts[full]), counts[full])
