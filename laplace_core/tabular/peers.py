"""The peers in tabular form: four other representations of one return, learned from the same transitions.

Categorical (paper, section 2.1 a; Bellemare et al. 2017), quantile (section 2.1 b; Dabney et al. 2018), expectile
(appendix A; Rowland et al. 2019) and plain Q. Each is a table and one ``update``, to be read side by side: the next
state gives a distribution of r + gamma Z(s', a*), and the update moves the table of (s, a) towards it.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import NamedTuple

import numpy as np

from laplace_core.errors import InputError
from laplace_core.planning.policies import check_policy, selection
from laplace_core.tabular.td import Decay, Transition, first_best
from laplace_core.worlds.model import END, World

_RATE = Decay()


class _Peer(ABC):
    """The base of the peers: the target policy, the learning rate and the mean of every state and action.

    Args:
        gamma: the one discount of the return.
        policy: deterministic policy to evaluate, int ``(S,)``; None is control, greedy on the learned mean.
        rate: learning rate by the number of earlier visits of the state and action.

    Attributes:
        values: mean return, ``(S, A)``.
    """

    def __init__(self, world: World, gamma: float, policy: np.ndarray | None = None, rate: Decay = _RATE):
        if not 0.0 < gamma < 1.0:
            raise InputError(f"gamma must lie between 0 and 1, both excluded, not {gamma:g}.")
        if policy is not None and check_policy(world, policy).ndim != 1:
            raise InputError("the peers evaluate deterministic policies only: one action a state.")
        self.gamma, self.policy, self.rate = gamma, policy, rate
        self.values = np.zeros((world.n_states, world.n_actions))
        self._visits = [[0] * world.n_actions for _ in world.states]

    def act(self, state: int, draw: float = 0.0) -> int:
        """The target policy's action; it is deterministic, so ``draw`` does not matter."""
        return first_best(self.values[state].tolist()) if self.policy is None else int(self.policy[state])

    @abstractmethod
    def distribution(self, state: int, action: int) -> tuple[np.ndarray, np.ndarray]:
        """The learned distribution of the return: locations and masses, ``(N,)`` each."""

    def _target(self, transition: Transition) -> tuple[np.ndarray, np.ndarray]:
        """Distribution of r + gamma Z(s', a*), of r alone where the episode terminated."""
        if transition.next_state == END:
            return np.array([transition.reward]), np.ones(1)
        later, masses = self.distribution(transition.next_state, self.act(transition.next_state))
        return transition.reward + self.gamma * later, masses

    def _next_rate(self, transition: Transition) -> float:
        visits = self._visits[transition.state]
        visits[transition.action] += 1
        return self.rate(visits[transition.action] - 1)


class PlainQ(_Peer):
    """Q-learning of the mean alone: Q += rate (target - Q)."""

    def update(self, transition: Transition) -> None:
        pair = transition.state, transition.action
        locations, masses = self._target(transition)
        self.values[pair] += self._next_rate(transition) * (locations @ masses - self.values[pair])

    def distribution(self, state: int, action: int) -> tuple[np.ndarray, np.ndarray]:
        return self.values[state, action, None], np.ones(1)


class Categorical(_Peer):
    """C51 (paper, Eq. 3): masses on fixed atoms; p += rate (projected target - p).

    Before the first update all the mass lies at return 0, or at the atom nearest to it.

    Args:
        atoms: increasing, ``(N,)``; a target beyond them is moved to the outermost.
    """

    def __init__(
        self, world: World, gamma: float, atoms: np.ndarray, *, policy: np.ndarray | None = None, rate: Decay = _RATE
    ):
        super().__init__(world, gamma, policy, rate)
        self.atoms = np.asarray(atoms, dtype=float)
        if self.atoms.ndim != 1 or self.atoms.size < 2 or not np.all(np.diff(self.atoms) > 0):
            raise InputError("atoms must be at least two increasing numbers.")
        nothing = project(np.zeros(1), np.ones(1), self.atoms)
        self.probabilities = np.tile(nothing, (*self.values.shape, 1))
        self.values[:] = self.probabilities @ self.atoms

    def update(self, transition: Transition) -> None:
        pair = transition.state, transition.action
        locations, masses = self._target(transition)
        probabilities = self.probabilities[pair]
        probabilities += self._next_rate(transition) * (project(locations, masses, self.atoms) - probabilities)
        self.values[pair] = probabilities @ self.atoms

    def distribution(self, state: int, action: int) -> tuple[np.ndarray, np.ndarray]:
        return self.atoms, self.probabilities[state, action]


