"""Worlds: the tabular model, the presets, and gymnasium in both directions."""

import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from hypothesis import given

from laplace_core import PRESETS, InputError, load_world
from laplace_core.learning import finite_horizon_optimum
from laplace_core.worlds import END, TOY_TEXT, Outcome, World, parameters_of
from laplace_core.worlds.env import TabularEnv
from tests.random_worlds import worlds
from tests.slow_twins import dense_model


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


@pytest.mark.parametrize(
    ("changes", "named"),
    [
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
    ],
)
def test_what_is_no_mdp_is_refused(changes, named):
    with pytest.raises(InputError, match=named):
        small_world(**changes)


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


@pytest.mark.parametrize("name", TOY_TEXT)
@pytest.mark.parametrize("flipped", [False, True])
def test_toy_text_worlds_hold_gymnasiums_own_table(name, flipped):
    # With every option at its default, and with every option the other way round.
    options = {p.name: p.default ^ flipped for p in parameters_of(f"gym:{name}")}
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


def test_toy_text_names_are_a_fixed_list():
    assert load_world("gym:FrozenLake").name == "gym:FrozenLake-v1"
    with pytest.raises(InputError, match="not one of"):
        load_world("gym:LunarLander-v3")
