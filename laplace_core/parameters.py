"""Typed, ranged values from outside: world parameters, command-line options and URL entries."""

from __future__ import annotations

import re
from dataclasses import dataclass

from laplace_core.errors import InputError

NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d{1,4})?", re.ASCII)
"""What is a number wherever one is written: none of Python's other spellings, such as 1_000."""


@dataclass(frozen=True)
class Parameter:
    """A named value with a type, a closed range and one line of help.

    Attributes:
        default: the value if none is given; None means that it depends on the world.
        low, high: the range of an int or float.
        kind: bool, int, float or str; by default the type of ``default``.
        choices: the allowed words of a str; empty for free text.
    """

    name: str
    default: bool | int | float | str | None
    low: float
    high: float
    help: str
    kind: type | None = None
    choices: tuple[str, ...] = ()

    @property
    def type(self) -> type:
        return self.kind or type(self.default)

    def parse(self, value: object) -> bool | int | float | str:
        """The value in the parameter's own type, from text or a number.

        Raises:
            InputError: wrong type or out of range.
        """
        text = str(value)
        if self.type is str and not self.choices:
            return text
        text = text.strip()
        if self.type is str:
            if text not in self.choices:
                raise InputError(f"{self.name} must be one of {', '.join(self.choices)}, not {text[:40]!r}.")
            return text
        if self.type is bool:
            if text.lower() not in ("true", "false", "1", "0"):
                raise InputError(f"{self.name} must be true or false, not {text[:40]!r}.")
            return text.lower() in ("true", "1")
        number = float(text) if NUMBER.fullmatch(text) else float("nan")
        if not self.low <= number <= self.high or (self.type is int and number != int(number)):
            what = "a whole number" if self.type is int else "a number"
            raise InputError(f"{self.name} must be {what} from {self.low:g} to {self.high:g}, not {text[:40]!r}.")
        return self.type(number)


def parse_named(
    owner: str, parameters: tuple[Parameter, ...], given: dict[str, object]
) -> dict[str, bool | int | float | str]:
    """Parse ``given`` against the parameters of ``owner``.

    Raises:
        InputError: a name that is not among them, or a value that does not fit.
    """
    known = {parameter.name: parameter for parameter in parameters}
    for name in given:
        if name not in known:
            listed = ", ".join(known) or "none"
            raise InputError(f"{owner} has no parameter {str(name)[:40]!r}; it has: {listed}.")
    return {name: known[name].parse(value) for name, value in given.items()}


def as_text(value: object) -> str:
    """A value as commands and links write it; :meth:`Parameter.parse` reads it back."""
    if isinstance(value, bool):
        return str(value).lower()
    if not isinstance(value, float):
        return str(value)
    short = f"{value:.12g}"
    return short if float(short) == value else repr(value)
