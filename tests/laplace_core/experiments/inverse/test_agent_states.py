"""Decoded timelines of agents' states against simulations: which states, and what the scores are."""

from __future__ import annotations

import numpy as np
import pytest

from laplace_core import InputError
from laplace_core.acting.continuations import continue_from
from laplace_core.acting.simulated_truth import empirical
from laplace_core.experiments.inverse import agent_states
from laplace_core.experiments.inverse.agent_states import (
    AGENTS,
    SOLVERS,
    TODAY,
    drawn_states,
    report,
    scores,
    shortfalls,
)
from laplace_core.training.checkpoint import load_checkpoint


@pytest.fixture(scope="module")
def cart():
    return load_checkpoint(agent_states.CHECKPOINTS / "laplace_CartPole-v1.safetensors")


def test_states_are_spread_over_the_episodes(cart):
    states = drawn_states(cart.agent, cart.environment, 7, 3)
    rollouts = {rollout.seed: rollout for rollout, _ in states}
    assert sorted(rollouts) == [agent_states.SEEDS + 15 + i for i in range(5)]
    assert [sum(rollout.seed == seed for rollout, _ in states) for seed in sorted(rollouts)] == [2, 2, 1, 1, 1]
    assert all(0 <= step < len(rollout) for rollout, step in states)


def test_the_simulated_timeline_itself_scores_nothing(cart):
    """CartPole pays 1 in every step: masses that hold what the continuations did have no distance and no error.

    The reward of 1 lies at a threshold, which half of it passes: the two bins beside it hold one half each.
    """
    (rollout, step) = drawn_states(cart.agent, cart.environment, 1, 0)[0]
    simulated = empirical(cart.agent, continue_from(cart.agent, rollout, step, count=5, steps=20))
    masses = -np.diff(simulated.open_tails, axis=-1)
    distance, value = scores(masses, simulated, cart.agent)
    assert distance == pytest.approx(0.0, abs=1e-12)
    assert value == pytest.approx(0.0, abs=1e-4)  # the activation is of single precision
    early = np.roll(masses, 5, axis=-1)
    assert scores(early, simulated, cart.agent)[0] > 0.5


def test_the_report_names_every_solver_and_who_falls_short(monkeypatch):
    monkeypatch.setattr(agent_states, "AGENTS", AGENTS[:1])
    monkeypatch.setattr(agent_states, "CONTINUATIONS", 10)
    numbers, text = report(2, 1)
    assert [row["column"] for row in numbers["rows"]] == [*SOLVERS, "chance"]
    assert all(name in text for name in SOLVERS)
    assert shortfalls(numbers) == []
    for row in numbers["rows"]:
        row["w1"] = 1.0 if row["column"] == TODAY else 2.0
    assert shortfalls(numbers) == ["laplace_CartPole-v1"]


def test_a_number_of_cases_out_of_range_is_refused():
    for cases in (1, 1001):
        with pytest.raises(InputError, match=f"cases is {cases}; it must be from 2 to 1,000."):
            report(cases, 0)
