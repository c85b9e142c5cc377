"""Worlds: the tabular model, the presets, and gymnasium in both directions."""

import copy
import json
import pickle
import warnings
from concurrent.futures import ProcessPoolExecutor
from dataclasses import fields, replace
from multiprocessing import get_context

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from hypothesis import given

from laplace_core import PRESETS, InputError, Settings, load_world, study
from laplace_core.planning import finite_horizon_optimum, greedy_policy, state_values
from laplace_core.tabular.td import LaplaceTD, Sampler, Schedule, learn
from laplace_core.worlds import END, TOY_TEXT, Outcome, World, parse_world
from laplace_core.worlds.env import TabularEnv
from tests.support.random_worlds import worlds
from tests.support.slow_twins import dense_model, idle_for_ever


def small_world(rows=None, **changes) -> World:
    """One state: action 0 ends with reward 1 or -1, action 1 stays with reward 2."""
    rows = rows or [Outcome(0, 1, 1.0, 0, 2.0), Outcome(0, 0, 0.25, END, 1.0), Outcome(0, 0, 0.75, END, -1.0)]
    return World.from_outcomes(
        **{"name": "small", "states": ["only"], "actions": ["end", "stay"], "outcomes": rows} | changes
    )


# --- the model ---


def test_model_of_a_small_world():
    world = small_world()
    np.testing.assert_array_equal(world.reward_values, [-1.0, 1.0, 2.0])
    np.testing.assert_array_equal(world.transition_matrix.toarray(), [[0.0], [1.0]])
    np.testing.assert_array_equal(world.reward_probabilities.toarray(), [[0.75, 0.25, 0.0], [0.0, 0.0, 1.0]])
    np.testing.assert_array_equal(world.expected_reward, [[-0.5, 2.0]])
    np.testing.assert_array_equal(world.start, [1.0])
    assert world.outcomes(0, 1) == [Outcome(0, 1, 1.0, 0, 2.0)]


@given(worlds())
def test_sparse_model_equals_the_dense_one(world):
    moves, paid = dense_model(world)
    shape = (world.n_states, world.n_actions, -1)
    np.testing.assert_allclose(world.transition_matrix.toarray().reshape(shape), moves, atol=1e-15)
    np.testing.assert_allclose(world.reward_probabilities.toarray().reshape(shape), paid, atol=1e-15)
    np.testing.assert_allclose(world.expected_reward, paid @ world.reward_values, atol=1e-12)
    np.testing.assert_allclose(paid.sum(axis=2), 1.0)


def test_probabilities_that_are_off_by_rounding_are_put_right():
    world = small_world([Outcome(0, 0, 1 / 3 + 1e-8, END, 1.0)] * 3 + [Outcome(0, 1, 1.0, 0, 0.0)])
    assert world.probability[:3].sum() == pytest.approx(1.0, abs=1e-15)


def test_states_are_found_by_name_index_and_index_as_text():
    world = load_world("two_branch")
    assert [world.state_index(given) for given in ("long 1", 1, "1")] == [1, 1, 1]
    for wrong in ("nowhere", 3, -1, "-1"):
        with pytest.raises(InputError, match="two_branch"):
            world.state_index(wrong)


def test_what_is_no_mdp_is_refused(subtests):
    for changes, named in [
        ({"rows": [Outcome(0, 0, 1.0, END, 0.0)]}, "'stay'"),  # an action without outcomes
        ({"rows": [Outcome(0, a, 0.9, END, 0.0) for a in (0, 1)]}, "total probability 0.9"),
        ({"rows": [Outcome(0, a, 1.0, 1, 0.0) for a in (0, 1)]}, "leads outside"),
        ({"rows": [Outcome(1, a, 1.0, END, 0.0) for a in (0, 1)]}, "outside its 1 states"),
        ({"rows": [Outcome(0, a, p, END, 0.0) for a in (0, 1) for p in (2.0, -1.0)]}, "negative"),
        ({"rows": [Outcome(0, a, 1.0, END, float("nan")) for a in (0, 1)]}, "reward"),
        ({"rows": [Outcome(0, a, 1.0, END, 1e10) for a in (0, 1)]}, "reward"),
        ({"start": np.array([0.5])}, "start"),
        ({"states": ["END"]}, "'END'"),
        ({"actions": ["same", "same"]}, "twice"),
        ({"states": [f"s{i}" for i in range(5001)]}, "5,000"),
    ]:
        with subtests.test(named, changes=changes), pytest.raises(InputError, match=named):
            small_world(**changes)


