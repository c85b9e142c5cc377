"""Work that takes seconds, in threads: in which order it is done, for whom, for how long, and which results are kept.

Whoever shows results states what it wants as a :class:`Wish`, with an estimate of its cost. :meth:`Wish.look` starts
what is short; all else starts by :meth:`Wish.begin`, which is a button's, so that no link alone makes a server work for
long. A :class:`Job` ends early when no session that wants it is there any more, and at the limit of the server.
"""

from __future__ import annotations

import sys
import threading
import time
import weakref
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field
from typing import Any, Generic, NamedTuple, Self, TypeVar, cast

from laplace_core.caching import BUDGET, Budget, Cache, weigh
from laplace_core.errors import InputError

Result = TypeVar("Result")
Progress = Callable[[int, int], None]
"""Called with how much is done, and of how much; it raises where the work is to end."""

SHORT = 10.0
"""Seconds of estimate up to which work starts by itself, and has a thread kept free for it. An estimate counts episodes
at their full length: most of what starts in this way is done in one or two seconds."""
GRACE = 45.0
"""Seconds that work goes on without a session that wants it: a page that is loaded again is another session."""
RELOAD = 2.0
"""Seconds that a session which is not there still counts when another one cancels: somebody may be loading a page."""
TICK = 1.0
"""Seconds between two looks at which sessions are there."""
WAITING, RUNNING, DONE, REFUSED, ENDED = "waiting", "running", "done", "refused", "ended"
FULL = "the queue of this server is full; try again soon."


def duration(seconds: float) -> str:
    """A length of time in words, to one unit."""
    for size, unit in ((86_400, "days"), (3_600, "hours"), (60, "minutes")):
        if seconds >= 2 * size:
            return f"{seconds / size:,.0f} {unit}"
    count = max(1, round(seconds))
    return f"{count} second" + ("" if count == 1 else "s")


def too_large(result: object, budget: Budget, lower: str) -> str:
    """The sentence that refuses to keep a result."""
    return (
        f"the result takes {weigh(result).bytes / 1e6:,.0f} MB, and results, caches and opened files may take "
        f"{budget.limit / 1e6:,.0f} MB together on this server: {lower}."
    )


class _End(Exception):
    """Raised inside of work that is to end."""


class Job(Generic[Result]):
    """One piece of work: waiting, running, done, refused (its work raised an error) or ended before that.

    Attributes:
        seconds: its estimate.
        done, of: how far it is; ``of`` is 0 before its first step.
        why: why the server ended it, without a full stop; empty if it did not.
        seen: whether somebody has looked at its result.
    """

    def __init__(self, line: Line, make: Callable[[Progress], Result], seconds: float):
        self.seconds = seconds
        self.done, self.of, self.why, self.seen = 0, 0, "", False
        self.state, self.asked = WAITING, line.clock()
        self._line, self._make = line, make
        self._began = 0.0
        self._wanted: dict[str, float] = {}  # sessions, and when each was last there
        self._ending, self._over = threading.Event(), threading.Event()
        self._result: Result | None = None
        self._error: BaseException | None = None

    @property
    def going(self) -> bool:
        """Whether it waits or runs, and is not about to end."""
        return self.state in (WAITING, RUNNING) and not self._ending.is_set()

    @property
    def gone(self) -> bool:
        """Whether it ended without a result: it has to begin again."""
        return self.state == ENDED or (self.state in (WAITING, RUNNING) and self._ending.is_set())

    @property
    def worked(self) -> bool:
        return self.state == DONE

    @property
    def before(self) -> int:
        """Jobs that run or wait before it, while it waits."""
        return self._line.before(self)

    def result(self) -> Result:
        """The result, once it is no longer going.

        Raises:
            InputError: it was refused, or has ended.
        """
        if self.gone:
            raise InputError(f"{self.why or 'this was cancelled'}: ask for it again.")
        self._over.wait()
        self.seen = True
        if self._error is not None:
            raise self._error
        if self.gone:
            return self.result()
        return cast(Result, self._result)  # it has one, for it neither failed nor was ended

    @property
    def refusal(self) -> str | None:
        """The sentence with which its work refused to go on, if it did."""
        return str(self._error) if isinstance(self._error, InputError) else None

    def wait(self, seconds: float | None = None) -> bool:
        """Give it a moment; returns whether it is at its end. What is soon done needs no words about its progress."""
        return self._over.wait(seconds)

    def want(self, name: str) -> None:
        """A session waits for it."""
        with self._line.lock:
            self._wanted[name] = self._line.clock()

    def leave(self, name: str) -> None:
        """A session waits for it no more; it ends with the last one.

        A page that was loaded again is another session: the one before must not keep alive what this one cancels.
        """
        with self._line.lock:
            self._wanted.pop(name, None)
            now = self._line.clock()
            if not any(self._line.is_there(other) or now - since <= RELOAD for other, since in self._wanted.items()):
                self._wanted.clear()
                self.end()

    def wanted(self) -> bool:
        """Whether a session that wants it is open, or was a moment ago."""
        with self._line.lock:
            now = self._line.clock()
            self._wanted |= {name: now for name in self._wanted if self._line.is_there(name)}
            return any(now - since <= GRACE for since in self._wanted.values())

    @property
    def sessions(self) -> tuple[str, ...]:
        """Sessions that want it."""
        return tuple(self._wanted)

    def end(self, why: str = "") -> None:
        """End it at its next step, or at once if it waits.

        Args:
            why: for those who still look, without a full stop; empty if it was cancelled.
        """
        if self.state in (WAITING, RUNNING):
            self.why = self.why or why
            self._ending.set()
            self._line.withdraw(self)

    def run(self) -> None:
        """Do it, in the thread of this call."""
        self.state, self._began = RUNNING, self._line.clock()
        try:
            if self._ending.is_set():
                raise _End
            self._result = self._make(self._step)
            self._finish(DONE)
        except _End:
            self._finish(ENDED)
        except BaseException as error:  # noqa: BLE001 - raised again where the result is asked for
            self._error = error
            self._finish(REFUSED)

    def _step(self, done: int, of: int) -> None:
        if self._line.clock() - self._began > self._line.limit:
            self.end(f"it was ended after {duration(self._line.limit)}, the limit of this server")
        self._line.tick()
        if self._ending.is_set():
            raise _End
        self.done, self.of = done, of

    def withdrawn(self) -> None:
        """Whether it was withdrawn from the queue before it ran."""
        self._finish(ENDED)

    def _finish(self, state: str) -> None:
        self.state = state
        del self._make  # and all that it holds
        self._over.set()


