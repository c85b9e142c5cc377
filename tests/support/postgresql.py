"""A PostgreSQL server of the distribution's packages, for tests: in a folder of its own, on a free port."""

from __future__ import annotations

import contextlib
import os
import shutil
import socket
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

import psutil

_USER = "postgres"


def programs() -> Path | None:
    """The folder of the newest server's programs; None where none is installed."""
    found = sorted(Path("/usr/lib/postgresql").glob("*/bin/pg_ctl"), key=lambda path: int(path.parts[-3]))
    return found[-1].parent if found else None


@contextlib.contextmanager
def server() -> Iterator[str]:
    """The address of an empty database; the server is stopped and its files are removed at the end."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    folder = Path(tempfile.mkdtemp(prefix="laplace_postgresql_"))
    data = folder / "data"
    try:
        if os.geteuid() == 0:  # the server refuses to run as root
            shutil.chown(folder, _USER)
        _run("initdb", "--pgdata", str(data), "--auth", "trust", "--username", _USER, "--no-sync")
        options = f"-p {port} -k {folder} -c listen_addresses=127.0.0.1 -c fsync=off"
        _run("pg_ctl", "--pgdata", str(data), "--wait", "--timeout", "300", "--log", str(folder / "log"), "-o", options,
             "start")  # fmt: skip
        try:
            yield f"postgresql://{_USER}@127.0.0.1:{port}/postgres"
        finally:
            number = int((data / "postmaster.pid").read_text().split()[0])
            _run("pg_ctl", "--pgdata", str(data), "--mode", "immediate", "stop")
            with contextlib.suppress(psutil.NoSuchProcess):
                psutil.Process(number).wait(60)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _run(program: str, *words: str) -> None:
    folder = programs()
    assert folder is not None
    user = _USER if os.geteuid() == 0 else None
    # Its own output goes nowhere: a server that inherits a pipe would keep it open.
    subprocess.run(
        [str(folder / program), *words], check=True, user=user, cwd="/", stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )  # fmt: skip
