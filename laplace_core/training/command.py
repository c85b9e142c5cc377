"""The verbs ``train`` and ``evaluate``. torch is loaded when one of them runs, not when the others do."""

from __future__ import annotations

import argparse
import json
import os
import signal
import sys
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from laplace_core.agents.capabilities import HasAtoms
from laplace_core.agents.settings import SETTINGS, LoopSettings
from laplace_core.environments import ENVIRONMENTS, GYMNASIUM
from laplace_core.errors import InputError
from laplace_core.parameters import as_text
from laplace_core.settings import flag
from laplace_core.training.events import Checkpoint, Episode, Evaluation, Resumed, Step
from laplace_core.training.progress import ProgressFile
from laplace_core.training.run_folder import read_config
from laplace_core.words import add_parameters, checked_number

if TYPE_CHECKING:  # these bring torch along
    from laplace_core.agents.agent import Agent
    from laplace_core.training.evaluation import Scores

REPORT_EVERY = 0.5
"""Seconds between two lines of progress."""
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
    train.add_argument("--json", action="store_true", help="print events as JSON lines")
    parameters = {p.name: p for kind in SETTINGS.values() for p in kind.SCHEMA if p.name != "environment"}
    add_parameters(train, parameters.values())
    train.set_defaults(run=run_train)


def run_train(options: argparse.Namespace) -> None:
    """Train to the end of the run."""
    from laplace_core.training.loop import train  # loads torch

    names = {p.name for kind in SETTINGS.values() for p in kind.SCHEMA}
    given = {name: value for name, value in vars(options).items() if name in names and value is not None}
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
        new = None if options.resume else settings
        for event in train(new, folder, resume=bool(options.resume), stop=lambda: bool(stop.asked)):
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


class Stop:
    """Asks a run to end at its next step on SIGTERM or Ctrl-C; the second one ends it at once.

    Attributes:
        asked: the number of the signal; 0 before there was one.
    """

    def __init__(self) -> None:
        self.asked = 0
        self._before: dict[int, Any] = {}

    def __enter__(self) -> Stop:
        if threading.current_thread() is threading.main_thread():  # no other may listen
            self._before = {number: signal.signal(number, self._ask) for number in (signal.SIGTERM, signal.SIGINT)}
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)
        self._before = {}

    def _ask(self, number: int, _: object) -> None:
        self.asked = number
        self.__exit__()


def name_of(settings: LoopSettings) -> str:
    """What the folder of a run is called by default."""
    return f"{settings.ALGORITHM}_{settings.environment.replace(':', '-')}_{settings.seed}"


def command_of(settings: LoopSettings, folder: str) -> list[str]:
    """The words after ``laplace`` that train with these settings: only what its files do not say already."""
    usual = settings_of(settings.ALGORITHM, settings.environment, {}).as_dict()
    words = ["train", settings.ALGORITHM, settings.environment]
    for parameter in settings.SCHEMA:
        value = getattr(settings, parameter.name)
        if value != usual[parameter.name] and parameter.name not in settings.unheard():
            words += [flag(parameter), as_text(value)]
    return [*words, "--run", folder]


def settings_of(algorithm: str | None, environment: str | None, given: dict[str, Any]) -> LoopSettings:
    """Settings for an algorithm and environment: its file's, with those given in their place.

    Raises:
        InputError: an unknown algorithm, environment or setting, a value out of its range, or a given setting that
            changes nothing beside the others.
    """
    from laplace_core.training.tuned import tuned_settings

    if algorithm not in SETTINGS:
        raise InputError(f"the algorithm must be one of {', '.join(SETTINGS)}, not {str(algorithm)[:40]!r}.")
    if environment not in ENVIRONMENTS:
        raise InputError(f"the environment must be one of {', '.join(ENVIRONMENTS)}, not {str(environment)[:40]!r}.")
    if given.get("environment", environment) != environment:
        raise InputError("the environment is named once, behind the algorithm: it is no setting besides.")
    kind = SETTINGS[algorithm]
    suits = tuned_settings(algorithm, environment)
    if not suits and environment not in GYMNASIUM:
        suits = kind.suited_to(environment)
    settings = kind.parse(suits | given | {"environment": environment})
    for name, reason in settings.unheard().items():
        if name in given:
            raise InputError(f"{name} changes nothing {reason}: leave it out.")
    return settings


class _Json:
    """One JSON line an event that says something."""

    def show(self, event: Any) -> None:
        if not isinstance(event, Step):
            print(json.dumps({"event": type(event).__name__.lower(), **vars(event)}), flush=True)

    def end(self) -> None:
        pass


