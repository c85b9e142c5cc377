"""Races to a deadline between trained agents: who acts by what rule, the work that this is, and the result in words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from laplace_core.acting import estimates
from laplace_core.acting.deadlines import longest_horizon, rules_of_race, trained_discount, usual_horizon
from laplace_core.acting.race import MOST_RACES, MOST_START, Entrant, Race, Races, race, races
from laplace_core.acting.rules import suited, words_of
from laplace_core.environments import GYMNASIUM_ENVIRONMENTS
from laplace_core.exchange.links import by_name
from laplace_core.parameters import Parameter
from laplace_core.payloads.track import payload
from laplace_core.supervise.jobs import Progress, Task
from laplace_core.training.checkpoint import Loaded
from laplace_core.words import capital, steps

HORIZON, START, LEFT, GAMMA, RIGHT, AT, MANY, COUNT = (
    "d.T", "d.start", "d.left", "d.gamma", "d.right", "d.at", "d.many", "d.starts",
)  # fmt: skip
USUAL_COUNT = 100
_STOPPED = "Both episodes are stopped after this number of steps."
_HELD_OUT = "No agent was trained or chosen on any of these starts."
_RIGHT_HELP = "The rule by which the agent acts for the time to go."
_STOPS = (1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 25, 30, 40, 50, 60, 80, 100, 125, 150, 200, 250, 300, 400, 500, 700, 1000)


@dataclass(frozen=True)
class Control:
    """The agents, rules and deadline of a race; ``gamma`` is the discount of a greedy left side."""

    left: Loaded
    left_rule: str
    gamma: float | None
    right: Loaded
    right_rule: str
    horizon: int

    @property
    def environment(self) -> str:
        return self.right.environment

    @property
    def entrants(self) -> tuple[Entrant, Entrant]:
        left = Entrant(self.left.agent, self.left_rule, self.gamma)
        return left, Entrant(self.right.agent, self.right_rule)


def horizons(loaded: Loaded, shown: int) -> list[int]:
    """Stops of the slider of T, denser where it is short; with the one that is shown."""
    limit = longest_horizon(loaded.agent, loaded.environment)
    return sorted({*(stop for stop in _STOPS if stop < limit), limit, shown})


def parameters(loaded: Loaded, other: Loaded | None = None) -> dict[str, Parameter]:
    """The entries of a link in addition to the agents."""
    left, played = rules_of_race((other or loaded).agent), (loaded.agent, loaded.environment)
    return by_name(
        Parameter(HORIZON, usual_horizon(*played), 1, longest_horizon(*played), _STOPPED),
        Parameter(START, 0, 0, MOST_START, f"Number of the start of both sides. {_HELD_OUT}"),
        Parameter(
            LEFT, None, help="Rule of the left side, with which the right side is compared.", kind=str, choices=left
        ),
        Parameter(GAMMA, None, 1e-6, 0.999999, "The left side takes the best action at this discount.", float),
        Parameter(RIGHT, None, help=_RIGHT_HELP, kind=str, choices=rules_of_race(loaded.agent)),
        Parameter(AT, None, 0, 10_000, "Number of steps before the cursor.", int),
        Parameter(MANY, "no", help="Whether the race runs from many starts.", choices=("no", "yes")),
        Parameter(COUNT, USUAL_COUNT, 2, MOST_RACES, "Number of starts; more make the interval narrower."),
    )


def control_of(values: Mapping[str, Any], left: Loaded, right: Loaded) -> Control:
    """The race of two agents, or of one on both sides, that a page's values describe."""
    played = right.agent, right.environment
    horizon = min(int(values.get(HORIZON, usual_horizon(*played))), longest_horizon(*played))
    left_rule = str(values.get(LEFT, rules_of_race(left.agent)[0]))
    right_rule = str(values.get(RIGHT, suited(right.agent, horizon)))
    gamma = trained_discount(left.agent, values.get(GAMMA)) if left_rule == "greedy" else None
    return Control(left, left_rule, gamma, right, right_rule, horizon)


def racing(control: Control, start: int) -> Task[tuple[Race, bytes]]:
    """The race of a control from a start, and the same packed for the track."""
    horizon, pictures = control.horizon, control.environment in GYMNASIUM_ENVIRONMENTS

    def make(progress: Progress) -> tuple[Race, bytes]:
        run = race(control.environment, *control.entrants, start, horizon=horizon, pictures=pictures, progress=progress)
        return run, payload(run)

    def estimate() -> float:
        return estimates.of_races(control.environment, control.entrants, horizon, pictures=pictures)

    return Task((control, start), make, estimate, slot="race", lower="lower T or choose quicker rules")


