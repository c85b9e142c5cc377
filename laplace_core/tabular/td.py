"""Temporal-difference learning of the Laplace code from sampled transitions of a tabular world.

For every discount gamma_g and channel c with activation f_c(r), one transition (s, a, r, s') moves

    Q[s, a, g, c] += rate * (f_c(r) + gamma_g Q[s', a*, g, c] - Q[s, a, g, c])

in one vectorised update, towards the values of the paper's Eq. 14. It is linear in f, so that the channels are free
to choose. The indicators 1[r = v] learn the reward-indicator basis W, from which every choice of sensitivities and
slope follows afterwards; :func:`sensitivity_channels` learn gamma-space directly, for worlds with many rewards.

An episode that terminates bootstraps from nothing; one that runs into ``max_steps`` is cut after a transition that
bootstraps as any other, so that survival knows no time limit.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from laplace_core.code.encoding import activation
from laplace_core.code.ties import ROUNDING, TIE_TOLERANCE, greedy_action
from laplace_core.errors import InputError
from laplace_core.planning.policies import TARGET_POLICIES, check_policy
from laplace_core.worlds.model import END, World

MAX_TABLE = 50_000_000  # numbers in a table: 400 MB


class Transition(NamedTuple):
    """One sampled step; ``kind`` is the index of the reward in ``world.reward_values``.

    ``next_state`` is END where the episode ends, on entering an absorbing state too.
    """

    state: int
    action: int
    reward: float
    kind: int
    next_state: int


@dataclass(frozen=True)
class Decay:
    """max(floor, first / (1 + n / half)): half of ``first`` after ``half`` counts; ``half=inf`` is constant.

    As a learning rate, n counts the earlier visits of the state and action: ``half=1`` is the plain average of all
    samples, a larger ``half`` forgets the early ones, which were bootstrapped from values not yet learned, and
    leaves more noise. As an epsilon, n counts the earlier episodes.
    """

    first: float = 1.0
    half: float = 10.0
    floor: float = 0.0

    def __post_init__(self) -> None:
        if not (0.0 <= self.floor <= self.first <= 1.0 and self.half > 0.0):
            raise InputError(f"a decay needs 0 <= floor <= first <= 1 and half > 0, not {self}.")

    def __call__(self, n: float) -> float:
        return max(self.floor, self.first / (1.0 + n / self.half))


@dataclass(frozen=True)
class Schedule:
    """Settings by which experience is gathered.

    Attributes:
        epsilon: chance of a uniformly random action, by the number of earlier episodes.
        max_steps: an episode is truncated after so many.
        starts: ``world`` draws the first state from the world's start, ``everywhere`` uniformly from all states.
        every: episodes between two events; the last episode always has one.
    """

    episodes: int = 1_000
    seed: int = 0
    epsilon: Decay = Decay(0.1, np.inf)
    max_steps: int = 1_000
    starts: str = "world"
    every: int = 1

    def __post_init__(self) -> None:
        if min(self.episodes, self.max_steps, self.every) < 1 or self.seed < 0:
            raise InputError("episodes, max_steps and every must be at least 1, and the seed not negative.")
        if self.starts not in ("world", "everywhere"):
            raise InputError(f"starts must be 'world' or 'everywhere', not {self.starts[:40]!r}.")


@dataclass(frozen=True)
class Progress:
    """The state of learning after an episode.

    Attributes:
        episode, steps: episodes and transitions so far.
        episode_return, truncated, epsilon: this episode's sum of rewards, whether it was cut, its random actions.
        largest_change: since the event before, of any of the first learner's ``values``, in units of reward.
    """

    episode: int
    steps: int
    episode_return: float
    truncated: bool
    largest_change: float
    epsilon: float


class Sampler:
    """Transitions of a world, drawn from its outcome table: one search in cumulated probabilities each."""

    def __init__(self, world: World, seed: int):
        possible, pairs = world.probability > 0, world.n_states * world.n_actions
        pair = (world.state * world.n_actions + world.action)[possible]
        self._bounds = np.searchsorted(pair, np.arange(pairs + 1)).tolist()
        cumulated = np.cumsum(world.probability[possible])
        before = np.append(0.0, cumulated)[self._bounds[:-1]]
        self._cumulated = (cumulated - before[pair]).tolist()
        # Plain lists: one number is read several times faster than from an array.
        self._next_state = world.following[possible].tolist()
        self._reward = world.reward[possible].tolist()
        self._kind = np.searchsorted(world.reward_values, world.reward[possible]).tolist()
        self._start = _cumulated(world.start).tolist()
        self._n_states, self._n_actions = world.n_states, world.n_actions
        self.draw = _uniforms(np.random.default_rng(seed)).__next__  # a number in [0, 1)

    def first_state(self, starts: str = "world") -> int:
        if starts == "everywhere":
            return int(self.draw() * self._n_states)
        return bisect_right(self._start, self.draw())

    def step(self, state: int, action: int) -> Transition:
        pair = state * self._n_actions + action
        first, last = self._bounds[pair], self._bounds[pair + 1]
        # Searching all but the last outcome: the sum of the probabilities may round below 1.
        row = first if last - first == 1 else bisect_right(self._cumulated, self.draw(), first, last - 1)
        return Transition(state, action, self._reward[row], self._kind[row], self._next_state[row])


def _cumulated(probabilities: np.ndarray) -> np.ndarray:
    """Cumulated along the last axis, and exactly 1 from the last possible entry on."""
    totals = np.cumsum(probabilities, axis=-1)
    return totals / totals[..., -1:]


def _uniforms(rng: np.random.Generator) -> Iterator[float]:
    while True:
        yield from rng.random(4096).tolist()


def td_update(
    value: np.ndarray,
    following: np.ndarray | None,
    now: np.ndarray,
    gammas: np.ndarray,
    *,
    rate: float,
    work: np.ndarray,
) -> None:
    """value += rate * (now + gamma * following - value), in place, for all discounts and channels at once.

    Args:
        value: ``(G, C)``, those of the state and action.
        following: ``(G, C)``, those of the next state under the target policy; None if the episode terminated.
        now: activation of the reward in each channel, ``(C,)``.
        gammas: ``(G, 1)``.
        work: ``(G, C)``, overwritten.
    """
    # Grouped as (1 - rate) value + (rate gamma) following + rate now: four passes over (G, C) and no temporary.
    if following is None:
        value *= 1.0 - rate
    else:
        np.multiply(rate * gammas, following, out=work)  # first, for ``following`` may be ``value`` itself
        value *= 1.0 - rate
        value += work
    value += rate * now


def sensitivity_channels(rewards: np.ndarray, thetas: np.ndarray, slope: float) -> np.ndarray:
    """f_h(v) for each reward v and the constant channel behind them, shape ``(V, H+1)``."""
    return np.hstack([activation(rewards, thetas, slope), np.ones((np.size(rewards), 1))])


class LaplaceTD:
    """A table of the Laplace code and its update.

    The table also holds a channel for the reward itself and a row for ``acting_gamma``, so that actions are judged
    by the learned expected return and never by a proxy.

    Args:
        gammas: discounts in (0, 1), shape ``(G,)``.
        channels: activation of each distinct reward in each channel, ``(V, C)``; default: indicators, C = V.
        policy: ``shared`` (every discount bootstraps from the action greedy at ``acting_gamma``), ``per_gamma``
            (each from its own), or one to evaluate, int ``(S,)`` or float ``(S, A)``: its mean over the actions.
        rate: learning rate by the number of earlier visits of the state and action.

    Raises:
        InputError: arguments that do not fit the world, or a table beyond ``MAX_TABLE``.
    """

    def __init__(
        self,
        world: World,
        gammas: np.ndarray,
        *,
        channels: np.ndarray | None = None,
        policy: str | np.ndarray = "shared",
        acting_gamma: float = 0.99,
        rate: Decay = Decay(),
    ) -> None:
        rewards = world.reward_values
        width = rewards.size
        if channels is not None:
            channels = np.asarray(channels, dtype=float)
            width = channels.shape[-1] if channels.ndim else 0
        if channels is not None and (channels.ndim != 2 or len(channels) != rewards.size):
            raise InputError(f"channels must be ({rewards.size}, C), one row a distinct reward, not {channels.shape}.")
        gammas = np.append(np.asarray(gammas, dtype=float).ravel(), acting_gamma)
        if not np.all((gammas > 0) & (gammas < 1)):
            raise InputError("discounts must be numbers between 0 and 1, both excluded.")
        if isinstance(policy, str) and policy not in TARGET_POLICIES:
            raise InputError(f"policy {policy!r} is not one of {', '.join(TARGET_POLICIES)}, nor a table.")
        shape = (world.n_states, world.n_actions, gammas.size, width + 1)
        if np.prod(shape, dtype=float) > MAX_TABLE:
            raise InputError(f"a table of {shape} exceeds {MAX_TABLE:,} numbers: fewer discounts or channels fit.")
        given: np.ndarray = np.zeros(0) if isinstance(policy, str) else check_policy(world, policy)
        self.policy = policy if isinstance(policy, str) else given
        self._mode = policy if isinstance(policy, str) else ("given" if given.ndim == 1 else "mixed")
        self._mixed, self._cumulated = given, _cumulated(given) if self._mode == "mixed" else given
        self.rate, self._visits = rate, [[0] * world.n_actions for _ in world.states]
        self._table = np.zeros(shape)
        self._rewards = rewards
        self._channels = None if channels is None else np.column_stack([channels, rewards])
        self._indicator, self._last = np.zeros(width + 1), 0
        self._gammas, self._rows, self._work = gammas[:, None], np.arange(gammas.size), np.empty(shape[2:])
        self._greedy = np.zeros((world.n_states, gammas.size), dtype=np.int64)  # a* at each discount
        if self._mode == "given":
            self._greedy += given[:, None]

    @property
    def table(self) -> np.ndarray:
        """What was asked for, ``(S, A, G, C)``: W, or gamma-space and the constant channel; a live view."""
        return self._table[:, :, :-1, :-1]

    @property
    def values(self) -> np.ndarray:
        """Expected discounted return at each discount, ``(S, A, G)``, in units of reward; a live view."""
        return self._table[:, :, :-1, -1]

    @property
    def acting_values(self) -> np.ndarray:
        """Expected return at ``acting_gamma``, ``(S, A)``; a live view."""
        return self._table[:, :, -1, -1]

    def act(self, state: int, draw: float = 0.0) -> int:
        """The target policy's action (at ``acting_gamma``); ``draw`` in [0, 1) decides where it is stochastic."""
        if self._mode == "mixed":
            return int(np.searchsorted(self._cumulated[state], draw, side="right"))
        return int(self._greedy[state, -1])

    def update(self, transition: Transition) -> None:
        """Learn from one transition, for all discounts and channels."""
        state, action, _, kind, next_state = transition
        following = None if next_state == END else self._following(next_state)
        rate = self.rate(self._visits[state][action])
        self._visits[state][action] += 1
        now = self._activation(kind)
        td_update(self._table[state, action], following, now, self._gammas, rate=rate, work=self._work)
        if self._mode == "shared":
            self._greedy[state, -1] = first_best(self._table[state, :, -1, -1].tolist())
        elif self._mode == "per_gamma":
            self._greedy[state] = greedy_action(self._table[state, :, :, -1], axis=0)

    def _activation(self, kind: int) -> np.ndarray:
        """What a reward gives in each channel and, last, itself; no matrix of rewards by rewards is ever made."""
        if self._channels is not None:
            return self._channels[kind]
        self._indicator[self._last] = 0.0
        self._indicator[[kind, -1]] = 1.0, self._rewards[kind]
        self._last = kind
        return self._indicator

    def _following(self, state: int) -> np.ndarray:
        """Values of a state under the target policy, ``(G, C)``."""
        values = self._table[state]
        if self._mode == "mixed":
            return np.tensordot(self._mixed[state], values, axes=1)
        if self._mode == "per_gamma":
            return values[self._greedy[state], self._rows]
        return values[self._greedy[state, -1]]


