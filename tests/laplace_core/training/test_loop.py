"""Runs: their events, the same ones twice, and the same ones again after a kill."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from laplace_core.acting.evaluation import evaluate
from laplace_core.agents import LaplaceSettings
from laplace_core.environments import vector
from laplace_core.errors import InputError
from laplace_core.files.tensor_file import read_tensors, write_tensors
from laplace_core.supervise import Process, read_process
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.training.events import Checkpoint, Episode, Evaluation, Resumed, Step
from laplace_core.training.loop import train
from laplace_core.training.replay import Replay
from laplace_core.training.run_folder import read_config, read_metrics
from tests.support.hostile import assert_one_sentence

TINY = LaplaceSettings(
    hidden=16, features=4, gammas=4, thetas=7, batch=16, steps=700, envs=3, buffer=400, learning_starts=100,
    update_every=10, updates=2, evaluate_every=250, evaluate_episodes=3, checkpoint_every=200, n_step=2,
)  # fmt: skip
ROOT = Path(__file__).resolve().parents[3]
CHILD = """
import json, sys
from laplace_core.agents import LaplaceSettings
from laplace_core.acting.evaluation import evaluate
from laplace_core.training.events import Step
from laplace_core.training.loop import train
from laplace_core.supervise import Process, read_process
for event in train(LaplaceSettings.parse(json.loads(sys.argv[1])), sys.argv[2]):
    if not isinstance(event, Step):
        print(type(event).__name__, getattr(event, "path", ""), flush=True)