def field(control: Control, count: int) -> Task[tuple[Races, dict[str, Any]]]:
    """The races of a control from the first so many starts, and their summary."""

    def make(progress: Progress) -> tuple[Races, dict[str, Any]]:
        runs = races(control.environment, *control.entrants, control.horizon, count=count, progress=progress)
        return runs, runs.summary()

    def estimate() -> float:
        return estimates.of_races(control.environment, control.entrants, control.horizon, count)

    lower = "lower T or the number of starts, or choose quicker rules"
    return Task((control, count), make, estimate, slot="field", lower=lower)


def sides(control: Control) -> tuple[str, str]:
    """Names of the left and the right side, that tell them apart."""
    left, right = words_of(control.left_rule), words_of(control.right_rule)
    if control.gamma is not None:
        left += f" (γ {control.gamma:.3g})"
    if control.left is control.right:
        return left, right
    if control.left.algorithm == control.right.algorithm:
        return f"{left}, other agent", right
    return f"{control.left.settings.TITLE}: {left}", f"{control.right.settings.TITLE}: {right}"


def alike(control: Control) -> bool:
    """Whether both sides are the same."""
    same = control.left is control.right and control.left_rule == control.right_rule
    return same and control.gamma is None


def verdict(race: Race, control: Control) -> tuple[str, str]:
    """``ahead``, ``behind`` or ``level``, and one sentence."""
    if alike(control):
        return "level", "Both sides act by the same rule: choose another one for either of them."
    left, right = sides(control)
    totals = [float(side.rewards.sum()) for side in (race.left, race.right)]
    where = f"Within {steps(race.horizon)} from start {race.start}"
    if race.parting is None and len(race.left) == len(race.right):
        return "level", f"{where} both take the same actions: {totals[0]:.1f} each."
    if abs(race.difference) < 0.05:
        apart = f", by different actions from step {race.parting + 1} on" if race.parting is not None else ""
        return "level", f"{where}: {left} {totals[0]:.1f}, {right} {totals[1]:.1f}: level{apart}."
    leader = right if race.difference > 0 else left
    tone, lead = "ahead" if race.difference > 0 else "behind", abs(race.difference)
    returns = f"{where}: {left} {totals[0]:.1f}, {right} {totals[1]:.1f}"
    return tone, f"{returns}. {capital(leader)} is ahead by {lead:.1f}."


def field_verdict(summary: Mapping[str, Any], control: Control) -> tuple[str, str]:
    """The same for many races, from their summary."""
    left, right = sides(control)
    low, high = summary["interval"]
    count, mean = f"Over {summary['starts']} starts", float(summary["difference"])
    if summary["equal"] == 1.0:
        return "level", f"{count} both have the same return from every start."
    means = f"{count}: {left} {summary['left']:.1f}, {right} {summary['right']:.1f} on average"
    if low <= 0.0 <= high:
        return "level", f"{means}. The interval of the difference covers 0: these starts do not show which is better."
    leader, tone = (right, "ahead") if mean > 0 else (left, "behind")
    return tone, f"{means}. {capital(leader)} is ahead by {abs(mean):.1f} ({_range(low, high)})."


def _range(low: float, high: float) -> str:
    """The interval of a lead, of either side."""
    return f"95% {min(abs(low), abs(high)):.1f} to {max(abs(low), abs(high)):.1f}"


def inside(control: Control, side: str, seed: int, step: int) -> dict[str, str]:
    """Values of the link that opens one side of a race on the page of trained agents, but for the agent's name."""
    rule = control.left_rule if side == "left" else control.right_rule
    query = {"r.shown": "yes", "r.seed": str(seed), "r.rule": rule, "r.at": str(max(0, step - 1))}
    if rule != "greedy":
        query["r.horizon"] = str(control.horizon)
    if side == "left" and control.gamma is not None:
        query["r.gamma"] = f"{control.gamma:.8g}"
    return query


def command(control: Control, count: int, file: str, against: str | None = None) -> str:
    """The command that prints the figures of many races.

    Args:
        file: where the agent lies; ``against``: where the other one does, if there is another.
    """
    words = ["laplace", "race", file, "--horizon", str(control.horizon)]
    words += ["--rule", control.right_rule, "--against", control.left_rule]
    if against is not None:
        words += ["--against-agent", against]
    if control.gamma is not None:
        words += ["--gamma", f"{control.gamma:.8g}"]
    return " ".join([*words, "--seeds", str(count)])
