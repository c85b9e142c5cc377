"""The base of all agents: two networks, the optimiser and one update. An algorithm adds its network and its loss."""

from __future__ import annotations

import copy
from abc import ABC, abstractmethod
from dataclasses import dataclass, fields
from typing import Any, ClassVar, Generic, TypeVar

import numpy as np
import torch
from torch import Tensor, nn

from laplace_core.agents.adam import Adam
from laplace_core.agents.settings import LoopSettings
from laplace_core.code.ties import greedy_action


@dataclass(frozen=True, eq=False)
class Batch:
    """Transitions to learn from: ``g`` is 1 where all discounts learn from the same ones, else G.

    Attributes:
        observations, next_observations: ``(B, g, O)``, float32.
        actions: ``(B, g)``, int64.
        rewards: ``(B, g, n)``; those from ``lengths`` on do not count.
        lengths: ``(B, g)``, from 1 to n: steps from the observation to the next one.
        terminated: ``(B, g)``; a truncated transition is not terminated: it bootstraps as any other.
        elapsed: ``(B, g)``, steps of the episode up to and with the last reward.
        weights: ``(B,)``, importance of each.
    """

    observations: Tensor
    actions: Tensor
    rewards: Tensor
    lengths: Tensor
    next_observations: Tensor
    terminated: Tensor
    elapsed: Tensor
    weights: Tensor

    def split(self, count: int) -> list[Batch]:
        """The rows split in order into this number of batches."""
        return [Batch(*parts) for parts in zip(*(getattr(self, name).chunk(count) for name in _FIELDS), strict=True)]


_FIELDS = tuple(field.name for field in fields(Batch))


Chosen = TypeVar("Chosen", bound=LoopSettings)
"""The settings of an algorithm."""


class Agent(ABC, Generic[Chosen]):
    """An online network that learns and acts while training, and its slow average, ``target``.

    The average is also what is evaluated and saved: it forgets less from one update to the next.

    Args:
        observation: numbers in an observation.
        actions: number of actions.
        time_limit: steps after which an episode is truncated; None if never.

    Attributes:
        heads: how many ways to act the network holds; ``acting_head`` is the one meant to be used.
        acting_discount: of the return that the acting head values; None where that return does not go on to the end.
        random: random numbers for losses that need some; a run puts its own here, to be gone on with after a stop.
    """

    settings_class: ClassVar[type[Any]]
    heads: int = 1
    acting_head: int = 0
    acting_discount: float | None = None

    def __init__(self, settings: Chosen, observation: int, actions: int, time_limit: int | None = None):
        self.settings, self.time_limit = settings, time_limit
        self.n_observations, self.n_actions = observation, actions
        self.random = np.random.default_rng(settings.seed)
        with torch.random.fork_rng(devices=[]):  # the only use of torch's random numbers
            torch.manual_seed(settings.seed)
            self.network = self._build()
        self.target = copy.deepcopy(self.network).requires_grad_(False)
        self._parameters: list[Any] = list(self.network.parameters())
        self.optimiser = Adam(self._parameters)
        self._averages: list[Any] = list(self.target.parameters())

    @abstractmethod
    def _build(self) -> nn.Module:
        """A fresh network."""

    @classmethod
    @abstractmethod
    def network_numbers(cls, settings: Chosen, observation: int, actions: int) -> int:
        """The number of weights of the network, counted without building it."""

    def prepare(self, batch: Batch) -> tuple[Tensor, ...]:
        """Tensors that the losses of a whole round of updates share, with one row for each transition."""
        return ()

    @abstractmethod
    def losses(self, batch: Batch, *prepared: Tensor) -> Tensor:
        """Loss of every transition at every head, ``(B, g)`` or ``(B, G)``, with gradients to the network.

        Args:
            prepared: what :meth:`prepare` has returned for these transitions.
        """

    @abstractmethod
    def _action_values(self, network: nn.Module, observations: Tensor, head: int | None) -> Tensor:
        """Values ``(B, 1, A)`` at one head, or ``(B, heads, A)`` for None, from observations ``(B, 1, O)``."""

    @torch.no_grad()
    def action_values(self, observations: np.ndarray, head: int | None = None) -> np.ndarray:
        """Expected discounted return of every action as the average sees it, in units of reward, float64.

        Args:
            observations: ``(B, O)``.
            head: one head, for ``(B, A)``; None is all of them, ``(B, heads, A)``.
        """
        values = self._action_values(self.target, batched(observations), head).double().numpy()
        return values if head is None else values[:, 0]

    def greedy(self, observations: np.ndarray) -> np.ndarray:
        """The action meant to be taken, int ``(B,)``, for observations ``(B, O)``."""
        return greedy_action(self.action_values(observations, self.acting_head))

    @torch.no_grad()
    def behave(self, observations: np.ndarray, heads: np.ndarray) -> np.ndarray:
        """Greedy actions of the learning network, int ``(B,)``, each row by its own head ``(B,)``."""
        inputs = batched(observations)
        if np.all(heads == heads[0]):
            return self._action_values(self.network, inputs, int(heads[0]))[:, 0].argmax(-1).numpy()
        values = self._action_values(self.network, inputs, None)
        return values[torch.arange(len(heads)), torch.from_numpy(heads)].argmax(-1).numpy()

    def learn(self, batch: Batch, updates: int, progress: float) -> tuple[list[float], np.ndarray]:
        """A round of updates: steps of the optimiser, each on its share of the batch and followed by the average.

        Args:
            batch: its rows are a multiple of ``updates``.
            progress: fraction of the training that lies behind, for the learning rate.

        Returns:
            the loss of every update, and that of every transition, ``(B,)``, for its priority.
        """
        prepared = [part.chunk(updates) for part in self.prepare(batch)]
        shares = zip(batch.split(updates), *prepared, strict=True)
        each = np.concatenate([self._update(part, own, progress) for part, *own in shares])
        return (batch.weights.numpy() * each).reshape(updates, -1).mean(axis=1).tolist(), each

    def update(self, batch: Batch, progress: float) -> tuple[float, np.ndarray]:
        """A round of one update: its loss, and that of every transition."""
        (loss,), each = self.learn(batch, 1, progress)
        return loss, each

    def _update(self, batch: Batch, prepared: list[Tensor], progress: float) -> np.ndarray:
        """One update of a round: the loss of every transition, ``(B,)``."""
        s = self.settings
        losses = self.losses(batch, *prepared)
        # The gradient of the weighted mean is known: handing it over spares the engine the operations of the mean.
        losses.backward((batch.weights / losses.numel()).unsqueeze(1).expand_as(losses))
        self.optimiser.step(s.learning_rate * (1.0 + progress * (s.learning_rate_final - 1.0)), s.gradient_clip)
        with torch.no_grad():
            torch._foreach_lerp_(self._averages, self._parameters, s.averaging)
        return losses.detach().numpy().mean(axis=1)


def batched(observations: np.ndarray) -> Tensor:
    """``(B, O)`` as networks take it, ``(B, 1, O)``, float32."""
    return torch.from_numpy(np.asarray(observations, dtype=np.float32)).unsqueeze(1)