def first_best(values: Sequence[float]) -> int:
    """:func:`laplace_core.code.ties.greedy_action` of a short list, without the cost of small arrays."""
    best = max(values)
    size = max(map(abs, values))
    enough = best - max(TIE_TOLERANCE * abs(best), ROUNDING * size)
    return next(a for a, value in enumerate(values) if value >= enough)


def learn(world: World, learners: Sequence[Any], schedule: Schedule) -> Iterator[Progress]:
    """Feed the same sampled transitions to all learners (``values``, ``act``, ``update``); the first one acts.

    A generator: between two events learning stands still, may be read, and may be left for good.
    The same seed gives the same events and the same tables.
    """
    leader, sampler = learners[0], Sampler(world, schedule.seed)
    draw, before, steps = sampler.draw, np.array(leader.values), 0
    for episode in range(1, schedule.episodes + 1):
        epsilon = schedule.epsilon(episode - 1)
        state, episode_return = sampler.first_state(schedule.starts), 0.0
        for _ in range(schedule.max_steps):
            action = int(draw() * world.n_actions) if draw() < epsilon else leader.act(state, draw())
            transition = sampler.step(state, action)
            for learner in learners:
                learner.update(transition)
            steps += 1
            episode_return += transition.reward
            state = transition.next_state
            if state == END:
                break
        if episode % schedule.every == 0 or episode == schedule.episodes:
            change = float(np.abs(leader.values - before).max())
            before = np.array(leader.values)
            yield Progress(episode, steps, episode_return, state != END, change, epsilon)