# --- absorbing states ---


def sink_world(**changes) -> World:
    """Two ways to a sink; "hall" pays 5 on the way and "stairs" -1, and "pit" is idled in by two states in turn."""
    rows = [
        Outcome(0, 0, 1.0, 1, 0.0), Outcome(0, 1, 0.5, 2, 0.0), Outcome(0, 1, 0.5, 4, 3.0),
        Outcome(1, 0, 1.0, 3, 5.0), Outcome(1, 1, 1.0, 3, 5.0), Outcome(2, 0, 1.0, 3, -1.0), Outcome(2, 1, 1.0, 2, 0.0),
        Outcome(3, 0, 1.0, 3, 0.0), Outcome(3, 1, 1.0, 3, 0.0), Outcome(4, 0, 1.0, 5, 0.0), Outcome(4, 1, 1.0, 4, 0.0),
        Outcome(5, 0, 1.0, 4, 0.0), Outcome(5, 1, 0.5, 3, 0.0), Outcome(5, 1, 0.5, 5, 0.0),
    ]  # fmt: skip
    states = ["start", "hall", "stairs", "sink", "pit", "below"]
    return World.from_outcomes("sink", states, ["a", "b"], rows, **changes)


def test_a_state_is_absorbing_if_nothing_is_ever_paid_and_the_end_never_comes():
    world = sink_world()
    # "stairs" may stay for ever, but can also be left for a reward; "pit" and "below" only lead to each other or on.
    assert [name for name, idle in zip(world.states, world.absorbing, strict=True) if idle] == ["sink", "pit", "below"]
    assert [row.next_state for row in world.outcomes(0, 1)] == [2, 4]  # what is seen stays
    np.testing.assert_array_equal(world.following, [1, 2, END, END, END, END, 2, *[END] * 7])


def test_idle_states_before_the_end_are_none():
    assert not load_world("two_branch", {"auxiliary": True}).absorbing.any()


def test_an_outcome_without_a_chance_does_not_keep_a_state_alive():
    rows = [Outcome(0, 0, 1.0, 1, 1.0), Outcome(1, 0, 1.0, 1, 0.0), Outcome(1, 0, 0.0, END, 7.0)]
    world = World.from_outcomes("idle", ["s", "sink"], ["go"], rows)
    np.testing.assert_array_equal(world.absorbing, [False, True])


@given(worlds())
def test_absorbing_states_are_those_left_after_striking_out(world):
    assert set(np.flatnonzero(world.absorbing)) == idle_for_ever(world)


SINK = {
    "states": ["start", "short", "long", "later", "sink"], "actions": ["short", "long"],
    "transitions": [
        {"state": "start", "action": "short", "next": {"short": 1}, "reward": {"0": 1}},
        {"state": "start", "action": "long", "next": {"long": 1}, "reward": {"0": 1}},
        {"state": "short", "action": "*", "next": {"sink": 1}, "reward": {"5": 1}},
        {"state": "long", "action": "*", "next": {"later": 1}, "reward": {"0": 1}},
        {"state": "later", "action": "*", "next": {"sink": 1}, "reward": {"10": 1}},
        {"state": "sink", "action": "*", "next": {"sink": 1}, "reward": {"0": 1}},
    ],
}  # fmt: skip


def test_a_world_with_a_sink_is_studied_as_with_the_end():
    document = json.loads(json.dumps(SINK).replace('"next": {"sink": 1}', '"next": {"END": 1}'))
    ended = study(parse_world(json.dumps(document)), Settings(state="start"))
    sunk = study(parse_world(json.dumps(SINK)), Settings(state="start"))
    assert sunk.settings == ended.settings
    np.testing.assert_allclose(sunk.gamma_space.constant, ended.gamma_space.constant, rtol=1e-12)
    np.testing.assert_allclose(sunk.decoded.tau_space, ended.decoded.tau_space, atol=1e-9)
    np.testing.assert_allclose(sunk.truth.survival, ended.truth.survival)
    # Three rows hold everything: 0 and then 5, or 0, 0 and then 10.
    np.testing.assert_allclose(sunk.truth.expected_reward, [[0, 5, 0], [0, 0, 10]])
    assert sunk.decoded.expected_reward[0, 1] == pytest.approx(5.0, abs=0.25)
    assert list(sunk.decoded.actions) == [0, 0, 1]


