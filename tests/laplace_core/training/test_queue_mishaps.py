"""The queue of runs where something goes wrong: folders full of junk or deleted, notes gone, disks full."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import threading
import time

import pytest

from laplace_core.errors import InputError
from laplace_core.supervise import Process, read_process, write_process
from laplace_core.training.progress import read_progress
from laplace_core.training.queue import FAILED, STOPPED, TRAINING, WAITING, Queue
from laplace_core.training.run_folder import new_run
from tests.support.hostile import assert_one_sentence
from tests.support.quick_runs import SMALL, added, process_of, stand_in, states, tell, until

A, B = (f"laplace_two_branch_{seed}" for seed in range(2))


def test_a_run_that_somebody_else_removes_or_resumes_meanwhile(still_runs, monkeypatch):
    end = Queue.end_at_once
    added(still_runs, 1)

    def then(act):
        monkeypatch.setattr(
            Queue, "end_at_once", lambda self, name: (end(self, name), act(Queue(still_runs.folder), name))
        )

    then(lambda other, name: other.resume(name))
    with pytest.raises(InputError) as refused:
        still_runs.remove(A)
    assert_one_sentence(str(refused.value), A, "resumed")
    assert still_runs.get(A).state == WAITING
    then(lambda other, name: other.folder.joinpath(A).rename(other.folder.parent / "elsewhere"))
    with pytest.raises(InputError) as refused:
        still_runs.remove(A)
    assert_one_sentence(str(refused.value), A)
    monkeypatch.setattr(Queue, "end_at_once", end)
    assert still_runs.add(SMALL) == A
    monkeypatch.setattr("os.rename", lambda *paths: (_ for _ in ()).throw(PermissionError(1, "Not permitted")))
    with pytest.raises(InputError) as refused:
        still_runs.remove(A)
    assert_one_sentence(str(refused.value), A, "not permitted")


def test_a_folder_that_is_deleted_meanwhile_is_made_again_by_the_next_run(still_runs):
    added(still_runs, 1)
    tell(still_runs, A, "finish")
    shutil.rmtree(still_runs.folder)
    assert still_runs.runs() == []
    for act in (still_runs.stop, still_runs.resume, still_runs.remove):
        with pytest.raises(InputError) as refused:
            act(A)
        assert_one_sentence(str(refused.value))
    with pytest.raises(InputError):
        still_runs.tick()
    assert not still_runs.folder.exists()
    assert still_runs.add(SMALL) == A


def test_a_process_whose_note_is_gone_is_waited_for(still_runs):
    """A process takes its note away before it ends and before it says why."""
    added(still_runs, 1)
    process = process_of(still_runs, A)
    (still_runs.folder / A / "process.json").unlink()
    for _ in range(2):
        still_runs.tick()
    assert states(still_runs) == {A: WAITING}
    assert read_process(still_runs.folder / A) is None  # not started once more
    (still_runs.folder / A / "end.part").write_text("crash")
    (still_runs.folder / A / "end.part").rename(still_runs.folder / A / "end")
    until(lambda: not process.alive)
    still_runs.tick()
    assert still_runs.get(A).state == FAILED
    assert "the lamp went out" in still_runs.get(A).error


def test_the_thread_outlives_a_full_disk_and_is_replaced_when_it_is_dead(tmp_path, monkeypatch):
    stand_in(monkeypatch)
    runs, tick, full = Queue(tmp_path / "runs"), Queue.tick, [True]

    def failing(self):
        if full and full.pop():
            raise InputError("job.json cannot be written: no space left on device.")
        return tick(self)

    monkeypatch.setattr(Queue, "tick", failing)
    runs.add(SMALL)
    until(lambda: states(runs) == {A: TRAINING})
    assert not full
    runs.stop(A)
    until(lambda: runs._thread is None)
    runs._thread = threading.Thread(target=lambda: None)
    runs._thread.start()
    runs._thread.join()
    runs.resume(A)
    until(lambda: states(runs) == {A: TRAINING})
    runs.stop(A)


def test_junk_in_the_folder_is_passed_over_and_broken_runs_can_only_be_removed(still_runs, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    new_run(elsewhere, SMALL)
    (still_runs.folder / "link").symlink_to(elsewhere)
    (still_runs.folder / "note.txt").write_text("hello")
    (still_runs.folder / "empty").mkdir()
    (still_runs.folder / "bad name").mkdir()
    (still_runs.folder / "bad name" / "config.json").write_text("{}")
    os.mkfifo(still_runs.folder / "pipe")
    for i, text in enumerate([b"", b"{", b"[]", b"null", b"\xff" * 50, b"[" * 10**5, b" " * 200_000, b"1" * 5000]):
        (still_runs.folder / f"broken_{i}").mkdir()
        (still_runs.folder / f"broken_{i}" / "config.json").write_bytes(text)
    (still_runs.folder / "outside").mkdir()
    (still_runs.folder / "outside" / "config.json").symlink_to(elsewhere / "config.json")
    still_runs.tick()
    found = still_runs.runs()
    assert {run.name for run in found} == {f"broken_{i}" for i in range(8)}
    for run in found:
        assert (run.state, run.settings) == (FAILED, None)
        assert_one_sentence(run.error)
        (run.folder / "inner").symlink_to(elsewhere)
        still_runs.resume(run.name)
        still_runs.remove(run.name)
    assert still_runs.runs() == []
    assert (elsewhere / "config.json").exists()


NONSENSE = (
    *(b"", b"{}", b"[]", b"\xff", b"[" * 10**5, b"9" * 5000),
    *(b'{"pid": -1, "started": "x"}', b'{"pid": 1, "started": "x"}', b'{"pid": true, "started": 3}'),
    *(b'{"wanted": "fly", "ticket": "1"}', b'{"wanted": "fail", "ticket": 1, "error": 7}'),
    b'{"pid": 5, "step": NaN, "of": 1, "steps_per_second": 1}',
    b'{"pid": 5, "step": -1, "of": 0, "steps_per_second": "x"}',
)


@pytest.mark.parametrize("file", ["job.json", "process.json", "progress.json", "errors.txt"])
def test_notes_that_hold_nonsense_leave_a_run_that_is_stopped(still_runs, file):
    for i, text in enumerate(NONSENSE):
        new_run(still_runs.folder / f"run_{i}", SMALL)
        (still_runs.folder / f"run_{i}" / file).write_bytes(text)
    still_runs.tick()
    assert set(states(still_runs).values()) == {STOPPED}
    assert all(read_progress(run.folder) is None for run in still_runs.runs())
    still_runs.resume("run_3")
    still_runs.tick()
    assert still_runs.get("run_3").state == TRAINING


def test_a_number_given_out_anew_is_not_taken_for_the_process_of_a_run(still_runs):
    new_run(still_runs.folder / "one", SMALL)
    other = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"])
    try:
        assert Process.of(other.pid).alive
        write_process(still_runs.folder / "one", Process(other.pid, time.time() - 3600))
        assert still_runs.get("one").state == STOPPED
        still_runs.stop("one")
        assert other.poll() is None
    finally:
        other.kill()
        other.wait()
    assert not Process.of(other.pid).alive
