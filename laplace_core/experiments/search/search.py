"""A search over settings: what is varied and how, what it costs, and its results as they are known.

Without a sampler every combination of listed values is tried, or, one at a time, every value by itself against the
settings of the file. A sampler chooses values from lists and ranges by what the trials before have found. Trainings are
runs in a folder: a search that was interrupted goes on with them, and a search that asks for more uses what is there,
scores included. Scores are of start seeds of their own, so that those of the reports stay unseen.
"""

from __future__ import annotations

import hashlib
import itertools
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any

import optuna
from optuna.trial import FrozenTrial, TrialState

from laplace_core.agents.settings import LoopSettings
from laplace_core.errors import InputError
from laplace_core.experiments.search import objectives
from laplace_core.experiments.search.objectives import OBJECTIVES, SCORE
from laplace_core.experiments.search.spaces import Space, Value, is_listed, space_of, values_of
from laplace_core.experiments.search.storages import HEARTBEAT, JOB, absolute, check_storage
from laplace_core.experiments.search.work import GRID, PRUNERS, SAMPLERS, TROUBLE, Plan, about_of, finish
from laplace_core.files.atomic import write_whole
from laplace_core.parameters import as_text
from laplace_core.training.defaults import settings_of

RESULTS = "search.json"
MOST_TRIALS = 10_000
USUAL_TRIALS = 50  # as many as the paper's searches had
_STORAGE = "search.db"  # in the folder of the runs

Trial = dict[str, Any]
"""Settings that a trial changes against the file's, by name."""


def trials(varied: Mapping[str, Sequence[Value]], *, one_at_a_time: bool) -> list[Trial]:
    """All combinations, or the unchanged settings and then each value by itself."""
    if one_at_a_time:
        return [{}, *({name: value} for name, values in varied.items() for value in values)]
    return [dict(zip(varied, values, strict=True)) for values in itertools.product(*varied.values())]


