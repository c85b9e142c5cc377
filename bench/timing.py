"""Repeated measurements whose competitors take turns, and their median with quartiles."""

from __future__ import annotations

import gc
from collections.abc import Callable, Mapping, Sequence
from time import perf_counter
from typing import NamedTuple

import numpy as np


class Spread(NamedTuple):
    """Median and quartiles of ``samples`` measurements."""

    median: float
    low: float
    high: float
    samples: int


def spread(values: Sequence[float] | np.ndarray) -> Spread:
    low, median, high = np.percentile(values, [25, 50, 75])
    return Spread(float(median), float(low), float(high), len(values))


def interleaved(tasks: Mapping[str, tuple[Callable[[], object], int]], rounds: int) -> dict[str, np.ndarray]:
    """Seconds a call of every task, one value a round, shape ``(rounds,)`` each.

    Every round runs every task, and every second round in reverse order, so that a drift of the machine
    meets all of them alike: divide two tasks round by round, never their totals.

    Args:
        tasks: name -> (function, calls a round). Each is called once beforehand, unmeasured.
    """
    for function, _ in tasks.values():
        function()
    seconds = {name: np.empty(rounds) for name in tasks}
    collecting = gc.isenabled()
    gc.disable()
    try:
        for turn in range(rounds):
            for name in list(tasks)[:: 1 if turn % 2 == 0 else -1]:
                function, calls = tasks[name]
                started = perf_counter()
                for _ in range(calls):
                    function()
                seconds[name][turn] = (perf_counter() - started) / calls
    finally:
        if collecting:
            gc.enable()
    return seconds
