"""DQN: the mean return alone, by Huber's loss (Mnih et al. 2015), with the targets of double Q-learning by default."""

from __future__ import annotations

from typing import ClassVar

import torch
from torch import Tensor
from torch.nn.functional import smooth_l1_loss

from laplace_core.agents.peer import Peer
from laplace_core.agents.settings import DqnSettings


class DqnAgent(Peer):
    """DQN."""

    settings_class: ClassVar[type[DqnSettings]] = DqnSettings

    @classmethod
    def channels(cls, settings: DqnSettings) -> int:
        return 1

    def initial(self) -> Tensor:
        return torch.zeros(1)

    def means(self, outputs: Tensor) -> Tensor:
        return outputs[..., 0]

    def distribution(self, outputs: Tensor) -> tuple[Tensor, Tensor]:
        """All mass at the mean."""
        return outputs, torch.ones_like(outputs)

    def loss(self, outputs: Tensor, locations: Tensor, masses: Tensor) -> Tensor:
        """Huber's loss, delta 1 in units of reward: the gradient is the error, cut to +-1."""
        return smooth_l1_loss(outputs, locations, reduction="none").sum(-1)
