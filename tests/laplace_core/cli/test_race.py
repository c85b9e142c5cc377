"""The verb race, as somebody at a terminal uses it."""

from __future__ import annotations

import json

import pytest

from laplace_core.acting.race import Entrant, race, races
from laplace_core.agents import LaplaceSettings
from laplace_core.cli import main
from laplace_core.training.checkpoint import load_checkpoint, new_agent, save_checkpoint
from tests.support.hostile import assert_refused


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Checkpoints of two agents of CartPole and of one of a world."""
    folder = tmp_path_factory.mktemp("agents")
    for name, environment, seed in (("a", "CartPole-v1", 0), ("b", "CartPole-v1", 1), ("c", "two_branch", 0)):
        settings = LaplaceSettings(environment=environment, hidden=8, features=4, theta_max=12.0, seed=seed)
        save_checkpoint(folder / f"{name}.safetensors", new_agent(settings), 0, None)
    return {name: str(folder / f"{name}.safetensors") for name in "abc"}


def printed(capsys, *words: str) -> str:
    assert main(["race", *words]) == 0
    return capsys.readouterr().out


def test_many_races_are_the_library_s(files, capsys):
    found = json.loads(printed(capsys, files["a"], "--horizon", "20", "--seeds", "4", "--json"))
    agent = load_checkpoint(files["a"]).agent
    wanted = races("CartPole-v1", Entrant(agent), Entrant(agent, "fading"), 20, count=4)
    assert found["returns"]["right"] == wanted.right.tolist()
    assert found["difference"] == wanted.summary()["difference"]
    assert (found["rule"], found["against"]) == ("fading", "greedy")


def test_one_race_step_by_step_between_two_agents(files, capsys):
    words = [files["a"], "--against-agent", files["b"], "--horizon", "20", "--start", "5", "--rule", "greedy"]
    found = json.loads(printed(capsys, *words, "--json"))
    left, right = (load_checkpoint(files[name]).agent for name in "ba")
    wanted = race("CartPole-v1", Entrant(left), Entrant(right), 5, horizon=20)
    assert found["left_actions"] == wanted.left.actions.tolist()
    assert found["right_rewards"] == wanted.right.rewards.tolist()
    assert "start 5" in printed(capsys, *words)


def test_an_interval_that_covers_nothing_is_said(files, capsys):
    told = printed(capsys, files["c"], "--horizon", "3", "--rule", "greedy", "--seeds", "5")
    assert "equal 100%" in told
    assert "the interval covers 0" in told


def test_bad_words_are_refused_in_one_line(subtests, files, capsys):
    for words in [
        ["a"], ["a", "--horizon", "0"], ["a", "--horizon", "5", "--seeds", "1"],
        ["a", "--horizon", "5", "--seeds", "999"], ["a", "--horizon", "5", "--start", "-1"],
        ["a", "--horizon", "5", "--rule", "best"], ["a", "--horizon", "5", "--gamma", "2"],
        ["a", "--horizon", "5", "--against", "matched", "--gamma", ".5"],
        ["a", "--horizon", "5", "--against-agent", "c"], ["a", "--horizon", "5", "--against", "own"],
        ["nothing.safetensors", "--horizon", "5"], ["a", "--horizon", "9999", "--start", "0"],
    ]:  # fmt: skip
        with subtests.test(" ".join(words)):
            assert_refused(capsys, ["race", *(files.get(word, word) for word in words)])
