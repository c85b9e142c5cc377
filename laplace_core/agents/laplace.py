"""Laplace DQN: the values of every reward threshold at every discount, by one network (paper, section 3).

Deviations from the paper, each a setting: the softmax over reward bins, the shared target policy and the shared
experience are the defaults; ``accumulated``, ``per_gamma``, ``per_discount`` and ``multiplexer`` are the paper's.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np
import torch
from torch import Tensor, nn

from laplace_core.agents import networks, parametrisations
from laplace_core.agents.agent import Agent, Batch
from laplace_core.agents.sensitivities import Sensitivities
from laplace_core.agents.settings import LaplaceSettings
from laplace_core.code.gamma_space import GammaSpace
from laplace_core.errors import InputError


class LaplaceAgent(Agent[LaplaceSettings]):
    """Laplace DQN.

    Attributes:
        gammas: ``(G,)``, increasing; each is a head that can act.
        thetas: ``(H,)``, increasing, in units of reward.
    """

    settings_class: ClassVar[type[LaplaceSettings]] = LaplaceSettings

    def __init__(self, settings: LaplaceSettings, observation: int, actions: int, time_limit: int | None = None):
        if settings.termination == "auxiliary" and time_limit is None:
            raise InputError("termination 'auxiliary' needs an environment with a time limit.")
        self.gammas = settings.discounts()
        self.sensitivities = Sensitivities(settings)
        self.thetas = self.sensitivities.thetas
        self.code = parametrisations.build(settings.parametrisation, self.sensitivities)
        self.heads = len(self.gammas)
        self.acting_head = int(np.abs(self.gammas - settings.acting_gamma).argmin())
        self.acting_discount = float(self.gammas[self.acting_head])
        self._gammas = torch.tensor(self.gammas, dtype=torch.float32)
        self._consistency = settings.consistency * (1.0 - self._gammas) ** settings.consistency_exponent
        self._shares = self._shares_of(settings.acting_share)
        super().__init__(settings, observation, actions, time_limit)

    def _build(self) -> nn.Module:
        return networks.build(self.gammas, self.n_observations, self.n_actions, self.code.initial(), self.settings)

    @classmethod
    def network_numbers(cls, settings: LaplaceSettings, observation: int, actions: int) -> int:
        channels = settings.thetas + (2 if settings.parametrisation == "softmax" else 1)
        return networks.count_numbers(settings.n_discounts, observation, actions, channels, settings)

    def _values(self, scaled: Tensor, gammas: Tensor) -> Tensor:
        """sum_h bin value * bin mass / (1 - gamma): ``(..., C)`` to ``(...)`` (paper, Eq. 9)."""
        return scaled @ self.code.value_weights / (1.0 - gammas)

    def _action_values(self, network: nn.Module, observations: Tensor, head: int | None) -> Tensor:
        gammas = self._gammas if head is None else self._gammas[head : head + 1]
        return self._values(self.code.scaled(network(observations, only=head)), gammas[:, None])

    def following(self, next_observations: Tensor) -> Tensor:
        """a* of the target policy, ``(B, 1)`` where it is shared by all discounts, else ``(B, G)``."""
        network = self.network if self.settings.double else self.target
        shared = self.settings.target_policy == "shared"
        if shared and next_observations.shape[1] > 1:  # each discount has an observation of its own
            batch, discounts = next_observations.shape[:2]
            flat = next_observations.reshape(batch * discounts, 1, -1)
            return self._action_values(network, flat, self.acting_head).argmax(-1).view(batch, discounts)
        return self._action_values(network, next_observations, self.acting_head if shared else None).argmax(-1)

    @torch.no_grad()
    def targets(self, batch: Batch) -> Tensor:
        """Targets of the scaled outputs, ``(B, G, C)``; the equation is in :mod:`.parametrisations`."""
        gammas, code = self._gammas, self.code
        actions = self.following(batch.next_observations).expand(-1, len(gammas))
        later = code.scaled(self.target(batch.next_observations, actions=actions))
        ended = batch.terminated.unsqueeze(-1)
        if ended.any():
            later = torch.where(ended, self._after_the_end(batch), later)
        later = later.mul_((gammas**batch.lengths).unsqueeze(-1))
        step = torch.arange(batch.rewards.shape[-1])
        counts = (step < batch.lengths.unsqueeze(-1)).float() * gammas[:, None] ** step  # (B, G, n)
        counts = counts * (1.0 - gammas)[:, None]
        encoded = code.encode(batch.rewards)  # (B, g, n, C)
        if encoded.shape[1] == 1:  # one product a transition for all discounts
            return torch.baddbmm(later, counts, encoded[:, 0])
        return later + torch.einsum("bgn,bgnc->bgc", counts, encoded)

    def _after_the_end(self, batch: Batch) -> Tensor:
        """Scaled outputs after termination, broadcast against ``(B, G, C)``.

        ``auxiliary`` is the paper's proposal (section 5), reward 0 for the n steps left to the time limit, in closed
        form: (1 - gamma^n) encode(0) + gamma^n ended; ``absorbing`` is its limit, n without end.
        """
        nothing = self.code.encode(torch.zeros(()))
        if self.settings.termination == "plain":
            return self.code.ended
        if self.settings.termination == "absorbing":
            return nothing
        assert self.time_limit is not None  # "auxiliary" counts the steps left to it
        over = (self._gammas ** (self.time_limit - batch.elapsed)).unsqueeze(-1)
        return (1.0 - over) * nothing + over * self.code.ended

    def losses(self, batch: Batch) -> Tensor:  # type: ignore[override]  # it prepares nothing
        target = self.targets(batch)
        outputs = self.network(batch.observations, actions=batch.actions.expand(-1, self.heads))
        losses, scaled = self.code.loss(outputs, target, self._gammas)
        if self.settings.consistency > 0:
            # Squared, because Huber's loss would move a value to a median of its noisy targets and not to their mean.
            # Times a power of 1 - gamma: with 0 an error counts as in Q, where long discounts outweigh all others, with
            # 2 as in the outputs, where short ones do.
            error = self._values(scaled, self._gammas) - self._values(target, self._gammas)
            losses = losses + 0.5 * self._consistency * error**2
        return losses * self._shares

    def _shares_of(self, acting_share: float) -> Tensor:
        """Weights of the discounts in the loss, ``(G,)``, with a mean of 1; all are 1 where no share is named."""
        if acting_share == 0 or self.heads == 1:
            return torch.ones(self.heads)
        shares = torch.full((self.heads,), (1.0 - acting_share) / (self.heads - 1))
        shares[self.acting_head] = acting_share
        return shares * self.heads

    @torch.no_grad()
    def gamma_spaces(self, observations: np.ndarray, gammas: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Q[b, a, g, h], ``(B, A, G, H)``, and the constant channel, ``(B, A, G)``, for observations ``(B, O)``.

        Args:
            gammas: other discounts than those trained, increasing in (0, 1), where the network takes them as an input.

        Raises:
            InputError: other discounts for a trunk, which has none but its own, or not increasing in (0, 1).
        """
        inputs = torch.from_numpy(np.asarray(observations, dtype=np.float32)).unsqueeze(1)
        if gammas is None:
            outputs, sizes = self.target(inputs), 1.0 - self._gammas.double()
        else:
            outputs = self._at(inputs, np.asarray(gammas, dtype=float))
            sizes = torch.tensor(1.0 - np.asarray(gammas, dtype=float))
        # In doubles: a difference of two sums in single precision would have lost what a value at +-100 weighs.
        scaled = self.code.scaled(outputs.transpose(1, 2).double())
        tails = (self.code.tails(scaled) / sizes[:, None]).numpy()
        return tails[..., 1:], tails[..., 0]

    def _at(self, inputs: Tensor, gammas: np.ndarray) -> Tensor:
        if not isinstance(self.target, networks.DiscountInput):
            raise InputError("a trunk has values only at its trained discounts: train 'network' or 'multiplexer'.")
        if gammas.ndim != 1 or not gammas.size or not np.all(np.diff([0.0, *gammas, 1.0]) > 0):
            raise InputError("discounts must increase and lie between 0 and 1, both excluded.")
        return self.target.at(inputs, tuple(gammas.tolist()))

    def gamma_space(self, observation: np.ndarray, gammas: np.ndarray | None = None) -> GammaSpace:
        """The learned gamma-space of one observation ``(O,)``, with the open ends that the agent acts on."""
        values, constant = self.gamma_spaces(np.asarray(observation)[None], gammas)
        gammas = self.gammas if gammas is None else np.asarray(gammas)
        return GammaSpace(values[0], constant[0], gammas, self.thetas, open_ends=True)
