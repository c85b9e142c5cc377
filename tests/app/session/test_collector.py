"""What an answer costs besides its own work: no full collection, no threads that wait for each other."""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import tomllib
from pathlib import Path

from app.session import collector

ROOT = Path(__file__).resolve().parents[3]
# What the server has done before it first runs the script, then the script's first lines.
_BEFORE_NUMPY = """
import os, sys, streamlit.web.bootstrap, streamlit.web.server
assert "numpy" not in sys.modules
class Watch:
    def find_spec(self, name, path=None, target=None):
        if name == "numpy":
            print(os.environ.get("OPENBLAS_NUM_THREADS"), os.environ.get("OMP_NUM_THREADS"))
            os._exit(0)
sys.meta_path.insert(0, Watch())
exec(compile(open("app/main.py").read(), "app/main.py", "exec"), {"__name__": "__main__", "__file__": "app/main.py"})
"""


def test_one_thread_is_set_before_numpy_is_imported(subtests):
    for given, expected in [({}, "1 1"), ({"OPENBLAS_NUM_THREADS": "3"}, "3 1")]:
        with subtests.test(given=given):
            free = {name: value for name, value in os.environ.items() if not name.endswith("_NUM_THREADS")}
            done = subprocess.run(
                [sys.executable, "-c", _BEFORE_NUMPY], cwd=ROOT, env=free | given, capture_output=True, text=True
            )
            assert done.stdout.strip() == expected, done.stderr


def test_no_collection_is_forced_after_an_answer():
    assert tomllib.loads((ROOT / ".streamlit" / "config.toml").read_text())["runner"] == {"postScriptGC": False}


def test_what_a_page_has_loaded_is_collected_no_more_and_other_garbage_is():
    class Node:
        pass

    stays = Node()
    stays.itself = stays
    try:
        collector.settle("a page of this test")
        assert gc.get_freeze_count() > 1000
        assert not any(each is stays for each in gc.get_objects())
        count = gc.get_freeze_count()
        collector.settle("a page of this test")  # once a page
        assert gc.get_freeze_count() <= count
        lost = Node()
        lost.itself = lost
        del lost
        assert gc.collect() >= 1
    finally:
        gc.unfreeze()
