"""QR-DQN: equally heavy quantiles of the return, by the quantile Huber loss (Dabney et al. 2018)."""

from __future__ import annotations

from typing import Any, ClassVar

import torch
from torch import Tensor
from torch.nn.functional import huber_loss, pad

from laplace_core.agents.peer import Peer
from laplace_core.agents.settings import QrdqnSettings

MOST_PAIRS = 2_000
"""Quantiles times targets up to which it is faster to go through all pairs."""


class QrdqnAgent(Peer[QrdqnSettings]):
    """QR-DQN.

    Attributes:
        levels: ``(C,)``, the midpoints (i - 1/2) / C: what fraction of the return lies below each output.
    """

    settings_class: ClassVar[type[QrdqnSettings]] = QrdqnSettings

    def __init__(self, settings: QrdqnSettings, *sizes: Any) -> None:
        self.levels = (torch.arange(settings.quantiles) + 0.5) / settings.quantiles
        super().__init__(settings, *sizes)

    @classmethod
    def channels(cls, settings: QrdqnSettings) -> int:
        return settings.quantiles

    def initial(self) -> Tensor:
        return torch.zeros(self.levels.numel())

    def means(self, outputs: Tensor) -> Tensor:
        return outputs.mean(-1)

    def distribution(self, outputs: Tensor) -> tuple[Tensor, Tensor]:
        """The quantiles in order, which a network need not give them in, equally heavy."""
        return outputs.sort(-1).values, torch.full_like(outputs, 1.0 / outputs.shape[-1])

    def loss(self, outputs: Tensor, locations: Tensor, masses: Tensor) -> Tensor:
        return quantile_huber(outputs, locations, self.levels)


def quantile_huber(quantiles: Tensor, locations: Tensor, levels: Tensor) -> Tensor:
    """sum_i mean_j |level_i - 1[u_ij < 0]| huber(u_ij), u_ij = y_j - q_i: ``(B,)`` (Dabney et al. 2018, Eq. 10).

    huber(u) is u^2 / 2 up to |u| = 1, in units of reward, and |u| - 1/2 beyond: a target above a high quantile costs
    more than one as far below it.

    Args:
        quantiles: ``(B, C)``.
        locations: ``(B, M)``, increasing along each row.
        levels: ``(C,)``.
    """
    if quantiles.shape[1] * locations.shape[1] > MOST_PAIRS:
        return _of_many(quantiles, locations, levels)
    q = quantiles.unsqueeze(2).expand(-1, -1, locations.shape[1])
    y = locations.unsqueeze(1).expand_as(q)
    weights = torch.where(y < q, 1.0 - levels.unsqueeze(1), levels.unsqueeze(1))
    return (weights * huber_loss(q, y, reduction="none")).sum((1, 2)) / locations.shape[1]


def _of_many(quantiles: Tensor, locations: Tensor, levels: Tensor) -> Tensor:
    """The same in C log M steps in place of C * M, to rounding in double precision.

    With the targets in order, those of one piece (far below q_i, near below, near above, far above) are neighbours, and
    their sum is a polynomial in q_i whose coefficients are differences of running sums of 1, y and y^2.
    """
    (q, order), y = quantiles.double().sort(-1), locations.double()  # in order because searching is then far faster
    levels = levels[order]
    counts = torch.searchsorted(y, torch.cat([q - 1.0, q, q + 1.0], dim=1).detach())
    whole = torch.full_like(counts[:, : q.shape[1]], y.shape[1])
    places = torch.cat([torch.zeros_like(whole), counts, whole], dim=1)  # where each of the four pieces begins and ends

    def pieces(values: Tensor) -> tuple[Tensor, ...]:
        return values.gather(1, places).view(len(q), 5, -1).diff(dim=1).unbind(1)

    n = places.view(len(q), 5, -1).diff(dim=1).unbind(1)
    s = pieces(pad(y.cumsum(1), (1, 0)))
    ss = pieces(pad((y * y).cumsum(1), (1, 0)))
    below = n[0] * (q - 0.5) - s[0] + (0.5 * n[1] * q - s[1]) * q + 0.5 * ss[1]
    above = s[3] - n[3] * (q + 0.5) + (0.5 * n[2] * q - s[2]) * q + 0.5 * ss[2]
    costs = (1.0 - levels) * below + levels * above
    return (costs.sum(-1) / y.shape[1]).float()
