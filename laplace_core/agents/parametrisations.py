"""The meaning of the outputs of a Laplace network, and the loss that moves them to a target.

All four work on values scaled by (1 - gamma), so that one target serves them all,

    y = (1 - gamma) sum_k gamma^k encode(r_k) + gamma^m [(1 - terminated) y(s_m, a*) + terminated * ended],

and Q = y / (1 - gamma) is the paper's Eq. 14. (1 - gamma) Q[g, h] is the chance that a reward at a geometrically
distributed future step exceeds theta_h, the episode still running. So bin masses, with termination as one more atom,
are a probability distribution: :class:`Softmax`. The other three predict the tails Q[g, h] and the constant channel
themselves: as sums of non-negative increments (monotone in theta; paper, section 3), by clipped differences
(appendix B.2), or freely.
"""

from __future__ import annotations

import torch
from torch import Tensor
from torch.nn.functional import log_softmax, pad, smooth_l1_loss, softplus

from laplace_core.agents.sensitivities import Sensitivities

FLOOR = 1e-6
"""Least mass of a bin before training: 1e-4 in a bin of +-100 would be a value error of 1 at gamma .99."""
LEAST_INCREMENT = 1e-3
"""The same for an increment of the tails: softplus hardly learns where it is hardly positive."""


class Softmax:
    """Probabilities of the H+1 reward bins and of the episode being over; trained by cross-entropy."""

    def __init__(self, sensitivities: Sensitivities):
        self._encode = sensitivities.masses
        self.channels = sensitivities.thetas.size + 2
        self.value_weights = torch.tensor([*sensitivities.bin_values, 0.0], dtype=torch.float32)
        self.ended = torch.zeros(self.channels)
        self.ended[-1] = 1.0

    def encode(self, rewards: Tensor) -> Tensor:
        """``rewards.shape + (C,)``: bin masses, and nothing on the death atom."""
        return pad(self._encode(rewards), (0, 1))

    def initial(self) -> Tensor:
        """Outputs that mean 'reward 0 for ever', ``(C,)``."""
        return self.encode(torch.zeros(())).clamp(min=FLOOR).log()

    def scaled(self, outputs: Tensor) -> Tensor:
        """Outputs ``(..., C)`` as probabilities."""
        return torch.softmax(outputs, dim=-1)

    def tails(self, scaled: Tensor) -> Tensor:
        """Constant channel and tails, times (1 - gamma), ``(..., H+1)``."""
        return scaled[..., :-1].flip(-1).cumsum(-1).flip(-1)

    def loss(self, outputs: Tensor, target: Tensor, gammas: Tensor) -> tuple[Tensor, Tensor]:
        """Cross-entropy above the target's own entropy, ``(..., G)``, and the scaled predictions."""
        logs = log_softmax(outputs, dim=-1)
        # The entropy of the target has no gradient; without it the loss is 0 where prediction and target agree.
        own = target.clamp(min=torch.finfo(target.dtype).tiny).log()  # many times as fast as torch.special.entr
        return (target * (own - logs)).sum(-1), logs.exp()


class Free:
    """The constant channel and the tails themselves, not bound to fall with theta; trained by Huber's loss."""

    def __init__(self, sensitivities: Sensitivities):
        self._encode = sensitivities.tails
        self.channels = sensitivities.thetas.size + 1
        # Summing bin values over differences of tails is a weighted sum of the tails.
        values = torch.tensor(sensitivities.bin_values, dtype=torch.float32)
        self.value_weights = torch.cat([values[:1], values.diff()])
        self.ended = torch.zeros(self.channels)

    def encode(self, rewards: Tensor) -> Tensor:
        """``rewards.shape + (C,)``: 1 and f_1, ..., f_H."""
        return self._encode(rewards)

    def initial(self) -> Tensor:
        return self.encode(torch.zeros(()))

    def scaled(self, outputs: Tensor) -> Tensor:
        return outputs

    def tails(self, scaled: Tensor) -> Tensor:
        return scaled

    def loss(self, outputs: Tensor, target: Tensor, gammas: Tensor) -> tuple[Tensor, Tensor]:
        """Huber's loss (delta 1) on Q itself, the mean over channels, ``(..., G)``, and the scaled predictions."""
        scaled = self.scaled(outputs)
        size = 1.0 / (1.0 - gammas.unsqueeze(-1))
        return smooth_l1_loss(scaled * size, target * size, reduction="none").mean(-1), scaled


class Accumulated(Free):
    """Tails as sums of non-negative increments from theta_H downwards."""

    def initial(self) -> Tensor:
        increments = -pad(self.encode(torch.zeros(())), (0, 1)).diff()
        return increments.clamp(min=LEAST_INCREMENT).expm1().log()  # the inverse of softplus

    def scaled(self, outputs: Tensor) -> Tensor:
        return softplus(outputs).flip(-1).cumsum(-1).flip(-1)


class Clipped(Free):
    """From the constant channel upwards in theta, every rise between two neighbours is cut to none."""

    def scaled(self, outputs: Tensor) -> Tensor:
        falls = (outputs[..., :-1] - outputs[..., 1:]).clamp(min=0.0)
        return outputs[..., :1] - pad(falls.cumsum(-1), (1, 0))


_KINDS: dict[str, type[Softmax] | type[Free]] = {
    "softmax": Softmax,
    "accumulated": Accumulated,
    "clipped": Clipped,
    "free": Free,
}


def build(name: str, sensitivities: Sensitivities) -> Softmax | Free:
    return _KINDS[name](sensitivities)
