"""Caches of one process under one budget: all together hold so many bytes, and what was used least recently leaves.

:func:`cached` does what :func:`functools.lru_cache` does, with three differences. What is kept is counted in bytes as
well as in entries. Beyond the budget of the process (:data:`BUDGET`) the entries that were used least recently leave,
whichever cache they are in. Two threads that ask for the same at the same time share one computation.

Bytes are those of arrays, tensors, texts and of the objects around them, found by walking through fields, lists and
mappings (:func:`weigh`). A buffer that several entries share counts once.
"""

from __future__ import annotations

import sys
import threading
import weakref
from collections import deque
from collections.abc import Callable, Hashable, Iterable, Mapping
from dataclasses import dataclass
from functools import update_wrapper
from itertools import count
from types import BuiltinFunctionType, FunctionType, MethodType, ModuleType
from typing import Any, Generic, ParamSpec, TypeVar

import numpy as np

Arguments = ParamSpec("Arguments")
Value = TypeVar("Value")

MEGABYTES = 1_000
"""Budget of a process that sets none."""
_BUFFER = 1_024
"""Bytes from which on a buffer is worth remembering by its identity."""
_CONTENT = 100_000
"""Bytes from which on a buffer tells whose content an entry holds."""
_NO_CONTENT = (type, ModuleType, FunctionType, BuiltinFunctionType, MethodType)
_NUMBERS = frozenset({int, float, complex, bool, type(None)})
_TEXTS = frozenset({str, bytes, bytearray})
_ROWS = frozenset({tuple, list})
_SIZE = sys.getsizeof(1.0)  # of a number
_EMPTY = np.empty(0)


@dataclass(frozen=True, eq=False)
class Weight:
    """What some objects take.

    Attributes:
        own: bytes of small things, which count for every entry that holds them.
        buffers: bytes of each large buffer, by its identity.
    """

    own: int
    buffers: Mapping[int, int]

    @property
    def bytes(self) -> int:
        """All of it."""
        return self.own + sum(self.buffers.values())


def weigh(*objects: object) -> Weight:
    """Bytes of objects and of all that their fields, items and views lead to; functions, classes and modules are none.

    An array that is a view counts as the whole buffer that it keeps alive.
    """
    own, buffers = 0, dict[int, int]()
    seen, left = set[int](), list(objects)
    while left:
        each: Any = left.pop()
        kind = type(each)
        if kind in _NUMBERS:
            own += _SIZE
            continue
        if kind is np.ndarray:
            each = _owner(each)
            kind = type(each)
        if id(each) in seen or isinstance(each, _NO_CONTENT):
            continue
        seen.add(id(each))
        if kind is np.ndarray:
            identity, size = id(each), each.nbytes + sys.getsizeof(_EMPTY)
        elif kind in _TEXTS:
            identity, size = id(each), sys.getsizeof(each)
        elif kind.__module__.startswith("torch") and hasattr(each, "untyped_storage"):  # without importing torch
            storage = each.untyped_storage()
            identity, size = storage.data_ptr(), storage.nbytes()
        else:
            own += sys.getsizeof(each)
            left += _content(each, kind)
            continue
        if size < _BUFFER:
            own += size
        else:
            buffers[identity] = size
    return Weight(own, buffers)


def _owner(array: Any) -> Any:
    """The owner of an array's memory: the array itself, the array that it is a view of, or bytes."""
    while type(array) is np.ndarray and array.base is not None:
        array = array.base
    return array


def _content(each: Any, kind: type) -> Iterable[object]:
    """The contents of an object that is neither number nor buffer."""
    if kind in _ROWS:
        return list(each)
    if isinstance(each, Mapping):
        return [part for pair in list(each.items()) for part in pair]  # at once: another thread may add to it
    if isinstance(each, tuple | list | set | frozenset | deque):
        return list(each)
    slots = [getattr(each, name, None) for parent in kind.__mro__ for name in _slots(parent)]
    return slots + list(getattr(each, "__dict__", {}).values())


def _slots(kind: type) -> tuple[str, ...]:
    names = kind.__dict__.get("__slots__", ())
    return (names,) if isinstance(names, str) else tuple(names)


