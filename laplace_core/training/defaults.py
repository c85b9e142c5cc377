"""The settings of a run: those that suit an algorithm and an environment, from readable files beside this module, with
those that were given in their place; and the command and the folder's name that stand for them."""

from __future__ import annotations

from functools import lru_cache
from importlib import resources
from typing import Any

from laplace_core.agents.settings import LOOP_SCHEMA, SETTINGS, LoopSettings
from laplace_core.environments import ENVIRONMENTS, GYMNASIUM
from laplace_core.errors import InputError
from laplace_core.files.strict_json import parse_json
from laplace_core.parameters import Parameter, as_text
from laplace_core.study.settings import flag

LOOKS = 20
"""Evaluations in a run that somebody looks at, at least: a curve of fewer points says little."""
_SHOWN_OWN = 8  # settings that only one algorithm has, the grids first: what a run is about
_SHOWN_LOOP = ("steps", "learning_rate")


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
    """The default name of the folder of a run."""
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


@lru_cache(maxsize=256)
def suited_settings(algorithm: str, environment: str) -> LoopSettings:
    """The same with nothing given.

    Raises:
        InputError: as of :func:`settings_of`.
    """
    return settings_of(algorithm, environment, {})


def with_looks(usual: LoopSettings, given: dict[str, Any]) -> LoopSettings:
    """Other settings in the place of some, with at least :data:`LOOKS` evaluations where nothing is said of them.

    Raises:
        InputError: values that do not fit each other.
    """
    steps = int(given.get("steps", usual.steps))
    often = {"evaluate_every": min(usual.evaluate_every, max(1, steps // LOOKS))}
    return usual.parse(usual.as_dict() | often | given)


def changed(settings: LoopSettings) -> list[str]:
    """The settings that differ from the recommended ones, in words; nothing if those cannot be read."""
    try:
        usual = suited_settings(settings.ALGORITHM, settings.environment)
    except InputError:
        return []
    words = []
    for name in (p.name for p in settings.SCHEMA if p.name not in ("seed", "evaluate_every")):
        value = getattr(settings, name)
        if value != getattr(usual, name):
            words.append(f"{name} {value:g}" if isinstance(value, float) else f"{name} {value}")
    return words


def fields(algorithm: str) -> tuple[list[Parameter], list[Parameter]]:
    """The settings of an algorithm: the handful that matter, and all others; seed and environment in neither."""
    schema = [p for p in SETTINGS[algorithm].SCHEMA if p.name not in ("environment", "seed")]
    common = {parameter.name for parameter in LOOP_SCHEMA}
    own = [parameter for parameter in schema if parameter.name not in common]
    first = [p for p in schema if p.name in _SHOWN_LOOP] + own[:_SHOWN_OWN]
    return first, [*own[_SHOWN_OWN:], *(p for p in schema if p.name in common and p.name not in _SHOWN_LOOP)]
