"""Random views, most of them unfavourable, on which verdicts are examined.

A view is the subject of a verdict: a world, a state, settings and a horizon. Worlds are presets with random parameters
and random worlds of every shape that tells the settings apart; settings go from careful to careless, one independently
of another, so that about half of the views choose wrongly or choose rightly on values that are off, each for a reason
of another kind.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from laplace_core.parameters import Parameter
from laplace_core.planning import finite_horizon_optimum
from laplace_core.study.horizon import row_horizons
from laplace_core.study.settings import ResolvedForWorld, Settings, resolve
from laplace_core.worlds import END, PRESETS, Outcome, World, load_world

MOST_ROWS = 200
SWITCHED = 0.25
"""Share of the views with one to three of the lens's switches thrown."""
VALUE_GAMMAS = (0.5, 0.8, 0.9, 0.95, 0.99, 0.999)


@dataclass(frozen=True, eq=False)
class View:
    """The subject of one verdict.

    Attributes:
        settings: resolved for the world.
        row: column of the horizon values, from 0.
        action: the action whose timeline is looked at; None: the chosen one.
    """

    world: World
    settings: ResolvedForWorld
    row: int
    action: int | None = None


def draw_view(rng: np.random.Generator) -> View:
    """A random view; it can always be decoded."""
    world, length = _WORLDS[rng.choice(len(_WORLDS), p=_SHARES)](rng)
    settings = _settings(rng, world, length)
    reached = min(settings.steps, max(1, int(np.ceil((length + 1) / settings.time_step))))
    kind = rng.choice(3, p=[0.5, 0.25, 0.25])
    if kind == 0 and world.n_actions > 1:
        row = _closest_decision(world, settings, reached)
    else:
        row = int(rng.integers(settings.steps if kind == 1 else reached))
    action = None if rng.random() < 0.7 else int(rng.integers(world.n_actions))
    return View(world, _switched(rng, settings, row), row, action)


def _closest_decision(world: World, settings: ResolvedForWorld, rows: int) -> int:
    """The row, of the first ``rows``, at which the best two actions differ by the least share, but do differ."""
    steps = np.maximum(1, np.rint(np.arange(rows) * settings.time_step + (1.0 + settings.time_step) / 2.0).astype(int))
    values = finite_horizon_optimum(world, steps[-1], settings.acting_gamma, world.state_index(settings.state))
    worst, best = np.sort(values, axis=1)[steps - 1][:, [-2, -1]].T
    margin = (best - worst) / np.maximum(np.abs(best), 1e-12)
    return int(np.argmin(np.where(margin > 1e-6, margin, np.inf)))


# --- settings ---


def _settings(rng: np.random.Generator, world: World, length: int) -> ResolvedForWorld:
    """Each setting is careless with the same chance, which is drawn first: some views have one fault, some many."""
    chance = float(rng.choice([0.0, 0.1, 0.25, 0.6], p=[0.45, 0.35, 0.15, 0.05]))

    def careless() -> bool:
        return bool(rng.random() < chance)

    time_step = float(rng.choice([1.0, 0.5, 0.25, 1.0 / 3.0], p=[0.79, 0.07, 0.07, 0.07]))
    theta_min, theta_max = _edges(rng, world.reward_values, careless=careless())
    chosen = Settings(
        world=world.source or world.name,
        params=world.params,
        **_discounts(rng, careless=careless()),
        thetas=int(rng.integers(20, 161)),
        theta_spacing=str(rng.choice(["uniform", "gaussian", "asinh"], p=[0.8, 0.1, 0.1])),
        theta_min=theta_min,
        theta_max=theta_max,
        alpha=(alpha := _two_digits(_log_uniform(rng, *((1e-8, 5.0) if careless() else (1e-8, 1e-4))))),
        steps=_steps(rng, length, time_step, careless=careless()),
        time_step=time_step,
        normalise=str(rng.choice(["paper", "survival"])) if careless() else "none",
        policy="per_gamma" if careless() else "shared",
        acting_gamma=float(rng.choice([0.9, 0.95, 0.97, 0.99, 0.995])),
        softness=float(rng.choice([0.05, 0.1, 0.2, 0.5, 1.0])) if careless() else 0.0,
        noise=_two_digits(_log_uniform(rng, 1e-5, 1e-2)) if rng.random() < 0.4 else 0.0,
        noise_seed=int(rng.integers(2**31)),
        deadline="time_to_go",
    )
    if chosen.noise:  # an alpha near rounding is nobody's choice beside noise
        least = 10.0 * chosen.noise if rng.random() < 0.7 else 0.0
        chosen = replace(chosen, alpha=_two_digits(max(alpha, least * _log_uniform(rng, 1.0, 30.0))))
    resolved = resolve(chosen, world)
    return replace(resolved, slope=_two_digits(resolved.slope * _steepness(rng, careless=careless())))


