"""Jobs side by side: each is done once, a death costs only its job, and nothing outlives its parent."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import psutil
import pytest

from laplace_core import InputError
from laplace_core.supervise.parallel import in_order, in_parallel
from tests.support.jobs import die, die_once, interrupt_itself, note_and_wait_after, refuse, slow_square, square
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
    sentence = "a process died 3 times without finishing a job, the last time by SIGKILL with 2 to go"
    with pytest.raises(InputError, match=sentence):
        list(in_parallel(die, [1, 2], 2))


def test_results_come_in_order(tmp_path):
    arguments = [(str(tmp_path), number) for number in range(6)]
    assert list(in_order(die_once, arguments, 2)) == [0, 1, 4, 9, 16, 25]  # 3 is done again, after 4 and 5
    assert list(in_order(square, range(4))) == [0, 1, 4, 9]
    assert list(in_order(square, [], 2)) == []


def test_nothing_goes_on_once_results_are_given_up(tmp_path, recwarn):
    """The first two jobs are done, and the two that wait for ever are ended with the generator."""
    results = in_order(note_and_wait_after, [(str(tmp_path), number) for number in range(4)], 2)
    assert [next(results), next(results)] == [0, 1]
    results.close()
    assert not [warning for warning in recwarn if warning.category is UserWarning]
    workers = [psutil.Process(int(file.name)) for file in tmp_path.iterdir() if psutil.pid_exists(int(file.name))]
    until(lambda: all(map(over, workers)))


def over(process: psutil.Process) -> bool:
    return not process.is_running() or process.status() == psutil.STATUS_ZOMBIE


@contextmanager
def at_work(folder: Path) -> Iterator[tuple[subprocess.Popen, list[psutil.Process]]]:
    """A process, the first of a group of its own, whose two workers have begun; killed at the end."""
    code = (
        "from laplace_core.supervise.parallel import in_parallel\n"
        "from tests.support.jobs import note_and_wait\n"
        f"list(in_parallel(note_and_wait, [({str(folder)!r}, 0), ({str(folder)!r}, 1)], 2))\n"
    )
    parent = subprocess.Popen(
        [sys.executable, "-c", code], cwd=ROOT, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    try:
        until(lambda: len(list(folder.iterdir())) == 2)
        yield parent, [psutil.Process(int(file.name)) for file in folder.iterdir()]
    finally:
        parent.kill()
        parent.wait()
        parent.stderr.close()


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM])
def test_workers_end_with_a_parent_that_is_killed(tmp_path, number):
    with at_work(tmp_path) as (parent, workers):
        assert not any(map(over, workers))
        parent.send_signal(number)
        assert parent.wait(60) == -number
        until(lambda: all(map(over, workers)))


def test_ctrl_c_is_for_the_parent_alone():
    assert dict(in_parallel(interrupt_itself, [1, 2], 2)) == {0: 1, 1: 2}


def test_ctrl_c_ends_all_and_no_worker_prints_a_traceback(tmp_path):
    """A terminal sends it to the whole group."""
    with at_work(tmp_path) as (parent, workers):
        os.killpg(parent.pid, signal.SIGINT)
        errors = parent.communicate(timeout=60)[1]
        assert errors.count("Traceback") == 1  # of this script, which is not the command line
        assert "KeyboardInterrupt" in errors
        until(lambda: all(map(over, workers)))


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
