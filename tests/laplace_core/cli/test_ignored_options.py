"""Options that would change nothing are refused in one sentence, and those that were refused do change something."""

from __future__ import annotations

import json

import numpy as np
import pytest

from laplace_core.acting.rules import RULES, Options
from laplace_core.agents.settings import C51Settings, LaplaceSettings
from laplace_core.cli import main
from laplace_core.errors import InputError
from laplace_core.training.checkpoint import new_agent, save_checkpoint
from laplace_core.training.defaults import command_of, settings_of
from tests.support.hostile import assert_refused


@pytest.fixture(scope="module")
def agents(tmp_path_factory):
    folder = tmp_path_factory.mktemp("agents")
    kinds = {"laplace": LaplaceSettings(environment="two_branch", hidden=8, features=4, theta_max=12.0),
             "c51": C51Settings(environment="two_branch", hidden=8)}  # fmt: skip
    for name, settings in kinds.items():
        save_checkpoint(folder / f"{name}.safetensors", new_agent(settings), 0, None)
    return {name: str(folder / f"{name}.safetensors") for name in kinds}


@pytest.mark.parametrize("rule", [name for name in RULES if name != "own"])
def test_the_options_of_a_rule_are_those_that_move_its_values(rule):
    settings = LaplaceSettings(environment="two_branch", hidden=8, features=4, theta_max=12.0, seed=3)
    agent, observations = new_agent(settings), np.eye(3, dtype=np.float32)
    needed = dict.fromkeys(RULES[rule].needs, 0.1)
    usual = RULES[rule].values(agent, 20, Options(**needed))(observations, 5)
    for name, other in (("alpha", 3.0), ("softness", 0.9), ("stretch", 4.0)):
        moved = RULES[rule].values(agent, 20, Options(**needed, **{name: other}))(observations, 5)
        assert (not np.allclose(moved, usual, rtol=1e-6)) == (name in RULES[rule].options)


RULED = [
    *((rule, name) for rule in ("greedy", "matched") for name in ("alpha", "softness", "stretch")),
    *(("fading", name) for name in ("alpha", "softness")),
    *((rule, "stretch") for rule in ("readout", "decoded")),
]


GIVEN = {
    "alpha": ["--alpha", "2"], "softness": ["--softness", "2"], "stretch": ["--stretch", "2"],
    "solver": ["--solver", "tsvd"], "selector": ["--alpha", "gcv"], "noise_level": ["--noise-level", "0.01"],
}  # fmt: skip
"""A word of the command line for each option of a rule."""


def test_an_option_of_another_rule_is_refused(subtests, agents, capsys):
    for rule, name in RULED:
        with subtests.test(rule=rule, name=name):
            words = ["--rule", rule, f"--{name}", "2"]
            assert_refused(capsys, ["evaluate", agents["laplace"], "--horizon", "3", *words], f"--{name}", f"{rule!r}")
            assert_refused(capsys, ["report", "horizon", agents["laplace"], *words], f"--{name}", f"{rule!r}")


def test_an_alpha_by_name_is_refused_by_its_own_words(agents, capsys):
    for rule in ("readout", "fading"):
        words = ["evaluate", agents["laplace"], "--horizon", "3", "--rule", rule, "--alpha", "auto"]
        assert_refused(capsys, words, "--alpha by name", f"{rule!r}", "for decoded")


def test_an_option_of_the_rule_is_heard(agents, capsys):
    for rule, found in RULES.items():
        for name in found.options:
            words = ["evaluate", agents["laplace"], "--horizon", "3", "--episodes", "2", "--rule", rule]
            assert main([*words, *GIVEN[name]]) == 0
    capsys.readouterr()


def test_an_option_of_a_rule_that_nobody_named_is_refused(agents, capsys):
    assert_refused(capsys, ["evaluate", agents["c51"], "--alpha", "1"], "--alpha", "'greedy'")
    assert_refused(capsys, ["evaluate", agents["laplace"], "--horizon", "3", "--softness", ".2"], "'fading'")


def test_one_race_has_no_count_of_starts(agents, capsys):
    for more in (["--seeds", "5"], ["--first", "2"]):
        assert_refused(capsys, ["race", agents["laplace"], "--horizon", "3", "--start", "4", *more], more[0], "--start")


@pytest.mark.parametrize("verb", ["decode", "learn"])
@pytest.mark.parametrize("words", [["--gammas", "14"], ["--gamma-min", ".02"], ["--gamma-max", ".999"]])
def test_a_grid_of_ones_own_beside_the_papers_is_refused(capsys, verb, words):
    assert_refused(capsys, [verb, "two_branch", "--spacing", "paper", *words], words[0], "--spacing paper", "15")


