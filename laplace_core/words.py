"""Words that several verbs of the command line read or print alike."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Sequence

import numpy as np

from laplace_core.errors import InputError
from laplace_core.parameters import Parameter
from laplace_core.pipeline import Study
from laplace_core.settings import flag


def add_parameters(parser: argparse.ArgumentParser, parameters: Iterable[Parameter]) -> None:
    """One option a parameter, its help in one sentence; a truth value may be given as the bare option."""
    for parameter in parameters:
        shown = "" if parameter.default is None else f" (default: {str(parameter.default).lower()})"
        if parameter.type is str:
            shown = shown and f" (default: {parameter.default})"
        choices = f" One of {', '.join(parameter.choices)}." if parameter.choices else ""
        metavar = {int: "N", float: "X", str: "NAME", bool: "true"}[parameter.type]
        text = f"{parameter.help}{choices}{shown}".replace("%", "%%")
        optional = {"nargs": "?", "const": "true"} if parameter.type is bool else {}
        parser.add_argument(flag(parameter), dest=parameter.name, metavar=metavar, help=text, **optional)


def checked_number(name: str, text: object, kind: type, low: float, high: float) -> int | float:
    """An option's number within its range.

    Raises:
        InputError: anything else; the sentence begins with the option's name.
    """
    return Parameter(name, None, low, high, "", kind).parse(text)


def named_params(entries: Sequence[str]) -> dict[str, str]:
    """``--param name=value`` entries by name.

    Raises:
        InputError: another form, or a name given twice.
    """
    params: dict[str, str] = {}
    for entry in entries:
        name, equals, value = entry.partition("=")
        if not equals or not name:
            raise InputError(f"--param {entry[:40]!r} must have the form name=value.")
        if name in params:
            raise InputError(f"--param {name[:40]} is given twice.")
        params[name] = value
    return params


def action_runs(found: Study, actions: np.ndarray) -> str:
    """Actions over the horizon as runs: ``1-2 short, 3 long``."""
    starts = np.flatnonzero(np.diff(actions, prepend=-1))
    ends = np.append(starts[1:], len(actions)) - 1
    parts = []
    for first, last in zip(starts, ends, strict=True):
        until = f"-{found.horizons[last]:g}" if last > first else ""
        parts.append(f"{found.horizons[first]:g}{until} {found.action_names[actions[first]]}")
    return ", ".join(parts[:12]) + (", ..." if len(parts) > 12 else "")
