"""The report that judges a rule: its table is made of evaluations, agent by agent, and references stand beside it."""

from __future__ import annotations

import json

import numpy as np
import pytest
import torch

from laplace_core.acting.evaluation import evaluate
from laplace_core.cli import main
from laplace_core.training.checkpoint import load_checkpoint, new_agent, save_checkpoint
from laplace_core.training.defaults import settings_of


@pytest.fixture(scope="module")
def agents(tmp_path_factory):
    """Two Laplace agents and a fixed-horizon one, their weights at random; and one of another environment."""
    folder, made = tmp_path_factory.mktemp("agents"), {}
    for name, algorithm, environment, seed in (
        ("a", "laplace", "CartPole-v1", 0), ("b", "laplace", "CartPole-v1", 1),
        ("fixed", "fixed_horizon", "CartPole-v1", 0), ("other", "laplace", "two_branch", 0),
    ):  # fmt: skip
        agent = new_agent(settings_of(algorithm, environment, {"seed": seed, "hidden": 8}))
        random = torch.Generator().manual_seed(seed)
        for parameter in agent.target.parameters():
            parameter.data += 0.3 * torch.randn(parameter.shape, generator=random)
        save_checkpoint(folder / f"{name}.safetensors", agent, 1, None)
        made[name] = str(folder / f"{name}.safetensors")
    return made


def test_means_and_differences_are_those_of_the_evaluations(agents, capsys):
    words = ["report", "horizon", agents["a"], agents["b"], "--horizons", "30,full", "--episodes", "6", "--seed", "3"]
    assert main([*words, "--reference", agents["fixed"], "--stretch", "2", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert [row["horizon"] for row in rows] == [30, None]

    def scores(name, horizon, rule, **options):
        agent = load_checkpoint(agents[name]).agent
        return evaluate(agent, "CartPole-v1", episodes=6, seed=3, horizon=horizon, rule=rule, **options).returns

    for row in rows:
        horizon = row["horizon"]
        by = {rule: [scores(name, horizon, rule) for name in "ab"] for rule in ("greedy", "matched")}
        by["fading"] = [scores(name, horizon, "fading", stretch=2.0) for name in "ab"]
        for rule, returns in by.items():
            np.testing.assert_allclose(row["means"][rule], np.mean(returns, axis=1))
        for rule in ("greedy", "matched"):
            found = row[f"against {rule}"]
            assert found["mean"] == pytest.approx(np.mean(np.array(by["fading"]) - by[rule]))
            assert found["interval"][0] <= found["mean"] <= found["interval"][1]
        own = "own" if horizon else "greedy"
        np.testing.assert_allclose(row["references"], [scores("fixed", horizon, own).mean()])


def test_the_table_names_the_reference_and_every_agent(agents, capsys):
    words = ["report", "horizon", agents["a"], agents["b"], "--horizons", "20", "--episodes", "2"]
    assert main([*words, "--reference", agents["fixed"]]) == 0
    told = capsys.readouterr().out
    assert "beside them fixed: T = 20: " in told
    assert told.count(" -> ") == 3  # the rule's name, and one for each agent
    assert main(words) == 0
    assert "beside them" not in capsys.readouterr().out


@pytest.mark.parametrize("more", [("{other}",), ("--reference", "{other}"), ("--horizons", "0"), ("--rule", "best")])
def test_what_does_not_fit_is_one_sentence(more, agents, capsys):
    assert main(["report", "horizon", agents["a"], "--episodes", "2", *(word.format(**agents) for word in more)]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 1
