"""A Ray cluster of two nodes on this machine, for tests."""

from __future__ import annotations

import contextlib
import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import psutil

ROOT = Path(__file__).parents[2]


@dataclass
class Cluster:
    """Its address, and the processes of its second node."""

    address: str
    second: list[int]

    def lose_second_node(self) -> None:
        """Kill the second node at once, with all that works on it."""
        for pid in self.second:
            with contextlib.suppress(psutil.NoSuchProcess):
                psutil.Process(pid).kill()


@contextlib.contextmanager
def two_nodes() -> Iterator[Cluster]:
    """A head and a second node of one processor each."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"127.0.0.1:{free.getsockname()[1]}"
    before = _of_ray()
    try:
        _start("--head", "--port", address.rpartition(":")[2], "--include-dashboard=false")
        head = _of_ray()
        _start("--address", address)
        yield Cluster(address, sorted(_of_ray() - head))
    finally:
        for pid in _of_ray() - before:
            with contextlib.suppress(psutil.NoSuchProcess):
                psutil.Process(pid).kill()


def _start(*words: str) -> None:
    common = ["start", *words, "--num-cpus=1", "--disable-usage-stats"]
    # Workers import the functions of the tests from the project's root.
    path = os.pathsep.join([str(ROOT), *filter(None, [os.environ.get("PYTHONPATH")])])
    environment = {**os.environ, "PYTHONPATH": path}
    subprocess.run(
        [sys.executable, "-m", "ray.scripts.scripts", *common], check=True, env=environment, capture_output=True
    )


def _of_ray() -> set[int]:
    """All processes of Ray on this machine."""
    found = set()
    for process in psutil.process_iter(["cmdline", "name"]):
        line = " ".join(process.info["cmdline"] or [])
        if "/ray/" in line or (process.info["name"] or "").startswith("ray::"):
            found.add(process.pid)
    return found - {os.getpid()}
