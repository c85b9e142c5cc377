"""Work of the page of trained agents that takes seconds: rollouts, their artefacts, and simulations from their states.

What is begun and done is shared by all sessions of this server.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace

import numpy as np

from app.session.jobs import Wish, background
from laplace_core.acting.continuations import Continuations, Outcomes, continue_from, outcomes_of_states
from laplace_core.acting.cost import cost_of
from laplace_core.acting.flags import Flags, flag_steps
from laplace_core.acting.return_laws import COUNT as RETURNS
from laplace_core.acting.return_laws import SimulatedReturns, outputs_along, simulate_returns, steps_until_cut
from laplace_core.acting.rollout import Rollout, acting_gamma, length_of, roll_out
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
        steps = length_of(agent, environment, control.horizon)
        return steps * cost_of(agent, environment, control.rule, control.horizon, pictures=pictures).of()

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
        acted = rollout.rule.replace("decoded", "readout") if own else "greedy"
        cost = cost_of(agent, environment, acted, rollout.horizon)
        return step * COUNT * cost.step + STEPS * cost.of(COUNT) if chance else EPISODES * 2 * STEPS * cost.of()

    rule = (rollout.rule, rollout.horizon, rollout.gamma) if own else None
    key = (agent, rollout, step, action, own) if chance else (agent, rule)
    return Wish(_truths, key, make, estimate, slot="truth", by_itself=0.0)


def returns(agents: Sequence[Loaded], rollout: Rollout, step: int, action: int) -> Wish[tuple[SimulatedReturns, ...]]:
    """Returns of several agents from this state and first action: each goes on by its own greedy policy."""

    def make(progress: Progress) -> tuple[SimulatedReturns, ...]:
        """Progress is a thousandth of the whole; agents count alike."""

        def of(i: int) -> Progress:
            return lambda done, steps: progress(round(1000 * (i + done / steps)), 1000 * len(agents))

        return tuple(
            simulate_returns(each.agent, rollout, step, action, progress=of(i)) for i, each in enumerate(agents)
        )

    def estimate() -> float:
        count = RETURNS if vector.chance(rollout.environment) else 1
        costs = [(each.agent, cost_of(each.agent, rollout.environment)) for each in agents]
        past = step * count * sum(cost.step for _, cost in costs)
        return past + sum(steps_until_cut(acting_gamma(agent)) * cost.of(count) for agent, cost in costs)

    key = (*(each.agent for each in agents), rollout, step, action)
    return Wish(_returns, key, make, estimate, slot="returns", by_itself=0.0)
