"""Searches and reproductions of several workers and machines: what takes long, for ``make verify``."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

import pytest

from laplace_core.cli import main
from laplace_core.experiments.search.storages import storage_of
from laplace_core.experiments.search.work import Plan, finish, queue, study_of
from tests.laplace_core.experiments.test_search_workers import SEARCH, counted
from tests.support import postgresql
from tests.support.quick_runs import until
from tests.support.ray_cluster import two_nodes
from tests.support.trials import calls_in, plan_of, sleeps

ROOT = Path(__file__).parents[3]
pytestmark = pytest.mark.long
TRIALS = 16
STORAGES = ["search.db", "search.journal", "postgresql"]
# A trial that sleeps: its time is that of no processor, of which a busy machine may have none to spare.
_WORKER = """
import sys, time
from functools import partial
from pathlib import Path
from laplace_core.experiments.search.work import study_of, take_one
from tests.support.trials import plan_of, sleeps
storage, study, folder, seconds, count, name = sys.argv[1:]
work = partial(sleeps, folder=folder, seconds=float(seconds))
plan = plan_of(storage, work, count=int(count), heartbeat=2, name=study)
study_of(plan)
(Path(folder) / f"ready {name}").touch()
while not (Path(folder) / "go").exists():
    time.sleep(0.01)
while take_one(plan) is not None:
    pass
"""


@pytest.fixture(params=STORAGES)
def storage(request, tmp_path):
    """Where the trials are kept."""
    if request.param != "postgresql":
        yield str(tmp_path / request.param)
        return
    pytest.importorskip("psycopg", reason="pip install -r requirements-postgresql.txt")
    if postgresql.programs() is None:
        pytest.skip("apt-get install postgresql")
    with postgresql.server() as address:
        yield address
        storage_of.cache_clear()


class Workers:
    """Processes that work at one plan; they begin together, once all have loaded what they need."""

    def __init__(self, plan: Plan, folder: Path, count: int, seconds: float):
        folder.mkdir()
        self.folder = folder
        words = [plan.storage, plan.name, str(folder), str(seconds), str(len(plan.jobs))]
        self.processes = [
            subprocess.Popen([sys.executable, "-c", _WORKER, *words, str(i)], cwd=ROOT) for i in range(count)
        ]

    def __enter__(self) -> Workers:
        until(lambda: len(list(self.folder.glob("ready *"))) == len(self.processes), 300)
        (self.folder / "go").touch()
        return self

    def __exit__(self, *_: object) -> None:
        for process in self.processes:
            process.kill()
            process.wait()

    def wait(self) -> None:
        """Until all that were not killed have ended well."""
        assert {process.wait(600) for process in self.processes} <= {0, -signal.SIGKILL}


def sleeping(storage: str, folder: Path, seconds: float, name: str = "study") -> Plan:
    """Trials that sleep, all queued."""
    asleep = partial(sleeps, folder=str(folder), seconds=seconds)
    plan = plan_of(storage, asleep, count=TRIALS, heartbeat=2, name=name)
    queue(study_of(plan), plan)
    return plan


def test_two_workers_on_one_storage_need_at_most_three_fifths_of_the_time_of_one(storage, tmp_path, capsys):
    """Sixteen trials of 4 s, each asleep: what is measured is the sharing, and not how busy the processors are."""
    times = []
    for count in (1, 2):
        folder = tmp_path / str(count)
        plan = sleeping(storage, folder, 4.0, f"of {count}")
        with Workers(plan, folder, count, 4.0) as workers:
            began = time.monotonic()
            workers.wait()
            times.append(time.monotonic() - began)
        assert calls_in(folder) == dict.fromkeys(range(TRIALS), 1)
    with capsys.disabled():
        ratio = f"{times[0]:.1f} s with one worker, {times[1]:.1f} s with two: {times[1] / times[0]:.2f}"
        print(f"\n16 trials of 4 s: {ratio}")
    assert times[1] <= 0.6 * times[0]


def test_a_killed_worker_loses_no_finished_trial_and_the_other_finishes_its_own(storage, tmp_path):
    folder = tmp_path / "calls"
    plan = sleeping(storage, folder, 1.0)
    with Workers(plan, folder, 2, 1.0) as workers:
        until(lambda: len(calls_in(folder)) >= 4, 300)
        workers.processes[0].kill()
        workers.processes[0].wait()
        before = [trial for trial in study_of(plan).trials if trial.state.name == "COMPLETE"]
        workers.wait()
    done = dict(finish(plan))
    assert sorted(done) == list(range(TRIALS))
    assert {trial.number: trial.value for trial in before}.items() <= {t.number: t.value for t in done.values()}.items()
    states = counted(study_of(plan))
    assert states["COMPLETE"] == TRIALS
    assert states.get("FAIL", 0) <= 1  # none, if it was killed between two trials
    assert sum(calls_in(folder).values()) <= TRIALS + 1


def test_two_commands_share_a_search_and_one_finishes_what_the_other_began(storage, tmp_path, capsys):
    """Real trainings: the second command is killed while it trains."""
    shared, alone = tmp_path / "shared", tmp_path / "alone"
    words = [*SEARCH, "--trials", "6", "--sampler", "random", "--heartbeat", "2"]
    command = [sys.executable, "-m", "laplace_core", *words, "--runs", str(shared), "--storage", storage]
    first, second = (subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL) for _ in range(2))
    try:
        until(lambda: len(list(shared.glob("laplace_*/resume.safetensors"))) >= 3, 300)
        second.kill()
        assert first.wait(600) == 0
    finally:
        first.kill()
        second.kill()
    found = json.loads((shared / "search.json").read_text())["trials"]
    assert main([*words, "--runs", str(alone), "--json"]) == 0
    expected = json.loads(capsys.readouterr().out)
    assert len(found) == len(expected) == 6
    assert expected[0]["trial"] in [row["trial"] for row in found]
    # Which trial draws which values depends on the order; what the same values are worth does not.
    worth = {json.dumps(row["trial"]): row["scores"] for row in expected}
    assert all(worth.get(json.dumps(row["trial"]), row["scores"]) == row["scores"] for row in found)
    assert len(found) == len({json.dumps(row["trial"]) for row in found})


@pytest.fixture(scope="module")
def cluster():
    pytest.importorskip("ray", reason="pip install -r requirements-cluster.txt")
    with two_nodes() as nodes:
        yield nodes


def test_a_search_and_a_reproduction_on_a_cluster_outlive_a_node(cluster, tmp_path, capsys):
    folder = tmp_path / "calls"
    folder.mkdir()
    plan = plan_of(
        str(tmp_path / "search.journal"), partial(sleeps, folder=str(folder), seconds=1.0), count=TRIALS, heartbeat=2
    )
    done = {}
    for job, trial in finish(plan, cluster=cluster.address):
        done[job] = trial.number
        if len(done) == 4:
            cluster.lose_second_node()
    assert sorted(done) == list(range(TRIALS))
    assert sum(calls_in(folder).values()) <= TRIALS + 1
    runs, out = tmp_path / "runs", tmp_path / "out"
    words = ["reproduce", "multiplexer", "--steps", "300", "--runs", str(runs), "--out", str(out)]
    assert main([*words, "--cluster", cluster.address, "--json"]) == 0
    rows = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert (
        len({row["run"] for row in rows}) == len(rows) == json.loads((out / "multiplexer.json").read_text())["planned"]
    )
