"""Runs of the page of training: how soon one is gone after Cancel, and what a look at long metrics costs."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from bench.report import Figure, Goal
from bench.timing import spread
from laplace_core.supervise import read_process
from laplace_core.training.curves import Reader
from laplace_core.training.defaults import settings_of
from laplace_core.training.progress import read_progress
from laplace_core.training.queue import Queue

SUBJECT = "Runs"
_EPISODES = 60_000


def figures() -> Iterator[Figure]:
    with TemporaryDirectory() as folder:
        yield _cancel(Queue(Path(folder) / "runs"), times=5)
        yield from _looks(Path(folder) / "metrics.jsonl", times=7)


def _cancel(queue: Queue, times: int) -> Figure:
    """From the request to a process that is gone, at moments of no particular kind."""
    name, seconds = queue.add(settings_of("laplace", "CartPole-v1", {})), []
    for turn in range(times):
        queue.resume(name)
        before = read_progress(queue.folder / name)
        while (note := read_progress(queue.folder / name)) is None or note == before:
            time.sleep(0.05)
        time.sleep(0.3 * turn)
        process, started = read_process(queue.folder / name), perf_counter()
        queue.stop(name)
        seconds.append(perf_counter() - started)
        assert not process.alive
    return Figure(
        SUBJECT, "from Cancel to the end of the process", spread(seconds), "s", "Laplace DQN, CartPole", Goal("<=", 2),
        "its resume point is written meanwhile",
    )  # fmt: skip


def _looks(path: Path, times: int) -> Iterator[Figure]:
    line = {"event": "Episode", "head": 14, "episode_return": 123.0, "length": 123, "truncated": False, "epsilon": 0.04,
            "loss": 0.0123456789, "seconds": 123.456}  # fmt: skip
    path.write_text("".join(json.dumps(line | {"step": 8 * i, "episode": i}) + "\n" for i in range(_EPISODES)))
    whole, nothing = [], []
    for _ in range(times):
        reader, started = Reader(path), perf_counter()
        reader.look()
        while reader.behind:
            reader.look()
        whole.append(perf_counter() - started)
        started = perf_counter()
        reader.look()
        nothing.append(1e3 * (perf_counter() - started))
    sizes = f"{_EPISODES:,} episodes, {path.stat().st_size / 1e6:.1f} MB"
    yield Figure(SUBJECT, "all metrics of a long run as curves", spread(whole), "s", sizes)
    yield Figure(SUBJECT, "the next look, nothing new", spread(nothing), "ms", sizes)
