"""How an agent learns: every choice as one frozen, typed object, with the defaults that suit a world.

A setting is defined once, as a field of :class:`LearnSettings`; the command line, the app and the saved files read
and write it by what stands there. None means "what suits the world" and is filled in by :func:`resolve_learning`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from functools import partial
from typing import Any

import numpy as np

from laplace_core.code.encoding import discount_grid
from laplace_core.errors import InputError
from laplace_core.parameters import Parameter, choice, like, schema_of, setting, switch
from laplace_core.planning import TARGET_POLICIES
from laplace_core.study.settings import DISCOUNT_RANGE, Settings, resolve
from laplace_core.tabular.td import Decay
from laplace_core.worlds import World

CONSTANT = 1e9
"""A half-life beyond any count: the rate or epsilon stays as it is."""
MAX_NUMBERS = 12_000_000
"""Most numbers in the tables of all seeds together: a saved file stays below 64 MB."""

# None until chosen; the default that stands here is what `resolve_learning` fills in.
_setting, _choice, _switch = (partial(kind, undecided=True) for kind in (setting, choice, switch))


@dataclass(frozen=True)
class LearnSettings:
    """Settings of one run of learning; None is what suits the world.

    Raises:
        InputError: a value out of its range.
    """

    episodes: int | None = _setting(None, 1, 1_000_000, "Episodes of each learner.")
    seeds: int | None = _setting(1, 1, 8, "Independent learners, one seed each; bands show their range.")
    seed: int | None = _setting(0, 0, 2**31 - 1, "Seed of the first learner; the next ones count up from it.")
    policy: str | None = _choice("shared", TARGET_POLICIES, "Greedy policy that every discount learns.")
    rate_first: float | None = _setting(1.0, 0, 1, "Learning rate of the first visit of a state and action.")
    rate_half: float | None = _setting(None, 1e-3, CONSTANT, "Visits after which the learning rate has halved.")
    rate_floor: float | None = _setting(0.0, 0, 1, "Smallest learning rate.")
    epsilon_first: float | None = _setting(1.0, 0, 1, "Chance of a random action in the first episode.")
    epsilon_half: float | None = _setting(None, 1e-3, CONSTANT, "Episodes after which that chance has halved.")
    epsilon_floor: float | None = _setting(None, 0, 1, "Smallest chance of a random action.")
    max_steps: int | None = _setting(None, 1, 100_000, "An episode is stopped after this number of steps.")
    starts: str | None = _choice(None, ("world", "everywhere"), "Start states: those of the world, or all states.")
    gammas: int | None = like(Settings, "gammas")
    spacing: str | None = like(Settings, "spacing")
    gamma_min: float | None = like(Settings, "gamma_min")
    gamma_max: float | None = like(Settings, "gamma_max")
    acting_gamma: float | None = _setting(0.99, *DISCOUNT_RANGE, "Discount by which the learner chooses its actions.")
    peers: bool | None = _switch(
        "Also learn the categorical, quantile, expectile and plain codes of the return.", default=False
    )
    peer_gamma: float | None = _setting(None, *DISCOUNT_RANGE, "Discount of that return (default: the acting gamma).")
    atoms: int | None = _setting(51, 2, 500, "Atoms of the categorical code.")
    quantiles: int | None = _setting(51, 1, 500, "Quantiles of the quantile code.")
    expectiles: int | None = _setting(11, 1, 101, "Expectiles of the expectile code, an odd number.")
    # Its step has the size of the rate however small the error is: a rate that stays high, as suits a world without
    # chance, would never let it settle.
    quantile_half: float | None = _setting(30.0, 1e-3, CONSTANT, "As rate-half, but for the quantile code.")

    def __post_init__(self) -> None:
        for parameter in LEARN_SCHEMA:
            value = getattr(self, parameter.name)
            if value is not None:
                object.__setattr__(self, parameter.name, parameter.parse(value))


@dataclass(frozen=True, kw_only=True)
class ResolvedLearning(LearnSettings):
    """Settings of one run of learning that leave nothing open; :func:`dataclasses.replace` keeps the type.

    Raises:
        InputError: None for a setting.
    """

    episodes: int
    seeds: int
    seed: int
    policy: str
    rate_first: float
    rate_half: float
    rate_floor: float
    epsilon_first: float
    epsilon_half: float
    epsilon_floor: float
    max_steps: int
    starts: str
    gammas: int
    spacing: str
    gamma_min: float
    gamma_max: float
    acting_gamma: float
    peers: bool
    peer_gamma: float
    atoms: int
    quantiles: int
    expectiles: int
    quantile_half: float

    def __post_init__(self) -> None:
        super().__post_init__()
        for parameter in LEARN_SCHEMA:
            if getattr(self, parameter.name) is None:
                raise InputError(f"{parameter.name} is not decided: resolve the settings first.")

    def chosen(self) -> LearnSettings:
        """The same values as if each had been chosen."""
        return LearnSettings(**asdict(self))

    @property
    def rate(self) -> Decay:
        return Decay(self.rate_first, self.rate_half, self.rate_floor)

    @property
    def epsilon(self) -> Decay:
        return Decay(self.epsilon_first, self.epsilon_half, self.epsilon_floor)

    @property
    def quantile_rate(self) -> Decay:
        return Decay(self.rate_first, self.quantile_half, self.rate_floor)

    @property
    def discounts(self) -> np.ndarray:
        """The discount grid, ``(G,)``."""
        return discount_grid(self.gammas, self.spacing, self.gamma_min, self.gamma_max)


LEARN_SCHEMA = schema_of(LearnSettings)
"""One entry a setting, in the order of the fields."""

BY_NAME: Mapping[str, Parameter] = {parameter.name: parameter for parameter in LEARN_SCHEMA}
GRID_NAMES = ("gammas", "spacing", "gamma_min", "gamma_max", "acting_gamma")
DECIDED_NAMES = (*GRID_NAMES, "policy")
"""Settings of a study that the learner has decided already."""

# Preset -> episodes and starts, measured to come within 2% of the exact gamma-space with the rates of _suggested.
_MEASURED: dict[str, tuple[int, str]] = {
    "two_branch": (200, "everywhere"),
    "two_decisions": (200, "everywhere"),
    "fig6_chain": (6_000, "world"),
    "double_chain": (6_000, "world"),
    "rise_and_fade": (400, "everywhere"),
    "discounting_chain": (2_000, "world"),
    "cliff_grid": (600, "everywhere"),
}


def parse_learn_settings(given: Mapping[str, Any]) -> LearnSettings:
    """Settings from text values by name.

    Raises:
        InputError: a value out of its range, or a name that is no setting.
    """
    for name in given:
        if name not in BY_NAME:
            raise InputError(f"{str(name)[:40]!r} is not a setting of learning; known are {', '.join(BY_NAME)}.")
    return LearnSettings(**given)


def resolve_learning(settings: LearnSettings, world: World) -> ResolvedLearning:
    """Fill every None with what suits the world; resolving again changes nothing.

    Raises:
        InputError: settings that do not fit the world or each other.
    """
    chosen = {f.name: getattr(settings, f.name) for f in fields(settings)}
    chosen = {name: value for name, value in chosen.items() if value is not None}
    grid = resolve(Settings(**{name: chosen[name] for name in GRID_NAMES if name in chosen}), world)
    values: dict[str, Any] = {parameter.name: parameter.default for parameter in LEARN_SCHEMA}
    values |= {name: getattr(grid, name) for name in GRID_NAMES} | _suggested(world) | chosen
    if values["spacing"] == "paper":  # these fifteen and no others
        values |= {name: getattr(grid, name) for name in ("gammas", "gamma_min", "gamma_max")}
    if values["peer_gamma"] is None:
        values["peer_gamma"] = values["acting_gamma"]
    if values["epsilon_half"] is None:
        values["epsilon_half"] = max(1.0, values["episodes"] / 10.0)
    resolved = ResolvedLearning(**values)
    for name in ("rate", "epsilon"):
        if values[f"{name}_floor"] > values[f"{name}_first"]:
            raise InputError(f"{name}_floor must not be above {name}_first, {values[f'{name}_first']:g}.")
    if values["expectiles"] % 2 == 0:
        raise InputError("expectiles must be an odd number, so that one of them is the mean.")
    size = sum(int(np.prod(shape)) for shape in table_shapes(resolved, world).values())
    if size > MAX_NUMBERS:
        raise InputError(
            f"{resolved.seeds} seeds, {world.n_states} states, {world.n_actions} actions, {resolved.gammas} discounts "
            f"and {world.reward_values.size} distinct rewards make tables of {size:,} numbers, above "
            f"{MAX_NUMBERS:,}: lower seeds or gammas, or round the rewards."
        )
    return resolved


def table_shapes(settings: ResolvedLearning, world: World) -> dict[str, tuple[int, ...]]:
    """The tables of all learners, by name; N seeds first."""
    pairs = (settings.seeds, world.n_states, world.n_actions)
    shapes = {"basis": (*pairs, len(settings.discounts), world.reward_values.size), "acting_values": pairs}
    if settings.peers:
        shapes |= {
            "laplace_values": pairs,
            "plain": pairs,
            "categorical": (*pairs, settings.atoms),
            "quantile": (*pairs, settings.quantiles),
            "expectile": (*pairs, settings.expectiles),
        }
    return shapes


def _suggested(world: World) -> dict[str, object]:
    """Episodes, starts, rates and exploration that suit a world.

    A world without chance can be learned at full rate. Where chance decides, the rate falls after as many visits as
    it may take until the values that are bootstrapped from have been learned: a smaller half-life would still remember
    them as they were before, a larger one leaves more noise. An episode takes word back by one step, so that a long
    world needs as many episodes as it has steps. In the presets a random walk finds everything; elsewhere it may take
    for ever, so that episodes are cut early and follow the learned policy more and more.
    """
    states, pairs, certain = world.n_states, world.n_states * world.n_actions, bool(np.all(world.probability >= 1.0))
    half = 1_000.0 if certain else float(np.clip(states, 10, 100))
    enough = 8 * states if certain else min(200 * pairs, 20_000)
    if world.source in _MEASURED:
        episodes, starts = _MEASURED[world.source]
        return {"episodes": max(episodes, enough), "starts": starts, "rate_half": half, "max_steps": 1_000,
                "epsilon_half": CONSTANT, "epsilon_floor": 0.0}  # fmt: skip
    episodes = min(max(300, 5 * pairs), 20_000) if certain else max(6_000, enough)
    return {"episodes": episodes, "starts": "everywhere", "rate_half": half, "max_steps": 200, "epsilon_floor": 0.3}
