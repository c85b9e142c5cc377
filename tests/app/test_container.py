"""The Dockerfile without an engine: what it copies is enough, its RUN lines run, and its CMD serves and is healthy."""

from __future__ import annotations

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
                    ignored = shutil.ignore_patterns("__pycache__", "plotly.min.js", "laplace-*.js")
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


def test_the_image_serves_the_app_and_its_chart_library(image):
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = json.loads(next(rest for keyword, rest in instructions() if keyword == "CMD"))
    command = [sys.executable, *command[1:]]
    command = [word.replace("0.0.0.0", "127.0.0.1").replace("8501", str(port)) for word in command]
    server = subprocess.Popen(command, cwd=image, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        for path, kind in (("_stcore/health", "text"), ("app/static/plotly.min.js", "javascript")):
            for _ in range(300):
                with contextlib.suppress(OSError), urllib.request.urlopen(f"http://127.0.0.1:{port}/{path}") as reply:
                    assert reply.status == 200
                    assert kind in reply.headers["content-type"]
                    break
                time.sleep(0.1)
            else:
                pytest.fail(f"{path} was not served")
    finally:
        server.terminate()
        server.wait()
