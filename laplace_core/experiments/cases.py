"""Random worlds and settings in which each artefact is switched on or not, for the test of the detector.

Of a ``short`` case the base configuration has none: a world that ends within nine steps, more rows than steps, an alpha
near rounding, sensitivities that overhang every reward, slope * spacing of 2.35, one policy, a hard deadline, time to
go, no noise. A ``lasting`` world has cycles, hundreds of steps or no end, and its rows may be fewer than its steps and
closer than they are: what is folded then, and what rings, is there in the base already. Switches are thrown
independently, each with a random strength; the two directions of the slope exclude each other, and so do an alpha that
smears and one that rings, and the two ways to rescale.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from laplace_core.experiments.case_worlds import lasting_world, short_world
from laplace_core.inverse import decode_matrix
from laplace_core.study.pipeline import grids
from laplace_core.study.settings import SLOPE_TIMES_SPACING, ResolvedForWorld, Settings, resolve
from laplace_core.worlds import END, World

KINDS = ("short", "lasting")
BASE_ALPHA = {"short": 1e-11, "lasting": 1e-9}
"""Near rounding; the longer the timeline, the sooner that is reached."""
MOST_ROWS = 400
CHANCE = 0.3
"""Of a switch to be thrown, but for those of :data:`CHANCES`."""
CHANCES = {
    "short": {"per gamma": 0.5, "constant": 0.6},
    "lasting": {"per gamma": 0.5, "constant": 0.4},
}
"""Of two switches that change nothing in many worlds."""
EXCLUSIVE = (("blur", "quantisation"), ("smearing", "ringing"), ("rescaling", "conditional"))

Switch = Callable[[np.random.Generator, World, ResolvedForWorld], dict[str, Any]]
"""Draws its strength and returns the settings that it changes."""


@dataclass(frozen=True, eq=False)
class Case:
    """One world, one state-action pair and the settings of its study.

    Attributes:
        base: the settings without any switch, resolved.
        settings: the same with what was ``switched``: the names of the switches thrown.
    """

    world: World
    action: int
    base: ResolvedForWorld
    settings: ResolvedForWorld
    switched: tuple[str, ...]


def draw_case(
    rng: np.random.Generator,
    chances: Mapping[str, float] | None = None,
    kind: str = "short",
    more: Mapping[str, Switch] | None = None,
) -> Case:
    """A random case of one of :data:`KINDS`.

    Args:
        chances: of a switch to be thrown, by its name, in place of :data:`CHANCES`.
        more: switches beside :data:`SWITCHES`. They are drawn last, so that all else of a case stays as it is without
            them.
    """
    if kind == "short":
        world = short_world(rng)
        base = _base(rng, world, _longest(world) + int(rng.integers(1, 3)), kind)
    else:
        world, length = lasting_world(rng)
        dt = float(rng.choice([1.0, 0.5, 0.25], p=[0.6, 0.2, 0.2]))
        steps = max(2, round(length * rng.choice([0.5, 1.0, 1.0, 1.3]) / dt))
        base = _base(rng, world, min(steps, MOST_ROWS, round(200 / dt)), kind, time_step=dt)
    more = more or {}
    chances = dict.fromkeys((*SWITCHES, *more), CHANCE) | CHANCES[kind] | dict(chances or {})
    switched = tuple(name for name in SWITCHES if rng.random() < chances[name])
    for pair in EXCLUSIVE:
        if set(pair) <= set(switched):
            dropped = pair[rng.integers(2)]
            switched = tuple(name for name in switched if name != dropped)
    settings = base
    for name in switched:
        settings = replace(settings, **SWITCHES[name](rng, world, settings))
    action = int(rng.integers(world.n_actions))
    for name, throw in more.items():
        if rng.random() < chances[name]:
            settings, switched = replace(settings, **throw(rng, world, settings)), (*switched, name)
    return Case(world, action, base, settings, switched)


def _base(rng: np.random.Generator, world: World, steps: int, kind: str, *, time_step: float = 1.0) -> ResolvedForWorld:
    rewards = world.reward_values
    spacing = float(np.diff(rewards).min(initial=2.0)) / rng.uniform(7.0, 10.0)
    slope = SLOPE_TIMES_SPACING / spacing
    over = max(0.2 * (rewards[-1] - rewards[0]), 10.0 / slope)
    low, high = float(rewards[0] - over), float(rewards[-1] + over)
    settings = Settings(
        world=world.name,
        gammas=int(rng.integers(20, 41)),
        spacing=str(rng.choice(["inverse-log", "log"])),
        gamma_min=0.05,
        thetas=int(np.ceil((high - low) / spacing)) + 1,
        theta_min=low,
        theta_max=high,
        alpha=BASE_ALPHA[kind],
        steps=steps,
        time_step=time_step,
        acting_gamma=float(rng.choice([0.9, 0.95, 0.99])),
    )
    settings = resolve(settings, world)
    return replace(settings, slope=SLOPE_TIMES_SPACING / spacing_of(settings))


def spacing_of(settings: ResolvedForWorld) -> float:
    return (settings.theta_max - settings.theta_min) / (settings.thetas - 1)


def _longest(world: World) -> int:
    """Steps of the longest episode; the worlds here have no way back."""
    steps, states = 0, np.flatnonzero(world.start)
    while states.size:
        steps += 1
        after = world.next_state[np.isin(world.state, states) & (world.probability > 0)]
        states = np.unique(after[after != END])
    return steps


# --- switches: each draws its strength and returns the settings that it changes ---


def _few_rows(rng: np.random.Generator, world: World, s: ResolvedForWorld) -> dict[str, Any]:
    return {"steps": int(rng.integers(1, max(2, s.steps - 1)))}


def _narrow_edges(rng: np.random.Generator, world: World, s: ResolvedForWorld) -> dict[str, Any]:
    """One end of the range on a reward, or past it; the spacing stays."""
    rewards, spacing = world.reward_values, spacing_of(s)
    past = float(rng.choice([0.0, 0.5, 3.0, 6.0])) * spacing
    if rng.random() < 0.5 and s.theta_max - rewards[0] - past > 3.0 * spacing:
        low, high = float(rewards[0] + past), s.theta_max
    else:
        low, high = s.theta_min, max(float(rewards[-1] - past), s.theta_min + 3.0 * spacing)
    thetas = max(3, round((high - low) / spacing) + 1)
    return {"theta_min": low, "theta_max": low + (thetas - 1) * spacing, "thetas": thetas}


def _gentle(rng: np.random.Generator, world: World, s: ResolvedForWorld) -> dict[str, Any]:
    return {"slope": float(np.exp(rng.uniform(np.log(0.5), np.log(4.0)))) / _gap(world)}


def _gap(world: World) -> float:
    return float(np.diff(world.reward_values).min(initial=2.0))


def _steep(rng: np.random.Generator, world: World, s: ResolvedForWorld) -> dict[str, Any]:
    """Steep and coarse: a spacing that shares no fraction with the rewards' halves."""
    thetas = max(4, int(s.thetas / rng.uniform(1.0, 3.0)))
    spacing = (s.theta_max - s.theta_min) / (thetas - 1)
    return {"thetas": thetas, "slope": float(np.exp(rng.uniform(np.log(8.0), np.log(100.0)))) / spacing}


