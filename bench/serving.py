"""A server of the app under a limit of memory, of this tree or of an older commit."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import psutil

ROOT = Path(__file__).resolve().parents[1]
_GROUPS = Path("/sys/fs/cgroup/memory")  # of the first version; the second has one tree for all
_LOOK = 0.1  # seconds between two looks at the memory


@dataclass(eq=False)
class Server:
    """A running server.

    Attributes:
        limited: in words, what holds it to its memory.
        peak: the largest memory seen, of it and of all that it has started, in MB.
    """

    address: str
    process: subprocess.Popen[bytes]
    log_file: Path
    limited: str = "no limit of memory"
    peak: float = 0.0
    _over: threading.Event = field(default_factory=threading.Event)

    @property
    def alive(self) -> bool:
        return self.process.poll() is None

    @property
    def memory(self) -> float:
        """Resident memory in MB, of it and of all that it has started; 0 once it is gone."""
        return sum(member.memory_info().rss for member in self._family()) / 2**20

    @property
    def spent(self) -> float:
        """Seconds of processor time of the server itself, whatever else the machine does."""
        return sum(psutil.Process(self.process.pid).cpu_times()[:2])

    @property
    def log(self) -> str:
        return self.log_file.read_text(errors="replace")

    def _family(self) -> list[psutil.Process]:
        with contextlib.suppress(psutil.NoSuchProcess):
            server = psutil.Process(self.process.pid)
            return [each for each in (server, *server.children(recursive=True)) if each.is_running()]
        return []

    def watch(self, limit: float | None) -> None:
        """Note the memory until the server ends; kill it above ``limit`` MB."""
        while not self._over.wait(_LOOK):
            with contextlib.suppress(psutil.Error):
                memory = self.memory
                self.peak = max(self.peak, memory)
                if limit is not None and memory > limit:
                    self.process.send_signal(signal.SIGKILL)


@contextlib.contextmanager
def serving(tree: Path, megabytes: int | None) -> Iterator[Server]:
    """Start the app of a tree, held to so much memory: by a control group where one can be made, else by a watch.

    Raises:
        RuntimeError: it does not start.
    """
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = [sys.executable, "-m", "streamlit", "run", "app/main.py", "--server.port", str(port)]
    command += ["--server.address", "127.0.0.1", "--server.headless", "true", "--server.fileWatcherType", "none"]
    with contextlib.ExitStack() as stack:
        runs = Path(
            stack.enter_context(tempfile.TemporaryDirectory(prefix="laplace_hold_", ignore_cleanup_errors=True))
        )
        variables = os.environ | {"LAPLACE_RUNS": str(runs / "runs"), "PYTHONPATH": str(tree)}
        with open(runs / "log", "wb") as log:
            process = subprocess.Popen(command, cwd=tree, env=variables, stdout=log, stderr=subprocess.STDOUT)
        server = Server(f"http://127.0.0.1:{port}", process, runs / "log")
        group = None if megabytes is None else _grouped(process.pid, megabytes)
        if megabytes is not None:
            server.limited = f"{megabytes} MB by a {'control group' if group else 'watch that kills above it'}"
        watching = threading.Thread(target=server.watch, args=(None if group else megabytes,), daemon=True)
        watching.start()
        try:
            _wait(server)
            yield server
        finally:
            server._over.set()
            watching.join()
            for member in reversed(server._family()):
                with contextlib.suppress(psutil.NoSuchProcess):
                    member.kill()
            process.wait()
            if group is not None:
                _remove(group)


def _wait(server: Server) -> None:
    for _ in range(600):
        if not server.alive:
            break
        with contextlib.suppress(OSError), urllib.request.urlopen(f"{server.address}/_stcore/health"):
            return
        time.sleep(0.1)
    raise RuntimeError(f"the server did not start: {server.log[-500:]}")


def _grouped(pid: int, megabytes: int) -> Path | None:
    """A control group that holds a process and its children to so much memory; None where none can be made."""
    group = _GROUPS / f"laplace_hold_{pid}"
    try:
        group.mkdir()
        (group / "memory.limit_in_bytes").write_text(str(megabytes * 2**20))
        (group / "cgroup.procs").write_text(str(pid))
    except OSError:
        with contextlib.suppress(OSError):
            group.rmdir()
        return None
    return group


def _remove(group: Path) -> None:
    for _ in range(50):
        with contextlib.suppress(OSError):
            group.rmdir()
            return
        time.sleep(0.1)


def tree_of(commit: str, folder: Path) -> Path:
    """The files of a commit, in a folder of their own."""
    folder.mkdir(parents=True)
    packed = subprocess.run(["git", "archive", commit], cwd=ROOT, stdout=subprocess.PIPE, check=True).stdout
    subprocess.run(["tar", "x", "-C", str(folder)], input=packed, check=True)
    return folder