@dataclass(frozen=True)
class Usage:
    """What one cache holds, and how often it was asked.

    Attributes:
        bytes: of its entries; what entries of two caches share counts for both.
        fixed: whether its entries stay whatever the budget is.
    """

    name: str
    bytes: int
    entries: int
    hits: int
    misses: int
    fixed: bool = False


class Budget:
    """Bytes that the caches of a process may hold together.

    Args:
        limit: bytes; a smaller one, set later, lets entries go at once.
    """

    def __init__(self, limit: int):
        self.lock = threading.RLock()
        self._limit = limit
        self._bytes = 0
        self._buffers: dict[int, list[int]] = {}  # holders and bytes, by identity
        self.clock = count()  # of uses
        self._caches: list[Cache[Any]] = []
        self._late: deque[tuple[Cache[Any], Hashable]] = deque()

    @property
    def limit(self) -> int:
        return self._limit

    @limit.setter
    def limit(self, limit: int) -> None:
        with self.lock:
            self._limit = limit
            gone = self._trim()
        _tell(gone)

    @property
    def bytes(self) -> int:
        """Bytes of all entries, each buffer once."""
        return self._bytes

    @property
    def fixed(self) -> int:
        """Bytes of the entries that stay whatever the budget is."""
        with self.lock:
            return sum(cache.usage.bytes for cache in self._caches if cache.fixed)

    def usage(self) -> list[Usage]:
        """The use of every cache that is not empty, the largest first."""
        with self.lock:
            used = [cache.usage for cache in self._caches if len(cache)]
        return sorted(used, key=lambda one: -one.bytes)

    def clear(self) -> None:
        """Drop all entries but the fixed ones."""
        with self.lock:
            caches = [cache for cache in self._caches if not cache.fixed]
        for cache in caches:
            cache.clear()

    def drop_with_owner(self, owner: object, cache: Cache[Any], key: Hashable) -> None:
        """Let a value go, and whatever any cache holds of its content, as soon as its owner is gone."""
        weakref.finalize(owner, self._owner_gone, cache, key).atexit = False

    def _owner_gone(self, cache: Cache[Any], key: Hashable) -> None:
        self._late.append((cache, key))
        # The collector calls this in whatever a thread is at; in the middle of our own work it has to wait.
        if not self.lock._is_owned():  # type: ignore[attr-defined]  # which C has and typeshed has not
            self._drop_late()

    def _drop_late(self) -> None:
        while self._late:
            cache, key = self._late.popleft()
            cache.drop_content(key)

    # ---- for the caches, which hold the lock

    def _joined(self, cache: Cache[Any]) -> None:
        with self.lock:
            self._caches.append(cache)

    def _add(self, weight: Weight) -> None:
        self._bytes += weight.own
        for identity, size in weight.buffers.items():
            held = self._buffers.setdefault(identity, [0, size])
            self._bytes += 0 if held[0] else size
            held[0] += 1

    def _take(self, weight: Weight) -> None:
        self._bytes -= weight.own
        for identity in weight.buffers:
            held = self._buffers[identity]
            held[0] -= 1
            if not held[0]:
                self._bytes -= held[1]
                del self._buffers[identity]

    def _trim(self) -> list[_Gone]:
        """Let the least recently used entries go until the rest fits; those that went."""
        gone: list[_Gone] = []
        while self._bytes > self._limit:
            oldest = [
                (first[0], number)
                for number, cache in enumerate(self._caches)
                if not cache.fixed and (first := cache._oldest()) is not None
            ]
            if not oldest:
                break
            gone += self._caches[min(oldest)[1]]._shed()
        return gone


BUDGET = Budget(MEGABYTES * 1_000_000)
"""That of this process. The library keeps its caches in it; an application may set its limit."""


class _Entry(Generic[Value]):
    __slots__ = ("age", "value", "weight")

    def __init__(self, value: Value, weight: Weight, age: int):
        self.value, self.weight, self.age = value, weight, age


_Gone = tuple[Callable[[Any], None] | None, Any]
"""What wants to know that an entry has left, and its value."""


def _tell(gone: list[_Gone]) -> None:
    for tell, value in gone:
        if tell is not None:
            tell(value)


