"""What an agent may be able to do besides acting, as types to ask for with ``isinstance``."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

import numpy as np

from laplace_core.agents.sensitivities import Sensitivities
from laplace_core.gamma_space import GammaSpace


@runtime_checkable
class HasGammaSpace(Protocol):
    """Values of every reward threshold ``thetas`` ``(H,)`` at every discount ``gammas`` ``(G,)``."""

    gammas: np.ndarray
    thetas: np.ndarray
    sensitivities: Sensitivities

    def gamma_spaces(self, observations: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """``(B, A, G, H)`` and the constant channel, ``(B, A, G)``, for observations ``(B, O)``."""

    def gamma_space(self, observation: np.ndarray) -> GammaSpace:
        """What was learned for one observation ``(O,)``."""
