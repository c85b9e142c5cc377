"""Settings that every algorithm has: the environment, the loop, the replay buffer and the optimiser."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from difflib import get_close_matches
from typing import Any, ClassVar

import numpy as np

from laplace_core.errors import InputError
from laplace_core.parameters import Parameter, parse_named
from laplace_core.worlds import PRESETS, TOY_TEXT

GYMNASIUM_ENVIRONMENTS = ("CartPole-v1", "Acrobot-v1", "LunarLander-v3", "MountainCar-v0", "CartPole-v0")
"""What gymnasium brings along with discrete actions and numbers, not pixels, as observations."""
ENVIRONMENTS = (*GYMNASIUM_ENVIRONMENTS, *PRESETS, *(f"gym:{name}" for name in TOY_TEXT))
"""Every environment that can be trained on and that a checkpoint may name: no others are ever built."""

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

    def __post_init__(self) -> None:
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
    def own_experience(self) -> bool:
        """Whether every discount learns from a buffer of its own."""
        return False

    @property
    def head_exploration(self) -> float:
        """Fraction of episodes that a random head behaves in; 0 where there is one head only."""
        return 0.0

    @property
    def rings(self) -> int:
        """Environments, and rings in the replay buffer."""
        return self.envs

    def discounts(self) -> np.ndarray:
        """Of the returns to the end of an episode that the heads value, ``(heads,)``; none where they value others."""
        return np.zeros(0)

    def as_dict(self) -> dict[str, bool | int | float | str]:
        return asdict(self)

    @classmethod
    def parse(cls, given: Mapping[str, Any]) -> LoopSettings:
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
        parsed: dict[str, Any] = dict(parse_named(cls.ALGORITHM, cls.SCHEMA, dict(given)))
        return cls(**parsed)
