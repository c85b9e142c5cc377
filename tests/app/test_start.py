"""``make app``: the address is said once, and a browser opens when the workbench answers."""

from __future__ import annotations

import os
import re
import socket
import stat
import subprocess
import sys
import threading
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PATIENCE = 120.0  # seconds until a browser that has not opened is a failure

BROWSER = f"""#!{sys.executable}
import sys, urllib.request
answer = urllib.request.urlopen(sys.argv[1]).status
open({{answers!r}}, "w").write(f"{{{{sys.argv[1]}}}} {{{{answer}}}}")
"""
"""What opens addresses on Linux: this one writes whether anybody answers there, into a pipe that the test reads."""


def recipe(target: str) -> str:
    """The lines of a target of the Makefile, as the shell gets them."""
    text = (ROOT / "Makefile").read_text(encoding="utf-8").replace("\\\n", "")
    (lines,) = re.findall(rf"^{target}:.*\n((?:\t.*\n)+)", text, re.M)
    return "\n".join(line.lstrip("\t@") for line in lines.splitlines())


def test_the_address_is_said_once_and_a_browser_opens_when_it_answers(tmp_path):
    answers = tmp_path / "answers"
    os.mkfifo(answers)
    browser = tmp_path / "xdg-open"
    browser.write_text(BROWSER.format(answers=str(answers)))
    browser.chmod(browser.stat().st_mode | stat.S_IXUSR)
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    values = {"BIN": str(Path(sys.executable).parent), "ADDRESS": "localhost", "PORT": str(port)}
    script = re.sub(r"\$\((\w+)\)", lambda name: values[name[1]], recipe("app"))
    environment = {**os.environ, "DISPLAY": ":0", "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"}
    opened: list[str] = []
    listener = threading.Thread(target=lambda: opened.append(answers.read_text()), daemon=True)
    listener.start()
    server = subprocess.Popen(
        ["sh", "-c", script.replace(values["BIN"], f"exec {values['BIN']}")], cwd=ROOT, env=environment,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    try:
        listener.join(PATIENCE)
    finally:
        server.terminate()
        said, _ = server.communicate()
    assert opened == [f"http://localhost:{port} 200"]
    assert said.count(str(port)) == 1
    assert said.splitlines()[0] == (
        f"The workbench: http://localhost:{port} (a browser opens as soon as it is ready; Ctrl-C ends it)"
    )
