"""Pictures of the documents, by the workbench itself: ``python -m bench.gallery [NAME ...]`` makes ``docs/gallery``.

Each picture is a view of the app in a headless Chromium, opened by its link. ``docs/gallery.md`` shows all of them.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from tests.browser.support import DRAWN, FLAGS, MAIN, PATIENCE, ROOT, WATCH, find_chromium, served, settled

if TYPE_CHECKING:
    from playwright.sync_api import Browser

FOLDER = ROOT / "docs" / "gallery"
LENS = DRAWN
INVERSE = "() => document.querySelector('.laplace-inverse')?.inverse?.scene?.made"
AGENT = "() => document.querySelector('.laplace-player canvas') && document.querySelector('canvas.tau-space')"
RACE = "() => document.querySelector('.laplace-track canvas')"
GUIDE = "() => document.querySelector('.katex') && document.querySelector('pre code')?.textContent"
CHART = "() => document.querySelector('.main-svg')"


@dataclass(frozen=True)
class View:
    """A view of the app.

    Attributes:
        link: its address, after that of the server.
        drawn: what becomes true in the browser once it is drawn.
        press: buttons pressed before that, by their labels.
        dark: in the dark theme.
        size: width and height of the window, in pixels.
    """

    link: str
    drawn: str
    press: tuple[str, ...] = ()
    dark: bool = False
    size: tuple[int, int] = (1440, 900)


VIEWS = {
    "worlds": View("", LENS),
    "repaired": View("?world=two_branch&normalise=none&alpha=0.2", LENS),
    "mixed_policies": View("?world=two_decisions&policy=per_gamma&alpha=0.02", LENS, dark=True),
    "own_world": View("?world=double_chain&alpha=0.01", LENS),
    "inverse": View("inverse?world=fig6_chain&noise=0.001", INVERSE),
    "agents": View(
        "agents?checkpoint=laplace_LunarLander-v3&r.rule=fading&r.horizon=60&r.seed=3", AGENT, ("Roll out",)
    ),
    "race": View("race?d.T=50", RACE),
    "train": View("train", CHART),
    "paper": View("paper", CHART),
    "guide": View("guide?page=concepts", GUIDE),
    "phone": View("", LENS, size=(390, 844)),
}
_TRAINED = "runs/laplace_two_branch_0"
_TRAINING = ("train", "laplace", "two_branch", "--steps", "4000", "--evaluate-every", "500")


def photographed(browser: Browser, address: str, view: View) -> bytes:
    """A picture of a view that has come to rest, as PNG."""
    width, height = view.size
    context = browser.new_context(
        viewport={"width": width, "height": height}, color_scheme="dark" if view.dark else "light"
    )
    context.set_default_timeout(PATIENCE)
    context.add_init_script(WATCH)
    try:
        page = context.new_page()
        page.goto(f"{address}/{view.link}")
        for label in view.press:
            page.get_by_role("button", name=label, exact=True).first.click()
        page.wait_for_function(view.drawn)
        settled(page)
        return page.screenshot(animations="disabled")
    finally:
        context.close()


def make(names: Sequence[str], folder: Path) -> None:
    """Make pictures of these views."""
    from playwright.sync_api import sync_playwright

    folder.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="laplace_gallery_") as kept:
        if "train" in names:  # the page of training shows a run of this machine
            command = [sys.executable, "-m", "laplace_core", *_TRAINING, "--run", _TRAINED]
            subprocess.run(
                command, cwd=kept, check=True, capture_output=True, env=os.environ | {"PYTHONPATH": str(ROOT)}
            )
        variables = {"LAPLACE_RUNS": str(Path(kept) / "runs")}
        with served(MAIN, variables=variables) as (address, _), sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=find_chromium(), args=FLAGS)
            for name in names:
                path = folder / f"{name}.png"
                path.write_bytes(photographed(browser, address, VIEWS[name]))
                print(f"{path.relative_to(folder.parent)}: {path.stat().st_size / 1000:.0f} kB", flush=True)
            browser.close()


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m bench.gallery", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"one of {', '.join(VIEWS)} (default: all)")
    names = parser.parse_args().names or list(VIEWS)
    unknown = [name for name in names if name not in VIEWS]
    if unknown:
        parser.error(f"{unknown[0]!r} is no picture: choose from {', '.join(VIEWS)}.")
    make(names, FOLDER)


if __name__ == "__main__":
    main()
