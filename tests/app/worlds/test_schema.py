"""Whatever a link says, the page opens: values that hold are kept, all others are noted and left out."""

from __future__ import annotations

import contextlib
import json

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from app.worlds.schema import LINK, OPENING, PIN, VIEW, WORLD, unpinned
from app.worlds.sources import BROUGHT, LEARN, view_of
from laplace_core import InputError
from laplace_core.exchange.links import query_of
from laplace_core.files.packed_text import pack
from laplace_core.payloads.link import PARAM
from laplace_core.study.settings import SCHEMA
from laplace_core.tabular import LEARN_SCHEMA
from laplace_core.worlds.timeline import FIRST_TIMELINE, packed_timeline
from tests.support.malformed_worlds import TEXT

NAMES = [
    *(parameter.name for parameter in (*SCHEMA, *VIEW, *WORLD, PIN)),
    *(LEARN + parameter.name for parameter in LEARN_SCHEMA),
    *(PARAM + name for name in ("length", "slip", "auxiliary", "r1", "", "p.", "width")),
    "l.",
]
_SNIPPETS = [
    *("own", "timeline", "data", "two_branch", "cliff_grid", "learned", "yes", "-1", "0", "1e308", "nan", "9" * 400),
    *("١٢", "<b>", "\x00", "\ud800", "{}", "[]", FIRST_TIMELINE),
    *map(pack, ("{}", "[]", "null", TEXT, '{"world": "own"}', '{"rows": [], "rest": "zero"}')),
]
PACKED = st.text(max_size=60).filter(str.isprintable).map(pack)
WORDS = st.text(max_size=60) | st.sampled_from(_SNIPPETS) | PACKED
JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8), inner, max_size=4),
    max_leaves=12,
)


def assert_holds(query: dict[str, str]) -> None:
    """It is read without an error, every note is short and one line, and what was read says the same again."""
    found, notes = LINK.read(query)
    for note in notes:
        assert len(note) < 600
        assert "\n" not in note
    again, more = LINK.read(query_of(found))
    assert more == []
    assert again == found
    with contextlib.suppress(InputError):  # said on the page; anything else would be a crash
        view_of(found)


@given(st.dictionaries(st.sampled_from(NAMES) | st.text(max_size=12), WORDS, max_size=6))
@example({"world": "own", "own": pack(TEXT), "state": "nope", "steps": "1"})
def test_any_text_in_any_entry_is_read_or_left_out(query):
    assert_holds({name: value.encode("utf-8", "replace").decode() for name, value in query.items()})


def test_each_entry_survives_each_odd_word(subtests):
    for name in [name for name in NAMES if name != "world"]:
        for word in ["", "\x00", "9" * 400, "１", "' OR 1=1", FIRST_TIMELINE[:30], "[" * 3_000]:
            with subtests.test(name, word=word):
                assert_holds({"world": "two_branch", name: word})


@given(JSON)
@example({"rest": "zero", "rows": [["a", 10**400, 1, 1]]})
@example({"rest": "zero", "rows": [["a", 0, 1e308, 1], ["a", 0, -1e308, 1]]})
@example({"rest": "ended", "rows": [["a", 0, True, 1.0]]})
@example({"rest": ["zero"], "rows": [["\ud800", 0, 1, 1]]})
@example({"rest": "zero", "rows": ["abcd", {"a": 1, "b": 2, "c": 3, "d": 4}]})
def test_any_json_in_a_packed_timeline_is_read_or_left_out(told):
    assert_holds({"world": "timeline", "timeline": pack(json.dumps(told))})


ROWS = st.fixed_dictionaries(
    {
        "action": st.sampled_from("ab "),
        "tau": st.integers(-1, 9) | st.floats(),
        "reward": st.floats(),
        "probability": st.floats(-0.1, 1.1),
    }
)


@given(st.lists(ROWS, max_size=5), st.sampled_from(["zero", "ended"]))
def test_any_table_in_a_packed_timeline_is_read_or_left_out(rows, rest):
    assert_holds({"world": "timeline", "timeline": packed_timeline(rows, rest)})


@given(JSON)
@example({"world": "own", "own": pack("{}")})
@example({"pin": pack("{}"), "world": "two_branch"})
@example({"world": "data", "data": "0123456789ab"})
def test_any_json_in_a_pin_is_read_or_left_out(told):
    assert_holds({"world": "two_branch", "pin": pack(json.dumps(told))})


@given(JSON)
def test_any_json_in_a_packed_world_is_read_or_left_out(told):
    assert_holds({"world": "own", "own": pack(json.dumps(told))})


def test_a_link_holds_every_setting_of_the_inverse(subtests):
    for name, word, value in (
        ("solver", "tsvd", "tsvd"), ("selector", "gcv", "gcv"), ("weighting", "deviation", "deviation"),
        ("filter", "savgol", "savgol"), ("noise_level", "0.01", 0.01), ("filter_window", "5", 5),
        ("filter_order", "2", 2),
    ):  # fmt: skip
        with subtests.test(name):
            found, notes = LINK.read({"world": "two_branch", "alpha": "0.3", name: word})
            assert found == {"world": "two_branch", "alpha": 0.3, name: value}
            assert not notes


def test_a_link_to_a_solver_that_is_none_says_so():
    found, notes = LINK.read({"world": "two_branch", "solver": "magic"})
    assert found == {"world": "two_branch"}
    assert "solver" in notes[0]


def test_a_pin_within_a_pin_is_dropped():
    inner = pack(json.dumps({"world": "two_branch", "alpha": "0.5"}))
    assert "pin" not in unpinned(pack(json.dumps({"world": "fig6_chain", "pin": inner})))


def test_a_deep_text_is_refused_and_does_not_overflow():
    deep = pack("[" * 100_000)
    for query in ({"world": "own", "own": deep}, {"world": "timeline", "timeline": deep}, {"pin": deep}):
        found, notes = LINK.read(query)
        assert found.get("world") == "two_branch"
        assert len(notes) == 1


@pytest.mark.parametrize("kind", BROUGHT)
def test_what_was_brought_needs_its_content(kind):
    found, notes = LINK.read({"world": kind})
    assert found == OPENING
    assert len(notes) == 1


def test_a_learned_view_travels_whole():
    query = {"world": "two_branch", "source": "learned", "run": "0123456789", "learner": "1", "l.seeds": "3",
             "l.rate_first": "0.5", "l.starts": "world", "l.peers": "true"}  # fmt: skip
    found, notes = LINK.read(query)
    assert notes == []
    assert query_of(found) == query


@pytest.mark.parametrize(
    ("query", "said"),
    [
        ({"horizon": "60", "steps": "20"}, "horizon 60 lies beyond the end of the timeline, 20"),
        ({"horizon": "11", "steps": "20", "time_step": "0.5"}, "horizon 11 lies beyond the end of the timeline, 10"),
        ({"used": "300", "steps": "20"}, "used 300 lies beyond the end of the timeline, 20"),
        ({"learner": "3", "source": "learned", "l.seeds": "3"}, "learner 3 is not there: 3 learned"),
        ({"learner": "1", "source": "learned"}, "learner 1 is not there: 1 learned"),
    ],
)
def test_a_value_that_could_only_be_clamped_is_named_and_left_out(query, said):
    values, notes = LINK.read({"world": "two_branch", **query})
    (note,) = notes
    assert said in note
    assert next(iter(query)) not in values


def test_the_last_horizon_is_taken():
    values, notes = LINK.read({"world": "two_branch", "horizon": "20", "steps": "20"})
    assert notes == []
    assert values["horizon"] == 20
