"""Returns as agents have learned them and as they come: definitions, distances, and an exact world."""

from __future__ import annotations

import io
import json

import gymnasium
import numpy as np
import pytest
import torch

from laplace_core import load_world
from laplace_core.acting import return_laws as module
from laplace_core.acting.return_laws import (
    INDEPENDENT,
    LEARNED,
    LEVELS,
    MEAN,
    ReturnLaw,
    SimulatedReturns,
    has_return_law,
    laws_npz,
    outputs_along,
    return_laws,
    return_quantiles,
    simulate_returns,
    steps_until_cut,
)
from laplace_core.acting.rollout import roll_out
from laplace_core.agents.settings import (
    C51Settings,
    DqnSettings,
    ExpectileSettings,
    FixedHorizonSettings,
    LaplaceSettings,
    QrdqnSettings,
)
from laplace_core.code.encoding import theta_midpoints
from laplace_core.inverse import decode
from laplace_core.tabular.peers import quantiles_of, return_distribution
from laplace_core.tabular.returns import independent_steps_return, wasserstein
from laplace_core.training.checkpoint import new_agent

torch.set_num_threads(1)
PEERS = (C51Settings, QrdqnSettings, ExpectileSettings, DqnSettings)


def made(settings, environment="CartPole-v1", **given):
    """An untrained agent whose last layer is not zero, so that its outputs differ."""
    agent = new_agent(settings(environment=environment, hidden=8, seed=3, **given))
    with torch.no_grad():
        for parameter in agent.target.parameters():
            parameter += 0.3 * torch.randn(parameter.shape, generator=torch.Generator().manual_seed(1))
    return agent


class Pushing:
    """Keeps the pole of CartPole up for long."""

    n_observations, n_actions, acting_head, gammas = 4, 2, 0, np.array([0.9])

    def action_values(self, observations, head):
        push = observations[:, 2] + 0.5 * observations[:, 3] + 0.02 * observations[:, 0] + 0.05 * observations[:, 1]
        return np.stack([-push, push], axis=1)


class OnIce:
    """Goes down or right on the frozen lake, by the number of the state."""

    n_observations, n_actions, acting_head, gammas = 16, 4, 0, np.array([0.95])
    policy = np.where(np.arange(16) % 2, 1, 2)

    def action_values(self, observations, head):
        return np.eye(4)[self.policy[observations.argmax(axis=1)]]


def test_without_chance_one_continuation_says_all_and_what_is_cut_off_is_told():
    """gamma .9: .9^50 = .0052 and .9^51 = .0046, so K = 51; a reward of 1 at each step makes (1 - .9^51) / .1 = 9.954,
    and what is left out is .9^51 / .1 = .0464."""
    rollout = roll_out(Pushing(), "CartPole-v1", 3, horizon=30)
    found = simulate_returns(Pushing(), rollout, 4, int(rollout.actions[4]), count=50)
    assert (steps_until_cut(0.9), found.steps, found.returns.shape) == (51, 51, (1,))
    assert found.returns[0] == pytest.approx(9.9536, abs=1e-4)
    assert (found.running, found.missing) == (1.0, pytest.approx(0.0464, abs=1e-4))
    assert found.mean == (found.returns[0], 0.0)
    assert found.by_chance == 0.0


def test_on_the_ice_what_comes_is_the_exact_law():
    agent, name = OnIce(), "gym:FrozenLake-v1"
    rollout = roll_out(agent, name, 0)
    found = simulate_returns(agent, rollout, 0, action=3, count=600)
    exact = return_distribution(load_world(name), 0, 3, agent.policy, gamma=0.95)
    law = ReturnLaw(LEARNED, 0.95, exact.locations, exact.masses)
    mean, error = found.mean
    assert abs(mean - law.mean) < 4 * error + found.missing
    assert found.distance(law) < 3 * found.by_chance + found.missing
    # The other action leads elsewhere.
    assert found.distance(law) < found.distance(
        ReturnLaw(LEARNED, 0.95, *return_distribution(load_world(name), 14, 1, agent.policy, gamma=0.95)[:2])
    )


def test_distance_and_what_chance_alone_makes():
    """Half at 0 and half at 2 against all at 1: W1 = 1. F = 1/2 on [0, 2], so sqrt(2 / 4 / (2 pi)) * 2 = .564."""
    came = SimulatedReturns(np.array([2.0, 0.0]), 0.9, 10, 0.0, 0.0)
    assert came.distance(ReturnLaw(MEAN, 0.9, np.array([1.0]), np.ones(1))) == pytest.approx(1.0)
    assert came.by_chance == pytest.approx(0.5642, abs=1e-4)


def test_chance_alone_makes_what_drawing_again_makes():
    rng = np.random.default_rng(0)
    population = rng.exponential(10.0, 4_000), np.ones(4_000)
    again = [wasserstein((rng.choice(population[0], 100), np.ones(100)), population) for _ in range(200)]
    told = [SimulatedReturns(rng.choice(population[0], 100), 0.9, 9, 0.0, 0.0).by_chance for _ in range(200)]
    assert np.mean(told) == pytest.approx(np.mean(again), rel=0.1)


