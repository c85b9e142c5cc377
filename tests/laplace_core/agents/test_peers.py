"""The peers: their losses worked by hand, and what is fast against slow loops."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from laplace_core.agents import SETTINGS, qrdqn
from laplace_core.agents.agent import Agent, Batch
from laplace_core.agents.c51 import project
from laplace_core.agents.registry import AGENTS
from laplace_core.errors import InputError
from laplace_core.tabular import peers as tables
from tests.laplace_core.agents.test_agents import batch_of

torch.set_num_threads(1)
PEERS = ("c51", "qrdqn", "expectile", "dqn")
OTHERS = (*PEERS, "fixed_horizon")
FEW = {
    "c51": {"atoms": 5, "v_min": -2.0, "v_max": 3.0}, "qrdqn": {"quantiles": 4}, "expectile": {"expectiles": 5},
    "dqn": {}, "fixed_horizon": {"horizon": 6, "times": 3}, "laplace": {},
}  # fmt: skip


def peer(algorithm: str, **changes) -> Agent:
    """An agent whose weights are all at random, so that no two outputs are alike."""
    settings = SETTINGS[algorithm](**({"hidden": 8, "batch": 6} | FEW[algorithm] | changes))
    agent = AGENTS[algorithm](settings, 3, 2, 10)
    random = torch.Generator().manual_seed(1)
    for network in (agent.network, agent.target):
        for parameter in network.parameters():
            parameter.data += 0.5 * torch.randn(parameter.shape, generator=random)
    return agent


def row(*values: float) -> torch.Tensor:
    return torch.tensor([values], requires_grad=True)


# Networks


def test_weights_are_counted_without_building(subtests):
    for dueling in [False, True]:
        for algorithm in OTHERS:
            with subtests.test(dueling=dueling, algorithm=algorithm):
                agent = peer(algorithm, dueling=dueling)
                built = sum(parameter.numel() for parameter in agent.network.parameters())
                assert agent.network_numbers(agent.settings, 3, 2) == built


def test_dueling_shares_what_all_actions_have_in_common():
    """V + A_a - mean A: adding the same to every advantage changes nothing, adding it to V changes all."""
    agent, batch = peer("qrdqn", dueling=True), batch_of(9)
    before = agent.network(batch.observations)
    agent.network.head.bias.data += 3.0
    torch.testing.assert_close(agent.network(batch.observations), before, rtol=1e-5, atol=1e-4)
    agent.network.state.bias.data += 3.0
    torch.testing.assert_close(agent.network(batch.observations), before + 3.0 * agent.scale, rtol=1e-5, atol=1e-4)


@pytest.mark.parametrize("dueling", [False, True])
def test_untrained_networks_are_near_their_initial_outputs(dueling):
    agent = AGENTS["c51"](SETTINGS["c51"](dueling=dueling), 3, 2)
    outputs = agent.network(torch.ones(1, 1, 3))
    assert outputs.shape == (1, 1, 2, 51)
    torch.testing.assert_close(outputs, agent.initial().expand_as(outputs), atol=0.5, rtol=0.0)


def test_a_round_equals_updates_one_by_one_with_the_targets_of_its_start():
    """Where the average stays and chooses the next action, targets do not depend on when they are computed."""
    batch = batch_of(12)
    one, other = (peer("qrdqn", double=False, averaging=1e-5) for _ in range(2))
    losses, each = one.learn(batch, 3, 0.5)
    slowly = [other.update(part, 0.5) for part in batch.split(3)]
    np.testing.assert_allclose(losses, [loss for loss, _ in slowly], rtol=1e-4)
    np.testing.assert_allclose(each, np.concatenate([found for _, found in slowly]), rtol=1e-4)
    for mine, theirs in zip(one.network.parameters(), other.network.parameters(), strict=True):
        torch.testing.assert_close(mine, theirs, atol=1e-5, rtol=1e-4)


@pytest.mark.parametrize("algorithm", [*OTHERS, "laplace"])
def test_an_update_follows_the_gradient_of_the_weighted_mean(algorithm, monkeypatch):
    """Five rows and, of Laplace DQN, fifteen discounts: no mean is over a power of two, or over the wrong axis."""
    weights = torch.tensor([0.1, 1.0, 0.4, 0.0, 0.7])
    agent, batch = peer(algorithm), replace(batch_of(5), weights=weights)
    state = agent.random.bit_generator.state
    losses = agent.losses(batch, *agent.prepare(batch))
    expected = (weights.unsqueeze(1) * losses).mean()
    gradients = torch.autograd.grad(expected, list(agent.network.parameters()))
    agent.random.bit_generator.state = state
    found = []
    monkeypatch.setattr(agent.optimiser, "step", lambda *_: found.extend(p.grad for p in agent.network.parameters()))
    loss, each = agent.update(batch, 0.5)
    assert loss == pytest.approx(expected.item(), rel=1e-5)
    np.testing.assert_allclose(each, losses.detach().mean(1), rtol=1e-5)
    for mine, theirs in zip(found, gradients, strict=True):
        torch.testing.assert_close(mine, theirs, rtol=1e-4, atol=1e-6)


@pytest.mark.parametrize("algorithm", OTHERS)
def test_one_batch_is_learned(algorithm):
    """Without targets that move the loss falls to a fraction."""
    agent, batch = peer(algorithm, learning_rate=1e-2, averaging=1e-5, double=False), batch_of(16)

    def loss() -> float:
        return float(np.mean([agent.losses(batch, *agent.prepare(batch)).mean().item() for _ in range(20)]))

    before = loss()
    for _ in range(150):
        agent.update(batch, 0.0)
    assert loss() < 0.4 * before


@pytest.mark.parametrize("algorithm", PEERS)
def test_untrained_peers_expect_nothing(algorithm):
    """C51 up to a thousandth in every atom; its atoms lie at most 3 from 0."""
    agent = AGENTS[algorithm](SETTINGS[algorithm](**FEW[algorithm]), 3, 2)
    assert float(agent.means(agent.initial())) == pytest.approx(0.0, abs=5 * 3e-3)


# Distributions


@pytest.mark.parametrize("algorithm", PEERS)
def test_distributions_are_those_with_the_means_that_decide(algorithm):
    agent, observation = peer(algorithm), np.array([0.3, -1.0, 2.0])
    locations, masses = agent.return_distribution(observation)
    assert locations.shape == masses.shape
    assert len(locations) == 2
    assert locations.dtype == np.float64
    assert np.all(np.diff(locations, axis=1) >= 0)
    assert masses.min() >= 0.0
    np.testing.assert_allclose(masses.sum(axis=1), 1.0, atol=1e-6)
    values = agent.action_values(observation[None], agent.acting_head)[0]
    np.testing.assert_allclose((locations * masses).sum(axis=1), values, rtol=1e-4, atol=1e-5)


def test_targets_equal_a_loop_over_transitions(subtests):
    for n_step in [1, 3]:
        for double in [False, True]:
            for algorithm in PEERS:
                with subtests.test(n_step=n_step, double=double, algorithm=algorithm):
                    agent, batch = peer(algorithm, double=double, dueling=True, gamma=0.8), batch_of(8, n_step=n_step)
                    locations, masses = agent.prepare(batch)
                    for i in range(8):
                        z, p = slow_target(agent, batch, i)
                        np.testing.assert_allclose(locations[i], z, rtol=1e-4, atol=1e-5)
                        np.testing.assert_allclose(masses[i], p, rtol=1e-4, atol=1e-6)


def slow_target(agent: Agent, batch: Batch, i: int) -> tuple[np.ndarray, np.ndarray]:
    """One transition, reward by reward."""
    total, discount = 0.0, 1.0
    for k in range(int(batch.lengths[i, 0])):
        total += discount * float(batch.rewards[i, 0, k])
        discount *= agent.settings.gamma
    following = batch.next_observations[i : i + 1]
    judge = agent.network if agent.settings.double else agent.target
    best = agent.means(judge(following))[0, 0].argmax()
    later, masses = agent.distribution(agent.target(following)[:, 0, best])
    discount = 0.0 if batch.terminated[i, 0] else discount
    return total + discount * later[0].detach().numpy(), masses[0].detach().numpy()


# DQN


def test_half_the_squared_error_worked_by_hand():
    """(5 - 2)^2 / 2 = 4.5, and its gradient is 2 - 5."""
    outputs = row(2.0)
    loss = peer("dqn").loss(outputs, torch.tensor([[5.0]]), torch.ones(1, 1))
    loss.sum().backward()
    assert loss.tolist() == [4.5]
    assert outputs.grad.tolist() == [[-3.0]]


# C51


def test_a_projection_worked_by_hand():
    """Atoms 0, 1, 2. A return of 1/4 gives 3/4 of its mass to 0 and 1/4 to 1; one of -7 all to 0, one of 9 all to 2."""
    found = project(torch.tensor([[0.25, -7.0, 9.0]]), torch.tensor([[0.4, 0.5, 0.1]]), torch.arange(3.0))
    np.testing.assert_allclose(found[0], [0.3 + 0.5, 0.1, 0.1], atol=1e-7)


@given(
    st.lists(st.tuples(st.floats(-3.0, 7.0), st.floats(0.01, 1.0)), min_size=1, max_size=8),
    st.integers(2, 60),
)
def test_projection_conserves_mass_and_mean_and_equals_that_of_the_tables(pairs, count):
    places, masses = np.array(pairs).T
    masses, atoms = masses / masses.sum(), torch.linspace(-3.0, 7.0, count)
    found = project(*(torch.tensor(part[None], dtype=torch.float32) for part in (places, masses)), atoms)[0].numpy()
    assert found.sum() == pytest.approx(1.0, abs=1e-5)
    assert found @ atoms.numpy() == pytest.approx(places @ masses, abs=1e-4)
    assert found.min() >= 0.0
    assert np.count_nonzero(found > 1e-6) <= 2 * len(pairs)
    np.testing.assert_allclose(found, tables.project(places, masses, np.linspace(-3.0, 7.0, count)), atol=1e-4)


def test_a_cross_entropy_worked_by_hand():
    """Three equal logits, target (3/4, 1/4, 0): log 3 less the target's entropy, .562335, is .536277.

    The gradient is softmax less target: 1/3 - 3/4, 1/3 - 1/4, 1/3.
    """
    outputs = row(0.0, 0.0, 0.0)
    agent = peer("c51", atoms=3, v_min=0.0, v_max=2.0)
    loss = agent.loss(outputs, torch.tensor([[0.25]]), torch.ones(1, 1))
    loss.sum().backward()
    assert loss.item() == pytest.approx(0.536277, abs=1e-6)
    np.testing.assert_allclose(outputs.grad[0], [-5 / 12, 1 / 12, 1 / 3], atol=1e-6)


def test_the_cross_entropy_is_zero_where_prediction_is_target():
    agent = peer("c51")
    p = torch.tensor([[0.1, 0.2, 0.3, 0.4, 1e-9]])
    assert agent.loss(p.log(), agent.atoms[None], p).item() == pytest.approx(0.0, abs=1e-5)


# QR-DQN


def test_a_quantile_loss_worked_by_hand():
    """Levels 1/4 and 3/4, quantiles 0 and 1, targets 1/2 and 3; huber(u) is u^2/2 to 1, then u - 1/2.

    At 0: u = 1/2, 3, both above: 1/4 (1/8 + 5/2) / 2 = .328125; gradient -1/4 (1/2 + 1) / 2 = -.1875.
    At 1: u = -1/2 costs 1/4 * 1/8, u = 2 costs 3/4 * 3/2: their mean is .578125; gradient (1/4 * 1/2 - 3/4) / 2.
    """
    quantiles = row(0.0, 1.0)
    loss = qrdqn.quantile_huber(quantiles, torch.tensor([[0.5, 3.0]]), torch.tensor([0.25, 0.75]))
    loss.sum().backward()
    assert loss.item() == pytest.approx(0.328125 + 0.578125)
    np.testing.assert_allclose(quantiles.grad[0], [-0.1875, -0.3125])


def test_levels_are_the_midpoints():
    np.testing.assert_allclose(peer("qrdqn").levels, [0.125, 0.375, 0.625, 0.875])


@pytest.mark.parametrize("algorithm", ["qrdqn", "expectile"])
def test_a_high_level_fears_to_be_too_low(algorithm):
    """2 below the target costs a high level more than 2 above it, and pulls harder; a low level the other way round."""
    agent = peer(algorithm)
    costs, pulls = [], []
    for output in (-2.0, 2.0):
        outputs = torch.full((1, agent.levels.numel()), output, requires_grad=True)
        loss = [
            agent.loss(torch.where(torch.arange(agent.levels.numel()) == i, outputs, 0.0), torch.zeros(1, 1), ONE)
            for i in (0, -1 % agent.levels.numel())
        ]
        sum(loss).backward()
        costs.append([one.item() for one in loss])
        pulls.append(outputs.grad[0, [0, -1]].tolist())
    (low_below, high_below), (low_above, high_above) = costs
    assert high_below > 2 * high_above
    assert low_above > 2 * low_below
    assert pulls[0][1] < 0 < pulls[1][1]
    assert -pulls[0][1] > 2 * pulls[1][1]
    # At level t: t * cost of being below, 1 - t above.
    t = float(agent.levels[-1])
    assert high_below / high_above == pytest.approx(t / (1.0 - t), rel=1e-5)


ONE = torch.ones(1, 1)


@given(
    st.integers(1, 7).flatmap(
        lambda n: st.lists(st.lists(st.floats(-4.0, 4.0, width=16), min_size=n, max_size=n), min_size=2, max_size=2)
    ),
    st.lists(st.floats(-4.0, 4.0, width=16), min_size=1, max_size=6),
)
def test_the_quantile_loss_and_its_gradient_equal_a_double_loop(quantiles, locations):
    """Both ways to sum; also where quantiles cross, coincide, or lie exactly 0 or 1 from a target."""
    y = sorted(locations)
    for most in (0, 10**6):
        q = torch.tensor(quantiles, requires_grad=True)
        levels = (torch.arange(q.shape[1]) + 0.5) / q.shape[1]
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(qrdqn, "MOST_PAIRS", most)
            loss = qrdqn.quantile_huber(q, torch.tensor([y, y]), levels)
        loss.sum().backward()
        check_quantiles(quantiles, y, levels, loss, gradient=q.grad)


def check_quantiles(quantiles, y, levels, loss, *, gradient):
    for b, one in enumerate(quantiles):
        cost, pull = 0.0, np.zeros(len(one))
        for i, qi in enumerate(one):
            for yj in y:
                u = yj - qi
                weight = abs(float(levels[i]) - (u < 0))
                cost += weight * (0.5 * u * u if abs(u) <= 1 else abs(u) - 0.5) / len(y)
                pull[i] -= weight * np.clip(u, -1.0, 1.0) / len(y)
        assert loss[b].item() == pytest.approx(cost, rel=1e-5, abs=1e-6)
        np.testing.assert_allclose(gradient[b], pull, rtol=1e-5, atol=1e-6)


# Settings


def test_settings_that_do_not_fit_are_refused(subtests):
    for algorithm, values, named in [
        ("c51", {"v_min": 1.0, "v_max": 1.0}, "v_min"),
        ("c51", {"v_min": 0.0, "v_max": 1e-40}, "apart"),
        ("c51", {"v_min": 999_999.0, "v_max": 1e6, "atoms": 1000}, "apart"),
        ("c51", {"atoms": 1}, "atoms"),
        ("qrdqn", {"quantiles": 0}, "quantiles"),
        ("expectile", {"expectiles": 4}, "odd"),
        ("expectile", {"expectiles": 1}, "expectiles"),
        ("dqn", {"gamma": 1.0}, "gamma"),
        ("dqn", {"atoms": 5}, "atoms"),
        ("fixed_horizon", {"horizon": 0}, "horizon"),
    ]:
        with subtests.test(algorithm, values=values), pytest.raises(InputError, match=named):
            SETTINGS[algorithm].parse(values)


@pytest.mark.parametrize("algorithm", OTHERS)
def test_settings_and_agents_have_the_same_name(algorithm):
    kind = SETTINGS[algorithm]
    assert algorithm == kind.ALGORITHM
    assert AGENTS[algorithm].settings_class is kind


@pytest.mark.parametrize("algorithm", PEERS)
def test_an_output_of_one_stands_for_a_reward_of_one_at_every_step(algorithm):
    """Returns are 1 + gamma + gamma^2 + ... = 100 times a reward a step at .99; C51's outputs are no returns."""
    agent, batch = peer(algorithm, gamma=0.99), batch_of(9)
    before = agent.network(batch.observations)
    agent.network.head.bias.data += 1.0
    wanted = before + (1.0 if algorithm == "c51" else 100.0)
    torch.testing.assert_close(agent.network(batch.observations), wanted, rtol=1e-5, atol=1e-3)
    outputs = agent.network(batch.observations)[torch.arange(9), 0, batch.actions[:, 0]]
    prepared = agent.prepare(batch)
    wanted = agent.loss(outputs, *prepared) / (1.0 if algorithm == "c51" else 100.0)
    torch.testing.assert_close(agent.losses(batch, *prepared)[:, 0], wanted)
