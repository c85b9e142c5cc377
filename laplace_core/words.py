"""Words that several verbs of the command line read or print alike."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from laplace_core.errors import InputError
from laplace_core.pipeline import Study


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