def _discounts(rng: np.random.Generator, *, careless: bool) -> dict[str, Any]:
    """A grid that reaches far and is well filled, or any."""
    if careless:
        return {
            "gammas": int(rng.integers(5, 20)),
            "spacing": str(rng.choice(["inverse-log", "log", "linear", "paper"])),
            "gamma_min": float(rng.choice([0.01, 0.05, 0.1, 0.3, 0.5])),
            "gamma_max": float(rng.choice([0.9, 0.95, 0.99])),
        }
    return {
        "gammas": int(rng.integers(15, 41)),
        "spacing": str(rng.choice(["inverse-log", "log", "linear", "paper"], p=[0.35, 0.45, 0.1, 0.1])),
        "gamma_min": float(rng.choice([0.01, 0.05, 0.1, 0.3])),
        "gamma_max": float(rng.choice([0.99, 0.99, 0.995])),
    }


def _edges(rng: np.random.Generator, rewards: np.ndarray, *, careless: bool) -> tuple[float, float]:
    """Ends of the sensitivities: beyond every reward, or far beyond; careless: one on a reward or short of it."""
    low, high = float(rewards[0]), float(rewards[-1])
    width = (high - low) or max(1.0, abs(low))
    over = width * (0.2 if rng.random() < 0.8 else float(rng.uniform(0.5, 2.0)))
    ends = [low - over, high + over]
    if careless:
        side, short = int(rng.integers(2)), width * float(rng.choice([0.0, 0.0, 0.1]))
        ends[side] = (low + short, high - short)[side]
    return float(f"{ends[0]:.6g}"), float(f"{ends[1]:.6g}")


def _steps(rng: np.random.Generator, length: int, time_step: float, *, careless: bool) -> int:
    """Rows of the world's length or more; careless: of a part of it, or hardly any."""
    if not careless:
        steps = length + float(rng.integers(0, 3)) if rng.random() < 0.5 else length * float(rng.uniform(1.0, 3.0))
    else:
        steps = length * float(rng.uniform(0.2, 1.0)) if rng.random() < 0.7 else float(rng.integers(1, 4))
    return int(np.clip(round(steps / time_step), 1, MOST_ROWS))


def _steepness(rng: np.random.Generator, *, careless: bool) -> float:
    """Slope in units of the one that suits the spacing."""
    if not careless:
        return 1.0
    return _log_uniform(rng, 0.03, 0.5) if rng.random() < 0.5 else _log_uniform(rng, 1.5, 30.0)


def _log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def _two_digits(x: float) -> float:
    return float(f"{x:.2g}")


def _switched(rng: np.random.Generator, settings: ResolvedForWorld, row: int) -> ResolvedForWorld:
    """The same settings, a quarter of them with one to three of the lens's switches thrown.

    Drawn after all else, so that the other views of a seed are what they were before there were switches.
    """
    if rng.random() >= SWITCHED:
        return settings
    horizon = float(row_horizons(settings.steps, settings.time_step)[row])
    switches: tuple[dict[str, Any], ...] = (
        {"used": _used(rng, horizon)},
        {"value_gamma": float(rng.choice([gamma for gamma in VALUE_GAMMAS if gamma != settings.acting_gamma]))},
        {"fold": True},
        {"shift": True},
        {"clip": True},
        {"paper_grid": True},
        {"horizon": horizon},
    )
    chosen = rng.choice(len(switches), int(rng.integers(1, 4)), replace=False)
    changes = {name: value for i in sorted(chosen) for name, value in switches[i].items()}
    return replace(settings, **changes)


def _used(rng: np.random.Generator, horizon: float) -> float:
    """Steps of the episode that are over: whole ones, or a part of the horizon; some are left."""
    whole = math.ceil(horizon) - 1
    if whole >= 1 and rng.random() < 0.8:
        return float(rng.integers(1, whole + 1))
    return _two_digits(horizon * float(rng.uniform(0.1, 0.9)))


# --- worlds: each comes with a length, about how many steps matter in it ---


