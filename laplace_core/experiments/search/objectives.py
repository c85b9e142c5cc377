"""The score of a trial of a search: its settings are trained with several seeds, side by side.

Every seed is a run of its own, in a folder that its settings name. So a trial that is taken over goes on with them, and
settings that are tried again are not trained again. After each evaluation of all seeds the trial reports the median of
their values, by which a pruner may end it.
"""

from __future__ import annotations

import contextlib
import hashlib
import itertools
import json
import time
from collections import defaultdict, deque
from collections.abc import Callable, Generator, Iterator, Sequence
from pathlib import Path
from statistics import fmean
from typing import Any

import numpy as np
import optuna

from laplace_core.agents.settings import LoopSettings
from laplace_core.errors import InputError
from laplace_core.experiments.training import evaluated, seconds_behind
from laplace_core.files.atomic import write_whole
from laplace_core.supervise import is_taken
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.training.events import Evaluation
from laplace_core.training.loop import train
from laplace_core.training.run_folder import read_config, read_metrics

EPISODES = 100
START_SEEDS = 500_000
"""Evaluations of searches take start seeds from here on; reports take those of the training seed, far below."""
LAST_EPISODES = 100
SCORE_FILE, SECONDS_FILE = "score.json", "seconds.json"
SCORE, PAPER = "score", "paper"
OBJECTIVES = {
    SCORE: f"mean return of the best checkpoint over {EPISODES} episodes from held-out start seeds",
    PAPER: f"the paper's: mean return of the last {LAST_EPISODES} episodes of training, a mean over the discounts",
}
_LOOK_EVERY = 0.5  # seconds between two looks at a run that another trial trains


def value_of(trial: optuna.Trial, settings: Sequence[LoopSettings], folder: Path, objective: str) -> float:
    """Train and score settings; the values of all seeds are attributes of the trial.

    Args:
        settings: of each seed.
        folder: the runs are in.

    Returns:
        the median over the seeds.

    Raises:
        optuna.TrialPruned: the pruner ended it.
        InputError: a run that cannot be trained or scored.
    """
    runs = [_Run(each, folder, objective) for each in settings]
    step = 0
    with contextlib.ExitStack() as open_runs:
        values = [open_runs.enter_context(contextlib.closing(run.values())) for run in runs]
        for each in itertools.zip_longest(*values):
            step = min(step + settings[0].evaluate_every, settings[0].steps)
            trial.report(float(np.median([value for value in each if value is not None])), step)
            if step < settings[0].steps and trial.should_prune():
                trial.set_user_attr("seconds", sum(run.seconds for run in runs))
                raise optuna.TrialPruned
    scores, errors = zip(*(run.score() for run in runs), strict=True)
    trial.set_user_attr("scores", list(scores))
    trial.set_user_attr("value_errors", list(errors))
    trial.set_user_attr("seconds", sum(run.seconds for run in runs))
    return float(np.median(scores))


def last_returns(events: Sequence[dict[str, Any]]) -> list[float]:
    """The paper's objective at each evaluation: the mean return of the last episodes that each discount behaved in,
    and the mean of these over the discounts.

    An agent whose discounts share their experience behaves by one of them in most episodes; a discount that has
    behaved in none yet does not count.
    """
    returns: dict[int, deque[float]] = defaultdict(lambda: deque(maxlen=LAST_EPISODES))
    values = []
    for event in events:
        if event["event"] == "Episode":
            returns[event["head"]].append(event["episode_return"])
        elif event["event"] == "Evaluation":
            means = [fmean(each) for each in returns.values()]
            values.append(fmean(means) if means else float(event["score"]))
    return values


def evaluations(events: Sequence[dict[str, Any]]) -> list[float]:
    """The scores of all evaluations while training."""
    return [float(event["score"]) for event in events if event["event"] == "Evaluation"]


_VALUES: dict[str, Callable[[Sequence[dict[str, Any]]], list[float]]] = {SCORE: evaluations, PAPER: last_returns}


def run_name(settings: LoopSettings) -> str:
    """The folder of a training of a search."""
    digest = hashlib.sha256(json.dumps(settings.as_dict(), sort_keys=True).encode()).hexdigest()[:10]
    return f"{settings.ALGORITHM}_{settings.environment.replace(':', '-')}_{digest}_{settings.seed}"


def is_finished(run: Path, settings: LoopSettings) -> bool:
    """Whether a run is trained to its end; its last checkpoint is written a moment before its last evaluation is."""
    if not (run / "last.safetensors").exists():
        return False
    events = read_metrics(run)
    return any(event["event"] == "Evaluation" and event["step"] >= settings.steps for event in events)


class _Run:
    """The training of one seed."""

    def __init__(self, settings: LoopSettings, folder: Path, objective: str):
        self.settings, self.folder, self.objective = settings, folder / run_name(settings), objective

    @property
    def _events(self) -> list[dict[str, Any]]:
        return read_metrics(self.folder)

    @property
    def seconds(self) -> float:
        """That its training took, evaluations included, without those of the other seeds meanwhile."""
        with contextlib.suppress(OSError, ValueError, KeyError, TypeError):  # not there, or not to be used
            return float(json.loads((self.folder / SECONDS_FILE).read_text())["seconds"])
        return [0.0, *seconds_behind(self._events)][-1]

    def values(self) -> Generator[float, None, None]:
        """Train to the end unless that is done; the value at each evaluation, those from before included."""
        while is_taken(self.folder):  # another trial of the same settings, or a worker that is taken for dead
            time.sleep(_LOOK_EVERY)
        there = (self.folder / "config.json").exists()
        if there and read_config(self.folder / "config.json") != self.settings:
            raise InputError(f"{self.folder} was made with other settings: name another folder.")
        given = 0
        if not is_finished(self.folder, self.settings):
            for _ in self._evaluations(resume=there):
                values = _VALUES[self.objective](self._events)[given:]
                given += len(values)
                yield from values
        yield from _VALUES[self.objective](self._events)[given:]

    def _evaluations(self, *, resume: bool) -> Iterator[Evaluation]:
        """Train to the end, and note the seconds that this takes: between two events other seeds are trained."""
        spent = self.seconds if resume else 0.0
        events = train(None if resume else self.settings, self.folder, resume=resume)
        with contextlib.closing(events):  # type: ignore[type-var]  # the loop is a generator
            began = time.perf_counter()
            for event in events:
                if isinstance(event, Evaluation):
                    spent += time.perf_counter() - began
                    write_whole(self.folder / SECONDS_FILE, json.dumps({"seconds": round(spent, 3)}).encode())
                    yield event
                    began = time.perf_counter()

    def score(self) -> tuple[float, float | None]:
        """The value of the finished run, and how far the agent's values at the starts are above observed returns."""
        if self.objective == PAPER:
            return round(last_returns(self._events)[-1], 3), None
        asked = {"episodes": EPISODES, "start_seed": START_SEEDS + self.settings.seed}
        with contextlib.suppress(OSError, ValueError, KeyError, TypeError):  # not there, or not to be used
            saved = json.loads((self.folder / SCORE_FILE).read_text())
            if {name: saved[name] for name in asked} == asked:
                return float(saved["score"]), None if saved["value_error"] is None else float(saved["value_error"])
        agent = load_checkpoint(self.folder / "best.safetensors").agent
        scores, error = evaluated(agent, self.settings.environment, asked["episodes"], asked["start_seed"])
        score, error = round(scores.mean, 3), None if error is None else round(error, 3)
        write_whole(self.folder / SCORE_FILE, json.dumps(asked | {"score": score, "value_error": error}).encode())
        return score, error
