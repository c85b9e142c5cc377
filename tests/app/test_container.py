"""The container without an engine: what the Dockerfile copies is enough, its RUN lines run, and its CMD serves below a
path, is healthy, and writes nothing but in /tmp and the volume; compose.yaml sets every limit."""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import re
import shutil
import socket
import stat
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest

from bench.visitor import visit
from laplace_core.supervise.limits import ENVIRONMENTS, Limits

ROOT = Path(__file__).resolve().parents[2]


def instructions() -> list[tuple[str, str]]:
    """(KEYWORD, rest) of every instruction, continuation lines joined."""
    lines = (ROOT / "Dockerfile").read_text().replace("\\\n", " ").splitlines()
    return [tuple(line.strip().split(" ", 1)) for line in lines if line.strip() and not line.startswith("#")]


@pytest.fixture(scope="module")
def image(tmp_path_factory) -> Path:
    """A clean folder with just what COPY brings, after every RUN line, in order."""
    folder = tmp_path_factory.mktemp("image")
    environment = {**os.environ, "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}", "TORCH_INDEX": ""}
    environment.pop("PYTHONPATH", None)
    for keyword, rest in instructions():
        if keyword == "COPY":
            *sources, target = rest.split()
            for source in sources:
                if (ROOT / source).is_dir():
                    ignored = shutil.ignore_patterns("__pycache__", "plotly.min.js", "laplace-*.js", "_build")
                    shutil.copytree(ROOT / source, folder / target, ignore=ignored)
                else:
                    shutil.copy(ROOT / source, folder / target)
        if keyword == "RUN":
            rest = rest.replace("/srv/runs", str(folder / "runs"))
            done = subprocess.run(rest, shell=True, cwd=folder, env=environment, capture_output=True, text=True)
            assert done.returncode == 0, f"RUN {rest}: {done.stderr[-2000:]}"
    return folder


def test_it_runs_as_nobody_in_particular():
    last = [rest for keyword, rest in instructions() if keyword == "USER"][-1]
    assert int(last.split(":")[0]) > 0


def test_the_base_is_one_image_and_no_other():
    keyword, base = instructions()[0]
    assert keyword == "FROM"
    assert re.fullmatch(r"python:3\.11\.\d+-slim-bookworm@sha256:[0-9a-f]{64}", base)


@pytest.mark.long
def test_runs_lie_in_a_volume_that_whoever_runs_it_may_write(image):
    told = dict(instructions())
    assert told["VOLUME"] == "/srv/runs"
    assert "LAPLACE_RUNS=/srv/runs" in told["ENV"]
    assert stat.S_IMODE((image / "runs").stat().st_mode) == 0o1777


def test_the_health_check_is_python_and_asks_streamlit():
    check = next(rest for keyword, rest in instructions() if keyword == "HEALTHCHECK")
    command = json.loads(check[check.index("[") :])
    assert command[0] == "python"
    compile(command[2], "health check", "exec")
    assert "/_stcore/health" in command[2]


def test_no_usage_statistics_are_sent():
    assert "gatherUsageStats = false" in (ROOT / ".streamlit" / "config.toml").read_text()


def command_of(keyword: str, port: int) -> list[str]:
    """The words of CMD or HEALTHCHECK, for this Python and another port."""
    rest = next(rest for each, rest in instructions() if each == keyword)
    _, *words = json.loads(rest[rest.index("[") :])
    words = [word.replace("0.0.0.0", "127.0.0.1").replace("8501", str(port)) for word in words]
    return [sys.executable, *words]


def read_only(folder: Path, command: list[str]) -> list[str]:
    """The command with ``folder`` mounted read-only, where this user may mount."""
    alone = ["unshare", "--mount", "--map-root-user"]
    if shutil.which("unshare") is None or subprocess.run([*alone, "true"], capture_output=True).returncode:
        return command
    mount = 'mount --bind "$1" "$1" && mount -o remount,bind,ro "$1" && cd "$1" && ! touch new && shift && exec "$@"'
    return [*alone, "sh", "-c", f"{mount} 2>/dev/null", "sh", str(folder), *command]


def files(folder: Path) -> dict[Path, int]:
    return {path: path.stat().st_mtime_ns for path in folder.rglob("*")}


@pytest.mark.parametrize("path", ["/laplace", pytest.param("", marks=pytest.mark.long)])
def test_the_image_serves_a_page_and_its_files_is_healthy_and_writes_nothing(image, tmp_path, path):
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    environment = os.environ | {"LAPLACE_RUNS": str(tmp_path / "runs"), "PYTHONDONTWRITEBYTECODE": "1"}
    environment = environment | {"HOME": str(tmp_path), "STREAMLIT_SERVER_BASE_URL_PATH": path}
    environment.pop("PYTHONPATH", None)
    before, address = files(image), f"http://127.0.0.1:{port}{path}"
    server = subprocess.Popen(
        read_only(image, command_of("CMD", port)), cwd=image, env=environment,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    try:
        for file, kind in (("_stcore/health", "text"), ("app/static/plotly.min.js", "javascript")):
            for _ in range(300):
                with contextlib.suppress(OSError), urllib.request.urlopen(f"{address}/{file}") as reply:
                    assert reply.status == 200
                    assert kind in reply.headers["content-type"]
                    break
                time.sleep(0.1)
            else:
                pytest.fail(f"{file} was not served")
        assert subprocess.run(command_of("HEALTHCHECK", port), env=environment, check=False).returncode == 0

        async def look() -> None:
            async with visit(address) as visitor:
                await visitor.open("worlds", "world=two_branch&normalise=paper")
                assert visitor.component("laplace_lens")

        asyncio.run(look())
    finally:
        server.terminate()
        server.wait()
    assert files(image) == before


def test_a_container_that_does_not_answer_is_not_healthy():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        command = command_of("HEALTHCHECK", probe.getsockname()[1])
    assert subprocess.run(command, capture_output=True, check=False).returncode != 0


COMPOSE = (ROOT / "compose.yaml").read_text(encoding="utf-8")


def test_compose_hands_every_limit_over_and_the_document_lists_every_variable():
    handed = set(re.findall(r"^      - (\w+)$", COMPOSE, re.M))
    assert handed == {f"LAPLACE_{name.upper()}" for name in Limits.__dataclass_fields__} | {
        ENVIRONMENTS,
        "STREAMLIT_SERVER_BASE_URL_PATH",
    }
    listed = re.findall(r"^\| `(\w+)` \|", (ROOT / "docs" / "server.md").read_text(encoding="utf-8"), re.M)
    assert handed | set(re.findall(r"\$\{(\w+):-", COMPOSE)) <= set(listed)


def test_compose_keeps_runs_in_the_volume_of_the_image_and_all_else_read_only():
    assert re.findall(r"volumes: (.*)", COMPOSE)[0] == f'["runs:{dict(instructions())["VOLUME"]}"]'
    assert "read_only: true" in COMPOSE
