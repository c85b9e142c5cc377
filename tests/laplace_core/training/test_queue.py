"""The queue of runs: two at a time, the others in order; ends, crashes, restarts, and folders full of junk."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from dataclasses import replace
from pathlib import Path

import pytest

from laplace_core.errors import InputError
from laplace_core.supervise import Process, read_process, write_process
from laplace_core.training import queue
from laplace_core.training.loop import train
from laplace_core.training.progress import read_progress
from laplace_core.training.queue import FAILED, FINISHED, STOPPED, STOPPING, TRAINING, WAITING, Queue
from laplace_core.training.run_folder import new_run, read_metrics
from tests.support.hostile import assert_one_sentence
from tests.support.quick_runs import SMALL, added, process_of, states, tell, until

A, B, C, D = (f"laplace_two_branch_{seed}" for seed in range(4))


def told(folder: Path) -> list[dict]:
    """The metrics of a run without the time fields."""
    return [{key: value for key, value in line.items() if key != "seconds"} for line in read_metrics(folder)]


def test_two_train_and_the_others_wait_in_the_order_they_came(still_runs):
    added(still_runs, 4)
    assert states(still_runs) == {A: TRAINING, B: TRAINING, C: WAITING, D: WAITING}
    assert [still_runs.get(name).place for name in (A, B, C, D)] == [0, 0, 1, 2]
    still_runs.tick()
    assert states(still_runs)[C] == WAITING
    tell(still_runs, A, "finish")
    assert still_runs.tick()
    assert states(still_runs) == {A: FINISHED, B: TRAINING, C: TRAINING, D: WAITING}
    assert still_runs.get(D).place == 1


def test_nothing_is_left_to_attend_to_when_all_have_ended(still_runs):
    added(still_runs, 1)
    tell(still_runs, A, "finish")
    still_runs.tick()
    assert not still_runs.tick()


def test_a_run_out_of_the_line_lets_the_next_move_up_and_returns_at_its_end(still_runs):
    added(still_runs, 4)
    still_runs.stop(C)
    assert (still_runs.get(C).state, still_runs.get(D).place) == (STOPPED, 1)
    still_runs.resume(C)
    assert (still_runs.get(D).place, still_runs.get(C).place) == (1, 2)


@pytest.mark.parametrize("stubborn", [False, True])
def test_a_run_that_is_stopped_is_gone_and_goes_on_when_asked(still_runs, stubborn):
    name = still_runs.add(SMALL)
    if stubborn:
        (still_runs.folder / name / "stubborn").touch()
    still_runs.tick()
    process = process_of(still_runs, name)
    still_runs.stop(name, patience=0.1 if stubborn else None)
    assert process.alive == stubborn  # it may be writing its resume point
    if stubborn:
        still_runs.tick()
        assert still_runs.get(name).state == STOPPING
        still_runs.end_at_once(name)
    assert not process.alive
    with pytest.raises(ProcessLookupError):
        os.killpg(process.pid, 0)
    still_runs.tick()
    assert still_runs.get(name).state == STOPPED
    still_runs.resume(name)
    still_runs.tick()
    assert still_runs.get(name).state == TRAINING
    assert process_of(still_runs, name) != process


@pytest.mark.parametrize(
    ("word", "named"), [("crash", "the lamp went out"), ("refuse", "full of sand"), ("vanish", "signal 9")]
)
def test_a_run_that_breaks_off_says_why_in_one_sentence_and_makes_place(still_runs, word, named):
    added(still_runs, 3)
    tell(still_runs, A, word)
    still_runs.tick()
    assert states(still_runs) == {A: FAILED, B: TRAINING, C: TRAINING}
    assert_one_sentence(still_runs.get(A).error, named)
    again = Queue(still_runs.folder)
    again.tick()
    assert again.get(A).state == FAILED
    still_runs.stop(B)
    still_runs.resume(A)
    still_runs.tick()
    assert (still_runs.get(A).state, still_runs.get(A).error) == (TRAINING, None)


def test_another_queue_finds_what_trains_and_what_waits_and_starts_nothing_twice(still_runs):
    added(still_runs, 3)
    before = {name: process_of(still_runs, name) for name in (A, B)}
    again = Queue(still_runs.folder)
    again.tick()
    assert states(again) == {A: TRAINING, B: TRAINING, C: WAITING}
    assert {name: read_process(again.folder / name) for name in (A, B)} == before
    tell(again, B, "finish")
    again.tick()
    assert states(again) == {A: TRAINING, B: FINISHED, C: TRAINING}
    again.stop(A)
    assert not before[A].alive
    still_runs.tick()  # the first one neither restarts it nor calls it failed
    assert still_runs.get(A).state == STOPPED


def test_after_a_restart_runs_whose_process_is_gone_go_on_first_and_by_themselves(still_runs):
    added(still_runs, 3)
    before = {name: process_of(still_runs, name) for name in (A, B)}
    for process in before.values():
        os.kill(process.pid, signal.SIGKILL)
        until(lambda process=process: not process.alive)
    again = Queue(still_runs.folder)
    again.tick()
    assert states(again) == {A: TRAINING, B: TRAINING, C: WAITING}
    assert all(process_of(again, name).pid != before[name].pid for name in (A, B))


def test_a_crash_that_nobody_watched_is_not_tried_again(still_runs):
    added(still_runs, 1)
    tell(still_runs, A, "crash")
    again = Queue(still_runs.folder)
    again.tick()
    assert again.get(A).state == FAILED
    assert "the lamp went out" in again.get(A).error


def test_a_process_that_was_asked_to_end_from_outside_goes_on_after_a_restart_only(still_runs):
    """As when the machine is shut down, or somebody ends it by hand."""
    added(still_runs, 1)
    process = process_of(still_runs, A)
    os.kill(process.pid, signal.SIGTERM)
    until(lambda: not process.alive)
    still_runs.tick()
    still_runs.tick()
    assert still_runs.get(A).state == STOPPED
    again = Queue(still_runs.folder)
    again.tick()
    assert again.get(A).state == TRAINING


def test_queues_and_threads_side_by_side_never_start_a_third(still_runs, monkeypatch):
    start, started, begun = Queue._start, [], []

    def slowly(self, run):
        """No run is started before every other queue and thread is after one as well."""
        started.append(run.name)
        until(lambda: len(begun) == len(threads))
        return start(self, run)

    def tick(one):
        begun.append(one)
        one.tick()

    monkeypatch.setattr(Queue, "_start", slowly)
    for seed in range(6):
        still_runs.add(replace(SMALL, seed=seed))
    others = [Queue(still_runs.folder) for _ in range(4)]
    threads = [threading.Thread(target=tick, args=(one,)) for one in [still_runs, *others] * 3]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert started == [A, B]
    assert sorted(states(still_runs).values()) == [TRAINING] * 2 + [WAITING] * 4
    for run in still_runs.runs():
        still_runs.stop(run.name)


def test_a_removed_run_is_gone_with_its_process_and_its_name_is_free(still_runs):
    added(still_runs, 1)
    process = process_of(still_runs, A)
    still_runs.remove(A)
    assert not process.alive
    assert still_runs.runs() == []
    assert [path.name for path in still_runs.folder.iterdir()] == [".lock"]
    assert still_runs.add(SMALL) == A


def test_the_same_run_is_not_added_twice_and_other_settings_get_another_name(still_runs):
    assert still_runs.add(SMALL) == A
    with pytest.raises(InputError) as refused:
        still_runs.add(SMALL)
    assert_one_sentence(str(refused.value), A)
    assert still_runs.add(replace(SMALL, hidden=9)) == f"{A}_2"


@pytest.mark.parametrize(
    ("changes", "named"),
    [
        ({"hidden": 1024, "features": 512, "gammas": 100, "thetas": 1000, "dueling": True}, "weights"),
    ],
)
def test_what_cannot_be_trained_is_refused_before_anything_is_made(still_runs, changes, named):
    with pytest.raises(InputError) as refused:
        still_runs.add(replace(SMALL, **changes))
    assert_one_sentence(str(refused.value), named)
    assert still_runs.runs() == []


def test_the_line_has_an_end(still_runs, monkeypatch):
    monkeypatch.setattr(queue, "MOST_WAITING", 2)
    added(still_runs, 2)
    added_later = [still_runs.add(replace(SMALL, seed=seed)) for seed in (2, 3)]
    with pytest.raises(InputError) as refused:
        still_runs.add(replace(SMALL, seed=9))
    assert_one_sentence(str(refused.value), "wait already")
    still_runs.stop(added_later[0])
    still_runs.add(replace(SMALL, seed=9))
    with pytest.raises(InputError):
        still_runs.resume(added_later[0])


def test_a_name_that_is_no_run_is_refused(subtests, still_runs):
    for name in ["", "..", "../runs", "nothing", ".lock", "a/b", "x" * 300, "\x00", "é"]:
        with subtests.test(name=name):
            for act in (still_runs.get, still_runs.stop, still_runs.resume, still_runs.remove):
                with pytest.raises(InputError) as refused:
                    act(name)
                assert_one_sentence(str(refused.value).replace("\x00", ""))


def test_a_folder_that_cannot_be_made_is_refused_in_one_sentence(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(InputError) as refused:
        Queue(tmp_path / "file" / "runs")
    assert_one_sentence(str(refused.value), "file")


def test_a_run_that_another_process_trains_is_not_resumed(tmp_path):
    new_run(tmp_path / "one", SMALL)
    other = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"])
    try:
        write_process(tmp_path / "one", Process.of(other.pid))
        half = tmp_path / "one" / "resume.safetensorsx1.tmp"
        half.touch()
        with pytest.raises(InputError) as refused:
            next(train(None, tmp_path / "one", resume=True))
        assert_one_sentence(str(refused.value), "one", str(other.pid))
        assert read_process(tmp_path / "one").pid == other.pid
        assert half.exists()  # the other may be writing it
    finally:
        other.kill()
        other.wait()
    assert list(train(None, tmp_path / "one", resume=True))
    assert not half.exists()
    assert read_process(tmp_path / "one") is None  # nobody trains it any more


@pytest.mark.long
def test_a_real_run_that_was_stopped_and_resumed_is_one_that_was_not(tmp_path):
    """By the queue's own thread and the real command; the stop comes at no particular step."""
    runs, settings = Queue(tmp_path / "runs"), replace(SMALL, steps=1500, evaluate_every=700, checkpoint_every=1500)
    list(train(settings, tmp_path / "whole"))
    name = runs.add(settings)
    folder = runs.folder / name
    # The first step that learns loads parts of torch, which may take longer than a process is given to end.
    until(lambda: (note := read_progress(folder)) and note.step > settings.learning_starts)
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