def _preset(rng: np.random.Generator) -> tuple[World, int]:
    name = str(rng.choice(list(PRESETS)))
    # The largest preset costs as much time as ten others, so that it is drawn rarely.
    while name == "discounting_chain" and rng.random() < 0.7:
        name = str(rng.choice(list(PRESETS)))
    params = {parameter.name: _value(rng, name, parameter) for parameter in PRESETS[name].parameters}
    world = load_world(name, params)
    length: dict[str, Callable[[], Any]] = {
        "fig6_chain": lambda: 4,
        "double_chain": lambda: max(params["early"], params["late"]) + 1,
        "discounting_chain": lambda: int(rng.choice([12, 35, 105])),
        "cliff_grid": lambda: 2 * (params["width"] + params["height"]),
    }
    return world, int(length.get(name, lambda: params["length"] + 1)())


def _value(rng: np.random.Generator, preset: str, parameter: Parameter) -> Any:
    """A parameter of a preset: its default, or a random value of a size that keeps the world small."""
    usual: Any = parameter.default
    if parameter.type is bool:
        return bool(rng.random() < 0.25)
    if parameter.name in ("slip", "p_early"):
        return float(rng.choice([usual, 0.1, 0.3]))
    if parameter.name == "bonus_chain":
        return int(rng.integers(5))
    if parameter.type is int:
        most = {"length": 12, "width": 4, "height": 3, "early": 5, "late": 9}[parameter.name]
        if preset == "rise_and_fade":
            most = 20
        return int(rng.integers(max(1, int(parameter.bounds[0])), most + 1))
    if rng.random() < 0.5 or not usual:
        return float(usual)
    return float(round(usual * rng.uniform(0.4, 1.6), 2))


def _rewards(rng: np.random.Generator, most: int = 5) -> np.ndarray:
    """Two to ``most`` distinct rewards, zero among them: halves from -3 to 6, or the same in another unit."""
    unit = float(rng.choice([1.0, 1.0, 1.0, 0.1, 20.0]))
    others = np.setdiff1d(np.arange(-6, 13), [0]) / 2.0
    return unit * np.append(0.0, rng.choice(others, int(rng.integers(1, most)), replace=False))


def _split(rng: np.random.Generator, parts: int) -> np.ndarray:
    weights = rng.integers(1, 6, parts)
    return weights / weights.sum()


def _random_names(count: int, actions: int) -> tuple[list[str], list[str]]:
    return [f"s{i}" for i in range(count)], [f"a{i}" for i in range(actions)]


def _layers(rng: np.random.Generator) -> tuple[World, int]:
    """Every step leads to the next layer or to the end, by chance, with chance rewards."""
    widths = [1, *rng.integers(1, 4, int(rng.integers(2, 6)))]
    first = np.concatenate([[0], np.cumsum(widths)])
    rewards, actions, rows = _rewards(rng), int(rng.integers(1, 5)), []
    for layer, width in enumerate(widths):
        for state in range(first[layer], first[layer] + width):
            for action in range(actions):
                for p in _split(rng, int(rng.integers(1, 4))):
                    ends = layer + 1 == len(widths) or rng.random() < 0.2
                    goal = END if ends else int(rng.integers(first[layer + 1], first[layer + 2]))
                    paid = 0.0 if rng.random() < 0.3 else rng.choice(rewards)
                    rows.append(Outcome(state, action, float(p), goal, float(paid)))
    return World.from_outcomes("layers", *_random_names(first[-1], actions), rows), len(widths)


def _tree(rng: np.random.Generator) -> tuple[World, int]:
    """Each action leads to its own subtree, which may end early; leaves pay."""
    depth, rewards, rows, count = int(rng.integers(2, 5)), _rewards(rng), [], 1
    actions = int(rng.integers(2, 4 if depth < 4 else 3))
    frontier = [(0, 0)]
    while frontier:
        state, level = frontier.pop()
        for action in range(actions):
            if level + 1 >= depth or count >= 12 or rng.random() < 0.25:
                rows.append(Outcome(state, action, 1.0, END, float(rng.choice(rewards))))
                continue
            frontier.append((count, level + 1))
            paid = 0.0 if rng.random() < 0.6 else float(rng.choice(rewards))
            rows.append(Outcome(state, action, 1.0, count, paid))
            count += 1
    return World.from_outcomes("tree", *_random_names(count, actions), rows), depth


def _cycles(rng: np.random.Generator) -> tuple[World, int]:
    """Any state may follow any, itself too; each step ends the episode with some chance."""
    count, actions, rewards = int(rng.integers(2, 8)), int(rng.integers(1, 5)), _rewards(rng)
    ending, rows = float(rng.choice([0.02, 0.1, 0.3])), []
    for state in range(count):
        for action in range(actions):
            parts = _split(rng, int(rng.integers(1, 4))) * (1.0 - ending)
            for p in parts:
                goal = state if rng.random() < 0.3 else int(rng.integers(count))
                rows.append(Outcome(state, action, float(p), goal, float(rng.choice(rewards))))
            rows.append(Outcome(state, action, ending, END, float(rng.choice(rewards))))
    length = min(60, int(np.ceil(2.0 / ending)))
    return World.from_outcomes("cycles", *_random_names(count, actions), rows), length


