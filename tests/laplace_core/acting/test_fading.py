"""The rule of the fading deadline, and the report that holds it against others."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from laplace_core.acting.rules import FADING_ALPHA, RULES, Options
from laplace_core.experiments.horizon import interval
from laplace_core.study.horizon import discount_kernel, readout_weights

GAMMAS = np.exp(-1.0 / np.geomspace(1.0, 99.5, 15))


class Agent:
    """Two actions: the first pays now, the second pays 1.5 at step 10. Q_gamma = 1 and 1.5 gamma^10, exactly."""

    gammas, acting_head = GAMMAS, 14

    def action_values(self, observations, head=None):
        values = np.stack([np.ones(15), 1.5 * GAMMAS**10], axis=-1)[None].repeat(len(observations), axis=0)
        return values if head is None else values[:, head]

    def greedy(self, observations):
        return self.action_values(observations, self.acting_head).argmax(-1)


def test_it_waits_while_there_is_time_and_takes_what_is_there_when_there_is_not():
    # With T to go the later reward counts 1.5 exp(-10 / (1.5 T)), above 1 while T > 10 / (1.5 log 1.5) = 16.4.
    choose = RULES["fading"](Agent(), 60, Options())
    chosen = np.array([choose(np.zeros((1, 1)), 60 - left)[0] for left in range(1, 61)])
    assert chosen[:16].tolist() == [0] * 16
    assert chosen[16:].tolist() == [1] * 44


def test_far_from_the_deadline_it_is_greedy_to_the_last_digit():
    # An agent whose action g has value 1 at discount g only: what is chosen is the largest weight.
    agent, weights = Agent(), []
    agent.action_values = lambda observations, head=None: np.eye(15)[None].repeat(len(observations), axis=0)
    choose = RULES["fading"](agent, 100, Options())
    for left in (67, 75, 100):  # 1.5 x 67 steps exceed the time constant of the acting discount, 99.5
        weights.append(choose(np.zeros((1, 1)), 100 - left)[0])
    assert weights == [14, 14, 14]


@pytest.mark.parametrize("constant", [2.0, 7.3, 30.0, 80.0])
def test_an_exponential_between_the_discounts_costs_no_noise(constant):
    tau = np.arange(1000)
    wanted = np.exp(-tau / constant)
    weights = readout_weights(GAMMAS, wanted, FADING_ALPHA)
    assert np.linalg.norm(weights) < 1.05
    assert np.abs(discount_kernel(GAMMAS, weights, 1000) - wanted).sum() < 0.02 * wanted.sum()
    # A hard deadline at the same place cannot be had at that price.
    hard = (tau < constant) * GAMMAS[14] ** tau
    dear = readout_weights(GAMMAS, hard, FADING_ALPHA)
    assert np.linalg.norm(dear) > 3.0
    assert np.abs(discount_kernel(GAMMAS, dear, 1000) - hard).sum() > 0.1 * hard.sum()


def test_agents_are_the_outer_unit_of_the_interval():
    # Two agents, one 10 better and one 10 worse in all of 100 episodes: nothing is known of the next agent. A quarter
    # of the draws each take one agent twice: 10 off the mean, stretched by 12.706 / 1.960 and by the root of 2.
    low, high = interval(np.array([[10.0] * 100, [-10.0] * 100]), draws=2000)
    assert (low, high) == pytest.approx((-91.68, 91.68), abs=0.02)
    # The same numbers spread over the episodes of both: much is known. The mean of 100 has a standard error of 1.
    mixed = np.tile([10.0, -10.0], (2, 50))
    assert interval(mixed) == pytest.approx((-1.96, 1.96), abs=0.06)
    # Ten agents that do the same are no more than one.
    np.testing.assert_allclose(interval(np.repeat(mixed[:1], 10, axis=0)), interval(mixed[:1]))


@pytest.mark.parametrize(("agents", "starts", "rest"), [(1, 0, 3), (0.3, 5, 3), (0, 0, 5), (1, 5, 1)])
def test_the_interval_covers_the_truth_as_often_as_it_says(agents, starts, rest):
    """Five agents x 100 starts, normal, 0 on average, 400 times: 95% have a standard error of 1.1%. It may be wider
    than it must, as what is neither the agents' nor the starts' is in both draws."""
    rng, inside = np.random.default_rng(0), 0
    for seed in range(400):
        table = rng.normal(size=(5, 1)) * agents + rng.normal(size=100) * starts + rng.normal(size=(5, 100)) * rest
        low, high = interval(table, draws=1000, seed=seed)
        inside += low <= 0 <= high
    assert inside / 400 > 0.925


def test_agents_without_discounts_are_refused():
    with pytest.raises(Exception, match="many discounts"):
        RULES["fading"](SimpleNamespace(), 10, Options())
