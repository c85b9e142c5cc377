"""Settings that were tuned for an algorithm and an environment: one readable JSON file each. No torch here."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from laplace_core.agents.settings import ENVIRONMENTS, SETTINGS, LoopSettings
from laplace_core.errors import InputError
from laplace_core.training.tensor_file import parse_json

FOLDER = Path(__file__).parent / "settings"


def tuned_settings(algorithm: str, environment: str, given: Mapping[str, object] | None = None) -> LoopSettings:
    """The tuned settings, or the defaults where there is no file, with ``given`` over them.

    Raises:
        InputError: an unknown algorithm, environment or setting, or a value out of its range.
    """
    if algorithm not in SETTINGS:
        raise InputError(f"algorithm {str(algorithm)[:40]!r} is not one of {', '.join(SETTINGS)}.")
    if environment not in ENVIRONMENTS:
        raise InputError(f"environment {str(environment)[:40]!r} is none of {', '.join(ENVIRONMENTS)}.")
    path = FOLDER / algorithm / f"{environment}.json"
    tuned = parse_json(path.read_text(encoding="utf-8"), path.name) if path.exists() else {}
    return SETTINGS[algorithm].parse(tuned | {"environment": environment} | dict(given or {}))
