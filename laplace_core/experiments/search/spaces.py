"""The values that a search may give to settings: lists and ranges, written as text.

``batch=64,128`` is a list, ``averaging=0.001..0.05`` a range, and ``learning_rate=0.0001..0.01:log`` a range in which
equal ratios are equally likely.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from laplace_core.agents.settings import SETTINGS
from laplace_core.errors import InputError
from laplace_core.parameters import Parameter, as_text

if TYPE_CHECKING:
    from optuna import Trial

Value = bool | int | float | str


@dataclass(frozen=True)
class Choices:
    """A few values, each as likely as the others."""

    values: tuple[Value, ...]

    def suggested(self, trial: Trial, name: str) -> Value:
        """The value that a trial is given."""
        value: Value = trial.suggest_categorical(name, self.values)  # type: ignore[assignment]  # none of them is None
        return value

    def beside(self, value: Value) -> Choices:
        """The same with a value that comes first."""
        return Choices(tuple(dict.fromkeys([value, *self.values])))

    def __str__(self) -> str:
        return ",".join(map(as_text, self.values))


@dataclass(frozen=True)
class Range:
    """All numbers from ``low`` to ``high``, both included; whole ones where both are of type int."""

    low: float
    high: float
    log: bool = False

    def suggested(self, trial: Trial, name: str) -> Value:
        """The value that a trial is given."""
        if isinstance(self.low, int) and isinstance(self.high, int):
            return trial.suggest_int(name, self.low, self.high, log=self.log)
        return trial.suggest_float(name, self.low, self.high, log=self.log)

    def beside(self, value: Value) -> Range:
        """The same: a range gets no single value."""
        return self

    def __str__(self) -> str:
        return f"{as_text(self.low)}..{as_text(self.high)}{':log' if self.log else ''}"


Dimension = Choices | Range
Space = Mapping[str, Dimension]
"""The dimension of every setting that is varied, by its name."""

# The paper names what it searched and the values that it found (appendix C), and no ranges. These hold each of those
# values. Its ranges of reward and of return depend on the environment: they stay as in our settings files.
PAPER: dict[str, dict[str, str]] = {
    "qrdqn": {
        "batch": "32,64,128,256", "buffer": "10000..200000:log", "epsilon_final": "0.01..0.2",
        "exploration": "0.05..0.5",
    },
    "c51": {
        "batch": "32,64,128,256", "learning_rate": "0.0001..0.01:log", "atoms": "21..101",
        "learning_starts": "32..5000:log", "update_every": "1,2,4,8,16",
    },
    "laplace": {
        "thetas": "25..500:log", "slope_times_spacing": "0.5..15:log", "gammas": "2..15",
        "learning_rate": "0.0001..0.01:log",
    },
}  # fmt: skip
_OURS = {
    "learning_rate": "0.0001..0.01:log", "averaging": "0.001..0.05:log", "n_step": "1..5", "batch": "32,64,128,256",
    "exploration": "0.05..0.4",
}  # fmt: skip
_OURS_LAPLACE = {
    "consistency": "0..2", "consistency_exponent": "0..1", "acting_share": "0..0.6", "head_exploration": "0..0.3",
    "slope_times_spacing": "1.5..6:log",
}  # fmt: skip
OURS: dict[str, dict[str, str]] = {name: _OURS | (_OURS_LAPLACE if name == "laplace" else {}) for name in SETTINGS}
SPACES = {"paper": PAPER, "ours": OURS}
"""Named spaces: of each algorithm, the dimension of every setting as text."""


def named_space(name: str, algorithm: str) -> dict[str, str]:
    """The dimensions of a named space as text.

    Raises:
        InputError: no space of this name, or none for this algorithm.
    """
    if name not in SPACES:
        raise InputError(f"the space must be one of {', '.join(SPACES)}, not {name[:40]!r}.")
    if algorithm not in SPACES[name]:
        raise InputError(f"the space {name!r} is of {', '.join(SPACES[name])}: name the settings with --vary.")
    return SPACES[name][algorithm]


def parsed(parameter: Parameter, text: str) -> Dimension:
    """A dimension of a setting from text.

    Raises:
        InputError: values that the setting cannot have, or a range that is none; the sentence names the setting.
    """
    if ".." not in text:
        values = tuple(parameter.parse(value) for value in text.split(","))
        if len(set(values)) < len(values):
            raise InputError(f"--vary {parameter.name}={text[:60]} has the same value twice: leave one out.")
        return Choices(values)
    ends, colon, scale = text.partition(":")
    first, _, last = ends.partition("..")
    if colon and scale != "log":
        raise InputError(f"--vary {parameter.name}={text[:60]}: only :log may follow a range.")
    if parameter.type not in (int, float):
        raise InputError(f"{parameter.name} is no number: list its values, as in {parameter.name}=A,B.")
    low, high = parameter.parse(first), parameter.parse(last)
    assert isinstance(low, int | float)
    assert isinstance(high, int | float)
    if not -inf < low < high < inf:
        raise InputError(f"--vary {parameter.name}={text[:60]} must go from a smaller number to a larger one.")
    if colon and low <= 0:
        raise InputError(f"--vary {parameter.name}={text[:60]}: a range on a log scale begins above 0.")
    return Range(low, high, log=bool(colon))


def space_of(algorithm: str, texts: Mapping[str, str]) -> Space:
    """The dimensions of a search from their texts.

    Raises:
        InputError: a setting that the algorithm does not have, or a dimension that does not fit it.
    """
    known = {parameter.name: parameter for parameter in SETTINGS[algorithm].SCHEMA}
    unknown = next((name for name in texts if name not in known), None)
    if unknown is not None:
        SETTINGS[algorithm].parse({unknown: ""})  # refuses it, and names the nearest
    return {name: parsed(known[name], text) for name, text in texts.items()}


def is_listed(space: Space) -> bool:
    """Whether every dimension is a list, so that there are finitely many combinations."""
    return all(isinstance(dimension, Choices) for dimension in space.values())


def values_of(space: Space) -> dict[str, Sequence[Value]]:
    """The values of every list of a space; those of ranges are not among them."""
    return {name: each.values for name, each in space.items() if isinstance(each, Choices)}
