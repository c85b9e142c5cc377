"""Networks from observations to one output vector for every action and discount.

Three ways to share weights between discounts, behind one call. Observations are ``(B, 1, O)``, the same for all
discounts, or ``(B, G, O)``, each discount's own; the answer is

    network(observations)                     (B, G, A, C)
    network(observations, actions=(B, G))     (B, G, C): one action each, without computing the others
    network(observations, only=g)             (B, 1, A, C): one discount, without computing the others

The trunk is trained for the discounts of its grid. The other two take the discount as an input and may be evaluated
at discounts never trained, by :meth:`DiscountInput.at`. The peers, which have no discounts to share weights between,
use :class:`Single`, which always answers for all actions.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from laplace_core.agents.settings import LaplaceSettings, LoopSettings

MULTIPLEXER_BOUNDS = (0.5, 0.75)
"""The paper's low, medium and high discounts (section 3.2): up to .5, up to .75, and above."""


class Head(nn.Module):
    """A linear layer from the features of a discount to the outputs of each action, shared by all discounts.

    Args:
        features: F, and with ``dueling`` half of them speak for the state and half for the advantages, whose mean
            over actions is taken away.
        initial: outputs before training, ``(C,)``; the weights begin small, so that all discounts are near it.
    """

    def __init__(self, features: int, actions: int, initial: Tensor, dueling: bool):
        super().__init__()
        self.dueling = dueling
        width = features // 2 if dueling else features
        self.weight = nn.Parameter(0.1 * torch.randn(actions, width, initial.numel()) / features**0.5)
        self.bias = nn.Parameter(initial.repeat(actions, 1))
        if dueling:
            self.state_weight = nn.Parameter(0.1 * torch.randn(width, initial.numel()) / features**0.5)

    def _weights(self) -> Tensor:
        """``(A, F, C)``. Dueling is linear in the features too: V + A_a - mean A is one matrix for each action."""
        if not self.dueling:
            return self.weight
        state = self.state_weight.expand(self.weight.shape[0], -1, -1)
        return torch.cat([state, self.weight - self.weight.mean(0, keepdim=True)], dim=1)

    def forward(self, features: Tensor, actions: Tensor | None = None) -> Tensor:
        """``(B, G, F)`` to ``(B, G, A, C)``, or to ``(B, G, C)`` for ``actions`` ``(B, G)``."""
        weights = self._weights()
        n_actions, width, channels = weights.shape
        batch, discounts = features.shape[:2]
        if actions is None:
            flat = weights.permute(1, 0, 2).reshape(width, n_actions * channels)
            return (features @ flat).view(batch, discounts, n_actions, channels) + self.bias
        # Rows are sorted by action, so that each action's rows are one product with its weights and nothing else is.
        flat, rows = actions.reshape(-1), features.reshape(batch * discounts, width)
        order = torch.argsort(flat, stable=True)
        groups = rows.index_select(0, order).split(torch.bincount(flat, minlength=n_actions).tolist())
        outputs = torch.cat([torch.addmm(self.bias[a], group, weights[a]) for a, group in enumerate(groups)])
        return outputs.index_select(0, torch.argsort(order)).view(batch, discounts, channels)


