"""Processes beside the application: known again, ended with what they started, and no lock that outlives one."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from pathlib import Path

import psutil
import pytest

from laplace_core.errors import InputError
from laplace_core.supervise import ONE_THREAD, End, Process, Worker, read_process, start, write_process
from laplace_core.training.queue import Queue
from tests.support.hostile import assert_one_sentence
from tests.support.quick_runs import until

STUBBORN = "import signal, time; signal.signal(signal.SIGTERM, signal.SIG_IGN); print(flush=True); time.sleep(60)"
FAMILY = f"""
import subprocess, sys, time
child = subprocess.Popen([sys.executable, "-c", {STUBBORN!r}], stdout=subprocess.PIPE, start_new_session=True)
child.stdout.readline()
print(child.pid, flush=True)
time.sleep(60)
"""
HOLDER = """
import sys
from pathlib import Path
from laplace_core.training.queue import Queue
with Queue(sys.argv[1])._locked():
    print(flush=True)
    sys.stdin.readline()
    Path(sys.argv[1], "given").touch()  # the last thing before the lock is given back
"""


@pytest.fixture
def begin():
    begun = []

    def one(code: str, *words: str) -> subprocess.Popen:
        begun.append(
            subprocess.Popen([sys.executable, "-c", code, *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        )
        return begun[-1]

    yield one
    for each in begun:
        each.kill()
        each.wait()


def test_a_process_ends_with_all_that_it_has_started(begin):
    parent = begin(FAMILY)
    process, child = Process.of(parent.pid), Process.of(int(parent.stdout.readline()))
    assert process.alive
    assert child.alive
    process.end(0.3)
    assert not process.alive
    assert not child.alive  # it has a session of its own, and does not hear SIGTERM
    assert parent.wait(5) == -signal.SIGTERM  # its status is left to who started it


def test_a_process_that_does_not_hear_is_killed(begin):
    one = begin(STUBBORN)
    one.stdout.readline()
    Process.of(one.pid).end(0.3)
    assert one.wait(5) == -signal.SIGKILL


def test_a_process_that_nobody_has_waited_for_is_over(begin):
    one = begin("")
    process = Process.of(one.pid)
    until(lambda: not process.alive)
    assert one.returncode is None
    assert not Process.of(one.pid).alive
    process.end()


def test_a_number_given_out_anew_is_another_process(begin):
    one = begin(STUBBORN)
    this = Process.of(one.pid)
    other = Process(one.pid, this.started - 60)
    assert this.same(this)
    assert not this.same(other)
    assert not this.same(None)
    other.end(0.1)
    assert this.alive


def test_a_note_is_read_as_it_was_written(tmp_path):
    own = Process.of(os.getpid())
    write_process(tmp_path, own)
    assert read_process(tmp_path) == own


def test_a_note_with_no_time_is_none(subtests, tmp_path):
    for started in ["null", "true", "-1", "1e300", "1" * 400, "[]"]:
        with subtests.test(started=started):
            (tmp_path / "process.json").write_text(f'{{"pid": 1000, "started": {started}}}')
            assert read_process(tmp_path) is None


@pytest.mark.skipif(not Path("/proc/sys/kernel/random/boot_id").exists(), reason="notes of this kind are from Linux")
def test_a_process_that_version_0_2_has_noted_is_known_again(tmp_path, begin):
    pid = begin(STUBBORN).pid
    boot = Path("/proc/sys/kernel/random/boot_id").read_text().strip()
    ticks = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[19]
    note = tmp_path / "process.json"
    note.write_text(f'{{"pid": {pid}, "started": "{boot} {ticks}"}}')
    assert read_process(tmp_path).alive
    for word in (f"another-boot {ticks}", f"{boot} {int(ticks) - 60_000}", f"{boot} {'9' * 4000}", boot, "over", ""):
        note.write_text(f'{{"pid": {pid}, "started": "{word}"}}')
        assert not read_process(tmp_path).alive


def test_a_process_that_is_started_has_one_thread_and_no_link_is_written_through(tmp_path):
    (tmp_path / "precious").write_text("kept")
    (tmp_path / "errors.txt").symlink_to(tmp_path / "precious")
    code = "import os, sys; print(sys.stdin.read(), os.environ['OMP_NUM_THREADS'], file=sys.stderr)"
    assert start([sys.executable, "-c", code], tmp_path / "errors.txt").wait(60) == 0
    assert (tmp_path / "errors.txt").read_text() == " 1\n"
    assert (tmp_path / "precious").read_text() == "kept"
    assert set(ONE_THREAD.values()) == {"1"}


def test_a_lock_that_a_killed_process_has_left_does_not_block(tmp_path, begin):
    holder = begin(HOLDER, str(tmp_path / "runs"))
    holder.stdout.readline()
    assert psutil.pid_exists(holder.pid)
    holder.kill()
    holder.wait()
    assert not Queue(tmp_path / "runs").tick()


def test_a_queue_waits_while_another_process_has_the_lock(tmp_path, begin):
    given, when_ready = tmp_path / "runs" / "given", []
    holder = begin(HOLDER, str(tmp_path / "runs"))
    holder.stdout.readline()
    waiting = threading.Thread(target=lambda: when_ready.append((Queue(tmp_path / "runs"), given.exists())[1]))
    waiting.start()
    holder.communicate(b"\n", timeout=60)
    waiting.join(60)
    assert when_ready == [True]
    assert holder.returncode == 0


@pytest.mark.parametrize("exists", [True, False])
def test_a_lock_that_is_a_link_is_refused(tmp_path, exists):
    (tmp_path / "runs").mkdir()
    if exists:
        (tmp_path / "precious").write_text("kept")
    (tmp_path / "runs" / ".lock").symlink_to(tmp_path / "precious")
    with pytest.raises(InputError) as refused:
        Queue(tmp_path / "runs")
    assert_one_sentence(str(refused.value), "runs")
    assert (tmp_path / "precious").exists() == exists


def test_a_worker_is_noted_and_another_server_finds_it_and_ends_it(tmp_path):
    worker = Worker.start(tmp_path, [sys.executable, "-c", "import time; time.sleep(60)"])
    found = Worker.noted(tmp_path)
    assert found.process == worker.process
    assert (found.end, worker.end) == (None, None)
    found.stop(0.3)
    until(lambda: worker.ended)
    assert found.end == End(None, "")  # only who started it hears of its status
    assert worker.end == End(-signal.SIGTERM, "")
    assert worker.end.asked


def test_a_worker_that_cannot_be_noted_does_not_run(tmp_path):
    (tmp_path / "process.json").mkdir()
    with pytest.raises(InputError) as refused:
        Worker.start(tmp_path, [sys.executable, "-c", f"import time; time.sleep(60); {tmp_path.name!r}"])
    assert_one_sentence(str(refused.value), "process.json")
    assert not [one for one in psutil.Process().children() if tmp_path.name in str(one.cmdline())]


@pytest.mark.parametrize(
    ("code", "refusal", "fault", "killed_by"),
    [
        ("import sys; sys.exit('laplace: it is full.')", "it is full.", None, None),
        ("raise RuntimeError('the lamp went out.')", None, "the lamp went out", None),
        ("raise AssertionError", None, "a fault of the program", None),
        ("import os, signal; os.kill(os.getpid(), signal.SIGKILL)", None, None, signal.SIGKILL),
        ("import sys; sys.exit('hm')", None, None, None),
    ],
)
def test_a_worker_says_how_it_ended(tmp_path, code, refusal, fault, killed_by):
    worker = Worker.start(tmp_path, [sys.executable, "-c", code])
    until(lambda: worker.ended)
    assert (worker.end.refusal, worker.end.fault, worker.end.signal) == (refusal, fault, killed_by)
    assert not worker.end.asked
