"""The verb ``learn`` and the process behind a page: progress, whole snapshots at any moment, an end when asked for."""

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from laplace_core import InputError, load_world
from laplace_core.cli import main
from laplace_core.supervise import Process, Worker
from laplace_core.tabular import Learning, LearnSettings, Run, read_learned, start
from laplace_core.worlds import dump_world
from tests.support.hostile import assert_one_sentence, assert_refused

LONG = LearnSettings(seeds=2, episodes=500_000)
PROGRESS = {"episodes", "of", "steps", "steps_per_second", "return", "error", "seconds", "eta", "finished"}
COMMAND = [sys.executable, "-m", "laplace_core", "learn"]


def wait_for(condition, seconds: float = 60.0, every: float = 0.02):
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        if found := condition():
            return found
        time.sleep(every)
    raise AssertionError(f"not within {seconds} s")


def wait_for_snapshots(out: Path, count: int) -> None:
    """Until so many snapshots have been at ``out``, one after another."""
    seen: set[int] = set()

    def there() -> bool:
        if out.exists():
            seen.add(out.stat().st_mtime_ns)
        return len(seen) >= count

    wait_for(there)


def being_written(folder: Path) -> bool:
    """Whether a file that has no name yet holds something already."""
    with contextlib.suppress(FileNotFoundError):  # it may have been given its name meanwhile
        return any(path.stat().st_size for path in folder.glob("*.tmp"))
    return False


@pytest.fixture
def run(tmp_path):
    """Start runs that end with the test."""
    started = []

    def begin(world, settings):
        folder = tmp_path / f"run {len(started)}"
        folder.mkdir()
        started.append(start(world, settings, folder))
        return started[-1]

    yield begin
    for one in started:
        one.cancel()


# --- the command ---


def test_a_table_tells_the_error_of_every_seed_and_its_actions(capsys):
    assert main(["learn", "two_branch", "--seeds", "2", "--seed", "7"]) == 0
    out, err = capsys.readouterr()
    lines = out.splitlines()
    assert err == ""  # no terminal, no moving line
    assert lines[0].startswith("two_branch: 2 x 200 episodes, ")
    assert lines[2].split() == ["seed", "7", "0.000%", "1-2", "short,", "3", "long"]
    assert lines[3].startswith("  seed 8 ")
    assert lines[4].split() == ["best", "1-2", "short,", "3", "long"]


def test_json_lines_end_with_the_result(capsys):
    assert main(["learn", "two_branch", "--seeds", "2", "--json"]) == 0
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert set(lines[0]) == set(lines[-2]) == PROGRESS
    assert lines[-2]["finished"]
    assert lines[-1]["optimal_action"] == [0, 0, 1]
    assert [seed["chosen_action"] for seed in lines[-1]["seeds"]] == [[0, 0, 1]] * 2


def test_the_file_is_what_was_learned(tmp_path, capsys):
    out, progress = tmp_path / "agent.safetensors", tmp_path / "progress.jsonl"
    words = ["learn", "two_decisions", "--param", "slip=0.1", "--episodes", "50", "--policy", "per_gamma", "--peers"]
    assert main([*words, "--out", str(out), "--progress", str(progress)]) == 0
    learned = read_learned(out)
    assert learned.finished
    learning = Learning(load_world("two_decisions", {"slip": 0.1}), LearnSettings(50, policy="per_gamma", peers=True))
    for _ in learning:
        pass
    np.testing.assert_array_equal(learned.basis, learning.snapshot().basis)
    np.testing.assert_array_equal(learned.peers.quantile, learning.snapshot().peers.quantile)
    lines = [json.loads(line) for line in progress.read_text().splitlines()]
    assert [line["finished"] for line in lines] == [False] * (len(lines) - 1) + [True]
    assert set(lines[-1]) == PROGRESS


