"""What the peers share: one discount, one network, and a distribution of the return that is moved to its target.

The next state gives a distribution of r + gamma Z(s', a*), as locations and masses, and the loss moves the outputs of
(s, a) towards it. An algorithm is four short answers: what its outputs are before training, their mean, the
distribution that they stand for, and the loss. :mod:`laplace_core.learning.peers` has the same four on tables.
"""

from __future__ import annotations

from abc import abstractmethod
from typing import ClassVar

import numpy as np
import torch
from torch import Tensor, nn

from laplace_core.agents.agent import Agent, Batch, batched
from laplace_core.agents.networks import Single
from laplace_core.agents.settings import DqnSettings


class Peer(Agent):
    """An agent that learns the return at one discount; C is the number of outputs of an action."""

    settings_class: ClassVar[type[DqnSettings]]

    def _build(self) -> nn.Module:
        return Single(self.n_observations, self.n_actions, self.initial(), self.settings)

    @classmethod
    def network_numbers(cls, settings: DqnSettings, observation: int, actions: int) -> int:
        return Single.count_numbers(observation, actions, cls.channels(settings), settings)

    @classmethod
    @abstractmethod
    def channels(cls, settings: DqnSettings) -> int:
        """C."""

    @abstractmethod
    def initial(self) -> Tensor:
        """Outputs that mean 'return 0', ``(C,)``."""

    @abstractmethod
    def means(self, outputs: Tensor) -> Tensor:
        """Mean return, ``(..., C)`` to ``(...)``, in units of reward."""

    @abstractmethod
    def distribution(self, outputs: Tensor) -> tuple[Tensor, Tensor]:
        """Locations in units of reward, increasing, and masses, ``(B, M)`` each, for outputs ``(B, C)``."""

    @abstractmethod
    def loss(self, outputs: Tensor, locations: Tensor, masses: Tensor) -> Tensor:
        """Distance of outputs ``(B, C)`` from a distribution, ``(B, M)`` twice: ``(B,)``."""

    @torch.no_grad()
    def targets(self, batch: Batch) -> tuple[Tensor, Tensor]:
        """Distribution of r_0 + ... + gamma^(m-1) r_(m-1) + gamma^m Z(s_m, a*), ``(B, M)`` twice."""
        judge, gamma = self.network if self.settings.double else self.target, self.settings.gamma
        actions = self.means(judge(batch.next_observations)).argmax(-1)
        later, masses = self.distribution(self.target(batch.next_observations, actions=actions)[:, 0])
        step = torch.arange(batch.rewards.shape[-1])
        counts = (step < batch.lengths.unsqueeze(-1)) * gamma**step
        discounts = torch.where(batch.terminated, 0.0, gamma**batch.lengths)
        return (batch.rewards * counts).sum(-1) + discounts * later, masses

    def losses(self, batch: Batch) -> Tensor:
        locations, masses = self.targets(batch)
        outputs = self.network(batch.observations, actions=batch.actions)[:, 0]
        return self.loss(outputs, locations, masses).unsqueeze(1)

    def _action_values(self, network: nn.Module, observations: Tensor, head: int | None) -> Tensor:
        return self.means(network(observations))

    @torch.no_grad()
    def return_distribution(self, observation: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The learned distribution of the return of every action, for one observation ``(O,)``.

        Returns:
            locations in units of reward, increasing, and their masses, ``(A, M)`` each, float64.
        """
        outputs = self.target(batched(np.asarray(observation)[None]))[0, 0]
        return tuple(part.double().numpy() for part in self.distribution(outputs))
