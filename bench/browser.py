"""What a person waits for, in a headless Chromium: the first picture, and the new one after a slider's release.

Both are measured on the workbench and on a bare Streamlit app with one heatmap, in turns, on warm servers. The
clock runs in the page: from the key press that moves a slider to the redraw, which the browser does by itself, and to
the link, which the server writes.
"""

from __future__ import annotations

import statistics
import time

from tests.browser.support import FLAGS, MAIN, ROOT, find_chromium, served

# Resolves with the milliseconds until the next redraw of the lens, and until the address bar, which the server writes,
# has changed.
_RELEASED = """
() => new Promise((done, fail) => {
  setTimeout(() => fail(new Error('no answer to a release within 20 s')), 20_000);
  const { frames } = document.querySelector('.laplace-lens'), link = location.href, start = performance.now();
  let drawn, before = frames.length;
  const tick = () => {
    if (drawn === undefined && frames.length !== before) drawn = performance.now() - start;
    if (location.href !== link) done([drawn ?? performance.now() - start, performance.now() - start]);
    else requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
})
"""
# The same for the bare app: until the text that follows its slider has changed.
_ANSWERED = """
() => new Promise((done, fail) => {
  setTimeout(() => fail(new Error('no answer of the bare app within 20 s')), 20_000);
  const text = () => document.querySelector('[data-testid="stMarkdown"]').textContent, before = text();
  const start = performance.now(), tick = () => {
    if (text() !== before) done(performance.now() - start);
    else requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
})
"""
_LENS = "() => document.querySelector('.laplace-lens')?.frames?.length > 0"
_GRAPH = "() => document.querySelector('.laplace-lens .world .main-svg')"
_PLOT = "() => document.querySelector('.js-plotly-plot .main-svg')"


def opening(browser, url: str, *drawn: str) -> list[float]:
    """Seconds from navigation until each of these is there, in a new tab of a browser with a warm cache."""
    page, found = browser.new_page(), []
    start = time.perf_counter()
    page.goto(url, wait_until="commit")
    for each in drawn:
        page.wait_for_function(each, polling="raf", timeout=60_000)
        found.append(time.perf_counter() - start)
    page.close()
    return found


def release(page, handle, key: str, watch: str) -> object:
    """Press a key on a slider and wait for what follows."""
    handle.focus()
    waiting = page.evaluate_handle(f"() => ({{ done: ({watch})() }})")
    page.keyboard.press(key)
    return page.evaluate("async (waiting) => await waiting.done", waiting)


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
        served(MAIN) as (app, _),
        served(ROOT / "bench" / "bare_app.py") as (bare, _),
        sync_playwright() as playwright,
    ):
        browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS).new_context(
            viewport={"width": 1440, "height": 900}
        )
        opening(browser, app, _LENS, _GRAPH)  # warm the servers and the browser's cache
        opening(browser, bare, _PLOT)
        for _ in range(opens):
            first, last = opening(browser, app, _LENS, _GRAPH)
            samples.setdefault("open, first picture", []).append(first)
            samples.setdefault("open, and the graph", []).append(last)
            samples.setdefault("open, bare app", []).append(opening(browser, bare, _PLOT)[0])
        workbench, plain = browser.new_page(), browser.new_page()
        workbench.goto(app)
        plain.goto(bare)
        workbench.wait_for_function(_LENS)
        plain.wait_for_function(_PLOT)
        time.sleep(3)
        for i in range(moves):
            key = "ArrowLeft" if i % 4 < 2 else "ArrowRight"
            for name in ("alpha", "slope", "horizon"):
                workbench.bring_to_front()
                drawn, linked = release(workbench, workbench.locator(f"input[name={name}]"), key, _RELEASED)
                samples.setdefault(f"{name}, picture", []).append(drawn)
                samples.setdefault(f"{name}, link", []).append(linked)
            plain.bring_to_front()
            slider = plain.get_by_role("slider", name="alpha")
            samples.setdefault("bare app, text", []).append(release(plain, slider, key, _ANSWERED))
    report(samples)
    return samples


def report(samples: dict[str, list[float]]) -> None:
    print("in headless Chromium, software rendering, median (quartiles):")
    for name, values in samples.items():
        unit = "s" if name.startswith("open") else "ms"
        print(f"  {name:24} {quartiles(values)} {unit}")
    first = statistics.median(samples["open, first picture"])
    print(f"  goal: first picture <= 3 s: {'met' if first <= 3 else 'NOT met'}")
    drawn = [value for name, values in samples.items() if name.endswith(", picture") for value in values]
    linked = [value for name, values in samples.items() if name.endswith(", link") for value in values]
    middle = statistics.median(drawn)
    print(f"  release to picture, all sliders {middle:.0f} ms; goal <= 250 ms: {'met' if middle <= 250 else 'NOT met'}")
    middle = statistics.median(linked)
    print(f"  release to the server's answer, all sliders {middle:.0f} ms, 120 of them a wait for further keys")


if __name__ == "__main__":
    main()