def test_learning_and_playing_end_where_nothing_follows():
    world = sink_world()
    env = TabularEnv(world)
    env.reset(options={"state": "hall"})
    assert env.step(0) == (3, 5.0, True, False, {})
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step(0)
    assert Sampler(world, seed=0).step(1, 0) == (1, 0, 5.0, list(world.reward_values).index(5.0), END)
    progress = list(learn(world, [LaplaceTD(world, np.array([0.5, 0.9]))], Schedule(episodes=20, max_steps=50)))
    assert not progress[-1].truncated
    assert progress[-1].steps <= 20 * 50


# --- worlds as Python objects ---


def pickled(world: World) -> World:
    return pickle.loads(pickle.dumps(world))  # noqa: S301 - our own


@pytest.mark.parametrize("how", [pickled, copy.deepcopy, copy.copy])
@pytest.mark.parametrize("source", ["cliff_grid", "two_branch"])
def test_a_world_can_be_pickled_and_copied(source, how):
    world = load_world(source)
    assert world.transition_matrix.nnz  # what is cached is no hindrance
    again = how(world)
    for entry in fields(World):
        one, other = getattr(world, entry.name), getattr(again, entry.name)
        np.testing.assert_array_equal(one, other) if isinstance(one, np.ndarray) else None
        assert isinstance(one, np.ndarray) or one == other
    with pytest.raises(ValueError, match="read-only"):
        again.reward[0] = 1.0
    with pytest.raises(TypeError):
        again.suggested["alpha"] = 1.0


def test_worlds_and_studies_pass_through_a_pool_of_processes():
    world = load_world("two_branch")
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        found = pool.submit(study, world, Settings()).result()
    here = study(world, Settings())
    assert found.settings == here.settings
    np.testing.assert_array_equal(found.decoded.horizon_values, here.decoded.horizon_values)
    assert copy.deepcopy(here).truth.optimal_action.tolist() == here.truth.optimal_action.tolist()


def test_a_changed_world_is_checked_as_a_new_one(subtests):
    for changes, named in [
        ({"reward": np.array([np.nan, 0.0, 0.0])}, "reward"),
        ({"reward": np.zeros(2)}, "as long"),
        ({"reward": np.array(["1", "2", "3"])}, "reward must be a list of numbers"),
        ({"probability": np.array([0.5, 0.5, np.nan])}, "probability"),
        ({"probability": np.array([0.5, 0.4, 1.0])}, "total probability 0.9"),
        ({"next_state": np.array([0.5, 0.0, 0.0])}, "whole numbers"),
        ({"next_state": np.array([5, 0, 0])}, "leads outside"),
        ({"states": ("only", "more")}, "more"),
        ({"states": ("END",)}, "'END'"),
        ({"start": np.array([np.nan])}, "start"),
        ({"positions": np.zeros((2, 2))}, "place"),
        ({"positions": np.array([[0.0, np.inf]])}, "place"),
    ]:
        with subtests.test(named, changes=changes), pytest.raises(InputError, match=named):
            replace(small_world(), **changes)


def test_outcomes_in_any_order_make_the_same_world():
    world = sink_world()
    order = np.random.default_rng(3).permutation(world.state.size)
    columns = ("state", "action", "next_state", "probability", "reward")
    mixed = replace(world, **{name: getattr(world, name)[order] for name in columns})
    np.testing.assert_array_equal(mixed.transition_matrix.toarray(), world.transition_matrix.toarray())
    np.testing.assert_array_equal(mixed.expected_reward, world.expected_reward)
    assert {row[2:] for row in mixed.outcomes(0, 1)} == {row[2:] for row in world.outcomes(0, 1)}


# --- presets ---


@pytest.mark.parametrize("auxiliary", [False, True])
@pytest.mark.parametrize(("length", "r1", "r2"), [(3, 5.0, 10.0), (1, 5.0, 10.0), (8, 5.0, 5.2), (4, 9.0, 10.0)])
def test_two_branch_attains_its_declared_optimum(length, r1, r2, auxiliary):
    # r1 is paid at once and r2 as the reward number length - 1: r1 for T < length, else max(r1, g^(length-1) r2).
    world = load_world("two_branch", {"length": length, "r1": r1, "r2": r2, "auxiliary": auxiliary})
    gamma = 0.9
    expected = [max(r1, gamma ** (length - 1) * r2) if length <= T else r1 for T in range(1, 12)]
    np.testing.assert_allclose(finite_horizon_optimum(world, 11, gamma, 0).max(axis=1), expected)


