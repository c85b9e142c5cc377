"""Hand-drawn timelines: the world that is built has exactly the drawn one, and bad drawings are refused by row."""

import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from laplace_core import InputError, Settings, load_world, study
from laplace_core.planning import greedy_policy, reward_timeline
from laplace_core.study.tables import true_timeline_rows
from laplace_core.worlds import MAX_TAU, dump_world, parse_world, timeline, timeline_rows, timeline_world
from tests.support.hostile import assert_one_sentence
from tests.support.random_worlds import rewards, worlds_with_policy

ACTIONS = ("wait", "go", "start")
CELL = {"action": "go", "tau": 2, "reward": 1.5, "probability": 0.25}


def row(action: str, tau: int, reward: float, probability: float) -> dict:
    return {"action": action, "tau": tau, "reward": reward, "probability": probability}


def drawn_timeline(rows: list[dict], rest: str, steps: int) -> dict[tuple[str, int], dict[float, float]]:
    """The naive twin: what the table says about every step of every action."""
    told: dict[tuple[str, int], dict[float, float]] = {}
    for action in {row["action"] for row in rows}:
        last = max(row["tau"] for row in rows if row["action"] == action)
        alive = 1.0
        for tau in range(steps):
            step: dict[float, float] = {}
            here = [row for row in rows if (row["action"], row["tau"]) == (action, tau)]
            for each in here:
                step[each["reward"]] = step.get(each["reward"], 0.0) + each["probability"]
            if rest == "ended":
                alive = sum(step.values()) if here else alive
            if tau <= last:
                step[0.0] = step.get(0.0, 0.0) + alive - sum(step.values())
            told[action, tau] = step
    return told


def assert_as_drawn(rows: list[dict], rest: str) -> None:
    world = timeline_world(rows, rest)
    assert world.states[world.state_index("start")] == world.states[int(np.argmax(world.start))]
    assert list(world.actions) == list(dict.fromkeys(row["action"] for row in rows))
    steps = max(row["tau"] for row in rows) + 3
    assert world.suggested["steps"] == steps
    told = drawn_timeline(rows, rest, steps)
    rng = np.random.default_rng(0)
    for policy in (greedy_policy(world, 0.9), rng.integers(0, world.n_actions, world.n_states)):
        found = reward_timeline(world, 0, policy, steps)
        for a, action in enumerate(world.actions):
            for tau in range(steps):
                expected = [told[action, tau].get(value, 0.0) for value in world.reward_values.tolist()]
                np.testing.assert_allclose(found[a, tau], expected, rtol=0, atol=1e-12)
                assert found[a, tau].sum() == pytest.approx(sum(told[action, tau].values()), abs=1e-12)


@st.composite
def drawings(draw, *, ends: bool) -> list[dict]:
    """Rows of up to three actions in any order; with ``ends`` their step sums start at 1 and fall."""
    rows = []
    for action in draw(st.lists(st.sampled_from(ACTIONS), min_size=1, unique=True)):
        alive = 1.0
        for tau in sorted(draw(st.sets(st.integers(0, 9), min_size=1, max_size=5))):
            shares = draw(st.lists(st.integers(1, 6), min_size=1, max_size=3))
            alive *= draw(st.integers(0, 8)) / 8 if not ends or tau > 0 else 1.0
            rows += [row(action, tau, draw(rewards), alive * share / sum(shares)) for share in shares]
            alive = alive if ends else 1.0
    return draw(st.permutations(rows))


@given(drawings(ends=False))
def test_what_is_left_pays_nothing_and_goes_on(rows):
    assert_as_drawn(rows, "zero")


@given(drawings(ends=True))
def test_what_is_left_has_ended(rows):
    assert_as_drawn(rows, "ended")


def test_two_timelines_by_hand():
    """go pays 5 at step 1 with a chance of 1/4; wait surely pays -1 at step 0 and 8 at step 2."""
    rows = [row("go", 1, 5.0, 0.25), row("wait", 0, -1.0, 1.0), row("wait", 2, 8.0, 0.5)]
    zero, ended = timeline_world(rows), timeline_world([*rows[:1], row("go", 3, 1.0, 0.125)], "ended")
    assert zero.states == ("start", "go, tau 1", "wait, tau 1", "wait, tau 2")
    found = reward_timeline(zero, 0, np.zeros(4, dtype=int), 4)
    np.testing.assert_array_equal(found.sum(axis=-1), [[1, 1, 0, 0], [1, 1, 1, 0]])
    np.testing.assert_allclose(found @ zero.reward_values, [[0, 1.25, 0, 0], [-1, 0, 4, 0]], atol=1e-15)
    found = reward_timeline(ended, 0, np.zeros(ended.n_states, dtype=int), 5)
    np.testing.assert_allclose(found.sum(axis=-1), [[1, 0.25, 0.25, 0.125, 0]], atol=1e-15)
    np.testing.assert_allclose(found @ ended.reward_values, [[0, 1.25, 0, 0.125, 0]], atol=1e-15)


