"""A search over settings: the values of some of them that score best over several seeds, and the effect of each.

Every combination of the values is trained with every seed, or, one at a time, every value by itself against the
settings of the file. Trainings are runs in a folder: a search that was interrupted goes on with them, and a search that
asks for more uses what is there, scores included. These come from start seeds of their own, so that those of the
reports stay unseen.
"""

from __future__ import annotations

import contextlib
import hashlib
import itertools
import json
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.agents.settings import LoopSettings
from laplace_core.errors import InputError
from laplace_core.experiments.training import evaluated, seconds_behind
from laplace_core.files.atomic import write_whole
from laplace_core.supervise.parallel import in_order
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.training.defaults import settings_of
from laplace_core.training.loop import train
from laplace_core.training.run_folder import read_config, read_metrics

EPISODES = 100
START_SEEDS = 500_000
"""Evaluations of searches take start seeds from here on; reports take those of the training seed, far below."""
RESULTS = "search.json"
SCORE = "score.json"

Trial = dict[str, Any]
"""Settings that a trial changes against the file's, by name."""


def trials(varied: Mapping[str, Sequence[str]], *, one_at_a_time: bool) -> list[Trial]:
    """All combinations, or the unchanged settings and then each value by itself."""
    if one_at_a_time:
        return [{}, *({name: value} for name, values in varied.items() for value in values)]
    return [dict(zip(varied, values, strict=True)) for values in itertools.product(*varied.values())]


def settings_for(algorithm: str, environment: str, common: Trial, trial: Trial, *, seed: int) -> LoopSettings:
    """Settings of one training.

    Raises:
        InputError: values that the schema refuses, or that do not fit each other.
    """
    return settings_of(algorithm, environment, {**common, **trial, "seed": seed})


def budget(planned: Sequence[LoopSettings], folder: Path) -> str:
    """The most that the search will cost, before anything is trained."""
    left = [settings for settings in planned if not _finished(folder / _name(settings))]
    steps = sum(settings.steps for settings in left)
    return (
        f"{len(planned)} trainings, {len(planned) - len(left)} of them finished already; at most {steps:,} steps and "
        f"{sum(s.steps // s.update_every * s.updates for s in left):,} updates to go"
    )


def search(
    algorithm: str,
    environment: str,
    common: Trial,
    varied: Mapping[str, Sequence[str]],
    *,
    seeds: int,
    folder: Path,
    one_at_a_time: bool = False,
    jobs: int = 1,
) -> Iterator[dict[str, Any]]:
    """Train and score, trial by trial; ``search.json`` in the folder always holds the results so far.

    Args:
        jobs: trainings at once, each in a process of its own where there are several.

    Yields:
        a trial's settings, scores of its seeds, their median, predicted minus observed return at the starts, and the
        seconds that their trainings took, one after the other.
    """
    rows: list[dict[str, Any]] = []
    tried = trials(varied, one_at_a_time=one_at_a_time)
    planned = [
        settings_for(algorithm, environment, common, trial, seed=seed) for trial in tried for seed in range(seeds)
    ]
    # A value that is the file's own makes the unchanged settings once more: one run must have one process.
    each = list(dict.fromkeys(planned))
    with contextlib.closing(in_order(partial(_score, folder=folder), each, jobs)) as results:
        known: dict[LoopSettings, tuple[float, float | None, float]] = {}
        for i, trial in enumerate(tried):
            wanted = planned[i * seeds : (i + 1) * seeds]
            while any(settings not in known for settings in wanted):
                known[each[len(known)]] = next(results)
            scores, errors, seconds = zip(*(known[settings] for settings in wanted), strict=True)
            row = {"trial": trial, "scores": scores, "median": float(np.median(scores)), "value_errors": errors}
            rows.append(row | {"seconds": round(sum(seconds), 1)})
            about = {
                "command": command(algorithm, environment, common, varied, seeds=seeds, one_at_a_time=one_at_a_time),
                "settings": settings_for(algorithm, environment, common, {}, seed=0).as_dict(),
                "one_at_a_time": one_at_a_time,
                "seeds": seeds,
                "trials": rows,
            }
            write_whole(folder / RESULTS, (json.dumps(about, indent=1) + "\n").encode())
            yield rows[-1]


def command(
    algorithm: str,
    environment: str,
    common: Trial,
    varied: Mapping[str, Sequence[str]],
    *,
    seeds: int,
    one_at_a_time: bool,
) -> str:
    """The command line of a search, without the folder that its runs are in."""
    words = [f"--set {name}={value}" for name, value in common.items()]
    words += [f"--vary {name}={','.join(map(str, values))}" for name, values in varied.items()]
    words += ["--one-at-a-time"] if one_at_a_time else []
    return " ".join(["python -m laplace_core search", algorithm, environment, *words, f"--seeds {seeds}"])


def _name(settings: LoopSettings) -> str:
    digest = hashlib.sha256(json.dumps(settings.as_dict(), sort_keys=True).encode()).hexdigest()[:10]
    return f"{settings.ALGORITHM}_{settings.environment.replace(':', '-')}_{digest}_{settings.seed}"


def _finished(run: Path) -> bool:
    return (run / "last.safetensors").exists()


def _score(settings: LoopSettings, folder: Path) -> tuple[float, float | None, float]:
    """Train unless that is done: score of the best checkpoint, error of its values, seconds that the training took."""
    run = folder / _name(settings)
    there = (run / "config.json").exists()
    if there and read_config(run / "config.json") != settings:
        raise InputError(f"{run} was made with other settings: name another folder.")
    if not _finished(run):
        for _ in train(None if there else settings, run, resume=there):
            pass
    score, error = _evaluated_once(run, settings)
    return score, error, seconds_behind(read_metrics(run))[-1]


def _evaluated_once(run: Path, settings: LoopSettings) -> tuple[float, float | None]:
    """Score and error of values of a finished run, saved in its folder for a larger search to use again."""
    asked = {"episodes": EPISODES, "start_seed": START_SEEDS + settings.seed}
    with contextlib.suppress(OSError, ValueError, KeyError, TypeError):  # not there, or not to be used
        saved = json.loads((run / SCORE).read_text())
        if {name: saved[name] for name in asked} == asked:
            return float(saved["score"]), None if saved["value_error"] is None else float(saved["value_error"])
    agent = load_checkpoint(run / "best.safetensors").agent
    scores, error = evaluated(agent, settings.environment, asked["episodes"], asked["start_seed"])
    score, error = round(scores.mean, 3), None if error is None else round(error, 3)
    write_whole(run / SCORE, json.dumps(asked | {"score": score, "value_error": error}).encode())
    return score, error
