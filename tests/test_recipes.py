"""The recipe that stands in the place to be extended, followed with a toy example, is all that it takes."""

from __future__ import annotations

import json

import numpy as np
import pytest

from app import raced, rolled
from laplace_core.agents import LaplaceSettings
from laplace_core.agents.peer_settings import C51Settings
from laplace_core.cli import main
from laplace_core.training.checkpoint import load_checkpoint, new_agent, save_checkpoint
from laplace_core.training.continuations import steps_known
from laplace_core.training.race import race
from laplace_core.training.rollout import roll_out
from laplace_core.training.rules import RULES, Rule, rules_of, suited


def last_action(agent, length, options):
    """Always the last action, more surely the less is to go."""
    wanted = np.eye(agent.n_actions)[-1]
    return lambda observations, time: np.tile(wanted * (length - time), (len(observations), 1))


@pytest.fixture
def toy(monkeypatch):
    """The recipe of ``laplace_core.training.rules``: a function, its entry, and a row of words."""
    monkeypatch.setitem(RULES, "last", Rule(last_action, lambda agent: agent.n_actions > 1))
    monkeypatch.setitem(rolled.TITLES, "last", ("for T: always the last action", "last action"))


def laplace():
    return new_agent(LaplaceSettings(environment="two_branch", hidden=8, features=4, theta_max=12.0))


def test_a_rule_of_control(toy, tmp_path, capsys):
    agent = laplace()
    for each in (agent, new_agent(C51Settings(environment="two_branch", hidden=8))):
        assert "last" in rules_of(each)
    rollout = roll_out(agent, "two_branch", 0, rule="last", horizon=3, spaces=False)
    assert set(rollout.actions) == {agent.n_actions - 1}
    assert steps_known(agent, rollout, 1, 50, own=True) == 2  # it acts for T = 3, and says nothing after it

    # The forms, the links and the words of the pages.
    assert rolled.rules_of(agent)["last"] == "for T: always the last action"
    assert rolled.parameters(agent)[rolled.RULE].parse("last") == "last"
    assert rolled.control_of({rolled.RULE: "last"}, 9).horizon == 9
    save_checkpoint(tmp_path / "agent.safetensors", agent, 0, None)
    loaded = load_checkpoint(tmp_path / "agent.safetensors")
    control = raced.Control(loaded, "greedy", None, loaded, "last", 3)
    assert "last" in raced.rules_of(agent)
    assert raced.sides(control) == ("greedy", "last action")
    assert race("two_branch", *control.entrants, 0, horizon=3).right.rule == "last"

    # The command line.
    assert main(["evaluate", str(tmp_path / "agent.safetensors"), "--rule", "last", "--horizon", "3", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["rule"] == "last"
    assert main(["evaluate", str(tmp_path / "agent.safetensors"), "--rule", "last", "--alpha", "2"]) == 2
    assert "changes nothing under the rule 'last'" in capsys.readouterr().err


def test_no_rule_is_chosen_by_itself_but_those_that_suit(toy):
    assert suited(laplace(), 3) == "fading"
