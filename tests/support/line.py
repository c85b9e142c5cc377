"""A line of jobs of a test's own: by a clock and with sessions that the test sets, and work that it lets go on."""

from __future__ import annotations

import threading

from laplace_core.supervise.jobs import Kind, Line, Progress

LIMIT, MOST = 100.0, 50
"""Seconds that a job may take, and jobs that may wait."""


class Server:
    """A line, the time, and the sessions that are there."""

    def __init__(self, threads: int = 1, kept: int = 0, most: int = MOST):
        self.now, self.gone = 0.0, set()
        self.line = Line(
            threads, kept=kept, most=most, limit=LIMIT, clock=lambda: self.now, is_there=lambda s: s not in self.gone
        )
        self.done: list[str] = []

    def kind(self, most: int = MOST, **more) -> Kind:
        return Kind("of a test", most, line=lambda: self.line, **more)


class Stub:
    """A run that goes on until it is told to end."""

    error = None

    def __init__(self):
        self.finished = False

    def cancel(self):
        self.finished = True

    def progress(self):
        return None

    history = snapshot = progress


class Gate:
    """Work that goes on step by step, each of them when a test lets it."""

    def __init__(self):
        self.begun, self._step, self._taken = threading.Event(), threading.Semaphore(0), threading.Semaphore(0)
        self._open = False

    def __call__(self, progress: Progress) -> str:
        self.begun.set()
        while not self._open:
            assert self._step.acquire(timeout=60)
            self._taken.release()
            progress(1, 2)
        return "done"

    def step(self) -> None:
        """Let it make a step, which reports its progress."""
        self._step.release()
        assert self._taken.acquire(timeout=60)

    def open(self) -> None:
        """Let it come to its end."""
        self._open = True
        self._step.release()
