"""World files: what they mean, that they come back as they were written, and that bad ones are refused."""

import json
from copy import deepcopy

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from laplace_core import PRESETS, InputError, load_world
from laplace_core.worlds import END, World, dump_world, files, parse_world, read_world
from tests.support.hostile import assert_nothing_written, assert_one_sentence
from tests.support.malformed_worlds import CASES, TEXT, VALID

README_EXAMPLE = """
{"name": "my_world", "states": ["start", "short", "long"], "actions": ["left", "right"], "start": {"start": 1.0},
 "transitions": [
  {"state": "start", "action": "left", "next": {"short": 1.0}, "reward": {"0": 1.0}},
  {"state": "start", "action": "right", "next": {"long": 1.0}, "reward": {"0": 1.0}},
  {"state": "short", "action": "*", "next": {"END": 1.0}, "reward": {"5": 1.0}},
  {"state": "long", "action": "*", "next": {"END": 0.5, "long": 0.5}, "reward": {"10": 0.5, "-1": 0.5}}]}
"""


def outcomes(world: World, state: str, action: str) -> dict[tuple[str, float], float]:
    """Chance of each (next state's name, reward)."""
    names = {END: "END", **dict(enumerate(world.states))}
    rows = world.outcomes(world.states.index(state), world.actions.index(action))
    found = {(names[row.next_state], row.reward): row.probability for row in rows}
    assert len(found) == len(rows)
    return found


def with_transitions(*entries: dict, **changes) -> World:
    return parse_world(json.dumps(VALID | {"transitions": entries} | changes))


def entry(state: str, action: str, following: dict, reward: dict) -> dict:
    return {"state": state, "action": action, "next": following, "reward": reward}


def assert_same_world(one: World, other: World) -> None:
    assert (one.name, one.states, one.actions) == (other.name, other.states, other.actions)
    for column in ("state", "action", "next_state", "reward"):
        np.testing.assert_array_equal(getattr(one, column), getattr(other, column))
    assert (one.positions is None) == (other.positions is None)
    if one.positions is not None:
        np.testing.assert_array_equal(one.positions, other.positions)
    for column in ("start", "probability"):
        np.testing.assert_allclose(getattr(one, column), getattr(other, column), rtol=1e-15, atol=0)


# --- what a file means ---


def test_the_example_of_the_documentation():
    world = parse_world(README_EXAMPLE)
    assert (world.name, world.states, world.actions) == ("my_world", ("start", "short", "long"), ("left", "right"))
    np.testing.assert_array_equal(world.start, [1.0, 0.0, 0.0])
    assert outcomes(world, "start", "left") == {("short", 0.0): 1.0}
    assert outcomes(world, "start", "right") == {("long", 0.0): 1.0}
    for action in world.actions:
        assert outcomes(world, "short", action) == {("END", 5.0): 1.0}
        both = {(name, reward): 0.25 for name in ("END", "long") for reward in (10.0, -1.0)}
        assert outcomes(world, "long", action) == both


def test_star_fills_only_what_no_entry_names_wherever_it_stands():
    named = entry("start", "right", {"END": 1.0}, {"1": 1.0})
    filler = entry("start", "*", {"short": 1.0}, {"2": 1.0})
    rest = [entry(state, "*", {"END": 1.0}, {"0": 1.0}) for state in ("short", "long")]
    for order in ([named, filler], [filler, named]):
        world = with_transitions(*order, *rest)
        assert outcomes(world, "start", "right") == {("END", 1.0): 1.0}
        assert outcomes(world, "start", "left") == {("short", 2.0): 1.0}


def test_star_may_find_nothing_left_to_fill():
    entries = [entry(state, "*", {"END": 1.0}, {"7": 1.0}) for state in VALID["states"]]
    entries += [entry("start", action, {"END": 1.0}, {"1": 1.0}) for action in VALID["actions"]]
    assert 7.0 not in [reward for _, reward in outcomes(with_transitions(*entries), "start", "left")]


def test_joint_outcomes_tie_the_reward_to_the_next_state():
    world = parse_world(TEXT)
    assert outcomes(world, "long", "right") == {("END", 10.0): 0.25, ("long", -1.5): 0.75}


