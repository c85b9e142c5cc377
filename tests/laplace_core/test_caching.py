"""Caches under one budget: what they remember, what leaves, what they count, and threads that ask for the same."""

from __future__ import annotations

import gc
import threading
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core.caching import Budget, Cache, cached, weigh

MEGABYTE = 1_000_000


def megabytes(count: float) -> np.ndarray:
    return np.ones(int(count * MEGABYTE / 8))


@dataclass(frozen=True, eq=False)
class Held:
    array: np.ndarray
    name: str = ""


class Slotted:
    __slots__ = ("array", "empty")

    def __init__(self, array: np.ndarray):
        self.array = array


# ---- what things weigh


@pytest.mark.parametrize(
    "wrap",
    [
        lambda array: array,
        lambda array: [array, {"again": array}],
        lambda array: {"key": (array,)},
        lambda array: Held(array),
        lambda array: Slotted(array),
        lambda array: array[::1000],  # a view keeps the whole buffer
        lambda array: array.reshape(2, -1)[1].T,
        lambda array: np.frombuffer(array.tobytes()),
        lambda array: array.tobytes(),
        lambda array: {Held(array), 3},
    ],
)
def test_an_array_counts_once_wherever_it_lies(wrap):
    """A million bytes, and a little for what is around them."""
    assert 1_000_000 <= weigh(wrap(megabytes(1))).bytes <= 1_002_000


def test_a_tensor_counts_by_its_storage_and_a_network_by_its_parameters():
    """100 x 50 weights in single floats are 20,000 bytes, 50 biases 200; a row of a matrix keeps all 1,000."""
    torch = pytest.importorskip("torch")
    layer = torch.nn.Linear(100, 50)
    assert sum(weigh(layer).buffers.values()) == 20_000
    assert weigh(layer).bytes > 20_200
    whole = torch.zeros(1000, 250)
    assert sum(weigh(whole[3]).buffers.values()) == 1_000_000


def test_functions_classes_and_modules_weigh_nothing():
    assert weigh(np, Held, megabytes, [].append).bytes == 0


# ---- what is remembered


@given(st.lists(st.integers(0, 6), max_size=60), st.integers(1, 5))
def test_entries_leave_as_those_of_lru_cache(asked, most):
    """Python's own cache is the twin: the same calls are computed again."""
    ours, theirs = [], []
    one = cached(most, budget=Budget(MEGABYTE))(lambda n: ours.append(n) or -n)
    other = lru_cache(most)(lambda n: theirs.append(n) or -n)
    for n in asked:
        assert one(n) == other(n) == -n
    assert ours == theirs
    assert (one.usage.hits, one.usage.misses) == other.cache_info()[:2]


def test_arguments_by_name_and_none_as_a_value_are_remembered():
    calls = []

    @cached(4, budget=Budget(MEGABYTE))
    def nothing(a: int, *, b: int = 0) -> None:
        """What it says."""
        calls.append((a, b))

    for _ in range(2):
        assert nothing(1, b=2) is None
        assert nothing(1) is None
    assert calls == [(1, 2), (1, 0)]
    assert nothing.__doc__ == "What it says."
    assert nothing.known(1, b=2)
    assert not nothing.known(1, b=3)
    nothing.cache_clear()
    nothing(1)
    assert len(calls) == 3


def test_a_refusal_is_raised_at_every_call_and_not_kept():
    calls = []

    @cached(4, budget=Budget(MEGABYTE))
    def refused(n: int) -> int:
        calls.append(n)
        raise ValueError(n)

    for _ in range(2):
        with pytest.raises(ValueError, match="1"):
            refused(1)
    assert calls == [1, 1]
    assert refused.usage.entries == 0


# ---- the budget


def test_the_least_recently_used_leaves_whichever_cache_it_is_in():
    budget = Budget(3_500_000)
    one, other = (cached(9, budget=budget)(lambda n, which=which: megabytes(1)) for which in "ab")
    one(1), other(1), one(2)
    one(1)  # used again: the other's is now the oldest
    one(3)
    assert (one.usage.entries, other.usage.entries) == (3, 0)
    assert budget.bytes <= budget.limit