def test_a_learned_file_is_decoded_like_a_world(tmp_path, capsys):
    path, out = tmp_path / "agent.safetensors", tmp_path / "study.npz"
    words = ["learn", "two_branch", "--param", "slip=0.3", "--seeds", "2", "--episodes", "20", "--out", str(path)]
    assert main(words) == 0
    capsys.readouterr()
    words = ["decode", str(path), "--seed-index", "1", "--state", "start", "--steps", "5"]
    assert main([*words, "--out", str(out)]) == 0
    printed = capsys.readouterr().out
    assert "true" in printed
    with np.load(out) as file:
        first = file["tau_space"]
        assert file["true_tau_space"].shape == first.shape == (2, 5, 149)
        command = json.loads(str(file["settings"]))["command"]
    again = tmp_path / "again.npz"  # the command in the file repeats it
    subprocess.run([sys.executable, *command.split()[1:], "--out", str(again)], check=True, capture_output=True)
    with np.load(again) as file:
        np.testing.assert_array_equal(file["tau_space"], first)
    assert main(["decode", str(path), "--seed-index", "0", "--steps", "5", "--out", str(again)]) == 0
    with np.load(again) as file:
        assert not np.array_equal(file["tau_space"], first)


def test_what_does_not_fit_is_refused(tmp_path, capsys):
    path = tmp_path / "agent.safetensors"
    assert main(["learn", "two_branch", "--episodes", "3", "--out", str(path)]) == 0
    own = str(path)
    for words, named in [
        (["learn", "nowhere"], "nowhere"),
        (["learn", own], "no world"),
        (["learn", "space.npz"], "no world"),
        (["learn", "two_branch", "--episodes", "0"], "episodes"),
        (["learn", "two_branch", "--epsilon-floor", "-1"], "epsilon_floor"),
        (["learn", "two_branch", "--peers", "perhaps"], "peers"),
        (["learn", "two_branch", "--param", "slip"], "slip"),
        (["learn", "two_branch", "--out", "agent.npz"], ".safetensors"),
        (["learn", "two_branch", "--out", str(tmp_path / "missing" / "a.safetensors")], "missing"),
        (["learn", "two_branch", "--progress", str(tmp_path / "missing" / "a.jsonl")], "missing"),
        (["learn", "two_branch", "--progress", "a\0b"], "name of a file"),
        (["decode", own, "--gammas", "9"], "--gammas"),
        (["decode", own, "--policy", "per_gamma"], "--policy"),
        (["decode", own, "--seed-index", "1"], "seed_index"),
        (["decode", own, "--seed-index", "-1"], "seed"),
        (["decode", own, "--seed-index", "first"], "seed_index"),
        (["decode", own, "--param", "slip=0.1"], "seed_index"),
        (["decode", own, "--state", "nowhere"], "nowhere"),
        (["decode", "two_branch", "--seed-index", "1"], "seed_index"),
        (["decode", str(tmp_path / "missing.safetensors")], "missing"),
    ]:
        assert_refused(capsys, words, named)
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["agent.safetensors"]


def test_sigterm_ends_it_and_leaves_a_whole_file(tmp_path):
    out = tmp_path / "agent.safetensors"
    words = [*COMMAND, "cliff_grid", "--episodes", "500000", "--max-steps", "100000", "--out", str(out)]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        wait_for_snapshots(out, 2)
        process.send_signal(signal.SIGTERM)
        assert process.communicate(timeout=60) == (b"", b"")
        assert process.returncode == 128 + signal.SIGTERM
    finally:
        process.kill()
        process.wait()
    assert not read_learned(out).finished
    assert [entry.name for entry in tmp_path.iterdir()] == ["agent.safetensors"]


