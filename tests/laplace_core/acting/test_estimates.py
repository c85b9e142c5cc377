"""Seconds that acting takes: every part of a step counts as often as it is done."""

from __future__ import annotations

import pytest

from laplace_core.acting import estimates
from laplace_core.acting.cost import StepCost
from laplace_core.acting.race import Entrant
from laplace_core.acting.rollout import roll_out
from laplace_core.agents import LaplaceSettings
from laplace_core.training.checkpoint import new_agent


@pytest.fixture
def agent(monkeypatch):
    """One whose choice costs 1 s, and each observation 2 s, in an environment whose step costs 10 s."""
    monkeypatch.setattr(estimates, "cost_of", lambda *given, pictures=False: StepCost(1.0, 2.0, 10.0))
    return new_agent(LaplaceSettings(environment="two_branch", hidden=8, features=4, theta_max=12.0))


def test_a_race_counts_both_sides_and_groups_of_a_hundred(agent):
    """T = 3. One race: 2 x 3 steps of 1 + 2 + 10. Of 250 starts: groups of 100, 100 and 50; 2 x 3 x (3 + 250 x 12)."""
    sides = Entrant(agent), Entrant(agent)
    assert estimates.of_races("two_branch", sides, 3) == 2 * 3 * 13
    assert estimates.of_races("two_branch", sides, 3, 250) == 2 * 3 * (3 + 250 * 12)


def test_a_rollout_counts_its_full_length(agent):
    assert estimates.of_rollout(agent, "two_branch", "greedy", 7, pictures=False) == 7 * 13


def test_continuations_are_stepped_to_their_state_and_then_acted_side_by_side(agent):
    """10 of them from step 1: 10 environment steps; then 5 steps of 1 + 10 x 12."""
    rollout = roll_out(agent, "two_branch", 0)
    assert estimates.of_continuations(agent, rollout, 1, 10, steps=5, own=False) == 10 * 10 + 5 * (1 + 10 * 12)
    assert estimates.of_outcomes(agent, rollout, 3, steps=5, own=True) == 3 * 2 * 5 * 13
