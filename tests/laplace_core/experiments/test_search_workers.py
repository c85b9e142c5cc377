"""The workers of a search: every job is done once, and what a dead worker has left is taken up again."""

from __future__ import annotations

import dataclasses
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from importlib.util import find_spec
from pathlib import Path

import optuna
import pytest
from optuna.trial import TrialState

from laplace_core import InputError
from laplace_core.cli import main
from laplace_core.experiments.search import objectives, spaces, work
from laplace_core.experiments.search.storages import BeatingJournal, storage_of
from laplace_core.experiments.search.work import SAMPLERS, TROUBLE, Plan, finish, study_of
from laplace_core.supervise import Process
from laplace_core.training.defaults import settings_of
from laplace_core.training.run_folder import read_metrics
from tests.support.quick_runs import until
from tests.support.trials import calls_in, falls, noting, plan_of, refuses_small

ROOT = Path(__file__).parents[3]
pytestmark = pytest.mark.filterwarnings("ignore:Heartbeat of storage:UserWarning")  # trials are begun by hand as well
STORAGES = pytest.mark.parametrize("name", ["search.db", "search.journal"])


def counted(study: optuna.Study) -> dict[str, int]:
    states = [trial.state.name for trial in study.trials]
    return {state: states.count(state) for state in states}


@STORAGES
@pytest.mark.parametrize("processes", [1, 2])
def test_every_job_is_done_once(name, processes, tmp_path):
    (tmp_path / "calls").mkdir()
    plan = plan_of(str(tmp_path / name), noting(tmp_path / "calls"))
    done = dict(finish(plan, processes=processes))
    assert sorted(done) == list(range(6))
    assert len({trial.params["x"] for trial in done.values()}) == 6
    assert all(trial.value == trial.params["x"] for trial in done.values())
    assert {job: trial.number for job, trial in finish(plan)} == {job: trial.number for job, trial in done.items()}
    more = dataclasses.replace(plan, jobs=[{}] * 8)
    assert len(dict(finish(more))) == 8
    assert calls_in(tmp_path / "calls") == dict.fromkeys(range(8), 1)
    assert counted(study_of(plan)) == {"COMPLETE": 8}


@STORAGES
def test_a_job_that_is_queued_twice_is_done_once(name, tmp_path):
    """Two commands that begin at the same moment may both find that a job is not queued yet."""
    (tmp_path / "calls").mkdir()
    plan = plan_of(str(tmp_path / name), noting(tmp_path / "calls"), count=3)
    for _ in range(2):
        for job in range(3):
            study_of(plan).enqueue_trial({}, user_attrs={"job": job})
    assert len(dict(finish(plan))) == 3
    while work.take_one(plan) is not None:
        pass
    assert calls_in(tmp_path / "calls") == dict.fromkeys(range(3), 1)


def begun_elsewhere(plan: Plan, folder: Path) -> subprocess.Popen:
    """A worker of a plan in a process of its own, which has begun a trial that never ends."""
    code = (
        "import sys; from functools import partial\n"
        "from laplace_core.experiments.search.work import take_one\n"
        "from tests.support.trials import plan_of, waits_for_ever\n"
        "take_one(plan_of(sys.argv[1], partial(waits_for_ever, folder=sys.argv[2])))\n"
    )
    worker = subprocess.Popen([sys.executable, "-c", code, plan.storage, str(folder)], cwd=ROOT)
    try:
        until(lambda: (folder / "begun").exists(), 300)
    except BaseException:
        worker.kill()
        raise
    return worker


