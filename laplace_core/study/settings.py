"""Every choice that leads from a world to a tau-space, as one frozen, typed object.

A setting is defined once, as a field of :class:`Settings`; the command line, the URL of the app and the saved files
all use this definition. None means "the default for the world", which :func:`resolve` fills in.
"""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from functools import lru_cache, partial
from typing import Any, Self

import numpy as np

from laplace_core.code.encoding import GAMMA_SPACINGS, PAPER_GAMMAS, THETA_SCALE_HELP, THETA_SPACINGS, sensitivity_grid
from laplace_core.errors import InputError
from laplace_core.inverse import ALPHA_CHOICES, MAX_STEPS, NORMALISATIONS, SOLVERS
from laplace_core.inverse.smoothing import DISCOUNT_FILTERS
from laplace_core.parameters import NUMBER, Parameter, as_text, choice, schema_of, setting, switch, text
from laplace_core.planning import TARGET_POLICIES
from laplace_core.study.horizon import row_horizons
from laplace_core.worlds import World

WEIGHTINGS = ("equal", "deviation")
"""``deviation`` divides the values of a discount by the standard deviation of their error, which grows like
1 / (1 - gamma); ``equal`` does not."""
DEADLINES = ("time_to_go", "constant")
"""``time_to_go`` acts by V_{T-t} at step t; ``constant`` by V_T at every step, as the paper's experiment does."""
SLOPE_TIMES_SPACING = 2.35
"""Default slope in units of 1/spacing: neighbouring sigmoids overlap, so that the midpoint proxy is unbiased
(error below .1% of the spacing) and the blur stays near two spacings. It makes the paper's 25 on 150
thresholds over [-2, 12]."""
DISCOUNT_RANGE = (1e-6, 0.999999)
"""Smallest and largest discount that can be chosen."""
OVERHANG = 0.2
"""Default overhang of the sensitivities beyond the rewards, as a fraction of their range."""

# None until chosen; the default that stands here is what `resolve` fills in.
_setting, _choice, _switch = (partial(kind, undecided=True) for kind in (setting, choice, switch))


@lru_cache(maxsize=64)
def levels_in(text: str) -> tuple[float, ...]:
    """The numbers of ``noise_levels``.

    Raises:
        InputError: a word that is no number, or not from 1e-12 to 1.
    """
    words = [word.strip() for word in text.split(",")]
    levels = tuple(float(word) if NUMBER.fullmatch(word) else float("nan") for word in words)
    for word, level in zip(words, levels, strict=True):
        if not 1e-12 <= level <= 1.0:
            raise InputError(f"noise_levels must be numbers from 1e-12 to 1, by commas, not {word[:40]!r}.")
    return levels