def test_start_and_name_may_be_left_out():
    document = {key: VALID[key] for key in ("states", "actions", "transitions")}
    world = parse_world(json.dumps(document))
    np.testing.assert_array_equal(world.start, [1.0, 0.0, 0.0])
    assert world.name


def test_rewards_are_numbers_in_quotes(subtests):
    for text, value in [
        ("5", 5.0),
        ("+5", 5.0),
        ("-5", -5.0),
        (".5", 0.5),
        ("5.", 5.0),
        ("5e-1", 0.5),
        ("1E3", 1000.0),
        ("007", 7.0),
    ]:
        with subtests.test(text):
            document = deepcopy(VALID)
            document["transitions"][0]["reward"] = {text: 1.0}
            assert outcomes(parse_world(json.dumps(document)), "start", "left") == {("short", value): 1.0}


def test_two_spellings_of_a_reward_are_one_reward():
    document = deepcopy(VALID)
    document["transitions"][0]["reward"] = {"5": 0.25, "5.0": 0.25, "0": 0.25, "-0": 0.25}
    assert outcomes(parse_world(json.dumps(document)), "start", "left") == {("short", 5.0): 0.5, ("short", 0.0): 0.5}


def test_what_has_no_chance_does_not_happen():
    document = deepcopy(VALID)
    document["transitions"][0] |= {"next": {"short": 1.0, "long": 0.0}, "reward": {"1": 1.0, "2": 0.0}}
    document["transitions"][4]["outcomes"].append({"p": 0.0, "next": "short", "reward": 99})
    world = parse_world(json.dumps(document))
    assert outcomes(world, "start", "left") == {("short", 1.0): 1.0}
    assert 99.0 not in world.reward_values


@pytest.mark.parametrize("off", [5e-7, -5e-7])
def test_sums_within_a_millionth_are_put_right(off):
    document = deepcopy(VALID)
    document["start"] = {"start": 0.5, "long": 0.5 + off}
    document["transitions"][1]["next"] = {"long": 0.5, "short": 0.5 + off}
    document["transitions"][2]["reward"] = {"5": 1.0 + off}
    document["transitions"][4]["outcomes"][0]["p"] = 0.25 + off
    world = parse_world(json.dumps(document))
    assert world.start.sum() == pytest.approx(1.0, abs=1e-15)
    totals = np.bincount(world.state * world.n_actions + world.action, weights=world.probability)
    np.testing.assert_allclose(totals, 1.0, rtol=0, atol=1e-15)


def test_five_thousand_states_are_not_too_many():
    states = [f"s{i}" for i in range(5_000)]
    entries = [entry(state, "*", {"END": 1.0}, {"0": 1.0}) for state in states]
    assert with_transitions(*entries, states=states, start={"s0": 1.0}).n_states == 5_000


# --- there and back ---


def test_a_world_that_is_written_comes_back(subtests):
    for source in [*PRESETS, "gym:FrozenLake-v1", "gym:CliffWalkingSlippery-v1"]:
        with subtests.test(source=source):
            world = load_world(source)
            again = parse_world(dump_world(world))
            assert_same_world(world, again)
            assert dump_world(again) == dump_world(world)


def test_presets_at_the_ends_of_their_ranges_come_back(subtests):
    for name, preset in PRESETS.items():
        with subtests.test(name):
            for end in (0, 1):
                ends = {
                    p.name: bool(end) if p.type is bool else p.bounds[end]
                    for p in preset.parameters
                    if p.type is not int
                }
                world = preset.make(ends)
                assert_same_world(world, parse_world(dump_world(world)))


def test_names_in_any_alphabet_come_back_through_a_file(tmp_path):
    text = TEXT.replace("short", "кратко").replace("long", '\\"長い\\" ').replace("left", "← left")
    path = tmp_path / "welt.json"
    for encoding in ("utf-8", "utf-8-sig"):
        path.write_text(text, encoding=encoding)
        world = read_world(path)
        assert world.states == ("start", "кратко", '"長い" ')
        assert world.actions == ("← left", "right")
        assert_same_world(world, parse_world(dump_world(world)))


