"""Many people at once: browser sessions that each change controls, and whether each sees its own picture.

``python -m bench.users [--users 50] [--changes 20]`` starts a server, opens a session a user in one Chromium, and lets
all of them change their controls, some by widgets and some by the address bar. After every change the tau-space that
the page draws and its verdict are compared with what the library computes for the settings of that session. The same
is done twice; the server's memory is printed after a warm-up, after the first round and after the second.
"""

from __future__ import annotations

import argparse
import asyncio
import base64
import random
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import parse_qsl, urlencode, urlsplit

import numpy as np

from app.worlds.schema import LINK
from app.worlds.sources import view_of
from laplace_core import load_world, study
from laplace_core.exchange.links import query_of
from laplace_core.files.packed_text import pack
from laplace_core.study.verdict import judge
from laplace_core.worlds import dump_world
from laplace_core.worlds.timeline import packed_timeline
from tests.browser.support import FLAGS, MAIN, find_chromium, served

WARM = 10
"""Users whose changes warm the server up before its memory is looked at."""
AT_ONCE = 4
"""Users who do something at the same time; all others keep their page open."""
PATIENCE = 60_000  # milliseconds until a picture that has not come counts as wrong
_WORLDS = (
    "two_branch",
    "two_decisions",
    "rise_and_fade",
    "double_chain",
    "gym:FrozenLake-v1",
    "cliff_grid",
    "fig6_chain",
)
_READY = "() => document.querySelector('.laplace-lens')?.lens?.seen"
_GO = """
(query) => {
  history.pushState({}, '', '?' + query);
  dispatchEvent(new PopStateEvent('popstate', { state: {} }));
}
"""

# Whether the page shows these rows (single floats, base64) within a tolerance, this verdict, and this link.
_SHOWS = """
({ rows, columns, values, verdict, query }) => {
  const told = document.querySelector('.verdict')?.textContent ?? '';
  if (!told.includes(verdict)) return false;
  const link = [...new URLSearchParams(location.search)].map(([name, value]) => `${name}=${value}`).sort().join('&');
  if (link !== query) return false;
  const seen = document.querySelector('.laplace-lens')?.lens?.seen;
  if (!seen || seen.n !== rows || seen.H !== columns) return false;
  const wanted = new Float32Array(Uint8Array.from(atob(values), (c) => c.charCodeAt(0)).buffer);
  for (let i = 0; i < rows * columns; i += 1)
    if (Math.abs(seen.tau[i] - wanted[i]) > 1e-5 + 1e-4 * Math.abs(wanted[i])) return false;
  return true;
}
"""
_SEEN = """
() => {
  const seen = document.querySelector('.laplace-lens')?.lens?.seen;
  return { verdict: document.querySelector('.verdict')?.textContent, rows: seen?.n, columns: seen?.H,
           search: location.search };
}
"""
_ERRORS = """
() => [...document.querySelectorAll('[data-testid="stException"], [data-testid="stAlertContentError"]')]
  .map((box) => box.textContent.slice(0, 200))
"""


@dataclass
class User:
    """One session: what it has set, by its own account, and what went wrong."""

    number: int
    page: object
    chance: random.Random
    wanted: dict[str, str] = field(default_factory=dict)
    errors: list[str] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)
    seconds: list[float] = field(default_factory=list)


def start_of(chance: random.Random) -> dict[str, str]:
    """A world with settings of its own; one in six brings its own world, one in six its own timeline."""
    dice = chance.random()
    if dice < 1 / 6:
        params = {"r2": round(chance.uniform(2, 20), 2), "r1": round(chance.uniform(1, 9), 2)}
        return {"world": "own", "own": pack(dump_world(load_world("two_branch", params))), **_alpha(chance)}
    if dice < 2 / 6:
        rows = [
            {
                "action": name,
                "tau": tau,
                "reward": round(chance.uniform(1, 9), 1),
                "probability": chance.choice((1.0, 0.5)),
            }
            for name in ("now", "later")
            for tau in chance.sample(range(9), 2)
        ]
        return {"world": "timeline", "timeline": packed_timeline(rows, "zero"), **_alpha(chance)}
    return {"world": chance.choice(_WORLDS), **_alpha(chance)}


def _alpha(chance: random.Random) -> dict[str, str]:
    return {"alpha": f"{10 ** chance.uniform(-4, 0.5):.2g}"}


