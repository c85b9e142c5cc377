"""The queue of runs: two at a time, the others in order; ends, crashes, restarts, and folders full of junk."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from dataclasses import replace
from pathlib import Path

import pytest

from laplace_core.errors import InputError
from laplace_core.training import queue
from laplace_core.training.loop import train
from laplace_core.training.process import Process, read_process, write_process
from laplace_core.training.progress import read_progress
from laplace_core.training.queue import FAILED, FINISHED, STOPPED, TRAINING, WAITING, Queue
from laplace_core.training.run_folder import new_run, read_metrics
from tests.hostile import assert_one_sentence
from tests.quick_runs import SMALL, stand_in, states, tell, until

A, B, C, D = (f"laplace_two_branch_{seed}" for seed in range(4))


@pytest.fixture
def runs(tmp_path, monkeypatch):
    """An empty queue that moves only when a test ticks it."""
    stand_in(monkeypatch)
    monkeypatch.setattr(Queue, "wake", lambda self: None)
    made = Queue(tmp_path / "runs")
    yield made
    for run in made.runs():
        made.stop(run.name)


def added(runs: Queue, count: int) -> None:
    for seed in range(count):
        runs.add(replace(SMALL, seed=seed))
    runs.tick()


def told(folder: Path) -> list[dict]:
    """The metrics of a run without the time fields."""
    return [{key: value for key, value in line.items() if key != "seconds"} for line in read_metrics(folder)]


def process_of(runs: Queue, name: str) -> Process:
    """Of a run whose process has really begun."""
    until(lambda: (runs.folder / name / "began").exists())
    return read_process(runs.folder / name)


def test_two_train_and_the_others_wait_in_the_order_they_came(runs):
    added(runs, 4)
    assert states(runs) == {A: TRAINING, B: TRAINING, C: WAITING, D: WAITING}
    assert [runs.get(name).place for name in (A, B, C, D)] == [0, 0, 1, 2]
    runs.tick()
    assert states(runs)[C] == WAITING
    tell(runs, A, "finish")
    assert runs.tick()
    assert states(runs) == {A: FINISHED, B: TRAINING, C: TRAINING, D: WAITING}
    assert runs.get(D).place == 1


def test_nothing_is_left_to_attend_to_when_all_have_ended(runs):
    added(runs, 1)
    tell(runs, A, "finish")
    runs.tick()
    assert not runs.tick()


def test_a_run_out_of_the_line_lets_the_next_move_up_and_returns_at_its_end(runs):
    added(runs, 4)
    runs.stop(C)
    assert (runs.get(C).state, runs.get(D).place) == (STOPPED, 1)
    runs.resume(C)
    assert (runs.get(D).place, runs.get(C).place) == (1, 2)


@pytest.mark.parametrize("stubborn", [False, True])
def test_a_run_that_is_stopped_is_gone_and_goes_on_when_asked(runs, stubborn):
    name = runs.add(SMALL)
    if stubborn:
        (runs.folder / name / "stubborn").touch()
    runs.tick()
    process, began = process_of(runs, name), time.monotonic()
    runs.stop(name)
    took = time.monotonic() - began
    assert not process.alive
    assert took < 10  # some two seconds, on a machine that does nothing else
    with pytest.raises(ProcessLookupError):
        os.killpg(process.pid, 0)
    runs.tick()
    assert runs.get(name).state == STOPPED
    runs.resume(name)
    runs.tick()
    assert runs.get(name).state == TRAINING
    assert process_of(runs, name) != process


@pytest.mark.parametrize(
    ("word", "named"), [("crash", "the lamp went out"), ("refuse", "full of sand"), ("vanish", "signal 9")]
)
def test_a_run_that_breaks_off_says_why_in_one_sentence_and_makes_place(runs, word, named):
    added(runs, 3)
    tell(runs, A, word)
    runs.tick()
    assert states(runs) == {A: FAILED, B: TRAINING, C: TRAINING}
    assert_one_sentence(runs.get(A).error, named)
    again = Queue(runs.folder)
    again.tick()
    assert again.get(A).state == FAILED
    runs.stop(B)
    runs.resume(A)
    runs.tick()
    assert (runs.get(A).state, runs.get(A).error) == (TRAINING, None)


def test_another_queue_finds_what_trains_and_what_waits_and_starts_nothing_twice(runs):
    added(runs, 3)
    before = {name: process_of(runs, name) for name in (A, B)}
    again = Queue(runs.folder)
    again.tick()
    assert states(again) == {A: TRAINING, B: TRAINING, C: WAITING}
    assert {name: read_process(again.folder / name) for name in (A, B)} == before
    tell(again, B, "finish")
    again.tick()
    assert states(again) == {A: TRAINING, B: FINISHED, C: TRAINING}
    again.stop(A)
    assert not before[A].alive
    runs.tick()  # the first one neither restarts it nor calls it failed
    assert runs.get(A).state == STOPPED


def test_after_a_restart_runs_whose_process_is_gone_go_on_first_and_by_themselves(runs):
    added(runs, 3)
    before = {name: process_of(runs, name) for name in (A, B)}
    for process in before.values():
        os.kill(process.pid, signal.SIGKILL)
        until(lambda process=process: not process.alive)
    again = Queue(runs.folder)
    again.tick()
    assert states(again) == {A: TRAINING, B: TRAINING, C: WAITING}
    assert all(process_of(again, name).pid != before[name].pid for name in (A, B))


def test_a_crash_that_nobody_watched_is_not_tried_again(runs):
    added(runs, 1)
    tell(runs, A, "crash")
    again = Queue(runs.folder)
    again.tick()
    assert again.get(A).state == FAILED
    assert "the lamp went out" in again.get(A).error


def test_a_process_that_was_asked_to_end_from_outside_goes_on_after_a_restart_only(runs):
    """As when the machine is shut down, or somebody ends it by hand."""
    added(runs, 1)
    process = process_of(runs, A)
    os.kill(process.pid, signal.SIGTERM)
    until(lambda: not process.alive)
    runs.tick()
    runs.tick()
    assert runs.get(A).state == STOPPED
    again = Queue(runs.folder)
    again.tick()
    assert again.get(A).state == TRAINING


def test_queues_and_threads_side_by_side_never_start_a_third(runs, monkeypatch):
    start, started = Queue._start, []

    def slowly(self, run):
        started.append(run.name)
        time.sleep(0.2)
        start(self, run)

    monkeypatch.setattr(Queue, "_start", slowly)
    for seed in range(6):
        runs.add(replace(SMALL, seed=seed))
    others = [Queue(runs.folder) for _ in range(4)]
    threads = [threading.Thread(target=one.tick) for one in [runs, *others] * 3]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert started == [A, B]
    assert sorted(states(runs).values()) == [TRAINING] * 2 + [WAITING] * 4
    for run in runs.runs():
        runs.stop(run.name)


def test_a_removed_run_is_gone_with_its_process_and_its_name_is_free(runs):
    added(runs, 1)
    process = process_of(runs, A)
    runs.remove(A)
    assert not process.alive
    assert runs.runs() == []
    assert [path.name for path in runs.folder.iterdir()] == [".lock"]
    assert runs.add(SMALL) == A


def test_the_same_run_is_not_added_twice_and_other_settings_get_another_name(runs):
    assert runs.add(SMALL) == A
    with pytest.raises(InputError) as refused:
        runs.add(SMALL)
    assert_one_sentence(str(refused.value), A)
    assert runs.add(replace(SMALL, hidden=9)) == f"{A}_2"


@pytest.mark.parametrize(
    ("changes", "named"),
    [
        ({"hidden": 1024, "features": 512, "gammas": 100, "thetas": 1000, "dueling": True}, "weights"),
        ({"environment": "gym:Taxi-v4", "buffer": 10**6}, "buffer"),
    ],
)
def test_what_cannot_be_trained_is_refused_before_anything_is_made(runs, changes, named):
    with pytest.raises(InputError) as refused:
        runs.add(replace(SMALL, **changes))
    assert_one_sentence(str(refused.value), named)
    assert runs.runs() == []


def test_the_line_has_an_end(runs, monkeypatch):
    monkeypatch.setattr(queue, "MOST_WAITING", 2)
    added(runs, 2)
    added_later = [runs.add(replace(SMALL, seed=seed)) for seed in (2, 3)]
    with pytest.raises(InputError) as refused:
        runs.add(replace(SMALL, seed=9))
    assert_one_sentence(str(refused.value), "wait already")
    runs.stop(added_later[0])
    runs.add(replace(SMALL, seed=9))
    with pytest.raises(InputError):
        runs.resume(added_later[0])


@pytest.mark.parametrize("name", ["", "..", "../runs", "nothing", ".lock", "a/b", "x" * 300, "\x00", "é"])
def test_a_name_that_is_no_run_is_refused(runs, name):
    for act in (runs.get, runs.stop, runs.resume, runs.remove):
        with pytest.raises(InputError) as refused:
            act(name)
        assert_one_sentence(str(refused.value).replace("\x00", ""))


def test_a_folder_that_cannot_be_made_is_refused_in_one_sentence(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(InputError) as refused:
        Queue(tmp_path / "file" / "runs")
    assert_one_sentence(str(refused.value), "file")


def test_junk_in_the_folder_is_passed_over_and_broken_runs_can_only_be_removed(runs, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    new_run(elsewhere, SMALL)
    (runs.folder / "link").symlink_to(elsewhere)
    (runs.folder / "note.txt").write_text("hello")
    (runs.folder / "empty").mkdir()
    (runs.folder / "bad name").mkdir()
    (runs.folder / "bad name" / "config.json").write_text("{}")
    os.mkfifo(runs.folder / "pipe")
    for i, text in enumerate([b"", b"{", b"[]", b"null", b"\xff" * 50, b"[" * 10**5, b" " * 200_000, b"1" * 5000]):
        (runs.folder / f"broken_{i}").mkdir()
        (runs.folder / f"broken_{i}" / "config.json").write_bytes(text)
    (runs.folder / "outside").mkdir()
    (runs.folder / "outside" / "config.json").symlink_to(elsewhere / "config.json")
    runs.tick()
    found = runs.runs()
    assert {run.name for run in found} == {f"broken_{i}" for i in range(8)}
    for run in found:
        assert (run.state, run.settings) == (FAILED, None)
        assert_one_sentence(run.error)
        (run.folder / "inner").symlink_to(elsewhere)
        runs.resume(run.name)
        runs.remove(run.name)
    assert runs.runs() == []
    assert (elsewhere / "config.json").exists()


NONSENSE = (
    *(b"", b"{}", b"[]", b"\xff", b"[" * 10**5, b"9" * 5000),
    *(b'{"pid": -1, "started": "x"}', b'{"pid": 1, "started": "x"}', b'{"pid": true, "started": 3}'),
    *(b'{"wanted": "fly", "ticket": "1"}', b'{"wanted": "fail", "ticket": 1, "error": 7}'),
    b'{"pid": 5, "step": NaN, "of": 1, "steps_per_second": 1}',
    b'{"pid": 5, "step": -1, "of": 0, "steps_per_second": "x"}',
)


@pytest.mark.parametrize("file", ["job.json", "process.json", "progress.json", "errors.txt"])
def test_notes_that_hold_nonsense_leave_a_run_that_is_stopped(runs, file):
    for i, text in enumerate(NONSENSE):
        new_run(runs.folder / f"run_{i}", SMALL)
        (runs.folder / f"run_{i}" / file).write_bytes(text)
    runs.tick()
    assert set(states(runs).values()) == {STOPPED}
    assert all(read_progress(run.folder) is None for run in runs.runs())
    runs.resume("run_3")
    runs.tick()
    assert runs.get("run_3").state == TRAINING


def test_a_number_given_out_anew_is_not_taken_for_the_process_of_a_run(runs):
    new_run(runs.folder / "one", SMALL)
    other = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"])
    try:
        assert Process.of(other.pid).alive
        write_process(runs.folder / "one", Process(other.pid, "another time"))
        assert runs.get("one").state == STOPPED
        runs.stop("one")
        assert other.poll() is None
    finally:
        other.kill()
        other.wait()
    assert not Process.of(other.pid).alive


def test_a_run_that_another_process_trains_is_not_resumed(tmp_path):
    new_run(tmp_path / "one", SMALL)
    other = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"])
    try:
        write_process(tmp_path / "one", Process.of(other.pid))
        with pytest.raises(InputError) as refused:
            next(train(None, tmp_path / "one", resume=True))
        assert_one_sentence(str(refused.value), "one", str(other.pid))
        assert read_process(tmp_path / "one").pid == other.pid
    finally:
        other.kill()
        other.wait()
    assert list(train(None, tmp_path / "one", resume=True))
    assert read_process(tmp_path / "one") is None  # nobody trains it any more


def test_a_real_run_that_was_stopped_and_resumed_is_one_that_was_not(tmp_path):
    """By the queue's own thread and the real command; the stop comes at no particular step."""
    runs, settings = Queue(tmp_path / "runs"), replace(SMALL, steps=1500, evaluate_every=700, checkpoint_every=1500)
    list(train(settings, tmp_path / "whole"))
    name = runs.add(settings)
    folder = runs.folder / name
    until(lambda: (note := read_progress(folder)) and note.step > 0)
    assert runs.get(name).state == TRAINING
    runs.stop(name)
    assert runs.get(name).state == STOPPED
    assert (folder / "resume.safetensors").exists()
    runs.resume(name)
    until(lambda: runs.get(name).state == FINISHED)
    told = [
        [{k: v for k, v in e.items() if k != "seconds"} for e in read_metrics(f)] for f in (folder, tmp_path / "whole")
    ]
    assert told[0] == told[1]
    assert read_progress(folder).step >= settings.steps
