"""Figures and tables that are measured: their parts, what they give where the answer is known, and their files."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from laplace_core.acting.evaluation import FIRST_SEED, played
from laplace_core.acting.rules import RULES, Options
from laplace_core.agents import LaplaceSettings
from laplace_core.cli import main
from laplace_core.code.gamma_space import GammaSpace
from laplace_core.code.interpolation import mixing
from laplace_core.experiments.paper import MEASUREMENTS, aliasing, fig1_5, fig4, fig6, measurement, table1, timescales
from laplace_core.experiments.paper.measurement import finished, measure, rows_in
from laplace_core.planning import reward_timeline
from laplace_core.study.pipeline import decode_and_read
from laplace_core.study.settings import Settings, resolve_for_gamma_space
from laplace_core.tabular.peers import return_distribution
from laplace_core.training.checkpoint import new_agent
from tests.support.jobs import measured_number, summed_numbers

ROOT = Path(__file__).parents[3]
TOY = replace(
    fig4.EXPERIMENT, name="toy", parts=[{"number": i} for i in range(5)], measure=measured_number,
    summary=summed_numbers,
)  # fmt: skip


def never() -> bool:
    return False


@pytest.mark.parametrize("processes", [1, 2])
def test_a_measurement_holds_each_part_and_does_it_once(tmp_path, processes):
    path = tmp_path / "out" / "toy.json"
    outcomes = list(measure(TOY, path, never, processes=processes))
    refused = [each.part for each in outcomes if each.row is None]
    assert refused == [{"number": 3}]
    about = json.loads(path.read_text())
    assert (about["finished"], about["planned"], about["summary"]) == (4, 5, {"sum": 0 + 1 + 4 + 16})
    assert [row["part"]["number"] for row in about["results"]] == [0, 1, 2, 4]  # in the order of the plan
    assert [each.part for each in measure(TOY, path, never)] == [{"number": 3}]


def test_a_measurement_stops_between_two_parts_and_goes_on(tmp_path):
    path, done = tmp_path / "toy.json", []
    for outcome in measure(TOY, path, lambda: len(done) == 2):
        done.append(outcome)
    assert len(rows_in(path)) == 2
    assert len(list(measure(TOY, path, never))) == 3


def test_rows_that_are_not_planned_any_more_go(tmp_path):
    path = tmp_path / "toy.json"
    list(measure(TOY, path, never))
    fewer = replace(TOY, parts=[{"number": 4}, {"number": 5}])
    assert [row["part"] for row in finished(fewer, path)] == [{"number": 4}]
    list(measure(fewer, path, never))
    assert [row["part"]["number"] for row in rows_in(path)] == [4, 5]


@pytest.mark.parametrize("content", [b"", b"[]", b"{}", b'{"results": [1]}', b'{"results": [{"part": 1}]}', b"\xff"])
def test_a_file_that_is_no_measurement_is_not_written_over(tmp_path, monkeypatch, capsys, content):
    monkeypatch.setattr(fig4, "EXPERIMENT", replace(TOY, name="fig4"))
    path = tmp_path / "fig4.json"
    path.write_bytes(content)
    assert main(["reproduce", "fig4", "--out", str(tmp_path)]) == 2
    assert "fig4.json" in capsys.readouterr().err
    assert path.read_bytes() == content


def test_the_command_lists_counts_and_measures(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(fig4, "EXPERIMENT", replace(fig4.EXPERIMENT, parts=fig4.EXPERIMENT.parts[:2]))
    words = ["reproduce", "fig4", "--out", str(tmp_path)]
    assert main([*words, "--list"]) == 0
    assert "0 of 2 parts measured" in capsys.readouterr().out
    assert main([*words, "--json"]) == 0
    rows = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [row["part"]["values"] for row in rows] == ["exact", "tabular"]
    assert main([*words, "--list", "--json"]) == 0
    (listed,) = json.loads(capsys.readouterr().out)
    assert (listed["state"], listed["measured"], listed["result"]) == ("finished", 2, str(tmp_path / "fig4.json"))
    assert main([*words, "--budget"]) == 0
    assert capsys.readouterr().out == "fig4: 2 parts, 2 of them measured\n"


@pytest.mark.parametrize("name", MEASUREMENTS)
def test_parts_differ_and_are_plain(name):
    parts = [json.dumps(part, sort_keys=True) for part in measurement(name).parts]
    assert measurement(name).name == name
    assert len(set(parts)) == len(parts)


# The numbers are those of three independent prototypes: rescaled rows repeat 5 for 14.85 and choose action 0;
# auxiliary states or rows left alone choose action 1, whose true value is 10 * .99^2 = 9.80.
def test_figure_4_is_that_of_the_prototypes():
    result = fig4.EXPERIMENT.measure({"values": "exact"})
    rescaled, left = result["plain"]["paper"], result["plain"]["none"]
    assert rescaled["expected_reward"][0] == pytest.approx([5, 5, 5], abs=5e-3)
    assert rescaled["values"] == pytest.approx([14.85, 9.74], abs=5e-3)
    assert left["values"] == pytest.approx([5.00, 9.70], abs=5e-3)
    assert result["auxiliary"]["paper"]["values"] == pytest.approx([5.00, 9.74], abs=5e-3)
    assert [each["action"] for each in (rescaled, left, *result["auxiliary"].values())] == [0, 1, 1, 1]


def test_figure_6_holds_the_whole_timeline_where_values_are_exact():
    result = fig6.EXPERIMENT.measure({"values": "exact"})
    assert result["error"] < 1e-3
    assert np.array(result["probabilities"])[:4] == pytest.approx(
        np.array([[0.5, 0, 0, 0.5], [0.5, 0, 0, 0.5], [0, 0.5, 0.5, 0], [0, 0.5, 0.5, 0]]), abs=1e-3
    )


# A coin of 0 or 1: its expectile at level t solves t (1 - e) = (1 - t) e, so e = t. Its quantiles are 0 below the
# level 1/2 and 1 above. On atoms 0, .5, 1 it stays; on atoms -.5, .5, 1.5 each side is shared by two.
def test_codes_of_a_coin():
    coin = np.array([0.0, 1.0]), np.array([0.5, 0.5])
    assert fig1_5.expectiles_of(coin, 3) == pytest.approx([0.25, 0.5, 0.75])
    assert fig1_5.quantiles_of(coin, 4)[0].tolist() == [0, 0, 1, 1]
    assert fig1_5.categorical_of(coin, np.array([0.0, 0.5, 1.0]))[1] == pytest.approx([0.5, 0, 0.5])
    assert fig1_5.categorical_of(coin, np.array([-0.5, 0.5, 1.5]))[1] == pytest.approx([0.25, 0.5, 0.25])


def test_the_aliased_states_share_their_return_and_differ_in_when_it_comes():
    world = aliasing.aliased_world()
    policy = np.zeros(world.n_states, dtype=int)
    soon, late = (return_distribution(world, state, 0, policy, gamma=aliasing.GAMMA) for state in (0, 1))
    assert soon.locations == pytest.approx(late.locations)
    assert soon.masses == pytest.approx(late.masses)
    times = [reward_timeline(world, state, policy, 8)[0][:, -2:].sum(axis=1) for state in (0, 1)]
    assert [np.flatnonzero(each).tolist() for each in times] == [[1], [6]]


# After n episodes of sure rewards a value d steps from the end holds n of them, so that its error is
# (gamma^n - gamma^d) / (1 - gamma^d): 32 steps from the end below a tenth after 3 episodes at .368, 29 at .99.
def test_sure_rewards_reach_a_value_one_step_an_episode():
    read = timescales.EXPERIMENT.measure({"rewards": "sure", "seed": 0})
    for g, gamma in enumerate(read["gammas"]):
        for left, when in read["episodes"].items():
            episodes, steps = np.arange(1, 33), int(left)
            off = (gamma ** np.minimum(episodes, steps) - gamma**steps) / (1.0 - gamma**steps)
            assert when[g] == episodes[off < timescales.NEAR][0]
    assert [read["episodes"]["32"][g] for g in (0, -1)] == [3, 29]


def test_a_value_is_accurate_once_it_stays_so():
    errors = np.array([[0.5, 0.0, 0.5], [0.05, 0.5, 0.5], [0.05, 0.05, 0.2]])
    assert timescales.first_accurate(errors, [10.0, 20.0, 30.0]).tolist() == [20.0, 30.0, np.inf]
    assert timescales.first_accurate(errors[1:, :1], [10.0, 20.0]).tolist() == [10.0]


@pytest.fixture(scope="module")
def lander():
    settings = LaplaceSettings(environment="CartPole-v1", hidden=16, features=8, thetas=9, theta_max=3.0)
    return new_agent(settings)


STARTS = range(FIRST_SEED, FIRST_SEED + 3)


def test_decoding_without_faults_acts_as_the_readout(lander):
    acting = float(lander.gammas[lander.acting_head])
    choose = table1.by_decoding(lander, acting, 20, [], alpha=0.3)
    other = RULES["readout"](lander, 20, Options(softness=table1.SOFTNESS, alpha=0.3, steps=table1.STEPS))
    ours, theirs = (played(each, "CartPole-v1", STARTS, 20) for each in (choose, other))
    np.testing.assert_array_equal(ours.returns, theirs.returns)
    observations = ours.starts
    for time in (0, 5, 19):
        np.testing.assert_array_equal(choose(observations, time), other(observations, time))


def test_decoding_with_every_fault_acts_as_the_pipeline_with_these_settings(lander):
    acting, length = float(lander.gammas[lander.acting_head]), 12
    choose = table1.by_decoding(lander, acting, length, list(table1.FAULTS), alpha=0.3)
    wanted = np.linspace(lander.gammas[0], lander.gammas[-1], table1.DISCOUNTS)
    mix = mixing(lander.gammas, wanted)
    settings = resolve_for_gamma_space(
        Settings(alpha=0.3, steps=length, normalise="paper", acting_gamma=acting, softness=0.0), wanted
    )
    observations = np.random.default_rng(0).normal(size=(20, 4)).astype(np.float32)
    values, constant = lander.gamma_spaces(observations)
    slow = []
    for each, steps in zip(values, constant, strict=True):
        space = GammaSpace(mix @ each, steps @ mix.T, wanted, lander.thetas)
        slow.append(int(decode_and_read(space, settings).actions[-1]))
    assert choose(observations, 0).tolist() == slow
    assert choose(observations, 7).tolist() == slow  # the same T at every step
    assert len(set(slow)) == 2


def test_a_row_of_table_1_can_be_made_again():
    known = {json.dumps(row["part"], sort_keys=True): row["result"] for row in rows_in(ROOT / "docs/paper/table1.json")}
    part = {"agent": "dqn_LunarLander-v3", "rule": "greedy", "horizon": 50}
    committed = np.array(known[json.dumps(part, sort_keys=True)]["returns"])
    again = np.array(table1.EXPERIMENT.measure(part)["returns"])
    assert abs(again.mean() - committed.mean()) < 2 * committed.std() / 10
