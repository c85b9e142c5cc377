"""One reader for the links of all pages: steps in their order, what depends on what, and what a note says."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.agents.schema import LINK as AGENTS
from app.race.schema import LINK as RACE
from app.train.schema import LINK as TRAIN
from app.worlds.schema import LINK as WORLDS
from laplace_core import InputError
from laplace_core.exchange.links import LEFT_OUT, LONGEST, Check, Entries, Old, Schema, Values, by_name, fits, query_of
from laplace_core.parameters import Parameter
from tests.support.train_page import made

APP = Path(__file__).resolve().parents[3] / "app"
LIBRARY = APP.parent / "laplace_core"
SHELVES = {"low": 2, "high": 5}


def _is_a_shelf(values: Values) -> None:
    if values["shelf"] not in SHELVES:
        raise InputError(f"there is no shelf {values['shelf']!r}.")


def _fits(values: Values) -> None:
    if values.get("b.width", 0) * values.get("books", 0) > 10:
        raise InputError("the books are too wide.")


def _boards(values: Values) -> dict[str, Parameter]:
    return {str(i): Parameter(f"board {i}", 0, 0, 9) for i in range(SHELVES[values["shelf"]])}


LINK = Schema(
    opening=lambda: {"shelf": "low", "books": 3},
    assumed=lambda: {"shelf": "low"},
    old=(Old("full", "books", {"yes": "10", "no": "0"}), Old("dust", None)),
    steps=(
        Entries(by_name(Parameter("shelf", "low", kind=str))),
        Check(_is_a_shelf),
        Entries(_boards, prefix="o."),
        Entries(by_name(Parameter("books", 3, 0, 10))),
        Entries(by_name(Parameter("width", 1, 0, 9)), prefix="b.", owner=lambda values: values["shelf"]),
        Check(_fits, drops=("b.*",)),
    ),
)


def test_a_link_that_holds_is_read_in_its_own_order_and_written_again():
    link = {"b.width": "2", "shelf": "high", "o.4": "7", "books": "5"}
    values, notes = LINK.read(link)
    assert values == {"b.width": 2, "shelf": "high", "o.4": 7, "books": 5}
    assert list(values) == list(link)
    assert notes == []
    assert query_of(values) == link


def test_what_there_is_depends_on_what_was_read_before():
    values, notes = LINK.read({"o.4": "7"})
    assert values == {"shelf": "low"}
    assert notes == ["The link has an entry 'o.4' that this page does not know."]


def test_a_single_entry_that_does_not_hold_is_left_out_with_one_sentence(subtests):
    for link, note in [
        ({"books": "11"}, f"{LEFT_OUT}books must be a whole number from 0 to 10, not '11'."),
        ({"o.0": "x"}, f"{LEFT_OUT}board 0 must be a whole number from 0 to 9, not 'x'."),
        ({"b.height": "1"}, f"{LEFT_OUT}low has no parameter 'height'; it has: width."),
        ({"n" * 90: "1"}, f"The link has an entry '{'n' * 40}' that this page does not know."),
        ({"o.": "1"}, "The link has an entry 'o.' that this page does not know."),
    ]:
        with subtests.test(link=link, note=note):
            assert LINK.read({**link, "b.width": "2"}) == ({"shelf": "low", "b.width": 2}, [note])


def test_a_check_leaves_out_what_it_names():
    values, notes = LINK.read({"books": "6", "b.width": "2"})
    assert values == {"shelf": "low", "books": 6}
    assert notes == [f"{LEFT_OUT}the books are too wide."]


def test_what_is_known_by_then_is_said_of_a_link_that_is_given_up():
    def _never(values: Values) -> None:
        raise InputError("it is late.")

    link = Schema(LINK.opening, (*LINK.steps, Check(_never, lead="")))
    assert link.read({"nonsense": "1", "books": "x"}) == (
        LINK.opening(),
        [
            f"{LEFT_OUT}books must be a whole number from 0 to 10, not 'x'.",
            "The link has an entry 'nonsense' that this page does not know.",
            "it is late.",
        ],
    )


def test_a_check_that_drops_nothing_gives_up_the_link():
    values, notes = LINK.read({"shelf": "none", "books": "5", "nonsense": "1"})
    assert values == LINK.opening()
    assert notes == [f"{LEFT_OUT}there is no shelf 'none'."]


@pytest.mark.parametrize(
    ("link", "books"),
    [({"full": "yes"}, 10), ({"full": "7"}, 7), ({"full": "no", "books": "4"}, 4), ({"books": "4", "full": "no"}, 4)],
)
def test_an_older_version_is_understood(link, books):
    assert LINK.read({**link, "dust": "thick"}) == ({"shelf": "low", "books": books}, [])


def test_the_sentence_stands_in_one_place():
    files = (path for package in (APP, LIBRARY) for path in package.rglob("*.py"))
    assert [path.name for path in files if LEFT_OUT in path.read_text(encoding="utf-8")] == ["links.py"]


def test_a_rival_that_cannot_be_opened_is_left_out(runs):
    """A run of the same environment is a rival by its settings; its checkpoint is read when it is asked for."""
    made(runs, "one", checkpoint=True)
    folder = made(runs, "two", checkpoint=True)
    link = {"checkpoint": "run:one", "d.against": "run:two"}
    assert RACE.read(link) == (link, [])
    (folder / "best.safetensors").write_bytes(b"")
    values, notes = RACE.read(link)
    assert values == {"checkpoint": "run:one"}
    assert len(notes) == 1
    assert notes[0].startswith(LEFT_OUT)


WORDS = st.text(max_size=20) | st.sampled_from(
    ["-1", "0", "1", "2.5", "nan", "yes", "9" * 400, "run:x", "../x", "none"]
)
NAMES = [
    *("checkpoint", "state", "action", "alpha", "added", "look", "o.0", "o.3", "o.99", "o.", "world", "pin"),
    *("r.shown", "r.seed", "r.rule", "r.horizon", "r.gamma", "r.at", "r.after", "r.action"),
    *("d.against", "d.T", "d.start", "d.left", "d.gamma", "d.right", "d.at", "d.many", "d.starts"),
    *("algorithm", "environment", "count", "run", "beside", "ships", "t.steps", "t.gammas", "t.seed", "t.", "t.nope"),
]


@pytest.mark.parametrize("schema", [WORLDS, AGENTS, RACE, TRAIN])
@given(link=st.dictionaries(st.sampled_from(NAMES) | st.text(max_size=9), WORDS, max_size=6))
def test_any_link_of_any_page_is_read_or_left_out(schema, link):
    """It is read without an error, every note is one short line, and what was read says the same again."""
    values, notes = schema.read(link)
    assert all(len(note) < 900 and "\n" not in note for note in notes)
    assert schema.read(query_of(values)) == (values, [])


def test_a_link_is_too_long_by_the_sum_of_its_values():
    assert fits({"own": "a" * LONGEST})
    assert not fits({"own": "a" * (LONGEST + 1)})
    assert not fits({"own": "a" * (LONGEST - 10), "pin": "b" * 11})
    assert fits({})