class Trunk(nn.Module):
    """Two hidden layers for all discounts, a layer of features for each, and the shared head."""

    def __init__(self, gammas: np.ndarray, observation: int, actions: int, initial: Tensor, settings: LaplaceSettings):
        super().__init__()
        s = settings
        self.discounts = len(gammas)
        self.trunk = nn.Sequential(
            nn.Linear(observation, s.hidden), nn.ReLU(), nn.Linear(s.hidden, s.hidden), nn.ReLU()
        )
        self.features = _feature_width(s)
        bound = s.hidden**-0.5
        self.weight = nn.Parameter(torch.empty(self.discounts * self.features, s.hidden).uniform_(-bound, bound))
        self.bias = nn.Parameter(torch.zeros(self.discounts * self.features))
        self.head = Head(self.features, actions, initial, s.dueling)

    def forward(self, observations: Tensor, actions: Tensor | None = None, only: int | None = None) -> Tensor:
        hidden = self.trunk(observations)  # (B, 1 or G, hidden)
        if hidden.shape[1] == 1:
            rows = slice(None) if only is None else slice(only * self.features, (only + 1) * self.features)
            features = nn.functional.linear(hidden[:, 0], self.weight[rows], self.bias[rows])
            features = features.view(len(hidden), -1, self.features)
        else:
            weight = self.weight.view(self.discounts, self.features, -1)
            features = torch.einsum("bgi,gfi->bgf", hidden, weight) + self.bias.view(self.discounts, self.features)
            features = features if only is None else features[:, only : only + 1]
        return self.head(torch.relu(features), actions)


class _Tower(nn.Module):
    """One network of an observation and a discount."""

    def __init__(self, observation: int, actions: int, initial: Tensor, settings: LaplaceSettings):
        super().__init__()
        hidden, width = settings.hidden, _feature_width(settings)
        self.observed = nn.Linear(observation, hidden)
        self.discounted = nn.Linear(2, hidden, bias=False)
        self.rest = nn.Sequential(nn.ReLU(), nn.Linear(hidden, hidden), nn.ReLU(), nn.Linear(hidden, width), nn.ReLU())
        self.head = Head(width, actions, initial, settings.dueling)

    def forward(self, observations: Tensor, gammas: Tensor, actions: Tensor | None) -> Tensor:
        """``(B, 1 or g, O)`` and ``(g,)`` to ``(B, g, A, C)`` or ``(B, g, C)``."""
        # The first layer is a sum over its inputs, so that it sees each observation once and not once a discount.
        return self.head(self.rest(self.observed(observations) + self.discounted(_as_input(gammas))), actions)


class DiscountInput(nn.Module):
    """Towers that take the discount as an input: one for all, or the paper's multiplexer of three (section 3.2)."""

    def __init__(self, gammas: np.ndarray, observation: int, actions: int, initial: Tensor, settings: LaplaceSettings):
        super().__init__()
        self.bounds = MULTIPLEXER_BOUNDS if settings.network == "multiplexer" else ()
        self.grid = tuple(float(gamma) for gamma in gammas)
        self.towers = nn.ModuleList(
            _Tower(observation, actions, initial, settings) for _ in range(len(self.bounds) + 1)
        )

    def forward(self, observations: Tensor, actions: Tensor | None = None, only: int | None = None) -> Tensor:
        if only is None:
            return self.at(observations, self.grid, actions)
        if observations.shape[1] > 1:
            observations = observations[:, only : only + 1]
        return self.at(observations, self.grid[only : only + 1], actions)

    def at(self, observations: Tensor, gammas: tuple[float, ...], actions: Tensor | None = None) -> Tensor:
        """At any increasing discounts, trained or not: ``(B, g, A, C)``, or ``(B, g, C)`` for ``actions``."""
        cuts = [0, *np.searchsorted(gammas, self.bounds, side="right"), len(gammas)]
        values = torch.tensor(gammas, dtype=torch.float32)
        parts = []
        for tower, first, last in zip(self.towers, cuts[:-1], cuts[1:], strict=True):
            if last > first:
                own = observations if observations.shape[1] == 1 else observations[:, first:last]
                chosen = None if actions is None else actions[:, first:last]
                parts.append(tower(own, values[first:last], chosen))
        return torch.cat(parts, dim=1)


