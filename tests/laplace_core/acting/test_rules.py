"""Rules of control: what each takes for the time to go."""

from __future__ import annotations

import numpy as np
import pytest
import torch

from laplace_core import load_world
from laplace_core.acting.evaluation import evaluate
from laplace_core.acting.rules import RULES, Options, suited
from laplace_core.agents import SETTINGS, LaplaceSettings
from laplace_core.cli import main
from laplace_core.errors import InputError
from laplace_core.training.checkpoint import new_agent, save_checkpoint
from tests.laplace_core.acting.test_evaluation import Knowing
from tests.support.hostile import assert_refused

torch.set_num_threads(1)
TINY = {"environment": "two_branch", "hidden": 4}


class Telling:
    """An agent that chooses the action of the head that it is asked at."""

    def __init__(self, gammas: np.ndarray | None = None, horizon: int | None = None):
        count = horizon if gammas is None else len(gammas)
        if gammas is not None:
            self.gammas = gammas
        else:
            self.horizon = horizon
        self.acting_head, self._values = count - 1, np.eye(count)

    def action_values(self, observations: np.ndarray, head: int) -> np.ndarray:
        return np.tile(self._values[head], (len(observations), 1))

    def greedy(self, observations: np.ndarray) -> np.ndarray:
        return self.action_values(observations, self.acting_head).argmax(axis=1)


def heads(rule: str, agent: Telling, length: int | None, times: int) -> list[int]:
    choose = RULES[rule](agent, length, Options())
    return [int(choose(np.zeros((2, 1)), time)[1]) for time in range(times)]


def test_the_matched_discount_is_that_of_the_nearest_time_constant():
    """Time constants 1, 4, 16: in the logarithm the borders lie at 2 and 8, where the shorter one is taken."""
    agent = Telling(np.exp(-1.0 / np.array([1.0, 4.0, 16.0])))
    # Twenty steps to go, then nineteen, ..., one.
    assert heads("matched", agent, 20, 20) == [2] * 12 + [1] * 6 + [0] * 2


def test_greedy_knows_no_time():
    assert heads("greedy", Telling(np.array([0.5, 0.9])), 3, 3) == [1, 1, 1]


def test_an_agents_own_time_to_go_is_cut_at_its_longest():
    assert heads("own", Telling(horizon=4), 6, 6) == [3, 3, 3, 2, 1, 0]
    assert heads("own", Telling(horizon=4), None, 3) == [3, 3, 3]


@pytest.mark.parametrize(("horizon", "paid"), [(1, 5.0), (2, 5.0), (3, 10.0), (20, 10.0)])
def test_the_matched_discount_acts_for_the_time_to_go(horizon, paid):
    """With T steps to go gamma is about exp(-1/T): 10 gamma^2 is 1.4, 3.7, 5.1 and 9.0, against 5 at once."""
    agent = Knowing(load_world("two_branch"))
    assert evaluate(agent, "two_branch", episodes=1, horizon=horizon, rule="matched").returns.tolist() == [paid]


@pytest.mark.parametrize("rule", ["matched", "readout", "decoded"])
def test_rules_of_many_discounts_need_them(rule):
    agent = new_agent(SETTINGS["dqn"](**TINY))
    with pytest.raises(InputError, match=f"{rule}.*many discounts"):
        evaluate(agent, "two_branch", episodes=1, horizon=2, rule=rule)
    with pytest.raises(InputError, match=f"{rule}.*horizon"):
        RULES[rule](Telling(np.array([0.5, 0.9])), None, Options())


def test_only_an_agent_that_has_one_acts_by_its_own_time_to_go():
    with pytest.raises(InputError, match="fixed_horizon"):
        evaluate(new_agent(SETTINGS["dqn"](**TINY)), "two_branch", episodes=1, horizon=2, rule="own")


@pytest.mark.parametrize(("algorithm", "rule"), [("laplace", "fading"), ("fixed_horizon", "own"), ("c51", "greedy")])
def test_the_rule_that_is_not_named_suits_the_agent(algorithm, rule, tmp_path, capsys):
    agent = new_agent(SETTINGS[algorithm](**TINY))
    assert suited(agent, 2) == rule
    assert suited(agent, None) == "greedy"
    save_checkpoint(tmp_path / "agent.safetensors", agent, 1, None)
    assert main(["evaluate", str(tmp_path / "agent.safetensors"), "--episodes", "2", "--horizon", "2"]) == 0
    assert f"{rule}, T = 2" in capsys.readouterr().out


def test_rules_are_named_on_the_command_line(tmp_path, capsys):
    path = str(tmp_path / "agent.safetensors")
    save_checkpoint(path, new_agent(LaplaceSettings(**TINY, features=2, thetas=3)), 1, None)
    assert main(["evaluate", path, "--episodes", "2", "--horizon", "2", "--rule", "matched"]) == 0
    assert "matched, T = 2" in capsys.readouterr().out
    assert_refused(capsys, ["evaluate", path, "--horizon", "2", "--rule", "best"], "best", "matched")
    assert_refused(capsys, ["evaluate", path, "--horizon", "2", "--rule", "own"], "own")