@dataclass(frozen=True)
class Settings:
    """Settings of one study.

    Values may be given as text or numbers and are kept in their own type; None is what suits the world. ``world`` may
    be given as a ``Path``, ``params`` as a mapping.

    Raises:
        InputError: a value out of its range.
    """

    world: str = "two_branch"
    params: tuple[tuple[str, object], ...] = ()
    state: str | None = text("State of the view, by name or index (default: the most likely start).")
    gammas: int | None = _setting(None, 2, 500, "Number of discounts.")
    spacing: str | None = _choice("inverse-log", GAMMA_SPACINGS, "Spacing of the discounts.")
    gamma_min: float | None = _setting(0.01, *DISCOUNT_RANGE, "Smallest discount.")
    gamma_max: float | None = _setting(0.99, *DISCOUNT_RANGE, "Largest discount.")
    thetas: int | None = _setting(150, 2, 2000, "Number of reward sensitivities.")
    theta_spacing: str | None = _choice("uniform", THETA_SPACINGS, "Spacing of the sensitivities.")
    theta_min: float | None = _setting(None, -1e10, 1e10, "Smallest sensitivity, in reward.")
    theta_max: float | None = _setting(None, -1e10, 1e10, "Largest sensitivity, in reward.")
    theta_scale: float | None = _setting(None, 0, 1e10, THETA_SCALE_HELP)
    slope: float | None = _setting(None, 1e-12, 1e12, "Steepness of the reward activation, in 1/reward.")
    alpha: float | None = _setting(0.01, 0, 1e6, "Regularisation of the inverse, in singular values of the transform.")
    steps: int | None = _setting(None, 1, MAX_STEPS, "Rows of tau-space: the longest timeline it can hold.")
    time_step: float | None = _setting(
        1.0, 1e-3, 1, "Time from one row of tau-space to the next, in steps of the world."
    )
    normalise: str | None = _choice("none", NORMALISATIONS, "Scaling of the rows of tau-space.")
    policy: str | None = _choice("shared", TARGET_POLICIES, "Policy that every discount evaluates.")
    acting_gamma: float | None = _setting(
        0.99, *DISCOUNT_RANGE, "Discount of the policy and of the values over the horizon."
    )
    softness: float | None = _setting(
        0.0, 0, 10, "Width of the deadline, as a fraction of the horizon; 0 is a hard one."
    )
    deadline: str | None = _choice(
        "time_to_go", DEADLINES, "T at each step of an episode: the time to go, or constant."
    )
    solver: str | None = _choice("tikhonov", tuple(SOLVERS), "Solver that inverts the transform.")
    selector: str | None = _choice(
        "typed", ALPHA_CHOICES, "Rule that chooses alpha, as --alpha NAME does; 'typed' uses the number of --alpha."
    )
    noise_level: float | None = _setting(
        None,
        1e-12,
        1,
        "Assumed random error of gamma-space: standard deviation of (1 - gamma) Q. The rule discrepancy needs it.",
    )
    noise_levels: str | None = text(
        "The same for each discount, separated by commas, in place of --noise-level.",
        levels_in,
    )
    weighting: str | None = _choice(
        None, WEIGHTINGS,
        "Weights of the discounts in the fit: equal, or by the deviation of their error, 1/(1-gamma). The second is "
        "the default if a rule chooses alpha or a noise level is given.",
    )  # fmt: skip
    filter: str | None = _choice("none", DISCOUNT_FILTERS, "Filter over the discounts before the inverse.")
    filter_window: int | None = _setting(5, 1, 499, "Discounts in a window of --filter savgol, an odd number.")
    filter_order: int | None = _setting(2, 0, 20, "Order of the polynomial of --filter savgol.")
    noise: float | None = _setting(
        0.0, 0, 1, "Random error of gamma-space: standard deviation of (1 - gamma) Q, a probability."
    )
    noise_seed: int | None = _setting(0, 0, 2**31 - 1, "Seed of the noise in gamma-space.")
    horizon: float | None = _setting(None, 1e-3, 2000, "Deadline T, in steps of the world (default: the longest).")
    used: float | None = _setting(0.0, 0, 2000, "Steps of the episode that are over; the time to go is T minus these.")
    value_gamma: float | None = _setting(None, *DISCOUNT_RANGE, "Discount of the values (default: the acting gamma).")
    fold: bool | None = _switch("Decode only as many rows as the horizon has (K = T).", default=False)
    shift: bool | None = _switch("Decode each discount by the row of the next one, an index error.", default=False)
    clip: bool | None = _switch("Begin the sensitivities at the lowest reward that occurs.", default=False)
    paper_grid: bool | None = _switch("Use the paper's 15 discounts in place of the grid.", default=False)
    slope_share: float | None = _setting(
        1.0, 0.05, 1, "Share of the trained slope, for a gamma-space that has its slope."
    )

    def __post_init__(self) -> None:
        put = partial(object.__setattr__, self)
        if not isinstance(self.world, str | os.PathLike):
            raise InputError(f"world must be a name or a path, not {type(self.world).__name__}.")
        put("world", os.fspath(self.world))
        try:
            put("params", tuple(dict(self.params).items()))
        except (TypeError, ValueError):
            raise InputError("params must be a mapping, or pairs, of names and values.") from None
        for parameter in SCHEMA:
            value = getattr(self, parameter.name)
            if value is not None:
                put(parameter.name, parameter.parse(value))
        if self.noise_levels is not None:
            levels_in(self.noise_levels)

    def to_command(self, out: str | None = None) -> str:
        """The ``decode`` command that reproduces this study."""
        words = ["python", "-m", "laplace_core", "decode", self.world]
        for name, value in self.params:
            words += ["--param", f"{name}={as_text(value)}"]
        for parameter, value in self._said():
            words += ["--alpha" if parameter.name == "selector" else flag(parameter), as_text(value)]
        return shlex.join(words + (["--out", out] if out else []))

    def _said(self) -> list[tuple[Parameter, object]]:
        """The settings that have to be said to repeat this study, with their values."""
        chosen = [(parameter, getattr(self, parameter.name)) for parameter in SCHEMA]
        ruled = self.selector not in (None, "typed")  # then alpha is what the rule finds
        return [
            (parameter, value)
            for parameter, value in chosen
            if value is not None and not self._is_off(parameter) and not (ruled and parameter.name == "alpha")
        ]

    def _is_off(self, parameter: Parameter) -> bool:
        """Whether a switch is off, which no later default can change: a command without it says the same."""
        value = getattr(self, parameter.name)
        if parameter.name == "weighting":
            return bool(value == _weighting(vars(self)))
        return parameter.name in SWITCHES and value == parameter.default

    def to_python(self, world_expression: str | None = None) -> str:
        """A Python script that repeats this study: only what was chosen is written, the rest suits the world.

        Args:
            world_expression: how to get the world, such as ``read_world("edited.json")``, where ``world`` does not
                name it.
        """
        words = [f"{parameter.name}={_literal(value)}" for parameter, value in self._said()]
        if world_expression is None and self.world.lower().endswith(".npz"):
            state = "" if self.state is None else f", {_literal(self.state)}"
            words.insert(0, f"world={_literal(self.world)}")
            return _script(
                ["from laplace_core import Settings, study_of_gamma_space",
                 "from laplace_core.study.npz import read_gamma_space"],
                f"gamma_space = read_gamma_space({_literal(self.world)}{state})",
                "study_of_gamma_space", "gamma_space", words=words, truth=False,
            )  # fmt: skip
        if world_expression is None:
            params = ", ".join(f"{_literal(name)}: {_literal(value)}" for name, value in self.params)
            world_expression = f"load_world({_literal(self.world)}{f', {{{params}}}' if params else ''})"
        loaders = [name for name in WORLD_MAKERS if f"{name}(" in world_expression]
        imports = ["from laplace_core import Settings, study"]
        imports += [f"from laplace_core.worlds import {', '.join(loaders)}"] if loaders else []
        return _script(imports, f"world = {world_expression}", "study", "world", words=words, truth=True)