def _smearing(rng: np.random.Generator, world: World, s: ResolvedForWorld) -> dict[str, Any]:
    return {"alpha": float(np.exp(rng.uniform(np.log(0.3), np.log(5.0))))}


def _ringing(rng: np.random.Generator, world: World, s: ResolvedForWorld) -> dict[str, Any]:
    return {"alpha": float(np.exp(rng.uniform(np.log(1e-5), np.log(0.1))))}


def _noisy(rng: np.random.Generator, world: World, s: ResolvedForWorld) -> dict[str, Any]:
    """Of such a size that it moves about .1 to 3 of a row's probability, whatever the inverse makes of it."""
    gammas = grids(s)[0]
    matrix = decode_matrix(gammas, s.steps, s.alpha, s.time_step) / s.time_step
    gain = np.sqrt((matrix / (1.0 - gammas)) ** 2 @ np.ones(gammas.size))
    one = 0.5 * np.sqrt(2.0 / np.pi) * world.reward_values.size * np.sqrt(2.0) * gain.max()
    moved = np.exp(rng.uniform(np.log(0.1), np.log(3.0)))
    return {"noise": float(min(1.0, moved / one)), "noise_seed": int(rng.integers(2**31))}


SWITCHES: dict[str, Switch] = {
    "rescaling": lambda rng, world, s: {"normalise": "paper"},
    "per gamma": lambda rng, world, s: {"policy": "per_gamma"},
    "few rows": _few_rows,
    "narrow edges": _narrow_edges,
    "blur": _gentle,
    "quantisation": _steep,
    "smearing": _smearing,
    "ringing": _ringing,
    "softness": lambda rng, world, s: {"softness": float(np.exp(rng.uniform(np.log(0.1), np.log(2.0))))},
    "constant": lambda rng, world, s: {"deadline": "constant"},
    "noise": _noisy,
    "conditional": lambda rng, world, s: {"normalise": "survival"},
}
"""In the order in which they are applied: the noise is sized for the inverse that it meets."""