@pytest.mark.parametrize("settings", PEERS)
def test_a_peer_says_what_it_has_learned(settings):
    agent, seen = made(settings), np.array([0.1, -0.2, 0.05, 0.3], np.float32)
    laws, distribution = return_laws(agent, seen), agent.return_distribution(seen)
    values = agent.action_values(seen[None], agent.acting_head)[0]
    for action, law in enumerate(laws):
        np.testing.assert_array_equal(law.locations, distribution[0][action])
        np.testing.assert_array_equal(law.masses, distribution[1][action])
        assert law.mean == pytest.approx(values[action], abs=2e-3 * (1 + abs(values[action])))
        assert law.kind == (MEAN if settings is DqnSettings else LEARNED)
    (one,) = return_laws(agent, seen, [1])
    np.testing.assert_array_equal(one.locations, laws[1].locations)


def test_a_laplace_agent_says_it_as_if_steps_were_independent():
    agent, seen = made(LaplaceSettings, features=4, gammas=6, thetas=9), np.full(4, 0.1, np.float32)
    (law,) = return_laws(agent, seen, [1], alpha=0.3)
    space = agent.gamma_space(seen)
    steps = steps_until_cut(space.gammas[agent.acting_head])
    tau_space = decode(space.differences, space.gammas, steps, 0.3)[1]
    discounts = space.gammas[agent.acting_head] ** np.arange(steps)
    rewards = np.array([space.thetas[0], *theta_midpoints(space.thetas), space.thetas[-1]])  # the ends are open
    wanted = independent_steps_return(tau_space, rewards, discounts)
    assert law.kind == INDEPENDENT
    assert steps == 528  # .99^528 = .00496
    np.testing.assert_allclose(law.locations, wanted[0])
    np.testing.assert_allclose(law.masses, wanted[1])


@pytest.mark.parametrize("settings", PEERS)
def test_quantiles_along_an_episode_are_those_of_each_step(settings):
    agent = made(settings)
    rollout = roll_out(agent, "CartPole-v1", 5, rule="random")
    said = outputs_along(agent, rollout)
    found = return_quantiles(said, rollout.actions)
    if settings is DqnSettings:
        assert found is None
        return
    assert found.shape == (len(rollout), len(LEVELS))
    for step in (0, len(rollout) - 1):
        law = return_laws(agent, rollout.observations[step], [int(rollout.actions[step])])[0]
        np.testing.assert_allclose(said["masses"][step, rollout.actions[step]], law.masses, atol=1e-6)
        wanted = quantiles_of(law.locations, law.masses / law.masses.sum(), np.array(LEVELS))
        np.testing.assert_allclose(found[step], wanted, rtol=1e-5, atol=1e-5)


def test_who_says_nothing_of_the_whole_return():
    assert not has_return_law(made(FixedHorizonSettings))
    assert has_return_law(made(DqnSettings))


def test_what_is_outputs_along_an_episode(monkeypatch):
    agent = made(FixedHorizonSettings, horizon=7)
    rollout = roll_out(agent, "CartPole-v1", 5, rule="random")
    said = outputs_along(agent, rollout)
    assert return_quantiles(said, rollout.actions) is None
    assert said["horizon_values"].shape == (len(rollout), 7, 2)
    np.testing.assert_allclose(said["horizon_values"][4], agent.action_values(rollout.observations[4:5])[0], rtol=1e-5)
    laplace = made(LaplaceSettings, features=4)
    assert outputs_along(laplace, roll_out(laplace, "CartPole-v1", 5, rule="random")) == {}
    monkeypatch.setattr(module, "MOST_OUTPUTS", 14 * len(rollout) - 1)
    assert outputs_along(agent, rollout) == {}


def test_a_file_holds_every_law_and_what_came():
    law = ReturnLaw(MEAN, 0.9, np.array([1.0]), np.ones(1))
    came = SimulatedReturns(np.array([0.5, 1.5]), 0.9, 51, 0.0, 0.0)
    file = np.load(io.BytesIO(laws_npz(["dqn", "c51"], [law, law], [came, came])))
    assert json.loads(str(file["settings"]))[1] == {"algorithm": "c51", "kind": MEAN, "gamma": 0.9}
    np.testing.assert_array_equal(file["1_c51_came"], came.returns)
    assert "0_dqn_came" not in np.load(io.BytesIO(laws_npz(["dqn"], [law])))


def test_whoever_watches_a_simulation_does_not_change_it():
    # The episode's own rule, random actions, is another process than the agent's policy.
    agent = made(DqnSettings)
    rollout = roll_out(agent, "CartPole-v1", 5, rule="random")
    heard = []
    watched = simulate_returns(agent, rollout, 0, 1, progress=lambda done, of: heard.append((done, of)))
    np.testing.assert_array_equal(watched.returns, simulate_returns(agent, rollout, 0, 1).returns)
    assert heard


def test_returns_are_of_the_agent_s_own_policy_whatever_rule_the_episode_has():
    """Held against the environment itself, played by hand: the pole stands for long, where random actions drop it."""
    agent = Pushing()
    rollout = roll_out(made(DqnSettings), "CartPole-v1", 5, rule="random")
    step, action = len(rollout) // 2, 1
    env = gymnasium.make("CartPole-v1", max_episode_steps=-1)
    env.reset(seed=5)
    for past in rollout.actions[:step]:
        env.step(int(past))
    wanted, over = 0.0, False
    for t in range(steps_until_cut(0.9)):
        if over:
            break
        seen, reward, over, _, _ = env.step(action)
        wanted += 0.9**t * reward
        action = int(agent.action_values(seen[None], 0)[0].argmax())
    env.close()
    found = simulate_returns(agent, rollout, step, 1)
    np.testing.assert_allclose(found.returns, [wanted], rtol=1e-12)
    assert wanted > sum(0.9**t for t in range(len(rollout) - step)) + 0.5