def test_auxiliary_states_make_both_branches_equally_long():
    # length - 1 waiting states on the long branch, and as many idle ones on the short branch.
    assert load_world("two_branch", {"length": 4}).n_states == 1 + 3
    assert load_world("two_branch", {"length": 4, "auxiliary": True}).n_states == 1 + 3 + 3


def test_slip_swaps_the_branches():
    world = load_world("two_branch", {"slip": 0.2})
    # With the chance .2 the other branch: .8 * 5 now on the first action, .2 * 5 on the second.
    np.testing.assert_allclose(world.expected_reward[0], [4.0, 1.0])
    np.testing.assert_allclose(world.transition_matrix.toarray()[:2, 1], [0.2, 0.8])


def test_two_decisions_weighs_leaving_against_the_branch_behind_it():
    # Leave: r0 = 4 at once. Go on: the branch's optimum, one step later and one step less to go.
    gamma = 0.9
    branch = [0.0] + [5.0 if T < 3 else max(5.0, gamma**2 * 10.0) for T in range(1, 8)]
    optimum = finite_horizon_optimum(load_world("two_decisions"), 8, gamma, 0)
    np.testing.assert_allclose(optimum, [[4.0, gamma * later] for later in branch])


def test_fig6_chain_pays_plus_and_minus_with_equal_chances():
    world = load_world("fig6_chain")
    values = list(world.reward_values)
    assert values == [-2.0, -1.0, 1.0, 2.0]
    expected = [[0.5, 0, 0, 0.5]] * 2 + [[0, 0.5, 0.5, 0]] * 2
    np.testing.assert_allclose(world.reward_probabilities.toarray(), expected)
    np.testing.assert_allclose(finite_horizon_optimum(world, 6, 0.9, 0), 0.0, atol=1e-15)


@pytest.mark.parametrize("p_early", [0.0, 0.3, 1.0])
def test_double_chain_pays_early_or_late_by_chance(p_early):
    # E = p g^2 .6 from T = 3 on, and (1 - p) g^6 1. more from T = 7 on.
    gamma = 0.9
    optimum = finite_horizon_optimum(load_world("double_chain", {"p_early": p_early}), 9, gamma, 0)[:, 0]
    early, late = p_early * gamma**2 * 0.6, (1 - p_early) * gamma**6
    np.testing.assert_allclose(optimum, [0, 0, early, early, early, early, *[early + late] * 3], atol=1e-15)


def test_rise_and_fade_rises_stays_and_fades():
    # Knots at 0, 2, 4, 6 of seven steps: -1 up to 2 in two steps, 2 for two, down to 0 in two.
    world = load_world("rise_and_fade", {"length": 7})
    np.testing.assert_allclose(world.expected_reward[:, 0], [-1.0, 0.5, 2.0, 2.0, 2.0, 1.0, 0.0])
    optimum = finite_horizon_optimum(world, 7, 0.9, 0)[-1, 0]
    assert optimum == pytest.approx(-1 + 0.45 + 2 * (0.81 + 0.729 + 0.6561) + 0.59049)


def test_discounting_chain_changes_its_best_action_after_the_horizon_100():
    # A delay of n is paid as reward number n, so it counts from T = n + 1 on: .99^1 = .99 (up to T = 100)
    # against 3 * .99^100 = 1.098.
    optimum = finite_horizon_optimum(load_world("discounting_chain"), 105, 0.99, 0)
    best = optimum.argmax(axis=1)
    assert set(best[:100]) == {0}
    assert set(best[100:]) == {4}
    np.testing.assert_allclose(optimum[[1, 3, 10, 30], [0, 1, 2, 3]], [0.99, 0.99**3, 0.99**10, 0.99**30])
    assert optimum[100, 4] == pytest.approx(3 * 0.99**100)


@pytest.mark.parametrize(("width", "height"), [(6, 4), (3, 2), (4, 3)])
def test_cliff_grid_reaches_its_goal_by_the_shortest_way(width, height):
    # One step up, width - 1 to the right, one down: n = width + 1 steps, each at -.2, and 10 with the last.
    # With less to go the best is to stay off the cliff and pay for the steps only.
    gamma, n = 0.9, width + 1
    world = load_world("cliff_grid", {"width": width, "height": height})
    assert world.n_states == width * (height - 1) + 1
    price = np.array([-0.2 * (1 - gamma**T) / (1 - gamma) for T in range(1, n + 3)])
    expected = [*price[: n - 1], *[price[n - 1] + 10 * gamma ** (n - 1)] * 3]
    np.testing.assert_allclose(finite_horizon_optimum(world, n + 2, gamma, 0).max(axis=1), expected)


