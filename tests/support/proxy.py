"""Reverse proxies in front of a server of the app: a tiny one, and nginx with the file that the documents show."""

from __future__ import annotations

import contextlib
import re
import shutil
import socket
import subprocess
import tempfile
import threading
import time
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NGINX_CONF = ROOT / "docs" / "hosting" / "nginx.conf"
PREFIX = "/laplace"
_HEAD = 65_536  # bytes of the head of a request
_PATIENCE = 60.0  # seconds until a proxy that does not answer has failed


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


@contextlib.contextmanager
def tiny(upstream: int) -> Iterator[tuple[int, list[str]]]:
    """Passes requests below :data:`PREFIX` on as they are and refuses all others with 404.

    Each connection carries one request, or one WebSocket until it ends.

    Yields:
        Its port, and the paths that it has refused.
    """
    refused: list[str] = []
    listener = socket.create_server(("127.0.0.1", 0))

    def accept() -> None:
        while True:
            try:
                client, _ = listener.accept()
            except OSError:  # closed: the test is over
                return
            threading.Thread(target=_serve, args=(client, upstream, refused), daemon=True).start()

    threading.Thread(target=accept, daemon=True).start()
    try:
        yield listener.getsockname()[1], refused
    finally:
        listener.shutdown(socket.SHUT_RDWR)
        listener.close()


def _serve(client: socket.socket, upstream: int, refused: list[str]) -> None:
    with client, contextlib.suppress(OSError):  # a browser closes what it needs no more
        received = b""
        while b"\r\n\r\n" not in received:
            more = client.recv(_HEAD)
            if not more or len(received) > _HEAD:
                return
            received += more
        head, body = received.split(b"\r\n\r\n", 1)
        path = head.split(b" ", 2)[1].decode()
        if path == PREFIX:
            client.sendall(f"HTTP/1.1 301 Moved\r\nLocation: {PREFIX}/\r\nConnection: close\r\n\r\n".encode())
            return
        if not path.startswith(f"{PREFIX}/"):
            refused.append(path)
            client.sendall(b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\nConnection: close\r\n\r\n")
            return
        if b"\nupgrade: websocket" not in head.lower():
            head = re.sub(rb"(?im)^connection:.*?$", b"Connection: close", head)
        with socket.create_connection(("127.0.0.1", upstream)) as server:
            server.sendall(head + b"\r\n\r\n" + body)
            threading.Thread(target=_pass_on, args=(client, server), daemon=True).start()
            _pass_on(server, client)


def _pass_on(source: socket.socket, target: socket.socket) -> None:
    """Bytes from one end to the other, until either is closed."""
    with contextlib.suppress(OSError):
        while received := source.recv(_HEAD):
            target.sendall(received)
        target.shutdown(socket.SHUT_WR)


@contextlib.contextmanager
def nginx(upstream: int) -> Iterator[tuple[int, list[str]]]:
    """nginx with ``docs/hosting/nginx.conf``, in which only the two ports are others.

    Yields:
        Its port, and the paths that it has answered with 404, which are known once it has ended.
    """
    port, refused = free_port(), []
    shown = NGINX_CONF.read_text(encoding="utf-8")
    assert "listen 80;" in shown
    assert "127.0.0.1:8501;" in shown
    shown = shown.replace("listen 80;", f"listen 127.0.0.1:{port};").replace(
        "127.0.0.1:8501;", f"127.0.0.1:{upstream};"
    )
    with tempfile.TemporaryDirectory(prefix="laplace_nginx_") as name:
        folder = Path(name)
        folder.chmod(0o755)
        places = ("client_body", "proxy", "fastcgi", "uwsgi", "scgi")
        paths = "\n".join(f"{place}_temp_path {folder}/{place};" for place in places)
        access = f"access_log {folder}/access.log;\n"
        (folder / "nginx.conf").write_text(
            f"worker_processes 1;\npid {folder}/pid;\nevents {{}}\nhttp {{\n{access}{paths}\n{shown}}}\n"
        )
        command = [shutil.which("nginx") or "nginx", "-e", f"{folder}/error.log", "-c", f"{folder}/nginx.conf"]
        process = subprocess.Popen([*command, "-p", name, "-g", "daemon off;"])
        try:
            _listening(port, process)
            yield port, refused
        finally:
            process.terminate()
            process.wait()
            log = (folder / "access.log").read_text() if (folder / "access.log").exists() else ""
            refused += re.findall(r'"\w+ (\S+) HTTP/[\d.]+" 404 ', log)


def _listening(port: int, process: subprocess.Popen[bytes]) -> None:
    """Wait until something listens on a port.

    Raises:
        RuntimeError: its process has ended, or takes too long.
    """
    end = time.monotonic() + _PATIENCE
    while process.poll() is None and time.monotonic() < end:
        with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port)):
            return
        time.sleep(0.05)
    raise RuntimeError("the proxy did not start")