class Usage(NamedTuple):
    """The use of a queue: jobs that run, jobs that wait, and how many may wait."""

    running: int
    waiting: int
    most_waiting: int


class Line:
    """Jobs that wait, and threads that do them: the shortest first, and none is passed for ever.

    A job's turn is the time at which it was asked for and the seconds that it takes: what waits for as long as it
    takes goes before everything that is added from then on. A session has one long job running at a time.

    Args:
        threads: at most; ``kept`` of them do short jobs only.
        most: jobs that may wait.
        limit: seconds that one job may take.
        is_there: whether a session of this name still is.
        clock: seconds, never backwards.
    """

    def __init__(
        self, threads: int, *, kept: int, most: int, limit: float, is_there: Callable[[str], bool],
        clock: Callable[[], float] = time.monotonic,
    ):  # fmt: skip
        self.limit, self.clock, self.is_there = limit, clock, is_there
        self.threads, self._kept, self._most = threads, kept, most
        self.lock = threading.RLock()
        self._changed = threading.Condition(self.lock)
        self._started, self._ticked = 0, clock()
        self._waiting: list[Job[Any]] = []
        self._running: list[Job[Any]] = []

    def add(self, job: Job[Any]) -> None:
        """Let a job wait for its turn.

        Raises:
            InputError: as many wait already as may.
        """
        with self._changed:
            self._drop_unwanted()
            if len(self._waiting) >= self._most:
                raise InputError(FULL)
            self._waiting.append(job)
            self._waiting.sort(key=lambda one: one.asked + one.seconds)
            if self._started < self.threads:
                self._started += 1
                threading.Thread(target=self._work, name="job", daemon=True).start()
            self._changed.notify_all()

    def before(self, job: Job[Any]) -> int:
        with self._changed:
            return len(self._running) + self._waiting.index(job) if job in self._waiting else 0

    def withdraw(self, job: Job[Any]) -> None:
        """Take a job out if it still waits."""
        with self._changed:
            if job in self._waiting:
                self._waiting.remove(job)
                job.withdrawn()

    def tick(self) -> None:
        """End what nobody wants, from time to time: called at each step of each job."""
        if self.clock() - self._ticked >= TICK:
            with self._changed:
                self._drop_unwanted()

    def usage(self) -> Usage:
        """Its present use."""
        with self._changed:
            return Usage(len(self._running), len(self._waiting), self._most)

    def _drop_unwanted(self) -> None:
        self._ticked = self.clock()
        for job in (*self._waiting, *self._running):
            if not job.wanted():
                job.end()

    def _work(self) -> None:
        while True:
            with self._changed:
                while (job := self._next()) is None:
                    self._changed.wait()
                self._waiting.remove(job)
                self._running.append(job)
            job.run()
            with self._changed:
                self._running.remove(job)
                self._changed.notify_all()
            del job  # and its result

    def _next(self) -> Job[Any] | None:
        """The job whose turn it is, if there is a place for it."""
        self._drop_unwanted()
        long = [job for job in self._running if job.seconds > SHORT]
        busy = {name for job in long for name in job.sessions} - {""}
        for job in self._waiting:
            if job.seconds <= SHORT or (len(long) < self.threads - self._kept and not set(job.sessions) <= busy):
                return job
        return None


