"""The verb ``train``. torch is loaded when it runs."""

from __future__ import annotations

import argparse
import json
import os
import signal
import sys
import time
from pathlib import Path
from typing import Any

from laplace_core.agents.settings import SETTINGS
from laplace_core.cli.options import add_parameters, checked_number
from laplace_core.cli.stop import Stop
from laplace_core.environments import ENVIRONMENTS
from laplace_core.errors import InputError
from laplace_core.supervise import Process
from laplace_core.training.defaults import name_of, settings_of
from laplace_core.training.events import Checkpoint, Episode, Evaluation, Resumed, Step
from laplace_core.training.job import asked_to_stop
from laplace_core.training.progress import ProgressFile
from laplace_core.training.run_folder import read_config

REPORT_EVERY = 0.5
"""Seconds between two lines of progress."""
LOOK_EVERY = 0.5
"""Seconds between two looks for a file that asks for the end."""
_CLOCK = 2.0  # seconds by which the birth of a process is known
_RECENT = 50  # episodes in the mean return of the progress line


def add_train(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """The parser of the verb ``train``."""
    train = verbs.add_parser(
        "train",
        help="train an agent, or go on with a run",
        description="Train an agent on an environment. What is not given comes from the settings file of the "
        "algorithm and environment, else, for a tabular world, from its rewards and returns, else from the defaults "
        "below. A setting that the others make meaningless is refused.",
        usage="laplace train ALGORITHM ENVIRONMENT [settings] [--run FOLDER]\n       laplace train --resume FOLDER",
    )
    train.add_argument("algorithm", nargs="?", metavar="ALGORITHM", help=f"one of {', '.join(SETTINGS)}")
    train.add_argument("environment_name", nargs="?", metavar="ENVIRONMENT", help=f"one of {', '.join(ENVIRONMENTS)}")
    train.add_argument("--run", metavar="FOLDER", dest="folder", help="where the run is kept (default: runs/...)")
    train.add_argument("--resume", metavar="FOLDER", help="go on with the run in this folder")
    train.add_argument(
        "--disk", metavar="MEGABYTES", help="that all runs of the folder which the run's own is in may hold together"
    )
    train.add_argument("--json", action="store_true", help="print events as JSON lines")
    parameters = {p.name: p for kind in SETTINGS.values() for p in kind.SCHEMA if p.name != "environment"}
    add_parameters(train, parameters.values())
    train.set_defaults(run=run_train)


def run_train(options: argparse.Namespace) -> None:
    """Train to the end of the run."""
    from laplace_core.training.loop import train  # loads torch

    names = {p.name for kind in SETTINGS.values() for p in kind.SCHEMA}
    given = {name: value for name, value in vars(options).items() if name in names and value is not None}
    most = None if options.disk is None else 10**6 * checked_number("disk", options.disk, int, 1, high=10**8)
    if options.resume:
        if options.algorithm or options.folder or given:
            raise InputError("--resume goes on with the settings of the run: leave out everything else.")
        folder = Path(options.resume)
        settings = read_config(folder / "config.json")
    else:
        settings = settings_of(options.algorithm, options.environment_name, given)
        folder = Path(options.folder or Path("runs") / name_of(settings))
    progress = _Json() if options.json else _Line(folder, settings.steps)
    file, step = ProgressFile(folder, settings.steps), 0
    with Stop() as stop:
        asked = _Request(folder, stop)
        new = None if options.resume else settings
        for event in train(new, folder, resume=bool(options.resume), stop=asked.came, most_bytes=most):
            progress.show(event)
            step = event.step
            file.at(step)
    if step:
        file.at(step, last=True)
    progress.end()
    if stop.asked and step < settings.steps:
        print(f"stopped; laplace train --resume {folder} goes on from there", file=sys.stderr, flush=True)
        sys.stdout.flush()
        os._exit(128 + stop.asked)  # everything is written; to take torch apart would need seconds


class _Request:
    """The request to end a run, by a signal or by a file in its folder."""

    def __init__(self, folder: Path, stop: Stop):
        self._folder, self._stop = folder, stop
        self._since = Process.of(os.getpid()).started - _CLOCK
        self._looked = 0.0

    def came(self) -> bool:
        now = time.monotonic()
        if not self._stop.asked and now - self._looked >= LOOK_EVERY:
            self._looked = now
            if asked_to_stop(self._folder, self._since):
                self._stop.asked = signal.SIGTERM
        return bool(self._stop.asked)


class _Json:
    """Print every event but steps as one JSON line."""

    def show(self, event: Any) -> None:
        if not isinstance(event, Step):
            print(json.dumps({"event": type(event).__name__.lower(), **vars(event)}), flush=True)

    def end(self) -> None:
        pass


class _Line:
    """Print progress as one line that is overwritten: steps, speed, score, time left; evaluations stay."""

    def __init__(self, folder: Path, total: int):
        self.folder, self.total = folder, total
        self.started = self.reported = time.monotonic()
        self.first: int | None = None
        self.step = 0
        self.score: float | None = None
        self.returns: list[float] = []

    def show(self, event: Any) -> None:
        self.step = event.step
        self.first = event.step if self.first is None else self.first
        if isinstance(event, Episode):
            self.returns = [*self.returns[-_RECENT + 1 :], event.episode_return]
        elif isinstance(event, Resumed):
            self._say(f"step {event.step:,}: {event.message}")
        elif isinstance(event, Evaluation):
            self.score = event.score
            best = ", the best so far" if event.best else ""
            self._say(f"step {event.step:,}: {event.score:.1f} +- {event.standard_error:.1f} in evaluation{best}")
        elif isinstance(event, Checkpoint):
            return
        if time.monotonic() - self.reported >= REPORT_EVERY and sys.stderr.isatty():
            self.reported = time.monotonic()
            print(f"\r\033[K{self._words()}", end="", file=sys.stderr, flush=True)

    def _words(self) -> str:
        rate = (self.step - (self.first or 0)) / max(1e-9, time.monotonic() - self.started)
        left = (self.total - self.step) / rate if rate > 0 else float("inf")
        words = [f"{self.step:,} of {self.total:,} steps", f"{rate:,.0f} steps/s"]
        if self.returns:
            words.append(f"return {sum(self.returns) / len(self.returns):.1f}")
        if self.score is not None:
            words.append(f"score {self.score:.1f}")
        return " · ".join([*words, f"{left:.0f} s left" if left < 1e7 else "..."])

    def _say(self, line: str) -> None:
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr)
        print(line, flush=True)

    def end(self) -> None:
        self._say(f"{self.step:,} steps in {time.monotonic() - self.started:.0f} s; the run is in {self.folder}")