@dataclass(frozen=True, kw_only=True)
class Resolved(Settings):
    """Settings that leave nothing open of how a gamma-space is decoded and read.

    What encodes it (``ENCODING_NAMES``) and the state may be None: then the gamma-space was learned elsewhere and its
    file decides. :func:`dataclasses.replace` keeps the type; :meth:`chosen` gives it up.

    Raises:
        InputError: None for a setting that must be decided.
    """

    alpha: float
    steps: int
    time_step: float
    normalise: str
    acting_gamma: float
    softness: float
    deadline: str
    solver: str
    selector: str
    weighting: str
    filter: str
    filter_window: int
    filter_order: int
    noise: float
    noise_seed: int
    used: float
    value_gamma: float
    fold: bool
    shift: bool
    slope_share: float

    def __post_init__(self) -> None:
        super().__post_init__()
        for parameter in SCHEMA:
            if getattr(self, parameter.name) is None and parameter.name not in self._open():
                raise InputError(f"{parameter.name} is not decided: resolve the settings first.")

    @staticmethod
    def _open() -> tuple[str, ...]:
        """Names of the settings that may be None."""
        return ("state", "horizon", "noise_level", "noise_levels", *ENCODING_NAMES)

    def at_alpha(self, alpha: float) -> Self:
        """The same settings with this very alpha, whatever rule chose theirs."""
        return replace(self, alpha=alpha, selector="typed")

    def chosen(self) -> Settings:
        """The same values as if each had been chosen, so that any of them may be given up again."""
        return Settings(**{each.name: getattr(self, each.name) for each in fields(Settings)})


@dataclass(frozen=True, kw_only=True)
class ResolvedForWorld(Resolved):
    """Settings of a world that leave nothing open; a ``theta_scale`` of None is the one that suits the range."""

    state: str
    gammas: int
    spacing: str
    gamma_min: float
    gamma_max: float
    thetas: int
    theta_spacing: str
    theta_min: float
    theta_max: float
    slope: float
    policy: str
    clip: bool
    paper_grid: bool

    @staticmethod
    def _open() -> tuple[str, ...]:
        return ("theta_scale", "horizon", "noise_level", "noise_levels")


SCHEMA = schema_of(Settings)
"""One entry a setting, in the order of the line from world to action."""

SWITCHES = (
    "used", "fold", "shift", "clip", "paper_grid", "slope_share",
    "selector", "weighting", "filter", "filter_window", "filter_order",
)  # fmt: skip
"""Settings that do nothing unless they are chosen."""

BY_NAME: Mapping[str, Parameter] = {parameter.name: parameter for parameter in SCHEMA}


