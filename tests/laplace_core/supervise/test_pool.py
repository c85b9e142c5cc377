"""Calls in several processes: in order, made again where a process was killed, and ended with their parent."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from functools import partial
from pathlib import Path

import psutil
import pytest

from laplace_core.errors import InputError
from laplace_core.supervise import in_processes
from tests.support.hostile import assert_one_sentence
from tests.support.quick_runs import until

ROOT = Path(__file__).resolve().parents[3]
PARENT = """
import sys
from functools import partial
from pathlib import Path
from laplace_core.supervise import in_processes
from tests.laplace_core.supervise.test_pool import waits
if __name__ == "__main__":
    list(in_processes(partial(waits, folder=Path(sys.argv[1])), range(2), 2))
"""


def square(number: int) -> int:
    return number * number


def once_killed(number: int, folder: Path) -> int:
    """The first call of an odd number kills its process, as the system does where memory is short."""
    if number % 2 and not (folder / str(number)).exists():
        (folder / str(number)).touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return number


def always_killed(number: int) -> int:
    if number == 1:
        os.kill(os.getpid(), signal.SIGKILL)
    return number


def refuses(number: int) -> int:
    if number == 2:
        raise InputError("two is refused.")
    if number == 5:
        raise OSError("five")
    return number


def waits(number: int, folder: Path) -> None:
    (folder / str(os.getpid())).touch()
    until(lambda: False)


def began(folder: Path) -> list[psutil.Process]:
    until(lambda: len(list(folder.iterdir())) == 2)
    return [psutil.Process(int(path.name)) for path in folder.iterdir()]


def over(process: psutil.Process) -> bool:
    return not process.is_running() or process.status() == psutil.STATUS_ZOMBIE


@pytest.mark.parametrize("jobs", [1, 3])
def test_results_come_in_order(jobs):
    assert list(in_processes(square, range(7), jobs)) == [0, 1, 4, 9, 16, 25, 36]
    assert list(in_processes(square, [], jobs)) == []


def test_a_call_whose_process_was_killed_is_made_again(tmp_path):
    assert list(in_processes(partial(once_killed, folder=tmp_path), range(5), 2)) == [0, 1, 2, 3, 4]
    assert {path.name for path in tmp_path.iterdir()} == {"1", "3"}


def test_a_call_that_kills_every_process_is_one_sentence():
    with pytest.raises(InputError) as refused:
        list(in_processes(always_killed, range(4), 2))
    assert_one_sentence(str(refused.value), "signal 9", "3 times")


def test_what_a_call_raises_is_raised_here_and_nothing_runs_on():
    for number, kind in ((2, InputError), (5, OSError)):
        results = in_processes(refuses, [0, 1, number, 3, 4], 2)
        assert [next(results), next(results)] == [0, 1]
        with pytest.raises(kind):
            next(results)
    assert not [one for one in psutil.Process().children() if "spawn_main" in str(one.cmdline())]


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM])
def test_workers_end_with_a_parent_that_is_killed(tmp_path, number):
    parent = subprocess.Popen([sys.executable, "-c", PARENT, str(tmp_path)], cwd=ROOT, stderr=subprocess.PIPE)
    workers = began(tmp_path)
    parent.send_signal(number)
    assert parent.wait(60) == -number
    parent.stderr.close()
    for worker in workers:
        until(lambda worker=worker: over(worker))


def test_ctrl_c_ends_all_and_no_worker_prints_a_traceback(tmp_path):
    """A terminal sends it to the whole group."""
    parent = subprocess.Popen(
        [sys.executable, "-c", PARENT, str(tmp_path)], cwd=ROOT, stderr=subprocess.PIPE, text=True,
        start_new_session=True,
    )  # fmt: skip
    workers = began(tmp_path)
    os.killpg(parent.pid, signal.SIGINT)
    errors = parent.communicate(timeout=60)[1]
    assert errors.count("Traceback") == 1  # of this script, which is not the command line
    assert "KeyboardInterrupt" in errors
    for worker in workers:
        until(lambda worker=worker: over(worker))