def changed(wanted: dict[str, str], chance: random.Random) -> dict[str, str]:
    """The settings with one of them changed to something else that fits."""
    view = view_of(LINK.read(wanted)[0])
    horizons = study(view.world, view.settings).horizons
    options = {
        "alpha": _alpha(chance)["alpha"],
        "slope": f"{view.settings.slope * chance.choice((0.5, 0.7, 1.5, 2)):.2g}",
        "thetas": str(chance.randrange(20, 160, 10)),
        "gammas": str(chance.randrange(8, 40)),
        "spacing": chance.choice(("inverse-log", "log", "linear")),
        "normalise": chance.choice(("none", "survival", "paper")),
        "policy": chance.choice(("shared", "per_gamma")),
        "action": chance.choice(view.world.actions),
        "state": chance.choice(view.world.states),
        "horizon": f"{chance.choice(list(horizons)):g}",
        "acting_gamma": f"{chance.uniform(0.8, 0.99):.2g}",
        "noise": f"{10 ** chance.uniform(-5, -2):.2g}",
        "softness": f"{chance.choice((0.0, 0.1, 0.3)):g}",
    }
    if wanted["world"] in _WORLDS:
        options["world"] = chance.choice(_WORLDS)
    name = chance.choice([name for name, value in options.items() if wanted.get(name) != value])
    if name == "world":  # state, action and the like belong to the world that is left
        return {"world": options["world"], **{k: v for k, v in wanted.items() if k in ("normalise", "policy")}}
    return {**wanted, name: options[name]}


async def use(user: User) -> None:
    """One change, by a widget or by the address bar, and what is seen then."""
    way = user.chance.random()
    before = dict(user.wanted)
    began = time.perf_counter()
    if way < 0.25:
        await _press_slider(user, "alpha")
    elif way < 0.35:
        await _choose_normalisation(user)
    else:
        user.wanted = changed(user.wanted, user.chance)
        await user.page.evaluate(_GO, urlencode(user.wanted))
    await check(user, f"{before} -> {user.wanted}")
    user.seconds.append(time.perf_counter() - began)


async def _press_slider(user: User, name: str) -> None:
    slider = user.page.locator(f"input[name={name}]")
    before = await slider.get_attribute("aria-valuetext")
    await slider.focus()
    await user.page.keyboard.press(user.chance.choice(("ArrowLeft", "ArrowRight")))
    after = await slider.get_attribute("aria-valuetext")
    if after != before:
        user.wanted = {**user.wanted, name: after}


async def _choose_normalisation(user: User) -> None:
    value = user.chance.choice(
        [value for value in ("none", "survival", "paper") if value != user.wanted.get("normalise", "none")]
    )
    await user.page.get_by_label("rows of tau-space").select_option(value)
    user.wanted = {**user.wanted, "normalise": value}


async def check(user: User, what: str) -> None:
    """Compare the page with the library: its link, its tau-space and its verdict."""
    user.wanted = query_of(LINK.read(user.wanted)[0])  # numbers as the page writes them
    view = view_of(LINK.read(user.wanted)[0])
    found = study(view.world, view.settings)
    z = np.ascontiguousarray(found.decoded.tau_space[view.action], dtype="<f4")
    expected = {
        "rows": z.shape[0],
        "columns": z.shape[1],
        "values": base64.b64encode(z.tobytes()).decode(),
        "verdict": judge(found, found.row, view.action).sentence,
        "query": "&".join(sorted(f"{name}={value}" for name, value in user.wanted.items())),
    }
    from playwright.async_api import TimeoutError as Late

    try:
        await user.page.wait_for_function(_SHOWS, arg=expected, polling=60, timeout=PATIENCE)
    except Late:
        seen = await user.page.evaluate(_SEEN)
        user.wrong.append(f"{what}: wanted {z.shape}, {expected['verdict']!r}, {expected['query']!r}; seen {seen}")
        user.wanted = dict(parse_qsl(urlsplit(user.page.url).query)) or user.wanted
    user.errors += await user.page.evaluate(_ERRORS)


async def opened(browser, address: str, number: int, seed: int) -> User:
    from playwright.async_api import TimeoutError as Late

    context = await browser.new_context(viewport={"width": 900, "height": 500})
    context.set_default_timeout(PATIENCE)
    user = User(number, await context.new_page(), random.Random(f"{seed} {number}"))
    user.page.on("pageerror", lambda error: user.errors.append(f"page: {error}"))
    user.page.on("console", lambda message: message.type == "error" and user.errors.append(f"console: {message.text}"))
    user.wanted = start_of(user.chance)
    await user.page.goto(f"{address}/?{urlencode(user.wanted)}")
    try:
        await user.page.wait_for_function(_READY, polling=100)
    except Late:
        user.errors.append(f"did not open: {(await user.page.inner_text('body'))[:200]!r}")
    await check(user, f"opened {user.wanted}")
    return user


