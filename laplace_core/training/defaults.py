"""The settings of a run: those that suit an algorithm and an environment, from readable files beside this module, with
those that were given in their place; and the command and the folder's name that stand for them."""

from __future__ import annotations

from importlib import resources
from typing import Any

from laplace_core.agents.settings import SETTINGS, LoopSettings
from laplace_core.environments import ENVIRONMENTS, GYMNASIUM
from laplace_core.errors import InputError
from laplace_core.files.strict_json import parse_json
from laplace_core.parameters import as_text
from laplace_core.study.settings import flag


def tuned_settings(algorithm: str, environment: str) -> dict[str, Any]:
    """Settings in the file of this pair, by name; empty if there is no file.

    Raises:
        InputError: a file that holds no JSON object.
    """
    file = resources.files("laplace_core.training") / "settings" / algorithm / f"{environment}.json"
    name = f"the file of settings {algorithm}/{environment}.json"
    settings = parse_json(file.read_bytes(), name) if file.is_file() else {}
    if not isinstance(settings, dict):
        raise InputError(f"{name} must hold one JSON object: take it from the package again.")
    return settings


def name_of(settings: LoopSettings) -> str:
    """What the folder of a run is called by default."""
    return f"{settings.ALGORITHM}_{settings.environment.replace(':', '-')}_{settings.seed}"


def command_of(settings: LoopSettings, folder: str) -> list[str]:
    """The words after ``laplace`` that train with these settings: only those that differ from its files' settings."""
    usual = settings_of(settings.ALGORITHM, settings.environment, {}).as_dict()
    words = ["train", settings.ALGORITHM, settings.environment]
    for parameter in settings.SCHEMA:
        value = getattr(settings, parameter.name)
        if value != usual[parameter.name] and parameter.name not in settings.ignored():
            words += [flag(parameter), as_text(value)]
    return [*words, "--run", folder]


def settings_of(algorithm: str | None, environment: str | None, given: dict[str, Any]) -> LoopSettings:
    """Settings for an algorithm and environment: its file's, with those given in their place.

    Raises:
        InputError: an unknown algorithm, environment or setting, a value out of its range, or a given setting that
            changes nothing beside the others.
    """
    if algorithm not in SETTINGS:
        raise InputError(f"the algorithm must be one of {', '.join(SETTINGS)}, not {str(algorithm)[:40]!r}.")
    if environment not in ENVIRONMENTS:
        raise InputError(f"the environment must be one of {', '.join(ENVIRONMENTS)}, not {str(environment)[:40]!r}.")
    if given.get("environment", environment) != environment:
        raise InputError("the environment is named once, behind the algorithm: it is no setting besides.")
    kind = SETTINGS[algorithm]
    suits = tuned_settings(algorithm, environment)
    if not suits and environment not in GYMNASIUM:
        suits = kind.suited_to(environment)
    settings = kind.parse(suits | given | {"environment": environment})
    for name, reason in settings.ignored().items():
        if name in given:
            raise InputError(f"{name} changes nothing {reason}: leave it out.")
    return settings
