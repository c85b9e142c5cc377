"""Artefacts at every step of a rollout: the same as one by one, and where they begin."""

from __future__ import annotations

import numpy as np
import pytest
import torch

from laplace_core import Settings, study_of_gamma_space
from laplace_core.acting.flags import Flags, flag_steps
from laplace_core.acting.rollout import roll_out
from laplace_core.agents import LaplaceSettings
from laplace_core.code.interpolation import with_added
from laplace_core.study.artefacts import find_artefacts
from laplace_core.study.settings import resolve_for_gamma_space
from laplace_core.training.checkpoint import new_agent

torch.set_num_threads(1)


@pytest.fixture(scope="module")
def agent():
    """A network that knows nothing, with a large error in every value."""
    settings = LaplaceSettings(hidden=8, features=4, gammas=6, thetas=9, theta_min=-3.0, theta_max=12.0, seed=3)
    agent = new_agent(settings)
    with torch.no_grad():
        for parameter in agent.target.parameters():
            parameter.add_(torch.randn_like(parameter), alpha=0.5)
    return agent


@pytest.fixture(scope="module")
def rollout(agent):
    return roll_out(agent, "CartPole-v1", 7)


@pytest.mark.parametrize(
    "values",
    [
        {"alpha": 1e-3},
        {"alpha": 0.1, "normalise": "survival"},
        {"normalise": "paper"},
        {"alpha": 1e-3, "slope_share": 0.5},
    ],
)
@pytest.mark.parametrize("added", [0, 2])
def test_every_step_is_as_if_it_were_looked_at_alone(rollout, values, added):
    settings = resolve_for_gamma_space(Settings(world="CartPole-v1", steps=50, **values), rollout.gammas)
    told = []
    flags = flag_steps(rollout, settings, added, lambda done, of: told.append((done, of)))
    assert told[-1] == (len(rollout), len(rollout))
    assert flags.marks.any()
    for step in range(len(rollout)):
        found = find_artefacts(
            study_of_gamma_space(with_added(rollout.space(step), added), settings), int(rollout.actions[step])
        )
        there = [name for name, mark in zip(flags.names, flags.marks[step], strict=True) if mark]
        assert there == [artefact.name for artefact in found]


def test_a_space_of_a_rollout_is_what_the_agent_says_itself(agent, rollout):
    """Its sensitivities too: without their places no gentler slope can be looked at."""
    own, kept = agent.gamma_space(rollout.observations[2]), rollout.space(2)
    np.testing.assert_allclose(kept.values, own.values, rtol=1e-6, atol=1e-7)  # single floats
    np.testing.assert_array_equal(kept.places, agent.sensitivities.places)


def test_an_artefact_begins_where_the_step_before_has_it_not():
    marks = np.array([[1, 0], [1, 1], [0, 1], [0, 1], [1, 0], [0, 0]], dtype=bool)
    assert Flags(("a", "b"), marks).begins.tolist() == [True, True, False, False, True, False]
