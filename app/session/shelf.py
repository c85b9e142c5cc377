"""Work in the background by its key: what was asked for last stays, the oldest makes room."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from typing import Any, Generic

from app.session.background import Progress, Result, Work


class Shelf(Generic[Result]):
    """Pieces of work for all sessions of this server.

    Args:
        most: pieces that are kept.
        full: whether the pieces together are too much for another reason, such as their memory. The one that was
            asked for last stays all the same.
    """

    def __init__(self, most: int, full: Callable[[list[Work[Result]]], bool] = lambda _: False):
        self._most, self._full = most, full
        self._kept: OrderedDict[Hashable, Work[Result]] = OrderedDict()
        self._lock = threading.Lock()

    def get(self, key: Hashable) -> Work[Result] | None:
        """The work of a key, if it was begun and not cancelled since."""
        work = self._kept.get(key)
        return None if work is None or work.gone else work

    def take(self, key: Hashable, make: Callable[[Progress], Result]) -> Work[Result]:
        """The work of a key: the one there is, or a new one. Those that make room for it are cancelled."""
        with self._lock:
            work = self.get(key)
            if work is None:
                work = self._kept[key] = Work(make)
            self._kept.move_to_end(key)
            while len(self._kept) > 1 and (len(self._kept) > self._most or self._full(list(self._kept.values()))):
                self._kept.popitem(last=False)[1].cancel()
            return work

    def clear(self) -> None:
        """Cancel everything and keep nothing."""
        with self._lock:
            while self._kept:
                self._kept.popitem()[1].cancel()

    def items(self) -> list[tuple[Any, Work[Result]]]:
        """Keys and their work, the oldest first."""
        return list(self._kept.items())


@dataclass(frozen=True)
class Job(Generic[Result]):
    """Work that a person may ask for: where it is kept, its key, and what makes its result."""

    shelf: Shelf[Result]
    key: Hashable
    make: Callable[[Progress], Result]

    @property
    def work(self) -> Work[Result] | None:
        """It, if it was begun."""
        return self.shelf.get(self.key)

    def begin(self) -> None:
        """Begin it, unless it was."""
        self.shelf.take(self.key, self.make)
