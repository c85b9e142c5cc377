"""Options, notes and wording that several verbs of the command line share."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Sequence
from typing import Any, TypeVar

import numpy as np

from laplace_core.code.encoding import bin_masses
from laplace_core.errors import InputError
from laplace_core.parameters import Parameter
from laplace_core.study.pipeline import Study, WorldStudy
from laplace_core.study.settings import flag

Number = TypeVar("Number", int, float)


def add_parameters(parser: argparse.ArgumentParser, parameters: Iterable[Parameter]) -> None:
    """One option a parameter, its help in one sentence; a truth value may be given as the bare option."""
    for parameter in parameters:
        default = "" if parameter.default is None else f" (default: {str(parameter.default).lower()})"
        if parameter.type is str:
            default = default and f" (default: {parameter.default})"
        choices = f" One of {', '.join(parameter.choices)}." if parameter.choices else ""
        metavar = {int: "N", float: "X", str: "NAME", bool: "true"}[parameter.type]
        text = f"{parameter.help}{choices}{default}".replace("%", "%%")
        optional: dict[str, Any] = {"nargs": "?", "const": "true"} if parameter.type is bool else {}
        parser.add_argument(flag(parameter), dest=parameter.name, metavar=metavar, help=text, **optional)


def checked_number(name: str, text: object, kind: type[Number], low: float, *, high: float) -> Number:
    """An option's number within its range.

    Raises:
        InputError: anything else; the sentence begins with the option's name.
    """
    return kind(Parameter(name, None, low, high, "", kind).parse(text))


def study_notes(study: Study) -> list[str]:
    """Notes on the world and the sensitivities of a decoded state, a sentence each."""
    if not isinstance(study, WorldStudy):
        return []
    world, notes = study.world, []
    if world.absorbing.any():
        names = [world.states[s] for s in np.flatnonzero(world.absorbing)]
        notes.append(f"the episode ends on entering {_listed(names)}: whatever is done there, only rewards of 0 follow")
    thetas = study.gamma_space.thetas
    outside = world.reward_values[(world.reward_values < thetas[0]) | (world.reward_values > thetas[-1])]
    if outside.size:
        held = bin_masses(outside, thetas, study.settings.slope).sum(axis=-1).max()
        notes.append(
            f"the sensitivities, {thetas[0]:g} to {thetas[-1]:g}, do not reach the "
            f"{'reward' if outside.size == 1 else 'rewards'} {_listed([f'{value:g}' for value in outside])}: "
            f"{'none' if held < 5e-3 else f'at most {held:.0%}'} of that is in tau-space"
        )
    return notes


def _listed(names: Sequence[str], most: int = 6) -> str:
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")


def named_params(entries: Sequence[str], option: str = "--param") -> dict[str, str]:
    """``--param name=value`` entries by name.

    Raises:
        InputError: another form, or a name given twice.
    """
    params: dict[str, str] = {}
    for entry in entries:
        name, equals, value = entry.partition("=")
        if not equals or not name:
            raise InputError(f"{option} {entry[:40]!r} must have the form name=value.")
        if name in params:
            raise InputError(f"{option} {name[:40]} is given twice.")
        params[name] = value
    return params


def action_runs(study: Study, actions: np.ndarray) -> str:
    """Actions over the horizon as runs: ``1-2 short, 3 long``."""
    starts = np.flatnonzero(np.diff(actions, prepend=-1))
    ends = np.append(starts[1:], len(actions)) - 1
    parts = []
    for first, last in zip(starts, ends, strict=True):
        until = f"-{study.horizons[last]:g}" if last > first else ""
        parts.append(f"{study.horizons[first]:g}{until} {study.action_names[actions[first]]}")
    return ", ".join(parts[:12]) + (", ..." if len(parts) > 12 else "")
