"""Work that takes seconds, in one thread for all sessions of this server; a page reads how far it is."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from concurrent.futures import wait as wait_for
from functools import cache
from typing import Generic, TypeVar

from laplace_core import InputError

Result = TypeVar("Result")
Progress = Callable[[int, int], None]
"""Called with how much is done, and of how much."""


class _Cancelled(Exception):
    """Nobody waits for it any more."""


class Work(Generic[Result]):
    """One piece of work: waiting, under way, done, refused or cancelled."""

    def __init__(self, make: Callable[[Progress], Result]):
        self.done, self.of = 0, 0
        self._cancelled = threading.Event()
        self._future: Future[Result] = _worker().submit(make, self._note)

    def _note(self, done: int, of: int) -> None:
        if self._cancelled.is_set():
            raise _Cancelled
        self.done, self.of = done, of

    def cancel(self) -> None:
        """End it at its next step."""
        self._cancelled.set()
        self._future.cancel()

    def wait(self, seconds: float) -> bool:
        """Give it a moment; returns whether it is at its end. What is soon done needs no words about its progress."""
        wait_for([self._future], seconds)
        return not self.going

    @property
    def going(self) -> bool:
        return not self._future.done()

    @property
    def gone(self) -> bool:
        """Whether it was cancelled: it has to be asked for anew."""
        return self._cancelled.is_set()

    @property
    def worked(self) -> bool:
        """Whether there is a result."""
        return self._future.done() and not self._future.cancelled() and self._future.exception() is None

    def result(self) -> Result:
        """The result, once it is no longer going.

        Raises:
            InputError: it was refused, or cancelled by somebody else.
        """
        if self.gone and not self.worked:
            raise InputError("this was cancelled: ask for it again.")
        return self._future.result()


@cache
def _worker() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(max_workers=1, thread_name_prefix="background")