WORLD_FILES = (".json", ".safetensors", ".npz")
"""Endings of the files that the ``world`` of settings may name."""

WORLD_MAKERS = ("load_world", "parse_world", "read_world", "timeline_world", "world_from_rows")
"""What :meth:`Settings.to_python` imports where the world's expression calls it."""


def _literal(value: object) -> str:
    """A value as Python source, in double quotes where that needs no escape."""
    text = repr(value.item() if isinstance(value, np.generic) else value)
    return f'"{text[1:-1]}"' if isinstance(value, str) and text[0] == "'" and '"' not in text else text


def _script(
    imports: list[str], source: str, function: str, argument: str, *, words: list[str], truth: bool
) -> str:  # fmt: skip
    """The lines of a script; long settings take a line each."""
    line = f"result = {function}({argument}, Settings({', '.join(words)}))"
    if len(line) > 100:
        listed = "".join(f"    {word},\n" for word in words)
        line = f"settings = Settings(\n{listed})\nresult = {function}({argument}, settings)"
    outputs = [
        "result.decoded.tau_space  # (actions, steps, sensitivities - 1): how likely each reward is at each step",
        "result.decoded.horizon_values  # (actions, steps): the value of each action for the horizon T = 1, 2, ...",
        "result.decoded.actions  # (steps,): the action chosen for each horizon",
    ]
    if truth:
        outputs.append("result.truth.optimal_action  # (steps,): the best one")
    return "\n".join([*imports, "", source, line, "", *outputs, ""])


def flag(parameter: Parameter) -> str:
    return "--" + parameter.name.replace("_", "-")


def parse_settings(world: str, params: Mapping[str, object], given: Mapping[str, Any]) -> Settings:
    """Settings from text values by name.

    Raises:
        InputError: a value out of its range; the sentence begins with the setting's name.
    """
    return Settings(world=world, params=tuple(params.items()), **given)


def check_paper_grid(given: Mapping[str, object]) -> None:
    """Refuse a discount grid of one's own beside the paper's fifteen discounts, which would change nothing.

    Args:
        given: values by the name of the setting, those that were given explicitly; None was not.

    Raises:
        InputError: naming the setting; the paper's own numbers are no conflict.
    """
    if given.get("spacing") != "paper":
        return
    fixed = {"gammas": len(PAPER_GAMMAS), "gamma_min": PAPER_GAMMAS[0], "gamma_max": PAPER_GAMMAS[-1]}
    for name, value in fixed.items():
        if given.get(name) is not None and BY_NAME[name].parse(given[name]) != value:
            raise InputError(
                f"{flag(BY_NAME[name])} cannot be chosen beside --spacing paper, which is these {len(PAPER_GAMMAS)} "
                f"discounts from {PAPER_GAMMAS[0]:g} to {PAPER_GAMMAS[-1]:g}: leave it out, or choose another spacing."
            )


def resolve(settings: Settings, world: World) -> ResolvedForWorld:
    """Fill every None with what suits the world; the result reproduces the study whatever the defaults become.

    Rewards decide the sensitivities (the range plus 20% at each end) and the slope (2.35 / spacing); how long
    a random walk survives decides the steps.
    """
    suggested = dict(world.suggested)
    if settings.spacing is not None or settings.gamma_min is not None or settings.gamma_max is not None:
        for name in ("spacing", "gamma_min", "gamma_max"):  # a suggested grid comes whole or not at all
            suggested.pop(name, None)
    values: dict[str, Any] = {
        parameter.name: suggested.get(parameter.name, parameter.default) if value is None else value
        for parameter in SCHEMA
        for value in [getattr(settings, parameter.name)]
    }
    if values["spacing"] == "paper":
        values |= {"gammas": len(PAPER_GAMMAS), "gamma_min": PAPER_GAMMAS[0], "gamma_max": PAPER_GAMMAS[-1]}
    values["gammas"] = values["gammas"] or 15
    if values["value_gamma"] is None:
        values["value_gamma"] = values["acting_gamma"]
    values["weighting"] = values["weighting"] or _weighting(values)
    if values["slope_share"] != 1.0:
        raise InputError("--slope-share softens the slope of a trained agent; for a world choose --slope.")
    low, high = float(world.reward_values[0]), float(world.reward_values[-1])
    overhang = OVERHANG * ((high - low) or max(1.0, abs(low)))
    values["theta_min"] = _round(low - overhang, overhang) if values["theta_min"] is None else values["theta_min"]
    values["theta_max"] = _round(high + overhang, overhang) if values["theta_max"] is None else values["theta_max"]
    if values["slope"] is None:
        grid = sensitivity_grid(
            values["thetas"], values["theta_min"], values["theta_max"], values["theta_spacing"],
            values["theta_scale"] or None,
        )  # fmt: skip
        spacing = float(np.diff(grid).max())
        gentle, steep = BY_NAME["slope"].bounds
        values["slope"] = float(f"{np.clip(SLOPE_TIMES_SPACING / spacing, gentle, steep):.2g}")
    if values["steps"] is None:
        values["steps"] = _random_walk_length(world)
    if settings.steps is None:  # the same stretch of time, whatever the resolution
        values["steps"] = min(MAX_STEPS, int(np.ceil(values["steps"] / values["time_step"] - 1e-9)))
    values["horizon"] = _nearest_horizon(values)
    source: dict[str, Any] = {"world": world.source or _file_of(settings.world, world), "params": world.params}
    state = int(np.argmax(world.start)) if values["state"] is None else world.state_index(values["state"])
    values["state"] = world.states[state]
    return ResolvedForWorld(**values, **source)


