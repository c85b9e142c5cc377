"""What an agent can do, asked for by type: a toy for each capability, and every agent that there is."""

from __future__ import annotations

import numpy as np
import pytest
import torch

from laplace_core.agents import SETTINGS
from laplace_core.agents.capabilities import (
    HasAtoms,
    HasDiscounts,
    HasGammaSpace,
    HasReturnDistribution,
    HasTimeToGo,
)
from laplace_core.agents.registry import AGENTS
from laplace_core.agents.sensitivities import Sensitivities
from laplace_core.agents.settings import LaplaceSettings
from laplace_core.code.gamma_space import GammaSpace

ALL = (HasDiscounts, HasGammaSpace, HasReturnDistribution, HasTimeToGo, HasAtoms)


class Plain:
    """It acts, and says no more."""

    acting_head = 0


class ManyDiscounts(Plain):
    gammas = np.array([0.5, 0.9])


class Thresholds(ManyDiscounts):
    thetas = np.array([0.0, 1.0])
    sensitivities = Sensitivities(LaplaceSettings(thetas=5))

    def gamma_spaces(self, observations: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        shape = (len(observations), 1, len(self.gammas))
        return np.zeros((*shape, len(self.thetas))), np.zeros(shape)

    def gamma_space(self, observation: np.ndarray) -> GammaSpace:
        (values,), (constant,) = self.gamma_spaces(observation[None])
        return GammaSpace(values, constant, self.gammas, self.thetas)


class Distribution(Plain):
    def return_distributions(self, observations: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return np.zeros((len(observations), 1, 1)), np.ones((len(observations), 1, 1))

    def return_distribution(self, observation: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        (locations,), (masses,) = self.return_distributions(observation[None])
        return locations, masses


class ToGo(Plain):
    def __init__(self) -> None:
        self.horizon = 4


class Atoms(Distribution):
    atoms = torch.tensor([0.0, 1.0])
    acting_discount = 0.9


@pytest.mark.parametrize(
    ("toy", "can"),
    [
        (Plain, ()),
        (ManyDiscounts, (HasDiscounts,)),
        (Thresholds, (HasDiscounts, HasGammaSpace)),
        (Distribution, (HasReturnDistribution,)),
        (ToGo, (HasTimeToGo,)),
        (Atoms, (HasReturnDistribution, HasAtoms)),
    ],
)
def test_a_toy_has_what_it_was_given_and_nothing_else(toy, can):
    assert tuple(each for each in ALL if isinstance(toy(), each)) == can


AGENTS_CAN = {
    "laplace": (HasDiscounts, HasGammaSpace),
    "c51": (HasReturnDistribution, HasAtoms),
    "qrdqn": (HasReturnDistribution,),
    "expectile": (HasReturnDistribution,),
    "dqn": (HasReturnDistribution,),
    "fixed_horizon": (HasTimeToGo,),
}


def test_every_algorithm_is_listed():
    assert set(AGENTS_CAN) == set(AGENTS)


@pytest.mark.parametrize("algorithm", AGENTS)
def test_every_agent_can_do_what_its_algorithm_promises(algorithm):
    agent = AGENTS[algorithm](SETTINGS[algorithm](hidden=4), 2, 3)
    assert tuple(each for each in ALL if isinstance(agent, each)) == AGENTS_CAN[algorithm]


@pytest.mark.parametrize("algorithm", SETTINGS)
def test_every_loop_knows_whose_experience_it_is_and_which_heads_explore(algorithm):
    """Settings answer for the loop, whether or not their algorithm lets a person choose."""
    settings = SETTINGS[algorithm]()
    assert not settings.own_experience
    chosen = {parameter.name for parameter in settings.SCHEMA}
    assert settings.head_exploration == (0.2 if "head_exploration" in chosen else 0.0)
    assert ("head_exploration" in settings.as_dict()) == ("head_exploration" in chosen)


def test_discounts_with_experience_of_their_own_say_so():
    settings = LaplaceSettings(experience="per_discount", gammas=3)
    assert settings.own_experience
    assert settings.rings == 3