@pytest.mark.parametrize(
    ("end", "snapshots"), [pytest.param(signal.SIGTERM, 1, marks=pytest.mark.long), (signal.SIGKILL, 2)]
)
def test_killed_at_any_moment_the_file_is_whole(tmp_path, end, snapshots):
    """Killed in the middle of a snapshot, after some whole ones: something is in the file that is to take its place."""
    out = tmp_path / "agent.safetensors"
    words = ["gym:Taxi-v4", "--episodes", "500000", "--gammas", "30", "--out", str(out)]
    process = subprocess.Popen([*COMMAND, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        wait_for_snapshots(out, snapshots)
        wait_for(lambda: being_written(tmp_path), every=0.0)
        process.send_signal(end)
        assert process.communicate(timeout=60)[1] == b""
    finally:
        process.kill()
        process.wait()
    assert not read_learned(out).finished
    left = {entry.suffix for entry in tmp_path.iterdir()}
    assert left == {".safetensors"} if end == signal.SIGTERM else left <= {".safetensors", ".tmp"}


# --- the process ---


def test_a_run_is_watched_to_its_end(run):
    one = run(load_world("two_branch", {"slip": 0.1}), LearnSettings(seeds=2))
    wait_for(lambda: one.finished)
    assert one.error is None
    assert one.progress()["finished"]
    learned = one.snapshot()
    assert learned.finished
    assert learned.world is load_world("two_branch", {"slip": 0.1})
    assert one.snapshot() is learned
    assert one.history()[-1] == one.progress()
    one.cancel()
    assert not one.cancelled


@pytest.mark.parametrize("as_text", [False, True])
def test_a_run_shows_itself_grow_and_is_cancelled(run, as_text):
    world = load_world("cliff_grid", {"slip": 0.1})
    one = run(dump_world(world) if as_text else world, LONG)
    first = wait_for(one.snapshot)
    later = wait_for(lambda: one.snapshot() is not first and one.snapshot())
    assert sum(first.episodes) < sum(later.episodes) < sum((500_000, 500_000))
    assert set(one.progress()) == PROGRESS
    assert [line["episodes"] for line in one.history()] == sorted(line["episodes"] for line in one.history())
    assert not one.finished
    one.cancel()
    assert one.finished
    assert one.cancelled
    assert one.error is None
    assert not one.snapshot().finished
    assert dump_world(one.snapshot().world) == dump_world(world)


def test_a_run_cancelled_before_it_began_has_nothing(run):
    one = run(load_world("cliff_grid"), LONG)
    one.cancel()
    assert one.finished
    assert one.snapshot() is None
    assert one.progress() is None


def test_a_line_of_progress_in_the_making_is_left_for_later(tmp_path):
    process = subprocess.Popen([sys.executable, "-c", ""])
    worker = Worker(tmp_path, Process.of(process.pid), process)
    one = Run(worker, tmp_path / "a.safetensors", tmp_path / "progress.jsonl")
    with (tmp_path / "progress.jsonl").open("w") as file:
        for text, seen in [('{"episodes": 1}\n{"epi', 1), ('sodes": 2', 1), ("}\n", 2), ("", 2)]:
            file.write(text)
            file.flush()
            assert [line["episodes"] for line in one.history()] == list(range(1, seen + 1))
    assert process.wait(10) == 0


def test_a_bad_run_is_refused_before_a_process_is_started(tmp_path):
    for world, settings, folder in [
        ("{}", LearnSettings(), tmp_path),
        (load_world("two_branch"), LearnSettings(), tmp_path / "missing"),
    ]:
        with pytest.raises(InputError) as refused:
            start(world, settings, folder)
        assert_one_sentence(f"laplace: {refused.value}")
    assert not list(tmp_path.iterdir())


def test_a_run_that_fails_says_why_in_one_sentence(run, tmp_path):
    one = run(load_world("cliff_grid"), LONG)
    wait_for(one.snapshot)
    os.killpg(one._worker.process.pid, signal.SIGKILL)  # as the system does when memory is short
    wait_for(lambda: one.finished)
    assert_one_sentence(f"laplace: {one.error}", "unexpectedly")
    folder = tmp_path / "spoilt"
    folder.mkdir()
    (folder / "progress.jsonl").mkdir()
    spoilt = start(load_world("two_branch"), LearnSettings(), folder)
    wait_for(lambda: spoilt.finished)
    assert_one_sentence(f"laplace: {spoilt.error}", "progress.jsonl")


def test_a_run_ends_with_the_process_that_started_it(tmp_path):
    code = (
        "import sys, time\nfrom laplace_core import load_world\nfrom laplace_core.tabular import LearnSettings, start\n"
        "one = start(load_world('cliff_grid'), LearnSettings(episodes=500_000), sys.argv[1])\n"
        "while one.snapshot() is None: time.sleep(.02)\nprint(one._worker.process.pid)"
    )
    parent = subprocess.run([sys.executable, "-c", code, str(tmp_path)], capture_output=True, text=True, check=True)
    child = Path(f"/proc/{int(parent.stdout)}/stat")
    if not child.parent.parent.joinpath("self").exists():
        pytest.skip("no /proc here")
    wait_for(lambda: not child.exists() or child.read_text().split()[2] == "Z", 5.0)
    assert not read_learned(tmp_path / "learned.safetensors").finished
