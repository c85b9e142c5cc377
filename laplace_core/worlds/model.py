"""A tabular Markov decision process with discrete stochastic rewards and termination."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from scipy import sparse

from laplace_core.errors import InputError

END = -1
"""The next state of an outcome that terminates the episode."""

MAX_STATES = 5_000
MAX_OUTCOMES = 1_000_000
MAX_REWARD = 1e9
PROBABILITY_TOLERANCE = 1e-6


class Outcome(NamedTuple):
    """One thing that may happen after a state and an action (all indices; ``next_state`` may be END)."""

    state: int
    action: int
    probability: float
    next_state: int
    reward: float


@dataclass(frozen=True, eq=False)
class World:
    """A tabular MDP as a flat list of outcomes, sorted by (state, action).

    Every state offers every action. Build one with :meth:`from_outcomes`, which validates; worlds compare
    and hash by identity, so that results can be cached per world.

    Attributes:
        states, actions: names, S and A of them.
        start: P(first state), shape ``(S,)``.
        state, action, next_state, probability, reward: the N outcomes, shape ``(N,)`` each.
        suggested: settings that suit this world (steps, alpha, ...), by the name of the setting.
        positions: where to draw each state, shape ``(S, 2)``, or None.
        source, params: what :func:`laplace_core.load_world` builds the same world from; empty if made by hand.
    """

    name: str
    states: tuple[str, ...]
    actions: tuple[str, ...]
    start: np.ndarray
    state: np.ndarray
    action: np.ndarray
    next_state: np.ndarray
    probability: np.ndarray
    reward: np.ndarray
    suggested: Mapping[str, object] = field(default_factory=lambda: MappingProxyType({}))
    positions: np.ndarray | None = None
    source: str = ""
    params: tuple[tuple[str, object], ...] = ()

    @classmethod
    def from_outcomes(
        cls,
        name: str,
        states: Iterable[str],
        actions: Iterable[str],
        outcomes: Iterable[Outcome],
        start: np.ndarray | None = None,
        suggested: Mapping[str, object] | None = None,
        positions: np.ndarray | None = None,
    ) -> World:
        """Validate and build; ``start`` defaults to the first state.

        Raises:
            InputError: sizes, names, indices, rewards or probabilities that make no MDP.
        """
        states, actions = tuple(states), tuple(actions)
        _check_names("state", states, MAX_STATES)
        _check_names("action", actions, MAX_STATES)
        table = list(outcomes)
        if not table or len(table) > MAX_OUTCOMES:
            raise InputError(f"world {name!r} has {len(table)} outcomes; it needs 1 to {MAX_OUTCOMES:,}.")
        state, action, next_state = (np.array([row[i] for row in table], dtype=np.int64) for i in (0, 1, 3))
        probability, reward = (np.array([row[i] for row in table], dtype=float) for i in (2, 4))
        _check_outcomes(name, states, actions, state, action, next_state, probability, reward)
        order = np.lexsort((action, state))
        state, action, next_state, probability, reward = (
            column[order] for column in (state, action, next_state, probability, reward)
        )
        totals = np.bincount(state * len(actions) + action, weights=probability, minlength=len(states) * len(actions))
        off = np.flatnonzero(np.abs(totals - 1.0) > PROBABILITY_TOLERANCE)
        if off.size:
            s, a = divmod(int(off[0]), len(actions))
            raise InputError(
                f"the outcomes of state {states[s]!r}, action {actions[a]!r} have total probability "
                f"{totals[off[0]]:.9g}; it must be 1."
            )
        probability = probability / totals[state * len(actions) + action]
        start = _start_distribution(name, states, start)
        for column in (state, action, next_state, probability, reward, start):
            column.setflags(write=False)
        return cls(
            name, states, actions, start, state, action, next_state, probability, reward,
            MappingProxyType(dict(suggested or {})), positions,
        )  # fmt: skip

    @property
    def n_states(self) -> int:
        return len(self.states)

    @property
    def n_actions(self) -> int:
        return len(self.actions)

    @cached_property
    def _pair(self) -> np.ndarray:
        """Row of each outcome in the (S*A, ...) matrices, increasing, shape ``(N,)``."""
        return self.state * self.n_actions + self.action

    @cached_property
    def transition_matrix(self) -> sparse.csr_array:
        """P(s' | s, a), alive only, shape ``(S*A, S)``: rows of terminating pairs sum to less than 1."""
        alive = self.next_state != END
        shape = (self.n_states * self.n_actions, self.n_states)
        return sparse.csr_array((self.probability[alive], (self._pair[alive], self.next_state[alive])), shape=shape)

    @cached_property
    def reward_values(self) -> np.ndarray:
        """The V distinct rewards in increasing order."""
        return np.unique(self.reward)

    @cached_property
    def reward_probabilities(self) -> sparse.csr_array:
        """P(r = reward_values[v] | s, a), shape ``(S*A, V)``."""
        columns = np.searchsorted(self.reward_values, self.reward)
        shape = (self.n_states * self.n_actions, self.reward_values.size)
        return sparse.csr_array((self.probability, (self._pair, columns)), shape=shape)

    @cached_property
    def expected_reward(self) -> np.ndarray:
        """E[r | s, a], shape ``(S, A)``."""
        return (self.reward_probabilities @ self.reward_values).reshape(self.n_states, self.n_actions)

    def outcomes(self, state: int, action: int) -> list[Outcome]:
        """What may happen after one state and action (indices)."""
        first, last = np.searchsorted(
            self._pair, [state * self.n_actions + action, state * self.n_actions + action + 1]
        )
        rows = zip(self.probability[first:last], self.next_state[first:last], self.reward[first:last], strict=True)
        return [Outcome(state, action, float(p), int(successor), float(r)) for p, successor, r in rows]

    def state_index(self, state: str | int) -> int:
        """Index of a state given by name, by index, or by its index as text.

        Raises:
            InputError: no such state.
        """
        if isinstance(state, str) and state in self._index_of_state:
            return self._index_of_state[state]
        try:
            index = int(state)
        except ValueError:
            index = -1
        if not 0 <= index < self.n_states:
            shown = ", ".join(self.states[:6]) + (", ..." if self.n_states > 6 else "")
            given, last = str(state)[:40], self.n_states - 1
            raise InputError(f"state {given!r} is not in world {self.name!r}: use 0 to {last} or a name ({shown}).")
        return index

    @cached_property
    def _index_of_state(self) -> dict[str, int]:
        return {name: index for index, name in enumerate(self.states)}


def _check_names(kind: str, names: tuple[str, ...], most: int) -> None:
    if not 1 <= len(names) <= most:
        raise InputError(f"there are {len(names)} {kind}s; a world needs 1 to {most:,}.")
    seen = set()
    for name in names:
        if not isinstance(name, str) or not name or len(name) > 100 or not name.isprintable():
            raise InputError(f"{kind} name {str(name)[:40]!r} must be 1 to 100 printable characters.")
        if name == "END" or name == "*":
            raise InputError(f"{name!r} has a meaning of its own and cannot be the name of one of the {kind}s.")
        if name in seen:
            raise InputError(f"{kind} {name!r} is listed twice.")
        seen.add(name)


def _check_outcomes(name, states, actions, state, action, next_state, probability, reward) -> None:
    if state.min() < 0 or state.max() >= len(states) or action.min() < 0 or action.max() >= len(actions):
        raise InputError(f"world {name!r} has an outcome outside its {len(states)} states and {len(actions)} actions.")
    if next_state.min() < END or next_state.max() >= len(states):
        raise InputError(f"world {name!r} has an outcome that leads outside its {len(states)} states.")
    if not np.all(np.isfinite(probability)) or probability.min() < 0:
        raise InputError(f"world {name!r} has a probability that is negative or not a finite number.")
    if not np.all(np.abs(reward) <= MAX_REWARD):
        raise InputError(f"world {name!r} has a reward that is not a number within +-{MAX_REWARD:g}.")


def _start_distribution(name: str, states: tuple[str, ...], start: np.ndarray | None) -> np.ndarray:
    if start is None:
        start = np.eye(1, len(states))[0]
    start = np.array(start, dtype=float)
    if start.shape != (len(states),) or not np.all(np.isfinite(start)) or start.min() < 0:
        raise InputError(f"world {name!r} needs one non-negative start probability a state.")
    if abs(start.sum() - 1.0) > PROBABILITY_TOLERANCE:
        raise InputError(f"the start probabilities of world {name!r} add up to {start.sum():.9g}; they must be 1.")
    return start / start.sum()
