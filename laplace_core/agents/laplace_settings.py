"""Settings of Laplace DQN."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from laplace_core.agents.loop_settings import LOOP_SCHEMA, LoopSettings
from laplace_core.encoding import (
    GAMMA_SPACINGS,
    PAPER_GAMMAS,
    THETA_SCALE_HELP,
    THETA_SPACINGS,
    discount_grid,
    sensitivity_grid,
)
from laplace_core.errors import InputError
from laplace_core.parameters import Parameter

NETWORKS = ("trunk", "network", "multiplexer")
PARAMETRISATIONS = ("softmax", "accumulated", "clipped", "free")
POLICIES = ("shared", "per_gamma")
TERMINATIONS = ("plain", "auxiliary", "absorbing")
EXPERIENCES = ("shared", "per_discount")
SLOPE_TIMES_SPACING = 2.35
"""Default slope in units of 1/spacing, as in :mod:`laplace_core.settings`."""

LAPLACE_SCHEMA = (
    *LOOP_SCHEMA,
    Parameter("gammas", 15, 1, 100, "Number of discounts; a single one is gamma_max."),
    Parameter("spacing", "log", 0, 0, "How the discounts are spaced.", str, GAMMA_SPACINGS),
    Parameter("gamma_min", 0.3678794412, 1e-6, 0.9999, "Smallest discount."),
    Parameter("gamma_max", 0.99, 1e-6, 0.9999, "Largest discount."),
    Parameter("thetas", 13, 2, 1000, "Number of reward sensitivities."),
    Parameter("theta_spacing", "uniform", 0, 0, "How the sensitivities are spaced.", str, THETA_SPACINGS),
    Parameter("theta_min", -1.0, -1e6, 1e6, "Smallest sensitivity, in reward."),
    Parameter("theta_max", 2.0, -1e6, 1e6, "Largest sensitivity, in reward."),
    Parameter("theta_scale", 0.0, 0, 1e6, THETA_SCALE_HELP),
    Parameter("slope_times_spacing", SLOPE_TIMES_SPACING, 0.1, 100, "Steepness of the activation, in 1/spacing."),
    Parameter("network", "trunk", 0, 0, "How discounts share weights.", str, NETWORKS),
    Parameter("features", 64, 1, 512, "Features a discount in front of the shared last layer."),
    Parameter("parametrisation", "softmax", 0, 0, "What the network's outputs mean.", str, PARAMETRISATIONS),
    Parameter("consistency", 1.0, 0, 1e3, "Weight of the loss on the value that the outputs imply."),
    Parameter("consistency_exponent", 1.0, 0, 2, "Power of 1 - gamma that weighs the consistency loss of a discount."),
    Parameter("acting_share", 0.0, 0, 1, "Share of the acting discount in the loss; 0 is the same as the others'."),
    Parameter("target_policy", "shared", 0, 0, "Whose policy every discount evaluates.", str, POLICIES),
    Parameter("acting_gamma", 0.99, 1e-6, 0.9999, "Discount whose greedy actions are taken; the nearest is used."),
    Parameter("termination", "plain", 0, 0, "What follows the end of an episode.", str, TERMINATIONS),
    Parameter("experience", "shared", 0, 0, "Whether the discounts share one buffer.", str, EXPERIENCES),
    Parameter("head_exploration", 0.2, 0, 1, "Fraction of episodes that a random discount or time to go behaves in."),
)


@dataclass(frozen=True)
class LaplaceSettings(LoopSettings):
    """Settings of Laplace DQN; see ``LAPLACE_SCHEMA``."""

    gammas: int = 15
    spacing: str = "log"
    gamma_min: float = 0.3678794412
    gamma_max: float = 0.99
    thetas: int = 13
    theta_spacing: str = "uniform"
    theta_min: float = -1.0
    theta_max: float = 2.0
    theta_scale: float = 0.0
    slope_times_spacing: float = SLOPE_TIMES_SPACING
    network: str = "trunk"
    features: int = 64
    parametrisation: str = "softmax"
    consistency: float = 1.0
    consistency_exponent: float = 1.0
    acting_share: float = 0.0
    target_policy: str = "shared"
    acting_gamma: float = 0.99
    termination: str = "plain"
    experience: str = "shared"
    head_exploration: float = 0.2

    ALGORITHM: ClassVar[str] = "laplace"
    SCHEMA: ClassVar[tuple[Parameter, ...]] = LAPLACE_SCHEMA

    def check(self) -> None:
        super().check()
        self.discounts()
        sensitivity_grid(self.thetas, self.theta_min, self.theta_max, self.theta_spacing, self.theta_scale or None)
        if self.prioritised and self.experience == "per_discount":
            raise InputError("prioritised replay needs shared experience.")
        if self.theta_min >= 0 or self.theta_max <= 0:
            raise InputError("the sensitivities must reach beyond reward 0 on both sides: theta_min < 0 < theta_max.")

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