# --- where states are drawn ---

PLACES = {"start": [0, 0.5], "short": [1, -1], "long": [1e9, 2]}


def test_positions_are_those_of_the_states_whatever_their_order():
    text = json.dumps(VALID | {"positions": dict(reversed(PLACES.items()))})
    world = parse_world(text)
    np.testing.assert_array_equal(world.positions, [[0, 0.5], [1, -1], [1e9, 2]])
    assert_same_world(world, parse_world(dump_world(world)))
    assert parse_world(TEXT).positions is None
    assert "positions" not in json.loads(dump_world(parse_world(TEXT)))


@pytest.mark.parametrize("source", ["cliff_grid", "gym:FrozenLake8x8-v1"])
def test_the_file_of_a_map_keeps_its_map(source):
    world = load_world(source)
    written = json.loads(dump_world(world))["positions"]
    assert [written[state] for state in world.states] == world.positions.tolist()


BAD_PLACES = {
    "no object": (None, True, 0, "", "start", [], [[0, 0]] * 3),
    "no pair": (None, True, 0, "0, 0", [], [0], [0, 0, 0], {}, {"x": 0, "y": 0}),
    "no number": (None, True, "0", [], {}, 1.1e9, -1e300, 10**400),
}


def test_positions_that_are_no_map_are_refused_by_name():
    def refused(positions: object, *named: str) -> None:
        with pytest.raises(InputError) as refusal:
            parse_world(json.dumps(VALID | {"positions": positions}))
        assert_one_sentence(f"laplace: {refusal.value}", "'positions'", *named)

    for positions in BAD_PLACES["no object"]:
        refused(positions, "must be an object")
    for place in BAD_PLACES["no pair"]:
        refused(PLACES | {"short": place}, "'short'", "pair")
    for number in BAD_PLACES["no number"]:
        refused(PLACES | {"short": [number, 0]}, "'short'")
        refused(PLACES | {"short": [0, number]}, "'short'")
    for name in ("cave", "END", "*", "", "two\nlines"):
        refused(PLACES | {name: [0, 0]}, "not in 'states'")
    for state in PLACES:
        refused({name: place for name, place in PLACES.items() if name != state}, f"lacks the state '{state}'")
    refused({}, "lacks the state 'start'")
    for literal in ("NaN", "Infinity", "-Infinity", "1e999", "9" * 5000):
        text = json.dumps(VALID | {"positions": PLACES}).replace("0.5]", f"{literal}]")
        with pytest.raises(InputError) as refusal:
            parse_world(text)
        assert_one_sentence(f"laplace: {refusal.value}")
    with pytest.raises(InputError, match="twice"):
        parse_world(json.dumps(VALID | {"positions": PLACES}).replace('"long": [', '"short": ['))


# --- what is refused ---


def test_a_malformed_world_is_refused_by_name(subtests):
    assert CASES
    assert parse_world(TEXT).n_states == 3  # what the cases spoil is sound itself
    for name, text, named in CASES:
        with subtests.test(name):
            with pytest.raises(InputError) as refused:
                parse_world(text)
            assert_one_sentence(f"laplace: {refused.value}", *named)


def test_decode_refuses_a_malformed_world_and_writes_nothing(subtests, tmp_path, capsys):
    for name, text, named in CASES[::13]:
        with subtests.test(name):
            path = tmp_path / "world.json"
            path.write_bytes(text.encode("utf-8", "surrogatepass"))
            assert_nothing_written(capsys, ["decode", str(path)], tmp_path, *named)


BYTES = {
    "latin-1": TEXT.replace("short", "kürz").encode("latin-1"),
    "utf-16": TEXT.encode("utf-16"),
    "a lone surrogate": TEXT.replace("short", "\ud800").encode("utf-8", "surrogatepass"),
    "an overlong slash": TEXT.encode().replace(b"short", b"\xc0\xaf"),
    "cut in a letter": TEXT.replace("short", "長").encode()[: TEXT.index("short") + 1],
    "zero bytes": bytes(1000),
    "random bytes": np.random.default_rng(0).bytes(1000),
}


