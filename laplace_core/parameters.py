"""Typed, ranged values from outside: world parameters, command-line options and URL entries.

A dataclass of settings states each of them once, as a field made by :func:`setting`, :func:`choice`, :func:`switch` or
:func:`text`; :func:`schema_of` reads from it the parameters that the command line, links, forms and files go by.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import Field, dataclass, field, fields, replace
from functools import cache
from math import inf
from typing import Any, get_args, get_type_hints

from laplace_core.errors import InputError

NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d{1,4})?", re.ASCII)
"""What is a number wherever one is written: none of Python's other spellings, such as 1_000."""


@dataclass(frozen=True)
class Parameter:
    """A named value with a type, one line of help and, where it is a number, a closed range.

    Attributes:
        default: the value if none is given; None means that it depends on the world.
        low, high: the range of an int or float; None for other types.
        kind: bool, int, float or str; by default the type of ``default``.
        choices: the allowed words of a str; empty for free text.
        check: refuses a free text by raising an InputError.
    """

    name: str
    default: bool | int | float | str | None
    low: float | None = None
    high: float | None = None
    help: str = ""
    kind: type | None = None
    choices: tuple[str, ...] = ()
    check: Callable[[str], object] | None = None

    @property
    def type(self) -> type:
        return self.kind or type(self.default)

    @property
    def bounds(self) -> tuple[float, float]:
        """The range of a number.

        Raises:
            TypeError: a parameter that is no number.
        """
        if self.low is None or self.high is None:
            raise TypeError(f"{self.name} has no range.")
        return self.low, self.high

    def _holds(self, number: float) -> bool:
        """Whether a number of the right type needs no further look."""
        return self.type is bool or (self.bounds[0] <= number <= self.bounds[1] and abs(number) < inf)

    def parse(self, value: object) -> bool | int | float | str:
        """The value in the parameter's own type, from text or a number.

        Raises:
            InputError: wrong type or out of range.
        """
        if isinstance(value, bool | int | float) and type(value) is self.type and self._holds(value):
            return value  # as most do: settings are made of settings
        text = str(value)
        if self.type is str and not self.choices:
            if self.check is not None:
                self.check(text)
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
        low, high = self.bounds
        if not low <= number <= high or (self.type is int and number != int(number)):
            what = "a whole number" if self.type is int else "a number"
            raise InputError(f"{self.name} must be {what} from {low:g} to {high:g}, not {text[:40]!r}.")
        return self.type(number)


_STATED = "parameter"  # where a field's metadata hold its parameter, without a name and a kind


def _stated(parameter: Parameter, *, undecided: bool = False) -> Any:
    """A field of a dataclass; Any, as :func:`dataclasses.field` is, so that the annotation decides its type."""
    return field(default=None if undecided else parameter.default, metadata={_STATED: parameter})


def setting(default: float | None, low: float, high: float, sentence: str, *, undecided: bool = False) -> Any:
    """A number as a field of a dataclass of settings; its annotation, int or float, is its type.

    Args:
        default: what holds if nothing is given; None means that it depends on the world.
        low, high: the closed range.
        sentence: what it is, as help and forms say it.
        undecided: the field is None until it is chosen, and ``default`` is what then fits.
    """
    return _stated(Parameter("", default, low, high, sentence), undecided=undecided)


def choice(default: str | None, options: tuple[str, ...], sentence: str, *, undecided: bool = False) -> Any:
    """Like :func:`setting`, for one of a few words."""
    return _stated(Parameter("", default, help=sentence, choices=options), undecided=undecided)


def switch(sentence: str, *, default: bool, undecided: bool = False) -> Any:
    """Like :func:`setting`, for what is either on or off."""
    return _stated(Parameter("", default, help=sentence), undecided=undecided)


def text(sentence: str, check: Callable[[str], object] | None = None) -> Any:
    """Like :func:`setting`, for a text, None until it is chosen.

    Args:
        check: refuses a text by raising an InputError; default: any text will do.
    """
    return _stated(Parameter("", None, help=sentence, check=check))


def like(owner: type, name: str) -> Any:
    """The setting ``name`` of another dataclass once more; None until it is chosen, without a default of its own."""
    known = {parameter.name: parameter for parameter in schema_of(owner)}
    return _stated(replace(known[name], default=None))


@cache
def schema_of(owner: type) -> tuple[Parameter, ...]:
    """The parameters that a dataclass of settings states, in the order of its fields.

    A class that only declares a field again, say without None, has its range and sentence from the class that states
    it. A field that states nothing is no setting.
    """
    hints = get_type_hints(owner)
    parameters = []
    for each in fields(owner):
        stated = _stated_in(owner, each)
        if stated is not None:
            default: Any = stated.default if each.default is None else each.default
            parameters.append(replace(stated, name=each.name, kind=_kind(hints[each.name]), default=default))
    return tuple(parameters)


def _stated_in(owner: type, each: Field[Any]) -> Parameter | None:
    for kind in owner.__mro__:
        declared = vars(kind).get("__dataclass_fields__", {}).get(each.name)
        if declared is not None and _STATED in declared.metadata:
            stated: Parameter = declared.metadata[_STATED]
            return stated
    return None


def _kind(hint: Any) -> type:
    """``int`` of ``int`` and of ``int | None``."""
    kind: type = next((each for each in get_args(hint) if each is not type(None)), hint)
    return kind


class Schema:
    """The parameters of a class of settings as its attribute, which so is always that of the class it is asked of."""

    def __get__(self, instance: object, owner: type) -> tuple[Parameter, ...]:
        return schema_of(owner)


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


def from_variables(owner: type, variables: Mapping[str, str], prefix: str) -> dict[str, Any]:
    """Settings of a dataclass, by name, that variables of the process state.

    Args:
        prefix: the name of a variable is this and then the name of the setting, in capitals.

    Raises:
        InputError: a value out of range, naming the variable.
    """
    given: dict[str, Any] = {}
    for parameter in schema_of(owner):
        variable = prefix + parameter.name.upper()
        if variables.get(variable, "").strip():
            try:
                given[parameter.name] = parameter.parse(variables[variable])
            except InputError as error:
                raise InputError(f"environment variable {variable}: {error}") from None
    return given


def as_text(value: object) -> str:
    """A value as commands and links write it; :meth:`Parameter.parse` reads it back."""
    if isinstance(value, bool):
        return str(value).lower()
    if not isinstance(value, float):
        return str(value)
    short = f"{value:.12g}"
    return short if float(short) == value else repr(value)
