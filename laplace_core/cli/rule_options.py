"""Options of the rules of control, for the verbs that let an agent act by one."""

from __future__ import annotations

import argparse
from typing import Any

from laplace_core.cli.options import checked_number
from laplace_core.errors import InputError
from laplace_core.inverse import ALPHA_CHOICES, SOLVERS

_NUMBERS = (("softness", 0.0, 10.0), ("alpha", 1e-9, 1e6), ("stretch", 1e-2, 100.0), ("noise_level", 1e-12, 1.0))


def add_rule_options(parser: argparse.ArgumentParser) -> None:
    """One option for each option of a rule."""
    parser.add_argument(
        "--softness",
        metavar="W",
        help="of readout and decoded: width of the deadline over the time to go (default: .2)",
    )
    parser.add_argument(
        "--alpha", metavar="A",
        help="of readout and decoded: regularisation (default: 1); of decoded also auto or a rule that chooses it for "
        "every observation",
    )  # fmt: skip
    parser.add_argument(
        "--solver", metavar="NAME", help="of decoded: how the transform is inverted (default: tikhonov)"
    )
    parser.add_argument(
        "--noise-level", metavar="S", help="of decoded and certified: standard deviation of (1 - gamma) Q"
    )
    parser.add_argument("--stretch", metavar="C", help="of fading: its time constant / the time to go (default: 1.5)")


def rule_options(options: argparse.Namespace) -> dict[str, Any]:
    """Those that were given, by their names in :class:`laplace_core.acting.rules.Options`.

    Raises:
        InputError: a number out of range, or a solver or a choice of alpha that does not exist.
    """
    by_name = options.alpha in ALPHA_CHOICES
    given: dict[str, Any] = {
        name: checked_number(name, getattr(options, name), float, low, high=high)
        for name, low, high in _NUMBERS
        if getattr(options, name) is not None and not (name == "alpha" and by_name)
    }
    if by_name:
        given["selector"] = options.alpha
    if options.solver is not None:
        if options.solver not in SOLVERS:
            raise InputError(f"solver must be one of {', '.join(SOLVERS)}, not {options.solver[:40]!r}.")
        given["solver"] = options.solver
    return given
