"""What the outputs of Laplace DQN mean; its targets and losses, worked by hand and by slow loops."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from laplace_core.agents.agent import Batch
from laplace_core.agents.laplace import LaplaceAgent
from laplace_core.agents.sensitivities import Sensitivities
from laplace_core.code.encoding import activation, bin_masses
from tests.laplace_core.agents.test_agents import SMALL, batch_of, small

CODES = ("softmax", "accumulated", "clipped", "free")


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


def test_targets_equal_a_loop_over_transitions_and_discounts(subtests):
    kinds = product(
        (1, 3), (1, 3), ("shared", "per_gamma"), ("plain", "auxiliary", "absorbing"), ("softmax", "accumulated")
    )
    for columns, n_step, policy, termination, name in kinds:
        with subtests.test(name, columns=columns, n_step=n_step, policy=policy, termination=termination):
            agent = small(
                parametrisation=name, target_policy=policy, termination=termination, double=n_step == 1, n_step=n_step,
                dueling=True,
            )  # fmt: skip
            batch = batch_of(4, columns=columns, n_step=n_step)
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


def test_losses_equal_a_loop_over_discounts_and_channels(subtests):
    for name in CODES:
        for consistency in [0.0, 0.7]:
            with subtests.test(name=name, consistency=consistency):
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
                            expected[i, g] = np.mean(
                                [huber((p - t) / (1 - gamma)) for p, t in zip(scaled, y, strict=True)]
                            )
                        error = (scaled - y) @ agent.code.value_weights.double().numpy() / (1 - gamma)
                        expected[i, g] += consistency * (1 - gamma) * error**2 / 2
                np.testing.assert_allclose(agent.losses(batch).detach(), expected, rtol=2e-4, atol=1e-5)


def test_the_acting_discount_may_have_a_share_of_the_loss_and_long_discounts_more_of_the_consistency():
    """Three discounts, a share of .7: weights 3 * .15, 3 * .15 and 3 * .7. Exponent .5 for 1: (1 - gamma)^-.5 more."""
    batch, losses = batch_of(5), {}
    for consistency in (0.0, 1.0):
        for more in ({}, {"acting_share": 0.7}, {"consistency_exponent": 0.5}):
            agent = small(consistency=consistency, **more)
            losses[consistency, *more] = agent.losses(batch).detach().numpy()
    assert agent.acting_head == 2
    shares = [0.45, 0.45, 2.1]
    np.testing.assert_allclose(losses[1.0, "acting_share"], losses[1.0,] * shares, rtol=1e-4)
    np.testing.assert_allclose(losses[0.0, "consistency_exponent"], losses[0.0,], rtol=1e-6)
    plain, more = losses[1.0,] - losses[0.0,], losses[1.0, "consistency_exponent"] - losses[0.0,]
    np.testing.assert_allclose(more, plain / np.sqrt(1 - agent.gammas), rtol=1e-3, atol=1e-5)


def test_a_single_discount_has_all_of_the_loss():
    batch = batch_of(5)
    losses = [small(gammas=1, acting_share=share).losses(batch).detach().numpy() for share in (0.0, 0.3)]
    np.testing.assert_array_equal(*losses)


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