class Kind(Generic[Result]):
    """Jobs of one kind by their keys, for all sessions of this server.

    What waits or runs stays, and so does what is done until somebody has seen it. Of the rest, the oldest makes room:
    first what no session wants any more. Results count in the memory of the server for its caches, and leave with what
    was used least recently there: they then have to be made anew.

    Args:
        name: what the results are called in the account of that memory.
        most: jobs at their end that are kept.
        line: where they wait; asked for with every job.
    """

    def __init__(self, name: str, most: int, *, line: Callable[[], Line], budget: Budget = BUDGET):
        self._most, self._line, self._budget = most, line, budget
        self._jobs: dict[Hashable, Job[Result]] = {}  # the one that was looked at last is the last
        self._counted: Cache[tuple[Hashable, Result]] = Cache(name, sys.maxsize, budget=budget, left=self._leave)
        self._lock = threading.RLock()

    @property
    def limit(self) -> float:
        """Seconds that one job may take."""
        return self._line().limit

    def get(self, key: Hashable) -> Job[Result] | None:
        """The job of a key, if it was begun and has not ended without a result."""
        job = self._jobs.get(key)
        return None if job is None or job.gone else job

    def why(self, key: Hashable) -> str:
        """Why the server ended the last job of a key, without a full stop; empty if it did not."""
        job = self._jobs.get(key)
        return "" if job is None else job.why

    def take(
        self, key: Hashable, make: Callable[[Progress], Result], seconds: float, name: str = "",
        *, lower: str = "ask for less",
    ) -> Job[Result]:  # fmt: skip
        """The job of a key: the one there is, or a new one.

        Args:
            name: the session that wants it.
            lower: what would make its result smaller.

        Raises:
            InputError: the line is full.
        """
        with self._lock:
            job = self.get(key)
            if job is None:
                job = Job(self._line(), lambda progress: self._count(key, make(progress), lower), seconds)
                job.want(name)
                self._line().add(job)
            job.want(name)
            self._jobs.pop(key, None)
            self._jobs[key] = job
            self._counted.get(key)  # it was used
            self._trim()
            return job

    def drop(self, key: Hashable) -> None:
        """Forget a job that is at its end, so that it may be done anew."""
        with self._lock:
            job = self._jobs.get(key)
            if job is not None and not job.going:
                self._remove(key)

    def clear(self) -> None:
        """End everything and keep nothing."""
        with self._lock:
            while self._jobs:
                self._jobs.popitem()[1].end()
            self._counted.clear()

    def items(self) -> list[tuple[Any, Job[Result]]]:
        """Keys and their jobs, the one that was looked at last as the last."""
        return list(self._jobs.items())

    def _trim(self) -> None:
        ended = [key for key, job in self._jobs.items() if not job.going]
        kept, last = len(ended), next(reversed(self._jobs))
        loose = [(wanted, key) for key in ended if key != last for wanted in (self._jobs[key].wanted(),)]
        for wanted, key in sorted(loose, key=lambda each: each[0]):
            if kept <= self._most:
                return
            if self._jobs[key].seen or self._jobs[key].gone or not wanted:
                kept -= 1
                self._remove(key)

    def _remove(self, key: Hashable) -> None:
        del self._jobs[key]
        self._counted.pop(key)

    def _count(self, key: Hashable, result: Result, lower: str) -> Result:
        """The result, once there is room for it.

        Raises:
            InputError: it takes more than all caches of the server may hold.
        """
        self._counted.pop(key)  # of a job that was cleared, and has come to its end all the same
        kept = key, result
        if not self._counted.put(key, kept):
            raise InputError(too_large(kept, self._budget, lower))
        with self._lock:
            if key not in self._jobs:
                self._counted.pop(key)
        return result

    def _leave(self, kept: tuple[Hashable, Result]) -> None:
        """Forget a job whose result had to make room."""
        with self._lock:
            self._jobs.pop(kept[0], None)


