"""Worlds as rows of a table: they come back as they were, edits mean what they say, bad cells are refused by row."""

from copy import deepcopy

import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from laplace_core import PRESETS, InputError, load_world
from laplace_core.worlds import (
    END,
    TOY_TEXT,
    World,
    dump_world,
    parse_world,
    rescaled,
    table,
    world_from_rows,
    world_rows,
)
from tests.support.hostile import assert_one_sentence
from tests.support.random_worlds import worlds

SOURCES = [*PRESETS, *(f"gym:{name}" for name in TOY_TEXT)]
PLAIN = [
    {"state": "start", "action": "go", "probability": 0.25, "reward": 1.0, "next": "late"},
    {"state": "start", "action": "go", "probability": 0.75, "reward": 0.0, "next": "END"},
    {"state": "late", "action": "go", "probability": 1.0, "reward": 5.0, "next": "END"},
]
BLANK = {"state": None, "action": "", "probability": float("nan"), "reward": pd.NA, "next": pd.NaT}


def changed(number: int, **cells: object) -> list[dict]:
    """The plain rows with other cells in one row, counted from 1."""
    rows = deepcopy(PLAIN)
    rows[number - 1] |= cells
    return rows


def back(world: World, rows: list[dict]) -> World:
    return world_from_rows(
        rows,
        name=world.name,
        states=world.states,
        actions=world.actions,
        start=world.start,
        suggested=world.suggested,
        positions=world.positions,
    )


def assert_identical(one: World, other: World) -> None:
    assert (one.name, one.states, one.actions, one.suggested) == (
        other.name,
        other.states,
        other.actions,
        other.suggested,
    )
    for column in ("start", "state", "action", "next_state", "probability", "reward"):
        np.testing.assert_array_equal(getattr(one, column), getattr(other, column))
    np.testing.assert_array_equal(one.positions is None, other.positions is None)
    if one.positions is not None:
        np.testing.assert_array_equal(one.positions, other.positions)


def refusal(rows, **options) -> str:
    with pytest.raises(InputError) as refused:
        world_from_rows(rows, **options)
    assert_one_sentence(f"laplace: {refused.value}")
    return str(refused.value)


# --- there and back ---


def test_the_rows_of_every_world_make_the_identical_world(subtests):
    for source in SOURCES:
        with subtests.test(source=source):
            world = load_world(source)
            rows = world_rows(world)
            assert all(set(row) == set(table.COLUMNS) for row in rows)
            assert_identical(world, back(world, rows))
            assert world_from_rows(rows).states == world.states  # they stand in order, known beforehand or not
            assert dump_world(back(world, rows)) == dump_world(world)


@pytest.mark.parametrize("source", ["two_branch", "gym:FrozenLake-v1"])
def test_the_rows_come_back_through_a_data_frame(source):
    world = load_world(source)
    frame = pd.DataFrame(world_rows(world))
    assert_identical(world, back(world, frame.to_dict("records")))
    assert_identical(world, back(world, frame.astype(str).to_dict("records")))


@given(worlds())
def test_rows_say_what_the_outcomes_say(world):
    """The naive twin: every outcome of every state and action, one by one."""
    expected = [
        {"state": state, "action": action, "probability": row.probability, "reward": row.reward,
         "next": "END" if row.next_state == END else world.states[row.next_state]}
        for s, state in enumerate(world.states)
        for a, action in enumerate(world.actions)
        for row in world.outcomes(s, a)
    ]  # fmt: skip
    assert world_rows(world) == expected
    again = back(world, expected)
    np.testing.assert_array_equal(again.reward, world.reward)
    np.testing.assert_allclose(again.probability, world.probability, rtol=1e-15)


# --- what an edit means ---


def test_blank_rows_and_rows_without_a_chance_change_nothing():
    plain = world_from_rows(PLAIN)
    spare = {"state": "late", "action": "go", "probability": 0, "reward": 99.0, "next": "start"}
    edited = world_from_rows([BLANK, *PLAIN[:1], {}, *PLAIN[1:], spare, BLANK])
    assert_identical(plain, edited)
    assert 99.0 not in edited.reward_values


def test_a_new_state_comes_after_the_known_ones_and_starts_with_no_chance():
    world = load_world("cliff_grid")
    rows = world_rows(world)
    new = [{"state": "cave", "action": a, "probability": 1, "reward": 3, "next": "END"} for a in world.actions]
    rows[0]["next"] = "cave"
    edited = back(world, new + rows)
    assert edited.states == (*world.states, "cave")
    np.testing.assert_array_equal(edited.start, np.append(world.start, 0.0))
    assert edited.positions is None
    first = edited.outcomes(edited.states.index(rows[0]["state"]), edited.actions.index(rows[0]["action"]))
    assert first[0].next_state == world.n_states
    assert edited.outcomes(world.n_states, 0)[0].reward == 3.0


def test_states_and_actions_stand_in_the_order_given_then_in_that_of_the_rows():
    rows = [
        {"state": s, "action": a, "probability": 1, "reward": 0, "next": "END"} for s in "cabd" for a in ("z", "x", "y")
    ]
    world = world_from_rows(rows, states=["b", "c"], actions=["y"], start={"d": 0.5, "c": 0.5})
    assert (world.states, world.actions) == (("b", "c", "a", "d"), ("y", "z", "x"))
    np.testing.assert_array_equal(world.start, [0.0, 0.5, 0.0, 0.5])
    assert world_from_rows(rows).states == tuple("cabd")
    np.testing.assert_array_equal(world_from_rows(rows).start, [1.0, 0.0, 0.0, 0.0])


