"""Several learners of one world, advanced in turns so that all of them can be watched at once."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from functools import cached_property

import numpy as np

from laplace_core.code.gamma_space import encode
from laplace_core.study.pipeline import WorldStudy, study
from laplace_core.tabular.model import CURVE_NAMES, Learned, PeerTables
from laplace_core.tabular.peers import Categorical, Expectile, PlainQ, Quantile
from laplace_core.tabular.reading import bounds_of, study_settings
from laplace_core.tabular.settings import LearnSettings, ResolvedLearning, resolve_learning
from laplace_core.tabular.td import LaplaceTD, Progress, Schedule, learn
from laplace_core.worlds import World

NOTES = 200
"""Points on a learning curve, about; some more at its beginning."""
EVENT_STEPS = 20_000
"""Transitions between two events, at most (unless one episode alone is longer): a fraction of a second."""


class Learning:
    """A run of learning: iterate over it, and look at :meth:`snapshot` whenever you like.

    Each turn of the iteration advances one learner by a few episodes and yields its index; the learners take turns.
    The result of each depends on its seed alone, not on the others.
    """

    def __init__(self, world: World, settings: LearnSettings):
        self.world, self.settings = world, resolve_learning(settings, world)
        s = self.settings
        self.every = max(1, min(s.episodes // (10 * NOTES), EVENT_STEPS // s.max_steps))
        bounds = bounds_of(world, s) if s.peers else None
        self._learners = [_Learner(world, s, s.seed + i, self.every, bounds=bounds) for i in range(s.seeds)]
        self._bounds = bounds
        self.seconds = 0.0

    def __iter__(self) -> Iterator[int]:
        running, _ = dict(enumerate(self._learners)), self._range  # solved once, before time counts
        while running:
            for index in list(running):
                since = time.perf_counter()
                event = next(running[index].events, None)
                if event is None:
                    del running[index]
                    continue
                self._note(running[index], event)
                self.seconds += time.perf_counter() - since
                yield index

    @property
    def finished(self) -> bool:
        return all(learner.episode == self.settings.episodes for learner in self._learners)

    @property
    def progress(self) -> dict[str, object]:
        """The progress of learning in plain numbers: a line of the progress file.

        ``return`` and ``error`` are means over the seeds of what ``CURVE_NAMES`` says, None before the first event.
        """
        done = sum(learner.episode for learner in self._learners)
        total = self.settings.episodes * self.settings.seeds
        steps = sum(learner.steps for learner in self._learners)
        seen = [learner for learner in self._learners if learner.episode]
        returns, errors = ([c[name][-1] for c in map(self._curve, seen)] for name in ("return", "error"))
        return {
            "episodes": done,
            "of": total,
            "steps": steps,
            "steps_per_second": round(steps / self.seconds) if self.seconds else 0,
            "return": float(np.mean(returns)) if seen else None,
            "error": float(np.mean(errors)) if seen else None,
            "seconds": round(self.seconds, 3),
            "eta": round(self.seconds / done * (total - done), 3) if done else None,
            "finished": self.finished,
        }

    def snapshot(self) -> Learned:
        """A copy of the tables learned so far."""
        each = self._learners
        return Learned(
            world=self.world,
            settings=self.settings,
            basis=np.stack([learner.laplace.table[:, :, : learner.grid] for learner in each]).astype(np.float32),
            acting_values=np.stack([learner.laplace.acting_values for learner in each]),
            curves=tuple(self._curve(learner) for learner in each),
            finished=self.finished,
            peers=None if self._bounds is None else self._peers(*self._bounds),
        )

    def _peers(self, low: float, high: float) -> PeerTables:
        def stacked(read: Callable[[_Learner], np.ndarray], dtype: type = np.float64) -> np.ndarray:
            return np.stack([read(learner) for learner in self._learners]).astype(dtype)

        return PeerTables(
            laplace_values=stacked(lambda learner: learner.laplace.values[:, :, -1]),
            plain=stacked(lambda learner: learner.plain.values),
            categorical=stacked(lambda learner: learner.categorical.probabilities, np.float32),
            quantile=stacked(lambda learner: learner.quantile.locations, np.float32),
            expectile=stacked(lambda learner: learner.expectile.expectiles, np.float32),
            low=low,
            high=high,
        )

    def _note(self, learner: _Learner, event: Progress) -> None:
        learner.take(event)
        since = event.episode - learner.noted
        # Closer together at first, where most is learned.
        due = min(self.settings.episodes / NOTES, 0.1 * learner.noted)
        if since >= max(1.0, due) or event.episode == self.settings.episodes:
            learner.note(self._error(learner))

    def _curve(self, learner: _Learner) -> dict[str, np.ndarray]:
        """The points of the curve so far, and the present one."""
        points = learner.points
        if learner.episode > learner.noted:
            points = [*points, learner.now(self._error(learner))]
        columns = np.array(points, dtype=float).reshape(-1, len(CURVE_NAMES)).T
        return dict(zip(CURVE_NAMES, columns, strict=True))

    def _error(self, learner: _Learner) -> float:
        exact = self._exact
        space = exact.gamma_space
        basis = learner.laplace.table[exact.state, :, : learner.grid]
        values = encode(basis, self.world.reward_values, space.gammas, space.thetas, exact.settings.slope).values
        return float(np.abs(values - space.values).max() / self._range)

    @cached_property
    def _exact(self) -> WorldStudy:
        return study(self.world, study_settings(self.settings))

    @cached_property
    def _range(self) -> float:
        return float(np.ptp(self._exact.gamma_space.values)) or 1.0


def seconds_to_learn(
    world: World, settings: LearnSettings, *, most: float = 0.06, clock: Callable[[], float] = time.thread_time
) -> float:
    """About how long learning takes on this machine, all seeds together: measured on the first episodes of one.

    The very first one is not counted if there are others: it prepares what they find.

    Args:
        most: seconds after which the measurement ends, with the episode under way then.
        clock: seconds of work; by default those of this thread alone, whatever else the machine does.

    Raises:
        InputError: settings that do not fit the world.
    """
    s = resolve_learning(settings, world)
    learner = _Learner(world, s, s.seed, 1, bounds=bounds_of(world, s) if s.peers else None)
    times = [clock()]
    for _ in learner.events:
        times.append(clock())
        if times[-1] - times[0] >= most:
            break
    counted = times[1:] if len(times) > 2 else times
    return (counted[-1] - counted[0]) / (len(counted) - 1) * s.episodes * s.seeds


class _Learner:
    """One seed: the Laplace code, its peers if wanted, the stream of its events and its curve."""

    def __init__(
        self, world: World, s: ResolvedLearning, seed: int, every: int, *, bounds: tuple[float, float] | None
    ) -> None:
        discounts = s.discounts
        self.grid = discounts.size
        if bounds is not None:  # one more discount: what this code says of the return that the peers represent
            discounts = np.append(discounts, s.peer_gamma)
        self.laplace = LaplaceTD(
            world, discounts, channels=None, policy=s.policy, acting_gamma=s.acting_gamma, rate=s.rate
        )
        learners: list[LaplaceTD | PlainQ | Categorical | Quantile | Expectile] = [self.laplace]
        if bounds is not None:
            low, high = bounds
            self.plain = PlainQ(world, s.peer_gamma, rate=s.rate)
            self.categorical = Categorical(world, s.peer_gamma, np.linspace(low, high, s.atoms), rate=s.rate)
            self.quantile = Quantile(
                world, s.peer_gamma, count=s.quantiles, scale=high - low, rate=s.quantile_rate, takes_over=0.5
            )
            self.expectile = Expectile(world, s.peer_gamma, low, high, count=s.expectiles, rate=s.rate)
            for peer in (self.plain, self.categorical, self.quantile, self.expectile):
                peer.act = self.laplace.act  # type: ignore[method-assign]  # all evaluate the one policy that acts
                learners.append(peer)
        schedule = Schedule(s.episodes, seed, s.epsilon, s.max_steps, s.starts, every)
        self.events = learn(world, learners, schedule)
        self.points: list[tuple[float, ...]] = []  # one row of CURVE_NAMES a note
        self.episode = self.steps = self.noted = 0
        self._epsilon, self._change = 1.0, 0.0
        self._returns: list[float] = []

    def take(self, event: Progress) -> None:
        self.episode, self.steps, self._epsilon = event.episode, event.steps, event.epsilon
        self._change = max(self._change, event.largest_change)
        self._returns.append(event.episode_return)

    def now(self, error: float) -> tuple[float, ...]:
        """A row of ``CURVE_NAMES``."""
        return self.episode, self.steps, float(np.mean(self._returns)), self._epsilon, self._change, error

    def note(self, error: float) -> None:
        self.points.append(self.now(error))
        self.noted, self._change, self._returns = self.episode, 0.0, []
