"""Learned tables and curves of every learner of one run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from laplace_core.code.ties import greedy_action
from laplace_core.errors import InputError
from laplace_core.tabular.settings import ResolvedLearning
from laplace_core.worlds import World

CURVE_NAMES = ("episode", "steps", "return", "epsilon", "change", "error")
"""The columns of a learning curve: episodes and transitions so far, the mean return of the episodes that were looked
at since the point before, epsilon, the largest change of a value from one look to the next since then, and the largest
|learned - exact| of the start state's gamma-space as a share of the range of the exact one."""


@dataclass(frozen=True, eq=False)
class PeerTables:
    """The other codes of the return, learned from the same transitions under the same policy; N seeds first.

    Attributes:
        laplace_values: what the Laplace code itself says of the return at ``peer_gamma``, its mean, ``(N, S, A)``.
        plain: plain Q, ``(N, S, A)``.
        categorical: masses on ``atoms``, ``(N, S, A, atoms)``.
        quantile: equally heavy locations, ``(N, S, A, quantiles)``.
        expectile: expectiles at the levels i / (count + 1), ``(N, S, A, expectiles)``.
        low, high: bounds of any return of the world at ``peer_gamma``; the atoms lie between them.
    """

    laplace_values: np.ndarray
    plain: np.ndarray
    categorical: np.ndarray
    quantile: np.ndarray
    expectile: np.ndarray
    low: float
    high: float

    @property
    def atoms(self) -> np.ndarray:
        return np.linspace(self.low, self.high, self.categorical.shape[-1])


@dataclass(frozen=True, eq=False)
class Learned:
    """N learners of one world, at some point of their learning.

    Attributes:
        settings: resolved.
        basis: W, expected discounted counts of each reward, float32 ``(N, S, A, G, V)``.
        acting_values: expected return at ``acting_gamma``, float64 ``(N, S, A)``.
        curves: one mapping a seed, from ``CURVE_NAMES`` to float64 ``(E,)``.
        finished: whether all episodes were learned.
        peers: None if only the Laplace code was learned.
    """

    world: World
    settings: ResolvedLearning
    basis: np.ndarray
    acting_values: np.ndarray
    curves: tuple[Mapping[str, np.ndarray], ...]
    finished: bool
    peers: PeerTables | None = None

    @property
    def gammas(self) -> np.ndarray:
        return self.settings.discounts

    @property
    def seeds(self) -> tuple[int, ...]:
        return tuple(self.settings.seed + i for i in range(self.settings.seeds))

    @property
    def episodes(self) -> tuple[int, ...]:
        """Episodes learned by each seed."""
        return tuple(int(curve["episode"][-1]) if curve["episode"].size else 0 for curve in self.curves)

    @property
    def policies(self) -> np.ndarray:
        """Greedy policy of each learner at ``acting_gamma``, int ``(N, S)``."""
        return greedy_action(self.acting_values)

    def seed_index(self, index: int) -> int:
        """The index of a learner, checked.

        Raises:
            InputError: there is no such learner.
        """
        if not 0 <= index < len(self.basis):
            raise InputError(f"seed_index {index} is not there: use 0 to {len(self.basis) - 1}.")
        return index
