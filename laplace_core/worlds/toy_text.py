"""gymnasium's toy-text environments that publish a transition table, as worlds."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from laplace_core.errors import InputError
from laplace_core.parameters import Parameter, parse_named
from laplace_core.worlds.model import END, Outcome, World

_SLIPPERY = Parameter("is_slippery", True, 0, 1, "Whether a move may go sideways.")

# A fixed list: a name from outside never reaches gymnasium.make.
TOY_TEXT: dict[str, tuple[Parameter, ...]] = {
    "FrozenLake-v1": (_SLIPPERY,),
    "FrozenLake8x8-v1": (_SLIPPERY,),
    "CliffWalking-v1": (Parameter("is_slippery", False, 0, 1, "Whether a move may go sideways."),),
    "CliffWalkingSlippery-v1": (),
    "Taxi-v4": (
        Parameter("is_rainy", False, 0, 1, "Whether a move may go sideways."),
        Parameter("fickle_passenger", False, 0, 1, "Whether the passenger may change the destination."),
    ),
}
"""Names, in the version of the pinned gymnasium, and what can be set."""


def toy_text_name(name: str) -> str:
    """The full name of a listed environment, given with or without its version.

    Raises:
        InputError: not on the list.
    """
    for known in TOY_TEXT:
        if name in (known, known.rsplit("-v", 1)[0]):
            return known
    raise InputError(f"gym:{name[:40]} is not one of gym:{', gym:'.join(TOY_TEXT)}.")


def toy_text_world(name: str, params: Mapping[str, object] | None = None) -> World:
    """Build a world from the transition table ``P[s][a] = [(p, s', r, terminated), ...]``.

    Raises:
        InputError: a name or parameter that is not listed.
    """
    import gymnasium  # slow to import, and only needed here

    name = toy_text_name(name)
    options = parse_named(f"gym:{name}", TOY_TEXT[name], dict(params or {}))
    env = gymnasium.make(name, **options).unwrapped
    try:
        n_states, n_actions = int(env.observation_space.n), int(env.action_space.n)
        rows = [
            Outcome(s, a, float(p), END if terminated else int(successor), float(r))
            for s in range(n_states)
            for a in range(n_actions)
            for p, successor, r, terminated in env.P[s][a]
            if p > 0
        ]
        start = np.asarray(env.initial_state_distrib, dtype=float)
    finally:
        env.close()
    states = [_state_name(env, name, s) for s in range(n_states)]
    actions = _ACTIONS.get(name.split("-")[0].removesuffix("8x8").removesuffix("Slippery"))
    suggested = {"gammas": 30, "spacing": "log", "gamma_min": 0.3, "alpha": 0.01, "steps": 60}
    return World.from_outcomes(
        f"gym:{name}", states, actions, rows, start, suggested=suggested, positions=_positions(env, name, n_states)
    )


_ACTIONS = {
    "FrozenLake": ("left", "down", "right", "up"),
    "CliffWalking": ("up", "right", "down", "left"),
    "Taxi": ("south", "north", "east", "west", "pick up", "drop off"),
}


def _state_name(env, name: str, state: int) -> str:
    if name.startswith("Taxi"):
        row, column, passenger, goal = env.decode(state)
        where = ("R", "G", "Y", "B", "taxi")[passenger]
        return f"({row}, {column}) passenger {where}, to {'RGYB'[goal]}"
    columns = 12 if name.startswith("Cliff") else env.ncol
    row, column = divmod(state, columns)
    return f"({row}, {column})"


def _positions(env, name: str, n_states: int) -> np.ndarray | None:
    if name.startswith("Taxi"):
        return None
    columns = 12 if name.startswith("Cliff") else env.ncol
    row, column = np.divmod(np.arange(n_states), columns)
    return np.stack([column, -row], axis=1).astype(float)
