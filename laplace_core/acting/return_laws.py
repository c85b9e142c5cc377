"""Distributions of the discounted return after one state and action: those that agents learned, and simulated ones.

Both are of the agent's OWN policy, greedy at its acting discount, and know no time limit. A Laplace agent has learned
no such law: the law that its tau-space gives if its steps were independent stands in for one, and is labelled so.
"""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from laplace_core.acting.continuations import MOST, continue_from
from laplace_core.acting.rollout import Rollout, acting_gamma
from laplace_core.agents.agent import Agent
from laplace_core.agents.capabilities import HasGammaSpace, HasReturnDistribution, HasTimeToGo
from laplace_core.environments import vector
from laplace_core.errors import InputError
from laplace_core.inverse import decode
from laplace_core.tabular.returns import independent_steps_return, wasserstein

COUNT = 100
"""Continuations where there is chance; elsewhere one says all."""
CUT = 0.005
"""Weight of a reward at which simulations end: gamma^K."""
LEVELS = (0.1, 0.25, 0.5, 0.75, 0.9)
MOST_OUTPUTS = 4_000_000
_AT_ONCE = 100  # observations in one pass through the network
INDEPENDENT, LEARNED, MEAN = "if steps were independent", "learned", "a mean"


@dataclass(frozen=True, eq=False)
class ReturnLaw:
    """The distribution of the return that an agent predicts.

    Attributes:
        kind: ``LEARNED``, ``INDEPENDENT`` or, of an agent that knows no more, ``MEAN``.
        locations, masses: ``(M,)``, locations increasing, in units of reward.
        mean: as the agent has it; of independent steps, that of the law: what the inverse leaves of it.
    """

    kind: str
    gamma: float
    locations: np.ndarray
    masses: np.ndarray

    @property
    def mean(self) -> float:
        return float(self.locations @ self.masses / self.masses.sum())


@dataclass(frozen=True, eq=False)
class SimulatedReturns:
    """Observed returns of N continuations.

    Attributes:
        returns: ``(N,)``, of the first ``steps`` steps, discounted.
        running: share of the continuations that were not over by then.
        missing: upper bound of the mean return after those steps, if no later reward exceeds the largest observed.
    """

    returns: np.ndarray
    gamma: float
    steps: int
    running: float
    missing: float

    @property
    def mean(self) -> tuple[float, float]:
        """The mean return and its standard error; 0 where one continuation stands for all."""
        count = len(self.returns)
        error = self.returns.std(ddof=1) / np.sqrt(count) if count > 1 else 0.0
        return float(self.returns.mean()), float(error)

    @property
    def law(self) -> tuple[np.ndarray, np.ndarray]:
        """Sorted returns, equally heavy."""
        count = len(self.returns)
        return np.sort(self.returns), np.full(count, 1.0 / count)

    @property
    def by_chance(self) -> float:
        """Expected W1 distance between a law and N draws of it.

        The integral of E|F_N - F|, which for a binomial count near a normal one is sqrt(2 F (1 - F) / (pi N)), with the
        simulated law for F.
        """
        locations, masses = self.law
        below = np.cumsum(masses)[:-1]
        return float(np.sqrt(2.0 * below * (1.0 - below) / (np.pi * len(locations))) @ np.diff(locations))

    def distance(self, law: ReturnLaw) -> float:
        """W1 distance from the law that an agent predicts, in units of reward."""
        return wasserstein((law.locations, law.masses), self.law)


def has_return_law(agent: Agent) -> bool:
    """Whether an agent predicts the distribution of the return, if only by its mean."""
    return isinstance(agent, HasReturnDistribution | HasGammaSpace)


def says_more_than_a_mean(agent: Agent) -> bool:
    """Whether the agent predicts the spread of the return, not only its mean."""
    if isinstance(agent, HasReturnDistribution):
        return agent.return_distribution(np.zeros(agent.n_observations))[0].shape[1] > 1
    return isinstance(agent, HasGammaSpace)


def steps_until_cut(gamma: float) -> int:
    """K, the first step at which gamma^K is at most ``CUT``; at most as many as can be simulated."""
    return int(min(MOST, np.ceil(np.log(CUT) / np.log(gamma))))


def return_laws(
    agent: Agent, observation: np.ndarray, actions: Sequence[int] | None = None, alpha: float = 1.0
) -> list[ReturnLaw]:
    """Laws that an agent predicts for the return of some actions, by default of all, for one observation ``(O,)``.

    Args:
        alpha: regularisation of the inverse, for an agent with a gamma-space.
    """
    gamma = acting_gamma(agent)
    actions = range(agent.n_actions) if actions is None else actions
    if isinstance(agent, HasReturnDistribution):
        locations, masses = agent.return_distribution(observation)
        kind = MEAN if locations.shape[1] == 1 else LEARNED
        return [ReturnLaw(kind, gamma, locations[action], masses[action]) for action in actions]
    if not isinstance(agent, HasGammaSpace):
        raise InputError("this agent predicts only the mean of its return, not its distribution.")
    space, steps = agent.gamma_space(observation), steps_until_cut(gamma)
    tau_space = decode(space.differences[list(actions)], space.gammas, steps, alpha)
    rewards, discounts = space.bin_values, gamma ** np.arange(steps)
    return [ReturnLaw(INDEPENDENT, gamma, *independent_steps_return(one, rewards, discounts)) for one in tau_space]


