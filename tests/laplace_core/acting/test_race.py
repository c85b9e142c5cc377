"""Races to a deadline: what one is, many against one by one, and what they come to."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import replace

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image, ImageSequence

from laplace_core import load_world
from laplace_core.acting.bootstrap import interval, mean_interval
from laplace_core.acting.evaluation import FIRST_SEED
from laplace_core.acting.race import FIRST_START, MOST_RACES, MOST_START, Entrant, Race, Races, race, races
from laplace_core.acting.race_file import race_gif, race_npz, races_csv, races_npz
from laplace_core.acting.rollout import MOST_SEED
from laplace_core.agents import LaplaceSettings
from laplace_core.errors import InputError
from laplace_core.training import loop
from laplace_core.training.checkpoint import new_agent
from tests.laplace_core.acting.test_evaluation import Knowing

torch.set_num_threads(1)


@pytest.fixture(scope="module")
def knowing():
    return Knowing(load_world("two_branch"))


@pytest.fixture(scope="module")
def agent():
    """An untrained agent of CartPole whose discounts disagree."""
    return new_agent(LaplaceSettings(hidden=8, features=4, gammas=5, thetas=9, theta_max=12.0))


# two_branch pays 5 at once and ends, or 10 at the third step. Greedy at .99 values them 5 and .99^2 * 10 = 9.8 and
# waits, which within two steps pays nothing. With 2 steps to go the nearest discount is .6, and .6^2 * 10 = 3.6 < 5:
# it takes the 5. With 3 to go it is .72, and .72^2 * 10 = 5.1 > 5: it waits as well, and both have 10.
@pytest.mark.parametrize(("horizon", "left", "right", "parting"), [(2, 0.0, 5.0, 0), (3, 10.0, 10.0, None)])
def test_who_knows_the_deadline_takes_what_can_be_had(knowing, horizon, left, right, parting):
    found = race("two_branch", Entrant(knowing), Entrant(knowing, "matched"), 4, horizon=horizon)
    assert (found.left.rewards.sum(), found.right.rewards.sum()) == (left, right)
    assert (found.difference, found.parting) == (right - left, parting)
    many = races("two_branch", Entrant(knowing), Entrant(knowing, "matched"), horizon, count=3)
    assert many.differences.tolist() == [right - left] * 3


def test_sides_part_where_their_actions_differ_first(agent):
    """What follows after the shorter of two episodes is no difference of actions."""
    found = race("CartPole-v1", Entrant(agent), Entrant(agent), 0, horizon=5)
    for left, right, parting in (([0, 1, 1, 0], [0, 1, 0, 1], 2), ([1, 1], [1, 1, 0], None), ([1], [0, 1], 0)):
        sides = (replace(found.left, actions=np.array(actions)) for actions in (left, right))
        assert Race(0, 5, *sides).parting == parting


def test_another_discount_of_the_left_side_counts(knowing):
    """At a discount of .5 the 10 is worth 2.5: also the greedy side takes the 5 then."""
    short = Entrant(knowing, gamma=0.5)
    assert race("two_branch", short, Entrant(knowing), 0, horizon=3).difference == 5.0
    assert races("two_branch", short, Entrant(knowing), 3, count=2).differences.tolist() == [5.0] * 2


def test_many_races_are_one_race_from_each_start(agent):
    left, right = Entrant(agent), Entrant(agent, "fading")
    many = races("CartPole-v1", left, right, 40, count=6, first=3)
    one_by_one = [race("CartPole-v1", left, right, start, horizon=40) for start in many.starts]
    assert many.starts.tolist() == [3, 4, 5, 6, 7, 8]
    np.testing.assert_allclose(many.left, [one.left.rewards.sum() for one in one_by_one])
    np.testing.assert_allclose(many.right, [one.right.rewards.sum() for one in one_by_one])
    np.testing.assert_allclose(many.differences, [one.difference for one in one_by_one], atol=1e-9)
    assert many.left_lengths.tolist() == [len(one.left) for one in one_by_one]
    assert any(one.parting is not None for one in one_by_one)


def made(left, right, first: int = 0) -> Races:
    left, right = np.array(left, dtype=float), np.array(right, dtype=float)
    steps = np.full(len(left), 9)
    return Races("CartPole-v1", 9, first + np.arange(len(left)), left, right, steps, steps)


# Differences 1, 0, -2, 4: mean .75; deviations .25, -.75, -2.75, 3.25, their squares add to 18.75, over 3 is 2.5^2, and
# 2.5 / sqrt(4) = 1.25. Sorted -2, 0, 1, 4: the lower of the two in the middle is 0, of start 11.
def test_what_many_races_come_to():
    found = made([1, 2, 3, 4], [2, 2, 1, 8], first=10)
    told = found.summary()
    assert (told["left"], told["right"], told["difference"], told["standard_error"]) == (2.5, 3.25, 0.75, 1.25)
    assert (told["better"], told["equal"], told["worse"]) == (0.5, 0.25, 0.25)
    assert found.notable() == {"worst": 12, "median": 11, "best": 13}
    low, high = told["interval"]
    assert -2.0 <= low < 0.75 < high <= 4.0


def test_the_interval_is_that_of_one_draw_after_the_other():
    """Other random numbers: ends agree within a few hundredths of the standard error of the mean, .1 here."""
    values = np.random.default_rng(0).normal(size=100)
    np.testing.assert_allclose(mean_interval(values), interval(values[None]), atol=0.01)


def test_sums_of_the_same_rewards_in_another_order_are_equal():
    assert made([0.1 + 0.2, 1e6], [0.3, 1e6 + 1e-6]).summary()["equal"] == 1.0


@given(st.lists(st.integers(-9, 9), min_size=2, max_size=30), st.integers(-9, 9))
def test_a_lead_in_every_race_moves_the_mean_and_the_interval_by_as_much(returns, lead):
    """The drawn starts are the same, so the interval of a constant lead is that lead, and nothing else."""
    told = made(returns, np.array(returns) + lead).summary()
    assert told["difference"] == pytest.approx(lead)
    np.testing.assert_allclose(told["interval"], [lead, lead])
    assert told["better"] + told["equal"] + told["worse"] == pytest.approx(1.0)


def test_no_start_was_trained_or_chosen_on():
    last = FIRST_START + MOST_START + MOST_RACES
    assert loop._LARGEST_START <= FIRST_START
    assert last < min(loop._VALIDATION_SEED, FIRST_SEED)
    assert FIRST_START + MOST_START <= MOST_SEED  # and a rollout may be asked for each


@pytest.mark.parametrize("run", ["one", "many"])
def test_progress_is_told_to_the_end_and_can_be_stopped(agent, run):
    sides = Entrant(agent), Entrant(agent, "fading")

    def work(told):
        if run == "one":
            race("CartPole-v1", *sides, 0, horizon=30, progress=told)
        else:
            races("CartPole-v1", *sides, 30, count=120, progress=told)  # in two parts

    heard: list[tuple[int, int]] = []
    work(lambda done, of: heard.append((done, of)))
    done = [each for each, _ in heard]
    assert done == sorted(done)
    assert {of for _, of in heard} == {60 if run == "one" else 120}
    assert max(done) <= heard[0][1]

    def stop(done: int, of: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        work(stop)


def test_what_makes_no_race_is_refused(subtests, agent):
    for given_, said in [
        ({"first": -1}, "start"), ({"first": MOST_START + 1}, "start"), ({"count": 1}, "number of starts"),
        ({"count": 501}, "number of starts"), ({"horizon": 0}, "horizon"), ({"left": ("best", None)}, "rule"),
        ({"left": ("own", None)}, "fixed_horizon"), ({"left": ("matched", 0.5)}, "greedy"),
        ({"left": ("greedy", 1.5)}, "between 0 and 1"),
    ]:  # fmt: skip
        with subtests.test(given_=given_, said=said):
            rule, gamma = given_.get("left", ("greedy", None))
            sides = Entrant(agent, rule, gamma), Entrant(agent, "fading")
            with pytest.raises(InputError, match=said):
                races(
                    "CartPole-v1",
                    *sides,
                    given_.get("horizon", 5),
                    count=given_.get("count", 2),
                    first=given_.get("first", 0),
                )
            if "count" not in given_:
                with pytest.raises(InputError, match=said):
                    race("CartPole-v1", *sides, given_.get("first", 0), horizon=given_.get("horizon", 5))


def test_a_race_becomes_an_animation_of_both_sides(agent):
    """Every picture of the longer side lasts 50 ms; those that are alike are one that lasts longer."""
    one = race("CartPole-v1", Entrant(agent), Entrant(agent, "fading"), 1, horizon=12, pictures=True)
    film = Image.open(io.BytesIO(race_gif(one, ("greedy (γ 0.9)", "fading"), 0.05)))
    single = Image.open(io.BytesIO(one.left.frames[0]))
    assert film.width > 2 * single.width
    assert film.height > single.height
    shown = sum(frame.info["duration"] for frame in ImageSequence.Iterator(film))
    assert shown == 50 * max(len(one.left.frames), len(one.right.frames))
    with pytest.raises(InputError, match="no pictures"):
        race_gif(race("CartPole-v1", Entrant(agent), Entrant(agent), 1, horizon=5), ("left", "right"), 0.05)


def test_files_hold_every_return(agent):
    found = made([1.5, 2.0], [2.25, 2.0], first=7)
    rows = list(csv.DictReader(io.StringIO(races_csv(found, "greedy", "fading deadline"))))
    assert [row["start seed"] for row in rows] == [str(FIRST_START + 7), str(FIRST_START + 8)]
    assert [float(row["difference"]) for row in rows] == [0.75, 0.0]
    assert float(rows[0]["return of fading deadline"]) == 2.25
    file = np.load(io.BytesIO(races_npz(found, {"left": "greedy"})))
    np.testing.assert_array_equal(file["right"], found.right)
    assert json.loads(str(file["settings"]))["left"] == "greedy"
    one = race("CartPole-v1", Entrant(agent), Entrant(agent, "fading"), 1, horizon=12)
    file = np.load(io.BytesIO(race_npz(one)))
    np.testing.assert_array_equal(file["right_rewards"], one.right.rewards)
    assert json.loads(str(file["left_settings"]))["seed"] == FIRST_START + 1
