"""The verb race, as somebody at a terminal uses it."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from laplace_core.acting.evaluation import evaluate
from laplace_core.acting.race import Entrant, race, races
from laplace_core.acting.rules import RULES, Options
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


# --- options of the rules, which evaluate takes as well ---

CHOSEN = ["--rule", "decoded", "--solver", "nonnegative", "--alpha", "auto"]


def test_a_rule_has_its_options_in_a_race(files, capsys):
    """A side whose rule takes no option is as it was."""
    words = [files["c"], "--horizon", "4", "--seeds", "2", "--json"]
    found = json.loads(printed(capsys, *words, *CHOSEN))
    agent = load_checkpoint(files["c"]).agent
    options = Options(solver="nonnegative", selector="auto")
    wanted = races("two_branch", Entrant(agent), Entrant(agent, "decoded", options=options), 4, count=2)
    assert found["returns"]["right"] == wanted.right.tolist()
    assert found["returns"]["left"] == races("two_branch", Entrant(agent), Entrant(agent), 4, count=2).left.tolist()
    assert found["options"] == {"solver": "nonnegative", "selector": "auto"}


def test_one_race_and_many_act_by_the_same_options(files, capsys):
    """Readout with a regularisation so strong that it weighs nothing differs from its usual self."""
    words = [files["c"], "--horizon", "4", "--rule", "readout", "--alpha", "1e6", "--softness", "0", "--json"]
    many = json.loads(printed(capsys, *words, "--seeds", "2"))
    one = json.loads(printed(capsys, *words, "--start", "0"))
    assert sum(one["right_rewards"]) == many["returns"]["right"][0]


@pytest.mark.parametrize("options", [Options(solver="tsvd", alpha=0.3), Options(noise_level=0.02, head=1)])
def test_no_option_is_lost_on_the_way_to_a_rule(files, monkeypatch, options):
    seen = []
    greedy = RULES["greedy"]

    def noted(agent, length, given):
        seen.append(given)
        return greedy.values(agent, length, given)

    monkeypatch.setitem(RULES, "greedy", replace(greedy, values=noted))
    agent = load_checkpoint(files["c"]).agent
    entrant = Entrant(agent, "greedy", options=options)
    race("two_branch", entrant, entrant, 0, horizon=3)
    races("two_branch", entrant, entrant, 3, count=2)
    assert seen == [replace(options, head=None)] * 4  # the head is that of the discount asked for


def test_evaluate_takes_a_solver_and_an_alpha_by_name(files, capsys):
    assert main(["evaluate", files["c"], "--horizon", "4", "--episodes", "2", "--json", *CHOSEN]) == 0
    found = json.loads(capsys.readouterr().out)
    agent = load_checkpoint(files["c"]).agent
    wanted = evaluate(agent, "two_branch", episodes=2, horizon=4, rule="decoded", solver="nonnegative", selector="auto")
    assert found["returns"] == wanted.returns.tolist()


@pytest.mark.parametrize("verb", ["evaluate", "race"])
def test_certified_needs_a_noise_level(files, capsys, verb):
    words = [verb, files["c"], "--horizon", "3", "--episodes" if verb == "evaluate" else "--seeds", "2"]
    assert_refused(capsys, [*words, "--rule", "certified"], "'certified'", "--noise-level")
    assert main([*words, "--rule", "certified", "--noise-level", "0.01"]) == 0
    assert "certified" in capsys.readouterr().out


def test_an_option_that_neither_side_takes_is_refused(files, capsys):
    words = ["race", files["c"], "--horizon", "3", "--rule", "fading"]
    assert_refused(capsys, [*words, "--solver", "tsvd"], "--solver", "'fading'", "decoded")
    assert_refused(capsys, [*words, "--alpha", "auto"], "--alpha by name", "'fading'")
    assert main([*words, "--against", "readout", "--alpha", "2", "--seeds", "2"]) == 0
    capsys.readouterr()
