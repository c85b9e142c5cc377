"""Random worlds: some end within nine steps, others last for hundreds, or for ever, or pay dozens of rewards.

A world of the later kinds comes with a length: how many steps an episode is looked at for. The test of the detector and
the study of the inverse draw from them.
"""

from __future__ import annotations

import numpy as np

from laplace_core.worlds import END, Outcome, World

MOST_STEPS = 200


def short_world(rng: np.random.Generator) -> World:
    """A world without a way back, over within nine steps."""
    return (_two_decisions, _layers, _chain, _tree)[rng.choice(4, p=[0.35, 0.35, 0.15, 0.15])](rng)


def lasting_world(rng: np.random.Generator) -> tuple[World, int]:
    """A world with cycles, with hundreds of steps or without an end, and a length that suits it."""
    return (_cycles, _long_chain, _grid, _continuing, _idling)[rng.choice(5, p=[0.25, 0.2, 0.15, 0.2, 0.2])](rng)


def rich_world(rng: np.random.Generator) -> tuple[World, int]:
    """A world with cycles that pays some twenty to fifty distinct rewards, and a length that suits it."""
    rewards = np.round(rng.uniform(-10.0, 10.0, int(rng.integers(20, 51))), 1)
    ending = float(rng.choice([0.0, 0.01, 0.05, 0.2]))
    return _wandering(rng, "rich", ending, states=int(rng.integers(8, 25)), rewards=np.unique(np.append(0.0, rewards)))


# --- within nine steps ---


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
    """Two actions in each state, each to its own subtree, which may end early; leaves pay."""
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


# --- with cycles, long or without an end ---


def _cycles(rng: np.random.Generator) -> tuple[World, int]:
    """A random MDP in which a step may stay, lead anywhere, or end, with some chance of each."""
    ending = float(rng.choice([0.02, 0.05, 0.1, 0.2, 0.4]))
    return _wandering(rng, "cycles", ending, states=int(rng.integers(2, 9)))


def _continuing(rng: np.random.Generator) -> tuple[World, int]:
    """The same without an end."""
    return _wandering(rng, "continuing", 0.0, states=int(rng.integers(2, 9)))


def _wandering(
    rng: np.random.Generator, name: str, ending: float, *, states: int, rewards: np.ndarray | None = None
) -> tuple[World, int]:
    actions = int(rng.integers(2, 4))
    rewards = _rewards(rng) if rewards is None else rewards
    rows: list[Outcome] = []
    for state in range(states):
        first = len(rows)
        for action in range(actions):
            for p in _split(rng, int(rng.integers(1, 4))):
                goal = state if rng.random() < 0.2 else int(rng.integers(states))
                if action == 0 and len(rows) == first:  # every state can be left
                    goal = (state + 1) % states
                paid = 0.0 if rng.random() < 0.4 else float(rng.choice(rewards))
                rows.append(Outcome(state, action, float(p) * (1.0 - ending), goal, paid))
            if ending:
                rows.append(Outcome(state, action, ending, END, float(rng.choice(rewards))))
    world = World.from_outcomes(name, [f"s{i}" for i in range(states)], [f"a{i}" for i in range(actions)], rows)
    # A thousandth of the episodes is left after that.
    length = np.log(1e-3) / np.log1p(-ending) if ending else np.exp(rng.uniform(np.log(3), np.log(MOST_STEPS)))
    return world, int(np.clip(length, 3, MOST_STEPS))


