"""A copy of the application and the library, in which a recipe of CONTRIBUTING.md is followed to the letter.

Everything then runs in processes of their own that know the copy only: what a recipe forgets is missing there as well.
"""

from __future__ import annotations

import filecmp
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("app", "laplace_core")

_FOLLOWED = """
import contextlib, functools, io, json, shutil, sys
from pathlib import Path
from streamlit.components.v2 import manifest_scanner
from streamlit.testing.v1 import AppTest
import laplace_core
from laplace_core.cli import main

scan = manifest_scanner.scan_component_manifests
manifest_scanner.scan_component_manifests = functools.cache(scan)  # as in tests/conftest.py
assert Path(laplace_core.__file__).is_relative_to(Path.cwd())
commands, copies, asked = json.loads(sys.argv[1])
printed = []
for words in commands:
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        assert main(words) == 0, words
    printed.append(out.getvalue())
for there, here in copies:
    Path(here).parent.mkdir(exist_ok=True)
    shutil.copy(there, here)
shown = []
for screen, query in asked:
    page = AppTest.from_file("app/main.py", default_timeout=120)
    page.switch_page(f"screens/{screen}.py")
    for name, value in query.items():
        page.query_params[name] = value
    page.run()
    while screen != "train" and page.get("progress"):  # an episode or a race under way in the background
        page.run()
    said = [each.value for each in (*page.exception, *page.error, *page.warning)]
    assert not said, (screen, said)
    shown.append({
        "captions": [caption.value for caption in page.caption],
        "options": {box.key: box.options for box in page.selectbox},
        "sliders": [slider.label for slider in page.slider],
        "numbers": {number.key: number.value for number in page.number_input},
        "artefacts": [block.proto.body for block in page.get("html") if 'class="artefact"' in block.proto.body],
        "buttons": [button.label for button in page.button],
        "verdict": [block.proto.body for block in page.get("html") if "race-verdict" in block.proto.body],
        "components": [block.proto.component_name for block in page.get("bidi_component")],
    })
print(json.dumps([printed, shown]))
"""


class Workshop:
    """The copy, in a folder that is empty but for packages of a user's own.

    Attributes:
        runs: where runs are kept that the pages list.
    """

    def __init__(self, folder: Path):
        self.root, self.packages = folder / "project", folder / "packages"
        self.runs = self.root / "runs"
        self.packages.mkdir(parents=True)
        for name in FOLDERS:
            # With what is compiled already: Python compiles again what a recipe changes, by its time and size.
            shutil.copytree(ROOT / name, self.root / name)

    def insert(self, path: str, before: str, text: str) -> None:
        """Put text before the only place in a file that reads ``before``."""
        whole = (self.root / path).read_text(encoding="utf-8")
        assert whole.count(before) == 1, f"{path} has {whole.count(before)} places {before!r}"
        (self.root / path).write_text(whole.replace(before, text + before), encoding="utf-8")

    def touched(self) -> list[str]:
        """Files that are new or differ from those of the project."""
        mine = [path for folder in FOLDERS for path in (self.root / folder).rglob("*") if path.is_file()]
        names = sorted(path.relative_to(self.root).as_posix() for path in mine if "__pycache__" not in path.parts)
        return [
            name for name in names
            if not (ROOT / name).is_file() or not filecmp.cmp(ROOT / name, self.root / name, shallow=False)
        ]  # fmt: skip

    def follow(
        self,
        *commands: tuple[str, ...],
        pages: Sequence[tuple[str, dict[str, str]]],
        copies: Sequence[tuple[str, str]] = (),
    ) -> tuple[list[str], list[dict[str, Any]]]:
        """Run commands, copy files, open pages: in this order, in one process that knows the copy only.

        Args:
            commands: words after ``laplace`` of each; one that fails ends the test.
            pages: screen and link of each.
            copies: from and to, within the copy of the project.

        Returns:
            What each command prints, and what each page shows.
        """
        known = {"PYTHONPATH": f"{self.root}{os.pathsep}{self.packages}", "LAPLACE_RUNS": str(self.runs)}
        done = subprocess.run(
            [sys.executable, "-c", _FOLLOWED, json.dumps([commands, copies, pages])], cwd=self.root,
            env=os.environ | known, capture_output=True, text=True, timeout=300, check=False,
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        printed, shown = json.loads(done.stdout)
        return printed, shown
