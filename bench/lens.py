"""The lens in a headless Chromium: frames while a control is dragged, agreement with the library, bytes and memory.

``python -m bench.lens``
"""

from __future__ import annotations

import argparse
import base64
import os
import statistics
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import plotly

from app.lens import Simulated, payload, state_of, structure
from app.lens.payload import unpacked
from bench.browser import FLAGS, find_chromium, served
from laplace_core import PRESETS, Settings, load_world, study, study_of_gamma_space
from laplace_core.interpolation import with_added
from tests.lens_reference import seen

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "app" / "demo.py"
TREE, BARE = ROOT / "app" / "js", "http://lens.test/"
FULL = {"gammas": 100, "thetas": 250, "steps": 200}
MOVES = 60
GOALS = {"redraws": 50, "frame": 16.0, "bytes": 200_000, "difference": 1e-4}
ROUNDING = 1e-13
"""Relative error of a gamma-space in doubles: where the library's own answer turns over it, there is none to match."""

_SEEN = """
(cases) => cases.map(({ payload, state, tau }) => {
  const bytes = Uint8Array.from(atob(window.payloads[payload]), (sign) => sign.charCodeAt(0));
  window.models ??= {};
  const model = window.models[payload] ??= read(bytes);
  const found = see(model, state), all = (x) => Array.from(x, (y) => (typeof y === 'number' ? y : Array.from(y)));
  return { tau_space: all(found.tau), survival: all(found.survival), expected_reward: all(found.rewards),
    horizon_values: all(found.values), read_row: found.readRow, chosen: found.chosen, regret: found.regret ?? null,
    discount_kernel: all(kernel(model, state, found).actual),
    averaging_kernel: all(resolution(model, state, found, tau).kernel), differences: all(gammaSpace(found, state)),
    distance: simulatedFor({ model, state }) ? all(distances(model, found)) : null };
})
"""


# ---- agreement with the library


def payloads(*, small: bool = False) -> dict[str, tuple[bytes, Settings]]:
    """Spaces of every kind by a name: large, few rows, finer time steps, the paper's own grid, one without a world."""
    size = {"gammas": 40, "thetas": 60, "steps": 30} if small else FULL
    wanted = {
        "two_branch": ("two_branch", {}),
        "two_decisions": ("two_decisions", size),
        "discounting_chain": ("discounting_chain", size),
        "cliff_grid": ("cliff_grid", {"thetas": 60, "steps": 50, "theta_spacing": "asinh"}),
        "finer": ("two_decisions", {"time_step": 0.25, "thetas": 80}),
        "paper": ("discounting_chain", {"spacing": "paper", "thetas": 50, "steps": 40 if small else 120}),
    }
    found = {}
    for name, (world_name, values) in wanted.items():
        world = load_world(world_name)
        settings = study(world, Settings(world=world_name, **values)).settings
        found[name] = payload(study(world, structure(settings, world)))[0], settings
    space = study(load_world("two_branch"), Settings(thetas=40)).gamma_space
    for name, dt in (("own gamma-space", 1.0), ("own, finer", 0.5)):
        own = study_of_gamma_space(space, structure(Settings(world="own.npz", steps=20, time_step=dt), None))
        found[name] = payload(own, _simulated(len(space.thetas)))[0], own.settings
    return found


def _simulated(count: int) -> Simulated:
    """Tails of 12 steps that continuations after action 1 may have come to."""
    rng = np.random.default_rng(0)
    lines = {name: np.zeros(12) for name in ("reward", "reward_error", "survival", "survival_error", "chance")}
    ends = -np.sort(-rng.random((12, count + 2)), axis=1)
    ends[:, -1] = 0.0
    return Simulated(1, SimpleNamespace(count=50, tails=ends[:, 1:-1], open_tails=ends, **lines))


def network() -> dict[str, tuple[bytes, Settings]]:
    """A space as of a network: sensitivities spaced in asinh, discounts added between, a slope that may be softened."""
    settings = Settings(thetas=40, theta_min=-4.0, theta_max=14.0, theta_spacing="asinh", slope=4.0)
    space = with_added(replace(study(load_world("two_branch"), settings).gamma_space, open_ends=True), 1)
    added = study_of_gamma_space(space, structure(Settings(world="network", steps=20), None))
    places = 2.5 / np.diff(np.arcsinh(space.thetas)).max() * np.arcsinh(space.thetas)
    simulated = _simulated(len(space.thetas))
    return {"network": (payload(added, simulated, places=places, added=1)[0], added.settings)}


def random_cases(held: dict[str, tuple[bytes, Settings]], count: int, seed: int) -> list[dict[str, object]]:
    """States over the whole range of every control, all switches thrown by chance."""
    rng, cases = np.random.default_rng(seed), []
    for i in range(count):
        name = list(held)[i % len(held)]
        settings = held[name][1]
        last = settings.steps * settings.time_step
        T = float(rng.integers(1, last + 1)) if settings.time_step == 1 else float(rng.uniform(1, last))
        chance = rng.random(7) < 0.35
        state = state_of(settings, T, action=int(rng.integers(len(unpacked(held[name][0])[0]["actions"]))))
        state |= {
            "alpha": float(10 ** rng.uniform(-6, 0)),
            "slope": float(state["slope"] * 10 ** rng.uniform(-1, 1)),
            "softness": float(rng.choice([0, 0, 0.2, 0.7])),
            "value_gamma": float(rng.uniform(0.5, 0.995)),
            "noise": float(rng.choice([0, 0, 1e-5, 1e-2])),
            "noise_seed": int(rng.integers(0, 2**31)),
            "normalise": str(rng.choice(["none", "survival", "paper"])),
            **dict(zip(("fold", "mixed", "paper_grid", "clip", "constant", "shift"), map(bool, chance), strict=False)),
            "used": float(rng.integers(0, int(T) + 1)) if chance[6] else 0.0,
        }
        if "places" in unpacked(held[name][0])[1]:
            state["slope_share"] = float(rng.choice([1.0, 0.7, 0.2]))
        cases.append({"payload": name, "state": state, "tau": int(rng.integers(settings.steps))})
    return cases


