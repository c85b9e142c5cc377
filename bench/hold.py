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
import subprocess
import sys
import tempfile
import time
from collections.abc import Awaitable, Callable, Iterator
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import urlencode

import numpy as np
import psutil
from websockets.exceptions import WebSocketException

from app.session.link import pack
from bench.__main__ import show
from bench.report import Figure, Goal, tally
from bench.serving import ROOT, Server, serving, tree_of
from bench.timing import Spread
from bench.visitor import Broken, Visitor, visit
from laplace_core import InputError
from laplace_core.files.tensor_file import read_tensors
from laplace_core.training.defaults import settings_of
from laplace_core.training.progress import read_progress
from laplace_core.training.queue import Queue
from laplace_core.training.run_folder import MAX_RESUME_BYTES

BUDGET = 2500
"""Megabytes that the server and all that it starts may take."""
OLD = "674dbb3"
"""The commit of version 0.2.0, which sessions are compared with."""
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


def _train(folder: Path) -> list[subprocess.Popen[bytes]]:
    """Two trainings of low priority."""
    command = [sys.executable, "-m", "laplace_core", "train", "dqn", "CartPole-v1", "--run"]
    return [
        subprocess.Popen(["nice", "-n", "19", *command, str(folder / name)], cwd=ROOT, stdout=subprocess.DEVNULL)
        for name in ("one", "two")
    ]


def sessions(*, short: bool, minutes: float = 10.0) -> Iterator[Figure]:
    users, rounds, seconds = (4, 1, 3.0) if short else (50, 4, minutes * 60 / 8)
    with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as stack:
        new = stack.enter_context(serving(ROOT, BUDGET))
        old = stack.enter_context(serving(tree_of(OLD, Path(folder) / "old"), None))
        trainings = _train(Path(folder))
        told = {new: Told(), old: Told()}
        spent, memory = dict.fromkeys(told, 0.0), []
        try:
            for server in told:  # warm up
                asyncio.run(_crowd(server, len(_WORLDS), 0.0, Told()))
            for turn in range(rounds):
                for server in (new, old) if turn % 2 == 0 else (old, new):
                    before = server.spent
                    asyncio.run(_crowd(server, users, seconds, told[server]))
                    spent[server] += server.spent - before
                    if server is new:
                        memory.append(server.memory)
        finally:
            for training in trainings:
                training.terminate()
            for training in trainings:
                training.wait()
        sizes = f"{users} sessions, {rounds} x {seconds:.0f} s each, in turns with 0.2.0, beside two trainings"
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
        note = f"{ends[new]:.2f} s against {ends[old]:.2f} s; {answers} answers"
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
                        if visitor.button("Race") is not None:  # a race that takes long waits for its button
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


def kills(*, short: bool) -> Iterator[Figure]:
    """A training is killed at random moments and resumed: what it had saved is there, and every file is whole."""
    count, chance = (3 if short else 200), random.Random(0)
    lost = broken = orphans = step = points = 0
    with tempfile.TemporaryDirectory() as folder:
        queue = Queue(Path(folder) / "runs")
        name = queue.add(settings_of("dqn", "CartPole-v1", {"steps": 1_000_000, "checkpoint_every": 500}))
        run = queue.folder / name
        command = [sys.executable, "-m", "laplace_core", "train", "--resume", str(run)]
        for _ in range(count):
            seen = read_progress(run)
            process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            while process.poll() is None and read_progress(run) == seen:
                time.sleep(0.05)
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(chance.uniform(0.0, 3.0))
            children = psutil.Process(process.pid).children(recursive=True) if process.poll() is None else []
            process.kill()
            process.wait()
            orphans += len(psutil.wait_procs(children, 30)[1])
            broken += sum(not _is_json(path) for path in run.glob("*.json"))
            point = run / "resume.safetensors"
            if point.exists():
                try:
                    about = read_tensors(point, MAX_RESUME_BYTES)[1]
                except InputError:
                    broken += 1
                    continue
                points += about["step"] > step
                lost += about["step"] < step or (run / "metrics.jsonl").stat().st_size < about["metrics_bytes"]
                step = about["step"]
        sizes = f"{count} kills of a training, at once to three seconds after it has gone on"
        note = f"{points} resume points, the last at step {step:,}"
        yield counted("Kills", "went back behind a resume point", lost, Goal("<=", 0), sizes=sizes, note=note)
        yield counted("Kills", "files half-written", broken, Goal("<=", 0), sizes=sizes)
        yield counted("Kills", "processes left after 30 s", orphans, Goal("<=", 0), sizes=sizes)


def _is_json(path: Path) -> bool:
    try:
        json.loads(path.read_text())
    except ValueError:
        return False
    return True


# ---- what nobody means well by


def hostile(*, short: bool) -> Iterator[Figure]:
    if find_spec("bench.hostile") is None:
        print("hostile links and files skipped: there is no bench/hostile.py")
        return
    from bench.hostile import files, links

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
        sizes = f"{many} links and {some} files, {server.limited}"
        yield counted(
            "Hostile", "pages that died", len(told.wrong), Goal("<=", 0), sizes=sizes, note="; ".join(told.wrong[:5])
        )
        yield counted("Hostile", "tracebacks in the log", server.log.count("Traceback"), Goal("<=", 0), sizes=sizes)
        yield counted("Hostile", "largest memory, MB", server.peak, Goal("<=", BUDGET), sizes=sizes)
        yield counted("Hostile", "server alive at the end", float(server.alive), Goal(">=", 1), sizes=sizes)


PARTS = {"visits": visits, "sessions": sessions, "asked": asked, "kills": kills, "hostile": hostile}


def main() -> int:
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
