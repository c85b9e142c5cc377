"""Capabilities of agents besides acting, as types for ``isinstance``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

import numpy as np

from laplace_core.code.gamma_space import GammaSpace

if TYPE_CHECKING:  # to ask for a capability needs no network
    from torch import Tensor

    from laplace_core.agents.sensitivities import Sensitivities


@runtime_checkable
class HasDiscounts(Protocol):
    """Values at many discounts ``gammas`` ``(G,)``, a head each."""

    gammas: np.ndarray


@runtime_checkable
class HasGammaSpace(HasDiscounts, Protocol):
    """Values of every reward threshold ``thetas`` ``(H,)`` at every discount ``gammas`` ``(G,)``."""

    thetas: np.ndarray
    sensitivities: Sensitivities

    def gamma_spaces(self, observations: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """``(B, A, G, H)`` and the constant channel, ``(B, A, G)``, for observations ``(B, O)``."""

    def gamma_space(self, observation: np.ndarray) -> GammaSpace:
        """The learned gamma-space of one observation ``(O,)``."""


@runtime_checkable
class HasReturnDistribution(Protocol):
    """A distribution of the discounted return of every action, as M locations and their masses."""

    def return_distributions(self, observations: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Locations in units of reward, increasing, and masses, ``(B, A, M)`` each, for observations ``(B, O)``."""

    def return_distribution(self, observation: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The same for one observation ``(O,)``: ``(A, M)`` each."""


@runtime_checkable
class HasTimeToGo(Protocol):
    """Values of the next T steps for every T to ``horizon``: head T - 1 acts for T steps to go."""

    horizon: int


@runtime_checkable
class HasAtoms(Protocol):
    """Fixed returns that carry all probability, ``atoms`` ``(C,)``, in units of reward; none lies beyond them."""

    atoms: Tensor
    acting_discount: float
