"""Laplace DQN: its networks, its updates, its settings."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import torch

from laplace_core.agents import ENVIRONMENTS, LaplaceSettings, networks
from laplace_core.agents.agent import Batch
from laplace_core.agents.laplace import LaplaceAgent
from laplace_core.agents.networks import DiscountInput
from laplace_core.environments.vector import _time_limit, make, spec
from laplace_core.errors import InputError

torch.set_num_threads(1)
SMALL = LaplaceSettings(hidden=8, features=4, gammas=3, thetas=5, batch=6)
NETWORKS = ("trunk", "network", "multiplexer")
CODES = ("softmax", "accumulated", "clipped", "free")


def small(observation: int = 3, actions: int = 2, time_limit: int | None = 10, **changes) -> LaplaceAgent:
    """An agent whose weights are all at random, so that no two outputs are alike."""
    agent = LaplaceAgent(replace(SMALL, **changes), observation, actions, time_limit)
    random = torch.Generator().manual_seed(1)
    for network in (agent.network, agent.target):
        for parameter in network.parameters():
            parameter.data += 0.5 * torch.randn(parameter.shape, generator=random)
    return agent


def batch_of(count: int = 6, *, columns: int = 1, n_step: int = 1, observation: int = 3, actions: int = 2) -> Batch:
    random = np.random.default_rng(0)
    shape = (count, columns)
    return Batch(
        observations=torch.tensor(random.normal(size=(*shape, observation)), dtype=torch.float32),
        actions=torch.tensor(random.integers(actions, size=shape)),
        rewards=torch.tensor(random.uniform(-0.5, 1.5, size=(*shape, n_step)), dtype=torch.float32),
        lengths=torch.tensor(random.integers(1, n_step + 1, size=shape)),
        next_observations=torch.tensor(random.normal(size=(*shape, observation)), dtype=torch.float32),
        terminated=torch.tensor(random.random(shape) < 0.4),
        elapsed=torch.tensor(random.integers(n_step, 9, size=shape)),
        weights=torch.ones(count),
    )


# Networks


def test_partial_evaluations_equal_the_whole(subtests):
    for network in NETWORKS:
        for dueling in [False, True]:
            for columns in [1, 7]:
                with subtests.test(network=network, dueling=dueling, columns=columns):
                    agent = small(network=network, dueling=dueling, gammas=7, gamma_min=0.3)
                    batch = batch_of(5, columns=columns)
                    whole = agent.network(batch.observations)
                    assert whole.shape == (5, 7, 2, agent.code.channels)
                    actions = batch.actions.expand(-1, 7)
                    chosen = agent.network(batch.observations, actions=actions)
                    for i in range(5):
                        for g in range(7):
                            torch.testing.assert_close(chosen[i, g], whole[i, g, actions[i, g]], rtol=1e-4, atol=1e-5)
                    for g in range(7):
                        torch.testing.assert_close(
                            agent.network(batch.observations, only=g)[:, 0], whole[:, g], rtol=1e-4, atol=1e-5
                        )


@pytest.mark.parametrize("network", NETWORKS)
def test_observations_of_their_own_equal_one_discount_at_a_time(network):
    agent, batch = small(network=network, gammas=7), batch_of(5, columns=7)
    whole = agent.network(batch.observations)
    for g in range(7):
        alone = agent.network(batch.observations[:, g : g + 1])[:, g]
        torch.testing.assert_close(whole[:, g], alone, rtol=1e-4, atol=1e-5)


def test_weights_are_counted_without_building(subtests):
    for network in NETWORKS:
        for dueling in [False, True]:
            for name in ["softmax", "free"]:
                with subtests.test(network=network, dueling=dueling, name=name):
                    agent = small(network=network, dueling=dueling, parametrisation=name)
                    built = sum(parameter.numel() for parameter in agent.network.parameters())
                    assert LaplaceAgent.network_numbers(agent.settings, 3, 2) == built


def test_the_multiplexer_has_a_tower_for_each_range_of_discounts():
    """Discounts up to .5, up to .75 and above are three towers': changing one moves no other's values."""
    agent = small(network="multiplexer", spacing="paper", gammas=15)
    observations = batch_of(3).observations
    before = agent.network(observations)
    agent.network.towers[1].head.bias.data += 1.0
    moved = (agent.network(observations) - before).abs().amax(dim=(0, 2, 3)) > 0.5
    assert moved.tolist() == [0.5 < gamma <= 0.75 for gamma in agent.gammas]


def test_discounts_that_were_never_trained_lie_between_their_neighbours():
    agent = small(network="network", gammas=15)
    observations = batch_of(3).observations
    network: DiscountInput = agent.network
    whole = network(observations)
    torch.testing.assert_close(network.at(observations, network.grid), whole)
    between = network.at(observations, (float(agent.gammas[4]) + 1e-6, float(agent.gammas[9]) + 1e-6))
    torch.testing.assert_close(between, whole[:, [4, 9]], rtol=1e-3, atol=1e-3)


@pytest.mark.parametrize("network", ["network", "multiplexer"])
def test_a_gamma_space_may_be_had_at_other_discounts(network):
    agent, observation = small(network=network, gammas=15), np.ones(3)
    own, chosen = agent.gamma_space(observation), agent.gamma_space(observation, agent.gammas[3:7])
    np.testing.assert_allclose(chosen.values, own.values[:, 3:7], rtol=1e-4)
    np.testing.assert_allclose(chosen.constant, own.constant[:, 3:7], rtol=1e-4)
    for wrong in ([], [0.5, 0.4], [0.0, 0.5], [0.5, 1.0], [float("nan")]):
        with pytest.raises(InputError, match="between 0 and 1"):
            agent.gamma_space(observation, np.array(wrong))


def test_a_trunk_has_no_other_discounts():
    with pytest.raises(InputError, match="only at its trained discounts"):
        small().gamma_space(np.ones(3), np.array([0.5]))


def test_dueling_shares_what_all_actions_have_in_common():
    """V + A_a - mean A: adding the same to every advantage's weights changes nothing."""
    agent, batch = small(dueling=True), batch_of()
    before = agent.network(batch.observations)
    agent.network.head.weight.data += 3.0
    torch.testing.assert_close(agent.network(batch.observations), before, rtol=1e-3, atol=1e-3)