def _long_chain(rng: np.random.Generator) -> tuple[World, int]:
    """Up to 200 states in a line, few of which pay; an action may leave early, and a step may slip back or end."""
    actions = int(rng.integers(1, 3))
    rewards, rows = _rewards(rng), []
    slip, ending = float(rng.choice([0.0, 0.0, 0.1])), float(rng.choice([0.0, 0.0, 0.01, 0.05]))
    # The labels copy a world for every step, as many states as may be reached by then.
    most = 50 if actions == 2 else 70 if slip else MOST_STEPS
    length = int(np.exp(rng.uniform(np.log(15), np.log(most))))
    pays, leaves = rng.choice([0.02, 0.1, 1.0]), float(rng.choice(rewards))
    for state in range(length):
        last = state + 1 == length
        paid = float(rng.choice(rewards)) if last or rng.random() < pays else 0.0
        chances = {END if last else state + 1: (1.0 - slip) * (1.0 - ending)}
        for goal, p in ((max(0, state - 1), slip * (1.0 - ending)), (END, ending)):
            chances[goal] = chances.get(goal, 0.0) + p
        rows += [Outcome(state, 0, p, goal, paid) for goal, p in chances.items() if p]
        if actions == 2:
            rows.append(Outcome(state, 1, 1.0, END, leaves))
    names = [f"s{i}" for i in range(length)]
    return World.from_outcomes("long chain", names, ["go", "leave"][:actions], rows), length


def _grid(rng: np.random.Generator) -> tuple[World, int]:
    """Four directions that slip, a price a step or none, a goal that pays and ends, and a trap that costs."""
    width, height = (int(n) for n in rng.integers(2, 7, 2))
    slip, price = float(rng.choice([0.0, 0.1, 0.3])), float(rng.choice([0.0, -0.5]))
    goal, trap = width * height - 1, int(rng.integers(1, width * height))
    pays, costs = float(rng.choice([2.0, 4.0, 6.0])), float(rng.choice([-3.0, -1.0]))
    rows = []
    for state in range(width * height):
        x, y = state % width, state // width
        near = [(x, y - 1), (x + 1, y), (x, y + 1), (x - 1, y)]
        at = [i + width * j if 0 <= i < width and 0 <= j < height else state for i, j in near]
        for action in range(4):
            chances: dict[int, float] = {}
            for turn, p in ((0, 1.0 - slip), (1, slip / 2.0), (3, slip / 2.0)):
                to = at[(action + turn) % 4]
                chances[to] = chances.get(to, 0.0) + p
            for to, p in chances.items():
                paid = pays if to == goal else costs if to == trap else price
                rows += [Outcome(state, action, p, END if to == goal else to, paid)] if p else []
    names = [f"{i % width},{i // width}" for i in range(width * height)]
    world = World.from_outcomes("grid", names, ["up", "right", "down", "left"], rows)
    return world, int(rng.integers(width + height, 4 * (width + height)))


def _idling(rng: np.random.Generator) -> tuple[World, int]:
    """A short branch and a long one, after which the best is to idle for ever, though going on would be possible."""
    r1, r2 = (float(r) for r in np.sort(rng.choice(np.arange(1, 13), 2, replace=False)) / 2.0)
    wait, costs = int(rng.integers(2, 8)), float(rng.choice([-3.0, -1.5, -1.0]))
    here, there = wait, wait + 1  # the states before lead to them
    rows = [Outcome(0, 0, 1.0, here, r1), Outcome(0, 1, 1.0, 1, 0.0)]
    for state in range(1, wait):
        goal, paid = (state + 1, 0.0) if state + 1 < wait else (here, r2)
        rows += [Outcome(state, action, 1.0, goal, paid) for action in range(2)]
    idle = int(rng.integers(2))
    if rng.random() < 0.5:  # to and fro
        rows += [Outcome(here, idle, 1.0, there, 0.0), Outcome(there, idle, 1.0, here, 0.0)]
    else:
        rows += [Outcome(here, idle, 1.0, here, 0.0), Outcome(there, idle, 1.0, there, 0.0)]
    rows += [Outcome(here, 1 - idle, 1.0, there, costs), Outcome(there, 1 - idle, 1.0, END, costs)]
    names = [f"s{i}" for i in range(wait + 2)]
    length = int(np.exp(rng.uniform(np.log(4), np.log(60))))
    return World.from_outcomes("idling", names, ["a", "b"], rows), length