@STORAGES
def test_the_trial_of_a_killed_worker_is_taken_up_again_with_its_values(name, tmp_path):
    (tmp_path / "calls").mkdir()
    plan = plan_of(str(tmp_path / name), noting(tmp_path / "calls"), heartbeat=600)
    first = finish(plan)
    before = dict([next(first), next(first)])
    first.close()
    worker = begun_elsewhere(plan, tmp_path)
    worker.kill()
    worker.wait()
    done = dict(finish(plan))
    assert {job: done[job].number for job in before} == {job: trial.number for job, trial in before.items()}
    assert float((tmp_path / "begun").read_text()) in {trial.value for trial in done.values()}
    assert counted(study_of(plan)) == {"COMPLETE": 6, "FAIL": 1}
    assert calls_in(tmp_path / "calls") == dict.fromkeys(range(6), 1)


@STORAGES
def test_a_worker_of_another_machine_is_missed_by_its_heartbeat(name, tmp_path):
    (tmp_path / "calls").mkdir()
    plan = plan_of(str(tmp_path / name), noting(tmp_path / "calls"), count=2)
    study = study_of(plan)
    work.queue(study, plan)
    lost = study.ask()
    value = lost.suggest_float("x", 0, 1)
    lost.set_user_attr("process", dataclasses.asdict(dataclasses.replace(Process.of(os.getpid()), place="elsewhere")))
    storage_of(plan.storage, plan.heartbeat).record_heartbeat(lost._trial_id)
    work.take_over(study, plan)
    assert study.trials[lost.number].state == TrialState.RUNNING  # nobody is hasty
    done = dict(finish(plan))
    assert done[0].params == {"x": value}
    assert done[0].number > 1
    assert calls_in(tmp_path / "calls") == {0: 1, 1: 1}


def test_a_worker_that_left_no_sign_of_life_is_missed_as_well(tmp_path, monkeypatch):
    plan = plan_of(str(tmp_path / "search.db"), noting(tmp_path), count=1)
    study = study_of(plan)
    work.queue(study, plan)
    study.ask()
    monkeypatch.setattr(work, "MISSED", 0)
    assert dict(finish(plan))[0].number == 1


def test_a_job_at_which_workers_die_again_and_again_is_given_up(tmp_path):
    plan = plan_of(str(tmp_path / "search.journal"), noting(tmp_path), count=1)
    study = study_of(plan)
    work.queue(study, plan)
    for _ in range(4):
        trial = study.ask()
        study.tell(trial, state=TrialState.FAIL)
        work.queue_again(study, study.trials[trial.number])
    assert counted(study) == {"FAIL": 4}
    with pytest.raises(InputError, match="the workers of job 0 died 4 times"):
        dict(work._news(study, plan, set()))


def test_a_trial_that_cannot_be_done_says_why_and_is_not_tried_again(tmp_path):
    plan = plan_of(str(tmp_path / "search.db"), refuses_small, count=8)
    done = dict(finish(plan))
    refused = [trial for trial in done.values() if TROUBLE in trial.user_attrs]
    assert 0 < len(refused) < 8
    assert all(trial.params["x"] < 0.5 and trial.user_attrs[TROUBLE] == "x is too small." for trial in refused)
    assert len(study_of(plan).trials) == 8


@pytest.mark.parametrize("pruner", ["median", "hyperband"])
def test_trials_that_fall_behind_are_pruned(pruner, tmp_path):
    plan = plan_of(str(tmp_path / "search.db"), falls, count=12, pruner=pruner, first=1, last=4)
    states = [trial.state for _, trial in sorted(finish(plan))]
    assert states[0] == TrialState.COMPLETE
    assert TrialState.PRUNED in states
    if pruner == "median":  # the four before it are no worse at the second step
        assert states[4:] == [TrialState.PRUNED] * 8


@pytest.mark.parametrize("sampler", ["tpe", "gp", "random"])
def test_a_sampler_draws_the_same_again_from_its_seed(sampler, tmp_path):
    drawn = []
    for i, seed in enumerate((3, 3, 4)):
        plan = plan_of(str(tmp_path / f"{i}.journal"), noting(tmp_path), count=12, sampler=sampler, seed=seed)
        drawn.append([trial.params["x"] for _, trial in sorted(finish(plan))])
    assert drawn[0] == drawn[1] != drawn[2]
    assert set(SAMPLERS) == {"tpe", "gp", "random", "grid"}


