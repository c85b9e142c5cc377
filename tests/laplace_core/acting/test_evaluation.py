"""Acting by what was learned, and what was learned against the exact gamma-space of two worlds."""

from __future__ import annotations

import json
from dataclasses import replace

import gymnasium
import numpy as np
import pytest
import torch

from laplace_core import Settings, load_world, study
from laplace_core.acting.evaluation import evaluate
from laplace_core.agents import LaplaceSettings
from laplace_core.agents.laplace import LaplaceAgent
from laplace_core.agents.settings import ENVIRONMENTS, C51Settings
from laplace_core.cli import main
from laplace_core.code.encoding import discount_grid
from laplace_core.environments import WORLD_TIME_LIMIT, vector
from laplace_core.errors import InputError
from laplace_core.inverse import decode
from laplace_core.planning import proxy_gamma_space, target_policies
from laplace_core.training.checkpoint import load_checkpoint, new_agent, save_checkpoint
from laplace_core.training.defaults import settings_of
from laplace_core.training.loop import train

torch.set_num_threads(1)
TINY = LaplaceSettings(environment="two_branch", hidden=8, features=4, gammas=6, thetas=9, theta_min=-3, theta_max=13)


class Knowing:
    """The exact values of a world in the place of an agent's, at discounts dense enough for short horizons."""

    acting_head = 39

    def __init__(self, world):
        self.n_observations, self.n_actions = world.n_states, world.n_actions
        self.gammas = discount_grid(40, "linear", 0.02, 0.99)
        policies = target_policies(world, self.gammas, "shared", 0.99)
        self._values = proxy_gamma_space(world, world.reward_values, self.gammas, policies)  # (S, A, G)

    def action_values(self, observations, head=None):
        values = np.moveaxis(self._values[observations.argmax(axis=1)], 1, 2)
        return values if head is None else values[:, head]

    def greedy(self, observations):
        return self.action_values(observations, self.acting_head).argmax(axis=1)


class Optimal:
    """Acts by the best values that there are at a discount near 1."""

    acting_head = 0

    def __init__(self, world):
        self.n_observations, self.n_actions = world.n_states, world.n_actions
        self._values = proxy_gamma_space(world, world.reward_values, np.array([0.9999]),
                                         target_policies(world, np.array([0.9999]), "shared", 0.9999))  # fmt: skip

    def action_values(self, observations, head=None):
        return self._values[observations.argmax(axis=1), :, 0]


def test_frozen_lake_lasts_as_long_as_gymnasium_lets_it():
    """gymnasium stops it after 100 steps and calls the optimum .74 (its registry); without a limit it is .82."""
    scores = evaluate(Optimal(load_world("gym:FrozenLake-v1")), "gym:FrozenLake-v1", episodes=2000)
    assert scores.lengths.max() == 100
    assert scores.mean == pytest.approx(0.740, abs=4 * np.sqrt(0.74 * 0.26 / 2000))


@pytest.mark.parametrize("name", [name for name in ENVIRONMENTS if name.startswith("gym:")])
def test_gymnasiums_own_time_limits_hold(name):
    own = gymnasium.spec(name.removeprefix("gym:")).max_episode_steps
    assert vector.spec(name).time_limit == (own or WORLD_TIME_LIMIT)
    env = vector.make(name)
    env.reset(seed=0)
    env.unwrapped._state = 0
    # Up against the wall of the top left corner: never over, so that only the limit ends it (slipping may, sooner).
    for step in range(1, vector.spec(name).time_limit + 1):
        _, _, terminated, truncated, _ = env.step(1 if "Taxi" in name else 0 if "Cliff" in name else 3)
        if terminated:
            return
        assert truncated == (step == vector.spec(name).time_limit)
    assert truncated


