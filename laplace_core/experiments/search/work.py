"""The workers of a search: each takes a queued trial, does it, and takes over what dead workers have left.

A plan is a list of jobs. Each is queued in the storage once as a trial, and the storage hands a queued trial to one
worker only. Where two commands queue the same job at the same moment, the trial with the lower number counts and the
other ends before it trains. So a job is done once, however many workers of however many machines take part.
"""

from __future__ import annotations

import contextlib
import json
import os
import time
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from datetime import datetime, timedelta
from typing import Any

import optuna
from optuna.exceptions import ExperimentalWarning
from optuna.pruners import BasePruner, HyperbandPruner, MedianPruner, NopPruner
from optuna.samplers import BaseSampler, GPSampler, RandomSampler, TPESampler
from optuna.study import StudyDirection
from optuna.trial import FrozenTrial, TrialState

from laplace_core.errors import InputError
from laplace_core.experiments.search.storages import FAILURES, HEARTBEAT, JOB, MISSED, queue_again, readable, storage_of
from laplace_core.supervise import Process
from laplace_core.supervise.parallel import TRIES, in_parallel

GRID = "grid"
SAMPLERS: dict[str, Callable[[int], BaseSampler]] = {
    "tpe": lambda seed: TPESampler(seed=seed),
    "gp": lambda seed: GPSampler(seed=seed),
    "random": lambda seed: RandomSampler(seed=seed),
    GRID: lambda seed: RandomSampler(seed=seed),  # every job states all its values: nothing is sampled
}
"""From a seed to a sampler, by the name that the command line gives it."""
PRUNERS: dict[str, Callable[[int, int], BasePruner]] = {
    "none": lambda first, last: NopPruner(),
    "median": lambda first, last: MedianPruner(n_startup_trials=4, n_warmup_steps=last // 4),
    "hyperband": lambda first, last: HyperbandPruner(min_resource=max(1, first), max_resource=last),
}
"""From the steps at the first and at the last evaluation to a pruner."""
LOOK_EVERY = 0.5
"""Seconds between two looks for a trial to take over, where all that is left is done by others."""
TROUBLE = "trouble"
_PROCESS, _ABOUT = "process", "about"
_OVER = (TrialState.COMPLETE, TrialState.PRUNED)
_OPEN = (TrialState.RUNNING, TrialState.WAITING)


@dataclass(frozen=True)
class Plan:
    """The plan of a search, as every worker gets it.

    Attributes:
        storage: as :func:`laplace_core.experiments.search.storages.storage_of` reads it.
        name: of the study in the storage.
        about: what the study is of; a study of this name that is of something else is refused.
        jobs: values that are fixed for each trial, by name; the sampler chooses all others.
        objective: of a module, or a partial of one; the larger its value, the better.
        first, last: steps that a trial reports first and last.
    """

    storage: str
    name: str
    about: str
    jobs: Sequence[Mapping[str, Any]]
    objective: Callable[[optuna.Trial], float]
    sampler: str = "tpe"
    pruner: str = "none"
    first: int = 1
    last: int = 1
    seed: int = 0
    heartbeat: int = HEARTBEAT


class SeededByTrial(BaseSampler):
    """A sampler whose seed is that of the search plus the number of the trial.

    With one worker a search so samples the same again, and two workers never the same.
    """

    def __init__(self, name: str, seed: int):
        self._make, self._seed = SAMPLERS[name], seed
        self._of: tuple[int, BaseSampler] | None = None

    def _sampler(self, trial: FrozenTrial) -> BaseSampler:
        if self._of is None or self._of[0] != trial.number:
            with warnings.catch_warnings(action="ignore", category=ExperimentalWarning):
                self._of = trial.number, self._make(self._seed + trial.number)
        return self._of[1]

    def infer_relative_search_space(self, study: optuna.Study, trial: FrozenTrial) -> dict[str, Any]:
        return self._sampler(trial).infer_relative_search_space(study, trial)

    def sample_relative(self, study: optuna.Study, trial: FrozenTrial, search_space: dict[str, Any]) -> dict[str, Any]:
        return self._sampler(trial).sample_relative(study, trial, search_space)

    def sample_independent(
        self, study: optuna.Study, trial: FrozenTrial, param_name: str, param_distribution: Any
    ) -> Any:
        return self._sampler(trial).sample_independent(study, trial, param_name, param_distribution)

    def before_trial(self, study: optuna.Study, trial: FrozenTrial) -> None:
        self._sampler(trial).before_trial(study, trial)

    def after_trial(
        self, study: optuna.Study, trial: FrozenTrial, state: TrialState, values: Sequence[float] | None
    ) -> None:
        self._sampler(trial).after_trial(study, trial, state, values)


@dataclass
class Job:
    """The progress of a job.

    Attributes:
        trials: that were queued for it, the first one first.
        done: its trial that is complete, pruned or refused; None while there is none.
    """

    trials: list[FrozenTrial] = field(default_factory=list)

    @property
    def done(self) -> FrozenTrial | None:
        over = (each for each in self.trials if each.state in _OVER or TROUBLE in each.user_attrs)
        return next(over, None)

    @property
    def open(self) -> bool:
        return any(each.state in _OPEN for each in self.trials)

    @property
    def lost(self) -> bool:
        """Whether every worker that tried it has died, so often that nobody tries again."""
        return self.done is None and not self.open and len(self.trials) > TRIES


def jobs_in(study: optuna.Study, count: int) -> list[Job]:
    """The jobs of a plan, as the storage has them."""
    jobs = [Job() for _ in range(count)]
    for trial in study.get_trials(deepcopy=False):
        number = trial.user_attrs.get(JOB)
        if isinstance(number, int) and 0 <= number < count:
            jobs[number].trials.append(trial)
    return jobs


def study_of(plan: Plan) -> optuna.Study:
    """The study of a plan, made where there is none yet.

    Raises:
        InputError: a storage that cannot be used, or a study of this name that is of something else.
    """
    storage = storage_of(plan.storage, plan.heartbeat)
    with readable(plan.storage):
        study = optuna.create_study(
            storage=storage,
            study_name=plan.name,
            load_if_exists=True,
            direction=StudyDirection.MAXIMIZE,
            sampler=SeededByTrial(plan.sampler, plan.seed),
            pruner=PRUNERS[plan.pruner](plan.first, plan.last),
        )
        about = study.user_attrs.get(_ABOUT)
        if about is None:
            study.set_user_attr(_ABOUT, plan.about)
    if about not in (None, plan.about):
        raise InputError(f"the study {plan.name[:60]} is of another search: name another one with --study.")
    return study


def finish(plan: Plan, *, processes: int = 1, cluster: str | None = None) -> Iterator[tuple[int, FrozenTrial]]:
    """Do all jobs of a plan that are not done yet, and give the trial of each as soon as it is known.

    Other commands may work at the same plan in the same storage; what they do is given as well.

    Args:
        processes, cluster: as in :func:`laplace_core.supervise.parallel.in_parallel`.

    Yields:
        Number of the job, and its trial: complete, pruned, or failed with a sentence as its attribute ``TROUBLE``.

    Raises:
        InputError: a storage that cannot be used, or a job at which workers died again and again.
    """
    study = study_of(plan)
    queue(study, plan)
    given: set[int] = set()
    yield from _news(study, plan, given)
    while len(given) < len(plan.jobs):
        left = [plan] * (len(plan.jobs) - len(given))
        with contextlib.closing(in_parallel(take_one, left, processes, cluster)) as results:
            for _ in results:
                yield from _news(study, plan, given)


def _news(study: optuna.Study, plan: Plan, given: set[int]) -> Iterator[tuple[int, FrozenTrial]]:
    """The jobs that are done and not given yet, in their order."""
    with readable(plan.storage):
        jobs = jobs_in(study, len(plan.jobs))
    for number, job in enumerate(jobs):
        if job.lost:
            raise InputError(f"the workers of job {number} died {len(job.trials)} times: see what they died of.")
        if number not in given and job.done is not None:
            given.add(number)
            yield number, job.done


def take_one(plan: Plan) -> int | None:
    """Do one trial; where others do all that is left, wait until they have done it or one of them has died.

    Returns:
        the number of the trial, or None if nothing is left.
    """
    study = study_of(plan)
    while True:
        with readable(plan.storage):
            take_over(study, plan)
            jobs = jobs_in(study, len(plan.jobs))
        if all(job.done is not None or job.lost for job in jobs):
            return None
        if any(trial.state == TrialState.WAITING for job in jobs for trial in job.trials):
            number = _trial(study, plan)
            if number is not None:
                return number
        else:
            time.sleep(LOOK_EVERY)


def queue(study: optuna.Study, plan: Plan) -> None:
    """Queue every job that has no trial yet, or none that is left of those that it had."""
    with readable(plan.storage):
        for number, job in enumerate(jobs_in(study, len(plan.jobs))):
            if job.done is None and not job.open:
                study.enqueue_trial(dict(plan.jobs[number]), user_attrs={JOB: number})


class _Surplus(Exception):
    """Another trial does this job, or there is none to do."""


def _trial(study: optuna.Study, plan: Plan) -> int | None:
    """Take a queued trial and do it; its number, or None if it was one too many."""
    taken: list[int] = []

    def objective(trial: optuna.Trial) -> float:
        trial.set_user_attr(_PROCESS, asdict(Process.of(os.getpid())))
        job = trial.user_attrs.get(JOB)
        same = (each for each in study.get_trials(deepcopy=False) if each.user_attrs.get(JOB) == job)
        if job is None or any(
            each.number < trial.number and (each.state in _OPEN or each.state in _OVER) for each in same
        ):
            raise _Surplus
        taken.append(trial.number)
        try:
            return plan.objective(trial)
        except InputError as error:
            trial.set_user_attr(TROUBLE, str(error))
            raise

    try:
        study.optimize(objective, n_trials=1, catch=(InputError, _Surplus))
    except KeyboardInterrupt:  # it was failed, and is there for whoever goes on with the search
        for number in taken:
            queue_again(study, study.trials[number])
        raise
    except FAILURES as error:
        with readable(plan.storage):
            raise error
    except (ValueError, optuna.exceptions.UpdateFinishedTrialError):
        # Whoever took this worker for lost has failed its trial and queued it again.
        if not taken or study.trials[taken[0]].state != TrialState.FAIL:
            raise
        return None
    return taken[0] if taken else None


def take_over(study: optuna.Study, plan: Plan) -> None:
    """Fail the trials of workers that have died, and queue them again.

    By the heartbeat, which a worker on any machine has; before that is missed, where the worker was a process of this
    machine and is over; and where a worker died so early that it left no sign of either.
    """
    with warnings.catch_warnings(action="ignore", category=ExperimentalWarning):
        optuna.storages.fail_stale_trials(study)
    early = datetime.now() - timedelta(seconds=MISSED * plan.heartbeat)
    for trial in study.get_trials(deepcopy=False, states=(TrialState.RUNNING,)):
        process = _process(trial)
        if process is None:
            dead = trial.datetime_start is not None and trial.datetime_start < early
        else:
            dead = process.near and not process.alive
        if dead:
            # Where two workers see it at once, Optuna refuses the second: the trial is over already.
            with contextlib.suppress(ValueError, optuna.exceptions.UpdateFinishedTrialError):
                study.tell(trial.number, state=TrialState.FAIL)
                queue_again(study, study.trials[trial.number])


def _process(trial: FrozenTrial) -> Process | None:
    about = trial.user_attrs.get(_PROCESS)
    try:
        return None if about is None else Process(**about)
    except TypeError:  # written by something else
        return None


def about_of(content: Mapping[str, Any]) -> str:
    """The content of a study as one text, the same for the same content."""
    return json.dumps(content, sort_keys=True)
