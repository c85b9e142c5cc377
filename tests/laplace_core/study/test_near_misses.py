"""What people of other habits write: each is understood as it was meant, or refused in one sentence."""

from __future__ import annotations

import numpy as np
import pytest

from laplace_core.agents import LaplaceSettings
from laplace_core.cli import main
from laplace_core.errors import InputError
from laplace_core.training.checkpoint import new_agent, save_checkpoint
from laplace_core.worlds import parse_world, timeline_world, world_from_rows
from tests.support.hostile import assert_one_sentence
from tests.support.malformed_commands import near_decode, near_evaluate, near_search
from tests.support.malformed_tables import ROWS, TIMELINE, timelines, world_tables
from tests.support.malformed_worlds import NEAR, TEXT

LEAST = 200
"""Cases of each entry."""


def failures_of_worlds(cases, build, meant) -> list[str]:
    """Cases that were neither the world that was meant nor one sentence with the word in it."""
    cases, failed = list(cases), []
    assert len(cases) >= LEAST
    for what, given, word in cases:
        try:
            world = build(given)
        except InputError as error:
            try:
                assert word is not None, "refused"
                assert_one_sentence(f"laplace: {error}", word)
            except AssertionError as wrong:
                failed.append(f"{what}: {error} ({wrong})")
            continue
        columns = ("state", "action", "next_state", "probability", "reward")
        same = world.states == meant.states and all(
            np.array_equal(getattr(world, name), getattr(meant, name)) for name in columns
        )
        if word is not None or not same:
            failed.append(f"{what}: taken as something else")
    return failed


def failures_of_commands(cases, capsys) -> list[str]:
    """Commands that neither do what was meant nor end with status 2 and one sentence with the word in it."""
    cases, failed = list(cases), []
    assert len(cases) >= LEAST
    for words, wanted in cases:
        capsys.readouterr()
        status = main(words)
        out, err = capsys.readouterr()
        try:
            if isinstance(wanted, list):
                assert status == 0, err
                assert main(wanted) == 0
                assert capsys.readouterr().out == out
            else:
                assert status == 2, out
                assert out == ""
                assert len(err.splitlines()) == 1
                assert_one_sentence(err[:-1], wanted)
        except AssertionError as wrong:
            failed.append(f"{words}: {err or wrong}")
    return failed


def test_world_files():
    assert failures_of_worlds(NEAR, parse_world, parse_world(TEXT)) == []


def test_tables_of_a_world():
    assert failures_of_worlds(world_tables(), world_from_rows, world_from_rows(ROWS)) == []


def test_timelines():
    assert failures_of_worlds(timelines(), timeline_world, timeline_world(TIMELINE)) == []


def test_the_rest_of_a_timeline(subtests):
    for rest in ["Zero", "ZERO", "end", "over", "ends", "", "none", "alive", "0", None, 0, True]:
        with subtests.test(rest=rest), pytest.raises(InputError, match="rest must be one of zero, ended"):
            timeline_world(TIMELINE, rest)


def test_the_command_decode(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert failures_of_commands(near_decode(), capsys) == []
    assert not list(tmp_path.iterdir())


def test_the_command_search(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert failures_of_commands(near_search(), capsys) == []
    assert not list(tmp_path.iterdir())


def test_the_command_evaluate(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "agent.safetensors"
    settings = LaplaceSettings(environment="two_branch", hidden=8, features=4, theta_max=12.0)
    save_checkpoint(path, new_agent(settings), 0, None)
    assert failures_of_commands(near_evaluate(str(path)), capsys) == []