def test_a_study_of_another_search_is_refused(tmp_path):
    plan = plan_of(str(tmp_path / "search.db"), noting(tmp_path), count=1)
    study_of(plan)
    with pytest.raises(InputError, match="the study study is of another search"):
        study_of(dataclasses.replace(plan, about="else"))


@STORAGES
def test_a_file_that_is_no_storage_is_one_sentence(name, tmp_path, subtests):
    for content in (b"not a database at all", b"{}\n", b"[1, 2]\n", b'{"op_code": 99}\n', b"\x00" * 200):
        with subtests.test(content=content):
            file = tmp_path / f"{len(content)}_{name}"
            file.write_bytes(content)
            with pytest.raises(InputError, match=r"cannot be used: .+"):
                study_of(plan_of(str(file), noting(tmp_path)))


def test_both_kinds_of_file_record_heartbeats(tmp_path):
    assert storage_of(str(tmp_path / "a.db"), 7).get_heartbeat_interval() == 7
    journal = storage_of(str(tmp_path / "a.journal"), 7)
    assert isinstance(journal, BeatingJournal)
    assert journal.get_heartbeat_interval() == 7


# --- what a trial trains ---

QUICK = ["--set", "steps=1200", "--set", "updates=1", "--set", "learning_starts=100", "--set", "hidden=8",
         "--set", "features=4", "--set", "evaluate_every=200", "--set", "checkpoint_every=200",
         "--set", "evaluate_episodes=2"]  # fmt: skip
SEARCH = ["search", "laplace", "two_branch", *QUICK, "--seeds", "2", "--vary", "learning_rate=0.001..0.01:log",
          "--trials", "2"]  # fmt: skip


def without_seconds(rows: list[dict]) -> list[dict]:
    return [{name: value for name, value in row.items() if name != "seconds"} for row in rows]


@pytest.mark.long
def test_a_search_that_is_killed_goes_on_from_its_checkpoints_to_the_same_result(tmp_path, capsys):
    """Compared with a search never interrupted: the same values are tried, and found to be worth the same."""
    killed, whole = tmp_path / "killed", tmp_path / "whole"
    words = [*SEARCH, "--runs", str(killed)]
    process = subprocess.Popen(
        [sys.executable, "-m", "laplace_core", *words], cwd=ROOT, stdout=subprocess.DEVNULL, start_new_session=True
    )
    try:
        until(lambda: len(list(killed.glob("laplace_*/resume.safetensors"))) == 2, 300)
    finally:
        process.kill()
        process.wait()
    assert not list(killed.glob("laplace_*/last.safetensors"))
    assert main([*words, "--json"]) == 0
    after = json.loads(capsys.readouterr().out)
    assert main([*SEARCH, "--runs", str(whole), "--json"]) == 0
    assert without_seconds(after) == without_seconds(json.loads(capsys.readouterr().out))
    assert sorted(run.name for run in killed.glob("laplace_*")) == sorted(run.name for run in whole.glob("laplace_*"))


def tiny(**more) -> list:
    given = {"steps": 400, "learning_starts": 100, "hidden": 8, "features": 4, "evaluate_every": 100,
             "evaluate_episodes": 2} | more  # fmt: skip
    return [settings_of("laplace", "two_branch", {**given, "seed": seed}) for seed in range(2)]


def test_a_pruned_trial_ends_both_trainings_early(tmp_path):
    study = optuna.create_study(direction="maximize", pruner=optuna.pruners.ThresholdPruner(lower=1e9))
    study.optimize(partial(objectives.value_of, settings=tiny(), folder=tmp_path, objective="score"), n_trials=1)
    (trial,) = study.trials
    assert trial.state == TrialState.PRUNED
    assert list(trial.intermediate_values) == [100]
    runs = list(tmp_path.iterdir())
    assert len(runs) == 2
    assert not any((run / "last.safetensors").exists() for run in runs)
    assert trial.user_attrs["seconds"] > 0


