"""Settings stand once, as fields of a dataclass, and what reads and writes them follows from there."""

from __future__ import annotations

from dataclasses import dataclass, field, fields, replace

import pytest

from laplace_core import InputError
from laplace_core.agents.settings import LOOP_SCHEMA, SETTINGS
from laplace_core.cli import main
from laplace_core.parameters import (
    Parameter,
    Schema,
    choice,
    from_variables,
    like,
    parse_named,
    schema_of,
    setting,
    switch,
    text,
)
from laplace_core.study.settings import SCHEMA, Resolved, ResolvedForWorld, Settings
from laplace_core.tabular import LEARN_SCHEMA, LearnSettings
from laplace_core.tabular.settings import ResolvedLearning

SCHEMAS = {"settings": SCHEMA, "learning": LEARN_SCHEMA} | {name: kind.SCHEMA for name, kind in SETTINGS.items()}


@dataclass(frozen=True)
class Colours:
    shade: float | None = setting(0.5, 0, 1, "How dark it is.", undecided=True)
    name: str | None = text("What it is called.")
    hue: str = choice("red", ("red", "blue"), "Which one.")
    layers: int = setting(3, 1, 9, "How many.")
    matt: bool = switch("No shine.", default=False)
    made_of: tuple[str, ...] = field(default=())

    SCHEMA = Schema()


@dataclass(frozen=True, kw_only=True)
class Mixed(Colours):
    shade: float
    layers: int = 4
    tint: int | None = like(Colours, "layers")


SHADE = Parameter("shade", 0.5, 0, 1, "How dark it is.", float)
LAYERS = Parameter("layers", 3, 1, 9, "How many.", int)


def test_a_schema_is_what_the_fields_state_in_their_order():
    assert Colours.SCHEMA == schema_of(Colours) == (
        SHADE,
        Parameter("name", None, help="What it is called.", kind=str),
        Parameter("hue", "red", help="Which one.", kind=str, choices=("red", "blue")),
        LAYERS,
        Parameter("matt", False, help="No shine.", kind=bool),
    )  # fmt: skip


def test_what_is_undecided_is_none_until_it_is_chosen():
    assert Colours() == Colours(shade=None, name=None, hue="red", layers=3, matt=False)


def test_a_field_declared_anew_keeps_its_range_and_sentence():
    schema = {parameter.name: parameter for parameter in Mixed.SCHEMA}
    assert schema["shade"] == SHADE
    assert schema["layers"] == replace(LAYERS, default=4)
    assert schema["tint"] == replace(LAYERS, name="tint", default=None)
    assert Colours.SCHEMA[3] == LAYERS


@pytest.mark.parametrize("name", ["name", "hue", "matt"])
def test_what_is_no_number_has_no_range(name):
    parameter = {parameter.name: parameter for parameter in Colours.SCHEMA}[name]
    assert parameter.low is None
    assert parameter.high is None
    with pytest.raises(TypeError, match=name):
        print(parameter.bounds)


def test_every_field_of_the_settings_states_what_it_is(subtests):
    for kind in [*SETTINGS.values(), Settings, LearnSettings]:
        with subtests.test(kind=kind):
            assert [parameter.name for parameter in schema_of(kind)] == [
                each.name for each in fields(kind) if each.name not in ("world", "params")
            ]


def test_settings_that_leave_nothing_open_have_the_same_schema():
    for kind in (Resolved, ResolvedForWorld):
        assert {parameter.name: parameter for parameter in schema_of(kind)} == {each.name: each for each in SCHEMA}
    assert schema_of(ResolvedLearning) == LEARN_SCHEMA


def test_every_default_is_in_its_range_and_has_a_sentence(subtests):
    for name in SCHEMAS:
        with subtests.test(name=name):
            for parameter in SCHEMAS[name]:
                assert parameter.help.endswith(".")
                assert (parameter.low is None) == (parameter.high is None) == (parameter.type in (bool, str))
                if parameter.default is not None:
                    assert type(parameter.default) is parameter.type
                    assert parameter.parse(parameter.default) == parameter.default


def test_settings_of_an_algorithm_are_those_of_all_and_its_own(subtests):
    for algorithm in SETTINGS:
        with subtests.test(algorithm=algorithm):
            kind = SETTINGS[algorithm]
            assert kind.SCHEMA[: len(LOOP_SCHEMA)] == LOOP_SCHEMA
            assert {parameter.name: parameter.default for parameter in kind.SCHEMA} == kind().as_dict()
            assert parse_named(algorithm, kind.SCHEMA, kind().as_dict()) == kind().as_dict()


def test_a_value_out_of_its_range_is_refused_when_the_settings_are_built(subtests):
    for kind in [*SETTINGS.values(), Settings, LearnSettings]:
        with subtests.test(kind=kind):
            for parameter in schema_of(kind):
                bad: tuple[object, ...] = ("no such word",) if parameter.choices else ("perhaps", 2)
                if parameter.type in (int, float):
                    bad = (parameter.bounds[0] - 1, parameter.bounds[1] * 2 + 1, float("nan"), "x")
                if parameter.type is str and not parameter.choices:
                    continue
                for value in bad:
                    with pytest.raises(InputError, match=f"^{parameter.name} must be"):
                        kind(**{parameter.name: value})


def test_a_worlds_switches_keep_their_ends_in_the_list_of_worlds(capsys):
    main(["worlds", "--json"])
    assert '"name": "auxiliary",\n     "default": false,\n     "low": 0,\n     "high": 1,' in capsys.readouterr().out


@dataclass(frozen=True)
class OfProcess:
    places: int = setting(2, 1, 9, "Places.")
    quiet: bool = switch("Whether nothing is said.", default=False)


def test_variables_of_the_process_state_settings():
    assert from_variables(OfProcess, {}, "LINE_") == {}
    assert from_variables(OfProcess, {"LINE_PLACES": "3", "LINE_QUIET": " ", "places": "4"}, "LINE_") == {"places": 3}
    with pytest.raises(InputError, match=r"^environment variable LINE_PLACES: places must be a whole number"):
        from_variables(OfProcess, {"LINE_PLACES": "ten"}, "LINE_")