def test_cliff_grid_slips_to_either_side():
    # From the start, "up" slides right into the cliff or left into the wall with chance slip / 2 each.
    world = load_world("cliff_grid", {"slip": 0.4})
    falls = [row.probability for row in world.outcomes(0, 0) if row.next_state == END]
    stays = [row.probability for row in world.outcomes(0, 0) if row.next_state == 0]
    assert falls == stays == [pytest.approx(0.2)]


def test_parameters_are_parsed_and_refused_by_name():
    assert load_world("two_branch", {"length": "5", "auxiliary": "true"}).n_states == 9
    for params, named in [({"lenght": 3}, "lenght"), ({"length": 2.5}, "length"), ({"slip": 0.6}, "slip")]:
        with pytest.raises(InputError, match=named):
            load_world("two_branch", params)
    with pytest.raises(InputError, match="none of"):
        load_world("no_such_world")


# --- gymnasium ---


@pytest.mark.parametrize("name", PRESETS)
def test_gymnasium_accepts_every_preset(name):
    with warnings.catch_warnings():
        warnings.filterwarnings("error", category=UserWarning)
        # Only registered environments can be made again in every render mode; ours are not registered.
        warnings.filterwarnings("ignore", message=".*alternative render modes.*")
        check_env(TabularEnv(load_world(name)))


_SLIPPERY = {"two_branch": {"slip": 0.3}, "two_decisions": {"slip": 0.3}, "cliff_grid": {"width": 3, "slip": 0.4}}


@pytest.mark.parametrize("name", PRESETS)
def test_sampled_steps_follow_the_model(name):
    # Pairs with a single outcome must give just that; the others, frequencies within 5 standard errors.
    world, draws = load_world(name, _SLIPPERY.get(name)), 400
    env = TabularEnv(world)
    env.reset(seed=1)
    for state in range(world.n_states):
        for action in range(world.n_actions):
            expected: dict[tuple, float] = {}
            for row in world.outcomes(state, action):
                ended = row.next_state == END
                seen = (state if ended else row.next_state, row.reward, ended)
                expected[seen] = expected.get(seen, 0.0) + row.probability
            counts = dict.fromkeys(expected, 0)
            n = draws if len(expected) > 1 else 2
            for _ in range(n):
                env.reset(options={"state": state})
                observation, reward, ended, truncated, _ = env.step(action)
                counts[observation, reward, ended] += 1  # a KeyError is an outcome that cannot happen
                assert not truncated
            for seen, p in expected.items():
                assert abs(counts[seen] / n - p) <= 5 * np.sqrt(p * (1 - p) / n) + 1e-12


class Draw:
    """Stands in for a random generator and always draws the same number."""

    def __init__(self, number: float):
        self.random = lambda: number


@pytest.mark.parametrize(("number", "reward"), [(0.0, 1), (0.25, 3), (0.75, 5), (np.nextafter(1.0, 0.0), 5)])
def test_an_outcome_without_a_chance_is_never_drawn(number, reward):
    chances = [0.0, 0.25, 0.0, 0.5, 0.0, 0.25]
    world = small_world([Outcome(0, a, p, END, float(i)) for a in (0, 1) for i, p in enumerate(chances)])
    env = TabularEnv(world)
    env.reset(seed=0)
    env.np_random = Draw(number)
    assert env.step(1)[1] == reward


def test_first_states_follow_the_start_distribution():
    world = small_world(
        [Outcome(s, a, 1.0, END, 0.0) for s in (0, 1) for a in (0, 1)], states=["a", "b"], start=np.array([0.25, 0.75])
    )
    env = TabularEnv(world, render_mode="ansi")
    env.reset(seed=3)
    mean = np.mean([env.reset()[0] for _ in range(2000)])
    assert mean == pytest.approx(0.75, abs=4 * np.sqrt(0.25 * 0.75 / 2000))
    assert env.render() in ("a", "b")
    env.step(0)
    assert env.render() == "END"
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step(0)


