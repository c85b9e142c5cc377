"""A tabular Markov decision process with discrete stochastic rewards and termination."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields
from functools import cached_property, partial
from types import MappingProxyType
from typing import Any, NamedTuple

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
    """One possible outcome of a state and an action (all indices; ``next_state`` may be END)."""

    state: int
    action: int
    probability: float
    next_state: int
    reward: float


@dataclass(frozen=True, eq=False)
class World:
    """A tabular MDP as a flat list of outcomes, sorted by (state, action).

    Every state offers every action. However a world is made (:meth:`from_outcomes`, the constructor,
    ``dataclasses.replace``), it is checked, its outcomes are sorted, its probabilities add up to 1 and its arrays are
    read-only. Worlds compare and hash by identity, so that results can be cached per world.

    Attributes:
        states, actions: names, S and A of them.
        start: P(first state), shape ``(S,)``.
        state, action, next_state, probability, reward: the N outcomes, shape ``(N,)`` each.
        suggested: settings that suit this world (steps, alpha, ...), by the name of the setting.
        positions: where to draw each state, shape ``(S, 2)``, or None.
        source, params: what :func:`laplace_core.load_world` builds the same world from; empty if made by hand.

    Raises:
        InputError: sizes, names, indices, rewards or probabilities that make no MDP.
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
        *,
        start: np.ndarray | None = None,
        suggested: Mapping[str, object] | None = None,
        positions: np.ndarray | None = None,
    ) -> World:
        """Validate and build; ``start`` defaults to the first state.

        Raises:
            InputError: sizes, names, indices, rewards or probabilities that make no MDP.
        """
        states, actions = tuple(states), tuple(actions)
        _check_names("state", states, MAX_STATES)  # before the first outcome is read: there may be very many
        _check_names("action", actions, MAX_STATES)
        table = list(outcomes)
        if not table or len(table) > MAX_OUTCOMES:
            raise InputError(f"world {name!r} has {len(table)} outcomes; it needs 1 to {MAX_OUTCOMES:,}.")
        state, action, next_state = (np.array([row[i] for row in table], dtype=np.int64) for i in (0, 1, 3))
        probability, reward = (np.array([row[i] for row in table], dtype=float) for i in (2, 4))
        if start is None:
            start = np.eye(1, len(states))[0]
        return cls(
            name, states, actions, start, state, action, next_state, probability, reward, suggested or {}, positions
        )

    def __post_init__(self) -> None:
        put = partial(object.__setattr__, self)
        put("states", tuple(self.states))
        put("actions", tuple(self.actions))
        put("suggested", MappingProxyType(dict(self.suggested)))
        _check_names("state", self.states, MAX_STATES)
        _check_names("action", self.actions, MAX_STATES)
        columns = {name: _column(self, name, kind) for name, kind in _COLUMNS.items()}
        _check_outcomes(self.name, self.states, self.actions, **columns)
        pair = columns["state"] * self.n_actions + columns["action"]
        if np.any(np.diff(pair) < 0):
            order = np.argsort(pair, kind="stable")
            pair, columns = pair[order], {name: column[order] for name, column in columns.items()}
        totals = _totals(self, pair, columns["probability"])
        columns["probability"] = columns["probability"] / totals[pair]
        columns["start"] = _start_distribution(self.name, self.states, self.start)
        if self.positions is not None:
            columns["positions"] = _positions(self.name, self.states, self.positions)
        for name, column in columns.items():
            column.setflags(write=False)
            put(name, column)

    def __getstate__(self) -> dict[str, object]:
        # What is cached is left behind, and a mapping proxy cannot be pickled.
        return {entry.name: getattr(self, entry.name) for entry in fields(self)} | {"suggested": dict(self.suggested)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state | {"suggested": MappingProxyType(state["suggested"])})
        for value in state.values():
            if isinstance(value, np.ndarray):
                value.setflags(write=False)

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
    def absorbing(self) -> np.ndarray:
        """Where, whatever is done, only rewards of exactly 0 follow for ever and END is never reached, bool ``(S,)``.

        Entering such a state is the end of the episode in all but name, and counts as the end.
        """
        from scipy.sparse.csgraph import breadth_first_order  # slow to import

        possible = self.probability > 0
        state, following = self.state[possible], self.next_state[possible]
        lively = np.zeros(self.n_states, dtype=bool)
        lively[state[(self.reward[possible] != 0) | (following == END)]] = True
        # Backwards along every move, from one node in front of all lively states: what is reached can become lively.
        n, inside = self.n_states, following != END
        tails = np.concatenate([following[inside], np.full(np.count_nonzero(lively), n)])
        heads = np.concatenate([state[inside], np.flatnonzero(lively)])
        backwards = sparse.csr_array((np.ones(tails.size), (tails, heads)), shape=(n + 1, n + 1))
        reached = breadth_first_order(backwards, n, return_predecessors=False)
        absorbing = np.ones(n + 1, dtype=bool)
        absorbing[reached] = False
        absorbing = absorbing[:n]
        absorbing.setflags(write=False)
        return absorbing

    @cached_property
    def following(self) -> np.ndarray:
        """The next state of each outcome, and END where it is an absorbing one, int ``(N,)``."""
        # END is -1 and picks the last entry, which stands for it.
        following = np.where(np.append(self.absorbing, True)[self.next_state], END, self.next_state)
        following.setflags(write=False)
        return following

    @cached_property
    def transition_matrix(self) -> sparse.csr_array:
        """P(s' | s, a), alive only, shape ``(S*A, S)``: rows of pairs that may end the episode sum to less than 1.

        An episode ends at END and on entering an :attr:`absorbing` state.
        """
        alive = self.following != END
        shape = (self.n_states * self.n_actions, self.n_states)
        return sparse.csr_array((self.probability[alive], (self._pair[alive], self.following[alive])), shape=shape)

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
        """Outcomes of one state and action (indices), absorbing next states by their own index."""
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
            listed = ", ".join(self.states[:6]) + (", ..." if self.n_states > 6 else "")
            given, last = str(state)[:40], self.n_states - 1
            raise InputError(f"state {given!r} is not in world {self.name!r}: use 0 to {last} or a name ({listed}).")
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
            raise InputError(f"{name!r} is reserved and cannot be the name of one of the {kind}s.")
        if name in seen:
            raise InputError(f"{kind} {name!r} is listed twice.")
        seen.add(name)