class Cache(Generic[Value]):
    """Values by key, the least recently used leaving first; safe for threads.

    Args:
        name: what :meth:`Budget.usage` calls it.
        most: entries that it keeps.
        budget: that it is counted in.
        fixed: whether its entries stay whatever the budget is; they count all the same.
        left: called with each value that had to leave.
    """

    def __init__(
        self,
        name: str,
        most: int,
        *,
        budget: Budget = BUDGET,
        fixed: bool = False,
        left: Callable[[Value], None] | None = None,
    ):
        self._name, self._most, self._budget, self.fixed, self._left = name, most, budget, fixed, left
        self._entries: dict[Hashable, _Entry[Value]] = {}
        self.hits = self.misses = 0
        budget._joined(self)

    def __len__(self) -> int:
        return len(self._entries)

    def __contains__(self, key: Hashable) -> bool:
        return key in self._entries

    def get(self, key: Hashable) -> Value | None:
        """The value of a key, which is then the last to leave; None where there is none."""
        entry = self._used(key)
        return None if entry is None else entry.value

    def put(self, key: Hashable, value: Value) -> bool:
        """Keep a value and its key; whether there is room for it at all, once others have made room."""
        self._budget._drop_late()
        weight = weigh(key, value)
        with self._budget.lock:
            gone = self._drop(key)
            if weight.bytes > self._budget.limit - (0 if self.fixed else self._budget.fixed):
                return False
            self.misses += 1
            self._entries[key] = _Entry(value, weight, next(self._budget.clock))
            self._budget._add(weight)
            while len(self._entries) > self._most:
                gone += self._shed()
            gone += self._budget._trim()
            kept = key in self._entries
        _tell([each for each in gone if each[1] is not value])
        return kept

    def recount(self, key: Hashable) -> None:
        """Weigh the value of a key again, if it is there: it has grown since."""
        with self._budget.lock:
            entry = self._entries.get(key)
        if entry is None:
            return
        weight = weigh(key, entry.value)
        with self._budget.lock:
            if self._entries.get(key) is not entry:
                return
            self._budget._take(entry.weight)
            self._budget._add(weight)
            entry.weight = weight
            gone = self._budget._trim()
        _tell(gone)

    def pop(self, key: Hashable) -> None:
        """Drop a value, if it is there."""
        with self._budget.lock:
            self._drop(key)

    def drop_content(self, key: Hashable) -> None:
        """Drop a value, and whatever any cache that is not fixed holds of its large buffers."""
        with self._budget.lock:
            entry = self._entries.get(key)
            if entry is None:
                return
            held = weigh(entry.value).buffers  # as it is now
            content = {identity for identity, size in held.items() if size >= _CONTENT}
            gone = self._drop(key)
            for cache in self._budget._caches:
                if not cache.fixed:
                    sharing = [at for at, one in cache._entries.items() if not content.isdisjoint(one.weight.buffers)]
                    gone += [each for at in sharing for each in cache._drop(at)]
        _tell(gone)

    def clear(self) -> None:
        """Drop all values."""
        with self._budget.lock:
            for key in list(self._entries):
                self._drop(key)

    def items(self) -> list[tuple[Hashable, Value]]:
        """Keys and values, the least recently used first."""
        with self._budget.lock:
            return [(key, entry.value) for key, entry in self._entries.items()]

    @property
    def usage(self) -> Usage:
        with self._budget.lock:
            own = sum(entry.weight.own for entry in self._entries.values())
            buffers: dict[int, int] = {}
            for entry in self._entries.values():
                buffers.update(entry.weight.buffers)
            held = own + sum(buffers.values())
            return Usage(self._name, held, len(self._entries), self.hits, self.misses, self.fixed)

    def _used(self, key: Hashable) -> _Entry[Value] | None:
        """The entry of a key, used just now; without the lock, for this is where the time would go."""
        entry = self._entries.get(key)
        if entry is None:
            return None
        self.hits += 1
        entry.age = next(self._budget.clock)
        return entry

    # ---- with the lock

    def _oldest(self) -> tuple[int, Hashable] | None:
        """Age and key of the entry that leaves first."""
        if not self._entries:
            return None
        key = min(self._entries, key=lambda key: self._entries[key].age)
        return self._entries[key].age, key

    def _shed(self) -> list[_Gone]:
        oldest = self._oldest()
        return [] if oldest is None else self._drop(oldest[1])

    def _drop(self, key: Hashable) -> list[_Gone]:
        entry = self._entries.pop(key, None)
        if entry is None:
            return []
        self._budget._take(entry.weight)
        return [(self._left, entry.value)]