class Quantile(_Peer):
    """Quantile code (paper, Eq. 4): N equally heavy locations at the levels (i - 1/2) / N.

    q_i += rate * scale * (level_i - P(target < q_i)), the negative gradient of E[u (level_i - 1[u < 0])] with
    u = target - q_i: a target above q_i raises it by level_i, one below lowers it by 1 - level_i.

    Args:
        scale: in units of reward, such as the range of the returns; a gradient of probabilities has no unit.
        takes_over: while the learning rate is above this, the quantiles of the target replace those of the table;
            afterwards no step goes beyond the target. Infinite: the plain gradient, whose step has one size however
            near the target is, so that an outer quantile leaps over it and takes a hundred steps back.
    """

    def __init__(
        self, world: World, gamma: float, *, count: int = 51, scale: float = 1.0, policy: np.ndarray | None = None,
        rate: Decay = _RATE, takes_over: float = np.inf,
    ):  # fmt: skip
        super().__init__(world, gamma, policy, rate)
        self.takes_over = takes_over
        if count < 1 or not scale > 0:
            raise InputError("quantiles need a count of at least 1 and a positive scale.")
        self.levels, self.scale = (np.arange(count) + 0.5) / count, scale
        self.locations = np.zeros((*self.values.shape, count))

    def update(self, transition: Transition) -> None:
        pair = transition.state, transition.action
        locations, masses = self._target(transition)
        rate = self._next_rate(transition)
        if rate > self.takes_over:
            self.locations[pair] = quantiles_of(locations, masses, self.levels)
        else:
            below = (locations < self.locations[pair][:, None]) @ masses
            moved = self.locations[pair] + rate * self.scale * (self.levels - below)
            if np.isfinite(self.takes_over):
                here = self.locations[pair]
                moved = np.clip(moved, np.minimum(here, locations.min()), np.maximum(here, locations.max()))
            self.locations[pair] = moved
        self.values[pair] = self.locations[pair].mean()

    def distribution(self, state: int, action: int) -> tuple[np.ndarray, np.ndarray]:
        return self.locations[state, action], np.full(self.levels.size, 1.0 / self.levels.size)


def quantiles_of(locations: np.ndarray, masses: np.ndarray, levels: np.ndarray) -> np.ndarray:
    """Quantiles of a discrete distribution at each level in (0, 1): where its cumulated mass first reaches it."""
    order = np.argsort(locations)
    reached = np.searchsorted(np.cumsum(masses[order]) * (1.0 + 1e-12), levels)
    return locations[order][np.minimum(reached, locations.size - 1)]


