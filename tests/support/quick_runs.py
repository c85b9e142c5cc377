"""Runs that take no time: a stand-in for the training process, which does what a file in its run folder says."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from laplace_core.agents import LaplaceSettings
from laplace_core.supervise import Process, read_process
from laplace_core.training import queue
from laplace_core.training.queue import Queue

SMALL = LaplaceSettings(
    environment="two_branch", hidden=8, features=4, gammas=4, thetas=7, theta_min=-3, theta_max=13, batch=8, steps=600,
    envs=2, buffer=300, learning_starts=50, evaluate_every=100, evaluate_episodes=2, checkpoint_every=200,
)  # fmt: skip

_CHILD = """
import os, pathlib, signal, sys, time
folder = pathlib.Path(sys.argv[1])
if (folder / "stubborn").exists():
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
(folder / "began").write_text(str(os.getpid()))
end = folder / "end"
for _ in range(9000):  # some three minutes: a test that failed leaves nothing behind
    if end.exists():
        break
    time.sleep(0.02)
word = end.read_text()
end.unlink()
if word == "finish":
    (folder / "last.safetensors").write_bytes(b"")
elif word == "crash":
    raise RuntimeError("the lamp went out")
elif word == "refuse":
    sys.exit("laplace: the buffer is full of sand.")
elif word == "vanish":
    os.kill(os.getpid(), signal.SIGKILL)
"""


def stand_in(monkeypatch) -> None:
    """Let queues start the stand-in."""
    monkeypatch.setattr(queue, "_command", lambda folder, most_bytes: [sys.executable, "-c", _CHILD, str(folder)])


def until(done: Callable[[], object], seconds: float = 240) -> None:
    """Wait for something to happen."""
    limit = time.monotonic() + seconds
    while not done():
        assert time.monotonic() < limit, "it did not happen"
        time.sleep(0.02)


def tell(runs: Queue, name: str, word: str) -> None:
    """Let the stand-in of a run end in one of its ways, and wait until it has."""
    folder: Path = runs.folder / name
    until(lambda: (folder / "began").exists())
    process = read_process(folder)
    (folder / "end.part").write_text(word)
    (folder / "end.part").rename(folder / "end")
    until(lambda: not process.alive)


def states(runs: Queue) -> dict[str, str]:
    """State of every run by its name, the oldest first."""
    return {run.name: run.state for run in sorted(runs.runs(), key=lambda run: run.name)}


def added(runs: Queue, count: int) -> None:
    """Runs of the first seeds, looked at once."""
    for seed in range(count):
        runs.add(replace(SMALL, seed=seed))
    runs.tick()


def process_of(runs: Queue, name: str) -> Process:
    """Of a run whose process has really begun."""
    until(lambda: (runs.folder / name / "began").exists())
    return read_process(runs.folder / name)