def test_atoms_that_do_not_reach_the_returns_are_told(tmp_path, capsys):
    """two_branch pays 5 at once or 10 after two steps, .99^2 * 10 = 9.8 discounted: neither lies within -1 to 2."""
    told = {}
    for high in (2.0, 20.0):
        settings = C51Settings(environment="two_branch", hidden=8, v_min=-1.0, v_max=high)
        path = tmp_path / f"{high:g}.safetensors"
        save_checkpoint(path, new_agent(settings), 0, None)
        assert main(["evaluate", str(path), "--episodes", "7", "--json"]) == 0
        told[high] = json.loads(capsys.readouterr().out)["notes"]
    assert told[20.0] == []
    (note,) = told[2.0]
    assert note.startswith("7 of 7 discounted returns")
    assert "the atoms of this agent, -1 to 2" in note
    assert main(["evaluate", str(tmp_path / "2.safetensors"), "--episodes", "7"]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == note


def test_returns_are_sums_of_rewards_and_lengths_are_steps():
    """The knowing agent waits for the 10 at the third step of two_branch, unless it is stopped before."""
    agent = Knowing(load_world("two_branch"))
    scores = evaluate(agent, "two_branch", episodes=3)
    assert scores.returns.tolist() == [10.0] * 3
    assert scores.lengths.tolist() == [3] * 3
    assert not scores.running.any()
    assert (scores.mean, scores.standard_error) == (10.0, 0.0)
    stopped = evaluate(agent, "two_branch", episodes=2, horizon=2)
    assert stopped.returns.tolist() == [0.0] * 2
    assert stopped.running.all()


@pytest.mark.parametrize(("horizon", "paid"), [(1, 5.0), (2, 5.0), (3, 10.0), (20, 10.0)])
def test_the_readout_acts_for_the_time_to_go(horizon, paid):
    """r1 = 5 at once or r2 = 10 at the third step: what cannot be reached in time is not waited for."""
    agent = Knowing(load_world("two_branch"))
    scores = evaluate(
        agent, "two_branch", episodes=1, horizon=horizon, softness=0.0, rule="readout", alpha=1e-6, steps=30
    )
    assert scores.returns.tolist() == [paid]


@pytest.mark.parametrize("softness", [0.0, 0.3])
def test_reading_out_and_decoding_take_the_same_actions(softness):
    """Two ways to one linear form, in all states that random agents pass through.

    No mass lies beyond the thresholds: a decoded reward knows midpoints only, while the values of an agent count a
    reward beyond them as the nearest threshold.
    """
    for seed in range(3):
        agent = new_agent(replace(TINY, environment="cliff_grid", seed=seed))
        agent.target.head.weight.data *= 30.0
        agent.target.head.weight.data[..., [0, -2]] = 0.0  # the two outermost bins; the last atom is death
        agent.target.head.bias.data[..., [0, -2]] = -60.0
        rules = [
            evaluate(agent, "cliff_grid", episodes=4, horizon=12, softness=softness, rule=rule, alpha=0.3, steps=50)
            for rule in ("readout", "decoded")
        ]
        np.testing.assert_array_equal(rules[0].returns, rules[1].returns)
        np.testing.assert_array_equal(rules[0].lengths, rules[1].lengths)


def test_the_same_seed_evaluates_on_the_same_starts():
    agent = new_agent(LaplaceSettings(hidden=8, features=4))
    one, same, other = (evaluate(agent, "CartPole-v1", episodes=20, seed=seed).returns for seed in (3, 3, 4))
    np.testing.assert_array_equal(one, same)
    assert not np.array_equal(one, other)
    # More episodes begin with the same ones.
    np.testing.assert_array_equal(evaluate(agent, "CartPole-v1", episodes=120, seed=3).returns[:20], one)


def test_arguments_that_do_not_fit_are_refused(subtests):
    for changes, named in [
        ({"rule": "best"}, "rule"),
        ({"episodes": 0}, "episodes"),
        ({"horizon": 0}, "horizon"),
        ({"horizon": -3}, "horizon"),
        ({"seed": -1}, "seed"),
        ({"softness": -1.0, "rule": "readout"}, "softness"),
        ({"environment": "Acrobot-v1"}, "not trained for"),
        ({"environment": "Ant-v5"}, "Ant-v5"),
    ]:
        with subtests.test(changes=changes, named=named), pytest.raises(InputError, match=named):
            evaluate(new_agent(TINY), **({"environment": "two_branch", "episodes": 1} | changes))


def exact(agent: LaplaceAgent, name: str, state: str):
    """The exact gamma-space on the agent's own grids."""
    s = agent.settings
    settings = Settings(
        world=name, state=state, gammas=s.gammas, spacing=s.spacing, gamma_min=s.gamma_min, gamma_max=s.gamma_max,
        thetas=s.thetas, theta_min=s.theta_min, theta_max=s.theta_max, slope=agent.sensitivities.slope,
        policy="shared", acting_gamma=float(agent.gammas[-1]),
    )  # fmt: skip
    return study(load_world(name), settings).gamma_space


@pytest.mark.parametrize(
    ("name", "changes", "near"),
    [
        ("two_branch", {"steps": 7_000, "gammas": 8, "thetas": 17}, 0.03),  # half of what its settings file asks for
        pytest.param("two_branch", {}, 0.03, marks=pytest.mark.long),
        pytest.param("fig6_chain", {}, 0.03, marks=pytest.mark.long),
    ],
)
def test_a_trained_network_has_the_gamma_space_of_its_world(name, changes, near, tmp_path):
    """Within ``near`` of the range of the exact one, in every state; and its decode shows the same picture."""
    for _ in train(settings_of("laplace", name, changes), tmp_path / "run"):
        pass
    agent, world = load_checkpoint(tmp_path / "run" / "last.safetensors").agent, load_world(name)
    for index, state in enumerate(world.states):
        found, true = agent.gamma_space(np.eye(world.n_states)[index]), exact(agent, name, state)
        np.testing.assert_allclose(found.values, true.values, atol=near * np.ptp(true.values))
        np.testing.assert_allclose(found.constant, true.constant, atol=near * np.ptp(true.values))
        if index == 0:
            pictures = [decode(-np.diff(space.values, axis=-1), space.gammas, 4, 0.1) for space in (found, true)]
            np.testing.assert_allclose(*pictures, atol=0.08 * pictures[1].max())


def test_lunar_lander_says_what_it_needs_where_its_physics_is_missing(monkeypatch):
    import gymnasium

    def missing(*_, **__):
        raise gymnasium.error.DependencyNotInstalled("Box2D is not installed")

    monkeypatch.setattr(gymnasium, "make", missing)
    with pytest.raises(InputError, match="gymnasium"):
        vector.make("LunarLander-v3")


def test_discounted_returns_are_what_a_knowing_agent_expects():
    """The 10 comes at the third step of two_branch, tau = 2."""
    agent = Knowing(load_world("two_branch"))
    scores = evaluate(agent, "two_branch", episodes=3, discounts=agent.gammas)
    np.testing.assert_allclose(scores.discounted, np.tile(10.0 * agent.gammas**2, (3, 1)))
    values = agent.action_values(scores.starts)[range(3), :, agent.greedy(scores.starts)]
    np.testing.assert_allclose(values, scores.discounted)
    assert evaluate(agent, "two_branch", episodes=3).discounted.shape == (3, 0)
