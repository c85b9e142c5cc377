"""The verbs train and evaluate, as somebody at a terminal uses them."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

from laplace_core.acting.evaluation import evaluate
from laplace_core.agents.settings import ENVIRONMENTS, SETTINGS
from laplace_core.cli import main
from laplace_core.supervise import read_process
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.training.defaults import command_of, settings_of
from laplace_core.training.progress import read_progress
from laplace_core.training.run_folder import new_run, read_config
from tests.support.hostile import assert_refused

SMALL = ["--steps", "600", "--learning-starts", "100", "--evaluate-every", "300", "--checkpoint-every", "300",
         "--hidden", "16", "--batch", "16", "--evaluate-episodes", "3"]  # fmt: skip


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """A short run on the paper's toy world."""
    folder = tmp_path_factory.mktemp("runs") / "short"
    assert main(["train", "laplace", "two_branch", *SMALL, "--run", str(folder)]) == 0
    return folder


def test_a_run_says_what_it_reached_and_leaves_a_checkpoint(run, capsys):
    folder = run.parent / "told"
    assert main(["train", "laplace", "two_branch", *SMALL, "--run", str(folder)]) == 0
    told = capsys.readouterr().out
    assert "in evaluation, the best so far" in told
    assert str(folder) in told
    loaded = load_checkpoint(folder / "best.safetensors")
    assert loaded.environment == "two_branch"
    assert loaded.settings.hidden == 16
    assert f"{loaded.score:.1f}" in told


def test_events_come_as_json_lines(tmp_path, capsys):
    assert main(["train", "laplace", "two_branch", *SMALL, "--run", str(tmp_path / "run"), "--json"]) == 0
    events = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert {event["event"] for event in events} == {"episode", "evaluation", "checkpoint"}
    assert [event["step"] for event in events] == sorted(event["step"] for event in events)


def test_the_file_of_the_environment_is_used_and_what_is_given_comes_first():
    tuned = settings_of("laplace", "CartPole-v1", {})
    assert tuned != SETTINGS["laplace"](environment="CartPole-v1")
    assert settings_of("laplace", "CartPole-v1", {"steps": "77"}).steps == 77
    assert settings_of("laplace", "CartPole-v1", {"steps": "77"}).hidden == tuned.hidden


def test_every_environment_has_valid_settings(subtests):
    for environment in ENVIRONMENTS:
        for algorithm in SETTINGS:
            with subtests.test(environment=environment, algorithm=algorithm):
                found = settings_of(algorithm, environment, {})
                assert found.environment == environment
                assert algorithm == found.ALGORITHM


def test_the_support_of_c51_holds_the_returns_of_a_world():
    """two_branch pays 5 at once or 10 at the third step: 9.801 from the start, and 10 one step before it is paid."""
    found = settings_of("c51", "two_branch", {})
    assert found.v_min <= 5.0
    assert found.v_max >= 10.0


@pytest.mark.parametrize("environment", ["MountainCar-v0", "gym:Taxi-v4", "gym:FrozenLake-v1", "double_chain"])
def test_other_environments_train_and_resume_as_well(environment, tmp_path, capsys):
    folder = tmp_path / "run"
    assert main(["train", "laplace", environment, *SMALL, "--run", str(folder)]) == 0
    first = (folder / "metrics.jsonl").read_text().splitlines()
    capsys.readouterr()
    assert main(["train", "--resume", str(folder)]) == 0  # finished already: nothing is added
    assert (folder / "metrics.jsonl").read_text().splitlines() == first
    assert load_checkpoint(folder / "last.safetensors").environment == environment


def test_every_setting_has_a_sentence_in_the_help():
    done = subprocess.run([sys.executable, "-m", "laplace_core", "train", "--help"], capture_output=True, text=True)
    text = " ".join(done.stdout.split())
    for parameter in {parameter for kind in SETTINGS.values() for parameter in kind.SCHEMA}:
        if parameter.name != "environment":
            assert f"--{parameter.name.replace('_', '-')}" in text
            assert parameter.help.split("%")[0].split(";")[0] in text


