"""Work of the page of trained agents that takes seconds: rollouts, their artefacts, and simulations from their states.

What is begun and done is shared by all sessions of this server.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace

import numpy as np

from app.session.jobs import Wish, background
from laplace_core.acting import estimates
from laplace_core.acting.continuations import Continuations, Outcomes, continue_from, outcomes_of_states
from laplace_core.acting.flags import Flags, flag_steps
from laplace_core.acting.return_laws import SimulatedReturns, outputs_along, simulate_returns_of
from laplace_core.acting.rollout import Rollout, roll_out
from laplace_core.environments import GYMNASIUM_ENVIRONMENTS, vector
from laplace_core.payloads.player import payload
from laplace_core.subjects import View
from laplace_core.supervise.jobs import Job, Kind, Progress
from laplace_core.training.checkpoint import Loaded

MOST_KEPT = 16
"""Rollouts that are kept once they were seen, of 90 MB each at the most."""
_FLAGS = 1e-3  # seconds that the search for artefacts takes at a step
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
    """

    rollout: Rollout
    packed: bytes
    along: dict[str, np.ndarray]


Rolling = Job[RolledOut]

_rollouts: Kind[RolledOut] = Kind("rollouts", MOST_KEPT, line=background)
_artefacts: Kind[Flags] = Kind("artefacts along rollouts", MOST_KEPT, line=background)
_truths: Kind[Continuations | Outcomes] = Kind("simulated continuations", 8, line=background)
_returns: Kind[tuple[SimulatedReturns, ...]] = Kind("simulated returns", MOST_KEPT, line=background)


def rolling(loaded: Loaded, control: Control) -> Wish[RolledOut]:
    """The rollout of an agent under a control."""
    agent, environment = loaded.agent, loaded.environment
    pictures = environment in GYMNASIUM_ENVIRONMENTS

    def make(progress: Progress) -> RolledOut:
        rollout = roll_out(agent, environment, **asdict(control), pictures=pictures, progress=progress)
        along = {} if rollout.spaces is not None else outputs_along(agent, rollout)
        return RolledOut(rollout, payload(rollout, along), along)

    def estimate() -> float:
        return estimates.of_rollout(agent, environment, control.rule, control.horizon, pictures=pictures)

    lower = "lower T or choose a quicker rule"
    return Wish(_rollouts, (agent, control), make, estimate, slot="rollout", lower=lower)


def artefacts(rolled: RolledOut, view: View) -> Wish[Flags]:
    """The search for artefacts at every step under the settings of a view."""
    # Without a truth no artefact depends on how values are read.
    how, rollout = (replace(view.settings, softness=0.0, deadline="time_to_go"), view.subject.added), rolled.rollout

    def make(progress: Progress) -> Flags:
        return flag_steps(rollout, *how, progress)

    return Wish(_artefacts, (rollout, how), make, lambda: _FLAGS * len(rollout), slot="artefacts")


def truth(loaded: Loaded, rollout: Rollout, step: int, action: int, *, own: bool) -> Wish[Continuations | Outcomes]:
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

    def estimate() -> float:
        if chance:
            return estimates.of_continuations(agent, rollout, step, COUNT, steps=STEPS, own=own)
        return estimates.of_outcomes(agent, rollout, EPISODES, steps=STEPS, own=own)

    rule = (rollout.rule, rollout.horizon, rollout.gamma) if own else None
    key = (agent, rollout, step, action, own) if chance else (agent, rule)
    return Wish(_truths, key, make, estimate, slot="truth", by_itself=0.0)


def returns(agents: Sequence[Loaded], rollout: Rollout, step: int, action: int) -> Wish[tuple[SimulatedReturns, ...]]:
    """Returns of several agents from this state and first action: each goes on by its own greedy policy."""

    def make(progress: Progress) -> tuple[SimulatedReturns, ...]:
        return simulate_returns_of([each.agent for each in agents], rollout, step, action, progress=progress)

    def estimate() -> float:
        return estimates.of_returns([each.agent for each in agents], rollout, step)

    key = (*(each.agent for each in agents), rollout, step, action)
    return Wish(_returns, key, make, estimate, slot="returns", by_itself=0.0)
