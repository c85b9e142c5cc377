"""Nothing of ours needs what only Unix has: without it every page opens, and runs and learners can be supervised."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

# Packages from elsewhere keep what they use on this system, which they do without on others; ours get nothing of it.
HIDING = """
import builtins, os, sys
HIDDEN = ("fcntl", "resource", "pwd", "grp", "termios")
real = builtins.__import__
OURS = tuple(os.path.join(os.getcwd(), name, "") for name in ("app", "laplace_core"))

def ours(names):  # by the file: Streamlit runs a page under the name __main__
    return str((names or {}).get("__file__")).startswith(OURS)

def hiding(name, globals=None, *rest, **named):
    if name.split(".")[0] in HIDDEN and ours(globals):
        raise ModuleNotFoundError(f"No module named {name!r}", name=name)
    return real(name, globals, *rest, **named)

builtins.__import__ = hiding

class Without(type(os)):
    def __getattribute__(self, name):
        unix = ("getuid", "geteuid", "getgid", "getpgid", "killpg", "setsid", "fork", "O_NOFOLLOW", "O_NONBLOCK")
        if name in unix and ours(sys._getframe(1).f_globals):
            raise AttributeError(f"module 'os' has no attribute {name!r}")
        return super().__getattribute__(name)

os.__class__ = Without
"""

CHECK = """
for code in ("import fcntl", "import resource", "import pwd", "import os; os.getuid()", "import os; os.killpg(0, 0)"):
    try:
        exec(code, {"__file__": os.path.abspath("app/main.py")})
    except (ImportError, AttributeError):
        continue
    raise SystemExit(f"not hidden: {code}")
"""

PAGES = """
import functools
from streamlit.components.v2 import manifest_scanner
from streamlit.testing.v1 import AppTest
scan = manifest_scanner.scan_component_manifests
manifest_scanner.scan_component_manifests = functools.cache(scan)  # as in tests/conftest.py
for screen in sys.argv[1].split(","):
    page = AppTest.from_file("app/main.py", default_timeout=120)
    if screen != "worlds":
        page.switch_page(f"screens/{screen}.py")
    page.run()
    assert not page.exception, (screen, [each.value for each in page.exception])
    assert page.main.children, screen
print("opened")
"""

SUPERVISED = """
import pathlib, time
from laplace_core.supervise import Process, read_process
from laplace_core.training.queue import Queue
from tests.support.quick_runs import SMALL, until
from laplace_core.training.curves import Reader
from laplace_core import load_world
from laplace_core.tabular import LearnSettings, start
from laplace_core.files.folders import temporary
assert temporary("laplace_runs").is_dir()
runs = Queue(sys.argv[1])
name = runs.add(SMALL)
while (process := read_process(runs.folder / name)) is None:
    time.sleep(0.02)
until(lambda: (runs.folder / name / "metrics.jsonl").exists() or runs.get(name).error)
Reader(runs.folder / name / "metrics.jsonl").look()
runs.stop(name)
assert not process.alive
folder = pathlib.Path(sys.argv[1], "learner")
folder.mkdir()
learner = start(load_world("cliff_grid"), LearnSettings(episodes=500_000), folder)
assert not learner.finished
learner.cancel()
assert learner.finished
print("supervised")
"""


def run(code: str, word: str, tmp_path: Path) -> str:
    done = subprocess.run(
        [sys.executable, "-c", HIDING + CHECK + code, word],
        capture_output=True,
        text=True,
        cwd=ROOT,
        env=os.environ | {"LAPLACE_RUNS": str(tmp_path / "runs"), "TMPDIR": str(tmp_path)},
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout.split()[-1]


def test_every_page_opens_without_what_only_unix_has(tmp_path):
    pages = re.findall(r'st\.Page\("screens/(\w+)\.py"', (ROOT / "app" / "main.py").read_text())
    assert set(pages) == {"worlds", "inverse", "agents", "race", "train", "paper", "guide"}
    assert run(PAGES, ",".join(pages), tmp_path) == "opened"


@pytest.mark.long
def test_runs_and_learners_are_supervised_without_what_only_unix_has(tmp_path):
    assert run(SUPERVISED, str(tmp_path / "supervised"), tmp_path) == "supervised"