# Agents


def test_one_update_learns_for_every_discount():
    agent, batch = small(learning_rate=1e-2), batch_of(16)
    agent.target.load_state_dict(agent.network.state_dict())
    before = agent.losses(batch).mean(dim=0).detach()
    for _ in range(60):
        agent.update(batch, 0.0)
    assert torch.all(agent.losses(batch).mean(dim=0) < 0.7 * before)


def test_the_average_follows_at_its_own_pace():
    agent, batch = small(averaging=0.25), batch_of()
    slow = [parameter.clone() for parameter in agent.target.parameters()]
    agent.update(batch, 0.0)
    for old, now, fast in zip(slow, agent.target.parameters(), agent.network.parameters(), strict=True):
        torch.testing.assert_close(now, 0.75 * old + 0.25 * fast.detach())


def test_the_same_seed_gives_the_same_network_and_leaves_torch_alone():
    torch.manual_seed(5)
    expected = torch.rand(1)
    torch.manual_seed(5)
    one, two, other = (LaplaceAgent(replace(SMALL, seed=seed), 3, 2) for seed in (3, 3, 4))
    assert torch.rand(1) == expected
    weights = [next(agent.network.parameters()) for agent in (one, two, other)]
    assert torch.equal(weights[0], weights[1])
    assert not torch.equal(weights[0], weights[2])


def test_behaviour_follows_the_head_that_it_is_given():
    agent = small()
    observations = np.random.default_rng(0).normal(size=(30, 3))
    heads = np.arange(30) % 3
    agent.target.load_state_dict(agent.network.state_dict())
    values = agent.action_values(observations)
    np.testing.assert_array_equal(agent.behave(observations, heads), values[np.arange(30), heads].argmax(-1))
    np.testing.assert_array_equal(agent.greedy(observations), values[:, 2].argmax(-1))
    np.testing.assert_array_equal(agent.behave(observations, np.full(30, 2)), agent.greedy(observations))


def test_the_gamma_space_of_one_observation_is_its_row_of_the_batch():
    agent, observations = small(), np.random.default_rng(0).normal(size=(4, 3))
    values, constant = agent.gamma_spaces(observations)
    one = agent.gamma_space(observations[2])
    assert one.values.dtype == np.float64
    assert one.values.shape == (2, 3, 5)
    np.testing.assert_allclose(one.values, values[2], rtol=1e-5)
    np.testing.assert_allclose(one.constant, constant[2], rtol=1e-5)


# Settings


def test_settings_that_do_not_fit_are_refused(subtests):
    for given, named in [
        ({"gammas": 0}, "gammas"),
        ({"hidden": 10**6}, "hidden"),
        ({"network": "none"}, "network"),
        ({"environment": "Ant-v5"}, "environment"),
        ({"learning_rate": float("nan")}, "learning_rate"),
        ({"theta_min": 0.5}, "theta_min"),
        ({"gamma_min": 0.995}, "gamma"),
        ({"epsilon_final": 1.0, "epsilon_first": 0.5}, "epsilon_final"),
        ({"learning_starts": 2_000, "buffer": 1_000}, "learning_starts"),
        ({"prioritised": True, "experience": "per_discount"}, "prioritised"),
        ({"gamms": 3}, "gamms"),
    ]:
        with subtests.test(given=given, named=named), pytest.raises(InputError, match=named):
            LaplaceSettings.parse(given)


def test_settings_are_what_they_were_after_a_round_through_text():
    settings = replace(SMALL, learning_rate=1.7e-3, dueling=True, network="multiplexer")
    assert LaplaceSettings.parse({name: str(value) for name, value in settings.as_dict().items()}) == settings
    assert LaplaceSettings.parse({}) == LaplaceSettings()


def test_auxiliary_states_need_a_time_limit():
    with pytest.raises(InputError, match="time limit"):
        LaplaceAgent(replace(SMALL, termination="auxiliary"), 3, 2, None)


def test_the_sizes_written_down_are_those_of_the_environment(subtests):
    for name in ENVIRONMENTS:
        with subtests.test(name):
            if name == "LunarLander-v3":
                pytest.importorskip("Box2D")
            env, sizes = make(name), spec(name)
            assert env.reset(seed=0)[0].shape == (sizes.observation,)
            assert env.action_space.n == sizes.actions
            assert _time_limit(env)._max_episode_steps == sizes.time_limit


def test_environments_off_the_list_are_refused(subtests):
    for name in ["Ant-v5", "gym:Taxi-v99", "os:system", "world.json", "../CartPole-v1", ""]:
        with subtests.test(name=name):
            for use in (make, spec):
                with pytest.raises(InputError, match="is not one of"):
                    use(name)


def test_the_network_that_is_built_is_the_one_named():
    names = {name: type(small(network=name).network).__name__ for name in NETWORKS}
    assert names == {"trunk": "Trunk", "network": "DiscountInput", "multiplexer": "DiscountInput"}
    assert networks.MULTIPLEXER_BOUNDS == (0.5, 0.75)