def bare_page(browser, held: dict[str, tuple[bytes, Settings]]):
    """A page with nothing but the mathematics of the lens."""
    page = browser.new_page()
    page.route(f"{BARE}**", _from_the_tree)
    page.goto(BARE)
    names = ("core/model", "core/maths", "core/network", "lens/verdict", "lens/simulated", "lens/controls")
    imported = ", ".join(f"import('{BARE}{name}.js')" for name in names)
    page.evaluate(f"async () => {{ Object.assign(window, ...await Promise.all([{imported}])); }}")
    page.evaluate(
        "(held) => { window.payloads = held; }", {n: base64.b64encode(d).decode() for n, (d, _) in held.items()}
    )
    return page


def _from_the_tree(route) -> None:
    """Answer from ``app/js``, as a server would."""
    path = TREE / route.request.url.removeprefix(BARE)
    if path.is_file():
        route.fulfill(path=path)
    else:
        route.fulfill(body="<!doctype html>", content_type="text/html")


def agreement(page, held: dict[str, tuple[bytes, Settings]], cases: list[dict[str, object]]) -> dict[str, float]:
    """Largest difference of every output, as a share of its range, and how often another action is chosen.

    A row rescaled although it holds nothing but rounding is rounding itself, in the browser as in the library: an
    entry is held against the library where the library's own answer survives a rounding of gamma-space.
    """
    worst: dict[str, float] = {"other action": 0, "left out": 0, "entries": 0}
    for start in range(0, len(cases), 10):
        some = cases[start : start + 10]
        for case, found in zip(some, page.evaluate(_SEEN, some), strict=True):
            data, state = held[case["payload"]][0], case["state"]
            true, *moved = (seen(data, state, case["tau"], shake) for shake in (0.0, ROUNDING, -ROUNDING))
            assert found["read_row"] == true["read_row"]
            for name in ("tau_space", "survival", "expected_reward", "horizon_values", "discount_kernel",
                         "averaging_kernel", "differences", "distance"):  # fmt: skip
                assert (found[name] is None) is (name not in true)
                if found[name] is None:
                    continue
                action = state["action"] if name in ("tau_space", "differences") else slice(None)
                there = np.isfinite(true[name][action])
                shown = true[name][action][there]
                width = max(float(np.ptp(shown)), 1e-300)
                holds = np.all([np.abs(each[name][action][there] - shown) <= 1e-6 * width for each in moved], axis=0)
                off = np.abs(np.array(found[name], float).reshape(there.shape)[there] - shown) / width
                worst[name] = max(worst.get(name, 0.0), float(off[holds].max(initial=0.0)))
                worst["left out"] += int((~holds).sum())
                worst["entries"] += holds.size
            values = true["horizon_values"]
            first, second = np.sort(values[:, true["read_row"]])[::-1][:2] if len(values) > 1 else (1.0, 0.0)
            row = true["read_row"]
            stays = max(np.abs(each["horizon_values"] - values)[:, row].max() for each in moved) <= 1e-6 * np.ptp(
                values
            )
            if stays and first - second > 1e-4 * np.ptp(values):
                worst["other action"] += int(found["chosen"] != true["chosen"])
    return worst


# ---- frames


def drag(page, name: str, end: float = 0.5) -> tuple[int, list[float], int, int]:
    """Redraws, their work in ms, server runs during the drag and after it, of one second of 60 pointer moves.

    ``end`` is where the handle is let go, as a share of the track.
    """
    handle = page.locator(f"input[name={name}]")
    handle.scroll_into_view_if_needed()
    box = handle.bounding_box()
    y, low, high = box["y"] + box["height"] / 2, box["x"] + 8, box["x"] + box["width"] - 8
    page.mouse.move((low + high) / 2, y)
    page.mouse.down()
    time.sleep(0.5)
    host = page.locator(".laplace-lens")
    host.evaluate("(host) => { host.frames.length = 0; }")
    runs = _runs(page)
    began = time.perf_counter()
    for i in range(MOVES):
        share = end + 0.4 * np.sin(2 * np.pi * (i + 1) / MOVES)
        page.mouse.move(low + share * (high - low), y)
        time.sleep(max(0.0, began + (i + 1) / MOVES - time.perf_counter()))
    frames = host.evaluate("(host) => host.frames.slice()")
    during = _runs(page) - runs
    page.mouse.up()
    time.sleep(1.5)
    return len(frames), frames, during, _runs(page) - runs - during


def _runs(page) -> int:
    return int(page.get_by_text("runs ").inner_text().split()[1].rstrip(","))


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
        runs = _runs(page)
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
    with served(PAGE) as (address, server), sync_playwright() as playwright:
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


def _agreement(browser, count: int) -> None:
    held = payloads()
    cases = random_cases(held, count, 1) + random_cases(network(), count // 5, 1)
    page = bare_page(browser, held := held | network())
    found = agreement(page, held, cases)
    page.close()
    left, entries = found.pop("left out"), found.pop("entries")
    print(f"against NumPy, {len(cases)} settings, goal <= {GOALS['difference']:g} of the range:")
    print("  " + ", ".join(f"{name} {value:.2g}" for name, value in found.items()))
    print(f"  {left:,} of {entries:,} entries are rounding in the library itself and left out")


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
