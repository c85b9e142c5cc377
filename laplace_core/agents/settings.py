"""Every choice behind a trained agent, as one frozen, typed object per algorithm.

The command line, the settings files, the run folders and the checkpoints all read and write these through the one
schema of each class.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from difflib import get_close_matches
from typing import ClassVar

import numpy as np

from laplace_core.encoding import GAMMA_SPACINGS, PAPER_GAMMAS, discount_grid, sensitivity_grid
from laplace_core.errors import InputError
from laplace_core.parameters import Parameter, parse_named
from laplace_core.worlds import PRESETS, TOY_TEXT

GYMNASIUM_ENVIRONMENTS = ("CartPole-v1", "Acrobot-v1", "LunarLander-v3", "MountainCar-v0", "CartPole-v0")
"""What gymnasium brings along with discrete actions and numbers, not pixels, as observations."""
ENVIRONMENTS = (*GYMNASIUM_ENVIRONMENTS, *PRESETS, *(f"gym:{name}" for name in TOY_TEXT))
"""Every environment that can be trained on and that a checkpoint may name: no others are ever built."""

NETWORKS = ("trunk", "network", "multiplexer")
PARAMETRISATIONS = ("softmax", "accumulated", "clipped", "free")
POLICIES = ("shared", "per_gamma")
TERMINATIONS = ("plain", "auxiliary", "absorbing")
EXPERIENCES = ("shared", "per_discount")
AGENT_THETA_SPACINGS = ("uniform", "asinh")
SLOPE_TIMES_SPACING = 2.35
"""Default slope in units of 1/spacing, as in :mod:`laplace_core.settings`."""

LOOP_SCHEMA = (
    Parameter("environment", "CartPole-v1", 0, 0, "What is trained on.", str, ENVIRONMENTS),
    Parameter("seed", 0, 0, 10**6, "Decides everything random: the same seed gives the same metrics."),
    Parameter("steps", 60_000, 1, 10**9, "Transitions to learn from."),
    Parameter("envs", 4, 1, 64, "Environments stepped side by side, where experience is shared."),
    Parameter("buffer", 50_000, 100, 10**6, "Transitions that the replay buffer keeps."),
    Parameter("batch", 128, 1, 4096, "Transitions in one update."),
    Parameter("learning_starts", 1_000, 1, 10**6, "Transitions gathered before the first update."),
    Parameter("update_every", 8, 1, 10**5, "Transitions between two rounds of updates."),
    Parameter("updates", 4, 1, 1000, "Updates in one round."),
    Parameter("learning_rate", 1e-3, 1e-7, 1, "Step size of Adam at the start."),
    Parameter("learning_rate_final", 0.1, 0, 1, "Step size at the end, as a fraction of the first; linear in between."),
    Parameter("averaging", 0.005, 1e-5, 1, "How far the target network moves towards the online one at every update."),
    Parameter("epsilon_first", 1.0, 0, 1, "Chance of a random action at the start."),
    Parameter("epsilon_final", 0.05, 0, 1, "Chance of a random action after exploration has faded."),
    Parameter("exploration", 0.2, 0, 1, "Fraction of the steps over which that chance falls, linearly."),
    Parameter("hidden", 256, 1, 1024, "Units in each of the two hidden layers."),
    Parameter("double", True, 0, 1, "The online network chooses the next action, the target network values it."),
    Parameter("dueling", False, 0, 1, "Separate streams for the state and for the advantage of each action."),
    Parameter("n_step", 1, 1, 20, "Rewards in a target before it bootstraps."),
    Parameter("prioritised", False, 0, 1, "Replay transitions in proportion to a power of their last loss."),
    Parameter("priority_exponent", 0.6, 0, 1, "That power; 0 is uniform."),
    Parameter("priority_correction", 0.4, 0, 1, "Importance correction at the start; it rises to 1 at the end."),
    Parameter("gradient_clip", 10.0, 1e-6, 1e6, "Largest norm of a gradient."),
    Parameter("evaluate_every", 5_000, 1, 10**9, "Transitions between two evaluations."),
    Parameter("evaluate_episodes", 20, 1, 1000, "Episodes in each of them."),
    Parameter("checkpoint_every", 10_000, 1, 10**9, "Transitions between two resume points."),
    Parameter("threads", 1, 1, 64, "Threads of torch; another number may change the last digits."),
)
LAPLACE_SCHEMA = (
    *LOOP_SCHEMA,
    Parameter("gammas", 15, 1, 100, "Number of discounts; a single one is gamma_max."),
    Parameter("spacing", "log", 0, 0, "How the discounts are spaced.", str, GAMMA_SPACINGS),
    Parameter("gamma_min", 0.3678794412, 1e-6, 0.9999, "Smallest discount."),
    Parameter("gamma_max", 0.99, 1e-6, 0.9999, "Largest discount."),
    Parameter("thetas", 13, 2, 1000, "Number of reward sensitivities."),
    Parameter("theta_spacing", "uniform", 0, 0, "How the sensitivities are spaced.", str, AGENT_THETA_SPACINGS),
    Parameter("theta_min", -1.0, -1e6, 1e6, "Smallest sensitivity, in reward."),
    Parameter("theta_max", 2.0, -1e6, 1e6, "Largest sensitivity, in reward."),
    Parameter("slope_times_spacing", SLOPE_TIMES_SPACING, 0.1, 100, "Steepness of the activation, in 1/spacing."),
    Parameter("network", "trunk", 0, 0, "How discounts share weights.", str, NETWORKS),
    Parameter("features", 64, 1, 512, "Features a discount in front of the shared last layer."),
    Parameter("parametrisation", "softmax", 0, 0, "What the network's outputs mean.", str, PARAMETRISATIONS),
    Parameter("consistency", 1.0, 0, 1e3, "Weight of the loss on the value that the outputs imply."),
    Parameter("target_policy", "shared", 0, 0, "Whose policy every discount evaluates.", str, POLICIES),
    Parameter("acting_gamma", 0.99, 1e-6, 0.9999, "Discount whose greedy actions are taken; the nearest is used."),
    Parameter("termination", "plain", 0, 0, "What follows the end of an episode.", str, TERMINATIONS),
    Parameter("experience", "shared", 0, 0, "Whether the discounts share one buffer.", str, EXPERIENCES),
    Parameter("head_exploration", 0.2, 0, 1, "Fraction of episodes that a random discount or time to go behaves in."),
)
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
class LoopSettings:
    """What every algorithm has; see ``LOOP_SCHEMA`` for the meaning and range of each."""

    environment: str = "CartPole-v1"
    seed: int = 0
    steps: int = 60_000
    envs: int = 4
    buffer: int = 50_000
    batch: int = 128
    learning_starts: int = 1_000
    update_every: int = 8
    updates: int = 4
    learning_rate: float = 1e-3
    learning_rate_final: float = 0.1
    averaging: float = 0.005
    epsilon_first: float = 1.0
    epsilon_final: float = 0.05
    exploration: float = 0.2
    hidden: int = 256
    double: bool = True
    dueling: bool = False
    n_step: int = 1
    prioritised: bool = False
    priority_exponent: float = 0.6
    priority_correction: float = 0.4
    gradient_clip: float = 10.0
    evaluate_every: int = 5_000
    evaluate_episodes: int = 20
    checkpoint_every: int = 10_000
    threads: int = 1

    ALGORITHM: ClassVar[str]
    SCHEMA: ClassVar[tuple[Parameter, ...]] = LOOP_SCHEMA

    def __post_init__(self):
        # Whatever they come from, values meet the ranges of the schema and have its types.
        given = {field.name: getattr(self, field.name) for field in fields(self)}
        for name, value in parse_named(self.ALGORITHM, self.SCHEMA, given).items():
            object.__setattr__(self, name, value)
        self.check()

    def check(self) -> None:
        """Refuse settings that do not fit each other.

        Raises:
            InputError: with the names of the settings at fault.
        """
        if self.epsilon_final > self.epsilon_first:
            raise InputError("epsilon_final must not exceed epsilon_first.")
        if self.learning_starts > self.buffer:
            raise InputError("learning_starts must not exceed the buffer.")

    @property
    def rings(self) -> int:
        """Environments, and rings in the replay buffer."""
        return self.envs

    def as_dict(self) -> dict[str, bool | int | float | str]:
        return asdict(self)

    @classmethod
    def parse(cls, given: Mapping[str, object]) -> LoopSettings:
        """From values by name, as text or typed; what is missing has its default.

        Raises:
            InputError: a name or a value that does not fit the schema.
        """
        known = {parameter.name for parameter in cls.SCHEMA}
        for name in given:
            if name not in known:
                near = get_close_matches(str(name), known, 1)
                hint = f"; the nearest is {near[0]}" if near else ""
                raise InputError(f"{cls.ALGORITHM} has no setting {str(name)[:40]!r}{hint}.")
        return cls(**parse_named(cls.ALGORITHM, cls.SCHEMA, dict(given)))


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
    slope_times_spacing: float = SLOPE_TIMES_SPACING
    network: str = "trunk"
    features: int = 64
    parametrisation: str = "softmax"
    consistency: float = 1.0
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
        sensitivity_grid(self.thetas, self.theta_min, self.theta_max, self.theta_spacing)
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
    def rings(self) -> int:
        return self.n_discounts if self.experience == "per_discount" else self.envs


@dataclass(frozen=True)
class DqnSettings(LoopSettings):
    """Settings of DQN, and what all peers have; see ``PEER_SCHEMA``."""

    gamma: float = 0.99

    ALGORITHM: ClassVar[str] = "dqn"
    SCHEMA: ClassVar[tuple[Parameter, ...]] = PEER_SCHEMA


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
        if self.v_min >= self.v_max:
            raise InputError("v_min must be below v_max.")


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


SETTINGS: dict[str, type[LoopSettings]] = {
    kind.ALGORITHM: kind
    for kind in (LaplaceSettings, C51Settings, QrdqnSettings, ExpectileSettings, DqnSettings, FixedHorizonSettings)
}
"""The settings of every algorithm, by the name that commands, files and checkpoints give it."""
