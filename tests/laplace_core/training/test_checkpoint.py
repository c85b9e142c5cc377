"""Checkpoints: there and back, and some fifty files that are not what they say."""

from __future__ import annotations

import json
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch

from laplace_core import __version__, training
from laplace_core.agents import LaplaceSettings
from laplace_core.errors import InputError
from laplace_core.files import atomic
from laplace_core.files.strict_json import parse_json
from laplace_core.training.checkpoint import MAX_BYTES, load_checkpoint, new_agent, save_checkpoint
from laplace_core.training.defaults import settings_of
from tests.support.hostile import assert_one_sentence

FILES = Path(training.__file__).parent / "settings"
TINY = LaplaceSettings(hidden=4, features=2, gammas=2, thetas=3, seed=7)


@pytest.fixture(scope="module")
def good(tmp_path_factory) -> bytes:
    path = tmp_path_factory.mktemp("good") / "good.safetensors"
    save_checkpoint(path, new_agent(TINY), 123, 45.5, episodes=20)
    return path.read_bytes()


def test_a_checkpoint_comes_back_as_it_was(tmp_path):
    agent = new_agent(replace(TINY, network="multiplexer", dueling=True))
    with torch.no_grad():
        for parameter in agent.target.parameters():
            parameter += 0.1
    save_checkpoint(tmp_path / "agent.safetensors", agent, 123, 45.5, episodes=20)
    loaded = load_checkpoint(tmp_path / "agent.safetensors")
    assert (loaded.algorithm, loaded.environment, loaded.seed) == ("laplace", "CartPole-v1", 7)
    assert (loaded.step, loaded.score, loaded.episodes, loaded.version) == (123, 45.5, 20, __version__)
    assert loaded.settings == agent.settings
    observations = np.random.default_rng(0).normal(size=(5, 4))
    for one, other in zip(agent.gamma_spaces(observations), loaded.agent.gamma_spaces(observations), strict=True):
        np.testing.assert_array_equal(one, other)
    assert os.listdir(tmp_path) == ["agent.safetensors"]


def test_a_failed_write_leaves_the_old_file_and_no_other(tmp_path, good, monkeypatch):
    path = tmp_path / "agent.safetensors"
    path.write_bytes(good)

    def fail(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(atomic.os, "replace", fail)
    with pytest.raises(InputError, match="no space left on device"):
        save_checkpoint(path, new_agent(TINY), 1, None)
    assert path.read_bytes() == good
    assert os.listdir(tmp_path) == ["agent.safetensors"]


def test_json_is_read_strictly(subtests):
    for text, named in [
        ('{"a": 1, "a": 2}', "'a' stands twice"),
        ('{"a": NaN}', "contains NaN"),
        ("[" * 100_000, "nested too deeply"),
        ('{"a": ' + "9" * 10_000 + "}", "too many digits"),
        ("{", "not JSON"),
        (b"\xff", "not UTF-8"),
    ]:
        with subtests.test(text=text, named=named):
            with pytest.raises(InputError) as refused:
                parse_json(text, "the text")
            assert_one_sentence(str(refused.value), "the text", named)


# Settings files


def test_every_settings_file_fits_its_schema_and_its_name(subtests):
    for path in sorted(FILES.glob("*/*.json")):
        with subtests.test(path.stem, algorithm=path.parent.name):
            written = json.loads(path.read_text())
            found = settings_of(path.parent.name, path.stem, {})
            assert found.environment == path.stem
            assert {name: getattr(found, name) for name in written} == written
            assert 4 * new_agent(found).network_numbers(found, 8, 4) < MAX_BYTES


def test_given_settings_go_over_the_tuned_ones():
    assert settings_of("laplace", "CartPole-v1", {"seed": "3", "hidden": 32}).hidden == 32
    assert settings_of("laplace", "double_chain", {}).environment == "double_chain"


@pytest.mark.parametrize(
    ("algorithm", "environment", "given"),
    [("ppo", "CartPole-v1", {}), ("laplace", "../CartPole-v1", {}), ("laplace", "CartPole-v1", {"sed": 1})],
)
def test_unknown_names_are_refused(algorithm, environment, given):
    with pytest.raises(InputError):
        settings_of(algorithm, environment, given)