def test_a_drawn_timeline_is_studied_and_saved_like_any_world():
    rows = [row("short", 0, 5.0, 1.0), row("long", 2, 10.0, 1.0)]
    world = timeline_world(rows, name="mine")
    found = study(world, Settings())
    assert (found.settings.state, found.settings.steps) == ("start", 5)
    assert [found.action_names[a] for a in found.truth.optimal_action] == ["short", "short", "long", "long", "long"]
    again = parse_world(dump_world(world))
    np.testing.assert_array_equal(again.probability, world.probability)
    assert again.name == "mine"


@pytest.mark.parametrize("left", [1e-3, 1e-7, 1e-11])
def test_a_small_rest_is_no_rounding_error(left):
    assert_as_drawn([row("go", 0, 5.0, 1.0 - left), row("go", 2, 5.0, left)], "zero")
    assert_as_drawn([row("go", 0, 5.0, 1.0), row("go", 1, 5.0, 1.0 - left), row("go", 2, 5.0, left)], "ended")


def test_an_action_whose_later_rows_have_no_chance_has_ended():
    rows = [row("go", 0, 1.0, 1.0), row("go", 1, 2.0, 0.0), row("go", 4, 3.0, 0.0)]
    assert_as_drawn(rows, "ended")
    assert_as_drawn(rows, "zero")


def test_the_longest_timeline_is_built():
    world = timeline_world([row("go", MAX_TAU, 1.0, 0.5), row("wait", MAX_TAU, 1.0, 0.5)], "zero")
    assert world.n_states == 2 * MAX_TAU + 1
    assert world.suggested["steps"] == MAX_TAU + 3


# --- from a world's own timeline ---


@settings(max_examples=60)
@given(worlds_with_policy(), st.integers(1, 12), st.integers(2, 5))
def test_a_worlds_timeline_comes_back_to_the_digits_it_was_rounded_to(pair, steps, digits):
    world, policy = pair
    true = reward_timeline(world, 0, policy, steps)
    rows = timeline_rows(true, world.reward_values, world.actions, digits)
    again = timeline_world(rows, "ended")
    found = reward_timeline(again, 0, np.zeros(again.n_states, dtype=int), steps)
    assert again.actions == world.actions
    columns = np.searchsorted(world.reward_values, again.reward_values)
    columns = np.clip(columns, 0, world.reward_values.size - 1)
    known = world.reward_values[columns] == again.reward_values
    assert found[..., ~known].max(initial=0.0) == 0.0  # nothing but rewards of the world is ever paid
    told = np.zeros_like(true)
    told[..., columns[known]] = found[..., known]
    np.testing.assert_allclose(told, true, rtol=0, atol=10.0**-digits + 1e-12)
    np.testing.assert_allclose(told.sum(axis=-1), true.sum(axis=-1), rtol=0, atol=0.51 * 10.0**-digits)
    for each in rows:
        assert each["probability"] == round(each["probability"], digits) > 0


def test_rounding_never_makes_survival_rise():
    """Seven rewards of 1/7: each rounds to .1429, together 1.0003."""
    true = np.full((1, 2, 7), 1 / 7)
    rows = timeline_rows(true, np.arange(7.0), ["go"])
    for tau in (0, 1):
        mine = [each["probability"] for each in rows if each["tau"] == tau]
        assert sum(round(p * 10_000) for p in mine) == 10_000
        assert sorted(set(mine)) == [0.1428, 0.1429]
    timeline_world(rows, "ended")


def test_the_largest_remainder_is_rounded_up():
    rows = timeline_rows(np.array([[[0.33336, 0.33334, 0.3333]]]), np.arange(3.0), ["go"])
    assert [each["probability"] for each in rows] == [0.3334, 0.3333, 0.3333]


