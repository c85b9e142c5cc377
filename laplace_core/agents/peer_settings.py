"""Settings and names of the peers; :data:`PEERS` lists them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from laplace_core.agents.loop_settings import LoopSettings, exploring_heads
from laplace_core.errors import InputError
from laplace_core.parameters import setting
from laplace_core.study.pipeline import policies_of
from laplace_core.tabular.returns import return_bounds
from laplace_core.worlds import load_world


@dataclass(frozen=True)
class DqnSettings(LoopSettings):
    """Settings of DQN, which all peers have as well."""

    gamma: float = setting(0.99, 1e-6, 0.9999, "Discount of the return.")

    ALGORITHM: ClassVar[str] = "dqn"
    TITLE: ClassVar[str] = "DQN"

    def describe(self) -> str:
        return f"{self.numbers()}, discount {self.gamma:g}"

    def numbers(self) -> str:
        """The outputs of an action, but for their discount."""
        return "the mean return"

    def discounts(self) -> np.ndarray:
        return np.array([self.gamma])


@dataclass(frozen=True)
class C51Settings(DqnSettings):
    """Settings of C51."""

    atoms: int = setting(51, 2, 1000, "Number of returns that carry probability.")
    v_min: float = setting(-100.0, -1e6, 1e6, "Smallest of these returns, in discounted reward.")
    v_max: float = setting(100.0, -1e6, 1e6, "Largest of these returns, in discounted reward.")

    ALGORITHM: ClassVar[str] = "c51"
    TITLE: ClassVar[str] = "C51"

    def numbers(self) -> str:
        return f"{self.atoms} atoms from {self.v_min:g} to {self.v_max:g}"

    @classmethod
    def suited_to(cls, world: str) -> dict[str, Any]:
        """Atoms that reach beyond the best returns of the world."""
        built, gamma = load_world(world), cls().gamma
        (policy,) = policies_of(built, np.array([gamma]), "shared", gamma)
        low, high = return_bounds(built, policy, gamma)
        return super().suited_to(world) | {"v_min": low, "v_max": high}

    def check(self) -> None:
        super().check()
        # Closer than this, neighbouring atoms are the same in single precision.
        least = 1e-5 * max(1.0, abs(self.v_min), abs(self.v_max))
        if (self.v_max - self.v_min) / (self.atoms - 1) < least:
            raise InputError(f"v_min must be below v_max, and neighbouring atoms at least {least:g} apart.")


@dataclass(frozen=True)
class QrdqnSettings(DqnSettings):
    """Settings of QR-DQN."""

    quantiles: int = setting(51, 1, 1000, "Number of quantiles of the return.")

    ALGORITHM: ClassVar[str] = "qrdqn"
    TITLE: ClassVar[str] = "QR-DQN"

    def numbers(self) -> str:
        return f"{self.quantiles} quantiles"


@dataclass(frozen=True)
class ExpectileSettings(DqnSettings):
    """Settings of expectile DQN."""

    expectiles: int = setting(11, 3, 101, "Number of expectiles of the return, an odd one.")

    ALGORITHM: ClassVar[str] = "expectile"
    TITLE: ClassVar[str] = "Expectile DQN"
    RETURN_LAW: ClassVar[str] = "imputed"

    def numbers(self) -> str:
        return f"{self.expectiles} expectiles"

    def check(self) -> None:
        super().check()
        if self.expectiles % 2 == 0:
            raise InputError("expectiles must be odd: the middle one is the mean.")


@dataclass(frozen=True)
class FixedHorizonSettings(DqnSettings):
    """Settings of fixed-horizon DQN."""

    horizon: int = setting(200, 1, 1000, "Longest time to go that is learned, in steps.")
    times: int = setting(4, 1, 100, "Random times to go that each transition teaches in one update.")
    head_exploration: float = exploring_heads()

    ALGORITHM: ClassVar[str] = "fixed_horizon"
    TITLE: ClassVar[str] = "Fixed-horizon DQN"

    def numbers(self) -> str:
        return f"a mean for every T to {self.horizon}"

    def discounts(self) -> np.ndarray:
        """None: the returns that it values end with the time to go."""
        return np.zeros(0)


PEERS: tuple[type[LoopSettings], ...] = (
    C51Settings, QrdqnSettings, ExpectileSettings, DqnSettings, FixedHorizonSettings,
)  # fmt: skip
"""In the order in which forms and pictures list them."""
