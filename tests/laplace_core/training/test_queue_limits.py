"""What a queue grants its runs: places, environments, room on the disk; and who has a run in several containers."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from contextlib import contextmanager
from dataclasses import asdict, replace
from pathlib import Path

import pytest

from laplace_core.errors import InputError
from laplace_core.supervise import Process, is_taken, read_process, take, write_process
from laplace_core.training import disk
from laplace_core.training.disk import check_free, held
from laplace_core.training.job import Job, asked_to_stop, owner_of, read_job, write_job
from laplace_core.training.loop import train
from laplace_core.training.queue import FAILED, STOPPED, STOPPING, TRAINING, WAITING, Queue, bytes_of_run
from laplace_core.training.run_folder import FILES, new_run, read_metrics
from tests.support.hostile import assert_one_sentence
from tests.support.quick_runs import SMALL, added, process_of, states, tell

A, B, C = (f"laplace_two_branch_{seed}" for seed in range(3))
HOLDER = """
import sys
from pathlib import Path
from laplace_core.supervise import take
lock = take(Path(sys.argv[1]))
print(lock is not None, flush=True)
sys.stdin.readline()
"""


@pytest.fixture
def holder():
    """Processes that have the lock of a folder."""
    begun = []

    def hold(folder: Path) -> subprocess.Popen:
        words = [sys.executable, "-c", HOLDER, str(folder)]
        begun.append(subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True))
        assert begun[-1].stdout.readline() == "True\n"
        return begun[-1]

    yield hold
    for each in begun:
        each.kill()
        each.wait()


# --- files of the wrong kind fail one run, and only that one ---


@pytest.mark.parametrize("name", ["errors.txt", "process.json", "job.json"])
def test_a_folder_in_the_place_of_a_file_fails_that_run_and_the_others_go_on(still_runs, name):
    for seed in range(3):
        still_runs.add(replace(SMALL, seed=seed))
    (still_runs.folder / A / name).unlink(missing_ok=True)
    (still_runs.folder / A / name).mkdir()
    for _ in range(2):
        still_runs.tick()
    found = states(still_runs)
    # Without a note of the queue a run is one that nobody has asked to be trained.
    assert found == {A: STOPPED if name == "job.json" else FAILED, B: TRAINING, C: TRAINING}
    if name != "job.json":
        assert_one_sentence(still_runs.get(A).error, name, "is a directory")
    (still_runs.folder / A / name).rmdir()
    still_runs.stop(B)
    still_runs.resume(A)
    still_runs.tick()
    assert (still_runs.get(A).state, still_runs.get(A).error) == (TRAINING, None)


def test_a_run_that_can_be_neither_started_nor_noted_fails_and_the_others_go_on(still_runs, monkeypatch):
    """The disk of its folder breaks between two looks: no note can be written any more."""
    from laplace_core.training import queue

    for seed in range(2):
        still_runs.add(replace(SMALL, seed=seed))
    write = queue.write_job

    def broken(path, job):
        if path.name == A:
            raise InputError("job.json cannot be written: input/output error.")
        write(path, job)

    with monkeypatch.context() as failing:
        failing.setattr(queue, "write_job", broken)
        assert still_runs.tick()
        assert states(still_runs) == {A: FAILED, B: TRAINING}
        assert_one_sentence(still_runs.get(A).error, "job.json", "input/output error")
    still_runs.resume(A)
    still_runs.tick()
    assert states(still_runs)[A] == TRAINING


@pytest.mark.parametrize("name", FILES[1:])
def test_a_folder_in_the_place_of_any_file_is_refused_by_the_command(tmp_path, name):
    """Something else in the place of the last checkpoint is noticed before the training, not after it."""
    new_run(tmp_path / "one", SMALL)
    (tmp_path / "one" / name).mkdir()
    with pytest.raises(InputError) as refused:
        next(train(None, tmp_path / "one", resume=True))
    assert_one_sentence(str(refused.value), name)
    assert not is_taken(tmp_path / "one")


def test_metrics_that_are_no_text_or_no_json_are_one_sentence(subtests, tmp_path):
    for content in (b"\xff\xfe\n", b"{\n", b"[1,\n"):
        with subtests.test(content=content):
            (tmp_path / "metrics.jsonl").write_bytes(content)
            with pytest.raises(InputError) as refused:
                read_metrics(tmp_path)
            assert_one_sentence(str(refused.value), "metrics.jsonl")


@contextmanager
def as_somebody_else():
    """Without the rights of root, if these tests run with them."""
    if os.geteuid():
        yield
        return
    os.seteuid(65534)
    try:
        yield
    finally:
        os.seteuid(0)


def test_a_folder_that_may_not_be_looked_into_hides_no_other_run(tmp_path):
    with tempfile.TemporaryDirectory() as name:
        runs = Path(name)
        new_run(runs / "one", SMALL)
        new_run(runs / "closed", SMALL)
        runs.chmod(0o755)
        (runs / "closed").chmod(0)
        try:
            with as_somebody_else():
                assert [run.name for run in Queue(runs, read_only=True).runs()] == ["one"]
        finally:
            (runs / "closed").chmod(0o755)


def test_a_reason_at_the_end_of_many_messages_is_found(still_runs):
    """Two megabytes of warnings, as a library that repeats itself writes them."""
    added(still_runs, 1)
    process_of(still_runs, A)
    with (still_runs.folder / A / "errors.txt").open("a") as file:
        file.write("a warning\n" * 200_000)
    tell(still_runs, A, "refuse")
    still_runs.tick()
    assert_one_sentence(still_runs.get(A).error, "full of sand")


# --- one run, several containers ---


def elsewhere(pid: int, started: float | None = None) -> Process:
    """A process of another container, which may have the number of one that runs here."""
    return Process(pid, time.time() if started is None else started, "another container")


def test_a_process_of_another_container_is_neither_known_here_nor_ended(tmp_path, holder):
    new_run(tmp_path / "one", SMALL)
    stranger = holder(tmp_path / "one")
    noted = replace(Process.of(stranger.pid), place="another container")
    assert Process.of(stranger.pid).alive
    assert not noted.alive
    assert not noted.same(Process.of(stranger.pid))
    noted.end(0.1)
    noted.ask()
    assert stranger.poll() is None
    write_process(tmp_path / "one", noted)
    assert read_process(tmp_path / "one") == noted


def test_a_run_that_another_container_trains_is_trained_once(tmp_path, still_runs, holder):
    """A process number means nothing there, so its note says nothing about it here; the lock does."""
    still_runs.add(SMALL)
    folder = still_runs.folder / A
    other = holder(folder)
    write_job(folder, Job("run", 1, begun=True))
    write_process(folder, elsewhere(other.pid, started=1.0))
    for _ in range(2):
        still_runs.tick()
    assert still_runs.get(A).state == TRAINING
    assert not (folder / "began").exists()
    with pytest.raises(InputError) as refused:
        next(train(None, folder, resume=True))
    assert_one_sentence(str(refused.value), A, "another process")
    other.kill()
    other.wait()
    still_runs.tick()
    still_runs.tick()
    assert still_runs.get(A).state == TRAINING
    process_of(still_runs, A)  # ours


def test_a_process_of_another_container_that_is_about_to_take_the_lock_is_waited_for(still_runs):
    still_runs.add(SMALL)
    folder = still_runs.folder / A
    write_job(folder, Job("run", 1, begun=True))
    write_process(folder, elsewhere(30))
    still_runs.tick()
    assert still_runs.get(A).state == TRAINING
    assert not (folder / "began").exists()
    write_process(folder, elsewhere(30, started=time.time() - 120))
    for _ in range(2):
        still_runs.tick()
    process_of(still_runs, A)


def test_a_run_of_another_container_is_asked_to_end_by_a_file(still_runs, holder):
    still_runs.add(SMALL)
    folder = still_runs.folder / A
    other, before = holder(folder), time.time() - 1.0
    write_job(folder, Job("run", 1, begun=True))
    write_process(folder, elsewhere(other.pid))
    still_runs.stop(A, patience=0.0)
    assert still_runs.get(A).state == STOPPING
    assert asked_to_stop(folder, before)
    assert not asked_to_stop(folder, time.time() + 1.0)
    assert other.poll() is None
    other.communicate("\n")
    write_process(folder, elsewhere(other.pid, started=1.0))
    still_runs.tick()
    assert still_runs.get(A).state == STOPPED
    still_runs.resume(A)
    still_runs.tick()
    assert not (folder / "stop").exists()


def test_a_lock_goes_with_its_process_and_is_given_back_by_a_run_that_ends(tmp_path, holder):
    new_run(tmp_path, SMALL)
    other = holder(tmp_path)
    assert is_taken(tmp_path)
    other.kill()
    other.wait()
    assert not is_taken(tmp_path)
    events = train(None, tmp_path, resume=True)
    next(events)
    assert is_taken(tmp_path)
    events.close()
    assert not is_taken(tmp_path)
    lock = take(tmp_path)
    lock.release()


# --- room on the disk ---


def test_what_a_run_holds_is_counted(tmp_path):
    (tmp_path / "one").mkdir()
    (tmp_path / "one" / "a").write_bytes(b"x" * 1_000)
    (tmp_path / "b").write_bytes(b"x" * 10)
    (tmp_path / "link").symlink_to(tmp_path / "one")
    assert held(tmp_path) == 1_010 + len(str(tmp_path / "one"))  # a link holds the name of what it leads to
    assert held(tmp_path / "nothing") == 0


def test_a_run_is_promised_what_it_will_take_at_the_most(tmp_path):
    """Two resume points side by side for a moment, and two checkpoints, with their headers of some kilobytes."""
    for changes in ({"prioritised": True}, {"environment": "CartPole-v1", "dueling": True}):
        settings = replace(SMALL, steps=300, evaluate_every=300, **changes)
        folder = tmp_path / str(len(changes))
        list(train(settings, folder))
        files = {name: (folder / f"{name}.safetensors").stat().st_size for name in ("resume", "best", "last")}
        promised, taken = bytes_of_run(settings), 2 * files["resume"] + files["best"] + files["last"]
        assert promised == pytest.approx(taken, abs=4 * 10_000)


def test_a_run_that_does_not_fit_the_limit_is_refused_and_nothing_is_made(tmp_path):
    need = bytes_of_run(SMALL)
    runs = Queue(tmp_path / "runs", most_bytes=need - 1)
    with pytest.raises(InputError) as refused:
        runs.add(SMALL)
    assert_one_sentence(str(refused.value), "remove runs", f"{need / 1e6:,.1f} MB")
    assert runs.runs() == []


def test_room_is_promised_to_runs_that_have_not_begun(still_runs, monkeypatch):
    monkeypatch.setattr(still_runs, "_most_bytes", round(1.5 * bytes_of_run(SMALL)))
    still_runs.add(SMALL)
    with pytest.raises(InputError) as refused:
        still_runs.add(replace(SMALL, seed=1))
    assert_one_sentence(str(refused.value), "remove runs")


def test_a_run_that_waited_until_there_was_no_room_fails_with_a_sentence(still_runs, monkeypatch):
    still_runs.add(SMALL)
    monkeypatch.setattr(still_runs, "_most_bytes", 1_000)
    still_runs.tick()
    assert states(still_runs) == {A: FAILED}
    assert_one_sentence(still_runs.get(A).error, "remove runs")


def test_a_full_disk_is_said_before_anything_is_written(tmp_path, monkeypatch):
    check_free(tmp_path, 1_000, None)
    with pytest.raises(InputError) as refused:
        check_free(tmp_path, 10**18, None)
    assert_one_sentence(str(refused.value), "free")
    monkeypatch.setattr(disk, "RESERVE", 10**18)
    with pytest.raises(InputError) as refused:
        Queue(tmp_path / "runs").add(SMALL)
    assert_one_sentence(str(refused.value), "free")


def test_a_resume_point_without_room_ends_the_run_and_the_last_one_stays(tmp_path):
    folder, most = tmp_path / "run", 10**9
    story = train(replace(SMALL, steps=10_000), folder, most_bytes=most)
    while not (folder / "resume.safetensors").exists():
        next(story)
    kept = (folder / "resume.safetensors").read_bytes()
    story.close()
    with pytest.raises(InputError) as refused:
        list(train(None, folder, resume=True, most_bytes=held(tmp_path) + 100))
    assert_one_sentence(str(refused.value), "remove runs")
    assert (folder / "resume.safetensors").read_bytes() == kept
    assert sorted(path.name for path in folder.iterdir() if path.suffix == ".tmp") == []
    assert next(train(None, folder, resume=True)).step // 200 == 1


def test_a_run_that_could_not_write_its_resume_point_when_it_was_stopped_says_so(still_runs):
    added(still_runs, 1)
    process_of(still_runs, A)
    write_job(still_runs.folder / A, Job("stop", 0, begun=True))
    tell(still_runs, A, "refuse")
    still_runs.tick()
    assert states(still_runs) == {A: FAILED}
    assert_one_sentence(still_runs.get(A).error, "full of sand")


# --- what a server grants ---


def test_places_and_environments_of_a_queue(tmp_path):
    runs = Queue(tmp_path / "runs", 1, allowed=lambda environment: environment != "CartPole-v1")
    with pytest.raises(InputError) as refused:
        runs.add(replace(SMALL, environment="CartPole-v1"))
    assert_one_sentence(str(refused.value), "CartPole-v1")
    none = Queue(tmp_path / "runs", 0)
    with pytest.raises(InputError) as refused:
        none.add(SMALL)
    assert_one_sentence(str(refused.value), "trains nothing")
    new_run(tmp_path / "runs" / "pole", replace(SMALL, environment="CartPole-v1"))
    with pytest.raises(InputError) as refused:
        runs.resume("pole")
    assert_one_sentence(str(refused.value), "CartPole-v1")
    assert runs.get("pole").state == STOPPED


def test_a_run_that_waits_for_an_environment_which_is_not_trained_on_fails(still_runs, monkeypatch):
    still_runs.add(SMALL)
    monkeypatch.setattr(still_runs, "_allowed", lambda environment: False)
    still_runs.tick()
    assert_one_sentence(still_runs.get(A).error, "two_branch")


def test_a_queue_that_only_shows_changes_nothing(still_runs):
    still_runs.add(SMALL)
    new_run(still_runs.folder / "other", replace(SMALL, seed=5))
    before = sorted(path.stat().st_mtime_ns for path in still_runs.folder.rglob("*"))
    runs = Queue(still_runs.folder, read_only=True)
    assert states(runs) == {A: WAITING, "other": STOPPED}
    for act in (runs.stop, runs.resume, runs.remove, runs.end_at_once):
        with pytest.raises(InputError) as refused:
            act(A)
        assert_one_sentence(str(refused.value), "only shows")
    with pytest.raises(InputError):
        runs.add(replace(SMALL, seed=7))
    with pytest.raises(InputError):
        runs.tick()
    assert sorted(path.stat().st_mtime_ns for path in still_runs.folder.rglob("*")) == before
    nowhere = Queue(still_runs.folder / "nowhere", read_only=True)
    assert nowhere.runs() == []
    assert not nowhere.folder.exists()


def test_the_owner_of_a_run_is_kept_and_nonsense_is_nobody(subtests, still_runs):
    name = still_runs.add(SMALL, owner="5f")
    assert owner_of(still_runs.folder / name) == "5f"
    still_runs.stop(name)
    still_runs.resume(name)
    assert owner_of(still_runs.folder / name) == "5f"
    for text in (b"", b"{}", b"[]", b'{"owner": 7}', b"\xff", b"[" * 900):
        with subtests.test(text=text):
            (still_runs.folder / name / "owner.json").write_bytes(text)
            assert owner_of(still_runs.folder / name) is None


def test_notes_have_the_form_that_version_0_2_reads(still_runs):
    added(still_runs, 1)
    assert set(json.loads((still_runs.folder / A / "job.json").read_text())) == set(asdict(Job("run", 1)))
    assert read_job(still_runs.folder / A).begun
