"""Settings and files as Python objects: checked when built, copied, pickled, and named by paths."""

from __future__ import annotations

import copy
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from laplace_core import InputError, Settings, load_world, study
from laplace_core.study.settings import resolve, resolve_for_gamma_space
from laplace_core.tabular.settings import LearnSettings
from laplace_core.worlds import parse_world_bytes, world_text
from tests.support.malformed_worlds import TEXT


def test_settings_are_refused_when_they_are_built(subtests):
    for given, sentence in [
        ({"alpha": -1}, "alpha must be a number from 0 to 1e+06, not '-1'."),
        ({"alpha": float("nan")}, "alpha must be a number from 0 to 1e+06, not 'nan'."),
        ({"steps": 2.5}, "steps must be a whole number from 1 to 2000, not '2.5'."),
        ({"policy": "mine"}, "policy must be one of shared, per_gamma, not 'mine'."),
        ({"world": None}, "world must be a name or a path, not NoneType."),
        ({"params": 5}, "params must be a mapping, or pairs, of names and values."),
    ]:
        with subtests.test(given=given, sentence=sentence):
            with pytest.raises(InputError) as refused:
                Settings(**given)
            assert str(refused.value) == sentence


def test_values_are_kept_in_their_own_type():
    made = Settings(world=Path("w.json"), params={"length": 4}, alpha="2e-1", steps=np.int64(7), gammas=15.0, state=0)
    assert made == Settings(world="w.json", params=(("length", 4),), alpha=0.2, steps=7, gammas=15, state="0")
    assert [type(getattr(made, name)) for name in ("alpha", "steps", "gammas", "slope")] == [
        float,
        int,
        int,
        type(None),
    ]
    assert pickle.loads(pickle.dumps(made)) == copy.deepcopy(made) == made  # noqa: S301 - our own
    assert len({made, copy.deepcopy(made)}) == 1


def test_settings_of_learning_are_refused_when_they_are_built():
    with pytest.raises(InputError, match="rate_first must be a number from 0 to 1"):
        LearnSettings(rate_first=-1)
    assert LearnSettings(episodes="20").episodes == 20


def test_a_world_may_be_named_by_a_path(tmp_path):
    path = tmp_path / "two_branch.json"
    path.write_text(TEXT)
    assert load_world(path).states == load_world(str(path)).states
    assert study(load_world(path), Settings()).settings.world == str(path)
    for name in ("two_branch", "gym:Taxi-v4", "w.txt"):
        with pytest.raises(InputError, match="none of"):
            load_world(Path(name))
    with pytest.raises(InputError, match="named by text or by a path"):
        load_world(5)


def test_a_byte_order_mark_is_read_and_another_encoding_refused(tmp_path):
    # One rule for a file on the disk and the bytes of an upload.
    text = TEXT.replace("short", "kürz")
    path = tmp_path / "w.json"
    for encoding in ("utf-8", "utf-8-sig"):
        path.write_bytes(text.encode(encoding))
        assert load_world(path).states == parse_world_bytes(text.encode(encoding)).states == ("start", "kürz", "long")
        assert world_text(text.encode(encoding)) == text
    for encoding in ("latin-1", "cp1252", "utf-16", "utf-16-le", "utf-16-be", "utf-32", "cp500"):
        path.write_bytes(text.encode(encoding))
        for read in (load_world, lambda path: parse_world_bytes(path.read_bytes(), path.name)):
            with pytest.raises(InputError) as refused:
                read(path)
            assert str(refused.value) == "w.json is not UTF-8 text: save it with the encoding UTF-8."


def test_resolved_settings_are_complete_and_can_be_chosen_again():
    world = load_world("two_branch")
    settings = resolve(Settings(), world)
    with pytest.raises(InputError, match="theta_min is not decided"):
        replace(settings, theta_min=None)
    # Given up again, the setting suits the world as if it had never been chosen.
    again = resolve(replace(settings.chosen(), theta_min=None), world)
    assert again == settings
    assert type(settings.chosen()) is Settings
    assert settings.chosen().to_command() == settings.to_command()
    # Our own bytes.
    for same in (copy.deepcopy(settings), pickle.loads(pickle.dumps(settings)), replace(settings)):  # noqa: S301
        assert same == settings
        assert hash(same) == hash(settings)


def test_a_gamma_space_leaves_open_what_its_file_decides():
    settings = resolve_for_gamma_space(Settings(world="mine.npz"), np.array([0.5, 0.9]))
    assert settings.slope is None
    assert settings.alpha == 0.01
    with pytest.raises(InputError, match="alpha is not decided"):
        replace(settings, alpha=None)
