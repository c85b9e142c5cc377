"""The base of the peers: one discount, one network, and a distribution of the return that moves to its target.

The next state gives a distribution of r + gamma Z(s', a*), as locations and masses, and the loss moves the outputs of
(s, a) towards it. An algorithm is four short answers: what its outputs are before training, their mean, the
distribution that they stand for, and the loss. :mod:`laplace_core.tabular.peers` has the same four on tables.
"""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, ClassVar, TypeVar

import numpy as np
import torch
from torch import Tensor, nn

from laplace_core.agents.agent import Agent, Batch, batched
from laplace_core.agents.networks import Single
from laplace_core.agents.settings import DqnSettings


def discounted(batch: Batch, gamma: float, lengths: Tensor | None = None) -> tuple[Tensor, Tensor]:
    """r_0 + ... + gamma^(m-1) r_(m-1), and gamma^m or, after a termination, 0: ``(B, g)`` each.

    Args:
        lengths: ``(B, g)``, in place of the m of the batch where fewer rewards count.
    """
    step = torch.arange(batch.rewards.shape[-1])
    counts = (step < (batch.lengths if lengths is None else lengths).unsqueeze(-1)) * gamma**step
    return (batch.rewards * counts).sum(-1), gamma**batch.lengths * ~batch.terminated


Chosen = TypeVar("Chosen", bound=DqnSettings)


class Peer(Agent[Chosen]):
    """An agent that learns the return at one discount; C is the number of outputs of an action.

    Attributes:
        in_returns: whether the outputs are in units of reward; those of C51 are logarithms of probabilities.
    """

    settings_class: ClassVar[type[Any]]
    in_returns: ClassVar[bool] = True

    def __init__(self, settings: Chosen, *sizes: Any) -> None:
        self.acting_discount = settings.gamma
        super().__init__(settings, *sizes)

    @property
    def scale(self) -> float:
        """The factor of the outputs of the last layer.

        Outputs in units of reward are so many times a reward a step, 1 / (1 - gamma), which is of order one: a network
        that begins at 0 would take long to reach returns of hundreds by steps of the size of the learning rate.
        """
        return 1.0 / (1.0 - self.settings.gamma) if self.in_returns else 1.0

    def _build(self) -> nn.Module:
        return Single(self.n_observations, self.n_actions, self.initial(), self.settings, self.scale)

    @classmethod
    def network_numbers(cls, settings: Chosen, observation: int, actions: int) -> int:
        return Single.count_numbers(observation, actions, cls.channels(settings), settings)

    @classmethod
    @abstractmethod
    def channels(cls, settings: Chosen) -> int:
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
    def prepare(self, batch: Batch) -> tuple[Tensor, Tensor]:
        """The target: distribution of r_0 + ... + gamma^(m-1) r_(m-1) + gamma^m Z(s_m, a*), ``(B, M)`` twice."""
        row = torch.arange(len(batch.observations))
        following = self.target(batch.next_observations)[:, 0]  # (B, A, C)
        judged = self.network(batch.next_observations)[:, 0] if self.settings.double else following
        later, masses = self.distribution(following[row, self.means(judged).argmax(-1)])
        rewards, discounts = discounted(batch, self.settings.gamma)
        return rewards + discounts * later, masses

    # It takes what its own prepare() returns.
    def losses(self, batch: Batch, locations: Tensor, masses: Tensor) -> Tensor:  # type: ignore[override]
        outputs = self.network(batch.observations)[:, 0]  # (B, A, C)
        outputs = outputs.gather(1, batch.actions.unsqueeze(2).expand(-1, -1, outputs.shape[2]))[:, 0]
        # Over the scale: half way between that of the returns and that of the last layer.
        return self.loss(outputs, locations, masses).unsqueeze(1) / self.scale

    def _action_values(self, network: nn.Module, observations: Tensor, head: int | None) -> Tensor:
        return self.means(network(observations))

    @torch.no_grad()
    def return_distributions(self, observations: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The learned distribution of the return of every action, for observations ``(B, O)``.

        Returns:
            locations in units of reward, increasing, and their masses, ``(B, A, M)`` each, float64.
        """
        outputs = self.target(batched(np.asarray(observations)))[:, 0]  # (B, A, C)
        parts = self.distribution(outputs.flatten(0, 1))
        locations, masses = (part.double().numpy().reshape(*outputs.shape[:2], -1) for part in parts)
        return locations, masses

    def return_distribution(self, observation: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The same for one observation ``(O,)``: ``(A, M)`` each."""
        locations, masses = self.return_distributions(np.asarray(observation)[None])
        return locations[0], masses[0]
