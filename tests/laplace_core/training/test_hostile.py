"""Some eighty files that are no checkpoints, and what refusing them looks like."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from laplace_core.agents import LaplaceSettings
from laplace_core.errors import InputError
from laplace_core.training.checkpoint import MAX_BYTES, load_checkpoint, new_agent, save_checkpoint
from tests.laplace_core.training.test_spoiled import HOSTILE
from tests.support.hostile import assert_one_sentence

TINY = LaplaceSettings(hidden=4, features=2, gammas=2, thetas=3, seed=7)


@pytest.fixture(scope="module")
def good(tmp_path_factory) -> bytes:
    path = tmp_path_factory.mktemp("good") / "good.safetensors"
    save_checkpoint(path, new_agent(TINY), 123, 45.5, episodes=20)
    return path.read_bytes()


def test_spoiled_checkpoints_are_refused_in_one_sentence(subtests, tmp_path, good):
    for name, spoil in HOSTILE.items():
        with subtests.test(name):
            path = tmp_path / "spoiled.safetensors"
            spoiled = spoil(good)
            assert spoiled != good
            path.write_bytes(spoiled)
            with pytest.raises(InputError) as refused:
                load_checkpoint(path)
            assert_one_sentence(str(refused.value))
            assert not Path("/tmp/laplace-was-here").exists()


@pytest.mark.parametrize("kind", ["folder", "nothing", "dangling", "pipe", "device", "zero byte", "too large"])
def test_what_is_no_file_is_refused_in_one_sentence(tmp_path, kind):
    path = tmp_path / "spoiled.safetensors"
    if kind == "folder":
        path.mkdir()
    elif kind == "dangling":
        path.symlink_to(tmp_path / "nowhere")
    elif kind == "pipe":
        os.mkfifo(path)
    elif kind == "device":
        path = Path("/dev/zero")
    elif kind == "zero byte":
        path = Path("a\0b.safetensors")
    elif kind == "too large":
        with path.open("wb") as file:
            file.truncate(MAX_BYTES + 1)
    with pytest.raises(InputError) as refused:
        load_checkpoint(path)
    assert_one_sentence(str(refused.value))


@settings(max_examples=300)
@given(place=st.integers(0, 3_000), value=st.integers(0, 255))
def test_a_changed_byte_is_refused_or_harmless(tmp_path_factory, good, place, value):
    """Whatever one byte becomes, there is a checkpoint of finite weights or one sentence, and nothing else."""
    data = bytearray(good)
    data[place % len(data)] = value
    path = tmp_path_factory.getbasetemp() / "changed.safetensors"
    path.write_bytes(data)
    try:
        loaded = load_checkpoint(path)
    except InputError as error:
        assert_one_sentence(str(error))
    else:
        assert all(torch.isfinite(parameter).all() for parameter in loaded.agent.target.parameters())


def test_a_giant_network_is_refused_before_it_is_built(tmp_path, good, monkeypatch):
    path = tmp_path / "giant.safetensors"
    path.write_bytes(HOSTILE["settings of a giant network"](good))
    monkeypatch.setattr("laplace_core.agents.networks.build", lambda *_: pytest.fail("it was built"))
    with pytest.raises(InputError, match=r"ask for 54,\d+,\d+ weights"):
        load_checkpoint(path)