def test_bytes_that_are_no_text_are_refused(subtests, tmp_path, capsys):
    for name, content in BYTES.items():
        with subtests.test(name):
            path = tmp_path / "world.json"
            path.write_bytes(content)
            assert_nothing_written(capsys, ["decode", str(path)], tmp_path, "world")


def test_files_that_cannot_be_read_are_refused(tmp_path, capsys):
    (tmp_path / "folder.json").mkdir()
    (tmp_path / "empty.json").touch()
    for name in ("folder.json", "missing.json", "empty.json/world.json", "zero\0byte.json", "x" * 400 + ".json"):
        assert_nothing_written(capsys, ["decode", str(tmp_path / name)], tmp_path, name.rsplit("/")[-1][:4])


def test_a_file_above_the_limit_is_not_even_read(tmp_path, monkeypatch):
    path = tmp_path / "world.json"
    path.write_text(TEXT)
    monkeypatch.setattr(files, "MAX_BYTES", len(TEXT))
    assert read_world(path).n_states == 3
    monkeypatch.setattr(files, "MAX_BYTES", len(TEXT) - 1)
    monkeypatch.setattr(files.Path, "read_text", lambda *_, **__: pytest.fail("it was read"))
    with pytest.raises(InputError, match="larger"):
        read_world(path)


BOMBS = {
    "one product": [entry("s0", "*", {f"s{i}": 1 / 40 for i in range(40)}, {str(i): 1 / 40 for i in range(40)})],
    "many entries": [
        entry(f"s{k}", "*", {f"s{i}": 1 / 40 for i in range(40)}, {str(i): 1 / 5 for i in range(5)}) for k in range(40)
    ],
    "a star over many actions": [
        entry(f"s{k}", "*", {"END": 1.0}, {str(i): 1 / 5 for i in range(5)}) for k in range(40)
    ],
}


@pytest.mark.parametrize("entries", BOMBS.values(), ids=BOMBS)
def test_a_small_file_of_large_products_is_refused(monkeypatch, entries):
    """With the real limit these would take seconds; the limit is lowered instead of the file enlarged."""
    monkeypatch.setattr(files, "MAX_OUTCOMES", 1_500)
    states, actions = [f"s{i}" for i in range(40)], [f"a{i}" for i in range(20)]
    with pytest.raises(InputError, match="1,500") as refused:
        with_transitions(*entries, states=states, actions=actions, start={"s0": 1.0})
    assert_one_sentence(str(refused.value))


JSON = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=5)
    | st.sampled_from(["END", "*", "start"]),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=6,
)


def paths(document: object, path: tuple = ()) -> list[tuple]:
    """The way to every value of a document."""
    inner = (
        document.items() if isinstance(document, dict) else enumerate(document) if isinstance(document, list) else ()
    )
    return [path] * bool(path) + [found for key, value in inner for found in paths(value, (*path, key))]


@settings(max_examples=150)
@given(st.lists(st.tuples(st.sampled_from(paths(VALID | {"positions": PLACES})), JSON), min_size=1, max_size=2))
def test_any_value_at_any_place_makes_a_world_or_a_sentence(changes):
    document = deepcopy(VALID | {"positions": PLACES})
    for path, value in changes:
        holder = document
        try:
            for key in path[:-1]:
                holder = holder[key]
            holder[path[-1]] = value
        except (TypeError, KeyError, IndexError):  # the first change removed the second one's place
            continue
    try:
        world = parse_world(json.dumps(document))
    except InputError as error:
        assert_one_sentence(f"laplace: {error}")
    else:
        assert_same_world(world, parse_world(dump_world(world)))


@settings(max_examples=100)
@given(st.integers(0, len(TEXT) - 1), st.integers(1, 20), st.text(max_size=3))
def test_any_splice_makes_a_world_or_a_sentence(at, length, put):
    try:
        parse_world(TEXT[:at] + put + TEXT[at + length :])
    except InputError as error:
        assert_one_sentence(f"laplace: {error}")