def test_a_trial_reports_the_median_of_its_seeds_at_every_evaluation(tmp_path):
    study = optuna.create_study(direction="maximize")
    objective = partial(objectives.value_of, settings=tiny(), folder=tmp_path, objective="paper")
    study.optimize(objective, n_trials=2)  # the second finds the runs finished, and reports the same
    first, second = study.trials
    assert list(first.intermediate_values) == [100, 200, 300, 400]
    assert first.intermediate_values == second.intermediate_values
    assert first.value == pytest.approx(first.intermediate_values[400], abs=1e-3)  # at the end of the episodes
    seeds = [objectives.last_returns(read_metrics(run)) for run in tmp_path.iterdir()]
    for step, values in zip((100, 200, 300, 400), zip(*seeds, strict=True), strict=True):
        assert first.intermediate_values[step] == sum(values) / 2


def test_the_objective_of_the_paper_is_a_mean_over_discounts_of_the_last_episodes():
    """Discount 0 behaved in 150 episodes of returns 0..149, whose last 100 have the mean 99.5, and discount 2 in two
    of 10 and 20: (99.5 + 15) / 2. Before the first episode ends the evaluation stands in."""
    evaluation = {"event": "Evaluation", "score": 7.0}
    episodes = [{"event": "Episode", "head": 0, "episode_return": float(i)} for i in range(150)]
    others = [{"event": "Episode", "head": 2, "episode_return": value} for value in (10.0, 20.0)]
    events = [evaluation, *episodes, evaluation, *others, {"event": "Checkpoint"}, evaluation]
    assert objectives.last_returns(events) == [7.0, 99.5, 57.25]


# --- spaces ---


def test_dimensions_are_read_from_text(subtests):
    schema = {parameter.name: parameter for parameter in settings_of("laplace", "two_branch", {}).SCHEMA}
    for name, text, expected in [
        ("batch", "32,64", spaces.Choices((32, 64))),
        ("double", "true,false", spaces.Choices((True, False))),
        ("n_step", "1..5", spaces.Range(1, 5)),
        ("learning_rate", "1e-4..1e-2:log", spaces.Range(1e-4, 1e-2, log=True)),
        ("consistency", "0..2", spaces.Range(0.0, 2.0)),
    ]:
        with subtests.test(text=text):
            dimension = spaces.parsed(schema[name], text)
            assert dimension == expected
            assert spaces.parsed(schema[name], str(dimension)) == expected
            trial = optuna.create_study().ask()
            schema[name].parse(dimension.suggested(trial, name))
    for name, text, named in [
        ("n_step", "5..1", "smaller"),
        ("n_step", "1..1.5", "whole number"),
        ("n_step", "0..3", "from 1 to 20"),
        ("learning_rate", "1e-4..", "must be a number"),
        ("consistency", "0..1:log", "begins above 0"),
        ("consistency", "0..1:lin", "only :log"),
        ("double", "false..true", "list its values"),
        ("batch", "32,32.0", "twice"),
    ]:
        with subtests.test(text=text), pytest.raises(InputError, match=named):
            spaces.parsed(schema[name], text)


def test_the_spaces_of_the_paper_hold_the_values_that_it_found(subtests):
    """Appendix C; its slope 25 on 100 sensitivities over CartPole's three units of reward is .76 in 1/spacing."""
    found = {
        "qrdqn": {"batch": 128, "buffer": 100_000, "epsilon_final": 0.04, "exploration": 0.16},
        "c51": {"batch": 128, "atoms": 62, "learning_starts": 32, "update_every": 4, "learning_rate": 0.006},
        "laplace": {"thetas": 100, "gammas": 5, "learning_rate": 0.005, "slope_times_spacing": 25 * 3 / 99},
    }
    for algorithm, values in found.items():
        space = spaces.space_of(algorithm, spaces.named_space("paper", algorithm))
        assert space.keys() == values.keys()
        for name, value in values.items():
            with subtests.test(f"{algorithm} {name}"):
                dimension = space[name]
                if isinstance(dimension, spaces.Choices):
                    assert value in dimension.values
                else:
                    assert dimension.low <= value <= dimension.high


