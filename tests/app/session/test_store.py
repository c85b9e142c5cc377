"""The URL of the app: what it keeps, what it refuses, and that a link reproduces the view."""

from __future__ import annotations

from app.worlds.schema import LINK, OPENING
from app.worlds.sources import WORLDS
from laplace_core.study.settings import BY_NAME, SCHEMA


def test_a_good_link_is_read_in_full():
    query = {
        "world": "two_branch",
        "p.length": "5",
        "p.auxiliary": "true",
        "alpha": "0.05",
        "normalise": "paper",
        "state": "long 2",
        "action": "long",
        "horizon": "4",
        "look": "surface",
    }
    found, notes = LINK.read(query)
    assert notes == []
    assert found == {
        "world": "two_branch",
        "p.length": 5,
        "p.auxiliary": True,
        "alpha": 0.05,
        "normalise": "paper",
        "state": "long 2",
        "action": "long",
        "horizon": 4.0,
        "look": "surface",
    }


_BAD_WORDS = [
    "",
    "abc",
    "nan",
    "inf",
    "-inf",
    "1e999",
    "--1",
    "0x10",
    "1,5",
    "None",
    "[1]",
    "<b>1</b>",
    "１２",
    "9" * 400,
]
_BAD_VALUES = [
    (parameter.name, word) for parameter in SCHEMA if parameter.name != "state" for word in _BAD_WORDS
    if not (parameter.type is float and word == "１２") and not (parameter.type is int and word == "１２")
]  # fmt: skip
_OUT_OF_RANGE = [
    (parameter.name, f"{value}")
    for parameter in SCHEMA
    if parameter.type in (int, float)
    for value in (parameter.bounds[0] - 1, parameter.bounds[1] * 2 + 1)
]
_FRACTIONS = [(parameter.name, "2.5") for parameter in SCHEMA if parameter.type is int]
_ODD = [("p.length", "2.5"), ("p.length", "0"), ("p.slip", "0.7"), ("p.auxiliary", "perhaps"), ("p.nope", "1"),
        ("p.", "1"), ("state", "no such state"), ("action", "sideways"), ("horizon", "0"), ("look", "hologram"),
        ("unheard_of", "1"), ("__proto__", "1"), ("state", "7")]  # fmt: skip


def test_a_bad_value_is_left_out_and_noted(subtests):
    for name, word in _BAD_VALUES + _OUT_OF_RANGE + _FRACTIONS + _ODD:
        with subtests.test(name, word=word):
            found, notes = LINK.read({"world": "two_branch", name: word})
            assert found == {"world": "two_branch"}
            assert len(notes) == 1
            assert len(notes[0]) < 300
            assert "\n" not in notes[0]
            bare = name.removeprefix("p.")
            assert bare in notes[0] or name in notes[0]


def test_only_listed_worlds_open_by_link(subtests):
    for world in ["", "nope", "../../etc/passwd", "gym:Ant-v5", "world.json", "gym:", "data.npz"]:
        with subtests.test(world=world):
            found, notes = LINK.read({"world": world, "alpha": "1"})
            assert found == OPENING
            assert len(notes) == 1


def test_bounds_that_contradict_each_other_are_left_out_and_noted():
    query = {"gamma_min": "0.9", "gamma_max": "0.5", "alpha": "0.3"}
    found, notes = LINK.read({"world": "two_branch", **query})
    assert found == {"world": "two_branch", "alpha": 0.3}
    assert "gamma-min" in notes[0]


def test_a_world_that_its_parameters_make_too_large_is_noted():
    found, notes = LINK.read({"world": "cliff_grid", "p.width": "200", "p.height": "200"})
    assert found == {"world": "cliff_grid"}
    assert "5,000" in notes[0]


def test_good_values_survive_beside_bad_ones():
    found, notes = LINK.read({"alpha": "0.5", "steps": "-3"})
    assert found == {"world": OPENING["world"], "alpha": 0.5}
    assert len(notes) == 1


def test_every_setting_can_travel_in_a_link():
    assert set(BY_NAME) == {parameter.name for parameter in SCHEMA}
    assert "two_branch" in WORLDS
    assert "gym:Taxi-v4" in WORLDS
