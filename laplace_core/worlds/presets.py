"""The worlds that ship, each a function of a few named parameters.

Every world says what it diagnoses. A reward "at step n" is the n-th reward after the start, counted from 0.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.parameters import Parameter, parse_named
from laplace_core.worlds.model import END, MAX_STATES, Outcome, World


@dataclass(frozen=True)
class Preset:
    """A named world: its summary, its parameters, and how to build it."""

    name: str
    title: str
    summary: str
    parameters: tuple[Parameter, ...]
    build: Callable[..., World]

    def make(self, params: Mapping[str, object] | None = None) -> World:
        """Build with ``params`` over the defaults.

        Raises:
            InputError: unknown parameter or a value out of its range.
        """
        defaults = {parameter.name: parameter.default for parameter in self.parameters}
        return self.build(**defaults | parse_named(self.name, self.parameters, dict(params or {})))


def _chain_steps(states: list[int], actions: range, rewards: list[float]) -> list[Outcome]:
    """Outcomes that walk ``states`` in order under any action, pay ``rewards``, and then end."""
    following = [*states[1:], END]
    return [Outcome(s, a, 1.0, following[i], rewards[i]) for i, s in enumerate(states) for a in actions]


def _branch(
    first: int, length: int, r1: float, r2: float, *, auxiliary: bool, slip: float, base: Callable[[int], int]
) -> Any:
    """The branching decision in state ``first``; later states are numbered by ``base(0), base(1), ...``.

    Returns the outcomes and the names of the later states.
    """
    long_states = [base(i) for i in range(length - 1)]
    short_states = [base(length - 1 + i) for i in range(length - 1)] if auxiliary else []
    names = [f"long {i + 1}" for i in range(length - 1)] + [f"idle {i + 1}" for i in range(len(short_states))]
    to_short = (short_states[0] if short_states else END, r1)
    to_long = (long_states[0] if long_states else END, 0.0 if long_states else r2)
    rows = []
    for action, (meant, other) in enumerate([(to_short, to_long), (to_long, to_short)]):
        rows += [Outcome(first, action, p, *goal) for p, goal in ((1.0 - slip, meant), (slip, other)) if p > 0]
    rows += _chain_steps(long_states, range(2), [0.0] * (length - 2) + [r2])
    rows += _chain_steps(short_states, range(2), [0.0] * len(short_states))
    return rows, names


_BRANCH_PARAMETERS = (
    Parameter("length", 3, 1, 200, "Steps on the long branch; it pays r2 at the last."),
    Parameter("r1", 5.0, -1000, 1000, "Reward of the short branch, paid at once."),
    Parameter("r2", 10.0, -1000, 1000, "Reward at the end of the long branch."),
    Parameter("auxiliary", False, help="Add zero-reward states until both branches have the same length."),
    Parameter("slip", 0.0, 0, 0.5, "Chance that the branching action is swapped for the other one."),
)


def two_branch(
    length: int = 3, *, r1: float = 5.0, r2: float = 10.0, auxiliary: bool = False, slip: float = 0.0
) -> World:
    """The toy MDP of the paper's Fig. 4: take r1 now and end, or wait for r2.

    Diagnoses the repeated reward: rescaled rows keep paying r1 after the short branch has ended.
    Optimum at the start, discount g: max(r1, 0) for T < length, else max(r1, g^(length-1) r2) (no slip).
    """
    rows, names = _branch(0, length, r1, r2, auxiliary=auxiliary, slip=slip, base=lambda i: i + 1)
    suggested = {"gammas": 15, "alpha": 0.2, "steps": length}
    return World.from_outcomes("two_branch", ["start", *names], ["short", "long"], rows, suggested=suggested)


def two_decisions(
    length: int = 3, *, r1: float = 5.0, r2: float = 10.0, auxiliary: bool = False, slip: float = 0.0, r0: float = 4.0
) -> World:
    """The same branch behind a first decision: take r0 and end, or go on to the branch.

    Diagnoses mixed policies: after "go on", low discounts take r1 and high ones wait for r2, so that the
    values over gamma belong to no single process. With the defaults they part at gamma = (r1/r2)^(1/2) = .707.
    """
    rows, names = _branch(1, length, r1, r2, auxiliary=auxiliary, slip=slip, base=lambda i: i + 2)
    rows += [Outcome(0, 0, 1.0, END, r0), Outcome(0, 1, 1.0, 1, 0.0)]
    suggested = {"gammas": 15, "spacing": "log", "gamma_min": 0.3, "gamma_max": 0.99, "alpha": 0.2, "steps": length + 1}
    states, actions = ["first", "branch", *names], ["leave / short", "go on / long"]
    return World.from_outcomes("two_decisions", states, actions, rows, suggested=suggested)


def fig6_chain(outer: float = 2.0, inner: float = 1.0) -> World:
    """The chain of the paper's Fig. 6: +-outer at steps 0 and 1, +-inner at steps 2 and 3, then the end.

    Diagnoses resolution in time and in reward on one clean process; nothing is decided in it.
    """
    sizes = [outer, outer, inner, inner]
    rows = [
        Outcome(i, 0, 0.5, i + 1 if i < 3 else END, sign * size) for i, size in enumerate(sizes) for sign in (1.0, -1.0)
    ]
    suggested = {"gammas": 100, "alpha": 1e-3, "steps": 4}
    return World.from_outcomes("fig6_chain", [f"step {i}" for i in range(4)], ["go"], rows, suggested=suggested)


def double_chain(
    early: int = 2, *, late: int = 6, r_early: float = 0.6, r_late: float = 1.0, p_early: float = 0.5
) -> World:
    """One of two chains by chance: r_early at step ``early`` or r_late at step ``late``.

    Diagnoses what marginals hold: both rewards show up in tau-space, each at its own step with its own
    chance, and survival falls in between.
    """
    early_states = list(range(1, early + 1))
    late_states = list(range(early + 1, early + late + 1))
    rows = [Outcome(0, 0, p_early, early_states[0], 0.0), Outcome(0, 0, 1.0 - p_early, late_states[0], 0.0)]
    rows = [row for row in rows if row.probability > 0]
    rows += _chain_steps(early_states, range(1), [0.0] * (early - 1) + [r_early])
    rows += _chain_steps(late_states, range(1), [0.0] * (late - 1) + [r_late])
    states = ["start", *(f"early {i}" for i in range(1, early + 1)), *(f"late {i}" for i in range(1, late + 1))]
    suggested = {"gammas": 100, "alpha": 1e-3, "steps": max(early, late) + 2}
    return World.from_outcomes("double_chain", states, ["go"], rows, suggested=suggested)


def rise_and_fade(length: int = 15, low: float = -1.0, high: float = 2.0) -> World:
    """A chain whose rewards rise from ``low``, stay ``high`` and fade to zero, a third of the length each.

    Diagnoses blur in time: how well a slow, smooth timeline survives the inverse.
    """
    knots = np.array([0.0, (length - 1) / 3.0, 2.0 * (length - 1) / 3.0, length - 1.0])
    rewards = np.interp(np.arange(length), knots, [low, high, high, 0.0])
    rows = _chain_steps(list(range(length)), range(1), [float(r) for r in rewards.round(6)])
    suggested = {"gammas": 30, "alpha": 0.01, "steps": length + 5}
    return World.from_outcomes("rise_and_fade", [f"step {i}" for i in range(length)], ["go"], rows, suggested=suggested)


_PAY_AFTER = (1, 3, 10, 30, 100)


def discounting_chain(reward: float = 1.0, bonus: float = 2.0, bonus_chain: int = 4) -> World:
    """Five actions that look alike and pay after 1, 3, 10, 30 or 100 steps; one chain pays more.

    Diagnoses the horizon: an action is worth something only once the horizon exceeds its delay
    (after bsuite's environment of the same name). With the defaults and gamma .99 the quickest chain is best
    up to T = 100, and the slowest one from there on: 3 * .99^100 = 1.10 against .99.
    """
    rows, states = [], ["start"]
    for action, delay in enumerate(_PAY_AFTER):
        chain = list(range(len(states), len(states) + delay))
        states += [f"chain {delay}, step {i}" for i in range(1, delay + 1)]
        rows.append(Outcome(0, action, 1.0, chain[0], 0.0))
        paid = reward + (bonus if action == bonus_chain else 0.0)
        rows += _chain_steps(chain, range(len(_PAY_AFTER)), [0.0] * (delay - 1) + [paid])
    actions = [f"pays after {delay}" for delay in _PAY_AFTER]
    suggested = {"gammas": 30, "spacing": "log", "gamma_min": 0.3, "gamma_max": 0.995, "alpha": 0.01, "steps": 110}
    return World.from_outcomes("discounting_chain", states, actions, rows, suggested=suggested)


def cliff_grid(
    width: int = 6, *, height: int = 4, slip: float = 0.0, goal: float = 10.0, cliff: float = -10.0, step: float = -0.2
) -> World:
    """A gridworld: from the bottom left to the bottom right along a cliff that ends the episode.

    Diagnoses deadlines: the goal is worth its price only while it can still be reached; with slip the
    short way along the edge is the risky one. An action slips to each side with chance slip/2.
    """
    if width * height - (width - 2) > MAX_STATES:
        raise InputError(f"a {width} x {height} grid has more than {MAX_STATES:,} states; make it smaller.")
    cells = [(x, y) for y in range(height) for x in range(width) if y < height - 1 or x == 0]
    index = {cell: i for i, cell in enumerate([cells[-1], *cells[:-1]])}
    moves = [(0, -1), (1, 0), (0, 1), (-1, 0)]
    rows = []
    for (x, y), s in index.items():
        for a in range(4):
            for turn, p in ((0, 1.0 - slip), (1, slip / 2), (-1, slip / 2)):
                if p == 0:
                    continue
                dx, dy = moves[(a + turn) % 4]
                x2, y2 = min(max(x + dx, 0), width - 1), min(max(y + dy, 0), height - 1)
                if y2 == height - 1 and x2 == width - 1:
                    rows.append(Outcome(s, a, p, END, goal + step))
                elif y2 == height - 1 and x2 > 0:
                    rows.append(Outcome(s, a, p, END, cliff + step))
                else:
                    rows.append(Outcome(s, a, p, index[x2, y2], step))
    positions = np.array([(x, -y) for x, y in index], dtype=float)
    suggested = {
        "gammas": 30,
        "spacing": "log",
        "gamma_min": 0.3,
        "alpha": 0.01,
        "steps": min(200, 4 * (width + height)),
    }
    states, actions = [f"({x}, {height - 1 - y})" for x, y in index], ["up", "right", "down", "left"]
    return World.from_outcomes("cliff_grid", states, actions, rows, suggested=suggested, positions=positions)


_PARAMETERS: dict[Callable[..., World], tuple[str, tuple[Parameter, ...]]] = {
    two_branch: ("Two branches (Fig. 4)", _BRANCH_PARAMETERS),
    two_decisions: (
        "Two decisions in a row",
        (*_BRANCH_PARAMETERS, Parameter("r0", 4.0, -1000, 1000, "Reward of leaving at the first decision.")),
    ),
    fig6_chain: (
        "Fig. 6 chain",
        (
            Parameter("outer", 2.0, -1000, 1000, "Size of the +- rewards at steps 0 and 1."),
            Parameter("inner", 1.0, -1000, 1000, "Size of the +- rewards at steps 2 and 3."),
        ),
    ),
    double_chain: (
        "Double chain, 50/50",
        (
            Parameter("early", 2, 1, 100, "Step at which the early chain pays."),
            Parameter("late", 6, 1, 100, "Step at which the late chain pays."),
            Parameter("r_early", 0.6, -1000, 1000, "Reward of the early chain."),
            Parameter("r_late", 1.0, -1000, 1000, "Reward of the late chain."),
            Parameter("p_early", 0.5, 0, 1, "Chance of the early chain."),
        ),
    ),
    rise_and_fade: (
        "Rise and fade, 15 steps",
        (
            Parameter("length", 15, 4, 200, "Number of rewards."),
            Parameter("low", -1.0, -1000, 1000, "The first reward."),
            Parameter("high", 2.0, -1000, 1000, "The reward in the middle third."),
        ),
    ),
    discounting_chain: (
        "Discounting chain",
        (
            Parameter("reward", 1.0, -1000, 1000, "What every chain pays."),
            Parameter("bonus", 2.0, -1000, 1000, "What one chain pays on top."),
            Parameter("bonus_chain", 4, 0, 4, "Which chain pays the bonus, 0 to 4."),
        ),
    ),
    cliff_grid: (
        "Gridworld with a cliff",
        (
            Parameter("width", 6, 3, 200, "Columns."),
            Parameter("height", 4, 2, 200, "Rows; the cliff is in the lowest."),
            Parameter("slip", 0.0, 0, 1, "Chance of sliding to a side instead."),
            Parameter("goal", 10.0, -1000, 1000, "Reward at the goal."),
            Parameter("cliff", -10.0, -1000, 1000, "Reward of falling."),
            Parameter("step", -0.2, -1000, 1000, "Reward of every step."),
        ),
    ),
}

PRESETS: dict[str, Preset] = {
    build.__name__: Preset(build.__name__, title, (inspect.getdoc(build) or "").split("\n")[0], parameters, build)
    for build, (title, parameters) in _PARAMETERS.items()
}