@pytest.mark.parametrize("source", ["two_branch", "fig6_chain", "double_chain", "gym:FrozenLake-v1", "cliff_grid"])
def test_a_study_starts_a_drawing(source):
    world = load_world(source)
    found = study(world, Settings(steps=8, thetas=20))
    rows = true_timeline_rows(found)
    again = study(timeline_world(rows, "ended"), Settings(steps=8, thetas=20))
    np.testing.assert_allclose(again.truth.survival, found.truth.survival, atol=1e-4)
    np.testing.assert_allclose(again.truth.expected_reward, found.truth.expected_reward, atol=2e-3)
    given_policy = true_timeline_rows(found, greedy_policy(world, 0.99))
    assert given_policy == rows


def test_half_steps_of_a_study_are_whole_steps_of_a_drawing():
    for steps, last in ((2, 0), (3, 1), (4, 1), (5, 2), (20, 3)):
        found = study(load_world("fig6_chain"), Settings(steps=steps, time_step=0.5))
        assert max(each["tau"] for each in true_timeline_rows(found)) == last


# --- what is refused ---


def refusal(rows, rest: str = "zero") -> str:
    with pytest.raises(InputError) as refused:
        timeline_world(rows, rest)
    assert_one_sentence(f"laplace: {refused.value}")
    return str(refused.value)


BAD_CELLS = {
    "action": (None, "", pd.NA, 5, True, [], "END", "*", "x" * 81, "two\nlines"),
    "tau": (None, float("nan"), -1, 0.5, MAX_TAU + 1, "x", True, [], float("inf"), 10**400),
    "reward": (None, pd.NA, "x", True, 1e10, float("inf"), {}),
    "probability": (None, "", -0.1, 1.1, "x", False, float("inf"), []),
}


def test_bad_cells_are_refused_by_row(subtests):
    for rest in timeline.TIMELINE_RESTS:
        for column in BAD_CELLS:
            with subtests.test(rest=rest, column=column):
                for cell in BAD_CELLS[column]:
                    text = refusal([row("go", 0, 1.0, 1.0), {}, CELL | {column: cell}], rest)
                    assert "row 3" in text
                    assert column in text


def test_sums_that_make_no_timeline_are_refused():
    over = [row("go", 1, 1.0, 0.75), row("wait", 1, 1.0, 1.0), row("go", 1, 2.0, 0.5)]
    assert "row 3 brings the probabilities of action 'go' at tau 1 to 1.25" in refusal(over)
    assert "tau 0 add up to 0.5" in refusal([row("go", 0, 1.0, 0.5)], "ended")
    timeline_world([row("go", 0, 1.0, 0.5)], "zero")
    rise = [row("go", 1, 1.0, 0.25), row("go", 3, 1.0, 0.5)]
    assert "rise from 0.25 at tau 2 to 0.5 at tau 3" in refusal(rise, "ended")
    timeline_world(rise, "zero")


def test_empty_and_huge_drawings_are_refused(monkeypatch):
    for rows in ([], [{}], [dict.fromkeys(CELL), dict.fromkeys(CELL, float("nan"))]):
        assert "no rows" in refusal(rows)
    assert "rest" in refusal([CELL], "nothing")
    assert "5,000" in refusal([row(f"a{i}", MAX_TAU, 1.0, 1.0) for i in range(11)])
    monkeypatch.setattr(timeline, "MAX_OUTCOMES", 100)
    monkeypatch.setattr(timeline.World, "from_outcomes", lambda *_, **__: pytest.fail("all outcomes were built"))
    assert "100" in refusal([row(f"a{i}", 9, float(v), 0.25) for i in range(5) for v in range(4)])


CELLS = (
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=3) | st.sampled_from([pd.NA, [], "1"])
)


@settings(max_examples=150)
@given(
    st.sampled_from(timeline.TIMELINE_RESTS),
    st.lists(st.tuples(st.integers(0, 1), st.sampled_from(list(CELL)), CELLS), min_size=1, max_size=3),
)
def test_any_cells_make_a_world_or_a_sentence(rest, edits):
    rows = [row("go", 0, 1.0, 1.0), dict(CELL)]
    for at, column, cell in edits:
        rows[at][column] = cell
    try:
        world = timeline_world(rows, rest)
    except InputError as error:
        assert_one_sentence(f"laplace: {error}")
    else:
        assert world.n_states <= MAX_TAU + 2
