"""Truth by simulation: the work that it is, and in words what is simulated and what it says of a decoded timeline."""

from __future__ import annotations

from typing import Any

from laplace_core.acting import estimates
from laplace_core.acting.continuations import Continuations, Outcomes, continue_from, outcomes_of_states, steps_known
from laplace_core.acting.rollout import Rollout
from laplace_core.acting.rules import title_of
from laplace_core.acting.simulated_truth import Confronted, confront, confront_states, empirical
from laplace_core.agents.agent import Agent
from laplace_core.caching import cached
from laplace_core.environments import vector
from laplace_core.payloads.lens import Simulated
from laplace_core.subjects import Subject, View
from laplace_core.supervise.jobs import Progress, Task
from laplace_core.training.checkpoint import Loaded

COUNT, EPISODES, EACH, STEPS = 100, 20, 10, 200
"""Of truths: continuations of a state; or episodes, and states of each; and how many steps follow."""


def truth(loaded: Loaded, rollout: Rollout, step: int, action: int, *, own: bool) -> Task[Continuations | Outcomes]:
    """Simulated continuations of this state and first action; of many states if the environment is deterministic.

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
    return Task(key, make, estimate, slot="truth", by_itself=0.0)


def titles(rollout: Rollout) -> dict[str, str]:
    """Titles of the two policies of a simulation: that of the values, and that of the rollout."""
    rule = title_of(rollout.rule).split(" (")[0].removeprefix("for T: ")
    if rollout.gamma:
        rule = f"greedy at γ {rollout.gamma:.4g}"
    return {"values": f"greedy at γ {rollout.acting_gamma:.4g}", "rule": f"as rolled out: {rule}"}


def words(view: View, loaded: Loaded, rollout: Rollout, step: int, *, own: bool) -> str:
    """The simulation in words, with a warning if tau-space predicts another policy.

    Args:
        own: under the rollout's own rule.
    """
    then = titles(rollout)["rule" if own else "values"].removeprefix("as rolled out: ")
    if vector.chance(loaded.environment):
        steps = steps_known(loaded.agent, rollout, step, STEPS, own=own)
        limit = "to the deadline" if steps < STEPS else "without a time limit"
        action = view.subject.action_names[view.action]
        words = f"{COUNT} continuations of {steps} steps, {limit}: {action}, then {then}."
    else:
        words = f"{loaded.environment} is deterministic: only the observed rewards can follow from here. "
        words += f"For calibration, {EACH} states of each of {EPISODES} episodes, {then}."
    if own:
        words += f" Tau-space predicts greedy at γ {rollout.acting_gamma:.4g}: this simulation follows another policy."
    return words


def summary(confronted: Confronted, view: View) -> str:
    """The caption of the two pictures of a simulation of one state."""
    sample = confronted.simulated
    return (
        f"Calibration: how often a reward exceeded θ where tau-space says so with some probability, over "
        f"{len(confronted.reward)} steps and all θ, at α {view.settings.alpha:g}; bars of two standard errors.  \n"
        f"W1, in reward: how far the rewards of a step are from those that tau-space predicts, 0 once it is over; "
        f"{confronted.distance.mean():.3g} on average over the steps. Grey in the strip beside tau-space: what chance "
        f"alone makes with {sample.count} continuations, {sample.chance.mean():.3g} on average."
    )


@cached(8)
def for_lens(simulated: Continuations | Outcomes, agent: Agent[Any], action: int) -> Simulated:
    """The continuations as the lens draws them; the same object for the same ones."""
    assert isinstance(simulated, Continuations)  # of many states the lens draws nothing
    return Simulated(action, empirical(agent, simulated))


@cached(16)
def confronted_with(
    simulated: Continuations | Outcomes, loaded: Loaded, subject: Subject, action: int, *, alpha: float
) -> Confronted:
    """A simulation beside what tau-space predicts; the same object for the same ones."""
    if isinstance(simulated, Outcomes):
        return confront_states(loaded.agent, simulated, alpha)
    assert subject.gamma_space is not None  # an agent was observed: there is no world to make one from
    return confront(loaded.agent, subject.gamma_space, action, simulated, alpha=alpha)