async def several(jobs) -> list:
    """Run coroutines, a few at a time."""
    room = asyncio.Semaphore(AT_ONCE)

    async def one(job):
        async with room:
            return await job

    return await asyncio.gather(*(one(job) for job in jobs))


async def changes(user: User, count: int) -> None:
    """So many changes; a page that does not answer is an error, and is opened again."""
    from playwright.async_api import Error

    for _ in range(count):
        try:
            await use(user)
        except Error as error:
            said = (await user.page.inner_text("body"))[:300]
            user.errors.append(f"{str(error).splitlines()[0]} at {user.page.url}: {said!r}")
            await user.page.reload()
            user.wanted = dict(parse_qsl(urlsplit(user.page.url).query)) or user.wanted


def memory(process) -> float:
    """Resident memory of the server in MB, where the system tells it."""
    try:
        status = Path(f"/proc/{process.pid}/status").read_text()
    except OSError:
        return float("nan")
    return int(status.split("VmRSS:")[1].split()[0]) / 1024


async def session(
    address: str, process, users: int, count: int, *, seed: int
) -> tuple[list[User], list[tuple[str, float]]]:
    """Both rounds; the users and the server's memory on the way."""
    from playwright.async_api import async_playwright

    told = [("before the first user", memory(process))]
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=find_chromium(), args=FLAGS)
        everyone = await several(opened(browser, address, i, seed) for i in range(min(WARM, users)))
        told.append((f"{len(everyone)} users open", memory(process)))
        await several(changes(user, count) for user in everyone)
        told.append((f"warm: {len(everyone)} x {count} changes", memory(process)))
        rest = await several(opened(browser, address, i, seed) for i in range(len(everyone), users))
        told.append((f"{users} users open", memory(process)))
        await several(changes(user, count) for user in rest)
        everyone += rest
        told.append((f"first round, {users} x {count} changes", memory(process)))
        await several(changes(user, count) for user in everyone)
        told.append(("second round, as many again", memory(process)))
        await browser.close()
    return everyone, told


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m bench.users", description=__doc__.partition("\n")[0])
    parser.add_argument("--users", type=int, default=50, metavar="N")
    parser.add_argument("--changes", type=int, default=20, metavar="N", help="changes of each user in each round")
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="seed of what they do")
    options = parser.parse_args()
    if find_chromium() is None:
        print("users skipped: no Chromium on the path")
        return 0
    began = time.perf_counter()
    with tempfile.TemporaryFile("w+") as log, served(MAIN, log) as (address, process):
        everyone, told = asyncio.run(session(address, process, options.users, options.changes, seed=options.seed))
        log.seek(0)
        server = log.read()
    return report(everyone, told, server, time.perf_counter() - began)


def report(everyone: list[User], told: list[tuple[str, float]], server: str, seconds: float) -> int:
    """Print the table; the exit status."""
    done = sorted(s for user in everyone for s in user.seconds)
    errors = [f"user {user.number}: {text}" for user in everyone for text in user.errors]
    wrong = [f"user {user.number}: {text}" for user in everyone for text in user.wrong]
    traces = server.count("Traceback")
    print(f"{len(everyone)} sessions in one Chromium, {len(done):,} changes, {seconds:.0f} s in all")
    middle, slow = np.quantile(done, [0.5, 0.95])
    print(f"  change to the right picture and verdict   median {middle:.2f} s, 95% {slow:.2f} s")
    print(f"  wrong pictures or verdicts                {len(wrong)}")
    print(f"  errors in pages                           {len(errors)}")
    print(f"  tracebacks in the server's log            {traces}")
    print("  memory of the server")
    for when, size in told:
        print(f"    {when:38} {size:6.0f} MB")
    first, second = told[-2][1], told[-1][1]
    print(f"    the second round added {second - first:+.0f} MB, {(second - first) / first:+.1%}")
    for text in [*wrong[:10], *errors[:10]]:
        print(f"  {text}", file=sys.stderr)
    if traces:
        print(server[-4000:], file=sys.stderr)
    return 1 if wrong or errors or traces else 0


if __name__ == "__main__":
    sys.exit(main())
