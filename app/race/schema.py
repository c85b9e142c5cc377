"""The race that a page shows, as values of its link: the agents, the rules, the deadline, the start; and its words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from app.catalogue import checkpoints, training_runs
from app.race.jobs import Control
from laplace_core import InputError
from laplace_core.acting.deadlines import longest_horizon, rules_of_race, trained_discount, usual_horizon
from laplace_core.acting.race import MOST_RACES, MOST_START
from laplace_core.acting.rules import suited
from laplace_core.exchange.links import Check, Entries, Schema, Values, by_name
from laplace_core.parameters import Parameter
from laplace_core.training.checkpoint import Loaded

AGENT, AGAINST = "checkpoint", "d.against"
HORIZON, START, LEFT, GAMMA, RIGHT, AT, MANY, COUNT = (
    "d.T", "d.start", "d.left", "d.gamma", "d.right", "d.at", "d.many", "d.starts",
)  # fmt: skip
FIRST_AGENT = "laplace_LunarLander-v3"
"""What a visitor without a link sees: an environment in which a deadline matters."""
USUAL_COUNT = 100
_STOPPED = "Both episodes are stopped after so many steps."
_HELD_OUT = "No agent was trained or chosen on any of these starts."
_RIGHT_HELP = "The rule by which the agent acts for the time to go."
RIVAL = Parameter(AGAINST, None, help="Another agent of this environment.", kind=str)
_STOPS = (1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 25, 30, 40, 50, 60, 80, 100, 125, 150, 200, 250, 300, 400, 500, 700, 1000)


def opening() -> Values:
    listed = checkpoints.names()
    return {AGENT: FIRST_AGENT if FIRST_AGENT in listed else listed[0]} if listed else {}


def rivals(name: str, environment: str) -> tuple[str, ...]:
    """Other agents of the same environment."""
    return tuple(other for other in checkpoints.names() if other != name and _environment(other) == environment)


def _environment(name: str) -> str | None:
    """Of a run without opening its checkpoint: there may be many."""
    if name.startswith(checkpoints.RUN):
        settings = training_runs.queue().get(name.removeprefix(checkpoints.RUN)).settings
        return None if settings is None else settings.environment
    return checkpoints.checkpoint(name).environment


def horizons(loaded: Loaded, shown: int) -> list[int]:
    """Stops of the slider of T, denser where it is short; with the one that is shown."""
    limit = longest_horizon(loaded.agent, loaded.environment)
    return sorted({*(stop for stop in _STOPS if stop < limit), limit, shown})


def parameters(loaded: Loaded, other: Loaded | None = None) -> dict[str, Parameter]:
    """What a link may hold besides the agents."""
    left, played = rules_of_race((other or loaded).agent), (loaded.agent, loaded.environment)
    return by_name(
        Parameter(HORIZON, usual_horizon(*played), 1, longest_horizon(*played), _STOPPED),
        Parameter(START, 0, 0, MOST_START, f"Both sides begin from it. {_HELD_OUT}"),
        Parameter(LEFT, None, help="The rule that the right side is compared with.", kind=str, choices=left),
        Parameter(GAMMA, None, 1e-6, 0.999999, "It takes the best action at this discount.", float),
        Parameter(RIGHT, None, help=_RIGHT_HELP, kind=str, choices=rules_of_race(loaded.agent)),
        Parameter(AT, None, 0, 10_000, "Steps that are over under the cursor.", int),
        Parameter(MANY, "no", help="Whether many starts are raced over.", choices=("no", "yes")),
        Parameter(COUNT, USUAL_COUNT, 2, MOST_RACES, "From start 0 on; more starts make the interval narrower."),
    )


def _is_rival(values: Values) -> None:
    """The other agent is one of the same environment, and can be opened."""
    if AGAINST not in values or AGENT not in values:
        return
    environment = checkpoints.checkpoint(str(values[AGENT])).environment
    if values[AGAINST] not in rivals(str(values[AGENT]), environment):
        raise InputError(f"{str(values[AGAINST])[:40]!r} is no other agent of {environment}.")
    checkpoints.checkpoint(str(values[AGAINST]))


def _of_race(values: Values) -> dict[str, Parameter]:
    if AGENT not in values:
        return {}
    other = checkpoints.checkpoint(str(values[AGAINST])) if AGAINST in values else None
    return parameters(checkpoints.checkpoint(str(values[AGENT])), other)


LINK = Schema(
    opening=opening,
    steps=(
        *checkpoints.NAMED,
        Entries(by_name(RIVAL)),
        Check(_is_rival, drops=(AGAINST,)),
        Entries(_of_race),
    ),
)


def control_of(values: Mapping[str, Any]) -> Control:
    """The race that a page's values describe.

    Raises:
        InputError: an agent that is there no longer.
    """
    right = checkpoints.checkpoint(str(values[AGENT]))
    left = checkpoints.checkpoint(str(values[AGAINST])) if AGAINST in values else right
    played = right.agent, right.environment
    horizon = min(int(values.get(HORIZON, usual_horizon(*played))), longest_horizon(*played))
    left_rule = str(values.get(LEFT, rules_of_race(left.agent)[0]))
    right_rule = str(values.get(RIGHT, suited(right.agent, horizon)))
    gamma = trained_discount(left.agent, values.get(GAMMA)) if left_rule == "greedy" else None
    return Control(left, left_rule, gamma, right, right_rule, horizon)