def test_a_smaller_limit_lets_entries_go_at_once():
    budget = Budget(10 * MEGABYTE)
    made = cached(99, budget=budget)(lambda n: megabytes(1))
    for n in range(8):
        made(n)
    budget.limit = 3_500_000
    assert made.usage.entries == 3
    assert budget.bytes <= budget.limit


def test_what_is_larger_than_the_budget_is_returned_and_drives_nothing_out():
    budget = Budget(3 * MEGABYTE)
    made = cached(9, budget=budget)(lambda size: megabytes(size))
    made(1)
    assert made(4).nbytes == 4 * MEGABYTE
    assert made.usage.entries == 1


def test_a_buffer_that_several_entries_share_counts_once_until_the_last_has_left():
    budget, buffer = Budget(10 * MEGABYTE), megabytes(2)
    one, other = Cache[Held]("one", 9, budget=budget), Cache[Held]("other", 9, budget=budget)
    one.put("a", Held(buffer))
    other.put("b", Held(buffer[5:]))
    assert 2 * MEGABYTE <= budget.bytes < 2.01 * MEGABYTE
    assert [round(usage.bytes / MEGABYTE) for usage in budget.usage()] == [2, 2]
    one.pop("a")
    assert budget.bytes > 2 * MEGABYTE
    other.pop("b")
    assert budget.bytes == 0


def test_keys_count_too():
    budget = Budget(10 * MEGABYTE)
    cached(9, budget=budget)(lambda key: len(key))(b"x" * MEGABYTE)
    assert budget.bytes > MEGABYTE


def test_what_has_grown_counts_once_it_is_weighed_anew():
    budget = Budget(3 * MEGABYTE)
    made = cached(9, budget=budget)(lambda n: [])
    made(0)
    made(1).append(megabytes(2))
    made.recount(1)
    assert 2 * MEGABYTE < budget.bytes < budget.limit
    made(1).append(megabytes(2))
    made.recount(1)
    made.recount("not there")
    assert budget.bytes <= budget.limit
    assert made.usage.entries == 0


@given(
    st.lists(
        st.tuples(st.sampled_from(["put", "get", "pop", "recount", "limit"]), st.integers(0, 5), st.integers(0, 3)),
        max_size=40,
    )
)
def test_the_sum_is_that_of_all_buffers_that_are_held_and_stays_within_the_limit(steps):
    """The slow twin weighs everything that is there, together, after every step."""
    budget, shared = Budget(300_000), [np.ones(5_000 * (i + 1)) for i in range(4)]
    caches = [Cache[list]("a", 4, budget=budget), Cache[list]("b", 4, budget=budget)]
    for what, key, n in steps:
        cache = caches[key % 2]
        if what == "put":
            cache.put(key, [shared[n], np.ones(2_000 * n)])
        elif what == "get" and (value := cache.get(key)) is not None:
            value.append(shared[n])
            cache.recount(key)
        elif what == "limit":
            budget.limit = 100_000 * (n + 1)
        else:
            getattr(cache, "pop" if what == "pop" else "recount")(key)
        weights = [weigh(*pair) for cache in caches for pair in cache.items()]
        buffers = {identity: size for weight in weights for identity, size in weight.buffers.items()}
        assert budget.bytes == sum(weight.own for weight in weights) + sum(buffers.values())
        assert budget.bytes <= budget.limit


def test_fixed_entries_stay_and_leave_less_room_for_the_others():
    budget = Budget(3_500_000)
    fixed, told = cached(9, budget=budget, fixed=True)(lambda n: megabytes(1)), []
    other = Cache[np.ndarray]("other", 9, budget=budget, left=lambda array: told.append(array.nbytes))
    fixed(1)
    other.put(1, megabytes(2))
    fixed(2)
    assert (len(other), fixed.usage.entries, told) == (0, 2, [2 * MEGABYTE])
    assert not other.put(2, megabytes(2))
    budget.clear()
    assert budget.fixed == budget.bytes > 2 * MEGABYTE