"""


def told(folder: Path) -> list[dict]:
    """The metrics of a run without the time fields."""
    return [{key: value for key, value in line.items() if key != "seconds"} for line in read_metrics(folder)]


def same_weights(one: Path, other: Path) -> bool:
    states = [load_checkpoint(folder / "last.safetensors").agent.target.state_dict() for folder in (one, other)]
    return all(np.array_equal(states[0][name], states[1][name]) for name in states[0])


@pytest.fixture(scope="module")
def whole(tmp_path_factory) -> Path:
    """An uninterrupted run of CartPole."""
    folder = tmp_path_factory.mktemp("whole") / "run"
    list(train(TINY, folder))
    return folder


def test_a_run_tells_its_story(tmp_path):
    events = list(train(TINY, tmp_path / "run"))
    kinds = {kind: [event for event in events if isinstance(event, kind)] for kind in (Episode, Evaluation, Checkpoint)}
    assert [event.step for event in kinds[Evaluation]] == sorted(event.step for event in kinds[Evaluation])
    # Evaluations at the first steps at or beyond 250 and 500, and at the end.
    assert [event.step // 250 for event in kinds[Evaluation]] == [1, 2, 2]
    resume = [event.step // 200 for event in kinds[Checkpoint] if event.path == "resume.safetensors"]
    assert resume == [1, 2, 3, 3]
    assert kinds[Evaluation][-1].step >= TINY.steps
    assert all(event.episode == i + 1 for i, event in enumerate(kinds[Episode]))
    # CartPole pays 1 a step, and every transition belongs to an episode, the unfinished ones at the end aside.
    assert all(event.episode_return == event.length for event in kinds[Episode])
    assert sum(event.length for event in kinds[Episode]) <= TINY.steps + 3
    losses = [event.loss for event in kinds[Episode]]
    assert losses[0] is None
    assert max(loss for loss in losses if loss is not None) > 0
    written = [event for event in events if not isinstance(event, Step)]
    assert [line["event"] for line in read_metrics(tmp_path / "run")] == [type(event).__name__ for event in written]


def test_the_checkpoint_is_the_agent_of_the_best_evaluation(whole):
    best = max(line["score"] for line in told(whole) if line["event"] == "Evaluation")
    loaded = load_checkpoint(whole / "best.safetensors")
    assert loaded.score == best
    assert loaded.settings == TINY
    assert load_checkpoint(whole / "last.safetensors").step >= TINY.steps
    assert read_config(whole / "config.json") == TINY


@pytest.mark.parametrize(
    "changes",
    [
        {"environment": "two_branch"},
        {"prioritised": True, "n_step": 1},
        {"experience": "per_discount", "batch": 4},
        {"target_policy": "per_gamma", "network": "multiplexer", "termination": "auxiliary", "steps": 300},
        {"parametrisation": "accumulated", "dueling": True, "steps": 300},
    ],
    ids=lambda changes: next(iter(changes.values())),
)
def test_the_same_settings_give_the_same_metrics_also_across_a_stop(tmp_path, changes):
    settings = replace(TINY, **changes)
    for name in ("one", "other"):
        list(train(settings, tmp_path / name))
    assert told(tmp_path / "one") == told(tmp_path / "other")
    stop_at(settings, tmp_path / "stopped", settings.steps - 80)
    list(train(None, tmp_path / "stopped", resume=True))
    assert told(tmp_path / "stopped") == told(tmp_path / "one")
    assert same_weights(tmp_path / "stopped", tmp_path / "one")


def stop_at(settings, folder: Path, step: int) -> None:
    """Leave a run in the middle, as a closed generator does."""
    for event in train(settings, folder):
        if event.step >= step:
            return


def test_another_seed_gives_other_metrics(tmp_path, whole):
    list(train(replace(TINY, seed=1), tmp_path / "run"))
    assert told(tmp_path / "run") != told(whole)


@pytest.mark.parametrize("step", [50, 199, 401, 640])
def test_a_run_left_anywhere_goes_on_to_the_same_end(tmp_path, whole, step):
    """Also before the first resume point, from where it begins again."""
    folder = tmp_path / "run"
    stop_at(TINY, folder, step)
    events = list(train(TINY, folder, resume=True))
    assert isinstance(events[0], Resumed) == (step > 200)
    assert told(folder) == told(whole)
    assert same_weights(folder, whole)


@pytest.mark.parametrize("checkpoints", [1, pytest.param(5, marks=pytest.mark.long)])
def test_a_killed_run_goes_on_to_the_same_end(tmp_path, whole, checkpoints):
    """SIGKILL while the child is at work on what follows its first or fifth file."""
    folder = tmp_path / "run"
    child = subprocess.Popen(
        [sys.executable, "-c", CHILD, json.dumps(TINY.as_dict()), str(folder)],
        stdout=subprocess.PIPE, text=True, cwd=ROOT,
    )  # fmt: skip
    seen = 0
    for line in child.stdout:
        seen += line.startswith("Checkpoint")
        if seen == checkpoints:
            child.send_signal(signal.SIGKILL)
            break
    assert child.wait() == -signal.SIGKILL
    child.stdout.close()
    assert told(folder) != told(whole)
    list(train(None, folder, resume=True))
    assert told(folder) == told(whole)
    assert same_weights(folder, whole)


def test_what_was_half_written_is_cut_away(tmp_path, whole):
    folder = tmp_path / "run"
    stop_at(TINY, folder, 450)
    with (folder / "metrics.jsonl").open("a") as file:
        file.write('{"event": "Episode", "step": 4')
    (folder / "resume.safetensorsx1.tmp").write_bytes(b"half")
    list(train(None, folder, resume=True))
    assert told(folder) == told(whole)
    assert not list(folder.glob("*.tmp"))


def test_a_run_of_millions_of_updates_is_resumed_but_not_one_of_absurd_weights(tmp_path):
    folder = tmp_path / "run"
    stop_at(TINY, folder, 450)
    arrays, about = read_tensors(folder / "resume.safetensors", 10**9)
    arrays["optimiser.0.step"] = np.full_like(arrays["optimiser.0.step"], 3e6)
    write_tensors(folder / "resume.safetensors", arrays, about)
    assert isinstance(next(train(None, folder, resume=True)), Resumed)
    for name, value in (("network.trunk.0.bias", 3e6), ("optimiser.0.exp_avg", np.nan), ("replay.rewards", np.inf)):
        write_tensors(folder / "resume.safetensors", arrays | {name: np.full_like(arrays[name], value)}, about)
        with pytest.raises(InputError, match="holds a value that is not a number within") as refused:
            next(train(None, folder, resume=True))
        assert_one_sentence(str(refused.value), name.removeprefix("network.").removeprefix("replay."))


def test_a_finished_run_has_nothing_left_to_do(tmp_path):
    settings = replace(TINY, steps=150)
    list(train(settings, tmp_path / "run"))
    before = told(tmp_path / "run")
    assert [type(event) for event in train(None, tmp_path / "run", resume=True)] == [Resumed]
    assert told(tmp_path / "run") == before


def test_an_environment_that_cannot_be_saved_goes_on_with_new_episodes(tmp_path, monkeypatch):
    monkeypatch.setattr(vector, "_savable", lambda env: False)
    folder = tmp_path / "run"
    stop_at(TINY, folder, 450)
    cuts = []
    monkeypatch.setattr(Replay, "cut", lambda replay: cuts.append(len(replay)))
    resumed = next(train(None, folder, resume=True))
    assert isinstance(resumed, Resumed)
    assert not resumed.exact
    stored = read_tensors(folder / "resume.safetensors", 10**9)[0]["replay.sizes"].sum()
    assert cuts == [stored]  # before anything new
    assert "new episode" in resumed.message
    events = list(train(None, folder, resume=True))
    assert events[-1].step >= TINY.steps
    assert [line["event"] for line in told(folder)].count("Resumed") == 1
    # The third run went on from the same point as the second: the metrics were cut back in between.
    lengths = [event.length for event in events if isinstance(event, Episode)]
    assert sum(lengths) <= TINY.steps - 400 + 3


def test_evaluations_start_where_training_never_does(monkeypatch, tmp_path):
    seeds = []
    make = vector.make

    def spied(name):
        env = make(name)
        reset = env.reset

        def spy(*, seed=None, options=None):
            seeds.append(seed)
            return reset(seed=seed, options=options)

        env.reset = spy
        return env

    monkeypatch.setattr("laplace_core.training.loop.make", spied)
    monkeypatch.setattr(vector, "make", spied)
    list(train(replace(TINY, steps=300), tmp_path / "run"))
    given = {seed for seed in seeds if seed is not None}
    training = {seed for seed in given if seed < 10**9}
    assert len(training) == 3
    assert given - training == {10**12 + i for i in range(3)}


# Refusals


def test_a_run_is_not_overwritten(whole):
    with pytest.raises(InputError, match="holds a run already"):
        next(train(TINY, whole))


def test_a_run_is_not_resumed_with_other_settings(whole):
    with pytest.raises(InputError, match="other settings"):
        next(train(replace(TINY, seed=1), whole, resume=True))


def test_there_must_be_a_run_to_resume(tmp_path):
    with pytest.raises(InputError, match="cannot be read"):
        next(train(None, tmp_path, resume=True))


def test_a_spoiled_config_is_refused(subtests, tmp_path):
    for config in [
        "", "[]", '{"algorithm": "laplace"}', '{"algorithm": [], "settings": {}}',
        '{"algorithm": "x", "settings": {}}', '{"algorithm": "laplace", "settings": {"steps": -1}}',
        '{"algorithm": "laplace", "settings": {"stps": 1}}',
    ]:  # fmt: skip
        with subtests.test(config=config):
            (tmp_path / "config.json").write_text(config)
            with pytest.raises(InputError):
                next(train(None, tmp_path, resume=True))


@pytest.mark.parametrize("kept", [0, 5, 2_000, -1])
def test_a_cut_resume_point_is_refused(tmp_path, kept):
    folder = tmp_path / "run"
    stop_at(TINY, folder, 300)
    data = (folder / "resume.safetensors").read_bytes()
    (folder / "resume.safetensors").write_bytes(data[:kept])
    with pytest.raises(InputError, match=r"resume\.safetensors"):
        next(train(None, folder, resume=True))


def test_metrics_cut_by_hand_are_refused(tmp_path):
    folder = tmp_path / "run"
    stop_at(TINY, folder, 300)
    (folder / "metrics.jsonl").write_text("")
    with pytest.raises(InputError, match="changed by hand"):
        next(train(None, folder, resume=True))


def test_networks_that_no_checkpoint_could_hold_are_refused(tmp_path):
    with pytest.raises(InputError, match="weights"):
        next(train(replace(TINY, hidden=1024, features=512, gammas=100, thetas=1000), tmp_path / "run"))


@pytest.mark.parametrize("environment", ["CartPole-v1", "two_branch"])
def test_a_run_that_is_asked_to_stop_goes_on_from_that_very_step_as_if_it_never_had(tmp_path, environment):
    settings = replace(TINY, environment=environment, steps=500)
    list(train(settings, tmp_path / "whole"))
    for limit in (37, 249, 251, 480):
        seen = [0]
        for event in train(settings, tmp_path / str(limit), stop=lambda seen=seen, limit=limit: seen[0] >= limit):
            seen[0] = event.step
        assert seen[0] < settings.steps
        assert next(train(None, tmp_path / str(limit), resume=True)).step == seen[0]
        list(train(None, tmp_path / str(limit), resume=True))
        assert told(tmp_path / str(limit)) == told(tmp_path / "whole")
        assert same_weights(tmp_path / str(limit), tmp_path / "whole")


def test_an_evaluation_tells_what_was_expected_at_every_discount(whole):
    """Of the last one, which the last checkpoint is as it was at: by its own values at the same starts."""
    told_last = [line for line in told(whole) if line["event"] == "Evaluation"][-1]
    agent = load_checkpoint(whole / "last.safetensors").agent
    starts = [10**12 + TINY.seed * 100_000 + i for i in range(TINY.evaluate_episodes)]
    first = np.array([vector.make("CartPole-v1").reset(seed=start)[0] for start in starts])
    values, actions = agent.action_values(first), agent.greedy(first)
    wanted = [values[i, :, action] for i, action in enumerate(actions)]
    np.testing.assert_allclose(told_last["values"], np.mean(wanted, axis=0), rtol=1e-5)
    lengths = evaluate(agent, "CartPole-v1", episodes=TINY.evaluate_episodes, seed=TINY.seed, first_seed=10**12).lengths
    wanted = [(1 - agent.gammas**length) / (1 - agent.gammas) for length in lengths]  # reward 1 a step
    np.testing.assert_allclose(told_last["discounted"], np.mean(wanted, axis=0), rtol=1e-9)
    wanted = np.std(wanted, axis=0, ddof=1) / np.sqrt(len(wanted))
    np.testing.assert_allclose(told_last["discounted_errors"], wanted, rtol=1e-6, atol=1e-12)


def test_progress_and_process_are_noted_while_a_run_is_trained(tmp_path):
    events = train(TINY, tmp_path / "run")
    next(events)
    assert Process.of(os.getpid()).same(read_process(tmp_path / "run"))
    events.close()
    assert read_process(tmp_path / "run") is None