class Single(nn.Module):
    """Two hidden layers and a linear one, for agents without a grid of discounts: ``(B, g, O)`` to ``(B, g, A, C)``.

    With ``dueling`` the second hidden layer is twice as wide, and its halves speak for the state and for the advantage
    of each action, whose mean over actions is taken away (Wang et al. 2016, Eq. 9).

    Args:
        initial: outputs before training over ``scale``, ``(C,)``; the last weights begin small, so that all actions are
            near it.
        scale: what the last layer's outputs are multiplied by.
    """

    def __init__(self, observation: int, actions: int, initial: Tensor, settings: LoopSettings, scale: float = 1.0):
        super().__init__()
        hidden, self.shape, self.dueling = settings.hidden, (actions, initial.numel()), settings.dueling
        self.scale = scale
        width = hidden * (2 if self.dueling else 1)
        self.trunk = nn.Sequential(nn.Linear(observation, hidden), nn.ReLU(), nn.Linear(hidden, width), nn.ReLU())
        self._hidden_layers: tuple[Any, ...] = self.trunk[0], self.trunk[2]
        self.head = nn.Linear(hidden, actions * initial.numel())
        self.state = nn.Linear(hidden, initial.numel()) if self.dueling else None
        for layer in (self.head,) if self.state is None else (self.head, self.state):
            nn.init.normal_(layer.weight, std=0.1 / hidden**0.5)
            layer.bias.data = initial.repeat(layer.out_features // initial.numel())

    def forward(self, observations: Tensor) -> Tensor:
        # For networks as small as these, calls of modules and views cost as much as arithmetic: the hidden layers are
        # applied without the former, and to the rows of one matrix.
        features = observations.flatten(0, -2)
        for layer in self._hidden_layers:
            features = nn.functional.linear(features, layer.weight, layer.bias).relu_()
        outputs = self._outputs(features)
        outputs = outputs if self.scale == 1.0 else outputs * self.scale
        return outputs.view(*observations.shape[:-1], *self.shape)

    def _outputs(self, features: Tensor) -> Tensor:
        if self.state is None:
            return self.head(features)
        stated, advantaged = features.chunk(2, dim=-1)
        advantages = self.head(advantaged).unflatten(-1, self.shape)
        return self.state(stated).unsqueeze(-2) + advantages - advantages.mean(-2, keepdim=True)

    @staticmethod
    def count_numbers(observation: int, actions: int, channels: int, settings: LoopSettings) -> int:
        """Weights in such a network, without building it."""
        hidden, streams = settings.hidden, 2 if settings.dueling else 1
        last = (actions + streams - 1) * channels * (hidden + 1)
        return (observation + 1) * hidden + (hidden + 1) * streams * hidden + last


def _feature_width(settings: LaplaceSettings) -> int:
    return settings.features * (2 if settings.dueling else 1)


def _as_input(gammas: Tensor) -> Tensor:
    """Two numbers of order one, ``(g, 2)``: the discount, and the logarithm of its time constant -1/log gamma."""
    return torch.stack([gammas, -torch.log(-torch.log(gammas)) / 4.0], dim=-1)


def build(
    gammas: np.ndarray, observation: int, actions: int, initial: Tensor, settings: LaplaceSettings
) -> Trunk | DiscountInput:
    """The network that the settings name.

    Args:
        gammas: ``(G,)``, increasing.
        observation: numbers in an observation.
        initial: outputs before training, ``(C,)``.
    """
    kind = Trunk if settings.network == "trunk" else DiscountInput
    return kind(gammas, observation, actions, initial, settings)


def count_numbers(discounts: int, observation: int, actions: int, channels: int, settings: LaplaceSettings) -> int:
    """Weights in the network that :func:`build` would build, without building it."""
    hidden, width = settings.hidden, _feature_width(settings)
    head = actions * channels * (settings.features + 1) + settings.dueling * settings.features * channels
    first, second = (observation + 1) * hidden, (hidden + 1) * hidden
    if settings.network == "trunk":
        return first + second + discounts * width * (hidden + 1) + head
    towers = len(MULTIPLEXER_BOUNDS) + 1 if settings.network == "multiplexer" else 1
    return towers * (first + 2 * hidden + second + width * (hidden + 1) + head)
