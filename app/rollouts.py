"""Rollouts in the making and the last few that were made: one cache for all sessions of this server.

One thread works through them; a rollout takes seconds. The page asks again and again and reads how far it is.
"""

from __future__ import annotations

import threading
from collections import OrderedDict
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache

from app.player.payload import payload
from laplace_core.agents.agent import Agent
from laplace_core.agents.settings import GYMNASIUM_ENVIRONMENTS
from laplace_core.training.checkpoint import Loaded
from laplace_core.training.rollout import Rollout, longest, roll_out

MOST_KEPT, MOST_BYTES = 16, 200_000_000
"""Rollouts, and their memory together; the one that is asked for stays whatever its size, some 90 MB at the most."""


class _Cancelled(Exception):
    """Nobody waits for it any more."""


@dataclass(frozen=True)
class Control:
    """How an episode is acted; see :func:`laplace_core.training.rollout.roll_out`."""

    seed: int = 0
    rule: str = "greedy"
    horizon: int | None = None
    gamma: float | None = None


class Rolling:
    """One rollout: under way, done, or refused."""

    def __init__(self, loaded: Loaded, control: Control):
        self.control, self.done, self.of = control, 0, 0
        self._agent: Agent = loaded.agent
        self._environment = loaded.environment
        self._cancelled = threading.Event()
        self._future: Future[tuple[Rollout, bytes]] = _worker().submit(self._work)

    def _work(self) -> tuple[Rollout, bytes]:
        c, pictures = self.control, self._environment in GYMNASIUM_ENVIRONMENTS
        found = roll_out(
            self._agent, self._environment, c.seed, c.rule, c.horizon, c.gamma, pictures=pictures, told=self._hear
        )
        return found, payload(found)

    def _hear(self, done: int, of: int) -> None:
        if self._cancelled.is_set():
            raise _Cancelled
        self.done, self.of = done, of

    def cancel(self) -> None:
        self._cancelled.set()
        self._future.cancel()

    @property
    def going(self) -> bool:
        return not self._future.done()

    @property
    def gone(self) -> bool:
        """Whether it was cancelled: it has to be asked for anew."""
        return self._cancelled.is_set()

    def rollout(self) -> Rollout:
        """What came of it, once it is no longer going.

        Raises:
            InputError: it was refused.
        """
        return self._future.result()[0]

    def packed(self) -> bytes:
        """The same for the player."""
        return self._future.result()[1]

    @property
    def bytes(self) -> int:
        """Memory that it holds; nothing before it is done."""
        if self.going or self._future.cancelled() or self._future.exception():
            return 0
        return self.rollout().bytes + len(self.packed())


@cache
def _worker() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(max_workers=1, thread_name_prefix="rollout")


_kept: OrderedDict[tuple[Agent, Control], Rolling] = OrderedDict()
_lock = threading.Lock()


def rolling(loaded: Loaded, control: Control) -> Rolling:
    """The rollout of an agent under a control: the one there is, or a new one; the oldest makes room."""
    key = loaded.agent, control
    with _lock:
        if key not in _kept or _kept[key].gone:
            _kept[key] = Rolling(loaded, control)
        _kept.move_to_end(key)
        while len(_kept) > 1 and (len(_kept) > MOST_KEPT or sum(one.bytes for one in _kept.values()) > MOST_BYTES):
            _kept.popitem(last=False)[1].cancel()
        return _kept[key]


def most_steps(loaded: Loaded) -> int:
    """The longest horizon that can be asked for."""
    return longest(loaded.agent)
