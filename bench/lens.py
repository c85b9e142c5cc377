"""The lens in a headless Chromium: frames while a control is dragged, agreement with the library, bytes and memory.

``python -m bench.lens``
"""

from __future__ import annotations

import argparse
import os
import statistics
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import plotly

from laplace_core import PRESETS, Settings, load_world, study
from laplace_core.payloads.lens import payload, structure
from tests.browser.support import DEMO, FLAGS, find_chromium, grab, runs_of_demo, served
from tests.support.lens_agreement import FULL, compared_in, fixture, network, payloads, random_cases

MOVES = 60
GOALS = {"redraws": 50, "frame": 16.0, "bytes": 200_000, "difference": 1e-4}

# ---- agreement with the library


def _agreement(browser, count: int) -> None:
    held = payloads()
    cases = random_cases(held, count, 1) + random_cases(network(), count // 5, 1)
    results = [compared_in(browser, fixture(held | network(), cases[i : i + 10])) for i in range(0, len(cases), 10)]
    problems = [problem for result in results for problem in result["problems"]]
    names = sorted({name for result in results for name in result["off"]})
    worst = {name: max(result["off"].get(name, 0.0) for result in results) for name in names}
    left, entries = (sum(result[name] for result in results) for name in ("leftOut", "entries"))
    print(f"against NumPy, {len(cases)} settings, goal <= {GOALS['difference']:g} of the range:")
    print("  " + ", ".join([f"{name} {value:.2g}" for name, value in worst.items()] + problems))
    print(f"  {left:,} of {entries:,} entries are rounding in the library itself and left out")


# ---- frames


def drag(page, name: str, end: float = 0.5) -> tuple[int, list[float], int, int]:
    """Redraws, their work in ms, server runs during the drag and after it, of one second of 60 pointer moves.

    ``end`` is where the handle is let go, as a share of the track.
    """
    move = grab(page, name)
    time.sleep(0.5)
    host = page.locator(".laplace-lens")
    host.evaluate("(host) => { host.frames.length = 0; }")
    runs = runs_of_demo(page)
    began = time.perf_counter()
    for i in range(MOVES):
        move(end + 0.4 * np.sin(2 * np.pi * (i + 1) / MOVES))
        time.sleep(max(0.0, began + (i + 1) / MOVES - time.perf_counter()))
    frames = host.evaluate("(host) => host.frames.slice()")
    during = runs_of_demo(page) - runs
    page.mouse.up()
    time.sleep(1.5)
    return len(frames), frames, during, runs_of_demo(page) - runs - during


def memory_of(pid: int) -> float:
    """Resident megabytes of a process."""
    pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def releases(page, pid: int, count: int) -> Iterator[tuple[int, float, float]]:
    """Releases so far, heap of the browser and memory of the server in MB, after garbage collection."""
    session = page.context.new_cdp_session(page)
    handle = page.locator("input[name=alpha]")
    handle.focus()
    for i in range(count + 1):
        if i % max(1, count // 10) == 0:
            session.send("HeapProfiler.collectGarbage")
            heap = page.evaluate("() => performance.memory.usedJSHeapSize") / 1e6
            yield i, heap, memory_of(pid)
        if i == count:
            break
        runs = runs_of_demo(page)
        page.keyboard.press("ArrowLeft" if i % 2 else "ArrowRight")
        page.wait_for_function(f"() => document.body.innerText.includes('runs {runs + 1},')", polling=20)


_PLOTLY = """
async () => {
  const x = Array.from({ length: 200 }, (_, i) => i);
  const layout = { width: 265, height: 204, margin: { l: 40, r: 8, t: 24, b: 32 } };
  const boxes = [0, 1, 2, 3].map(() => document.body.appendChild(document.createElement('div'))), work = [];
  for (let k = 0; k < 60; k += 1) {
    const began = performance.now();
    for (const box of boxes) {
      const y = (phase) => x.map((i) => Math.sin(i / 20 + k / 10 + phase));
      await Plotly.react(box, [0, 1, 2].map((phase) => ({ x, y: y(phase), mode: 'lines' })), layout);
    }
    work.push(performance.now() - began);
    await new Promise((next) => requestAnimationFrame(next));
  }
  return work.slice(5);
}
"""


def _plotly(browser) -> None:
    """What the four line pictures would cost a frame if plotly.js drew them: why the lens draws on canvases."""
    page = browser.new_page()
    page.goto("about:blank")
    page.add_script_tag(path=str(Path(plotly.__file__).parent / "package_data" / "plotly.min.js"))
    work = page.evaluate(_PLOTLY)
    page.close()
    print(
        f"four line pictures by plotly.js: work {statistics.median(work):.1f} ms a frame, 95% "
        f"{np.percentile(work, 95):.1f}; the whole lens has {GOALS['frame']:g}"
    )


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m bench.lens", description=__doc__.split("\n")[0])
    parser.add_argument("--only", choices=("agreement", "drags", "releases", "plotly"), help="run one part")
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--releases", type=int, default=1000)
    parser.add_argument("--world", default="two_decisions")
    options = parser.parse_args()
    chromium = find_chromium()
    if chromium is None:
        print("lens bench skipped: no Chromium on the path")
        return
    from playwright.sync_api import sync_playwright

    print(f"load {os.getloadavg()[0]:.2f}")
    with served(DEMO) as (address, server), sync_playwright() as playwright:
        flags = [*FLAGS, "--enable-precise-memory-info"]
        browser = playwright.chromium.launch(executable_path=chromium, args=flags)
        if options.only in (None, "agreement"):
            _agreement(browser, options.cases)
        if options.only in (None, "plotly"):
            _plotly(browser)
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        if options.only in (None, "drags"):
            _drags(page, f"{address}/?world={options.world}")
        if options.only in (None, "releases"):
            page.goto(f"{address}/?world={options.world}")
            page.locator("canvas.tau-space").wait_for()
            time.sleep(3)
            for count, heap, memory in releases(page, server.pid, options.releases):
                print(f"  after {count:5} releases: heap {heap:.1f} MB, server {memory:.1f} MB", flush=True)
        browser.close()


def _drags(page, address: str) -> None:
    largest = 0
    for name in PRESETS:
        world = load_world(name)
        settings = study(world, Settings(world=name, **FULL)).settings
        largest = max(largest, len(payload(study(world, structure(settings, world)))[0]))
    print(f"payload at {FULL}: at most {largest:,} bytes over the presets; goal <= {GOALS['bytes']:,}")
    received: list[int] = []
    page.on("websocket", lambda socket: socket.on("framereceived", lambda frame: received.append(len(frame))))
    page.goto("&".join([address, *(f"{name}={value}" for name, value in FULL.items())]))
    page.locator("canvas.tau-space").wait_for()
    time.sleep(3)
    print(f"opening: {sum(received):,} bytes over the socket, scripts of the page included")
    for name in ("alpha", "horizon", "slope"):
        samples = [drag(page, name, end) for end in (0.45, 0.5, 0.55)]
        received.clear()
        samples.append(drag(page, name, 0.45))
        work = [frame for _, frames, _, _ in samples for frame in frames]
        late = float(np.percentile(work, 95))
        print(
            f"drag {name:8} redraws {[n for n, *_ in samples]} (goal >= {GOALS['redraws']}), work "
            f"{statistics.median(work):.1f} ms, 95% {late:.1f} (goal <= {GOALS['frame']:g}), server runs during "
            f"{[x for *_, x, _ in samples]}, after {[x for *_, x in samples]}, {sum(received):,} bytes a release; "
            f"load {os.getloadavg()[0]:.2f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
