"""Random worlds and settings in which each artefact is switched on or not, for the test of the detector.

The base configuration has none: a world that ends within nine steps, more rows than steps, an alpha near rounding,
sensitivities that overhang every reward, slope * spacing of 2.35, one policy, a hard deadline, time to go, no noise.
Switches are thrown independently, each with a random strength; the two directions of the slope exclude each other,
and so do an alpha that smears and one that rings.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from laplace_core.inverse import decode_matrix
from laplace_core.pipeline import grids
from laplace_core.settings import SLOPE_TIMES_SPACING, Settings, resolve
from laplace_core.worlds import END, Outcome, World

BASE_ALPHA = 1e-11
CHANCES = {"per gamma": 0.5, "constant": 0.6}
"""Of a switch to be thrown: .3, but for two that change nothing in many worlds."""
EXCLUSIVE = (("blur", "quantisation"), ("smearing", "ringing"))


@dataclass(frozen=True, eq=False)
class Case:
    """One world, one state-action pair and the settings it is looked at with.

    Attributes:
        base: the settings without any switch, resolved.
        settings: the same with what was ``switched``: the names of the switches thrown.
    """

    world: World
    action: int
    base: Settings
    settings: Settings
    switched: tuple[str, ...]


def draw_case(rng: np.random.Generator, chances: Mapping[str, float] | None = None) -> Case:
    """A random case; ``chances`` overrides :data:`CHANCES` by the name of a switch."""
    world = (_two_decisions, _layers, _chain, _tree)[rng.choice(4, p=[0.35, 0.35, 0.15, 0.15])](rng)
    base = _base(rng, world)
    chances = dict.fromkeys(SWITCHES, 0.3) | CHANCES | dict(chances or {})
    switched = tuple(name for name in SWITCHES if rng.random() < chances[name])
    for pair in EXCLUSIVE:
        if set(pair) <= set(switched):
            dropped = pair[rng.integers(2)]
            switched = tuple(name for name in switched if name != dropped)
    settings = base
    for name in switched:
        settings = replace(settings, **SWITCHES[name](rng, world, settings))
    return Case(world, int(rng.integers(world.n_actions)), base, settings, switched)


def _base(rng: np.random.Generator, world: World) -> Settings:
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
        alpha=BASE_ALPHA,
        steps=_longest(world) + int(rng.integers(1, 3)),
        acting_gamma=float(rng.choice([0.9, 0.95, 0.99])),
    )
    settings = resolve(settings, world)
    return replace(settings, slope=SLOPE_TIMES_SPACING / spacing_of(settings))


def spacing_of(settings: Settings) -> float:
    return (settings.theta_max - settings.theta_min) / (settings.thetas - 1)


def _longest(world: World) -> int:
    """Steps of the longest episode; the worlds here have no way back."""
    steps, states = 0, np.flatnonzero(world.start)
    while states.size:
        steps += 1
        after = world.next_state[np.isin(world.state, states) & (world.probability > 0)]
        states = np.unique(after[after != END])
    return steps


# --- worlds ---


def _rewards(rng: np.random.Generator, most: int = 4) -> np.ndarray:
    """Two to ``most`` distinct rewards, halves from -3 to 6; zero is among them."""
    others = np.setdiff1d(np.arange(-6, 13), [0]) / 2.0
    return np.append(0.0, rng.choice(others, int(rng.integers(1, most)), replace=False))


def _split(rng: np.random.Generator, parts: int) -> np.ndarray:
    weights = rng.integers(1, 5, parts)
    return weights / weights.sum()


def _two_decisions(rng: np.random.Generator) -> World:
    """Leave early for a little, or a step later for more, or late for most; waiting pays nothing."""
    first, length = int(rng.integers(2)), int(rng.integers(4, 8))
    last = first + int(rng.integers(1, 3))
    r0, r1, r2 = np.sort(rng.choice(np.arange(1, 17), 3, replace=False)) / 2.0
    leave = rng.integers(2)
    slip = float(rng.choice([0.0, 0.0, 0.1, 0.3]))
    rows = []
    for state in range(length):
        onwards = state + 1 if state + 1 < length else END
        paid = r2 if onwards == END else 0.0
        for action in range(2):
            quits = action == leave and first <= state <= last
            goal, other = (END, r0 if state < last else r1), (onwards, paid)
            if not quits:
                goal, other = other, goal
            p_slip = slip if first <= state <= last else 0.0
            rows.append(Outcome(state, action, 1.0 - p_slip, *goal))
            if p_slip:
                rows.append(Outcome(state, action, p_slip, *other))
    return World.from_outcomes("two decisions", [f"s{i}" for i in range(length)], ["a", "b"], rows)


def _layers(rng: np.random.Generator) -> World:
    """A random MDP whose states lie in layers; every step leads to the next layer or to the end."""
    widths = [1, *rng.integers(1, 4, int(rng.integers(2, 7)))]
    first = np.concatenate([[0], np.cumsum(widths)])
    rewards, actions, rows = _rewards(rng), int(rng.integers(2, 4)), []
    for layer, width in enumerate(widths):
        for state in range(first[layer], first[layer] + width):
            for action in range(actions):
                for p in _split(rng, int(rng.integers(1, 3))):
                    ends = layer + 1 == len(widths) or rng.random() < 0.2
                    goal = END if ends else int(rng.integers(first[layer + 1], first[layer + 2]))
                    paid = 0.0 if rng.random() < 0.4 else rng.choice(rewards)
                    rows.append(Outcome(state, action, float(p), goal, float(paid)))
    names = [f"s{i}" for i in range(first[-1])]
    return World.from_outcomes("layers", names, [f"a{i}" for i in range(actions)], rows)


def _chain(rng: np.random.Generator) -> World:
    """One way onwards, a random reward at each step, and a chance of the end."""
    length, rewards = int(rng.integers(2, 9)), _rewards(rng)
    ending = float(rng.choice([0.0, 0.1, 0.3]))
    rows = []
    for state in range(length):
        onwards = state + 1 if state + 1 < length else END
        for p in _split(rng, int(rng.integers(1, 3))):
            paid = float(rng.choice(rewards))
            rows.append(Outcome(state, 0, float(p) * (1.0 - ending), onwards, paid))
            rows.append(Outcome(state, 0, float(p) * ending, END, paid))
    return World.from_outcomes("chain", [f"s{i}" for i in range(length)], ["go"], [r for r in rows if r.probability])


def _tree(rng: np.random.Generator) -> World:
    """Two actions a state, each to a subtree of its own, which may end early; leaves pay."""
    depth, rewards, rows, names = int(rng.integers(2, 5)), _rewards(rng), [], ["s0"]
    frontier = [(0, 0)]
    while frontier:
        state, level = frontier.pop()
        for action in range(2):
            if level + 1 >= depth or rng.random() < 0.2:
                rows.append(Outcome(state, action, 1.0, END, float(rng.choice(rewards))))
                continue
            names.append(f"s{len(names)}")
            frontier.append((len(names) - 1, level + 1))
            paid = 0.0 if rng.random() < 0.6 else float(rng.choice(rewards))
            rows.append(Outcome(state, action, 1.0, len(names) - 1, paid))
    return World.from_outcomes("tree", names, ["left", "right"], rows)


# --- switches: each draws its strength and returns the settings that it changes ---


def _few_rows(rng: np.random.Generator, world: World, s: Settings) -> dict[str, object]:
    return {"steps": int(rng.integers(1, max(2, _longest(world))))}


def _narrow_edges(rng: np.random.Generator, world: World, s: Settings) -> dict[str, object]:
    """One end of the range on a reward, or past it; the spacing stays."""
    rewards, spacing = world.reward_values, spacing_of(s)
    past = float(rng.choice([0.0, 0.5, 3.0, 6.0])) * spacing
    if rng.random() < 0.5 and s.theta_max - rewards[0] - past > 3.0 * spacing:
        low, high = float(rewards[0] + past), s.theta_max
    else:
        low, high = s.theta_min, max(float(rewards[-1] - past), s.theta_min + 3.0 * spacing)
    thetas = max(3, round((high - low) / spacing) + 1)
    return {"theta_min": low, "theta_max": low + (thetas - 1) * spacing, "thetas": thetas}


def _gentle(rng: np.random.Generator, world: World, s: Settings) -> dict[str, object]:
    return {"slope": float(np.exp(rng.uniform(np.log(0.5), np.log(4.0)))) / _gap(world)}


def _gap(world: World) -> float:
    return float(np.diff(world.reward_values).min(initial=2.0))


def _steep(rng: np.random.Generator, world: World, s: Settings) -> dict[str, object]:
    """Steep and coarse: a spacing that shares no fraction with the rewards' halves."""
    thetas = max(4, int(s.thetas / rng.uniform(1.0, 3.0)))
    spacing = (s.theta_max - s.theta_min) / (thetas - 1)
    return {"thetas": thetas, "slope": float(np.exp(rng.uniform(np.log(8.0), np.log(100.0)))) / spacing}


def _smearing(rng: np.random.Generator, world: World, s: Settings) -> dict[str, object]:
    return {"alpha": float(np.exp(rng.uniform(np.log(0.3), np.log(5.0))))}


def _ringing(rng: np.random.Generator, world: World, s: Settings) -> dict[str, object]:
    return {"alpha": float(np.exp(rng.uniform(np.log(1e-5), np.log(0.1))))}


def _noisy(rng: np.random.Generator, world: World, s: Settings) -> dict[str, object]:
    """Of such a size that it moves about .1 to 3 of a row's probability, whatever the inverse makes of it."""
    gammas = grids(s)[0]
    gain = np.sqrt((decode_matrix(gammas, s.steps, s.alpha) / (1.0 - gammas)) ** 2 @ np.ones(gammas.size))
    one = 0.5 * np.sqrt(2.0 / np.pi) * world.reward_values.size * np.sqrt(2.0) * gain.max()
    moved = np.exp(rng.uniform(np.log(0.1), np.log(3.0)))
    return {"noise": float(min(1.0, moved / one)), "noise_seed": int(rng.integers(2**31))}


SWITCHES = {
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
}
"""In the order in which they are applied: the noise is sized for the inverse that it meets."""
