"""Fixed-horizon DQN: the return of the next T steps for every T up to a maximum, by one network with T as an input.

Q(s, a, T) = E[r + gamma max_a' Q(s', a', T - 1)] and Q(s, a, 0) = 0 (De Asis et al. 2020, there with one table a
horizon), learned off-policy for random T from the same transitions. It is backward induction without a model of the
world, and the baseline of any rule that adapts to a horizon.
"""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np
import torch
from torch import Tensor, nn

from laplace_core.agents.agent import Agent, Batch, batched
from laplace_core.agents.networks import Single
from laplace_core.agents.peer import discounted
from laplace_core.agents.settings import FixedHorizonSettings

TIME_INPUTS = 12
"""Inputs of the network that encode T: its nearness to as many times from 1 to the longest, evenly spaced in log T.

The two times around T share a weight of 1. Short times differ from the start, and long ones vary smoothly.
"""


class FixedHorizonAgent(Agent[FixedHorizonSettings]):
    """Fixed-horizon DQN: head h acts for h + 1 steps to go, and the last one where the end is farther or unknown.

    Attributes:
        horizon: the longest time to go.
    """

    settings_class: ClassVar[type[FixedHorizonSettings]] = FixedHorizonSettings

    def __init__(self, settings: FixedHorizonSettings, *sizes: Any) -> None:
        self.horizon = self.heads = settings.horizon
        self.acting_head = self.heads - 1
        super().__init__(settings, *sizes)

    def _build(self) -> nn.Module:
        return Single(self.n_observations + TIME_INPUTS, self.n_actions, torch.zeros(1), self.settings)

    @classmethod
    def network_numbers(cls, settings: FixedHorizonSettings, observation: int, actions: int) -> int:
        return Single.count_numbers(observation + TIME_INPUTS, actions, 1, settings)

    def values(self, network: nn.Module, observations: Tensor, times: Tensor) -> Tensor:
        """Q(s, a, T), ``(B, g, A)``, in units of reward.

        Args:
            observations: ``(B, 1, O)``.
            times: T, ``(B, g)``; 0 is worth 0.
        """
        place = times.clamp(min=1).log() * ((TIME_INPUTS - 1) / np.log(max(2, self.horizon)))
        inputs = (1.0 - (place.unsqueeze(-1) - torch.arange(TIME_INPUTS)).abs()).clamp(min=0.0)
        outputs = network(torch.cat([observations.expand(-1, times.shape[1], -1), inputs], dim=-1))
        # The network's own scale is reward a step, which is of one size for all T.
        return outputs.squeeze(-1) * self._steps(times).unsqueeze(-1)

    def _steps(self, times: Tensor) -> Tensor:
        """1 + gamma + ... + gamma^(T - 1)."""
        return (1.0 - self.settings.gamma**times) / (1.0 - self.settings.gamma)

    def _action_values(self, network: nn.Module, observations: Tensor, head: int | None) -> Tensor:
        times = torch.arange(1, self.heads + 1) if head is None else torch.tensor([head + 1])
        return self.values(network, observations, times.expand(len(observations), -1))

    @torch.no_grad()
    def behave(self, observations: np.ndarray, heads: np.ndarray) -> np.ndarray:
        values = self.values(self.network, batched(observations), torch.from_numpy(heads + 1).unsqueeze(1))
        return values[:, 0].argmax(-1).numpy()

    @torch.no_grad()
    def targets(self, batch: Batch, times: Tensor) -> Tensor:
        """r_0 + ... + gamma^m max_a Q(s_m, a, T - m), cut after T rewards: ``(B, g)``, as ``times``, which hold T."""
        left = (times - batch.lengths).clamp(min=0)
        following = self.values(self.target, batch.next_observations, left)
        judged = self.values(self.network, batch.next_observations, left) if self.settings.double else following
        later = following.gather(-1, judged.argmax(-1, keepdim=True)).squeeze(-1)
        rewards, discounts = discounted(batch, self.settings.gamma, torch.minimum(batch.lengths, times))
        return rewards + discounts * later

    def prepare(self, batch: Batch) -> tuple[Tensor, Tensor]:
        """Random times to go and the targets for them, ``(B, times)`` each."""
        size = len(batch.observations), self.settings.times
        times = torch.from_numpy(self.random.integers(1, self.horizon + 1, size=size))
        return times, self.targets(batch, times)

    # It takes what its own prepare() returns.
    def losses(self, batch: Batch, times: Tensor, targets: Tensor) -> Tensor:  # type: ignore[override]
        outputs = self.values(self.network, batch.observations, times)
        outputs = outputs.gather(-1, batch.actions.expand_as(times).unsqueeze(-1)).squeeze(-1)
        # Over the discounted number of steps: half way between the scale of the values and that of the network.
        return 0.5 * (outputs - targets) ** 2 / self._steps(times)
