"""Settings of the peers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from laplace_core.agents.loop_settings import LOOP_SCHEMA, LoopSettings
from laplace_core.errors import InputError
from laplace_core.parameters import Parameter

PEER_SCHEMA = (
    *LOOP_SCHEMA,
    Parameter("gamma", 0.99, 1e-6, 0.9999, "Discount of the return."),
)
C51_SCHEMA = (
    *PEER_SCHEMA,
    Parameter("atoms", 51, 2, 1000, "Number of returns that carry probability."),
    Parameter("v_min", -100.0, -1e6, 1e6, "Smallest of them, in discounted reward."),
    Parameter("v_max", 100.0, -1e6, 1e6, "Largest of them, in discounted reward."),
)
QRDQN_SCHEMA = (
    *PEER_SCHEMA,
    Parameter("quantiles", 51, 1, 1000, "Number of quantiles of the return."),
)
EXPECTILE_SCHEMA = (
    *PEER_SCHEMA,
    Parameter("expectiles", 11, 3, 101, "Number of expectiles of the return, an odd one."),
)
FIXED_HORIZON_SCHEMA = (
    *PEER_SCHEMA,
    Parameter("horizon", 200, 1, 1000, "Longest time to go that is learned, in steps."),
    Parameter("times", 4, 1, 100, "Random times to go that each transition teaches in one update."),
    Parameter("head_exploration", 0.2, 0, 1, "Fraction of episodes that a random discount or time to go behaves in."),
)


@dataclass(frozen=True)
class DqnSettings(LoopSettings):
    """Settings of DQN, and what all peers have; see ``PEER_SCHEMA``."""

    gamma: float = 0.99

    ALGORITHM: ClassVar[str] = "dqn"
    SCHEMA: ClassVar[tuple[Parameter, ...]] = PEER_SCHEMA

    def discounts(self) -> np.ndarray:
        return np.array([self.gamma])


@dataclass(frozen=True)
class C51Settings(DqnSettings):
    """Settings of C51; see ``C51_SCHEMA``."""

    atoms: int = 51
    v_min: float = -100.0
    v_max: float = 100.0

    ALGORITHM: ClassVar[str] = "c51"
    SCHEMA: ClassVar[tuple[Parameter, ...]] = C51_SCHEMA

    def check(self) -> None:
        super().check()
        # Closer than this, neighbouring atoms are the same in single precision.
        least = 1e-5 * max(1.0, abs(self.v_min), abs(self.v_max))
        if (self.v_max - self.v_min) / (self.atoms - 1) < least:
            raise InputError(f"v_min must be below v_max, and neighbouring atoms at least {least:g} apart.")


@dataclass(frozen=True)
class QrdqnSettings(DqnSettings):
    """Settings of QR-DQN; see ``QRDQN_SCHEMA``."""

    quantiles: int = 51

    ALGORITHM: ClassVar[str] = "qrdqn"
    SCHEMA: ClassVar[tuple[Parameter, ...]] = QRDQN_SCHEMA


@dataclass(frozen=True)
class ExpectileSettings(DqnSettings):
    """Settings of expectile DQN; see ``EXPECTILE_SCHEMA``."""

    expectiles: int = 11

    ALGORITHM: ClassVar[str] = "expectile"
    SCHEMA: ClassVar[tuple[Parameter, ...]] = EXPECTILE_SCHEMA

    def check(self) -> None:
        super().check()
        if self.expectiles % 2 == 0:
            raise InputError("expectiles must be odd: the middle one is the mean.")


@dataclass(frozen=True)
class FixedHorizonSettings(DqnSettings):
    """Settings of fixed-horizon DQN; see ``FIXED_HORIZON_SCHEMA``."""

    horizon: int = 200
    times: int = 4
    head_exploration: float = 0.2

    ALGORITHM: ClassVar[str] = "fixed_horizon"
    SCHEMA: ClassVar[tuple[Parameter, ...]] = FIXED_HORIZON_SCHEMA

    def discounts(self) -> np.ndarray:
        """None: the returns that it values end with the time to go."""
        return np.zeros(0)
