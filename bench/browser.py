"""What a person waits for, in a headless Chromium: the first picture, and the new one after a slider's release.

Both are measured on the workbench and on a bare Streamlit app with one heatmap, in turns, on warm servers. The
clock runs in the page: from the key press that moves a slider to the frame after the last change of any
picture or of the verdict.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import socket
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.request
from pathlib import Path
from typing import IO

ROOT = Path(__file__).resolve().parent.parent
CHROMIUM = ("chromium", "chromium-browser", "google-chrome")
FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update"]

# Resolves with the milliseconds until the last change of a picture or of the verdict; they must then have rested
# for `quiet` ms, which are not counted.
_SETTLED = """
(quiet) => new Promise((done) => {
  const pictures = '.js-plotly-plot, .verdict, [data-testid="stPlotlyChart"]';
  const start = performance.now();
  let last = start;
  const seen = new MutationObserver((changes) => {
    if (changes.some(({ target }) => (target.closest ? target : target.parentElement)?.closest(pictures))) {
      last = performance.now();
    }
  });
  seen.observe(document.body, { subtree: true, childList: true, attributes: true, characterData: true });
  const tick = () => {
    if (performance.now() - last > quiet && last > start) { seen.disconnect(); done(last - start); }
    else requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
})
"""
_DRAWN = "() => document.querySelectorAll('.js-plotly-plot .main-svg').length >= %d"


@contextlib.contextmanager
def served(script: Path, log: IO[str] | None = None):
    """A Streamlit server on a free port of this machine; yields its address and its process.

    What it says goes to ``log``, or nowhere.
    """
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = [sys.executable, "-m", "streamlit", "run", str(script), "--server.port", str(port)]
    command += ["--server.address", "127.0.0.1", "--server.headless", "true", "--server.fileWatcherType", "none"]
    runs = tempfile.TemporaryDirectory(prefix="laplace_runs_", ignore_cleanup_errors=True)  # never somebody's own
    process = subprocess.Popen(
        command, cwd=ROOT, stdout=log or subprocess.DEVNULL, stderr=log or subprocess.DEVNULL,
        env=os.environ | {"LAPLACE_RUNS": runs.name},
    )  # fmt: skip
    try:
        for _ in range(300):
            with (
                contextlib.suppress(OSError),
                urllib.request.urlopen(f"http://127.0.0.1:{port}/_stcore/health") as reply,
            ):
                if reply.status == 200:
                    break
            time.sleep(0.1)
        else:
            raise RuntimeError(f"{script.name} did not start")
        yield f"http://127.0.0.1:{port}", process
    finally:
        process.terminate()
        process.wait()
        runs.cleanup()


def find_chromium() -> str | None:
    return next((path for name in CHROMIUM if (path := shutil.which(name))), None)


def opening(browser, url: str, charts: int) -> tuple[float, float]:
    """Seconds from navigation to the first drawn plot and to the last, in a new tab of a browser with a warm cache."""
    page = browser.new_page()
    start = time.perf_counter()
    page.goto(url, wait_until="commit")
    page.wait_for_function(_DRAWN % 1, polling="raf", timeout=60_000)
    first = time.perf_counter() - start
    page.wait_for_function(_DRAWN % charts, polling="raf", timeout=60_000)
    last = time.perf_counter() - start
    page.close()
    return first, last


def slider_release(page, label: str, key: str) -> float:
    """Milliseconds from a key press on a slider (Streamlit's release) to the last change in the page."""
    handle = page.get_by_role("slider", name=label)
    handle.focus()
    watch = page.evaluate_handle(f"() => ({{ done: ({_SETTLED})(500) }})")
    page.keyboard.press(key)
    return page.evaluate("async (watch) => await watch.done", watch)


def quartiles(values: list[float]) -> str:
    low, middle, high = statistics.quantiles(values, n=4)
    return f"{middle:.4g} ({low:.4g} to {high:.4g}, n = {len(values)})"


def main(opens: int = 7, moves: int = 24) -> dict[str, list[float]]:
    """Measure and print; returns every sample by name."""
    chromium = find_chromium()
    if chromium is None:
        print("browser bench skipped: no Chromium on the path")
        return {}
    from playwright.sync_api import sync_playwright

    samples: dict[str, list[float]] = {}
    with (
        served(ROOT / "app" / "main.py") as (app, _),
        served(ROOT / "bench" / "bare_app.py") as (bare, _),
        sync_playwright() as playwright,
    ):
        browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS).new_context(
            viewport={"width": 1440, "height": 900}
        )
        for url, charts in ((app, 5), (bare, 1)):  # warm the servers and the browser's cache
            opening(browser, url, charts)
        for _ in range(opens):
            first, last = opening(browser, app, 5)
            samples.setdefault("open, first picture", []).append(first)
            samples.setdefault("open, all five", []).append(last)
            samples.setdefault("open, bare app", []).append(opening(browser, bare, 1)[0])
        workbench, plain = browser.new_page(), browser.new_page()
        workbench.goto(app)
        plain.goto(bare)
        workbench.wait_for_function(_DRAWN % 5)
        plain.wait_for_function(_DRAWN % 1)
        time.sleep(3)
        for i in range(moves):
            key = "ArrowLeft" if i % 4 < 2 else "ArrowRight"
            for label in ("alpha", "slope", "horizon"):
                workbench.bring_to_front()
                samples.setdefault(f"release of {label}", []).append(slider_release(workbench, label, key))
            plain.bring_to_front()
            samples.setdefault("release, bare app", []).append(slider_release(plain, "alpha", key))
    report(samples)
    return samples


def report(samples: dict[str, list[float]]) -> None:
    print("in headless Chromium, software rendering, median (quartiles):")
    for name, values in samples.items():
        unit = "s" if name.startswith("open") else "ms"
        print(f"  {name:24} {quartiles(values)} {unit}")
    first = statistics.median(samples["open, first picture"])
    print(f"  goal: first picture <= 3 s: {'met' if first <= 3 else 'NOT met'}")
    releases = [value for name, values in samples.items() if name.startswith("release of") for value in values]
    middle = statistics.median(releases)
    print(f"  release to picture, all sliders {middle:.0f} ms; goal <= 250 ms: {'met' if middle <= 250 else 'NOT met'}")


if __name__ == "__main__":
    main()
