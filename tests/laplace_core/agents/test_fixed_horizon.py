"""Fixed-horizon DQN: its values, targets and loss, worked by hand and against a slow loop."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import torch

from tests.laplace_core.agents.test_agents import batch_of
from tests.laplace_core.agents.test_peers import peer


def test_values_for_no_time_are_nothing():
    agent = peer("fixed_horizon")
    values = agent.values(agent.network, torch.ones(4, 1, 3), torch.tensor([0, 1, 6]).expand(4, -1))
    assert torch.all(values[:, 0] == 0.0)
    assert torch.all(values[:, 1:] != 0.0)


def test_fixed_horizon_targets_worked_by_hand():
    """Rewards 1, 2 and gamma 1/2, two steps: T = 1 has 1, T = 2 has 1 + 2/2, T = 3 adds Q(s_2, a*, 1) / 4."""
    agent = peer("fixed_horizon", gamma=0.5, n_step=2)
    batch = replace(
        batch_of(1, n_step=2), rewards=torch.tensor([[[1.0, 2.0]]]), lengths=torch.tensor([[2]]),
        terminated=torch.tensor([[False]]),
    )  # fmt: skip
    left = torch.tensor([[1]])
    best = agent.values(agent.network, batch.next_observations, left).argmax().item()
    later = agent.values(agent.target, batch.next_observations, left)[0, 0, best].item()
    assert later != 0.0
    found = agent.targets(batch, torch.tensor([[1, 2, 3]]))
    np.testing.assert_allclose(found[0], [1.0, 2.0, 2.0 + 0.25 * later], rtol=1e-5)


def test_a_fixed_horizon_loss_is_the_squared_error_over_the_steps():
    """Errors 3 at T = 2 and gamma 1/2, of 1 + 1/2 discounted steps: 9/2 / 1.5 = 3."""
    agent, batch, times = peer("fixed_horizon", gamma=0.5), batch_of(1), torch.tensor([[2]])
    value = agent.values(agent.network, batch.observations, times)[0, 0, batch.actions[0, 0]]
    target = (value + 3.0).detach().view(1, 1)
    assert agent.losses(batch, times, target).item() == pytest.approx(3.0, rel=1e-5)


@pytest.mark.parametrize("double", [False, True])
@pytest.mark.parametrize("n_step", [1, 3])
def test_fixed_horizon_targets_equal_a_loop(n_step, double):
    agent, batch = peer("fixed_horizon", gamma=0.8, double=double, dueling=True), batch_of(8, n_step=n_step)
    times = torch.tensor(np.random.default_rng(3).integers(1, 7, size=(8, 3)))
    found = agent.targets(batch, times)
    for i in range(8):
        for j, T in enumerate(times[i].tolist()):
            total, length = 0.0, int(batch.lengths[i, 0])
            for k in range(min(length, T)):
                total += 0.8**k * float(batch.rewards[i, 0, k])
            if length < T and not batch.terminated[i, 0]:
                following, left = batch.next_observations[i : i + 1], torch.tensor([[T - length]])
                judge = agent.network if double else agent.target
                best = agent.values(judge, following, left)[0, 0].argmax()
                total += 0.8**length * agent.values(agent.target, following, left)[0, 0, best].item()
            assert found[i, j].item() == pytest.approx(total, rel=1e-4, abs=1e-5)


def test_every_time_to_go_is_drawn():
    agent, batch = peer("fixed_horizon"), batch_of(200)
    times, targets = agent.prepare(batch)
    assert times.unique().tolist() == [1, 2, 3, 4, 5, 6]
    torch.testing.assert_close(targets, agent.targets(batch, times))


def test_heads_of_a_fixed_horizon_are_its_times_to_go():
    agent, observations = peer("fixed_horizon"), np.random.default_rng(0).normal(size=(30, 3))
    agent.target.load_state_dict(agent.network.state_dict())
    heads, values = np.arange(30) % 6, agent.action_values(observations)
    assert values.shape == (30, 6, 2)
    for head in range(6):
        np.testing.assert_allclose(agent.action_values(observations, head), values[:, head], rtol=1e-4, atol=1e-5)
    np.testing.assert_array_equal(agent.behave(observations, heads), values[np.arange(30), heads].argmax(-1))
    np.testing.assert_array_equal(agent.greedy(observations), values[:, 5].argmax(-1))
