"""Small random worlds for property tests (hypothesis), and the same world under other state numbers."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from laplace_core.worlds import END, Outcome, World

# Quarters are exact in binary, so that equal rewards are equal numbers.
rewards = st.integers(-8, 12).map(lambda quarters: quarters / 4)
weights = st.integers(1, 8)
discounts = st.lists(st.integers(5, 95), min_size=2, max_size=5, unique=True).map(lambda p: np.sort(p) / 100)


@st.composite
def worlds(draw, max_states: int = 6, max_actions: int = 3, *, ends: bool = False) -> World:
    """A world of up to three outcomes a pair, any of which may terminate; some worlds run for ever.

    Args:
        ends: every step terminates with a chance of at least 1/2, so that 60 steps hold all there is.
    """
    n_states, n_actions = draw(st.integers(1, max_states)), draw(st.integers(1, max_actions))
    successors = st.integers(END, n_states - 1)
    outcomes = []
    for state in range(n_states):
        for action in range(n_actions):
            rows = draw(st.lists(st.tuples(weights, successors, rewards), min_size=1, max_size=3))
            if ends:
                rows.append((sum(row[0] for row in rows), END, draw(rewards)))
            total = sum(row[0] for row in rows)
            outcomes += [Outcome(state, action, weight / total, *goal) for weight, *goal in rows]
    states = [f"s{i}" for i in range(n_states)]
    return World.from_outcomes("random", states, [f"a{i}" for i in range(n_actions)], outcomes)


@st.composite
def policies(draw, world: World) -> np.ndarray:
    """A deterministic int ``(S,)`` or a stochastic float ``(S, A)`` policy."""
    if draw(st.booleans()):
        actions = st.integers(0, world.n_actions - 1)
        return np.array(draw(st.lists(actions, min_size=world.n_states, max_size=world.n_states)))
    size = world.n_states * world.n_actions
    table = np.array(draw(st.lists(weights, min_size=size, max_size=size)), dtype=float)
    table = table.reshape(world.n_states, world.n_actions)
    return table / table.sum(axis=1, keepdims=True)


@st.composite
def worlds_with_policy(draw, **limits) -> tuple[World, np.ndarray]:
    world = draw(worlds(**limits))
    return world, draw(policies(world))


def renamed(world: World, order: list[int]) -> World:
    """The same world with state i at place ``order[i]``."""
    place = {**dict(enumerate(order)), END: END}
    rows = [
        Outcome(place[row.state], row.action, row.probability, place[row.next_state], row.reward)
        for state in range(world.n_states)
        for action in range(world.n_actions)
        for row in world.outcomes(state, action)
    ]
    states = [world.states[i] for i in np.argsort(order)]
    return World.from_outcomes("renamed", states, world.actions, rows)
