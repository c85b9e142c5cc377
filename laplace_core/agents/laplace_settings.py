"""Settings of Laplace DQN."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from laplace_core.agents.loop_settings import LoopSettings, exploring_heads
from laplace_core.code.encoding import (
    GAMMA_SPACINGS,
    PAPER_GAMMAS,
    THETA_SCALE_HELP,
    THETA_SPACINGS,
    discount_grid,
    sensitivity_grid,
)
from laplace_core.errors import InputError
from laplace_core.parameters import choice, setting
from laplace_core.planning import TARGET_POLICIES
from laplace_core.study.settings import SLOPE_TIMES_SPACING, Settings, resolve
from laplace_core.worlds import load_world

NETWORKS = ("trunk", "network", "multiplexer")
PARAMETRISATIONS = ("softmax", "accumulated", "clipped", "free")
TERMINATIONS = ("plain", "auxiliary", "absorbing")
EXPERIENCES = ("shared", "per_discount")


@dataclass(frozen=True)
class LaplaceSettings(LoopSettings):
    """Settings of Laplace DQN."""

    gammas: int = setting(15, 1, 100, "Number of discounts; a single one is gamma_max.")
    spacing: str = choice("log", GAMMA_SPACINGS, "Spacing of the discounts.")
    gamma_min: float = setting(0.3678794412, 1e-6, 0.9999, "Smallest discount.")
    gamma_max: float = setting(0.99, 1e-6, 0.9999, "Largest discount.")
    thetas: int = setting(13, 2, 1000, "Number of reward sensitivities.")
    theta_spacing: str = choice("uniform", THETA_SPACINGS, "Spacing of the sensitivities.")
    theta_min: float = setting(-1.0, -1e6, 1e6, "Smallest sensitivity, in reward.")
    theta_max: float = setting(2.0, -1e6, 1e6, "Largest sensitivity, in reward.")
    theta_scale: float = setting(0.0, 0, 1e6, THETA_SCALE_HELP)
    slope_times_spacing: float = setting(SLOPE_TIMES_SPACING, 0.1, 100, "Steepness of the activation, in 1/spacing.")
    network: str = choice("trunk", NETWORKS, "Network: how discounts share weights.")
    features: int = setting(64, 1, 512, "Features of each discount before the shared last layer.")
    parametrisation: str = choice("softmax", PARAMETRISATIONS, "Meaning of the network's outputs.")
    consistency: float = setting(1.0, 0, 1e3, "Weight of the loss on the value that the outputs imply.")
    consistency_exponent: float = setting(
        1.0, 0, 2, "Power of 1 - gamma that weighs the consistency loss of a discount."
    )
    acting_share: float = setting(0.0, 0, 1, "Share of the acting discount in the loss; 0 weighs all alike.")
    target_policy: str = choice("shared", TARGET_POLICIES, "Policy that every discount evaluates.")
    acting_gamma: float = setting(0.99, 1e-6, 0.9999, "Discount whose greedy actions are taken; the nearest is used.")
    termination: str = choice("plain", TERMINATIONS, "What follows the end of an episode.")
    experience: str = choice("shared", EXPERIENCES, "Whether the discounts share one buffer.")
    head_exploration: float = exploring_heads()

    ALGORITHM: ClassVar[str] = "laplace"
    TITLE: ClassVar[str] = "Laplace DQN"

    def check(self) -> None:
        super().check()
        self.discounts()
        sensitivity_grid(self.thetas, self.theta_min, self.theta_max, self.theta_spacing, self.theta_scale or None)
        if self.prioritised and self.experience == "per_discount":
            raise InputError("prioritised replay needs shared experience.")
        if self.theta_min >= 0 or self.theta_max <= 0:
            raise InputError("the sensitivities must reach beyond reward 0 on both sides: theta_min < 0 < theta_max.")

    def describe(self) -> str:
        grid = f"{self.n_discounts} discounts to {self.gamma_max:g}, {self.thetas} sensitivities"
        return f"{grid}, {self.network}, {self.parametrisation}"

    def ignored(self) -> dict[str, str]:
        ignored = super().ignored()
        if self.consistency == 0:
            ignored["consistency_exponent"] = "at consistency 0"
        if self.theta_spacing == "uniform":
            ignored["theta_scale"] = "beside theta_spacing=uniform"
        if self.own_experience:
            ignored["envs"] = "where every discount has an environment of its own (experience=per_discount)"
        if self.spacing == "paper":
            paper = {"gammas": len(PAPER_GAMMAS), "gamma_min": PAPER_GAMMAS[0], "gamma_max": PAPER_GAMMAS[-1]}
            differ = [name for name, value in paper.items() if getattr(self, name) != value]
            ignored |= dict.fromkeys(differ, "beside spacing=paper, which has its own fifteen discounts")
        elif self.gammas == 1:
            ignored |= dict.fromkeys(
                ("spacing", "gamma_min", "acting_gamma"), "for a single discount, which is gamma_max"
            )
        return ignored

    @classmethod
    def suited_to(cls, world: str) -> dict[str, Any]:
        """Sensitivities that reach beyond the world's rewards."""
        suited = resolve(Settings(world=world), load_world(world))
        low, high = min(suited.theta_min, -0.5), max(suited.theta_max, 0.5)
        return super().suited_to(world) | {"theta_min": low, "theta_max": high, "thetas": 41, "consistency": 0.0}

    def discounts(self) -> np.ndarray:
        """The discount grid, ``(G,)``."""
        if self.n_discounts == 1:
            return np.array([self.gamma_max])
        return discount_grid(self.gammas, self.spacing, self.gamma_min, self.gamma_max)

    @property
    def n_discounts(self) -> int:
        return len(PAPER_GAMMAS) if self.spacing == "paper" else self.gammas

    @property
    def own_experience(self) -> bool:
        return self.experience == "per_discount"

    @property
    def rings(self) -> int:
        return self.n_discounts if self.own_experience else self.envs