class Expectile(_Peer):
    """Expectile code (paper, Eq. 11): N expectiles at the levels i / (N + 1), N odd, so that 1/2 is one: the mean.

    e_i += rate * E[2 |level_i - 1[u < 0]| u] with u = target - e_i, the negative gradient of the expectile loss
    ER = |level_i - 1[u < 0]| u^2. A target above e_i is weighted by level_i, one below by 1 - level_i. At the level
    1/2 this is the update of plain Q. Expectiles are no samples: the target's distribution is imputed from those of
    the next state.

    Args:
        low, high: bounds of the return, in units of reward.
    """

    def __init__(
        self,
        world: World,
        gamma: float,
        low: float,
        high: float,
        *,
        count: int = 11,
        policy: np.ndarray | None = None,
        rate: Decay = _RATE,
    ) -> None:
        super().__init__(world, gamma, policy, rate)
        if count < 1 or count % 2 == 0 or not low < high:
            raise InputError("expectiles need an odd count and low < high.")
        self.levels, self.low, self.high = np.arange(1, count + 1) / (count + 1), low, high
        self.expectiles = np.zeros((*self.values.shape, count))

    def update(self, transition: Transition) -> None:
        pair = transition.state, transition.action
        locations, masses = self._target(transition)
        gradient = 2.0 * expectile_conditions(locations, self.expectiles[pair], self.levels) @ masses
        self.expectiles[pair] += self._next_rate(transition) * gradient
        self.values[pair] = self.expectiles[pair][self.levels.size // 2]

    def distribution(self, state: int, action: int) -> tuple[np.ndarray, np.ndarray]:
        return impute(self.expectiles[state, action], self.levels, self.low, self.high)


def project(locations: np.ndarray, masses: np.ndarray, atoms: np.ndarray) -> np.ndarray:
    """Masses on ``atoms``, each location shared by its two neighbours in proportion to nearness, shape ``(N,)``.

    The mass is conserved, and so is the mean of all that lies between the outermost atoms; the rest is moved there
    (Bellemare et al. 2017, the projection of C51, for atoms at any distances).
    """
    inside = np.clip(locations, atoms[0], atoms[-1])
    left = np.clip(np.searchsorted(atoms, inside, side="right") - 1, 0, atoms.size - 2)
    nearness = (inside - atoms[left]) / (atoms[left + 1] - atoms[left])
    lower = np.bincount(left, masses * (1.0 - nearness), atoms.size)
    return lower + np.bincount(left + 1, masses * nearness, atoms.size)


def expectile_conditions(locations: np.ndarray, expectiles: np.ndarray, levels: np.ndarray) -> np.ndarray:
    """|level_i - 1[x_j < e_i]| (x_j - e_i), shape ``(N, M)``; its mean over x is 0 where e_i is the expectile."""
    excess = locations - expectiles[:, None]
    return np.where(excess < 0, 1.0 - levels[:, None], levels[:, None]) * excess


def impute(expectiles: np.ndarray, levels: np.ndarray, low: float, high: float) -> tuple[np.ndarray, np.ndarray]:
    """A distribution with the given expectiles: locations and masses, from the conditions of paper, Eqs. 12 and 13.

    The first-order conditions are linear in the masses of fixed locations, so that Eq. 13, their sum of squares, is a
    non-negative least-squares problem. The locations low, e_1, ..., e_N, high are enough: moving mass outwards to the
    two nearest of them changes no E[(x - e_i)+] and no mean, hence no condition, so whatever distribution on
    [low, high] has these expectiles, one on these locations has them too. It is one of many, and rougher than the
    true one: expectiles do not say more. Expectiles that no distribution has get the nearest in Eq. 13's sense.
    """
    from scipy.optimize import nnls  # slow to import, and only needed here

    scale = high - low
    locations = np.unique(np.clip(np.concatenate([expectiles, [low, high]]), low, high))
    conditions = expectile_conditions(locations, expectiles, levels) / scale
    # A heavy last row asks for a total mass of 1; the rest is rounding, and is divided out.
    system = np.vstack([conditions, np.full(locations.size, 100.0)])
    masses, _ = nnls(system, np.append(np.zeros(expectiles.size), 100.0), maxiter=50 * locations.size)
    return locations, masses / masses.sum()


class ReturnDistribution(NamedTuple):
    """Locations and masses ``(N,)``, increasing; ``error`` bounds the Wasserstein-1 distance to the exact law."""

    locations: np.ndarray
    masses: np.ndarray
    error: float


def return_distribution(
    world: World,
    state: int,
    action: int,
    policy: np.ndarray,
    *,
    gamma: float,
    tolerance: float = 1e-6,
    most: int = 4_000,
) -> ReturnDistribution:
    """The true law of sum_tau gamma^tau r_tau after a state and action, the policy deciding afterwards.

    The joint law of (state, return so far) is carried forward exactly, equal returns merged: a world with few paths
    gets its exact atoms, where sampling would leave an error of a percent for all its work, and propagating backwards
    would round again at every step. Beyond ``most`` atoms the nearby returns of a state are replaced by their mean.
    Given the atom, such a move has mean zero whatever happens afterwards, so that the squares of the moves add up:
    ``error`` is the root of their sum, which bounds the Wasserstein-2 and hence the Wasserstein-1 distance, plus
    what may still be paid when the propagation ends, below ``tolerance`` (in units of reward). Of a state and action
    with very many outcomes the nearby rewards are replaced by their mean beforehand, which counts in the same way.
    """
    policy = check_policy(world, policy)
    moves = selection(world, policy)  # (S, S*A): chance of each pair in a state
    largest = float(np.abs(world.reward).max())
    bounds, outcomes, spread = _merged_outcomes(world, 1e-12 * max(largest, 1e-300))
    pairs, returns, masses = np.array([state * world.n_actions + action]), np.zeros(1), np.ones(1)
    done: list[tuple[np.ndarray, np.ndarray]] = []
    discount, squares, cell = 1.0, 0.0, 1e-12 * max(largest, 1e-300)
    while masses.size and masses.sum() * discount * largest / (1.0 - gamma) > tolerance:
        squares += discount**2 * float(masses @ spread[pairs])
        source, outcome = _expand(bounds, pairs)
        returns = returns[source] + discount * outcomes.reward[outcome]
        masses, states = masses[source] * outcomes.probability[outcome], outcomes.following[outcome]
        states, returns, masses, shift, cell = _merge(states, returns, masses, cell, most=most)
        squares += shift
        ended = states == END
        done.append((returns[ended], masses[ended]))
        states, returns, masses = states[~ended], returns[~ended], masses[~ended]
        source, entry = _expand(moves.indptr, states)
        pairs, returns, masses = moves.indices[entry], returns[source], masses[source] * moves.data[entry]
        discount *= gamma
    left = float(masses.sum()) * discount * largest / (1.0 - gamma)
    locations, totals = (np.concatenate(column) for column in zip(*done, (returns, masses), strict=True))
    _, locations, totals, shift, _ = _merge(np.zeros(locations.size, int), locations, totals, cell, most=most)
    return ReturnDistribution(locations, totals, float(np.sqrt(squares + shift)) + left)


MOST_OUTCOMES = 300
"""Of one state and action, beyond which nearby rewards are taken together: each of the atoms has all of them next."""


class _Outcomes(NamedTuple):
    """Outcomes of all pairs of state and action, ``(M,)`` each."""

    probability: np.ndarray
    reward: np.ndarray
    following: np.ndarray


def _merged_outcomes(world: World, cell: float) -> tuple[np.ndarray, _Outcomes, np.ndarray]:
    """Where the outcomes of each pair begin and end, the outcomes, and the mean square of what was moved of a pair."""
    pairs = world.n_states * world.n_actions
    bounds = np.searchsorted(world.state * world.n_actions + world.action, np.arange(pairs + 1))
    outcomes, spread = _Outcomes(world.probability, world.reward, world.following), np.zeros(pairs)
    counts = np.diff(bounds)
    if counts.max() <= MOST_OUTCOMES:
        return bounds, outcomes, spread
    parts = []
    for pair in range(pairs):
        probability, reward, following = (column[bounds[pair] : bounds[pair + 1]] for column in outcomes)
        if counts[pair] > MOST_OUTCOMES:
            following, reward, probability, spread[pair], _ = _merge(
                following, reward, probability, cell, most=MOST_OUTCOMES
            )
        parts.append((probability, reward, following))
    merged = _Outcomes(*(np.concatenate(column) for column in zip(*parts, strict=True)))
    return np.cumsum([0, *(len(part[0]) for part in parts)]), merged, spread


def _expand(bounds: np.ndarray, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Index in ``rows`` and entry, for every entry of every row; row i holds entries bounds[i] to bounds[i+1] - 1."""
    counts = bounds[rows + 1] - bounds[rows]
    source = np.repeat(np.arange(rows.size), counts)
    within = np.arange(source.size) - np.repeat(np.cumsum(counts) - counts, counts)
    return source, bounds[rows][source] + within


def _merge(
    groups: np.ndarray, values: np.ndarray, masses: np.ndarray, cell: float, *, most: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray, float, float]:
    """Replace the values of a group that share a cell by their mean; widen the cell until ``most`` are left.

    Returns the groups, values, masses, the mass moved times its distance squared, and the cell.
    """
    while True:
        cells = np.floor(values / cell + 0.5)
        order = np.lexsort((cells, groups))
        new = (np.diff(groups[order]) != 0) | (np.diff(cells[order]) != 0)
        if new.sum() < most or np.ptp(values) < cell:
            break
        cell *= 2.0
    index = np.empty(order.size, dtype=np.int64)
    index[order] = np.append(0, np.cumsum(new))
    totals = np.bincount(index, masses)
    means = np.bincount(index, masses * values) / np.where(totals > 0, totals, 1.0)
    moved = float(masses @ (values - means[index]) ** 2)
    positive = totals > 0
    return groups[order][np.append(True, new)][positive], means[positive], totals[positive], moved, cell
