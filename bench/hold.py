"""Whether a server holds: heavy visits, many sessions, work asked for at once, kills, and what nobody means well by.

``python -m bench.hold [--part visits|sessions|asked|kills|hostile] [--short]`` prints figures beside their goals; exit
status 1 if one is missed. Visitors have no screen (:mod:`bench.visitor`); the server is a process of its own.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import io
import itertools
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Awaitable, Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urlencode, urlsplit

import numpy as np
import psutil
from websockets.exceptions import WebSocketException

from bench.__main__ import show
from bench.report import Figure, Goal, tally
from bench.serving import ROOT, Server, serving, tree_of
from bench.timing import Spread
from bench.visitor import Broken, Visitor, visit
from laplace_core import InputError
from laplace_core.files.packed_text import pack
from laplace_core.files.tensor_file import read_tensors
from laplace_core.tabular.files import read_learned
from laplace_core.training.run_folder import MAX_RESUME_BYTES
from tests.support.hostile_inputs import files, links

if TYPE_CHECKING:
    from playwright.sync_api import Dialog, Request

BUDGET = 2500
"""Megabytes that the server and all that it starts may take."""
OLD = "674dbb3"
"""The commit of version 0.2.0, which sessions are compared with."""
_PATIENCE = 1800.0  # seconds that trainings are given once everything else is over
_LEAST = 3  # changes of a session, however slow the machine
_WORLDS = ("two_branch", "two_decisions", "rise_and_fade", "double_chain", "gym:FrozenLake-v1", "cliff_grid")
_CART, _LANDER = "laplace_CartPole-v1", "laplace_LunarLander-v3"
FAULTS = (Broken, OSError, WebSocketException)
"""What may end a visit; each is counted and told at the end."""
_GENERIC = "encountered an error"  # what Streamlit shows where a page has died


def once(value: float) -> Spread:
    return Spread(value, value, value, 1)


def p95(seconds: list[float]) -> float:
    return float(np.quantile(seconds, 0.95)) if seconds else float("nan")


def counted(subject: str, name: str, value: float, goal: Goal | None, *, sizes: str, note: str = "") -> Figure:
    return Figure(subject, name, once(value), "", sizes, goal, note)


# ---- ordinary sessions


@dataclass
class Told:
    """What visitors have met: seconds of their answers, and what went wrong."""

    seconds: list[float] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)

    def look(self, visitor: Visitor, what: str) -> None:
        """Note a page that has died."""
        if any(_GENERIC in text for text in visitor.texts("exception")):
            self.wrong.append(f"{what}: the page has died")


async def change(visitor: Visitor, chance: random.Random, told: Told) -> None:
    """One ordinary change, timed: the lens, or a link."""
    alpha, began = float(f"{10 ** chance.uniform(-3, 0.3):.3g}"), time.perf_counter()
    if chance.random() < 0.5:
        await visitor.move_lens(alpha=alpha)
    else:
        await visitor.go(urlencode({"world": chance.choice(_WORLDS), "alpha": alpha}))
    told.seconds.append(time.perf_counter() - began)
    told.look(visitor, f"alpha {alpha} in {visitor.query}")


async def ordinary(address: str, number: int, told: Told, *, until: Callable[[], bool], pause: float) -> None:
    """A session that changes something now and then."""
    chance = random.Random(number)
    try:
        async with visit(address) as visitor:
            await visitor.open("worlds", urlencode({"world": chance.choice(_WORLDS)}))
            for count in itertools.count():
                if count >= _LEAST and until():
                    break
                await asyncio.sleep(chance.uniform(0, 2 * pause))
                await change(visitor, chance, told)
    except FAULTS as error:
        told.wrong.append(f"session {number}: {type(error).__name__} {error}")


async def give(visitor: Visitor, page: str, name: str, data: bytes) -> None:
    """Open a page and give it a file."""
    await visitor.open(page)
    if page == "worlds":
        await visitor.unfold("Bring your own")
    await visitor.upload("", name, data)


# ---- heavy visits


def _own_world(actions: int, rewards: int = 1) -> str:
    rows = [
        {"state": "s", "action": f"a{i}", "next": {"s": 0.9, "END": 0.1},
         "reward": {str(float(i + 1 + j)): 1 / rewards for j in range(rewards)}}
        for i in range(actions)
    ]  # fmt: skip
    world = {"name": "own", "states": ["s"], "actions": [f"a{i}" for i in range(actions)], "start": {"s": 1.0}}
    return json.dumps({**world, "transitions": rows})


def _wide_npz() -> bytes:
    file, thetas = io.BytesIO(), np.linspace(0, 1, 45_000)
    values = np.linspace(1, 0, 45_000) * np.ones((1, 2, 1))
    np.savez_compressed(file, gamma_space=values, gammas=np.array([0.5, 0.9]), thetas=thetas)
    return file.getvalue()


Deed = Callable[[Visitor], Awaitable[None]]
"""What one visitor does."""


def _link(page: str, begin: str = "", **query: object) -> Deed:
    """Open a link, and press the button that begins its work, where one is there and can be pressed."""

    async def follow(visitor: Visitor) -> None:
        await visitor.open(page, urlencode(query))
        if begin and visitor.button(begin) is not None:
            await visitor.press(begin)

    return follow


def _file(name: str, data: bytes) -> Deed:
    return lambda visitor: give(visitor, "worlds", name, data)


def heavy_visits(count: int) -> Iterator[tuple[str, Deed]]:
    """Names and deeds of visitors at the largest settings, every kind in turn.

    A study of two actions at 2000 x 2000 is nearly the largest that a page takes; one of twelve is beyond it.
    """
    allowed, beyond, wide, rewards = pack(_own_world(2)), pack(_own_world(12)), _wide_npz(), _own_world(2, 20_000)
    large = (_own_world(1) + " " * 28_000_000).encode()
    for i in range(count):
        alpha = 0.01 * (i + 1)
        largest = {"world": "own", "own": allowed, "thetas": 2000, "steps": 2000, "alpha": alpha}
        pinned = pack(json.dumps({key: str(value) for key, value in {**largest, "alpha": alpha / 2}.items()}))
        race = {"checkpoint": _LANDER, "d.T": 1000, "d.left": "decoded", "d.many": "yes", "d.starts": 500}
        learners = {"world": "cliff_grid", "source": "learned", "l.seeds": 8, "l.episodes": 10**6, "l.seed": i}
        rollout = {"checkpoint": _LANDER, "r.rule": "decoded", "r.seed": i}
        kinds = [
            ("own world, 2 actions, 2000 x 2000", _link("worlds", **largest)),
            ("the same, pinned", _link("worlds", **largest, pin=pinned)),
            ("own world, 12 actions, 2000 x 2000", _link("worlds", **{**largest, "own": beyond})),
            ("NPZ of 45,000 sensitivities", _file("wide.npz", wide)),
            ("world of 40,000 rewards", _file("rewards.json", rewards.encode())),
            ("world of 28 MB", _file("large.json", large)),
            ("race of 500 starts", _link("race", "Race over", **race)),
            ("8 learners", _link("worlds", "Learn", **learners)),
            ("a long rollout", _link("agents", "Roll out", **rollout)),
        ]
        yield kinds[i % len(kinds)]


def visits(*, short: bool) -> Iterator[Figure]:
    count, quiet_changes, patience = (9, 8, 15.0) if short else (40, 40, 120.0)
    with serving(ROOT, BUDGET) as server:
        quiet, beside, answered = Told(), Told(), Told()
        refused: list[str] = []

        async def run() -> None:
            async with visit(server.address, patience=patience) as other:
                chance = random.Random(0)
                await other.open("worlds", "world=two_branch")
                for _ in range(quiet_changes):
                    await change(other, chance, quiet)
                over = asyncio.Event()

                async def work() -> None:
                    chance = random.Random(0)
                    while not over.is_set():
                        await change(other, chance, beside)
                        await asyncio.sleep(0.2)

                working = asyncio.create_task(work())
                room = asyncio.Semaphore(4)

                async def one(name: str, deed: Deed) -> None:
                    async with room:
                        try:
                            async with visit(server.address, patience=patience) as visitor:
                                began = time.perf_counter()
                                await deed(visitor)
                                answered.seconds.append(time.perf_counter() - began)
                                answered.look(visitor, name)
                                said = visitor.texts("alert")
                                refused.extend(said)
                                if not (said or visitor.of_kind("bidi_component") or visitor.of_kind("progress")):
                                    answered.wrong.append(f"{name}: shows nothing")
                        except FAULTS as error:
                            answered.wrong.append(f"{name}: {type(error).__name__} {error}")

                await asyncio.gather(*(one(*visit_) for visit_ in heavy_visits(count)))
                over.set()
                with contextlib.suppress(*FAULTS):
                    await working

        asyncio.run(run())
        what = f"{count} heavy visits, 4 at a time, {server.limited}"
        yield counted("Visits", "server alive at the end", float(server.alive), Goal(">=", 1), sizes=what)
        yield counted("Visits", "largest memory, MB", server.peak, Goal("<=", BUDGET), sizes=what)
        wrong = [*answered.wrong, *beside.wrong]
        yield counted(
            "Visits", "neither answered nor refused", len(wrong), Goal("<=", 0), sizes=what, note="; ".join(wrong[:5])
        )
        yield counted(
            "Visits", "answered", len(answered.seconds), None, sizes=what, note=f"{len(refused)} sentences said why not"
        )
        ratio = p95(beside.seconds) / p95(quiet.seconds)
        sizes = f"{len(beside.seconds)} changes beside, {len(quiet.seconds)} alone"
        yield counted("Visits", "p95 of another session, beside / alone", ratio, Goal("<=", 2), sizes=sizes)


# ---- many sessions


async def _crowd(server: Server, users: int, seconds: float, told: Told) -> None:
    end = time.monotonic() + seconds
    await asyncio.gather(
        *(ordinary(server.address, i, told, until=lambda: time.monotonic() > end, pause=2.0) for i in range(users))
    )


def _train(folder: Path, steps: int) -> list[subprocess.Popen[bytes]]:
    """Two trainings of low priority, long enough to last until the sessions end."""
    command = ["nice", "-n", "19", sys.executable, "-m", "laplace_core", "train", "dqn", "CartPole-v1"]
    return [
        subprocess.Popen(
            [*command, "--steps", str(steps), "--run", str(folder / name)], cwd=ROOT, stdout=subprocess.DEVNULL
        )
        for name in ("one", "two")
    ]


async def _race(server: Server, starts: int, patience: float) -> bool:
    """A race of many starts; whether its page shows the result in the end."""
    query = {"checkpoint": _CART, "d.T": 200, "d.left": "decoded", "d.many": "yes", "d.starts": starts}
    async with visit(server.address, patience=120) as visitor:
        await visitor.open("race", urlencode(query))
        if visitor.button("Race over") is not None:
            await visitor.press("Race over")
        return await _until_done(visitor, patience)


async def _simulation(server: Server, agent: str, patience: float) -> bool:
    """A rollout and the simulated continuations of one of its states; whether the page shows them in the end."""
    async with visit(server.address, patience=120) as visitor:
        await visitor.open("agents", urlencode({"checkpoint": agent}))
        await visitor.press("Roll out")
        if not await _until_done(visitor, patience):
            return False
        await visitor.press("Simulate")
        return await _until_done(visitor, patience)


def _beside(server: Server, finished: dict[str, bool], *, short: bool) -> threading.Thread:
    """A race and a simulation in sessions of their own, begun now; what has finished is noted."""
    agent, starts, patience = (_CART, 20, 60.0) if short else (_LANDER, 500, 1800.0)

    async def both() -> None:
        async def one(name: str, work: Awaitable[bool]) -> None:
            try:
                finished[name] = await work
            except FAULTS as error:
                finished[f"{name}: {type(error).__name__} {error}"] = False

        race = one("race", _race(server, starts, patience))
        await asyncio.gather(race, one("simulation", _simulation(server, agent, patience)))

    thread = threading.Thread(target=lambda: asyncio.run(both()), daemon=True)
    thread.start()
    return thread


def sessions(*, short: bool, minutes: float = 10.0) -> Iterator[Figure]:
    users, rounds, seconds = (4, 1, 3.0) if short else (50, 4, minutes * 60 / 8)
    with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as stack:
        new = stack.enter_context(serving(ROOT, BUDGET))
        old = stack.enter_context(serving(tree_of(OLD, Path(folder) / "old"), None))
        trainings = _train(Path(folder), 2_000 if short else 40_000)
        told, finished = {new: Told(), old: Told()}, {new: dict[str, bool](), old: dict[str, bool]()}
        spent, memory, rounds_of = dict.fromkeys(told, 0.0), [], {new: list[str](), old: list[str]()}
        try:
            for server in told:  # warm up
                asyncio.run(_crowd(server, len(_WORLDS), 0.0, Told()))
            beside = [_beside(server, finished[server], short=short) for server in told]
            for turn in range(rounds):
                for server in (new, old) if turn % 2 == 0 else (old, new):
                    before, answered = server.spent, len(told[server].seconds)
                    asyncio.run(_crowd(server, users, seconds, told[server]))
                    spent[server] += server.spent - before
                    rounds_of[server].append(f"{p95(told[server].seconds[answered:]):.2f}")
                    if server is new:
                        memory.append(server.memory)
            beside[0].join()  # whether those of 0.2.0 ever finish is not ours
            done = finished[new] | {f"training {i}": each.wait(_PATIENCE) == 0 for i, each in enumerate(trainings, 1)}
        finally:
            for training in trainings:
                training.kill()
                training.wait()
        sizes = (
            f"{users} sessions, {rounds} x {seconds:.0f} s each, in turns with 0.2.0, "
            "beside two trainings, a race and a simulation"
        )
        note = "; ".join(f"{name} {'finished' if well else 'did not finish'}" for name, well in done.items())
        yield counted(
            "Sessions", "background works that finished", sum(done.values()), Goal(">=", 4), sizes=sizes, note=note
        )
        wrong = told[new].wrong
        yield counted("Sessions", "errors", len(wrong), Goal("<=", 0), sizes=sizes, note="; ".join(wrong[:5]))
        per = {server: 1e3 * spent[server] / max(len(told[server].seconds), 1) for server in told}
        note = f"{per[new]:.0f} ms against {per[old]:.0f} ms"
        yield counted(
            "Sessions",
            "server time an answer / that of 0.2.0",
            per[new] / per[old],
            Goal("<=", 0.5),
            sizes=sizes,
            note=note,
        )
        ends = {server: p95(told[server].seconds) for server in told}
        answers = " and ".join(str(len(told[server].seconds)) for server in (new, old))
        each = " and ".join(", ".join(rounds_of[server]) for server in (new, old))
        note = f"{ends[new]:.2f} s against {ends[old]:.2f} s; {answers} answers; by round {each} s"
        yield counted("Sessions", "p95 / that of 0.2.0", ends[new] / ends[old], Goal("<=", 0.5), sizes=sizes, note=note)
        if len(memory) > 1:
            rise = memory[-1] / memory[-2]
            note = ", ".join(f"{m:.0f}" for m in memory)
            yield counted(
                "Sessions",
                "memory, last round / the one before",
                rise,
                Goal("<=", 1.05),
                sizes=sizes,
                note=f"{note} MB",
            )


# ---- work asked for at once


async def _until_done(visitor: Visitor, patience: float) -> bool:
    """Wait until the page shows no bar of progress any more."""
    end = time.monotonic() + patience
    while time.monotonic() < end:
        kinds = {place.element.WhichOneof("type") for place in visitor.shown.values()}
        if "progress" not in kinds:
            return True
        await asyncio.sleep(0.2)
    return False


def asked(*, short: bool) -> Iterator[Figure]:
    rollouts, races, patience = (3, 2, 60.0) if short else (30, 20, 900.0)
    with serving(ROOT, BUDGET) as server:
        done, told = [], Told()

        async def one(i: int) -> None:
            try:
                async with visit(server.address, patience=120) as visitor:
                    if i < rollouts:
                        await visitor.open("agents", urlencode({"checkpoint": _CART, "r.seed": i}))
                        await visitor.press("Roll out")
                    else:
                        await visitor.open("race", urlencode({"checkpoint": _CART, "d.T": 20, "d.start": i}))
                        if visitor.has_button("Race"):  # a race that takes long waits for its button
                            await visitor.press("Race")
                    if await _until_done(visitor, patience):
                        visitor.component("laplace_player" if i < rollouts else "laplace_track")
                        done.append(i)
                    told.look(visitor, f"work {i}")
            except FAULTS as error:
                told.wrong.append(f"work {i}: {type(error).__name__} {error}")

        async def everyone() -> None:
            await asyncio.gather(*(one(i) for i in range(rollouts + races)))

        asyncio.run(everyone())
        sizes = f"{rollouts} rollouts and {races} races, each of a session of its own"
        yield counted(
            "Asked", "finished", len(done), Goal(">=", rollouts + races), sizes=sizes, note="; ".join(told.wrong[:5])
        )


# ---- kills


@dataclass(frozen=True)
class Victim:
    """Work that is killed again and again, and goes on where it was.

    Attributes:
        command: of ``laplace``, for the next start.
        points: by name, how far what is saved reaches, which may never go back; it raises InputError or ValueError
            where a file is half-written.
    """

    name: str
    command: Callable[[], list[str]]
    points: Callable[[], dict[str, float]]


def _training_points(runs: Path) -> dict[str, float]:
    """Steps of the resume points under a folder, and bytes that their metrics lack."""
    found: dict[str, float] = {}
    for path in runs.rglob("*.json"):
        json.loads(path.read_text())
    for path in runs.rglob("resume.safetensors"):
        about = read_tensors(path, MAX_RESUME_BYTES)[1]
        found[str(path)] = about["step"]
        lacking = about["metrics_bytes"] - (path.parent / "metrics.jsonl").stat().st_size
        found[f"metrics of {path}"] = -max(0, lacking)  # 0 at first, as it is to stay
    return found


def _table_points(table: Path) -> dict[str, float]:
    """Rows of a table that are whole; what a kill has cut short after them is written again."""
    if not table.exists():
        return {}
    lines = table.read_text().splitlines(keepends=True)
    return {"rows": sum(line.endswith("\n") and line.count(",") >= lines[0].count(",") for line in lines)}


def _learned_points(file: Path) -> dict[str, float]:
    """Whether there is a snapshot; it has to be whole. A learner that was killed begins again."""
    if not file.exists():
        return {}
    read_learned(file)
    return {"snapshot": 1.0}


def victims(folder: Path) -> list[Victim]:
    """Training, search, study and learning, each too long to end by itself."""
    run, found, table, learned = folder / "run", folder / "search", folder / "s.csv", folder / "l.safetensors"
    training = ["train", "dqn", "CartPole-v1", "--steps", "1000000", "--checkpoint-every", "500", "--run", str(run)]
    resume = ["train", "--resume", str(run)]
    searching = ["search", "dqn", "CartPole-v1", "--set", "steps=1000000", "--set", "checkpoint_every=500"]
    searching += ["--seeds", "2", "--jobs", "2", "--runs", str(found)]
    studying = ["study", "--worlds", "1000", "--jobs", "2", "--out", str(table)]
    learning = ["learn", "cliff_grid", "--episodes", "1000000", "--seeds", "2", "--out", str(learned)]
    return [
        Victim("training", lambda: resume if run.exists() else training, lambda: _training_points(run)),
        Victim("search", lambda: searching, lambda: _training_points(found)),
        Victim("study", lambda: studying, lambda: _table_points(table)),
        Victim("learning", lambda: learning, lambda: _learned_points(learned)),
    ]


@dataclass
class _Harm:
    """What kills have done: points that went back, files half-written, processes left; and how far all went."""

    back: int = 0
    broken: int = 0
    left: int = 0
    reached: list[str] = field(default_factory=list)


def _end(process: subprocess.Popen[bytes], harm: _Harm) -> None:
    """Kill a process, and count its children that are there 30 seconds later."""
    try:
        children = psutil.Process(process.pid).children(recursive=True)
    except psutil.NoSuchProcess:
        children = []
    process.kill()
    process.wait()
    left = psutil.wait_procs(children, 30)[1]
    harm.left += len(left)
    for child in left:
        child.kill()


def _kill_again(victim: Victim, count: int, chance: random.Random, harm: _Harm, *, latest: float) -> None:
    reached = dict[str, float]()
    for _ in range(count):
        command = [sys.executable, "-m", "laplace_core", *victim.command()]
        process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(chance.uniform(0.5, latest))
        _end(process, harm)
        try:
            points = victim.points()
        except (InputError, ValueError):
            harm.broken += 1
            continue
        harm.back += sum(points.get(name, -1.0) < before for name, before in reached.items())
        reached = points
    harm.reached.append(f"{victim.name} to {max(reached.values(), default=0):,.0f}")


def _kill_servers(count: int, chance: random.Random, harm: _Harm) -> None:
    """Servers that a learner runs on are killed; the learner has to end with them."""

    async def learn(server: Server, seed: int) -> None:
        async with visit(server.address) as visitor:
            wanted = {"world": "cliff_grid", "source": "learned", "l.episodes": 20_000, "l.seed": seed}
            await visitor.open("worlds", urlencode(wanted))
            await visitor.press("Learn")
            await asyncio.sleep(chance.uniform(0.0, 3.0))

    for seed in range(count):
        with serving(ROOT, None) as server:
            asyncio.run(learn(server, seed))
            _end(server.process, harm)
            runs = server.log_file.parent / "runs"
            try:
                _training_points(runs)
            except (InputError, ValueError):
                harm.broken += 1


def kills(*, short: bool) -> Iterator[Figure]:
    """Work is killed at random moments and begun again: what it had saved is there, and every file is whole."""
    each, latest, chance, harm = (1 if short else 40), (3.0 if short else 15.0), random.Random(0), _Harm()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        listed = victims(Path(folder))
        for victim in listed:
            _kill_again(victim, each, chance, harm, latest=latest)
    _kill_servers(each, chance, harm)
    names = ", ".join([victim.name for victim in listed] + ["server"])
    sizes = f"{each * (len(listed) + 1)} kills in all, of {names} alike, half a second to {latest:.0f} after each start"
    note = ", ".join(harm.reached)
    yield counted("Kills", "went back behind a resume point", harm.back, Goal("<=", 0), sizes=sizes, note=note)
    yield counted("Kills", "files half-written", harm.broken, Goal("<=", 0), sizes=sizes)
    yield counted("Kills", "processes left after 30 s", harm.left, Goal("<=", 0), sizes=sizes)


# ---- what nobody means well by


def hostile(*, short: bool) -> Iterator[Figure]:
    many, some = (12, 6) if short else (300, 100)
    with serving(ROOT, BUDGET) as server:
        told = Told()

        async def one(what: str, page: str, deed: Deed) -> None:
            try:
                async with visit(server.address, patience=60) as visitor:
                    await deed(visitor)
                    told.look(visitor, f"{page} {what}")
            except FAULTS as error:
                told.wrong.append(f"{page} {what}: {type(error).__name__} {error}")

        async def everything() -> None:
            for link in links(many, 0):
                path, _, query = link.lstrip("/").partition("?")
                page = path or "worlds"
                await one(query[:80], page, lambda v, page=page, query=query: v.open(page, query))
            for file in files(some, 0):
                page = file.page or "worlds"
                await one(file.name[:80], page, lambda v, page=page, file=file: give(v, page, file.name, file.content))

        asyncio.run(everything())
        seen = _in_chromium(server.address, links(2 if short else 60, 1))
        if seen is None:
            print("links in a browser skipped: there is no Chromium")
        else:
            opened, wrong = seen
            words = f"{opened} links in Chromium"
            yield counted("Hostile", "requests to other hosts, and scripts", len(wrong), Goal("<=", 0), sizes=words,
                          note="; ".join(wrong[:5]))  # fmt: skip
        sizes = f"{many} links and {some} files, {server.limited}"
        yield counted(
            "Hostile", "pages that died", len(told.wrong), Goal("<=", 0), sizes=sizes, note="; ".join(told.wrong[:5])
        )
        yield counted("Hostile", "tracebacks in the log", server.log.count("Traceback"), Goal("<=", 0), sizes=sizes)
        yield counted("Hostile", "largest memory, MB", server.peak, Goal("<=", BUDGET), sizes=sizes)
        yield counted("Hostile", "server alive at the end", float(server.alive), Goal(">=", 1), sizes=sizes)


def _in_chromium(address: str, links: list[str]) -> tuple[int, list[str]] | None:
    """How many links a browser has opened, and its requests to other hosts and dialogs of scripts; None without one."""
    from playwright.sync_api import sync_playwright

    from tests.browser.support import FLAGS, find_chromium

    chromium, wrong = find_chromium(), list[str]()
    if chromium is None:
        return None

    def note(request: Request) -> None:
        asked = urlsplit(request.url)
        if asked.scheme not in ("data", "blob") and asked.netloc != urlsplit(address).netloc:
            wrong.append(f"asked {request.url[:80]}")

    def dismiss(dialog: Dialog) -> None:
        wrong.append(f"said {dialog.message[:80]}")
        dialog.dismiss()

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS)
        page = browser.new_page()
        page.on("request", note)
        page.on("dialog", dismiss)
        for link in links:
            page.goto(f"{address}{link}")
            page.wait_for_selector("[data-testid=stApp][data-test-script-state=notRunning] [data-testid=stSidebar]")
            page.wait_for_load_state("networkidle")  # pictures of another host would be asked for by now
        browser.close()
    return len(links), wrong


PARTS = {"visits": visits, "sessions": sessions, "asked": asked, "kills": kills, "hostile": hostile}


def main() -> int:
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that servers and trainings end with it
    parser = argparse.ArgumentParser(prog="python -m bench.hold", description="Whether a server holds.")
    parser.add_argument("--part", choices=PARTS, help="run one part")
    parser.add_argument("--short", action="store_true", help="a few of everything")
    parser.add_argument("--minutes", type=float, default=10.0, help="that sessions take in all")
    options = parser.parse_args()
    figures: list[Figure] = []
    for name, part in PARTS.items():
        if options.part in (None, name):
            more = {"minutes": options.minutes} if name == "sessions" else {}
            figures += show(part(short=options.short, **more))
    print(f"\n{tally(figures)}")
    return int(any(figure.met is False for figure in figures))


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    sys.exit(main())
