"""The peers trained: what they learn of small worlds against the exact values, and their runs and checkpoints."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch

from laplace_core import load_world
from laplace_core.acting.evaluation import evaluate
from laplace_core.agents import SETTINGS
from laplace_core.agents.agent import Agent
from laplace_core.errors import InputError
from laplace_core.planning import finite_horizon_optimum, greedy_policy
from laplace_core.tabular.peers import return_distribution
from laplace_core.tabular.returns import wasserstein
from laplace_core.training.checkpoint import load_checkpoint, new_agent, save_checkpoint
from laplace_core.training.defaults import settings_of
from laplace_core.training.loop import train
from tests.laplace_core.agents.test_peers import FEW, OTHERS, PEERS
from tests.laplace_core.training.test_loop import TINY as LAPLACE
from tests.laplace_core.training.test_loop import same_weights, stop_at, told

torch.set_num_threads(1)
LOOP = {name: getattr(LAPLACE, name) for name in ("batch", "steps", "envs", "buffer", "learning_starts", "hidden",
        "update_every", "updates", "evaluate_every", "evaluate_episodes", "checkpoint_every", "n_step")}  # fmt: skip
LEARNING = {
    "steps": 3_000, "envs": 8, "hidden": 32, "batch": 64, "learning_starts": 500, "update_every": 8, "updates": 4,
    "learning_rate": 3e-3, "learning_rate_final": 0.01, "averaging": 0.03, "evaluate_every": 3_000,
}  # fmt: skip


def trained(algorithm: str, world: str, folder: Path, **changes) -> Agent:
    for _ in train(settings_of(algorithm, world, LEARNING | changes), folder):
        pass
    return load_checkpoint(folder / "last.safetensors").agent


@pytest.mark.parametrize(
    "algorithm", [pytest.param(name, marks=() if name in ("c51", "dqn") else pytest.mark.long) for name in PEERS]
)
def test_a_peer_learns_the_values_and_the_return_of_its_world(algorithm, tmp_path):
    """double_chain: at the start chance decides between .6 at step 2 and 1 at step 6, so that the return has two atoms.

    All its mass at the mean, which is what DQN has, is .177 away; the codes of the return are nearer.
    """
    agent, world = trained(algorithm, "double_chain", tmp_path / "run", epsilon_final=1.0), load_world("double_chain")
    policy = greedy_policy(world, 0.99)
    for state, observation in enumerate(np.eye(world.n_states)):
        law = return_distribution(world, state, 0, policy, gamma=0.99)
        value = agent.action_values(observation[None], agent.acting_head)[0, 0]
        assert value == pytest.approx(law.locations @ law.masses, abs=0.03)
        locations, masses = agent.return_distribution(observation)
        away = wasserstein((locations[0], masses[0]), (law.locations, law.masses))
        near = {"c51": 0.05, "qrdqn": 0.13, "expectile": 0.1, "dqn": 0.2}[algorithm]
        assert away < (near if world.states[state] == "start" else 0.03)


def test_a_fixed_horizon_agent_learns_every_horizon(tmp_path):
    """two_branch: 5 at once, or 10 at the third step, which is worth nothing to whom fewer steps are left."""
    agent = trained("fixed_horizon", "two_branch", tmp_path / "run", horizon=4, epsilon_final=0.5)
    world = load_world("two_branch")
    exact = finite_horizon_optimum(world, 4, 0.99, 0)  # (T, A)
    np.testing.assert_allclose(agent.action_values(np.eye(world.n_states)[:1])[0], exact, atol=0.25)
    for horizon, paid in ((1, 5.0), (2, 5.0), (3, 10.0), (4, 10.0), (50, 10.0)):
        assert evaluate(agent, "two_branch", episodes=1, horizon=horizon, rule="own").returns.tolist() == [paid]
    assert evaluate(agent, "two_branch", episodes=1, horizon=2, rule="greedy").returns.tolist() == [0.0]


@pytest.mark.parametrize(
    ("algorithm", "changes"),
    [
        ("fixed_horizon", {"environment": "two_branch", "head_exploration": 0.5}),
        ("c51", {"prioritised": True, "dueling": True, "n_step": 1}),
    ],
)
def test_the_same_settings_give_the_same_metrics_also_across_a_stop(algorithm, changes, tmp_path):
    """Fixed-horizon DQN draws times to go in its loss: those, too, must go on where they were."""
    settings = SETTINGS[algorithm](**(LOOP | FEW[algorithm] | changes))
    for name in ("one", "other"):
        list(train(settings, tmp_path / name))
    assert told(tmp_path / "one") == told(tmp_path / "other")
    evaluations = [line for line in told(tmp_path / "one") if line["event"] == "Evaluation"]
    assert {len(line["values"] or ()) for line in evaluations} == {0 if algorithm == "fixed_horizon" else 1}
    stop_at(settings, tmp_path / "stopped", settings.steps - 80)
    list(train(None, tmp_path / "stopped", resume=True))
    assert told(tmp_path / "stopped") == told(tmp_path / "one")
    assert same_weights(tmp_path / "stopped", tmp_path / "one")


@pytest.mark.parametrize("algorithm", OTHERS)
def test_a_checkpoint_comes_back_as_it_was(algorithm, tmp_path):
    agent = new_agent(SETTINGS[algorithm](hidden=4, dueling=True, seed=7, **FEW[algorithm]))
    with torch.no_grad():
        for parameter in agent.target.parameters():
            parameter += 0.1 * torch.randn(parameter.shape, generator=torch.Generator().manual_seed(0))
    save_checkpoint(tmp_path / "agent.safetensors", agent, 123, 45.5, episodes=20)
    loaded = load_checkpoint(tmp_path / "agent.safetensors")
    assert (loaded.algorithm, loaded.seed, loaded.settings) == (algorithm, 7, agent.settings)
    observations = np.random.default_rng(0).normal(size=(5, 4))
    np.testing.assert_array_equal(agent.action_values(observations), loaded.agent.action_values(observations))


@pytest.mark.parametrize("algorithm", OTHERS)
def test_a_checkpoint_with_other_settings_is_refused(algorithm, tmp_path):
    """The weights that are there are counted against those that the settings ask for."""
    agent = new_agent(SETTINGS[algorithm](hidden=4, **FEW[algorithm]))
    agent.settings = replace(agent.settings, hidden=5)
    save_checkpoint(tmp_path / "agent.safetensors", agent, 1, None)
    with pytest.raises(InputError, match="weights"):
        load_checkpoint(tmp_path / "agent.safetensors")
