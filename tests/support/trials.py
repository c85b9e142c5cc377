"""What trials of searches do in tests: functions that other processes can import."""

from __future__ import annotations

import os
import time
from functools import partial
from pathlib import Path

import optuna

from laplace_core import InputError
from laplace_core.experiments.search.work import Plan


def plan_of(storage: str, objective, count: int = 6, name: str = "study", **more) -> Plan:
    """A plan of equal jobs whose values a sampler chooses."""
    return Plan(storage, name, "about", [{}] * count, objective, **{"sampler": "random", "heartbeat": 1} | more)


def noted(trial: optuna.Trial, folder: str) -> float:
    """The value of x; each call leaves a line in the file of its job."""
    value = trial.suggest_float("x", 0, 1)
    with (Path(folder) / str(trial.user_attrs["job"])).open("a") as calls:
        calls.write(f"{os.getpid()}\n")
    return value


def waits_for_ever(trial: optuna.Trial, folder: str) -> float:
    """Leaves a file that holds its value, and then works for ever."""
    part = Path(folder) / "part"
    part.write_text(repr(trial.suggest_float("x", 0, 1)))
    part.rename(Path(folder) / "begun")
    while True:
        time.sleep(0.05)


def sleeps(trial: optuna.Trial, folder: str, seconds: float) -> float:
    """As :func:`noted`, after some time that needs no processor."""
    time.sleep(seconds)
    return noted(trial, folder)


def refuses_small(trial: optuna.Trial) -> float:
    value = trial.suggest_float("x", 0, 1)
    if value < 0.5:
        raise InputError("x is too small.")
    return value


def falls(trial: optuna.Trial) -> float:
    """Reports less and less over four steps, the more so the later its job is."""
    for step in range(1, 5):
        trial.report(-float(step * trial.user_attrs["job"]), step)
        if trial.should_prune():
            raise optuna.TrialPruned
    return -float(trial.user_attrs["job"])


def calls_in(folder: Path) -> dict[int, int]:
    """How often each job was begun."""
    return {int(file.name): file.read_text().count("\n") for file in folder.iterdir() if file.name.isdigit()}


def noting(folder: Path):
    return partial(noted, folder=str(folder))