class _Line:
    """One line that is written over: steps, speed, score, time left; evaluations stay."""

    def __init__(self, folder: Path, total: int):
        self.folder, self.total = folder, total
        self.started = self.shown = time.monotonic()
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
        if time.monotonic() - self.shown >= REPORT_EVERY and sys.stderr.isatty():
            self.shown = time.monotonic()
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


def own_discount(agent: Agent) -> np.ndarray | None:
    """The discount of the return that an agent's fixed atoms stand for, ``(1,)``; None where it has none."""
    return np.array([agent.acting_discount]) if isinstance(agent, HasAtoms) else None


def return_notes(agent: Agent, scores: Scores) -> list[str]:
    """Whether atoms reach the returns that came, in a sentence if not.

    Args:
        scores: with the discounted returns at :func:`own_discount`.
    """
    if not isinstance(agent, HasAtoms):
        return []
    low, high = float(agent.atoms[0]), float(agent.atoms[-1])
    came = scores.discounted[:, 0]
    outside = int(np.count_nonzero((came < low) | (came > high)))
    if not outside:
        return []
    return [
        f"{outside} of {came.size} discounted returns, which were {came.min():.1f} to {came.max():.1f}, lie outside "
        f"the atoms of this agent, {low:g} to {high:g}: set v_min and v_max wider"
    ]


def add_evaluate(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """The parser of the verb ``evaluate``."""
    evaluate = verbs.add_parser(
        "evaluate",
        help="how well a checkpoint acts",
        description="Whole episodes without exploration, from start seeds that are never trained on.",
    )
    evaluate.add_argument("checkpoint", metavar="CHECKPOINT", help="a .safetensors file of a trained agent")
    evaluate.add_argument("--episodes", default="100", metavar="N", help="how many (default: 100)")
    evaluate.add_argument("--seed", default="0", metavar="N", help="which start seeds (default: 0)")
    evaluate.add_argument("--horizon", metavar="T", help="act for an episode of T steps, by the time to go")
    evaluate.add_argument(
        "--softness",
        metavar="W",
        help="of readout and decoded: width of the deadline over the time to go (default: .2)",
    )
    evaluate.add_argument("--alpha", metavar="A", help="of readout and decoded: regularisation (default: 1)")
    evaluate.add_argument(
        "--rule",
        metavar="NAME",
        help="greedy, matched (the discount nearest to the time to go), fading, readout, decoded (the same, slowly) or "
        "own (of fixed_horizon); default: with a horizon fading or own where the agent can, else greedy",
    )
    evaluate.add_argument("--stretch", metavar="C", help="of fading: its time constant / the time to go (default: 1.5)")
    evaluate.add_argument("--json", action="store_true", help="print JSON, with every return")
    evaluate.set_defaults(run=run_evaluate)


def run_evaluate(options: argparse.Namespace) -> None:
    """Evaluate one checkpoint."""
    episodes = checked_number("episodes", options.episodes, int, 1, high=100_000)
    seed = checked_number("seed", options.seed, int, 0, high=10**6)
    told_rule: dict[str, Any] = {
        name: checked_number(name, getattr(options, name), float, low, high=high)
        for name, low, high in (("softness", 0.0, 10.0), ("alpha", 1e-9, 1e6), ("stretch", 1e-2, 100.0))
        if getattr(options, name) is not None
    }
    horizon = None if options.horizon is None else checked_number("horizon", options.horizon, int, 1, high=10_000)
    from laplace_core.training.checkpoint import load_checkpoint  # all three load torch
    from laplace_core.training.evaluation import evaluate
    from laplace_core.training.rules import check_rule_options, suited

    loaded = load_checkpoint(options.checkpoint)
    rule = suited(loaded.agent, horizon) if options.rule is None else options.rule
    check_rule_options(rule, told_rule)
    scores = evaluate(
        loaded.agent, loaded.environment, episodes=episodes, seed=seed, horizon=horizon, rule=rule,
        discounts=own_discount(loaded.agent), **told_rule,
    )  # fmt: skip
    notes = return_notes(loaded.agent, scores)
    told = {
        "checkpoint": options.checkpoint, "algorithm": loaded.algorithm, "environment": loaded.environment,
        "rule": rule, "horizon": horizon, "episodes": episodes, "seed": seed, "mean": scores.mean,
        "standard_error": scores.standard_error, "notes": notes,
    }  # fmt: skip
    if options.json:
        print(json.dumps(told | {"returns": scores.returns.tolist(), "lengths": scores.lengths.tolist()}))
        return
    limit = "" if horizon is None else f", T = {horizon}"
    print(
        f"{loaded.algorithm} on {loaded.environment}, {rule}{limit}: {scores.mean:.2f} +- {scores.standard_error:.2f} "
        f"(standard error, {episodes} episodes), from {scores.returns.min():.1f} to {scores.returns.max():.1f}"
    )
    for note in notes:
        print(note)