class _Key(list[object]):
    """Arguments of a call, whose hash is computed once."""

    __slots__ = ("_hash",)

    def __init__(self, words: tuple[object, ...]):
        super().__init__(words)
        self._hash = hash(words)

    def __hash__(self) -> int:  # type: ignore[override]  # it is never changed
        return self._hash


_NAMED = object()
"""Stands before the arguments that are given by name."""


def _key(args: tuple[object, ...], kwargs: Mapping[str, object]) -> _Key:
    return _Key((*args, _NAMED, *sorted(kwargs.items())) if kwargs else args)


class _Making(Generic[Value]):
    """A computation under way."""

    def __init__(self) -> None:
        self.thread, self.done = threading.get_ident(), threading.Event()
        self.value: list[Value] = []  # one once it is there, none if it failed


class Cached(Generic[Arguments, Value]):
    """A function that remembers; see :func:`cached`."""

    def __init__(self, function: Callable[Arguments, Value], most: int, budget: Budget, *, fixed: bool = False):
        update_wrapper(self, function)
        self._function = function
        name = f"{function.__module__}.{function.__qualname__.lstrip('_')}"
        self._cache: Cache[Value] = Cache(name, most, budget=budget, fixed=fixed)
        self._lock = budget.lock
        self._making: dict[_Key, _Making[Value]] = {}

    def __call__(self, *args: Arguments.args, **kwargs: Arguments.kwargs) -> Value:
        key = _key(args, kwargs)
        while True:
            entry = self._cache._used(key)
            if entry is not None:
                return entry.value
            with self._lock:
                entry = self._cache._used(key)  # it may have come meanwhile
                if entry is not None:
                    return entry.value
                making = self._making.get(key)
                mine = making is None
                if making is None:
                    making = self._making[key] = _Making()
            if mine:
                return self._made(key, making, lambda: self._function(*args, **kwargs))
            if making.thread == threading.get_ident():  # it asks for itself
                return self._function(*args, **kwargs)
            making.done.wait()
            if making.value:
                return making.value[0]

    def _made(self, key: _Key, making: _Making[Value], make: Callable[[], Value]) -> Value:
        try:
            value = make()
            making.value.append(value)
            self._cache.put(key, value)
            return value
        finally:
            with self._lock:
                del self._making[key]
            making.done.set()

    def known(self, *args: Arguments.args, **kwargs: Arguments.kwargs) -> bool:
        """Whether the value of a call is kept now; to ask is no use of it."""
        return _key(args, kwargs) in self._cache

    def remember(self, value: Value, *args: Arguments.args, **kwargs: Arguments.kwargs) -> None:
        """Keep the value of a call that was made elsewhere."""
        self._cache.put(_key(args, kwargs), value)

    def recount(self, *args: Arguments.args, **kwargs: Arguments.kwargs) -> None:
        """Weigh the value of a call again, if it is kept: it has grown since."""
        self._cache.recount(_key(args, kwargs))

    def cache_clear(self) -> None:
        """Forget all values."""
        self._cache.clear()

    @property
    def usage(self) -> Usage:
        return self._cache.usage


def cached(
    most: int, *, budget: Budget = BUDGET, fixed: bool = False
) -> Callable[[Callable[Arguments, Value]], Cached[Arguments, Value]]:
    """Let a function of hashable arguments remember what it has returned.

    A value that alone exceeds the budget is returned and not kept. An exception is raised again at every call.

    Args:
        most: values that are kept at most.
        budget: in which they are counted.
        fixed: whether they stay whatever the budget is; for little that is always needed.
    """
    return lambda function: Cached(function, most, budget, fixed=fixed)
