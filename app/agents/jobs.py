"""Work of the page of trained agents that takes seconds: rollouts, their artefacts, and simulations from their states.

Each kind has one shelf for all sessions of this server.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field, replace

import numpy as np

from app.components.player.payload import payload
from app.session.background import Progress, Work
from app.session.shelf import Job, Shelf
from app.view.subjects import View
from laplace_core.acting.continuations import Continuations, Outcomes, continue_from, outcomes_of_states
from laplace_core.acting.flags import Flags, flag_steps
from laplace_core.acting.return_laws import SimulatedReturns, outputs_along, simulate_returns
from laplace_core.acting.rollout import Rollout, roll_out
from laplace_core.environments import GYMNASIUM_ENVIRONMENTS, vector
from laplace_core.training.checkpoint import Loaded

MOST_KEPT, MOST_BYTES = 16, 200_000_000
"""Rollouts, and their memory together; the one that is asked for stays whatever its size, some 90 MB at the most."""
COUNT, EPISODES, EACH, STEPS = 100, 20, 10, 200
"""Of truths: continuations of a state; or episodes, and states of each; and how many steps follow."""


@dataclass(frozen=True)
class Control:
    """How an episode is acted; see :func:`laplace_core.acting.rollout.roll_out`."""

    seed: int = 0
    rule: str = "greedy"
    horizon: int | None = None
    gamma: float | None = None


@dataclass(frozen=True, eq=False)
class RolledOut:
    """One rollout.

    Attributes:
        packed: the same for the player.
        along: outputs of a peer along it, from :func:`laplace_core.acting.return_laws.outputs_along`.
        artefacts: searches in it, of some kilobytes each, which go when it goes.
    """

    rollout: Rollout
    packed: bytes
    along: dict[str, np.ndarray]
    artefacts: Shelf[Flags] = field(default_factory=lambda: Shelf(8))

    @property
    def bytes(self) -> int:
        """Memory that it holds."""
        return self.rollout.bytes + len(self.packed) + sum(array.nbytes for array in self.along.values())


Rolling = Work[RolledOut]


def _too_large(kept: list[Rolling]) -> bool:
    return sum(one.result().bytes for one in kept if one.worked) > MOST_BYTES


_rollouts: Shelf[RolledOut] = Shelf(MOST_KEPT, _too_large)
_truths: Shelf[Continuations | Outcomes] = Shelf(8)  # of less than a megabyte each
_returns: Shelf[tuple[SimulatedReturns, ...]] = Shelf(16)  # of a few kilobytes each


def rolling(loaded: Loaded, control: Control) -> Rolling:
    """The rollout of an agent under a control: the one there is, or a new one; the oldest makes room."""

    def make(progress: Progress) -> RolledOut:
        pictures = loaded.environment in GYMNASIUM_ENVIRONMENTS
        rollout = roll_out(loaded.agent, loaded.environment, **asdict(control), pictures=pictures, progress=progress)
        along = {} if rollout.spaces is not None else outputs_along(loaded.agent, rollout)
        return RolledOut(rollout, payload(rollout, along), along)

    return _rollouts.take((loaded.agent, control), make)


def artefacts(rolled: RolledOut, view: View) -> Work[Flags]:
    """The search for artefacts at every step under the settings of a view: the one there is, or a new one."""
    # Without a truth no artefact depends on how values are read.
    key = replace(view.settings, softness=0.0, deadline="time_to_go"), view.subject.added
    return rolled.artefacts.take(key, lambda progress: flag_steps(rolled.rollout, *key, progress))


def truth(loaded: Loaded, rollout: Rollout, step: int, action: int, *, own: bool) -> Job[Continuations | Outcomes]:
    """What follows, of this state and first action where there is chance, else of many states.

    Args:
        own: under the rollout's own rule.
    """
    agent, environment, chance = loaded.agent, loaded.environment, vector.chance(loaded.environment)

    def make(progress: Progress) -> Continuations | Outcomes:
        if chance:
            return continue_from(
                agent, rollout, step, action=action, count=COUNT, steps=STEPS, own=own, progress=progress
            )
        like = rollout if own else None
        return outcomes_of_states(
            agent, environment, episodes=EPISODES, each=EACH, steps=STEPS, like=like, progress=progress
        )

    rule = (rollout.rule, rollout.horizon, rollout.gamma) if own else None
    return Job(_truths, (agent, rollout, step, action, own) if chance else (agent, rule), make)


def returns(agents: Sequence[Loaded], rollout: Rollout, step: int, action: int) -> Job[tuple[SimulatedReturns, ...]]:
    """Returns of several agents from this state and first action: each goes on by its own greedy policy."""

    def make(progress: Progress) -> tuple[SimulatedReturns, ...]:
        """Progress is a thousandth of the whole; agents count alike."""

        def of(i: int) -> Progress:
            return lambda done, steps: progress(round(1000 * (i + done / steps)), 1000 * len(agents))

        return tuple(
            simulate_returns(each.agent, rollout, step, action, progress=of(i)) for i, each in enumerate(agents)
        )

    return Job(_returns, (*(each.agent for each in agents), rollout, step, action), make)