@dataclass(frozen=True)
class Search:
    """A search, checked when it is made.

    Attributes:
        common: settings of all trainings against the file's.
        varied: the dimension of each setting as text, see :mod:`laplace_core.experiments.search.spaces`.
        seeds: trainings of a trial, from seed 0 on.
        folder: of the runs.
        count: trials that a sampler makes; None is the usual number.
        objective: one of :data:`laplace_core.experiments.search.objectives.OBJECTIVES`.
        storage: where the trials are kept; None is a file in the folder.
        study: its name there; None is one that the search's own settings decide.
        sampler_seed: decides what a sampler draws.
        heartbeat: seconds between two signs of life of a trial.

    Raises:
        InputError: settings that the schema refuses or that do not fit each other, and options that do not.
    """

    algorithm: str
    environment: str
    common: Trial
    varied: Mapping[str, str]
    seeds: int
    folder: Path
    one_at_a_time: bool = False
    sampler: str = GRID
    pruner: str = "none"
    count: int | None = None
    objective: str = SCORE
    storage: str | None = None
    study: str | None = None
    sampler_seed: int = 0
    heartbeat: int = HEARTBEAT
    space: Space = field(init=False, repr=False)

    def __post_init__(self) -> None:
        for what, name, known in (
            ("sampler", self.sampler, SAMPLERS), ("pruner", self.pruner, PRUNERS),
            ("objective", self.objective, OBJECTIVES),
        ):  # fmt: skip
            if name not in known:
                raise InputError(f"the {what} must be one of {', '.join(known)}, not {name[:40]!r}.")
        self.settings({})  # refuses what is wrong in the common settings
        object.__setattr__(self, "space", space_of(self.algorithm, self.varied))
        if self.storage is not None:
            check_storage(self.storage)
        if self.listed:
            self._check_list()
        elif not self.varied:
            raise InputError("a sampler needs settings to vary: name them with --vary, or a --space.")
        elif self.one_at_a_time:
            raise InputError("--one-at-a-time lists its trials: leave --sampler out.")

    def _check_list(self) -> None:
        if not is_listed(self.space):
            raise InputError("a range needs a sampler: name one, such as --sampler tpe, or list values.")
        if self.count is not None:
            raise InputError("--trials is of a sampler: a grid has one trial for each combination of its values.")
        if self.one_at_a_time and self.pruner != "none":
            raise InputError("--one-at-a-time compares every value with the unchanged settings: leave --pruner out.")
        if len(self.jobs) > MOST_TRIALS:
            raise InputError(f"that is {len(self.jobs):,} combinations: list fewer values, or name a sampler.")
        for trial in self.jobs:
            self.settings(trial)

    @property
    def listed(self) -> bool:
        """Whether all trials are known beforehand."""
        return self.sampler == GRID

    @cached_property
    def jobs(self) -> list[Trial]:
        """The changes of each trial; empty if a sampler chooses them."""
        if self.listed:
            return trials(values_of(self.space), one_at_a_time=self.one_at_a_time)
        return [{} for _ in range(self.count or USUAL_TRIALS)]

    def settings(self, trial: Trial, *, seed: int = 0) -> LoopSettings:
        """Settings of one training. What a sampler chose and the other settings make meaningless stays as it was.

        Raises:
            InputError: values that the schema refuses, or that do not fit each other.
        """
        usual = settings_of(self.algorithm, self.environment, {**self.common, "seed": seed})
        if not trial or self.listed:
            return settings_of(self.algorithm, self.environment, {**self.common, **trial, "seed": seed})
        chosen = usual.parse(usual.as_dict() | trial)
        idle = chosen.ignored().keys() & trial.keys()
        return usual.parse(chosen.as_dict() | {name: getattr(usual, name) for name in idle})

    @property
    def command(self) -> str:
        """The command line of the search, without the folder, the storage and the workers that it has."""
        words = [f"--set {name}={as_text(value)}" for name, value in self.common.items()]
        words += [f"--vary {name}={text}" for name, text in self.varied.items()]
        words += ["--one-at-a-time"] if self.one_at_a_time else []
        words += [] if self.listed else [f"--sampler {self.sampler} --trials {len(self.jobs)}"]
        words += [f"--sampler-seed {self.sampler_seed}"] if self.sampler_seed else []
        words += [] if self.pruner == "none" else [f"--pruner {self.pruner}"]
        words += [] if self.objective == SCORE else [f"--objective {self.objective}"]
        return " ".join(["python -m laplace_core search", self.algorithm, self.environment, *words,
                         f"--seeds {self.seeds}"])  # fmt: skip

    @property
    def plan(self) -> Plan:
        """The search as its workers get it."""
        usual = self.settings({})
        what = {
            "algorithm": self.algorithm, "environment": self.environment, "settings": usual.as_dict(),
            "varied": {name: str(dimension) for name, dimension in self.space.items()}, "seeds": self.seeds,
            "one_at_a_time": self.one_at_a_time, "objective": self.objective,
            "sampler": self.sampler, "pruner": self.pruner, "sampler_seed": self.sampler_seed,
        }  # fmt: skip
        about = about_of(what)
        digest = hashlib.sha256(about.encode()).hexdigest()[:10]
        base = {name: getattr(usual, name) for name in self.space} if self.one_at_a_time else {}
        return Plan(
            absolute(self.storage or str(self.folder / _STORAGE)),
            self.study or f"{self.algorithm}_{self.environment.replace(':', '-')}_{digest}",
            about,
            [base | job for job in self.jobs],
            partial(_value, search=replace(self, folder=self.folder.absolute())),
            self.sampler,
            self.pruner,
            first=min(usual.evaluate_every, usual.steps),
            last=usual.steps,
            seed=self.sampler_seed,
            heartbeat=self.heartbeat,
        )

    def budget(self) -> str:
        """The most that the search will cost, before anything is trained."""
        planned = [self.settings(trial, seed=seed) for trial in self.jobs for seed in range(self.seeds)]
        left = [each for each in planned if not objectives.is_finished(self.folder / objectives.run_name(each), each)]
        if not self.listed:  # which trainings these are, the sampler decides
            left = planned[self.seeds * self._known() :]
        steps = sum(each.steps for each in left)
        return (
            f"{len(planned)} trainings, {len(planned) - len(left)} of them finished already; at most {steps:,} steps "
            f"and {sum(each.steps // each.update_every * each.updates for each in left):,} updates to go"
        )

    def _known(self) -> int:
        """Trials in the results that the folder holds, if they are of this search."""
        try:
            content = json.loads((self.folder / RESULTS).read_bytes())
            return len(content["trials"]) if content["command"] == self.command else 0
        except (OSError, ValueError, KeyError, TypeError):
            return 0

    def run(self, *, processes: int = 1, cluster: str | None = None) -> Iterator[dict[str, Any]]:
        """Do what is left, trial by trial; ``search.json`` in the folder always holds the results so far.

        Args:
            processes, cluster: as in :func:`laplace_core.supervise.parallel.in_parallel`; each does one trial.

        Yields:
            the row of a trial, as :func:`laplace_core.experiments.search.results.read` gives it; one that could not be
            trained has ``trouble``, a sentence, and is not in the file.
        """
        self.folder.mkdir(parents=True, exist_ok=True)
        rows: dict[int, dict[str, Any]] = {}
        for number, done in finish(self.plan, processes=processes, cluster=cluster):
            trial = self.jobs[number] if self.listed else done.params
            if TROUBLE in done.user_attrs:
                yield {"trial": trial, "trouble": done.user_attrs[TROUBLE]}
                continue
            rows[number] = _row(number, trial, done)
            about = {
                "command": self.command,
                "settings": self.settings({}).as_dict(),
                "one_at_a_time": self.one_at_a_time,
                "seeds": self.seeds,
                "objective": self.objective,
                "sampler": self.sampler,
                "pruner": self.pruner,
                "space": {name: str(dimension) for name, dimension in self.space.items()},
                "trials": [rows[each] for each in sorted(rows)],
            }
            write_whole(self.folder / RESULTS, (json.dumps(about, indent=1) + "\n").encode())
            yield rows[number]


def _row(number: int, trial: Trial, done: FrozenTrial) -> dict[str, Any]:
    pruned = done.state == TrialState.PRUNED
    last = done.intermediate_values[max(done.intermediate_values)] if pruned else done.value
    return {
        "trial": trial,
        "scores": done.user_attrs.get("scores", []),
        "median": last,
        "value_errors": done.user_attrs.get("value_errors", []),
        "seconds": round(done.user_attrs.get("seconds", 0.0), 1),
        "number": number,
        "pruned": pruned,
        "reported": {str(step): value for step, value in sorted(done.intermediate_values.items())},
    }


def _value(trial: optuna.Trial, search: Search) -> float:
    """The objective of a trial; every worker gets it with the search."""
    usual = search.settings({})
    for name, dimension in search.space.items():
        if search.one_at_a_time:
            dimension = dimension.beside(getattr(usual, name))
        dimension.suggested(trial, name)
    number = trial.user_attrs[JOB]
    changes = search.jobs[number] if search.listed else trial.params
    settings = [search.settings(changes, seed=seed) for seed in range(search.seeds)]
    return objectives.value_of(trial, settings, search.folder, search.objective)
