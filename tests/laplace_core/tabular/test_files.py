"""Learned agents as files: they come back whole, are written whole, and hostile ones are refused."""

import json
import tracemalloc
import warnings
from dataclasses import replace

import numpy as np
import pytest
from safetensors.numpy import load

from laplace_core import InputError, load_world
from laplace_core.files import atomic
from laplace_core.tabular import (
    CURVE_NAMES,
    Learned,
    Learning,
    LearnSettings,
    learned_bytes,
    parse_learned,
    read_learned,
    save_learned,
)
from laplace_core.tabular import files as files_module
from laplace_core.worlds import dump_world, parse_world
from tests.support.hostile import assert_one_sentence
from tests.support.malformed_learned import cases, parts


def learned_of(world, **settings) -> Learned:
    learning = Learning(world, LearnSettings(**settings))
    for _ in learning:
        pass
    return learning.snapshot()


@pytest.fixture(scope="module")
def good() -> bytes:
    return learned_bytes(learned_of(load_world("two_branch", {"slip": 0.1}), episodes=30, seeds=2, peers=True))


def assert_same(one: Learned, other: Learned) -> None:
    assert one.settings == other.settings
    assert one.finished == other.finished
    assert dump_world(one.world) == dump_world(other.world)
    np.testing.assert_array_equal(one.basis, other.basis)
    np.testing.assert_array_equal(one.acting_values, other.acting_values)
    for mine, theirs in zip(one.curves, other.curves, strict=True):
        for name in CURVE_NAMES:
            np.testing.assert_allclose(mine[name], theirs[name], rtol=1e-5)
    assert (one.peers is None) == (other.peers is None)
    if one.peers is not None:
        for name in ("laplace_values", "plain", "categorical", "quantile", "expectile", "atoms"):
            np.testing.assert_array_equal(getattr(one.peers, name), getattr(other.peers, name))


# --- there and back ---


@pytest.mark.parametrize(
    ("world", "settings"),
    [
        (load_world("cliff_grid", {"slip": 0.2}), {"episodes": 20, "seeds": 3}),
        (load_world("fig6_chain"), {"episodes": 20, "peers": True, "peer_gamma": 0.8}),
        (load_world("two_decisions"), {"episodes": 20, "policy": "per_gamma", "spacing": "paper"}),
        (load_world("gym:FrozenLake-v1"), {"episodes": 5, "gammas": 7}),
        (parse_world(dump_world(load_world("double_chain"))), {"episodes": 7, "peers": True, "rate_half": 1e9}),
    ],
    ids=lambda value: getattr(value, "name", ""),
)
def test_what_was_saved_is_read(tmp_path, world, settings):
    learned = learned_of(world, **settings)
    path = tmp_path / "agent.safetensors"
    save_learned(learned, path)
    again = read_learned(path)
    assert_same(again, learned)
    save_learned(again, path)
    assert_same(read_learned(path), learned)
    assert [entry.name for entry in tmp_path.iterdir()] == ["agent.safetensors"]


def test_a_preset_comes_back_as_the_same_world():
    world = load_world("two_branch", {"slip": 0.1})
    assert parse_learned(learned_bytes(learned_of(world, episodes=2))).world is world


@pytest.mark.parametrize("turns", [0, 1, 5])
def test_a_run_that_goes_on_is_saved_as_unfinished(turns):
    learning = Learning(load_world("two_branch"), LearnSettings(seeds=3, peers=True))
    for _, _ in zip(range(turns), learning, strict=False):
        pass
    again = parse_learned(learned_bytes(learning.snapshot()))
    assert not again.finished
    assert_same(again, learning.snapshot())


def test_a_file_names_no_path_of_the_machine(tmp_path):
    path = tmp_path / "own.json"
    path.write_text(dump_world(load_world("two_branch")))
    content = learned_bytes(learned_of(load_world(str(path)), episodes=2))
    assert str(tmp_path).encode() not in content
    assert dump_world(parse_learned(content).world) == path.read_text()


def test_tensors_are_small_and_metadata_is_json(good):
    header, _ = parts(good)
    for text in header["__metadata__"].values():
        json.loads(text)
    assert {name: array.dtype.name for name, array in load(good).items()} == {
        "basis": "float32", "acting_values": "float64", "laplace_values": "float64", "plain": "float64",
        "categorical": "float32", "quantile": "float32", "expectile": "float32",
    }  # fmt: skip


