"""A race in words, as a command and as a link."""

from __future__ import annotations

from pathlib import Path

import pytest

from laplace_core.acting.deadlines import rules_of_race
from laplace_core.acting.race import FIRST_START, race
from laplace_core.agents import SETTINGS, LaplaceSettings
from laplace_core.trained import races
from laplace_core.trained.races import Control
from laplace_core.training.checkpoint import Loaded, load_checkpoint, new_agent, save_checkpoint


def loaded(tmp_path: Path, name: str, settings) -> Loaded:
    save_checkpoint(tmp_path / name, new_agent(settings), 100, 21.5, episodes=20)
    return load_checkpoint(tmp_path / name)


@pytest.fixture
def control(tmp_path) -> Control:
    one = loaded(tmp_path, "a.safetensors", LaplaceSettings(environment="two_branch", hidden=4, features=4, gammas=3))
    return Control(one, "greedy", None, one, "fading", 3)


def test_an_agent_of_fixed_horizons_has_one_rule(tmp_path):
    other = loaded(tmp_path, "b.safetensors", SETTINGS["fixed_horizon"](environment="two_branch", hidden=4))
    assert rules_of_race(other.agent) == ("own",)


def test_the_words_are_those_of_who_leads(control):
    fields = {"starts": 9, "left": 1.0, "right": 3.0, "difference": 2.0, "interval": [1.5, 2.5], "equal": 0.0}
    assert races.field_verdict(fields, control) == (
        "ahead",
        "Over 9 starts: greedy 1.0, fading deadline 3.0 on average. Fading deadline is ahead by 2.0 (95% 1.5 to 2.5).",
    )
    tone, sentence = races.field_verdict(fields | {"difference": -2.0, "interval": [-2.5, -1.5]}, control)
    assert (tone, sentence.split(". ")[1]) == ("behind", "Greedy is ahead by 2.0 (95% 1.5 to 2.5).")
    tone, sentence = races.field_verdict(fields | {"interval": [-0.1, 4.0]}, control)
    assert tone == "level"
    assert "covers 0" in sentence
    assert races.field_verdict(fields | {"interval": [0.05, 4.0]}, control)[0] == "ahead"
    assert "same return" in races.field_verdict(fields | {"equal": 1.0}, control)[1]


def test_two_sides_that_are_one_are_told_so(control):
    same = Control(control.left, "fading", None, control.right, "fading", 3)
    one = race("two_branch", *same.entrants, 0, horizon=3)
    assert "same rule" in races.verdict(one, same)[1]


def test_the_command_repeats_the_view(control):
    shown = Control(control.left, "greedy", 0.9, control.right, "readout", 7)
    found = races.command(shown, 50, "runs/mine/best.safetensors")
    assert found == (
        "laplace race runs/mine/best.safetensors --horizon 7 --rule readout --against greedy --gamma 0.9 --seeds 50"
    )
    assert "--against-agent other.safetensors --gamma" in races.command(
        shown, 50, "one.safetensors", "other.safetensors"
    )


def test_a_link_leads_into_the_same_episode(control):
    query = races.inside(control, "right", FIRST_START + 2, 8)
    assert query == {"r.shown": "yes", "r.seed": "2000000002", "r.rule": "fading", "r.at": "7", "r.horizon": "3"}
