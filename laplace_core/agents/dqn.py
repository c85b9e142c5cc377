"""DQN: the mean return alone (Mnih et al. 2015), by default with the targets of double Q-learning (van Hasselt 2016).

The error is squared and not cut at 1, as Mnih et al. do: a cut error moves a value to a median of its targets, which on
returns of +-2 may be anything from -1 to 1. Gradients are cut to a norm instead, as in all agents here.
"""

from __future__ import annotations

from typing import ClassVar

import torch
from torch import Tensor

from laplace_core.agents.peer import Peer
from laplace_core.agents.settings import DqnSettings


class DqnAgent(Peer[DqnSettings]):
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
        """Half the squared error: the gradient is the error."""
        return 0.5 * (masses * (locations - outputs) ** 2).sum(-1)
