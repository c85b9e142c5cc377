"""Reward sensitivities of an agent: the activation, the bins between thresholds and the value of each bin.

The activation is a sigmoid on the axis on which the thresholds are evenly spaced: the reward itself, asinh(r / scale)
or, with ``gaussian`` spacing, the normal law's Phi((r - middle) / scale). One slope then suits the dense middle and the
sparse ends, where a slope in 1/reward would blur the one or round the other.
"""

from __future__ import annotations

import numpy as np
import torch
from torch import Tensor

from laplace_core.agents.settings import LaplaceSettings
from laplace_core.code.encoding import sensitivity_grid, theta_scale
from laplace_core.code.gamma_space import bin_values


class Sensitivities:
    """The grid of thresholds and everything that follows from a reward through it.

    Attributes:
        thetas: ``(H,)``, in units of reward, float64.
        places: ``(H,)``, slope * theta on the axis of the activation, float64; evenly spaced.
        bin_values: ``(H+1,)``, what a reward in each bin counts as: the midpoints, and for the two outermost bins,
            below the first and above the last threshold, those thresholds themselves.
    """

    def __init__(self, settings: LaplaceSettings):
        s = settings
        self.thetas = sensitivity_grid(s.thetas, s.theta_min, s.theta_max, s.theta_spacing, s.theta_scale or None)
        self._spacing, self._middle = s.theta_spacing, (s.theta_min + s.theta_max) / 2.0
        self._scale = theta_scale(s.theta_min, s.theta_max, s.theta_spacing, s.theta_scale or None)
        places = self._place(torch.from_numpy(self.thetas)).numpy()
        self._places = torch.tensor(places, dtype=torch.float32)
        self.slope = s.slope_times_spacing / float(np.diff(places).max())
        self.places = self.slope * places
        self.bin_values = bin_values(self.thetas, open_ends=True)

    def _place(self, rewards: Tensor) -> Tensor:
        """Rewards on the axis of the activation, in their shape and precision."""
        if self._spacing == "uniform":
            return rewards
        if self._spacing == "asinh":
            return torch.asinh(rewards / self._scale)
        return torch.special.ndtr((rewards - self._middle) / self._scale)

    def tails(self, rewards: Tensor) -> Tensor:
        """The constant channel, 1, and f_1(r), ..., f_H(r): shape ``rewards.shape + (H+1,)``, never increasing."""
        values = torch.sigmoid(self.slope * (self._place(rewards).unsqueeze(-1) - self._places))
        return torch.cat([torch.ones_like(values[..., :1]), values], dim=-1)

    def masses(self, rewards: Tensor) -> Tensor:
        """1 - f_1, f_1 - f_2, ..., f_H: the mass of a reward in each bin, ``rewards.shape + (H+1,)``; the sum is 1."""
        tails = self.tails(rewards)
        return tails - torch.nn.functional.pad(tails[..., 1:], (0, 1))