def test_values_at_their_bounds_are_read():
    # A world that pays its one reward for ever: W reaches 1 / (1 - gamma) itself, and rounds in float32.
    forever = {"state": "a", "action": "go", "next": {"a": 1.0}, "reward": {"3": 1.0}}
    world = parse_world(json.dumps({"states": ["a"], "actions": ["go"], "transitions": [forever]}))
    learned = learned_of(world, episodes=10, max_steps=1_000, gamma_max=0.95, acting_gamma=0.95, peers=True)
    again = parse_learned(learned_bytes(learned))
    assert again.basis.max() == pytest.approx(20.0, rel=1e-3)


# --- written whole ---


def test_a_file_that_cannot_be_written_leaves_the_old_one(tmp_path, good, monkeypatch):
    learned, path = parse_learned(good), tmp_path / "agent.safetensors"
    path.write_bytes(b"old")

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(atomic.os, "replace", full)
    with pytest.raises(InputError, match="no space left"):
        save_learned(learned, path)
    monkeypatch.setattr(atomic.os, "replace", lambda *_: pytest.fail("interrupted"))
    with pytest.raises(pytest.fail.Exception):
        save_learned(learned, path)
    assert [entry.name for entry in tmp_path.iterdir()] == ["agent.safetensors"]
    assert path.read_bytes() == b"old"


@pytest.mark.parametrize("name", ["missing/agent.safetensors", "a\0b.safetensors"])
def test_names_that_are_no_places_are_refused(tmp_path, good, name):
    with pytest.raises(InputError) as refused:
        save_learned(parse_learned(good), tmp_path / name)
    assert_one_sentence(f"laplace: {refused.value}", "safetensors")
    with pytest.raises(InputError) as refused:
        read_learned(tmp_path / name)
    assert_one_sentence(f"laplace: {refused.value}", "safetensors")


def test_a_world_that_needs_more_room_than_a_header_has_is_refused(good, monkeypatch):
    learned = parse_learned(good)
    monkeypatch.setattr(files_module, "MAX_HEADER", 1_000)
    with pytest.raises(InputError, match="too large to be saved"):
        learned_bytes(learned)


# --- hostile ---


def refusal(path) -> str | None:
    """What the refusal says, None if the file was read; a warning is a failure."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            read_learned(path)
        except InputError as error:
            return str(error)
    return None


def test_hostile_files_are_refused_in_one_sentence(tmp_path, good):
    trap, path = tmp_path / "trap", tmp_path / "own.safetensors"
    count = 0
    for name, content, named in cases(good, str(trap)):
        path.write_bytes(content)
        said = refusal(path)
        assert said is not None, f"{name} was read"
        try:
            assert_one_sentence(f"laplace: {said}", *named)
        except AssertionError as error:
            raise AssertionError(f"{name}: {error}") from None
        count += 1
    assert count > 120
    assert not trap.exists()
    path.write_bytes(good)
    read_learned(path)


def test_folders_missing_and_large_files_are_refused(tmp_path, good):
    path = tmp_path / "own.safetensors"
    with pytest.raises(InputError, match="no such file"):
        read_learned(path)
    path.write_bytes(good)
    with pytest.raises(InputError, match="larger than"):
        read_learned(path, limit=len(good) - 1)
    assert read_learned(path, limit=len(good)).finished
    with pytest.raises(InputError, match="directory"):
        read_learned(tmp_path)


def test_a_small_file_never_takes_much_memory(good):
    hostile = [content for name, content, _ in cases(good, "trap") if "header above" not in name]
    tracemalloc.start()
    for content in hostile:
        with pytest.raises(InputError):
            parse_learned(content)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 30e6


def test_any_flipped_byte_of_the_header_is_refused_or_read(good):
    # Whatever a byte becomes: one sentence or an agent, and never another error.
    end = 8 + int.from_bytes(good[:8], "little")
    rng = np.random.default_rng(0)
    for place, value in zip(rng.integers(0, end, 400), rng.integers(0, 256, 400), strict=True):
        broken = bytearray(good)
        broken[place] = value
        try:
            found = parse_learned(bytes(broken))
        except InputError as error:
            assert_one_sentence(f"laplace: {error}")
        else:
            assert np.isfinite(found.basis).all()


def test_the_settings_of_a_file_stay_frozen(good):
    learned = parse_learned(good)
    assert hash(learned) != hash(replace(learned))  # by identity: a key of caches


def test_equal_agents_make_equal_bytes(good):
    again = learned_bytes(parse_learned(good))
    assert again == good
    assert learned_bytes(parse_learned(again)) == good
