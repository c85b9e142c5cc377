"""Ending a command by a signal."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NoReturn

from laplace_core import interrupt


@contextmanager
def by_exception() -> Iterator[None]:
    """Ctrl-C as ``KeyboardInterrupt`` and SIGTERM as ``SystemExit`` within the block, so that what is being written
    is dropped, and files keep their last whole state."""
    if threading.current_thread() is not threading.main_thread():  # no other may listen
        yield
        return

    def end(number: int, _frame: object) -> NoReturn:
        raise SystemExit(128 + number)

    before = {signal.SIGTERM: signal.signal(signal.SIGTERM, end)}
    if signal.getsignal(signal.SIGINT) is interrupt.end:
        before[signal.SIGINT] = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


class Stop:
    """Asks a run to end at its next step on SIGTERM, which may be repeated, or Ctrl-C, of which the second ends it at
    once.

    Attributes:
        asked: the number of the signal; 0 before there was one.
    """

    def __init__(self) -> None:
        self.asked = 0
        self._before: dict[int, Any] = {}

    def __enter__(self) -> Stop:
        if threading.current_thread() is threading.main_thread():  # no other may listen
            self._before = {number: signal.signal(number, self._ask) for number in (signal.SIGTERM, signal.SIGINT)}
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)
        self._before = {}

    def _ask(self, number: int, _: object) -> None:
        self.asked = number
        if number == signal.SIGINT:
            signal.signal(number, self._before[number])
