"""Expectile DQN: expectiles of the return, by the squared expectile loss with imputed targets (Rowland et al. 2019).

Expectiles are no samples: the target is a distribution that has those of the next state. Rowland et al. search for
equally heavy samples with a numeric optimiser; :func:`impute` has masses of their own in closed form instead.
"""

from __future__ import annotations

from typing import Any, ClassVar

import torch
from torch import Tensor
from torch.nn.functional import pad

from laplace_core.agents.peer import Peer
from laplace_core.agents.settings import ExpectileSettings

LEAST_TAIL = 0.01
"""Least mass that an outermost location is given: rarer events are moved inwards, so that none lies without bounds."""


class ExpectileAgent(Peer[ExpectileSettings]):
    """Expectile DQN.

    Attributes:
        levels: ``(C,)``, i / (C + 1); the middle one is 1/2, whose expectile is the mean.
    """

    settings_class: ClassVar[type[ExpectileSettings]] = ExpectileSettings

    def __init__(self, settings: ExpectileSettings, *sizes: Any) -> None:
        self.levels = torch.arange(1, settings.expectiles + 1) / (settings.expectiles + 1)
        super().__init__(settings, *sizes)

    @classmethod
    def channels(cls, settings: ExpectileSettings) -> int:
        return settings.expectiles

    def initial(self) -> Tensor:
        return torch.zeros(self.levels.numel())

    def means(self, outputs: Tensor) -> Tensor:
        return outputs[..., self.levels.numel() // 2]

    def distribution(self, outputs: Tensor) -> tuple[Tensor, Tensor]:
        """Imputed locations and their masses."""
        return impute(outputs, self.levels)

    def loss(self, outputs: Tensor, locations: Tensor, masses: Tensor) -> Tensor:
        return expectile_loss(outputs, locations, masses, self.levels)


def expectile_loss(expectiles: Tensor, locations: Tensor, masses: Tensor, levels: Tensor) -> Tensor:
    """sum_i sum_j p_j |level_i - 1[u_ij < 0]| u_ij^2, u_ij = y_j - e_i: ``(B,)`` (Rowland et al. 2019).

    A target above a high expectile costs more than one as far below it.

    Args:
        expectiles: ``(B, C)``.
        locations, masses: ``(B, M)`` each.
        levels: ``(C,)``.
    """
    excess = locations.unsqueeze(1) - expectiles.unsqueeze(2)  # (B, C, M)
    weights = torch.where(excess < 0, 1.0 - levels.unsqueeze(-1), levels.unsqueeze(-1))
    return (weights * excess**2 @ masses.unsqueeze(-1)).sum((1, 2))


def impute(expectiles: Tensor, levels: Tensor) -> tuple[Tensor, Tensor]:
    """A distribution with the given expectiles: locations, increasing, and masses, ``(B, C + 1)`` each.

    With m the mean, which is the middle expectile, and U(x) = E[(X - x)+], the first-order condition of the expectile
    at level t, t U(e) = (1 - t) E[(e - X)+] (paper, Eq. 12), and E[(e - X)+] = U(e) - (m - e) give U in closed form,

        U(e) = (1 - t) (e - m) / (2 t - 1),

    at every expectile but the middle one. U is convex, with slope P(X <= x) - 1; the straight lines between the known
    points are the U of masses on the expectiles, each the change of slope there. Two locations beyond the outermost
    expectiles close the ends: as near as the next line allows, with a mass of at most 1 / (C + 1).

    Errors: if some distribution with at least ``LEAST_TAIL`` at both its ends has these expectiles, so has the result,
    within 1e-8 of their range. Other expectiles, which networks give, are made increasing outwards from the middle
    one, and the points are replaced by their greatest convex minorant, which is again the U of a distribution. The
    mean is m in every case.
    """
    middle = levels.numel() // 2
    below = expectiles[:, : middle + 1].double().flip(1).cummin(1).values.flip(1)
    above = expectiles[:, middle:].double().cummax(1).values
    m, t = above[:, :1], torch.cat([levels[:middle], levels[middle + 1 :]]).double()
    x = torch.cat([below[:, :-1], above[:, 1:]], dim=1)
    # Equal expectiles are set apart by what is next to nothing, for slopes that are not 0 / 0.
    apart = 1e-9 * (1.0 + m.abs() + x[:, -1:] - x[:, :1])
    x = x + apart * (t - 0.5) * (levels.numel() + 1)
    excess = (1.0 - t) * (x - m) / (2.0 * t - 1.0)
    lacking = excess + x - m  # E[(x - X)+]
    falls = ((excess[:, :-1] - excess[:, 1:]) / x.diff(dim=1))[:, [0, -1]]
    least = 1.0 / (levels.numel() + 1)
    low = x[:, :1] - lacking[:, :1] / (1.0 - falls[:, :1]).clamp(LEAST_TAIL, least)
    high = x[:, -1:] + excess[:, -1:] / falls[:, 1:].clamp(LEAST_TAIL, least)
    x = torch.cat([low, x, high], dim=1)
    slopes = _minorant_slopes(x, torch.cat([m - low, excess, torch.zeros_like(m)], dim=1))
    masses = pad(pad(slopes, (1, 0), value=-1.0), (0, 1)).diff(dim=1)
    return x.float(), masses.float()


def _minorant_slopes(x: Tensor, y: Tensor) -> Tensor:
    """Slopes of the greatest convex minorant of points ``(B, K)``, x increasing, between neighbours: ``(B, K - 1)``.

    max over i <= k of min over j > k of the slope from point i to point j: isotonic regression (Robertson et al. 1988).
    """
    chords = (y.unsqueeze(1) - y.unsqueeze(2)) / (x.unsqueeze(1) - x.unsqueeze(2))  # (B, K, K): from i to j
    least = chords[:, :-1, 1:].flip(2).cummin(2).values.flip(2)
    return least.masked_fill(~torch.ones_like(least[0], dtype=torch.bool).triu(), -torch.inf).amax(1)
