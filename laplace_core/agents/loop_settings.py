"""Settings that every algorithm has: the environment, the loop, the replay buffer and the optimiser.

The class of an algorithm's settings also says, once, what the algorithm is called and what its outputs are: the
command line, the pages and the pictures take these words from here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from difflib import get_close_matches
from typing import Any, ClassVar

import numpy as np

from laplace_core.environments import ENVIRONMENTS
from laplace_core.errors import InputError
from laplace_core.parameters import Schema, choice, parse_named, schema_of, setting, switch


@dataclass(frozen=True)
class LoopSettings:
    """The settings that every algorithm has."""

    environment: str = choice("CartPole-v1", ENVIRONMENTS, "Environment of the training.")
    seed: int = setting(0, 0, 10**6, "Seed of everything random: the same seed gives the same metrics.")
    steps: int = setting(60_000, 1, 10**9, "Transitions to learn from.")
    envs: int = setting(4, 1, 64, "Environments stepped side by side, where experience is shared.")
    buffer: int = setting(50_000, 100, 10**6, "Transitions that the replay buffer keeps.")
    batch: int = setting(128, 1, 4096, "Transitions in one update.")
    learning_starts: int = setting(1_000, 1, 10**6, "Transitions gathered before the first update.")
    update_every: int = setting(8, 1, 10**5, "Transitions between two rounds of updates.")
    updates: int = setting(4, 1, 1000, "Updates in one round.")
    learning_rate: float = setting(1e-3, 1e-7, 1, "Step size of Adam at the start.")
    learning_rate_final: float = setting(
        0.1, 0, 1, "Step size at the end, as a fraction of the first; linear in between."
    )
    averaging: float = setting(
        0.005, 1e-5, 1, "How far the target network moves towards the online one at every update."
    )
    epsilon_first: float = setting(1.0, 0, 1, "Chance of a random action at the start.")
    epsilon_final: float = setting(0.05, 0, 1, "Chance of a random action after exploration has faded.")
    exploration: float = setting(0.2, 0, 1, "Fraction of the steps over which exploration falls linearly.")
    hidden: int = setting(256, 1, 1024, "Units in each of the two hidden layers.")
    double: bool = switch("The online network chooses the next action, the target network values it.", default=True)
    dueling: bool = switch("Separate streams for the state and for the advantage of each action.", default=False)
    n_step: int = setting(1, 1, 20, "Rewards in a target before it bootstraps.")
    prioritised: bool = switch("Replay transitions in proportion to a power of their last loss.", default=False)
    priority_exponent: float = setting(0.6, 0, 1, "Power of the loss in prioritised replay; 0 is uniform.")
    priority_correction: float = setting(0.4, 0, 1, "Importance correction at the start; it rises to 1 at the end.")
    gradient_clip: float = setting(10.0, 1e-6, 1e6, "Largest norm of a gradient.")
    evaluate_every: int = setting(5_000, 1, 10**9, "Transitions between two evaluations.")
    evaluate_episodes: int = setting(20, 1, 1000, "Episodes in each evaluation.")
    checkpoint_every: int = setting(10_000, 1, 10**9, "Transitions between two resume points.")
    threads: int = setting(1, 1, 64, "Threads of torch; another number may change the last digits.")

    ALGORITHM: ClassVar[str]
    """The name that commands, files and checkpoints give the algorithm."""
    TITLE: ClassVar[str]
    """The name that people call it by."""
    RETURN_LAW: ClassVar[str] = ""
    """How a distribution of the return is derived from its outputs, as a label; empty where they are one."""
    SCHEMA = Schema()  # no annotation: a dataclass would ask for its value before there are fields
    """The parameters of each class, those of every algorithm first."""

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

    def describe(self) -> str:
        """The outputs of the network for an action, in a few words."""
        return "the value of every action"

    def ignored(self) -> dict[str, str]:
        """Settings that the others make meaningless, by name, each with the condition under which it is ignored."""
        ignored: dict[str, str] = {}
        if not self.prioritised:
            ignored |= dict.fromkeys(("priority_exponent", "priority_correction"), "without prioritised=true")
        if self.epsilon_first == self.epsilon_final:
            ignored["exploration"] = "where epsilon_first and epsilon_final are the same"
        return ignored

    @classmethod
    def suited_to(cls, world: str) -> dict[str, Any]:
        """Settings, by name, that suit a tabular world for which there is no file; the others have their defaults."""
        return {"epsilon_final": 0.2}

    @property
    def own_experience(self) -> bool:
        """Whether every discount learns from its own buffer."""
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
        """Discounts of the heads' returns to the end of an episode, ``(heads,)``; empty where they value others."""
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


LOOP_SCHEMA = schema_of(LoopSettings)
"""The parameters that every algorithm has."""


def exploring_heads() -> Any:
    """A setting of the algorithms that value many discounts or times to go."""
    return setting(0.2, 0, 1, "Fraction of episodes that are acted with a random discount or time to go.")