def test_what_an_owner_has_brought_leaves_every_cache_with_the_owner():
    class Owner: ...

    budget, brought, others = Budget(10 * MEGABYTE), megabytes(1), megabytes(1)
    files = Cache[Held]("files", 9, budget=budget, fixed=True)
    views = cached(9, budget=budget)(lambda held, n: held.array[n:])
    owner = Owner()
    files.put("file", Held(brought))
    budget.drop_with_owner(owner, files, "file")
    views(Held(brought), 1), views(Held(others), 1)
    del brought, owner
    gc.collect()
    assert (len(files), views.usage.entries) == (0, 1)
    assert budget.bytes < 1.01 * MEGABYTE


def test_an_owner_that_goes_while_the_lock_is_held_is_served_by_the_next_that_puts_something():
    class Owner: ...

    budget = Budget(10 * MEGABYTE)
    files = Cache[np.ndarray]("files", 9, budget=budget, fixed=True)
    owner = Owner()
    files.put("file", megabytes(1))
    budget.drop_with_owner(owner, files, "file")
    with budget.lock:
        del owner
        gc.collect()
        assert len(files) == 1
    files.put("next", megabytes(1))
    assert [key for key, _ in files.items()] == ["next"]


# ---- threads


class Noted(threading.Event):
    """An event that tells when somebody begins to wait for it."""

    def __init__(self) -> None:
        super().__init__()
        self.waited = threading.Event()

    def wait(self, timeout: float | None = None) -> bool:
        self.waited.set()
        return super().wait(timeout)


@pytest.mark.parametrize("limit", [MEGABYTE, 10], ids=["kept", "too large to be kept"])
def test_two_that_ask_for_the_same_wait_for_one_computation(limit):
    began, go, calls = threading.Event(), threading.Event(), []

    @cached(4, budget=Budget(limit))
    def slow(n: int) -> list[int]:
        calls.append(n)
        began.set()
        assert go.wait(20)
        return [n]

    found: list[list[int]] = []
    threads = [threading.Thread(target=lambda: found.append(slow(1))) for _ in range(2)]
    threads[0].start()
    assert began.wait(20)
    (making,) = slow._making.values()
    making.done = Noted()
    threads[1].start()
    assert making.done.waited.wait(20)
    go.set()
    for thread in threads:
        thread.join(20)
    assert calls == [1]
    assert found[0] is found[1]


def test_others_are_not_held_up_by_a_long_computation():
    began, go = threading.Event(), threading.Event()

    @cached(4, budget=Budget(MEGABYTE))
    def made(n: int) -> int:
        if n == 1:
            began.set()
            assert go.wait(20)
        return n

    thread = threading.Thread(target=made, args=(1,))
    thread.start()
    assert began.wait(20)
    assert made(2) == 2
    go.set()
    thread.join(20)
    assert made.usage.entries == 2


def test_who_has_waited_for_a_computation_that_failed_makes_it_anew():
    began, go, calls = threading.Event(), threading.Event(), []

    @cached(4, budget=Budget(MEGABYTE))
    def fails_once(n: int) -> int:
        calls.append(n)
        if len(calls) == 1:
            began.set()
            assert go.wait(20)
            raise ValueError
        return n

    def first() -> None:
        with pytest.raises(ValueError):  # noqa: PT011 - it has no words
            fails_once(1)

    found: list[int] = []
    threads = [threading.Thread(target=first), threading.Thread(target=lambda: found.append(fails_once(1)))]
    threads[0].start()
    assert began.wait(20)
    threads[1].start()
    go.set()
    for thread in threads:
        thread.join(20)
    assert (found, calls) == ([1], [1, 1])


def test_a_function_may_ask_for_itself():
    @cached(9, budget=Budget(MEGABYTE))
    def factorial(n: int) -> int:
        return 1 if n < 2 else n * factorial(n - 1)

    assert factorial(6) == 720


def test_many_threads_leave_the_sum_right():
    budget = Budget(2 * MEGABYTE)
    made = cached(8, budget=budget)(lambda n: np.full(5_000, n))

    def ask(seed: int) -> None:
        for n in np.random.default_rng(seed).integers(0, 20, 300):
            assert made(int(n))[0] == n

    threads = [threading.Thread(target=ask, args=(seed,)) for seed in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(30)
    assert budget.bytes == made.usage.bytes
    made.cache_clear()
    assert budget.bytes == 0