TABLES = [
    *((name, {}) for name in TOY_TEXT),
    ("FrozenLake-v1", {"is_slippery": False}),
    ("FrozenLake-v1", {"success_rate": 0.8}),
    ("FrozenLake8x8-v1", {"success_rate": 1.0}),
    ("CliffWalking-v1", {"is_slippery": True}),
    ("Taxi-v4", {"is_rainy": True}),
    ("Taxi-v4", {"is_rainy": True, "rainy_probability": 0.5}),
]


def test_toy_text_worlds_hold_gymnasiums_own_table(subtests):
    for name, options in TABLES:
        with subtests.test(name=name, options=options):
            world = load_world(f"gym:{name}", options)
            env = gymnasium.make(name, **options).unwrapped
            assert (world.n_states, world.n_actions) == (env.observation_space.n, env.action_space.n)
            np.testing.assert_allclose(world.start, env.initial_state_distrib)
            moves, paid = dense_model(world)
            values = list(world.reward_values)
            for s in range(world.n_states):
                for a in range(world.n_actions):
                    for p, successor, reward, ended in env.P[s][a]:
                        paid[s, a, values.index(reward)] -= p
                        if not ended:
                            moves[s, a, successor] -= p
            assert np.abs(paid).max() < 1e-12
            assert np.abs(moves).max() < 1e-12


@pytest.mark.parametrize("rain", [False, True])
def test_a_fickle_passenger_rides_as_in_gymnasium(rain):
    # One step from every state with him aboard and some without: what gymnasium's step() may do there, if he has made
    # up his mind at the start to change it (fickle_step), with chance 1 here.
    env = gymnasium.make("Taxi-v4", fickle_passenger=True, is_rainy=rain).unwrapped
    options = {"fickle_passenger": True, "fickle_probability": 1.0, "is_rainy": rain}
    world = load_world("gym:Taxi-v4", options)
    assert world.states[:500] == load_world("gym:Taxi-v4").states
    env.reset(seed=0)
    rng = np.random.default_rng(0)
    aboard = [s for s in range(500) if env.decode(s)[2] == 4]
    for s in [*rng.choice(aboard, 8, replace=False).tolist(), *rng.choice(500, 4, replace=False).tolist()]:
        for a in range(6):
            for settled in (False, True):
                seen = set()
                for _ in range(500 if rain else 40):
                    env.s, env.fickle_step = s, not settled
                    observation, reward, over, _, _ = env.step(a)
                    seen.add((END if over else observation + (0 if env.fickle_step else 500), reward))
                rows = world.outcomes(s + 500 * settled, a)
                assert {(row.next_state, row.reward) for row in rows if row.probability > 0} == seen


def test_the_value_of_a_fickle_taxi_is_what_gymnasium_pays():
    # The policy of the world without fickleness, played in gymnasium's own environment. Its mean discounted return
    # over 4,000 starts is 6.787 +- .050 (seeds 0 to 3,999); the world without fickleness has 6.327.
    policy = greedy_policy(load_world("gym:Taxi-v4"), 0.99)
    world = load_world("gym:Taxi-v4", {"fickle_passenger": True})
    exact = world.start @ state_values(world, np.tile(policy, 2), 0.99)
    env = gymnasium.make("Taxi-v4", fickle_passenger=True).unwrapped
    returns = []
    for seed in range(2000):
        state, discounted = env.reset(seed=seed)[0], 0.0
        for time in range(200):
            state, reward, over, _, _ = env.step(int(policy[state]))
            discounted += 0.99**time * reward
            if over:
                break
        returns.append(discounted)
    assert exact == pytest.approx(np.mean(returns), abs=3.5 * np.std(returns) / np.sqrt(len(returns)))
    assert exact == pytest.approx(6.787, abs=3 * 0.050)


@pytest.mark.parametrize(
    ("name", "params", "needed"),
    [
        ("FrozenLake-v1", {"is_slippery": False, "success_rate": 0.9}, "is_slippery"),
        ("Taxi-v4", {"rainy_probability": 0.9}, "is_rainy"),
        ("Taxi-v4", {"fickle_probability": 0.9}, "fickle_passenger"),
    ],
)
def test_a_parameter_that_would_be_ignored_is_refused(name, params, needed):
    with pytest.raises(InputError, match=f"changes nothing without {needed}"):
        load_world(f"gym:{name}", params)


def test_toy_text_names_are_a_fixed_list():
    assert load_world("gym:FrozenLake").name == "gym:FrozenLake-v1"
    with pytest.raises(InputError, match="not one of"):
        load_world("gym:LunarLander-v3")