def test_the_papers_own_grid_beside_its_name_is_no_conflict(capsys, tmp_path):
    # Every command that is printed names the whole grid.
    out = tmp_path / "first.npz"
    assert main(["decode", "two_branch", "--spacing", "paper", "--out", str(out)]) == 0
    with np.load(out) as file:
        command = json.loads(str(file["settings"]))["command"]
    assert all(word in command for word in ("--spacing paper", "--gammas 15", "--gamma-min 0.01", "--gamma-max 0.99"))
    assert main(command.split()[3:]) == 0
    capsys.readouterr()


def test_what_belongs_to_something_that_is_not_there_is_refused(capsys):
    assert_refused(capsys, ["decode", "two_branch", "--noise-seed", "3"], "--noise-seed", "--noise")
    for words in (["--atoms", "11"], ["--peer-gamma", ".9"], ["--quantile-half", "9"]):
        assert_refused(capsys, ["learn", "two_branch", *words], words[0], "--peers")


TRAINED = [
    ("dqn", {"priority_exponent": 0.5}, "prioritised"),
    ("c51", {"priority_correction": 0.5, "prioritised": False}, "prioritised"),
    ("dqn", {"exploration": 0.1, "epsilon_first": 0.1, "epsilon_final": 0.1}, "epsilon"),
    ("laplace", {"consistency": 0, "consistency_exponent": 0.5}, "consistency"),
    ("laplace", {"experience": "per_discount", "envs": 2, "prioritised": False}, "experience"),
    ("laplace", {"spacing": "paper", "gammas": 13}, "paper"),
    ("laplace", {"spacing": "paper", "gamma_min": 0.2}, "paper"),
    ("laplace", {"gammas": 1, "spacing": "linear"}, "gamma_max"),
    ("laplace", {"gammas": 1, "gamma_min": 0.2}, "gamma_max"),
    ("laplace", {"gammas": 1, "acting_gamma": 0.2}, "gamma_max"),
]


def test_a_setting_of_training_that_changes_nothing_is_refused(subtests, capsys, tmp_path):
    for algorithm, given, named in TRAINED:
        with subtests.test(algorithm=algorithm, given=given, named=named):
            words = [
                word for name, value in given.items() for word in (f"--{name.replace('_', '-')}", str(value).lower())
            ]
            command = ["train", algorithm, "two_branch", *words, "--run", str(tmp_path / "run")]
            assert_refused(capsys, command, "changes nothing", named)
            assert not list(tmp_path.iterdir())
            with pytest.raises(InputError, match="changes nothing"):
                settings_of(algorithm, "two_branch", given)


def test_the_command_of_a_run_never_holds_a_setting_that_changes_nothing():
    usual = settings_of("laplace", "two_branch", {})
    settings = usual.parse(usual.as_dict() | {"spacing": "paper", "gammas": 9, "priority_exponent": 0.1, "steps": 99})
    assert {"gammas", "priority_exponent"} < set(settings.ignored())
    words = command_of(settings, "run")
    assert "--steps" in words
    assert "--gammas" not in words
    assert "--priority-exponent" not in words


def test_a_run_that_goes_on_stays_in_its_folder(capsys):
    assert_refused(capsys, ["train", "--resume", "a", "--run", "b"], "--resume")


SEARCHED = [
    (["--vary", "environment=fig6_chain,cliff_grid"], "environment"),
    (["--set", "environment=fig6_chain"], "environment"),
    (["--vary", "algorithm=dqn,c51"], "algorithm"),
    (["--set", "algorithm=c51"], "algorithm"),
    (["--vary", "seed=1,2"], "--seeds"),
    (["--set", "seed=1"], "--seeds"),
    (["--vary", "learning_rate=1e-3,.001"], "twice"),
    (["--vary", "learning_rate=1e-3", "--set", "learning_rate=1e-4"], "learning_rate"),
    (["--vary", "priority_exponent=.4,.6"], "prioritised"),
    (["--vary", "learning_rate"], "--vary"),
    (["--set", "steps"], "--set"),
]


def test_a_search_over_what_is_no_setting_is_refused(subtests, capsys, tmp_path):
    for words, named in SEARCHED:
        with subtests.test(words=words, named=named):
            assert_refused(capsys, ["search", "dqn", "two_branch", *words, "--runs", str(tmp_path / "runs")], named)
            assert not list(tmp_path.iterdir())


def test_a_deadline_without_a_world_is_refused(tmp_path, capsys):
    path = str(tmp_path / "own.npz")
    assert main(["decode", "two_branch", "--out", path]) == 0
    capsys.readouterr()
    assert_refused(capsys, ["decode", path, "--deadline", "constant"], "--deadline", "world")


@pytest.mark.parametrize("horizon", [".5", "2.6", "0"])
def test_a_horizon_between_two_steps_is_refused(capsys, horizon):
    assert_refused(capsys, ["decode", "two_branch", "--horizon", horizon], "horizon must be a")
