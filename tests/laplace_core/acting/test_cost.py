"""What a step costs, by a clock that only the agent moves on."""

from __future__ import annotations

import numpy as np
import pytest

from laplace_core.acting.cost import REPEATS, StepCost, step_cost
from laplace_core.errors import InputError


class Slow:
    """An agent of CartPole that takes 2 ms for each call and 3 ms for each observation; longer at its first calls."""

    n_observations, n_actions, acting_head = 4, 2, 0

    def __init__(self, unit: float = 1e-3, first: float = 0.0):
        self.now, self._unit, self._first = 0.0, unit, first

    def action_values(self, observations, head=None):
        self.now += (2.0 + 3.0 * len(observations)) * self._unit + self._first
        self._first = 0.0
        return np.zeros((len(observations), 2))


@pytest.mark.parametrize(("unit", "first"), [(1e-3, 0.0), (1e-3, 20.0), (10.0, 0.0)])
def test_a_step_costs_what_the_rule_takes_for_a_call_and_for_each_observation(unit, first):
    """One observation takes 5, three take 11: 3 each and 2 for the call. A slow first call does not count.

    On a busy machine the first call alone took longer than a measurement may, and was all that was measured.
    """
    agent = Slow(unit, first)
    found = step_cost(agent, "CartPole-v1", clock=lambda: agent.now)
    assert (found.choice, found.each) == (pytest.approx(2 * unit), pytest.approx(3 * unit))
    assert (found.step, found.picture) == (0.0, 0.0)
    assert found.of(10) == pytest.approx(32 * unit)


def test_environments_and_pictures_count_for_each_of_those_side_by_side():
    assert StepCost(1.0, 2.0, 3.0, 4.0).of() == 10.0
    assert StepCost(1.0, 2.0, 3.0, 4.0).of(5) == 46.0


def test_measuring_takes_few_calls_and_random_actions_none():
    agent, calls = Slow(), []
    agent.action_values = lambda observations, head=None: calls.append(1) or np.zeros((len(observations), 2))
    step_cost(agent, "CartPole-v1", clock=lambda: 0.0)
    assert len(calls) == 2 * (REPEATS + 1) + 1
    found = step_cost(agent, "two_branch", "random", clock=iter(range(100)).__next__)
    assert (found.choice, found.each, found.step) == (0.0, 0.0, 1.0)  # two readings of this clock are 1 apart
    assert len(calls) == 2 * (REPEATS + 1) + 1


def test_a_rule_that_does_not_suit_is_refused():
    with pytest.raises(InputError, match="own"):
        step_cost(Slow(), "CartPole-v1", "own")
