"""Learners as jobs: each in a separate process, watched through its files; the result is kept in memory.

A run belongs to what it learns and not to a session: a page that is loaded again finds it at work.
"""

from __future__ import annotations

import atexit
import hashlib
import shutil
import sys
import tempfile
import time
from dataclasses import dataclass, field
from functools import cache, lru_cache
from pathlib import Path
from typing import Any
from weakref import WeakValueDictionary

from laplace_core.caching import BUDGET, Cache
from laplace_core.errors import InputError
from laplace_core.supervise.jobs import WAITING, Job, Progress, Task, Wish, too_large
from laplace_core.tabular.learner import seconds_to_learn
from laplace_core.tabular.model import Learned
from laplace_core.tabular.process import Run, start
from laplace_core.tabular.settings import LearnSettings, ResolvedLearning
from laplace_core.worlds import World, dump_world

MOST_KEPT = 4
"""Runs that a session keeps; the oldest leaves first."""
_LOOK_EVERY = 0.2  # seconds between two looks at a process


@cache
def _room() -> Path:
    """A folder for the files of all runs of this process, gone with it."""
    room = Path(tempfile.mkdtemp(prefix="laplace_runs_"))

    def clear() -> None:
        for work in list(_at_work.values()):
            work.stop()
        shutil.rmtree(room, ignore_errors=True)

    atexit.register(clear)
    return room


class Work:
    """The work of one job: it starts a process, watches it until it ends, and keeps the learned values.

    That counts in the memory of the server for its caches, and leaves with what was used least recently there.
    """

    def __init__(self, key: str, world: World, settings: LearnSettings):
        self._key, self._world, self._settings = key, world, settings
        self._run: Run | None = None
        self._last: dict[str, Any] | None = None
        self._has_learned, self._too_large = False, ""
        self._place = object()  # the key of its own in the cache

    def learn(self, progress: Progress) -> Work:
        """The work.

        Raises:
            InputError: the process cannot start, or ended by itself without finishing; or what was learned takes more
                memory than the server has for its caches.
        """
        _at_work[self._key] = self
        try:
            folder = Path(tempfile.mkdtemp(dir=_room()))
        except OSError:
            raise InputError(
                "this server has no temporary folder for what is learned: its owner may set TMPDIR to one."
            ) from None
        try:
            run = self._run = start(self._world, self._settings, folder)
            while not run.finished:
                said: dict[str, Any] = run.progress() or {}
                progress(int(said.get("episodes", 0)), int(said.get("of", 0)))
                time.sleep(_LOOK_EVERY)
            if run.error:
                raise InputError(run.error)
        finally:
            self.stop()
            shutil.rmtree(folder, ignore_errors=True)
        if self._too_large:
            raise InputError(self._too_large)
        return self

    def stop(self) -> None:
        """End the process, within a second, and keep what it has written last."""
        run = self._run
        if run is None:
            return
        run.cancel()
        self._last, learned = run.progress(), run.snapshot()
        if learned is not None and _learned.put(self._place, learned):
            BUDGET.drop_with_owner(self, _learned, self._place)
            self._has_learned = True
        elif learned is not None:
            self._too_large = too_large(learned, BUDGET, "lower the number of learners, discounts or thetas")
        self._run = None  # it holds the snapshot too

    def progress(self) -> dict[str, Any] | None:
        """The last line of progress, None before the first."""
        run = self._run
        return run.progress() if run else self._last

    def learned(self) -> Learned | None:
        """The last snapshot; the same object until there is a new one. None before the first, and once it has left."""
        run = self._run
        return run.snapshot() if run else _learned.get(self._place)

    @property
    def lost(self) -> bool:
        """Whether the learned values were dropped to free memory."""
        return self._run is None and self._has_learned and self._place not in _learned


def learning(world: World, settings: ResolvedLearning, *, slot: str) -> Task[Work]:
    """Learners of a world as work that can be asked for; their key is that of what they learn."""
    key = hashlib.sha256(repr((dump_world(world), settings, slot)).encode()).hexdigest()
    lower = "lower the number of episodes or of learners"
    return Task(key, Work(key, world, settings).learn, lambda: _seconds(world, settings), slot, lower)


_seconds = lru_cache(maxsize=32)(seconds_to_learn)
_learned: Cache[Learned] = Cache("learned gamma-spaces", sys.maxsize)
_at_work: WeakValueDictionary[str, Work] = WeakValueDictionary()


class Watched:
    """A run as one session sees it: waiting for a place, learning, or at its end with what it has learned."""

    def __init__(self, key: str, job: Job[Work]):
        self._key, self._job, self._work, self._left = key, job, _at_work.get(key), False

    def look(self, job: Job[Work] | None) -> None:
        """Another look at it; a job is there unless the session has left it or it has ended."""
        if job is not None:
            self._job, self._left = job, False
        self._work = _at_work.get(self._key) or self._work

    @property
    def running(self) -> bool:
        """Whether it waits or learns."""
        return self._job.going and not self._left

    @property
    def waiting(self) -> bool:
        """Whether it still waits for a place."""
        return self.running and self._job.state == WAITING

    @property
    def before(self) -> int:
        """Runs before it, while it waits."""
        return self._job.before

    @property
    def error(self) -> str | None:
        """One sentence if it ended without finishing and without being stopped."""
        if self._job.why:
            return f"{self._job.why}; what was learned until then stays."
        return self._job.refusal

    @property
    def lost(self) -> bool:
        """Whether the learned values were dropped to free memory, so that they must be learned again."""
        return self._work is not None and not self.running and self._work.lost

    def progress(self) -> dict[str, Any] | None:
        return self._work.progress() if self._work else None

    def learned(self) -> Learned | None:
        """The last snapshot; the same object until there is a new one."""
        return self._work.learned() if self._work else None

    def cancel(self, wish: Wish[Work]) -> None:
        """Leave it: unless another session waits for it, it ends within a second. What was learned so far stays."""
        self._left = True
        wish.cancel()
        if self._job.gone:
            self._job.wait(5.0)
            self.look(None)


@dataclass
class Runs:
    """The runs that a session has looked at last, by what they learn."""

    watched: dict[str, Watched] = field(default_factory=dict)

    def watch(self, wish: Wish[Work]) -> Watched | None:
        """The run of a wish, if this session has begun or seen it, or its link holds it."""
        mine, key = self.watched, str(wish.key)
        job = wish.look() if key in mine or wish.by_itself else None
        if job is not None:
            one = mine.pop(key, None) or Watched(key, job)
            mine[key] = one  # the latest is the last
            while len(mine) > MOST_KEPT:
                mine.pop(next(iter(mine)))
        if key in mine:
            mine[key].look(job)
            if mine[key].lost:
                self.forget(wish)
        return mine.get(key)

    def forget(self, wish: Wish[Work]) -> None:
        """Drop a run that is at its end, so that it may begin again."""
        wish.kind.drop(wish.key)
        self.watched.pop(str(wish.key), None)

    def at_work(self) -> bool:
        """Whether one of them is running."""
        return any(run.running for run in self.watched.values())
