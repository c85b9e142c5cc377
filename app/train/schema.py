"""The state of the page Train: from a link to the settings of a run, and to the run that is shown."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from laplace_core import InputError
from laplace_core.agents.settings import ENVIRONMENTS, SETTINGS, LoopSettings
from laplace_core.exchange.links import Check, Entries, Schema, Values, by_name
from laplace_core.parameters import Parameter
from laplace_core.training.defaults import suited_settings, with_looks
from laplace_core.training.run_folder import RUN_NAME

TRAIN = "t."
"""Prefix of settings of a run, in the session and in the URL."""
OPENING = {"algorithm": "laplace", "environment": "CartPole-v1"}
MOST_AT_ONCE = 8
NOTHING = "none"
"""In a link, in the place of the runs that are drawn beside the one that is looked at."""

FORM = (
    Parameter("algorithm", OPENING["algorithm"], help="Algorithm that learns.", kind=str, choices=tuple(SETTINGS)),
    Parameter("environment", OPENING["environment"], help="Environment to learn.", kind=str, choices=ENVIRONMENTS),
    Parameter("count", 1, 1, MOST_AT_ONCE, "Runs to start; each has the next seed."),
    Parameter("run", None, help="The run that is shown.", kind=str),
    Parameter("beside", None, help="Names of the runs that are drawn with it.", kind=str),
    Parameter("ships", None, help="Algorithms whose bundled agents are drawn behind it.", kind=str),
)


def suited(values: Mapping[str, Any]) -> LoopSettings:
    """The settings when nothing is set by hand."""
    return suited_settings(_word("algorithm", values), _word("environment", values))


def wanted(values: Mapping[str, Any]) -> LoopSettings:
    """The settings of a run.

    Raises:
        InputError: values that do not fit each other.
    """
    given = {name.removeprefix(TRAIN): value for name, value in values.items() if name.startswith(TRAIN)}
    return with_looks(suited(values), given)


def _word(name: str, values: Mapping[str, Any]) -> str:
    return str(values.get(name, OPENING[name]))


def _names_runs(entry: str) -> Check:
    def test(values: Values) -> None:
        if not all(RUN_NAME.fullmatch(word) for word in names_in(values.get(entry))):
            raise InputError(f"{entry} is not the name of a run.")

    return Check(test, drops=(entry,))


def _names_algorithms(values: Values) -> None:
    if not all(word in SETTINGS for word in names_in(values.get("ships"))):
        raise InputError("ships is not the name of an algorithm.")


def _settings(values: Values) -> dict[str, Parameter]:
    """The settings that the algorithm and environment have."""
    return by_name(*(each for each in SETTINGS[_word("algorithm", values)].SCHEMA if each.name != "environment"))


LINK = Schema(
    opening=dict,
    steps=(
        Entries(by_name(*FORM)),
        _names_runs("run"),
        _names_runs("beside"),
        Check(_names_algorithms, drops=("ships",)),
        Entries(_settings, prefix=TRAIN),
    ),
)


def names_in(word: object) -> list[str]:
    """Names of runs or algorithms, as the link joins them."""
    return [] if word in (None, NOTHING) else str(word).split(",")[:MOST_AT_ONCE]