def test_blanks_around_names_are_forgiven_unless_they_are_part_of_a_name():
    assert world_from_rows(changed(1, next="late ", state=" start")).states == ("start", "late")
    spaced = world_from_rows(
        [*changed(1, next=" late"), PLAIN[2] | {"state": " late"}], states=["start", "late", " late"]
    )
    assert spaced.next_state[0] == 2


def test_numbers_may_be_numbers_or_text(subtests):
    for cell in [0.25, "0.25", " .25 ", np.float32(0.25), np.float64(0.25), "25e-2"]:
        with subtests.test(cell=cell):
            assert_identical(world_from_rows(PLAIN), world_from_rows(changed(1, probability=cell)))


# --- what is refused ---

NAMES = (5, 1.5, True, ["start"], {"a": 1}, b"start", np.arange(3))
NUMBERS = ("x", "1,5", "nan", "inf", True, np.True_, [1], {}, b"1", np.arange(3), "0x1", "1_0", pd.Timestamp(0))
BLANKS = (None, "", "  ", float("nan"), np.nan, pd.NA, pd.NaT)
LARGE = (float("inf"), -float("inf"), 1e10, 10**400, 10**5000, "1e999")


@pytest.mark.parametrize("number", [1, 3])
def test_every_bad_cell_is_refused_by_row_and_column(number):
    for column in table.COLUMNS:
        numeric = column in ("probability", "reward")
        for cell in BLANKS:
            assert f"row {number} has no {column}" in refusal(changed(number, **{column: cell}))
        for cell in (*NUMBERS, *LARGE) if numeric else NAMES:
            assert f"row {number}, {column} is" in refusal(changed(number, **{column: cell}))
        row = {key: value for key, value in PLAIN[0].items() if key != column}
        assert f"row 4 has no {column}" in refusal([*PLAIN, row])
    for cell in (-1e-9, 1.1, 2):
        assert f"row {number}, probability is" in refusal(changed(number, probability=cell))


def test_words_that_cannot_be_names_are_refused(subtests):
    for state in ["END", "*", "x" * 101, "two\nlines", "\ud800"]:
        with subtests.test(state=state):
            assert "row 3, state" in refusal(changed(3, state=state))
            assert "row 1, action" in refusal(changed(1, action=state))


def test_rows_that_do_not_fit_together_are_refused(subtests):
    for rows, named in [
        (changed(2, next="end"), "row 2, next is 'end', which is no state"),
        (changed(3, state="lat"), "row 1, next is 'late'"),
        (changed(1, probability=0.5), "state 'start', action 'go' add up to 1.25; they must add up to 1"),
        (PLAIN[1:], "state 'start', action 'go' add up to 0.75"),
        (changed(3, action="stay"), "state 'start' has no row for action 'stay': add one"),
        ([], "no rows"),
        ([BLANK, {}], "no rows"),
    ]:
        with subtests.test(rows=rows, named=named):
            assert named in refusal(rows)


def test_a_known_state_without_rows_is_missed():
    assert "state 'gone' has no row for action 'go': add one" in refusal(PLAIN, states=["start", "gone", "late"])
    assert "'gone'" in refusal(PLAIN, start={"gone": 1.0})
    assert "3 probabilities for 2 states" in refusal(PLAIN, states=["start", "late"], start=np.ones(3))
    assert "add up to 0.5" in refusal(PLAIN, start={"late": 0.5})


def test_too_many_rows_are_refused(monkeypatch):
    monkeypatch.setattr(table, "MAX_OUTCOMES", 2)
    assert "3 rows" in refusal(PLAIN)


CELLS = (
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=4)
    | st.sampled_from(["start", "late", "go", "END", "1", pd.NA, pd.NaT, (), []])
)


@settings(max_examples=200)
@given(
    st.lists(st.tuples(st.integers(0, 3), st.sampled_from([*table.COLUMNS, "other"]), CELLS), min_size=1, max_size=4)
)
def test_any_cells_make_a_world_or_a_sentence(edits):
    rows = [*deepcopy(PLAIN), {}]
    for row, column, cell in edits:
        rows[row][column] = cell
    try:
        world = world_from_rows(rows)
    except InputError as error:
        assert_one_sentence(f"laplace: {error}")
    else:
        assert parse_world(dump_world(world)).states == world.states


# --- rescale to 1 ---


@given(worlds(), st.lists(st.floats(0.01, 100.0), min_size=18, max_size=18))
def test_rescaling_brings_back_what_was_stretched(world, factors):
    rows = world_rows(world)
    pairs = sorted({(row["state"], row["action"]) for row in rows})
    stretched = [
        row | {"probability": row["probability"] * factors[pairs.index((row["state"], row["action"]))]} for row in rows
    ]
    kept = deepcopy(stretched)
    again = rescaled(stretched)
    assert stretched == kept
    for row, other in zip(rows, again, strict=True):
        assert other | {"probability": 0} == row | {"probability": 0}
        assert other["probability"] == pytest.approx(row["probability"], rel=1e-12)


def test_rescaling_by_hand():
    rows = [PLAIN[0] | {"probability": "1"}, BLANK, PLAIN[1] | {"probability": 3.0, "next": None}, PLAIN[2]]
    assert [row["probability"] for row in rescaled(rows) if row["state"]] == [0.25, 0.75, 1.0]
    assert rescaled(rows)[1]["state"] is None
    with pytest.raises(InputError, match="state 'late', action 'go' are all 0"):
        rescaled(changed(3, probability=0))
    for cells in ({"state": None}, {"action": 5}, {"probability": None}, {"probability": -1}):
        with pytest.raises(InputError, match="row 3"):
            rescaled(changed(3, **cells))
