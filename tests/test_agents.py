"""Laplace DQN: what its outputs mean, its targets worked by hand and by slow loops, its networks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from laplace_core.agents import LaplaceSettings, networks
from laplace_core.agents.agent import Batch
from laplace_core.agents.laplace import LaplaceAgent
from laplace_core.agents.networks import DiscountInput
from laplace_core.agents.sensitivities import Sensitivities
from laplace_core.encoding import activation, bin_masses
from laplace_core.errors import InputError
from laplace_core.training.environments import spec

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


def batch_of(count: int = 6, columns: int = 1, n_step: int = 1, observation: int = 3, actions: int = 2) -> Batch:
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


# What a reward becomes


def test_masses_agree_with_the_library_and_sum_to_one():
    sensitivities = Sensitivities(replace(SMALL, thetas=13))
    rewards = np.array([-30.0, -1.0, 0.0, 0.37, 1.0, 2.0, 30.0])
    masses = sensitivities.masses(torch.tensor(rewards, dtype=torch.float32)).numpy()
    # Three units over twelve gaps: a spacing of 1/4, hence a slope of 2.35 / (1/4) = 9.4.
    assert sensitivities.slope == pytest.approx(9.4)
    np.testing.assert_allclose(masses[:, 1:-1], bin_masses(rewards, sensitivities.thetas, 9.4), atol=1e-6)
    np.testing.assert_allclose(masses.sum(axis=1), 1.0, atol=1e-6)
    # What lies outside the thresholds is in the outermost bins, not lost.
    np.testing.assert_allclose(masses[[0, -1], [0, -1]], 1.0, atol=1e-6)
    tails = sensitivities.tails(torch.tensor(rewards, dtype=torch.float32)).numpy()
    np.testing.assert_allclose(tails[:, 1:], activation(rewards, sensitivities.thetas, 9.4), atol=1e-6)


@given(st.floats(-100.0, 100.0))
def test_asinh_sensitivities_do_not_round_rewards(reward):
    """The midpoint proxy of one reward misses it by less than a twentieth of the gap it falls into."""
    settings = replace(SMALL, thetas=113, theta_spacing="asinh", theta_min=-135.0, theta_max=135.0)
    sensitivities = Sensitivities(settings)
    masses = sensitivities.masses(torch.tensor([reward], dtype=torch.float32)).double().numpy()[0]
    gap = np.diff(sensitivities.thetas)[min(np.searchsorted(sensitivities.thetas, reward), 111)]
    assert masses @ sensitivities.bin_values == pytest.approx(reward, abs=0.05 * gap)


@pytest.mark.parametrize("name", CODES)
def test_untrained_agents_expect_reward_zero_for_ever(name):
    """Up to 1e-6 in every bin, or 1e-3 in every increment of which there are 26."""
    agent, near = LaplaceAgent(replace(SMALL, thetas=25, parametrisation=name), 3, 2), 1e-4
    if name == "accumulated":
        near = 0.026
    outputs = agent.code.initial()
    scaled = agent.code.scaled(outputs)
    assert float(scaled @ agent.code.value_weights) == pytest.approx(0.0, abs=near)
    np.testing.assert_allclose(agent.code.tails(scaled)[0], 1.0, atol=near)  # the constant channel: alive
    np.testing.assert_allclose(scaled, agent.code.encode(torch.zeros(())), atol=near)


@pytest.mark.parametrize("name", ["softmax", "accumulated", "clipped"])
def test_tails_never_rise_with_theta(name):
    agent = small(parametrisation=name)
    values, constant = agent.gamma_spaces(np.random.default_rng(0).normal(size=(20, 3)))
    assert np.all(np.diff(values, axis=-1) <= 1e-6)
    assert np.all(values[..., 0] <= constant + 1e-6)
    if name != "clipped":
        assert values.min() >= 0.0
    if name == "softmax":
        assert np.all(constant <= 1.0 / (1.0 - agent.gammas) + 1e-3)


def test_a_free_network_may_rise_with_theta():
    values, _ = small(parametrisation="free").gamma_spaces(np.random.default_rng(0).normal(size=(20, 3)))
    assert np.any(np.diff(values, axis=-1) > 1e-3)


def test_clipping_cuts_rises_and_keeps_falls():
    # 5, 3, 4, 1: the fall of 2 stays, the rise to 4 is cut to 3, and the fall of 3 from there goes on to 0.
    scaled = small(parametrisation="clipped").code.scaled(torch.tensor([5.0, 3.0, 4.0, 1.0]))
    np.testing.assert_allclose(scaled, [5.0, 3.0, 3.0, 0.0])


@pytest.mark.parametrize("name", CODES)
def test_action_values_are_the_midpoint_proxy_of_the_gamma_space(name):
    """Eq. 9 over the inner bins, and the outermost thresholds for what lies beyond them."""
    agent = small(parametrisation=name)
    observations = np.random.default_rng(0).normal(size=(4, 3))
    values, constant = agent.gamma_spaces(observations)
    thetas = agent.thetas
    middles = (thetas[1:] + thetas[:-1]) / 2
    proxy = (values[..., :-1] - values[..., 1:]) @ middles
    proxy += thetas[0] * (constant - values[..., 0]) + thetas[-1] * values[..., -1]
    expected = np.moveaxis(proxy, 1, 2)  # (B, A, G) to (B, G, A)
    np.testing.assert_allclose(agent.action_values(observations), expected, rtol=1e-4, atol=1e-3)
    np.testing.assert_allclose(agent.action_values(observations, 1), expected[:, 1], rtol=1e-4, atol=1e-3)


# Targets


def test_a_target_worked_by_hand():
    """Two thresholds, -1 and 1, slope 2.35 / 2; one transition with reward 1 that terminates; gamma = 1/2.

    f(1) = sigmoid(2.35 / 2 * 2) = sigmoid(2.35) = 0.912934 at theta = -1 and 1/2 at theta = 1. So the reward's masses
    are 1 - .912934 = .087066 below, .412934 between, .5 above. Times 1 - gamma = 1/2: .043533, .206467, .25; and the
    rest, gamma = 1/2, is death.
    """
    agent = small(gammas=1, gamma_max=0.5, thetas=2, theta_min=-1.0, theta_max=1.0)
    batch = replace(
        batch_of(1), rewards=torch.ones(1, 1, 1), terminated=torch.ones(1, 1, dtype=bool), lengths=torch.ones(1, 1)
    )
    np.testing.assert_allclose(agent.targets(batch)[0, 0], [0.043533, 0.206467, 0.25, 0.5], atol=1e-6)


def test_tails_of_a_target_worked_by_hand():
    """The same transition as tails: (1 - gamma) times 1, f(1) at -1, f(1) at 1; Q is twice that."""
    agent = small(gammas=1, gamma_max=0.5, thetas=2, theta_min=-1.0, theta_max=1.0, parametrisation="accumulated")
    batch = replace(batch_of(1), rewards=torch.ones(1, 1, 1), terminated=torch.ones(1, 1, dtype=bool))
    np.testing.assert_allclose(agent.targets(batch)[0, 0], [0.5, 0.456467, 0.25], atol=1e-6)


@pytest.mark.parametrize("columns", [1, 3])
@pytest.mark.parametrize("n_step", [1, 3])
@pytest.mark.parametrize("policy", ["shared", "per_gamma"])
@pytest.mark.parametrize("termination", ["plain", "auxiliary", "absorbing"])
@pytest.mark.parametrize("name", ["softmax", "accumulated"])
def test_targets_equal_a_loop_over_transitions_and_discounts(columns, n_step, policy, termination, name):
    double = n_step == 1
    agent = small(
        parametrisation=name, target_policy=policy, termination=termination, double=double, n_step=n_step, dueling=True
    )
    batch = batch_of(8, columns, n_step)
    np.testing.assert_allclose(agent.targets(batch), slow_targets(agent, batch), rtol=1e-4, atol=1e-6)


def slow_targets(agent: LaplaceAgent, batch: Batch) -> np.ndarray:
    """Every transition and discount by itself, reward by reward; auxiliary steps are walked one by one."""
    found = np.empty((len(batch.observations), agent.heads, agent.code.channels))
    for i, row in enumerate(found):
        for g, gamma in enumerate(agent.gammas):
            c = g if batch.rewards.shape[1] > 1 else 0
            length, discount, y = int(batch.lengths[i, c]), 1.0, 0.0
            for k in range(length):
                y = y + (1 - gamma) * discount * agent.code.encode(batch.rewards[i, c, k]).numpy()
                discount *= gamma
            if batch.terminated[i, c]:
                nothing = agent.code.encode(torch.zeros(())).numpy()
                steps = {"plain": 0, "auxiliary": 10 - int(batch.elapsed[i, c]), "absorbing": 20_000}
                for _ in range(steps[agent.settings.termination]):
                    y = y + (1 - gamma) * discount * nothing
                    discount *= gamma
                row[g] = y + discount * agent.code.ended.numpy()
                continue
            following = batch.next_observations[i : i + 1, c : c + 1]
            judge = agent.network if agent.settings.double else agent.target
            values = agent._action_values(judge, following, None)[0].detach().numpy()
            best = values[agent.acting_head if agent.settings.target_policy == "shared" else g].argmax()
            row[g] = y + discount * agent.code.scaled(agent.target(following))[0, g, best].numpy()
    return found


def test_absorbing_states_are_the_limit_of_auxiliary_ones():
    batch = batch_of(8)
    far = small(termination="auxiliary", time_limit=10**6)
    np.testing.assert_allclose(far.targets(batch), small(termination="absorbing").targets(batch), atol=1e-5)


def test_auxiliary_states_keep_the_values_and_change_the_survival():
    """Reward 0 adds nothing to a value; the constant channel counts the steps that were added."""
    batch = batch_of(30)
    plain, auxiliary = small(thetas=41), small(thetas=41, termination="auxiliary")
    ended = batch.terminated[:, 0].numpy()
    values = [agent._values(agent.targets(batch), agent._gammas)[ended].numpy() for agent in (plain, auxiliary)]
    np.testing.assert_allclose(*values, atol=1e-3)
    alive = [agent.targets(batch)[ended][..., -1].numpy() for agent in (plain, auxiliary)]
    assert np.all(alive[1] < alive[0])


# Losses


@pytest.mark.parametrize("name", CODES)
@pytest.mark.parametrize("consistency", [0.0, 0.7])
def test_losses_equal_a_loop_over_discounts_and_channels(name, consistency):
    agent, batch = small(parametrisation=name, consistency=consistency), batch_of(5)
    target = agent.targets(batch).numpy()
    outputs = agent.network(batch.observations)
    expected = np.zeros((5, 3))
    for i in range(5):
        for g, gamma in enumerate(agent.gammas):
            out = outputs[i, g, batch.actions[i, 0]].detach()
            scaled, y = agent.code.scaled(out).double().numpy(), target[i, g].astype(float)
            if name == "softmax":
                expected[i, g] = sum(t * np.log(t / p) for t, p in zip(y, scaled, strict=True) if t > 0)
            else:
                expected[i, g] = np.mean([huber((p - t) / (1 - gamma)) for p, t in zip(scaled, y, strict=True)])
            error = (scaled - y) @ agent.code.value_weights.double().numpy() / (1 - gamma)
            expected[i, g] += consistency * (1 - gamma) * error**2 / 2
    np.testing.assert_allclose(agent.losses(batch).detach(), expected, rtol=2e-4, atol=1e-5)


def huber(error: float) -> float:
    return error**2 / 2 if abs(error) < 1 else abs(error) - 0.5


def test_cross_entropy_pulls_each_logit_by_prediction_less_target():
    """The gradient of -sum y log softmax(x) is softmax(x) - y: .5 - .8, .5 - .2."""
    agent = small(gammas=1, thetas=2)
    outputs = torch.tensor([[[0.0, 0.0, -50.0, -50.0]]], requires_grad=True)
    target = torch.tensor([[[0.8, 0.2, 0.0, 0.0]]])
    agent.code.loss(outputs, target, agent._gammas)[0].sum().backward()
    np.testing.assert_allclose(outputs.grad[0, 0], [-0.3, 0.3, 0.0, 0.0], atol=1e-6)


def test_the_loss_is_zero_where_the_prediction_is_the_target():
    agent = small()
    target = agent.targets(batch_of())
    loss, _ = agent.code.loss(target.clamp(min=1e-30).log(), target, agent._gammas)
    np.testing.assert_allclose(loss, 0.0, atol=1e-5)


# Networks


@pytest.mark.parametrize("network", NETWORKS)
@pytest.mark.parametrize("dueling", [False, True])
@pytest.mark.parametrize("columns", [1, 7])
def test_partial_evaluations_equal_the_whole(network, dueling, columns):
    agent = small(network=network, dueling=dueling, gammas=7, gamma_min=0.3)
    batch = batch_of(5, columns)
    whole = agent.network(batch.observations)
    assert whole.shape == (5, 7, 2, agent.code.channels)
    actions = batch.actions.expand(-1, 7)
    chosen = agent.network(batch.observations, actions=actions)
    for i in range(5):
        for g in range(7):
            torch.testing.assert_close(chosen[i, g], whole[i, g, actions[i, g]], rtol=1e-4, atol=1e-5)
    for g in range(7):
        torch.testing.assert_close(agent.network(batch.observations, only=g)[:, 0], whole[:, g], rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize("network", NETWORKS)
def test_observations_of_their_own_equal_one_discount_at_a_time(network):
    agent, batch = small(network=network, gammas=7), batch_of(5, 7)
    whole = agent.network(batch.observations)
    for g in range(7):
        alone = agent.network(batch.observations[:, g : g + 1])[:, g]
        torch.testing.assert_close(whole[:, g], alone, rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize("network", NETWORKS)
@pytest.mark.parametrize("dueling", [False, True])
@pytest.mark.parametrize("name", ["softmax", "free"])
def test_weights_are_counted_without_building(network, dueling, name):
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
    with pytest.raises(InputError, match="own grid"):
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


@pytest.mark.parametrize(
    ("given", "named"),
    [
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
    ],
)
def test_settings_that_do_not_fit_are_refused(given, named):
    with pytest.raises(InputError, match=named):
        LaplaceSettings.parse(given)


def test_settings_are_what_they_were_after_a_round_through_text():
    settings = replace(SMALL, learning_rate=1.7e-3, dueling=True, network="multiplexer")
    assert LaplaceSettings.parse({name: str(value) for name, value in settings.as_dict().items()}) == settings
    assert LaplaceSettings.parse({}) == LaplaceSettings()


def test_the_schema_and_the_defaults_agree():
    defaults = LaplaceSettings().as_dict()
    assert {parameter.name: parameter.default for parameter in LaplaceSettings.SCHEMA} == defaults
    assert all(parameter.help.endswith(".") for parameter in LaplaceSettings.SCHEMA)


def test_auxiliary_states_need_a_time_limit():
    with pytest.raises(InputError, match="time limit"):
        LaplaceAgent(replace(SMALL, termination="auxiliary"), 3, 2, None)


def test_every_environment_has_a_size():
    assert spec("CartPole-v1") == (4, 2, 500)
    assert spec("Acrobot-v1") == (6, 3, 500)
    assert spec("two_branch") == (3, 2, 200)


def test_the_network_that_is_built_is_the_one_named():
    names = {name: type(small(network=name).network).__name__ for name in NETWORKS}
    assert names == {"trunk": "Trunk", "network": "DiscountInput", "multiplexer": "DiscountInput"}
    assert networks.MULTIPLEXER_BOUNDS == (0.5, 0.75)
