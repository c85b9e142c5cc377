"""The page of trained agents, on the shipped lander: reading a state, rolling out, opening, scrubbing, and memory.

What a person waits for is measured in a headless Chromium on a warm server; without one, only the library's part is.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path
from time import perf_counter, process_time

import numpy as np
import torch

from bench.browser import opening
from bench.lens import memory_of
from bench.report import Figure, Goal
from bench.timing import Spread, interleaved, spread
from bench.users import _GO
from laplace_core.acting.rollout import roll_out
from laplace_core.caching import weigh
from laplace_core.inverse import decode
from laplace_core.payloads.player import payload
from laplace_core.training.checkpoint import Loaded, load_checkpoint
from tests.browser.support import FLAGS, MAIN, ROOT, find_chromium, module_of, served

SUBJECT = "Trained agents"
NAME = "laplace_LunarLander-v3"
LONG = 12
"""A start seed from which the shipped lander hovers until the time limit of 1,000 steps, greedy and fading alike."""
ROLLOUTS, LENGTH = 50, 150

_LENS = "() => document.querySelector('.laplace-lens')?.frames?.length > 0"
_PLAYER = "() => document.querySelector('.laplace-player .line b')?.textContent"
# Milliseconds from moving the slider of the player to the frame that shows the step's spaces, for so many steps; the
# hand never rests for long enough that the server would be asked.
_SCRUBBED = """
async (count) => {
  const bar = document.querySelector('.laplace-player input[name=step]');
  const { lens } = document.querySelector('.laplace-lens');
  const found = [], frame = () => new Promise((next) => requestAnimationFrame(next));
  for (let step = 1; step <= count; step += 1) {
    await new Promise((next) => setTimeout(next, 7 + (step * 13) % 40)); // at no particular moment of a frame
    lens.host.frames.length = 0;
    const began = performance.now();
    bar.value = step;
    bar.dispatchEvent(new Event('input'));
    while (!lens.host.frames.length) await frame(); // this comes after the lens in the same frame
    found.push(performance.now() - began);
    if (!lens.model.id.endsWith(` ${step}`)) throw new Error(`step ${step} is not what the lens shows`);
  }
  return found;
}
"""


def main() -> Iterator[Figure]:
    torch.set_num_threads(1)
    loaded = load_checkpoint(Path(ROOT) / "checkpoints" / f"{NAME}.safetensors")
    yield from _reading(loaded)
    yield from _rollouts(loaded)
    chromium = find_chromium()
    if chromium is None:
        print("  the page itself is skipped: no Chromium on the path")
        return
    from playwright.sync_api import sync_playwright

    with served(MAIN) as (address, server), sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS)
        with contextlib.closing(browser.new_context(viewport={"width": 1440, "height": 900})) as context:
            url = f"{address}/agents?checkpoint={NAME}"
            yield _opening(context, url)
            yield from _scrubbing(context, url)
            yield from _memory(context, url, server.pid)


def _sizes(loaded: Loaded) -> str:
    agent = loaded.agent
    return f"{agent.n_actions} actions x {len(agent.gammas)} discounts x {len(agent.thetas)} sensitivities, one thread"


def _reading(loaded: Loaded) -> Iterator[Figure]:
    agent, random = loaded.agent, np.random.default_rng(0)
    one, many = random.normal(size=agent.n_observations), random.normal(size=(500, agent.n_observations))

    def read():
        space = agent.gamma_space(one)
        return decode(space.differences, space.gammas, 200, 0.1)

    seconds = interleaved({"one": (read, 5), "many": (lambda: agent.gamma_spaces(many), 1)}, rounds=15)
    yield Figure(
        SUBJECT, "gamma-space of one state and its decode at K = 200", spread(1e3 * seconds["one"]), "ms",
        _sizes(loaded), Goal("<", 5),
    )  # fmt: skip
    yield Figure(
        SUBJECT, "gamma-space of 500 states in one batch", spread(seconds["many"]), "s", _sizes(loaded), Goal("<", 0.5)
    )


def _rollouts(loaded: Loaded) -> Iterator[Figure]:
    for rule in ("greedy", "fading"):
        seconds, busy, megabytes = [], [], []
        for _ in range(3):
            began, before = perf_counter(), process_time()
            found = roll_out(loaded.agent, loaded.environment, LONG, rule=rule, horizon=1_000, pictures=True)
            packed = payload(found)
            seconds.append(perf_counter() - began)
            busy.append(process_time() - before)
            megabytes.append((weigh(found).bytes + len(packed)) / 1e6)
        sizes = f"LunarLander, seed {LONG}, {rule}, {len(found):,} steps; {_sizes(loaded)}"
        note = f"time of the processor {np.median(busy):.1f} s; packed for the browser, {np.median(megabytes):.0f} MB"
        yield Figure(
            SUBJECT, f"1,000 steps rolled out {rule}, pictures and spaces", spread(seconds), "s", sizes,
            Goal("<=", 15), note,
        )  # fmt: skip


def _opening(context, url: str, times: int = 7) -> Figure:
    opening(context, url, _LENS)  # warms the server and the browser's cache
    return Figure(
        SUBJECT, "opening a shipped checkpoint to the first picture", spread([opening(context, url, _LENS)[0] for _ in
        range(times)]), "s", "1440 x 900, a new tab", Goal("<=", 3), "on a warm server",
    )  # fmt: skip


def _scrubbing(context, url: str, count: int = 150) -> Iterator[Figure]:
    page = context.new_page()
    page.set_default_timeout(300_000)
    page.goto(f"{url}&r.shown=yes&r.seed={LONG}")
    page.wait_for_function(_PLAYER)
    page.wait_for_timeout(3_000)
    found = page.evaluate(_SCRUBBED, count)
    work = page.evaluate("() => document.querySelector('.laplace-player').times.slice(1)")
    page.close()
    sizes = f"all pictures of the lens, K = 200; {count} steps of an episode of 1,000"
    yield Figure(
        SUBJECT, "scrubbing, from the hand to the next state's spaces", spread(found), "ms", sizes, Goal("<=", 33),
        f"95% {np.percentile(found, 95):.1f} ms, of which the wait for a frame is up to 16.7",
    )  # fmt: skip
    yield Figure(
        SUBJECT, "the same, unpacking the step and the player's own pictures", spread(work), "ms", sizes,
        note=f"95% {np.percentile(work, 95):.1f} ms",
    )  # fmt: skip


def _memory(context, url: str, server: int) -> Iterator[Figure]:
    page, found, before = context.new_page(), [memory_of(server)], None
    page.set_default_timeout(300_000)
    page.goto(url)
    page.wait_for_function(_LENS)
    for i in range(ROLLOUTS):
        query = f"checkpoint={NAME}&r.shown=yes&r.seed={i + 100}&r.rule=fading&r.horizon={LENGTH}"
        page.evaluate(_GO, query)
        hub = module_of(page, "hub.js")
        page.wait_for_function("([{ hub }, before]) => (hub.leader?.id ?? before) !== before", arg=[hub, before])
        before = hub.evaluate("({ hub }) => hub.leader.id")
        if i % 10 == 9:
            found.append(memory_of(server))
    page.close()
    sizes = f"LunarLander, {ROLLOUTS} seeds, fading, T = {LENGTH}, with pictures; of rollouts 16 are kept"
    told = ", ".join(f"{value:.0f}" for value in found)
    yield Figure(
        SUBJECT, f"memory of the server after {ROLLOUTS} opened rollouts", Spread(found[-1], found[-1], found[-1], 1),
        "MB", sizes, note=f"before, and after every ten: {told} MB",
    )  # fmt: skip
    yield Figure(
        SUBJECT, "growth with ten more, once as many are kept as will be", spread(np.diff(found[2:])), "MB", sizes,
        Goal("<=", 10), "from the 20th on",
    )  # fmt: skip