def test_every_named_space_can_be_searched_where_it_is_tuned(subtests, capsys):
    for name, of in spaces.SPACES.items():
        for algorithm in of:
            with subtests.test(f"{name} {algorithm}"):
                assert main(["search", algorithm, "CartPole-v1", "--space", name, "--trials", "5", "--budget"]) == 0
                assert "15 trainings" in capsys.readouterr().out


NO_SERVER = (
    "nobody@127.0.0.1:1/none cannot be used" if find_spec("psycopg") else "pip install -r requirements-postgresql.txt"
)
"""The driver is installed for `make verify` only."""


@pytest.mark.parametrize(
    ("more", "named"),
    [
        (["--vary", "learning_rate=.001..01:log", "--sampler", "grid"], "a range needs a sampler"),
        (["--sampler", "tpe"], "a sampler needs settings to vary"),
        (["--space", "theirs"], "paper, ours"),
        (["--sampler", "best"], "tpe, gp, random, grid"),
        (["--pruner", "hard"], "none, median, hyperband"),
        (["--objective", "sum"], "score, paper"),
        (["--storage", "search.txt"], "the storage must be"),
        (["--storage", "mysql://x/y"], "the storage must be"),
        (["--storage", "postgresql://nobody:secret@127.0.0.1:1/none"], NO_SERVER),
        (["--vary", "averaging=.01,.02", "--one-at-a-time", "--pruner", "median"], "leave --pruner out"),
        (["--vary", "averaging=.01,.02", "--one-at-a-time", "--trials", "3"], "leave --sampler out"),
        (["--vary", "averaging=.01,.02", "--sampler", "grid", "--trials", "3"], "--trials is of a sampler"),
        (["--vary", "batch=1,2,3,4,5,6,7,8,9", "--vary", "hidden=1,2,3,4,5,6,7,8,9",
          "--vary", "envs=1,2,3,4,5,6,7,8,9", "--vary", "n_step=1,2,3,4,5,6,7,8,9", "--vary", "updates=1,2"],
         "13,122 combinations"),
    ],
)  # fmt: skip
def test_what_cannot_be_searched_is_refused_in_one_sentence(more, named, tmp_path, capsys):
    assert main(["search", "dqn", "two_branch", *more, "--runs", str(tmp_path / "runs")]) == 2
    said = capsys.readouterr().err
    assert named in said
    assert "secret" not in said
    assert len(said.splitlines()) == 1


def test_what_a_sampler_chose_in_vain_changes_nothing(tmp_path):
    """Without prioritised replay its exponent is meaningless: such a trial is the run that has no exponent."""
    from laplace_core.experiments.search.search import Search

    search = Search("dqn", "two_branch", {}, {"prioritised": "true,false", "priority_exponent": "0.3..0.9"}, 1,
                    tmp_path, sampler="tpe")  # fmt: skip
    idle = search.settings({"prioritised": False, "priority_exponent": 0.5})
    assert idle == search.settings({})
    assert search.settings({"prioritised": True, "priority_exponent": 0.5}).priority_exponent == 0.5


@STORAGES
def test_a_queued_trial_is_handed_to_one_worker_only(name, tmp_path):
    """Eight at a time ask for forty trials. In an SQLite file Optuna by itself would hand some of them to several."""
    plan = plan_of(str(tmp_path / name), noting(tmp_path), count=40)
    study = study_of(plan)
    work.queue(study, plan)
    with ThreadPoolExecutor(8) as pool:
        taken = list(pool.map(lambda _: study.ask().number, range(40)))
    assert sorted(taken) == list(range(40))