def _file_of(named: str, world: World) -> str:
    """The file that settings name for a world made by hand: not one that stands for another world.

    A name that :func:`laplace_core.load_world` builds a listed world from is not this world's.
    """
    if named.lower().endswith(WORLD_FILES):
        return named
    return f"{re.sub(r'[^A-Za-z0-9_-]+', '_', world.name)[:40].strip('_') or 'world'}.json"


_THETAS = ("thetas", "theta_spacing", "theta_min", "theta_max", "theta_scale")
ENCODING_NAMES = ("gammas", "spacing", "gamma_min", "gamma_max", *_THETAS, "slope", "policy", "clip", "paper_grid")
"""Settings that a gamma-space from a file brings along and that cannot be chosen for it."""


def resolve_for_gamma_space(settings: Settings, gammas: np.ndarray) -> Resolved:
    """Like :func:`resolve` for a gamma-space learned elsewhere: only decoding and reading are left to choose.

    The default length is three time constants of the largest discount, at most 200 steps.

    Raises:
        InputError: a setting that the file itself decides.
    """
    for name in ENCODING_NAMES:
        if getattr(settings, name) is not None:
            raise InputError(f"{flag(BY_NAME[name])} cannot be chosen for a saved gamma-space: the file decides it.")
    if settings.params:
        raise InputError("a saved gamma-space has no parameters: leave out --param.")
    length = int(np.clip(np.ceil(-3.0 / np.log(np.max(gammas))), 3, 200))
    values: dict[str, Any] = {
        parameter.name: parameter.default if value is None else value
        for parameter in SCHEMA
        for value in [getattr(settings, parameter.name)]
        if parameter.name not in ENCODING_NAMES
    }
    if values["value_gamma"] is None:
        values["value_gamma"] = values["acting_gamma"]
    values["weighting"] = values["weighting"] or _weighting(values)
    values["steps"] = settings.steps or min(MAX_STEPS, int(np.ceil(length / (settings.time_step or 1.0))))
    values["horizon"] = _nearest_horizon(values)
    return Resolved(world=settings.world, **values)


def _weighting(values: Mapping[str, Any]) -> str:
    """The weighting that suits a typed alpha, or a rule: most rules take the error of all discounts for equal."""
    is_known = values["noise_level"] is not None or values["noise_levels"] is not None
    return "equal" if values["selector"] in (None, "typed") and not is_known else "deviation"


def _nearest_horizon(values: Mapping[str, Any]) -> float | None:
    """The horizon of the row that is nearest to the chosen one."""
    if values["horizon"] is None:
        return None
    horizons = row_horizons(values["steps"], values["time_step"])
    return float(horizons[np.argmin(np.abs(horizons - values["horizon"]))])


def _round(bound: float, overhang: float) -> float:
    """Six significant digits, for a readable command, unless they would move it by a tenth of the overhang."""
    short = float(f"{bound:.6g}")
    return short if abs(short - bound) <= overhang / 10.0 else bound


def _random_walk_length(world: World, most: int = 200) -> int:
    """Steps until a random walk is still running with a chance below 1e-3, between 3 and ``most``."""
    moves = world.transition_matrix / world.n_actions
    distribution = world.start
    for tau in range(most):
        if distribution.sum() < 1e-3:
            return max(3, tau)
        distribution = np.repeat(distribution, world.n_actions) @ moves
    return most
