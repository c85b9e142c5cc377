"""One process of low priority beside a server, which makes calls one after another for many sessions.

Whoever asks wants only the latest call: an earlier one that nobody else wants is dropped, or given up if it runs and
others wait. Small calls go before large ones. The process starts with the first call, ends after a while without one,
and ends with the process that started it.

What is sent between the two is pickled: both are ours, and no file or link from outside is read in this way. A process
of our own and not a pool's: a pool can neither give up one call nor end with a server that is stopped in the
middle of it.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Generic, TypeVar

import laplace_core
from laplace_core.caching import BUDGET
from laplace_core.errors import InputError
from laplace_core.supervise.parallel import TRIES, end_with, without_interrupt
from laplace_core.supervise.process import ONE_THREAD

Key = TypeVar("Key", bound=Hashable)
Result = TypeVar("Result")

LOW = 10
"""Niceness of the process: it gets a tenth of a core that others want. At 19 it would get a hundredth, and a search on
a busy server would not end."""
IDLE = 60.0
"""Seconds without a call after which the process ends."""
GIVEN = 2.0
"""Seconds that a call which nobody wants any more may still run while others wait: what is nearly done is kept."""
_LOOK_EVERY = 0.25  # seconds between two looks at whether a running call is still wanted
_CACHES = 200_000_000  # bytes that the caches of the process may hold


@dataclass(eq=False)
class _Call(Generic[Key]):
    """A call that is wanted.

    Attributes:
        owners: who wants it; nobody once all of them want something else.
    """

    key: Key
    function: Callable[..., Any]
    arguments: tuple[object, ...]
    is_large: bool
    owners: set[str] = field(default_factory=set)


class _Died(Exception):
    """The process is gone, or was ended, before it answered."""


class Aside(Generic[Key, Result]):
    """Calls in one process of low priority.

    Args:
        keep: called with the key of a call and its result, in a thread of this object.
        lost: called with the key of a call that raised an error, or whose process died ``TRIES`` times, and the error.
        is_there: whether an owner still waits.
    """

    def __init__(
        self,
        keep: Callable[[Key, Result], None],
        lost: Callable[[Key, Exception], None],
        is_there: Callable[[str], bool] = lambda owner: True,
    ):
        self._keep, self._lost, self._is_there = keep, lost, is_there
        self._changed = threading.Condition()
        self._calls: dict[Key, _Call[Key]] = {}  # the running one is there, too; the oldest is first
        self._running: _Call[Key] | None = None
        self._thread: threading.Thread | None = None

    def ask(
        self, owner: str, key: Key, function: Callable[..., Result], *arguments: object, is_large: bool = False
    ) -> None:
        """Want a call in place of whatever this owner wanted before; a call that is wanted already is shared.

        Args:
            function: of a module, so that the process can import it; arguments and result are pickled.
            is_large: whether calls that are not go before it.
        """
        with self._changed:
            for other in [call for call in self._calls.values() if call.key != key]:
                other.owners.discard(owner)
                if not other.owners and other is not self._running:
                    del self._calls[other.key]
            self._calls.setdefault(key, _Call(key, function, arguments, is_large)).owners.add(owner)
            self._changed.notify_all()
            if self._thread is None:
                self._thread = threading.Thread(target=self._work, daemon=True, name="calls aside")
                self._thread.start()

    def is_over(self, key: Key, wait: float = 0.0) -> bool:
        """Whether a call no longer waits or runs.

        Args:
            wait: seconds to give it.
        """
        with self._changed:
            return self._changed.wait_for(lambda: key not in self._calls, wait)

    # ---- in the thread

    def _work(self) -> None:
        process: _Process | None = None
        while (call := self._next()) is not None:
            died = 0
            while True:
                process = process or _Process()
                try:
                    self._keep(call.key, self._made(call, process))
                except _Died:
                    process.end()
                    process, died = None, died + 1
                    if self._is_wanted(call) and died < TRIES:
                        continue
                    if died == TRIES:
                        self._lost(call.key, InputError(f"the process of this search died {TRIES} times."))
                except Exception as error:  # noqa: BLE001 - whatever the function raises is told to those who asked
                    self._lost(call.key, error)
                break
            with self._changed:
                self._running = None
                del self._calls[call.key]
                self._changed.notify_all()
        if process is not None:
            process.end()

    def _next(self) -> _Call[Key] | None:
        """The call to make now, once there is one; None after a while without one."""
        with self._changed:
            if not self._changed.wait_for(lambda: bool(self._calls), IDLE):
                self._thread = None
                return None
            self._running = min(self._calls.values(), key=lambda call: call.is_large)
            return self._running

    def _made(self, call: _Call[Key], process: _Process) -> Result:
        """The result of a call.

        Raises:
            _Died: the process did, or the call was given up.
            Exception: what the function raised.
        """
        began = time.monotonic()
        process.send(call.function, call.arguments)
        while True:
            with contextlib.suppress(queue.Empty):
                result: Result = process.answer(_LOOK_EVERY)
                return result
            if time.monotonic() - began > GIVEN and len(self._calls) > 1 and not self._is_wanted(call):
                raise _Died

    def _is_wanted(self, call: _Call[Key]) -> bool:
        with self._changed:
            return any(self._is_there(owner) for owner in call.owners)


class _Process:
    """The process, as the server sees it. Both trust each other: what one writes, the other unpickles."""

    def __init__(self) -> None:
        with without_interrupt():
            self._process = subprocess.Popen(
                [sys.executable, "-m", "laplace_core.supervise.aside", str(os.getpid())],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                cwd=Path(laplace_core.__file__).parents[1],  # where -m finds this very package
                env=os.environ | ONE_THREAD,
            )
        self._answers: queue.SimpleQueue[tuple[bool, Any] | None] = queue.SimpleQueue()
        threading.Thread(target=self._read, daemon=True, name="answers from aside").start()

    def _read(self) -> None:
        assert self._process.stdout is not None  # it is a pipe
        # Closed here and not where the process is ended: a file must not be closed while another thread reads it.
        with self._process.stdout as answers, contextlib.suppress(EOFError, OSError, pickle.UnpicklingError):
            while True:
                self._answers.put(pickle.load(answers))  # noqa: S301 - from our own process
        self._answers.put(None)

    def send(self, function: Callable[..., object], arguments: tuple[object, ...]) -> None:
        """Let it make a call.

        Raises:
            _Died: it is gone.
            Exception: a call that cannot be pickled.
        """
        assert self._process.stdin is not None  # it is a pipe
        call = pickle.dumps((function, arguments), protocol=pickle.HIGHEST_PROTOCOL)  # whole, or nothing is written
        try:
            self._process.stdin.write(call)
            self._process.stdin.flush()
        except OSError:
            raise _Died from None

    def answer(self, seconds: float) -> Any:
        """The result of the function.

        Raises:
            queue.Empty: it did not within so many seconds.
            _Died: the process is gone.
            Exception: what the function raised.
        """
        answer = self._answers.get(timeout=seconds)
        if answer is None:
            raise _Died
        worked, value = answer
        if not worked:
            raise value
        return value

    def end(self) -> None:
        self._process.kill()
        self._process.wait()
        assert self._process.stdin is not None  # it is a pipe
        with contextlib.suppress(OSError):
            self._process.stdin.close()


def serve(parent: int) -> None:
    """Make the calls that come in through standard input, until it is closed or the parent is gone."""
    end_with(parent)
    if hasattr(os, "nice"):
        os.nice(LOW)
    BUDGET.limit = _CACHES
    with os.fdopen(os.dup(1), "wb") as answers, os.fdopen(os.dup(0), "rb") as calls:
        os.dup2(2, 1)  # what a library prints is no answer
        while True:
            try:
                function, arguments = pickle.load(calls)  # noqa: S301 - from the process that started this one
            except EOFError:
                return
            try:
                answer = (True, function(*arguments))
            except Exception as error:  # noqa: BLE001 - raised again where it is waited for
                answer = (False, error)
            answers.write(_packed(answer))
            answers.flush()


def _packed(answer: tuple[bool, object]) -> bytes:
    """An answer, whole; one that cannot be pickled is an error that says so."""
    try:
        return pickle.dumps(answer, protocol=pickle.HIGHEST_PROTOCOL)
    except Exception as error:  # noqa: BLE001 - whatever a result raises when it is packed
        return pickle.dumps((False, TypeError(f"the result cannot be sent: {error}")))


if __name__ == "__main__":
    serve(int(sys.argv[1]))
