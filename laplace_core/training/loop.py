"""The training loop: a generator of events that loggers, progress lines and screens consume."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import torch

from laplace_core.acting.evaluation import Scores, evaluate
from laplace_core.agents.settings import LoopSettings
from laplace_core.environments.vector import Environments, make
from laplace_core.supervise import memory
from laplace_core.training.checkpoint import new_agent, save_checkpoint
from laplace_core.training.events import Checkpoint, Episode, Evaluation, Event, Resumed, Step
from laplace_core.training.replay import buffer_of
from laplace_core.training.resume_point import arrays_of, restore_agent
from laplace_core.training.run_folder import RunFolder

_VALIDATION_SEED = 10**12  # start seeds of the evaluations while training
_LARGEST_START = 10**9  # start seeds of training are below
_ROUND = 8  # updates that are drawn for, and whose targets may be computed, at once


def train(
    settings: LoopSettings | None,
    run_folder: str | Path,
    *,
    resume: bool = False,
    stop: Callable[[], bool] | None = None,
    most_bytes: int | None = None,
) -> Iterator[Event]:
    """Train an agent; files in ``run_folder`` follow the events.

    The same settings give the same events, ``seconds`` aside. A run that was killed, at any moment, goes on with
    ``resume=True`` from its last resume point and ends with the metrics of one never interrupted, if the state of
    its environments can be saved. A consumer may stop at any event.

    Args:
        settings: may be None to resume.
        stop: called between two steps; when it returns True, the run ends with a resume point of that very step, which
            leaves no trace in its metrics.
        most_bytes: that all runs of the folder which this one is in may hold on disk; None is as much as there is.

    Raises:
        InputError: settings or a folder that do not fit, or no room for a resume point; then the last one stays.
    """
    folder = RunFolder(run_folder, settings, resume=resume, most_bytes=most_bytes)
    try:
        torch.set_num_threads(folder.settings.threads)
        memory.keep()
        run = _Run(folder)
    except BaseException:
        folder.close()
        raise
    try:
        yield from run.events(resume=resume, stop=stop or (lambda: False))
    finally:
        run.close()


class _Run:
    """The state that changes while training."""

    def __init__(self, folder: RunFolder):
        s = self.settings = folder.settings
        self.folder, self.started = folder, perf_counter()
        self.agent = new_agent(s)
        own = s.own_experience
        self.own_heads = np.arange(s.rings) if own else None
        seeds = np.random.SeedSequence(s.seed).generate_state(s.rings + 1)
        self.random = self.agent.random = np.random.default_rng(int(seeds[-1]))
        self.envs = Environments([partial(make, s.environment)] * s.rings, (seeds[:-1] % _LARGEST_START).tolist())
        self.replay = buffer_of(s, self.agent.n_observations)
        self.heads = np.full(s.rings, self.agent.acting_head)
        self.returns = np.zeros(s.rings)
        self.losses = [0.0, 0]  # sum and count since the last episode
        self.step = self.episodes = 0
        self.best: float | None = None

    def close(self) -> None:
        self.envs.close()
        self.folder.close()

    def events(self, *, resume: bool, stop: Callable[[], bool]) -> Iterator[Event]:
        s, saved = self.settings, self.folder.load() if resume else None
        self.folder.open_metrics(saved[1]["metrics_bytes"] if saved else 0)
        if saved:
            yield from self._restore(*saved)
        while self.step < s.steps:
            if stop():
                self._write_resume_point()
                return
            before = self.step
            yield from self._episodes(self._act())
            self._learn(before)
            if self._crossed(before, memory.EVERY):
                memory.give_back()
            yield Step(self.step)
            done = self.step >= s.steps
            if done or self._crossed(before, s.evaluate_every):
                yield from self._evaluate(last=done)
            if done or self._crossed(before, s.checkpoint_every):
                yield from self._save()

    def _crossed(self, before: int, every: int) -> int:
        """How many multiples of ``every`` lie between ``before``, excluded, and now."""
        return self.step // every - before // every

    def _seconds(self) -> float:
        return round(perf_counter() - self.started, 3)

    def _recorded(self, event: Event) -> Event:
        self.folder.write(event)
        return event

    @property
    def epsilon(self) -> float:
        s = self.settings
        faded = min(1.0, self.step / max(1.0, s.exploration * s.steps))
        return s.epsilon_first + faded * (s.epsilon_final - s.epsilon_first)

    def _act(self) -> Any:
        """Step all environments once and store the transitions; returns them."""
        s, envs, random = self.settings, self.envs, self.random
        self._choose_heads()
        observations, uniform = envs.observations, random.random(envs.count) < self.epsilon
        actions = random.integers(self.agent.n_actions, size=envs.count)
        if not uniform.all() and self.step >= s.learning_starts:
            actions = np.where(uniform, actions, self.agent.behave(observations, self.heads))
        stepped = envs.step(actions)
        self.replay.add(
            stepped.real, observations, actions, stepped.rewards, next_observations=stepped.observations,
            terminated=stepped.terminated, truncated=stepped.truncated, elapsed=stepped.elapsed,
        )  # fmt: skip
        self.returns[stepped.real] += stepped.rewards[stepped.real]
        self.step += int(stepped.real.sum())
        return stepped

    def _choose_heads(self) -> None:
        """At the start of an episode, decide which head behaves in it."""
        if self.own_heads is not None:
            self.heads = self.own_heads
            return
        fresh = np.flatnonzero(self.envs.fresh)
        if fresh.size:
            share = self.settings.head_exploration
            others = self.random.integers(self.agent.heads, size=fresh.size)
            explores = self.random.random(fresh.size) < share
            self.heads[fresh] = np.where(explores, others, self.agent.acting_head)

    def _episodes(self, stepped: Any) -> Iterator[Event]:
        for i in np.flatnonzero(stepped.real & (stepped.terminated | stepped.truncated)):
            self.episodes += 1
            total, count = self.losses
            self.losses = [0.0, 0]
            yield self._recorded(
                Episode(
                    self.step, self.episodes, int(self.heads[i]), float(self.returns[i]), int(stepped.elapsed[i]),
                    bool(stepped.truncated[i] and not stepped.terminated[i]), round(self.epsilon, 6),
                    total / count if count else None, self._seconds(),
                )
            )  # fmt: skip
            self.returns[i] = 0.0

    def _learn(self, before: int) -> None:
        s = self.settings
        if self.step < s.learning_starts:
            return
        progress = min(1.0, self.step / s.steps)
        correction = s.priority_correction + progress * (1.0 - s.priority_correction)
        left = self._crossed(before, s.update_every) * s.updates
        while left:
            count = min(left, _ROUND)
            batch, places = self.replay.sample(count * s.batch, self.random, correction)
            losses, each = self.agent.learn(batch, count, progress)
            self.replay.prioritise(places, each)
            for loss in losses:
                self.losses[0] += loss
            self.losses[1] += count
            left -= count

    def _evaluate(self, *, last: bool) -> Iterator[Event]:
        s = self.settings
        gammas = s.discounts()
        scores = evaluate(
            self.agent,
            s.environment,
            episodes=s.evaluate_episodes,
            seed=s.seed,
            first_seed=_VALIDATION_SEED,
            discounts=gammas,
        )
        # An equal score later in training replaces an earlier one: more has been learned since.
        best = self.best is None or scores.mean >= self.best
        if best:
            self.best = scores.mean
            save_checkpoint(self.folder.best, self.agent, self.step, scores.mean, episodes=s.evaluate_episodes)
        if last:
            save_checkpoint(self.folder.last, self.agent, self.step, scores.mean, episodes=s.evaluate_episodes)
        by_discount = self._predicted_and_observed(scores) if gammas.size else ()
        yield self._recorded(
            Evaluation(
                self.step, scores.mean, scores.standard_error, s.evaluate_episodes, best, self._seconds(),
                *by_discount,
            )
        )  # fmt: skip
        if best:
            yield self._recorded(Checkpoint(self.step, self.folder.best.name, self._seconds()))

    def _predicted_and_observed(self, scores: Scores) -> Iterator[tuple[float, ...]]:
        """Predicted and observed mean discounted returns of the starts, and the latter's error, ``(G,)`` each."""
        values, actions = self.agent.action_values(scores.starts), self.agent.greedy(scores.starts)
        taken = values[np.arange(len(actions)), :, actions]
        for means in (taken.mean(axis=0), scores.discounted.mean(axis=0), scores.discounted_errors):
            yield tuple(means.tolist())

    def _save(self) -> Iterator[Event]:
        # The event is written first: the metrics of a resume point are complete.
        event = self._recorded(Checkpoint(self.step, self.folder.resume_point.name, self._seconds()))
        self._write_resume_point()
        yield event

    def _write_resume_point(self) -> None:
        about = {
            "step": self.step,
            "episodes": self.episodes,
            "best": self.best,
            "heads": self.heads.tolist(),
            "returns": self.returns.tolist(),
            "losses": self.losses,
            "random": self.random.bit_generator.state,
            "envs": self.envs.state() if self.envs.saves else None,
        }
        self.folder.save(arrays_of(self.agent, self.replay), about)

    def _restore(self, arrays: dict[str, np.ndarray], about: dict[str, Any]) -> Iterator[Event]:
        restore_agent(self.agent, self.replay, arrays, self.folder.resume_point.name)
        self.step, self.episodes, self.best = about["step"], about["episodes"], about["best"]
        self.losses = about["losses"]
        self.random.bit_generator.state = about["random"]
        self.heads = np.array(about["heads"])
        if about["envs"] is not None:
            self.returns = np.array(about["returns"])
            self.envs.restore(about["envs"])
            message = "the run goes on exactly where it was"
        else:
            self.replay.cut()
            # The new episodes must not be those that the run began with.
            self.envs.close()
            seeds = self.random.integers(_LARGEST_START, size=self.envs.count).tolist()
            self.envs = Environments([partial(make, self.settings.environment)] * len(seeds), seeds)
            message = "the state of this environment cannot be saved: every one of them begins a new episode"
        event = Resumed(self.step, about["envs"] is not None, message, self._seconds())
        if not event.exact:  # an exact one leaves no trace in the metrics
            self.folder.write(event)
        yield event