@dataclass
class Asked:
    """The jobs that one session wants.

    Attributes:
        name: of the session.
        jobs: the last one in each slot, while it is kept.
        left: jobs that it waits for no more, though others may.
        refused: by slot, the key of what it has cancelled or could not begin, and a sentence if it could not.
    """

    name: str = ""
    jobs: weakref.WeakValueDictionary[str, Job[Any]] = field(default_factory=weakref.WeakValueDictionary)
    left: weakref.WeakSet[Job[Any]] = field(default_factory=weakref.WeakSet)
    refused: dict[str, tuple[Hashable, str]] = field(default_factory=dict)

    def leave(self, slot: str) -> None:
        """It waits for the job in a slot no more."""
        before = self.jobs.pop(slot, None)
        if before is not None:
            before.leave(self.name)
            self.left.add(before)


@dataclass(frozen=True)
class Task(Generic[Result]):
    """Work that any session can wish for; its fields are those of a :class:`Wish`."""

    key: Hashable
    make: Callable[[Progress], Result]
    estimate: Callable[[], float]
    slot: str
    lower: str = "ask for less"
    by_itself: float = SHORT


@dataclass(frozen=True)
class Wish(Generic[Result]):
    """Work that a session wants; which one that is, says a class that is made of this one.

    Attributes:
        kind, key: where its job is found, in all sessions.
        make: makes the result.
        estimate: about how many seconds that takes; asked for only before it is begun.
        lower: what would make it shorter.
        slot: a session has one job in each slot: with another one begun, it waits for the one before no more.
        by_itself: seconds of estimate below which it starts without a button, unless the session has cancelled it. What
            only a button starts, at 0, goes on while the page shows something else.
    """

    kind: Kind[Result]
    key: Hashable
    make: Callable[[Progress], Result]
    estimate: Callable[[], float]
    slot: str
    lower: str = "ask for less"
    by_itself: float = SHORT

    @classmethod
    def of(cls, kind: Kind[Result], task: Task[Result]) -> Self:
        """The wish for a task, whose job is one of a kind."""
        return cls(kind, task.key, task.make, task.estimate, task.slot, task.lower, task.by_itself)

    @property
    def asked(self) -> Asked:
        """The jobs that the session of this code wants."""
        raise NotImplementedError

    def look(self) -> Job[Result] | None:
        """The job, which this session now waits for; what is short is begun. None: a button has to begin it."""
        job, asked = self.kind.get(self.key), self.asked
        if job is not None and job.going and job in asked.left:
            job = None
        elif job is not None or self._starts_by_itself(asked):
            self.begin()
            job = self.kind.get(self.key)
        if job is None and self.by_itself > 0.0:
            self._let_go()
        return job

    def _starts_by_itself(self, asked: Asked) -> bool:
        refused = asked.refused.get(self.slot, (None, ""))[0] == self.key
        return not refused and not self.kind.why(self.key) and self.estimate() < self.by_itself

    def begin(self) -> None:
        """Callback of a button: begin it, unless it is, and wait for it; see :attr:`notice` if that is refused."""
        asked = self.asked
        asked.refused.pop(self.slot, None)
        try:
            if self.kind.get(self.key) is None and self.too_long:
                raise InputError(self.too_long)
            seconds = self.estimate() if self.kind.get(self.key) is None else 0.0
            job = self.kind.take(self.key, self.make, seconds, asked.name, lower=self.lower)
        except InputError as error:
            asked.refused[self.slot] = self.key, str(error)
            return
        if asked.jobs.get(self.slot) is not job:
            self._let_go()
        asked.jobs[self.slot] = job
        asked.left.discard(job)

    def cancel(self) -> None:
        """Callback of a button: this session waits for it no more."""
        self._let_go()
        self.asked.refused[self.slot] = self.key, ""

    def _let_go(self) -> None:
        self.asked.leave(self.slot)

    @property
    def too_long(self) -> str:
        """The sentence that refuses it, if this server does no work that long."""
        seconds, most = self.estimate(), self.kind.limit
        if seconds <= most:
            return ""
        return f"this takes about {duration(seconds)}, and this server allows {duration(most)}: {self.lower}."

    @property
    def notice(self) -> str:
        """Why it cannot be begun, or was ended; empty if there is nothing to say."""
        key, sentence = self.asked.refused.get(self.slot, (None, ""))
        ended = self.kind.why(self.key)
        return self.too_long or (sentence if key == self.key else "") or (ended and f"{ended}: {self.lower}.")