def test_evaluate_prints_what_the_library_finds(run, capsys):
    checkpoint = str(run / "best.safetensors")
    assert main(["evaluate", checkpoint, "--episodes", "7", "--seed", "3", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    found = evaluate(load_checkpoint(checkpoint).agent, "two_branch", episodes=7, seed=3)
    np.testing.assert_array_equal(told["returns"], found.returns)
    assert told["mean"] == found.mean
    assert main(["evaluate", checkpoint, "--episodes", "5", "--horizon", "2"]) == 0
    assert "fading, T = 2" in capsys.readouterr().out


def test_bad_words_are_one_sentence(subtests, capsys, tmp_path, monkeypatch):
    for words, named in [
        (["train"], "algorithm"),
        (["train", "dreamer", "CartPole-v1"], "dreamer"),
        (["train", "laplace"], "environment"),
        (["train", "laplace", "Pong-v5"], "Pong-v5"),
        (["train", "laplace", "CartPole-v1", "--steps", "0"], "steps"),
        (["train", "laplace", "CartPole-v1", "--steps", "many"], "steps"),
        (["train", "laplace", "CartPole-v1", "--theta-min", "1"], "theta_min"),
        (["train", "laplace", "CartPole-v1", "--network", "transformer"], "network"),
        (["train", "laplace", "CartPole-v1", "--speed", "9"], "--speed"),
        (["train", "--resume", "nowhere"], "nowhere"),
        (["train", "laplace", "CartPole-v1", "--resume", "nowhere"], "resume"),
        (["evaluate", "nothing.safetensors"], "nothing.safetensors"),
        (["evaluate", "nothing.safetensors", "--episodes", "0"], "episodes"),
        (["evaluate", "nothing.safetensors", "--horizon", "-1"], "horizon"),
        (["evaluate", "nothing.safetensors", "--softness", "x"], "softness"),
    ]:
        with subtests.test(" ".join(words)):
            monkeypatch.chdir(tmp_path)
            assert_refused(capsys, words, named)
            assert not list(tmp_path.iterdir())


def test_a_run_is_not_written_over(run, capsys):
    assert_refused(capsys, ["train", "laplace", "two_branch", *SMALL, "--run", str(run)], "short")


def test_an_unknown_rule_is_refused(run, capsys):
    assert_refused(capsys, ["evaluate", str(run / "best.safetensors"), "--rule", "lucky"], "lucky")


@pytest.mark.parametrize("number", [signal.SIGTERM, pytest.param(signal.SIGINT, marks=pytest.mark.long)])
def test_a_signal_ends_a_run_with_a_resume_point_and_says_how_to_go_on(number, tmp_path):
    folder = tmp_path / "run"
    words = ["train", "laplace", "two_branch", *SMALL, "--steps", "100000", "--evaluate-every", "100000"]
    command = [sys.executable, "-m", "laplace_core", *words, "--checkpoint-every", "100000", "--run", str(folder)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while read_progress(folder) is None:
        assert process.poll() is None
        time.sleep(0.05)
    process.send_signal(number)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 128 + number
    assert f"laplace train --resume {folder}" in err.splitlines()[-1]
    assert (folder / "resume.safetensors").exists()
    assert read_process(folder) is None


def test_the_command_of_settings_makes_those_settings(tmp_path, monkeypatch):
    settings = settings_of(
        "laplace", "CartPole-v1", {"seed": 5, "dueling": True, "gamma_min": 0.123456789, "steps": 77}
    )
    words = command_of(settings, str(tmp_path / "run"))
    assert words[:3] == ["train", "laplace", "CartPole-v1"]
    assert "--hidden" not in words  # the settings file says it
    monkeypatch.setattr("laplace_core.training.loop.train", lambda settings, path, **_: new_run(path, settings) or ())
    assert main(words) == 0
    assert read_config(tmp_path / "run" / "config.json") == settings
