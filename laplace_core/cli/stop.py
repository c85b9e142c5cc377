"""Ending a long command by a signal."""

from __future__ import annotations

import signal
import threading
from typing import Any


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
