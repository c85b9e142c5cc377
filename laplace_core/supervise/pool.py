"""Calls of one function in several processes, which end with this one and of which any may be killed.

What the pools of the standard library lack: a call whose process was killed is made once more, workers do not outlive
a parent that was killed, and Ctrl-C is the parent's alone, so that no worker prints a traceback.
"""

from __future__ import annotations

import os
import signal
import threading
from collections import Counter, deque
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager
from multiprocessing import connection, get_context, parent_process
from multiprocessing.connection import Connection
from typing import Any, TypeVar

from laplace_core.errors import InputError

Item = TypeVar("Item")
Result = TypeVar("Result")
TRIES = 3
"""Times that a call is made whose processes are killed."""


def in_processes(function: Callable[[Item], Result], items: Sequence[Item], jobs: int) -> Generator[Result, None, None]:
    """The results of a function in the order of its arguments, each as soon as it and all before it are known.

    The processes are ended when the generator is closed.

    Args:
        function: of a module, or a ``functools.partial`` of one; called here where ``jobs`` is 1.
        jobs: calls at once.

    Raises:
        InputError: the processes of a call were killed :data:`TRIES` times.
        Exception: what the function has raised, in the place of its result.
    """
    if jobs == 1:
        yield from map(function, items)
        return
    waiting, results, killed = deque(range(len(items))), dict[int, tuple[Exception | None, Any]](), Counter[int]()
    workers: list[_Worker] = []
    try:
        for number in range(len(items)):
            while number not in results:
                for worker in workers:
                    if worker.at is None and waiting:
                        worker.give(waiting.popleft(), items)
                while waiting and len(workers) < jobs:
                    workers.append(_Worker(function))
                    workers[-1].give(waiting.popleft(), items)
                busy = {worker.pipe: worker for worker in workers if worker.at is not None}
                for pipe in connection.wait(list(busy)):
                    worker = busy[pipe]  # type: ignore[index]  # wait gives back what it was given
                    at = worker.at
                    assert at is not None  # it is busy
                    try:
                        results[at] = worker.take()
                    except (EOFError, OSError):
                        workers.remove(worker)
                        status = worker.end()
                        killed[at] += 1
                        if killed[at] == TRIES:
                            raise InputError(_words(status)) from None
                        waiting.appendleft(at)
            error, result = results.pop(number)
            if error is not None:
                raise error
            yield result
    finally:
        for worker in workers:
            worker.end()


def _words(status: int | None) -> str:
    how = f"killed (signal {-status})" if status is not None and status < 0 else f"ended (status {status})"
    return f"a process that was at work was {how} {TRIES} times: ask for fewer jobs if memory was short."


class _Worker:
    """A process that waits for arguments and answers with results.

    Attributes:
        pipe: this side of the way to it.
        at: the number of the argument that it has; None while it waits for one.
    """

    def __init__(self, function: Callable[[Any], Any]):
        context = get_context("spawn")
        self.pipe, other = context.Pipe()
        self.at: int | None = None
        self._process = context.Process(target=_work, args=(function, other), daemon=True)
        with _without_interrupt():
            self._process.start()
        other.close()  # so that the end of the process is the end of what comes from it

    def give(self, number: int, items: Sequence[Any]) -> None:
        self.at = number
        try:
            self.pipe.send(items[number])
        except OSError:  # it was killed: :meth:`take` will find that out
            return

    def take(self) -> tuple[Exception | None, Any]:
        """What the function has raised, or its result.

        Raises:
            EOFError, OSError: the process has ended.
        """
        answer: tuple[Exception | None, Any] = self.pipe.recv()
        self.at = None
        return answer

    def end(self) -> int | None:
        """End the process; returns its status."""
        self._process.kill()
        self._process.join()
        self.pipe.close()
        return self._process.exitcode


@contextmanager
def _without_interrupt() -> Iterator[None]:
    """Hold Ctrl-C back for a moment; a process that is started in it never hears of it."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _work(function: Callable[[Any], Any], pipe: Connection) -> None:
    """What a worker does until nobody is there any more who could give it something."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    while True:
        try:
            item = pipe.recv()
        except EOFError:
            return
        answer: tuple[Exception | None, Any]
        try:
            answer = None, function(item)
        except Exception as error:  # noqa: BLE001 - the parent raises it
            answer = error, None
        pipe.send(answer)


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)