_COLUMNS = {
    "state": np.int64, "action": np.int64, "next_state": np.int64, "probability": np.float64, "reward": np.float64,
}  # fmt: skip
ROUNDING = 1e-14
"""A sum of probabilities that is this near to 1 is left as it is, so that a world built again keeps its last digit."""


def _column(world: World, name: str, kind: type) -> np.ndarray:
    """A copy of one column in its own type, ``(N,)``."""
    given = np.asarray(getattr(world, name))
    if given.ndim != 1 or given.dtype.kind not in ("iu" if kind is np.int64 else "iuf"):
        what = "whole numbers" if kind is np.int64 else "numbers"
        raise InputError(f"world {world.name!r}: {name} must be a list of {what}, one an outcome.")
    return given.astype(kind)


def _check_outcomes(
    name: str,
    states: tuple[str, ...],
    actions: tuple[str, ...],
    state: np.ndarray,
    *,
    action: np.ndarray,
    next_state: np.ndarray,
    probability: np.ndarray,
    reward: np.ndarray,
) -> None:
    sizes = {column.size for column in (state, action, next_state, probability, reward)}
    if len(sizes) > 1:
        raise InputError(f"world {name!r} has columns of {min(sizes)} to {max(sizes)} outcomes; all must be as long.")
    if not 1 <= state.size <= MAX_OUTCOMES:
        raise InputError(f"world {name!r} has {state.size} outcomes; it needs 1 to {MAX_OUTCOMES:,}.")
    if state.min() < 0 or state.max() >= len(states) or action.min() < 0 or action.max() >= len(actions):
        raise InputError(f"world {name!r} has an outcome outside its {len(states)} states and {len(actions)} actions.")
    if next_state.min() < END or next_state.max() >= len(states):
        raise InputError(f"world {name!r} has an outcome that leads outside its {len(states)} states.")
    if not np.all(np.isfinite(probability)) or probability.min() < 0:
        raise InputError(f"world {name!r} has a probability that is negative or not a finite number.")
    if not np.all(np.abs(reward) <= MAX_REWARD):
        raise InputError(f"world {name!r} has a reward that is not a number within +-{MAX_REWARD:g}.")


def _totals(world: World, pair: np.ndarray, probability: np.ndarray) -> np.ndarray:
    """The sum of the probabilities of each (state, action), ``(S*A,)``."""
    totals = np.bincount(pair, weights=probability, minlength=world.n_states * world.n_actions)
    off = np.flatnonzero(np.abs(totals - 1.0) > PROBABILITY_TOLERANCE)
    if off.size:
        s, a = divmod(int(off[0]), world.n_actions)
        raise InputError(
            f"the outcomes of state {world.states[s]!r}, action {world.actions[a]!r} have total probability "
            f"{totals[off[0]]:.9g}; it must be 1."
        )
    return np.where(np.abs(totals - 1.0) <= ROUNDING, 1.0, totals)


def _start_distribution(name: str, states: tuple[str, ...], start: np.ndarray) -> np.ndarray:
    start = np.array(start, dtype=float)
    if start.shape != (len(states),) or not np.all(np.isfinite(start)) or start.min() < 0:
        raise InputError(f"world {name!r} needs one non-negative start probability a state.")
    total = start.sum()
    if abs(total - 1.0) > PROBABILITY_TOLERANCE:
        raise InputError(f"the start probabilities of world {name!r} add up to {total:.9g}; they must be 1.")
    return start if abs(total - 1.0) <= ROUNDING else start / total


def _positions(name: str, states: tuple[str, ...], positions: np.ndarray) -> np.ndarray:
    positions = np.array(positions, dtype=float)
    if positions.shape != (len(states), 2) or not np.all(np.isfinite(positions)):
        raise InputError(f"world {name!r} needs one finite place [x, y] a state, or no positions.")
    return positions
