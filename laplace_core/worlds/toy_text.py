"""gymnasium's toy-text environments that publish a transition table, as worlds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.parameters import Parameter, as_text, parse_named
from laplace_core.worlds.model import END, Outcome, World

_SLIPPERY = Parameter("is_slippery", True, help="Whether a move may go sideways.")
_SUCCESS = Parameter("success_rate", 1 / 3, 0, 1, "Chance that a move on slippery ice goes where it was meant to.")

# A fixed list: a name from outside never reaches gymnasium.make.
TOY_TEXT: dict[str, tuple[Parameter, ...]] = {
    "FrozenLake-v1": (_SLIPPERY, _SUCCESS),
    "FrozenLake8x8-v1": (_SLIPPERY, _SUCCESS),
    "CliffWalking-v1": (Parameter("is_slippery", False, help="Whether a move may go sideways."),),
    "CliffWalkingSlippery-v1": (),
    "Taxi-v4": (
        Parameter("is_rainy", False, help="Whether a move may go sideways."),
        Parameter("fickle_passenger", False, help="Whether the passenger may change the destination."),
        Parameter("rainy_probability", 0.8, 0, 1, "Chance that a move in the rain goes where it was meant to."),
        Parameter("fickle_probability", 0.3, 0, 1, "Chance that a fickle passenger changes the destination."),
    ),
}
"""Names, in the version of the pinned gymnasium, and what can be set."""

_NEEDS = {"success_rate": "is_slippery", "rainy_probability": "is_rainy", "fickle_probability": "fickle_passenger"}
"""Parameters that say how much of something there is, and the one that says whether there is any."""


def toy_text_name(name: str) -> str:
    """The full name of a listed environment, given with or without its version.

    Raises:
        InputError: not on the list.
    """
    for known in TOY_TEXT:
        if name in (known, known.rsplit("-v", 1)[0]):
            return known
    raise InputError(f"gym:{name[:40]} is not one of gym:{', gym:'.join(TOY_TEXT)}.")


def toy_text_limit(name: str) -> int | None:
    """Steps after which gymnasium itself truncates an episode; None where it never does.

    Raises:
        InputError: a name that is not listed.
    """
    import gymnasium

    return gymnasium.spec(toy_text_name(name)).max_episode_steps


def toy_text_world(name: str, params: Mapping[str, Any] | None = None) -> World:
    """Build a world from the transition table ``P[s][a] = [(p, s', r, terminated), ...]``.

    Raises:
        InputError: a name or parameter that is not listed, or a parameter that another one makes meaningless.
    """
    import gymnasium  # slow to import, and only needed here

    name = toy_text_name(name)
    options = _options(name, dict(params or {}))
    env: Any = gymnasium.make(name, **options).unwrapped  # what toy text environments have, no type says
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
    if options.get("fickle_passenger"):
        rows = list(_fickle(env, rows, options["fickle_probability"]))
        states += [f"{state}, settled" for state in states]
        start = np.concatenate([start, np.zeros(n_states)])
    actions = _ACTIONS[name.split("-")[0].removesuffix("8x8").removesuffix("Slippery")]
    suggested = {"gammas": 30, "spacing": "log", "gamma_min": 0.3, "alpha": 0.01, "steps": 60}
    return World.from_outcomes(
        f"gym:{name}",
        states,
        actions,
        rows,
        start=start,
        suggested=suggested,
        positions=_positions(env, name, n_states),
    )


def _options(name: str, params: dict[str, Any]) -> dict[str, Any]:
    """Every parameter of an environment.

    Raises:
        InputError: a value that does not fit, or that would be ignored.
    """
    given = parse_named(f"gym:{name}", TOY_TEXT[name], params)
    options = {parameter.name: given.get(parameter.name, parameter.default) for parameter in TOY_TEXT[name]}
    for parameter in TOY_TEXT[name]:
        needed = _NEEDS.get(parameter.name)
        if needed and not options[needed] and options[parameter.name] != parameter.default:
            raise InputError(
                f"{parameter.name}={as_text(options[parameter.name])} changes nothing without {needed}=true: "
                "give both, or neither."
            )
    return options


def _fickle(env: Any, rows: list[Outcome], chance: float) -> Iterator[Outcome]:
    """The outcomes with a passenger who may change the destination once, on the first move with him aboard.

    gymnasium draws at the start whether he will, and tells nobody until he does: that is the same process as drawing
    it on that move. States come twice: the first half before that move, the second half, "settled", after it.
    """
    n_states = len(env.P)
    places = [env.decode(s) for s in range(n_states)]
    for s, a, p, successor, r in rows:
        yield Outcome(n_states + s, a, p, successor if successor == END else n_states + successor, r)
        aboard = places[s][2] == 4
        if successor == END or not aboard or places[s][:2] == places[successor][:2]:
            yield Outcome(s, a, p, successor, r)
            continue
        row, column, passenger, goal = places[successor]
        if chance < 1.0:
            yield Outcome(s, a, p * (1.0 - chance), n_states + successor, r)
        others = [other for other in range(4) if other != goal and chance > 0.0]
        for other in others:
            changed = env.encode(row, column, passenger, other)
            yield Outcome(s, a, p * chance / len(others), n_states + changed, r)


_ACTIONS = {
    "FrozenLake": ("left", "down", "right", "up"),
    "CliffWalking": ("up", "right", "down", "left"),
    "Taxi": ("south", "north", "east", "west", "pick up", "drop off"),
}


def _state_name(env: Any, name: str, state: int) -> str:
    if name.startswith("Taxi"):
        row, column, passenger, goal = env.decode(state)
        where = ("R", "G", "Y", "B", "taxi")[passenger]
        return f"({row}, {column}) passenger {where}, to {'RGYB'[goal]}"
    columns = 12 if name.startswith("Cliff") else env.ncol
    row, column = divmod(state, columns)
    return f"({row}, {column})"


def _positions(env: Any, name: str, n_states: int) -> np.ndarray | None:
    if name.startswith("Taxi"):
        return None
    columns = 12 if name.startswith("Cliff") else env.ncol
    row, column = np.divmod(np.arange(n_states), columns)
    return np.stack([column, -row], axis=1).astype(float)
