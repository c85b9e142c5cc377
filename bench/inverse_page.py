"""The page of the inverse and the lens in a headless Chromium: frames while alpha is dragged, by solver.

On the page of the inverse alpha is dragged on the L-curve and on a rule's curve, in the lens by its slider. Other work
on the machine makes all of them slower: each figure also stands over that of the linear solver in the same run.

``python -m bench.inverse_page``
"""

from __future__ import annotations

import os
import statistics

import numpy as np

from tests.browser.support import DRAWN, FLAGS, MAIN, PATIENCE, WATCH, find_chromium, grab, runs_asked, served, settled

MOVES = 60
REDRAWS = 50
CASES = {
    "linear, 15 x 113 x 200": ("gammas=15&thetas=114&steps=200", 16.0),
    "non-negative, 15 x 113 x 200": ("gammas=15&thetas=114&steps=200&solver=nonnegative", 60.0),
    "linear, 100 x 250 x 200": ("gammas=100&thetas=251&steps=200", 16.0),
}
"""Links of the page by what they show, and the milliseconds that 95% of the frames may take."""
IN_LENS = {
    "linear": ("", 16.0),
    "non-negative": ("&solver=nonnegative", 60.0),
    "feasible, until it is released": ("&solver=feasible", 16.0),
}
"""The same for the lens, at 15 x 113 x 200 with the five actions of its world."""
HOST = "document.querySelector('.laplace-inverse').inverse"


def drag(page, name: str) -> tuple[list[float], int, int]:
    """Work of each frame in ms, and runs of the server during a drag of 60 moves and after it."""
    canvas = page.locator(f".laplace-inverse .{name} canvas")
    canvas.scroll_into_view_if_needed()
    box = canvas.bounding_box()
    page.evaluate(f"() => {{ {HOST}.frames.length = 0; }}")
    runs = runs_asked(page)
    for i in range(MOVES + 1):
        share = 0.5 + 0.3 * np.sin(2 * np.pi * i / MOVES)
        page.mouse.move(box["x"] + share * box["width"], box["y"] + 0.5 * box["height"])
        if not i:
            page.mouse.down()
        page.evaluate("() => new Promise(requestAnimationFrame)")
    frames = page.evaluate(f"() => {HOST}.frames.slice()")
    during = runs_asked(page) - runs
    page.mouse.up()
    settled(page)
    return frames, during, runs_asked(page) - runs - during


def slide(page) -> tuple[list[float], int, int]:
    """The same as :func:`drag` of the slider of alpha in the lens."""
    move, lens = grab(page, "alpha"), "document.querySelector('.laplace-lens')"
    page.evaluate(f"() => {{ {lens}.frames.length = 0; }}")
    runs = runs_asked(page)
    for i in range(MOVES + 1):
        move(0.5 + 0.3 * np.sin(2 * np.pi * i / MOVES))
        page.evaluate("() => new Promise(requestAnimationFrame)")
    frames = page.evaluate(f"() => {lens}.frames.slice()")
    during = runs_asked(page) - runs
    page.mouse.up()
    settled(page)
    return frames, during, runs_asked(page) - runs - during


def report(title: str, found: tuple[list[float], int, int], goal: float, linear: float | None) -> float:
    """Print what was found; returns the median work of a frame in ms."""
    frames, during, after = found
    middle = statistics.median(frames)
    ratio = "" if linear is None else f", {middle / linear:.1f} times that of the linear solver"
    print(
        f"{title}: {len(frames)} redraws (goal >= {REDRAWS}), work {middle:.1f} ms{ratio}, 95% "
        f"{np.percentile(frames, 95):.1f} (goal <= {goal:g}), server runs during {during}, after {after}; load "
        f"{os.getloadavg()[0]:.2f}",
        flush=True,
    )
    return middle


def main() -> None:
    chromium = find_chromium()
    if chromium is None:
        print("bench of the page of the inverse skipped: no Chromium on the path")
        return
    from playwright.sync_api import sync_playwright

    linear: dict[str, float] = {}
    with served(MAIN) as (address, _), sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS)
        context = browser.new_context(viewport={"width": 1440, "height": 900})
        context.set_default_timeout(PATIENCE)
        context.add_init_script(WATCH)
        page = context.new_page()
        for title, (query, goal) in CASES.items():
            page.goto(f"{address}/inverse?world=discounting_chain&noise=0.001&{query}")
            page.wait_for_function(f"() => {HOST.replace(').', ')?.')}?.scene?.made")
            settled(page)
            for name in ("lcurve", "rule-gcv"):
                middle = report(f"{title}, {name}", drag(page, name), goal, linear.get(name))
                linear.setdefault(name, middle)
        for title, (query, goal) in IN_LENS.items():
            page.goto(f"{address}/?world=discounting_chain&noise=0.001&gammas=15&thetas=114&steps=200{query}")
            page.wait_for_function(DRAWN)
            settled(page)
            if "feasible" in query:
                page.wait_for_function("() => document.querySelector('.laplace-lens').lens.model.arrays.decoded")
                settled(page)
            linear.setdefault("lens", report(f"lens, {title}", slide(page), goal, linear.get("lens")))
        browser.close()


if __name__ == "__main__":
    main()