def outputs_along(agent: Agent, rollout: Rollout) -> dict[str, np.ndarray]:
    """Outputs of a peer at every step of an episode beside its values, float32.

    Returns:
        ``locations`` and ``masses`` ``(N, A, M)`` of learned returns; ``horizon_values`` ``(N, T, A)`` of an agent that
        knows the time to go; nothing for others, or if it were more than ``MOST_OUTPUTS`` numbers.
    """
    if isinstance(agent, HasTimeToGo):
        names: tuple[str, ...] = ("horizon_values",)
        read: Callable[[np.ndarray], tuple[np.ndarray, ...]] = partial(_horizon_values, agent)
    elif isinstance(agent, HasReturnDistribution):
        names, read = ("locations", "masses"), agent.return_distributions
    else:
        return {}
    first = read(rollout.observations[:1])[0]
    if first.shape[-1] == 1 or first.size * len(rollout) > MOST_OUTPUTS:
        return {}
    starts = range(0, len(rollout), _AT_ONCE)
    parts = [read(rollout.observations[i : min(i + _AT_ONCE, len(rollout))]) for i in starts]
    columns = zip(*parts, strict=True)
    return {name: np.concatenate(each).astype(np.float32) for name, each in zip(names, columns, strict=True)}


def _horizon_values(agent: Agent, observations: np.ndarray) -> tuple[np.ndarray, ...]:
    return (agent.action_values(observations),)


def return_quantiles(outputs: Mapping[str, np.ndarray], actions: np.ndarray) -> np.ndarray | None:
    """Quantiles, at ``LEVELS``, of the predicted return of the actions taken: ``(N, len(LEVELS))``.

    Args:
        outputs: from :func:`outputs_along`.
        actions: ``(N,)``.
    """
    if "locations" not in outputs:
        return None
    each = np.arange(len(actions))
    locations, masses = (outputs[name][each, actions].astype(float) for name in ("locations", "masses"))
    below = np.cumsum(masses, axis=1) / masses.sum(axis=1, keepdims=True)
    places = (below[:, None, :] < np.array(LEVELS)[:, None] * (1.0 - 1e-6)).sum(axis=2)
    return locations[each[:, None], places.clip(max=locations.shape[1] - 1)]


def simulate_returns(
    agent: Agent, rollout: Rollout, step: int, action: int, *, count: int = COUNT, seed: int = 0,
    progress: Callable[[int, int], None] | None = None,
) -> SimulatedReturns:  # fmt: skip
    """Returns of continuations from the state before a step of an episode, which may be another agent's.

    Args:
        action: taken first; afterwards the agent acts greedily at its acting discount.
        count: N; 1 where the environment has no chance in it and all are the same.
        progress: called with (done, total) in steps; an exception that it raises cancels the work.

    Raises:
        InputError: as of :func:`continue_from`.
    """
    gamma = acting_gamma(agent)
    steps = steps_until_cut(gamma)
    count = count if vector.chance(rollout.environment) else 1
    sample = continue_from(agent, rollout, step, action=action, count=count, steps=steps, seed=seed, progress=progress)
    running = float(sample.alive[:, -1].mean())
    missing = running * gamma**steps / (1.0 - gamma) * float(np.abs(sample.rewards).max())
    return SimulatedReturns(sample.rewards @ gamma ** np.arange(steps), gamma, steps, running, missing)


def simulate_returns_of(
    agents: Sequence[Agent], rollout: Rollout, step: int, action: int, *, progress: Callable[[int, int], None]
) -> tuple[SimulatedReturns, ...]:
    """The same of several agents; progress counts in thousandths of the whole, and agents alike."""

    def of(i: int) -> Callable[[int, int], None]:
        return lambda done, steps: progress(round(1000 * (i + done / steps)), 1000 * len(agents))

    return tuple(simulate_returns(each, rollout, step, action, progress=of(i)) for i, each in enumerate(agents))


def laws_npz(
    names: Sequence[str], laws: Sequence[ReturnLaw], observed: Sequence[SimulatedReturns] | None = None
) -> bytes:
    """Laws side by side as an ``.npz`` file: ``I_NAME_locations``, ``_masses`` and, where known, ``_came`` for agent I,
    and a JSON string ``settings`` with the discount and the kind of each."""
    arrays: dict[str, Any] = {}
    for i, (name, law) in enumerate(zip(names, laws, strict=True)):
        arrays |= {f"{i}_{name}_locations": law.locations, f"{i}_{name}_masses": law.masses}
        if observed is not None:
            arrays[f"{i}_{name}_came"] = observed[i].returns
    report = [{"algorithm": name, "kind": law.kind, "gamma": law.gamma} for name, law in zip(names, laws, strict=True)]
    file = io.BytesIO()
    np.savez_compressed(file, **arrays, settings=np.array(json.dumps(report)))
    return file.getvalue()