def _continuing(rng: np.random.Generator) -> tuple[World, int]:
    """No episode of it ever ends, and every state pays now and then."""
    count, actions, rewards, rows = int(rng.integers(1, 7)), int(rng.integers(1, 5)), _rewards(rng), []
    for state in range(count):
        for action in range(actions):
            for p in _split(rng, int(rng.integers(1, 4))):
                rows.append(Outcome(state, action, float(p), int(rng.integers(count)), float(rng.choice(rewards))))
    if not any(row.reward for row in rows):
        rows = [row._replace(reward=1.0) if row.state == 0 else row for row in rows]
    length = int(rng.choice([5, 15, 40]))
    return World.from_outcomes("continuing", *_random_names(count, actions), rows), length


def _chain(rng: np.random.Generator) -> tuple[World, int]:
    """A long way with a decision at its head: leave for little, or go on to a reward at the end of up to 200 steps."""
    length = int(np.exp(rng.uniform(np.log(8), np.log(200))))
    little, much = np.sort(rng.choice(np.arange(1, 21), 2, replace=False)) / 2.0
    leave, heads = int(rng.integers(2)), int(rng.integers(1, 4))
    toll = float(rng.choice([0.0, 0.0, -0.1, 0.05]))
    rows = []
    for state in range(length):
        onwards = state + 1 if state + 1 < length else END
        paid = float(much) if onwards == END else toll
        for action in range(2):
            if state < heads and action == leave:
                rows.append(Outcome(state, action, 1.0, END, float(little)))
            else:
                rows.append(Outcome(state, action, 1.0, onwards, paid))
    return World.from_outcomes("long way", *_random_names(length, 2), rows), length


def _decisions(rng: np.random.Generator) -> tuple[World, int]:
    """Leave early for a little, or a step later for more, or late for most; waiting pays nothing, hands may slip."""
    first, length = int(rng.integers(2)), int(rng.integers(4, 9))
    last = first + int(rng.integers(1, 3))
    r0, r1, r2 = np.sort(rng.choice(np.arange(1, 17), 3, replace=False)) / 2.0
    leave, slip, rows = int(rng.integers(2)), float(rng.choice([0.0, 0.0, 0.1, 0.3])), []
    for state in range(length):
        onwards = state + 1 if state + 1 < length else END
        paid = float(r2) if onwards == END else 0.0
        for action in range(2):
            goal, other = (END, float(r0 if state < last else r1)), (onwards, paid)
            decides = first <= state <= last
            if not (action == leave and decides):
                goal, other = other, goal
            rows.append(Outcome(state, action, 1.0 - slip if decides else 1.0, *goal))
            if slip and decides:
                rows.append(Outcome(state, action, slip, *other))
    return World.from_outcomes("decisions", *_random_names(length, 2), rows), length


def _idle(rng: np.random.Generator) -> tuple[World, int]:
    """Two branches that pay and then idle without pay: for ever in one state or a ring, or until one leaves."""
    length, ring = int(rng.integers(2, 7)), int(rng.integers(1, 4))
    soon, late = float(rng.integers(1, 11)) / 2.0, float(rng.integers(2, 21)) / 2.0
    idle = [length + i for i in range(ring)]
    leaving = rng.random() < 0.4
    rows = [Outcome(0, 0, 1.0, idle[0], soon), Outcome(0, 1, 1.0, 1, 0.0)]
    for state in range(1, length):
        onwards, paid = (state + 1, 0.0) if state + 1 < length else (idle[0], late)
        rows += [Outcome(state, action, 1.0, onwards, paid) for action in range(2)]
    for i, state in enumerate(idle):
        around = idle[(i + 1) % ring]
        rows.append(Outcome(state, 0, 1.0, around, 0.0))
        rows.append(Outcome(state, 1, 1.0, END if leaving else around, 0.0))
    return World.from_outcomes("idle", *_random_names(length + ring, 2), rows), length + 2


_WORLDS: tuple[Callable[[np.random.Generator], tuple[World, int]], ...] = (
    _preset, _layers, _tree, _cycles, _continuing, _chain, _decisions, _idle,
)  # fmt: skip
_SHARES = (0.22, 0.13, 0.08, 0.1, 0.06, 0.12, 0.22, 0.07)
