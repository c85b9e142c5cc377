"""Jobs side by side: each is done once, a death costs only its job, and nothing outlives its parent."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import psutil
import pytest

from laplace_core import InputError
from laplace_core.supervise.parallel import in_parallel
from tests.support.jobs import die, die_once, refuse, slow_square, square
from tests.support.quick_runs import until
from tests.support.ray_cluster import two_nodes

ROOT = Path(__file__).parents[3]


@pytest.mark.parametrize("processes", [1, 2])
def test_every_job_has_its_result(processes):
    assert dict(in_parallel(square, range(7), processes)) == {i: i * i for i in range(7)}
    assert list(in_parallel(square, [], processes)) == []


@pytest.mark.parametrize("processes", [1, 2])
def test_what_a_job_raises_is_raised(processes):
    with pytest.raises(InputError, match=r"number \d is refused"):
        list(in_parallel(refuse, [1, 2], processes))


def test_a_job_whose_process_dies_is_done_again(tmp_path):
    arguments = [(str(tmp_path), number) for number in range(6)]
    assert dict(in_parallel(die_once, arguments, 2)) == {i: i * i for i in range(6)}
    assert (tmp_path / "3").read_text().count("\n") == 2


def test_a_job_that_always_kills_its_process_is_given_up():
    with pytest.raises(InputError, match="a process died 3 times without finishing a job, the last time with 2 to go"):
        list(in_parallel(die, [1, 2], 2))


def test_workers_end_with_a_parent_that_is_killed(tmp_path):
    code = (
        "from laplace_core.supervise.parallel import in_parallel\n"
        "from tests.support.jobs import note_and_wait\n"
        f"list(in_parallel(note_and_wait, [({str(tmp_path)!r}, 0), ({str(tmp_path)!r}, 1)], 2))\n"
    )
    parent = subprocess.Popen([sys.executable, "-c", code], cwd=ROOT)
    try:
        until(lambda: len(list(tmp_path.iterdir())) == 2)
        workers = [int(file.name) for file in tmp_path.iterdir()]
        assert all(psutil.pid_exists(pid) for pid in workers)
    finally:
        parent.send_signal(signal.SIGKILL)
        parent.wait()
    until(lambda: not any(psutil.pid_exists(pid) for pid in workers))


def test_a_cluster_that_is_not_there_is_one_sentence():
    with pytest.raises(InputError, match=r"a cluster needs Ray|there is no Ray cluster at 127\.0\.0\.1:1"):
        list(in_parallel(square, [1], cluster="127.0.0.1:1"))


@pytest.mark.long
def test_a_lost_node_of_a_cluster_costs_only_its_jobs(tmp_path):
    pytest.importorskip("ray", reason="pip install -r requirements-cluster.txt")
    arguments, done = [(str(tmp_path), number) for number in range(60)], {}
    with two_nodes() as cluster:
        for i, result in in_parallel(slow_square, arguments, cluster=cluster.address):
            done[i] = result
            if len(done) == 10:
                cluster.lose_second_node()
    assert done == {i: i * i for i in range(60)}
    calls = [file.read_text().count("\n") for file in tmp_path.iterdir()]
    assert len(calls) == 60
    assert sum(calls) <= 60 + 2  # at most what the lost node had finished and not yet told
