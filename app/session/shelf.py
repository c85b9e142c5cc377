"""Work in the background by its key: what was asked for last stays, the oldest makes room."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Any, Generic, TypeVar

from app.session.background import Work

Kind = TypeVar("Kind", bound=Work[Any])


class Shelf(Generic[Kind]):
    """Pieces of work for all sessions of this server.

    Args:
        most: pieces that are kept.
        full: whether the pieces together are too much for another reason, such as their memory. The one that was
            asked for last stays all the same.
    """

    def __init__(self, most: int, full: Callable[[list[Kind]], bool] = lambda _: False):
        self._most, self._full = most, full
        self._kept: OrderedDict[Hashable, Kind] = OrderedDict()
        self._lock = threading.Lock()

    def get(self, key: Hashable) -> Kind | None:
        """The work of a key, if it was begun and not cancelled since."""
        found = self._kept.get(key)
        return None if found is None or found.gone else found

    def take(self, key: Hashable, make: Callable[[], Kind]) -> Kind:
        """The work of a key: the one there is, or a new one. Those that make room for it are cancelled."""
        with self._lock:
            found = self.get(key)
            if found is None:
                found = self._kept[key] = make()
            self._kept.move_to_end(key)
            while len(self._kept) > 1 and (len(self._kept) > self._most or self._full(list(self._kept.values()))):
                self._kept.popitem(last=False)[1].cancel()
            return found

    def clear(self) -> None:
        """Cancel everything and keep nothing."""
        with self._lock:
            while self._kept:
                self._kept.popitem()[1].cancel()

    def items(self) -> list[tuple[Any, Kind]]:
        """Keys and their work, the oldest first."""
        return list(self._kept.items())
