"""Exact gamma-spaces, policies, timelines and optima, each against a slow twin."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import PRESETS, InputError, load_world
from laplace_core.code.encoding import activation
from laplace_core.planning import (
    check_policy,
    finite_horizon_optimum,
    greedy_policy,
    proxy_gamma_space,
    reward_indicator_basis,
    reward_timeline,
    state_values,
    target_policies,
    value_of_rule,
)
from laplace_core.worlds import Outcome, World
from tests.support.random_worlds import discounts, policies, renamed, worlds, worlds_with_policy
from tests.support.slow_twins import (
    assert_mean_agrees,
    best_by_recursion,
    dense_gamma_space,
    rule_by_recursion,
    sampled_rewards,
    timeline_by_paths,
    value_iteration,
)

GAMMAS = np.array([0.05, 0.5, 0.9, 0.99])


def bases(world, gammas, given, every=1) -> np.ndarray:
    """W of every state, or of every n-th, ``(S, A, G, V)``."""
    return np.array([reward_indicator_basis(world, s, gammas, given) for s in range(0, world.n_states, every)])


def thetas_around(world, count=5) -> np.ndarray:
    return np.linspace(world.reward_values[0] - 1, world.reward_values[-1] + 1, count)


# --- gamma-space ---


@pytest.mark.parametrize("slip", [0.0, 0.3])
def test_two_branch_in_closed_form(slip):
    # Short: 5 now. Long: 0 now, 0 next, 10 as the third, so 1 + g zeros and g^2 tens. With the chance p of a
    # slip each action is a mixture of both.
    world = load_world("two_branch", {"slip": slip})
    assert list(world.reward_values) == [0.0, 5.0, 10.0]
    basis = reward_indicator_basis(world, 0, GAMMAS, [np.zeros(3, dtype=int)] * 4)
    short = np.stack([0 * GAMMAS, 0 * GAMMAS + 1, 0 * GAMMAS], axis=1)
    long = np.stack([1 + GAMMAS, 0 * GAMMAS, GAMMAS**2], axis=1)
    expected = [(1 - slip) * short + slip * long, (1 - slip) * long + slip * short]
    np.testing.assert_allclose(basis, expected, atol=1e-14)


def test_double_chain_in_closed_form():
    # With the chance p: zeros at steps 0, 1 and .6 at step 2; else zeros at steps 0 to 5 and 1 at step 6.
    p, g = 0.3, GAMMAS
    world = load_world("double_chain", {"p_early": p})
    basis = reward_indicator_basis(world, 0, g, [np.zeros(9, dtype=int)] * 4)[0]
    zeros = p * (1 + g) + (1 - p) * (1 - g**6) / (1 - g)
    np.testing.assert_allclose(basis, np.stack([zeros, p * g**2, (1 - p) * g**6], axis=1), atol=1e-13)


def test_a_world_that_never_ends_counts_one_over_one_minus_gamma():
    # A wait that is paid 2 at every step: sum of g^tau = 1 / (1 - g) such rewards.
    world = World.from_outcomes("wait", ["s"], ["a"], [Outcome(0, 0, 1.0, 0, 2.0)])
    basis = reward_indicator_basis(world, 0, GAMMAS, [np.array([0])] * 4)
    np.testing.assert_allclose(basis[0, :, 0], 1 / (1 - GAMMAS))


def test_gamma_space_of_presets_equals_a_dense_solve(subtests):
    for kind in ["shared", "per_gamma"]:
        for name in PRESETS:
            with subtests.test(kind=kind, name=name):
                world = load_world(
                    name, {"slip": 0.3} if any(p.name == "slip" for p in PRESETS[name].parameters) else None
                )
                given = target_policies(world, GAMMAS, kind, 0.99)
                channels = activation(world.reward_values, thetas_around(world), 3.0)
                every = 1 + world.n_states // 25
                fast = bases(world, GAMMAS, given, every) @ channels
                slow = dense_gamma_space(world, channels, GAMMAS, given)[::every]
                np.testing.assert_allclose(fast, slow, rtol=0, atol=1e-9)


@given(worlds_with_policy(), discounts)
def test_gamma_space_of_random_worlds_equals_a_dense_solve(world_and_policy, gammas):
    world, policy = world_and_policy
    channels = activation(world.reward_values, thetas_around(world), 3.0)
    fast = bases(world, gammas, [policy] * len(gammas)) @ channels
    slow = dense_gamma_space(world, channels, gammas, [policy] * len(gammas))
    np.testing.assert_allclose(fast, slow, rtol=0, atol=1e-9)


@given(st.data())
def test_every_discount_follows_its_own_policy(data):
    world = data.draw(worlds())
    given = data.draw(st.lists(policies(world), min_size=4, max_size=4))
    fast = bases(world, GAMMAS, given)
    identity = np.eye(world.reward_values.size)
    np.testing.assert_allclose(fast, dense_gamma_space(world, identity, GAMMAS, given), rtol=0, atol=1e-9)


SAMPLED = [
    ("two_branch", {"slip": 0.3}),
    ("fig6_chain", {}),
    ("double_chain", {"p_early": 0.3}),
    ("cliff_grid", {"width": 4, "height": 3, "slip": 0.2}),
]


@pytest.mark.parametrize(("name", "params"), SAMPLED)
def test_gamma_space_and_timeline_agree_with_sampled_episodes(name, params):
    world = load_world(name, params)
    gammas, policy = np.array([0.3, 0.8, 0.95]), greedy_policy(world, 0.95)
    channels = activation(world.reward_values, thetas_around(world), 3.0)
    exact = reward_indicator_basis(world, 0, gammas, [policy] * 3) @ channels
    for action in range(world.n_actions):
        rewards = sampled_rewards(world, 0, action, policy, count=2000, seed=10 + action)
        happened = (rewards[:, :, None] == world.reward_values).astype(float)  # NaN, the end, equals nothing
        powers = gammas[:, None] ** np.arange(rewards.shape[1])
        assert_mean_agrees(np.einsum("ntv,vh,gt->ngh", happened, channels, powers), exact[action])
        timeline = reward_timeline(world, 0, policy, rewards.shape[1])
        assert_mean_agrees(happened, timeline[action])


@given(worlds_with_policy(), discounts)
def test_proxy_in_all_states_equals_the_basis_state_by_state(world_and_policy, gammas):
    world, policy = world_and_policy
    proxy = np.sin(world.reward_values)  # any number a reward will do
    fast = proxy_gamma_space(world, proxy, gammas, [policy] * len(gammas))
    np.testing.assert_allclose(fast, bases(world, gammas, [policy] * len(gammas)) @ proxy, rtol=0, atol=1e-9)


@given(worlds_with_policy(), discounts)
def test_gamma_space_never_rises_with_theta(world_and_policy, gammas):
    world, policy = world_and_policy
    channels = activation(world.reward_values, thetas_around(world, 30), 3.0)
    values = bases(world, gammas, [policy] * len(gammas)) @ channels
    assert np.all(np.diff(values, axis=-1) <= 1e-12)


@given(st.data())
def test_renaming_states_changes_nothing(data):
    world, policy = data.draw(worlds_with_policy())
    order = data.draw(st.permutations(range(world.n_states)))
    other = renamed(world, order)
    np.testing.assert_array_equal(greedy_policy(other, 0.9)[order], greedy_policy(world, 0.9))
    carried = policy[np.argsort(order)]
    before = bases(world, GAMMAS, [policy] * 4)
    np.testing.assert_allclose(bases(other, GAMMAS, [carried] * 4)[order], before, rtol=0, atol=1e-9)


def test_one_policy_a_discount_is_required():
    world = load_world("two_branch")
    with pytest.raises(InputError, match="1 policies for 4 discounts"):
        reward_indicator_basis(world, 0, GAMMAS, [np.zeros(3, dtype=int)])
    for wrong in ([0.5, 1.0], [0.0, 0.5], [[0.5]], []):
        with pytest.raises(InputError, match="discounts"):
            proxy_gamma_space(world, world.reward_values, np.array(wrong), [np.zeros(3, dtype=int)] * len(wrong))


# --- policies ---


@given(worlds(), st.sampled_from([0.1, 0.5, 0.9]))
def test_greedy_policy_is_that_of_value_iteration(world, gamma):
    q, policy = value_iteration(world, gamma), greedy_policy(world, gamma)
    for s, chosen in enumerate(policy):
        assert q[s, chosen] >= q[s].max() - 1e-8
        # An equally good action of a lower index would have been taken instead.
        assert np.all(q[s, :chosen] < q[s].max() - 1e-10)
    np.testing.assert_allclose(state_values(world, policy, gamma), q.max(axis=1), atol=1e-8)


@given(worlds(max_states=3, max_actions=3))
def test_no_deterministic_policy_beats_the_greedy_one(world):
    best = np.full(world.n_states, -np.inf)
    for actions in itertools.product(range(world.n_actions), repeat=world.n_states):
        best = np.maximum(best, state_values(world, np.array(actions), 0.9))
    np.testing.assert_allclose(state_values(world, greedy_policy(world, 0.9), 0.9), best, atol=1e-9)


@given(worlds_with_policy())
def test_state_values_are_the_mean_of_the_rewards_own_gamma_space(world_and_policy):
    world, policy = world_and_policy
    q = dense_gamma_space(world, world.reward_values[:, None], [0.9], [policy])[:, :, 0, 0]
    expected = q[np.arange(world.n_states), policy] if policy.ndim == 1 else (policy * q).sum(axis=1)
    np.testing.assert_allclose(state_values(world, policy, 0.9), expected, atol=1e-9)


@given(worlds())
def test_greedy_policy_does_not_depend_on_where_it_starts(world):
    last = np.full(world.n_states, world.n_actions - 1)
    np.testing.assert_array_equal(greedy_policy(world, 0.9, last), greedy_policy(world, 0.9))


def test_equal_actions_give_way_to_the_first_wherever_it_starts():
    world = World.from_outcomes("equal", ["s"], ["0", "1"], [Outcome(0, a, 1.0, 0, 1.0) for a in (0, 1)])
    np.testing.assert_array_equal(greedy_policy(world, 0.9, np.array([1])), [0])


def test_greedy_policy_is_optimal_at_the_largest_discount():
    # From A to B and back pays 4 + 3.3, by C and back 3.9 + 3.7 if action 1 is taken in C and 3.9 + 3 if not.
    paid = [(4.0, 1), (3.9, 2), (3.3, 0), (3.3, 0), (3.0, 0), (3.7, 0)]
    rows = [Outcome(i // 2, i % 2, 1.0, to, reward) for i, (reward, to) in enumerate(paid)]
    world = World.from_outcomes("three", ["A", "B", "C"], ["0", "1"], rows)
    np.testing.assert_array_equal(greedy_policy(world, 0.999999), [1, 0, 1])
    # The gain of a third a step is small beside values of millions, also for who starts from the wrong policy.
    np.testing.assert_array_equal(greedy_policy(world, 0.999999, np.zeros(3, dtype=int)), [1, 0, 1])


def test_two_decisions_change_at_two_discounts(subtests):
    for gamma, first, branch in [(0.70, 0, 0), (0.72, 0, 1), (0.73, 0, 1), (0.74, 1, 1), (0.99, 1, 1)]:
        with subtests.test(gamma=gamma, first=first, branch=branch):
            # At the branch 10 g^2 > 5 for g > .7071. Before it, going on is worth g * max(5, 10 g^2), which exceeds
            # r0 = 4 for g > .4^(1/3) = .7368.
            policy = greedy_policy(load_world("two_decisions"), gamma)
            assert (policy[0], policy[1]) == (first, branch)


def test_target_policies_are_shared_or_one_a_discount():
    world, gammas = load_world("two_decisions"), np.array([0.7, 0.72, 0.99])
    shared = target_policies(world, gammas, "shared", 0.72)
    assert [list(policy[:2]) for policy in shared] == [[0, 1]] * 3
    own = target_policies(world, gammas, "per_gamma", 0.72)
    assert [list(policy[:2]) for policy in own] == [[0, 0], [0, 1], [1, 1]]
    with pytest.raises(InputError, match="policy"):
        target_policies(world, gammas, "greedy", 0.72)


def test_given_policies_are_checked():
    world = load_world("two_branch")
    assert check_policy(world, np.array([0, 1, 1])).dtype.kind == "i"
    np.testing.assert_array_equal(check_policy(world, np.full((3, 2), 0.5)), np.full((3, 2), 0.5))
    above, negative = np.full((3, 2), 0.6), np.array([[1.5, -0.5]] * 3)
    for wrong in (np.array([0, 1]), np.array([0, 1, 2]), np.array([0.0, 1.0, 0.0]), above, negative):
        with pytest.raises(InputError, match="policy"):
            check_policy(world, wrong)


# --- what really happens ---


@given(worlds_with_policy(max_states=3), st.integers(0, 2))
def test_timeline_equals_a_walk_over_every_path(world_and_policy, state):
    world, policy = world_and_policy
    state = min(state, world.n_states - 1)
    timeline = reward_timeline(world, state, policy, 4)
    for action in range(world.n_actions):
        slow = timeline_by_paths(world, state, action, policy, steps=4)
        np.testing.assert_allclose(timeline[action], slow, atol=1e-12)


@given(worlds_with_policy())
def test_true_survival_starts_at_one_and_never_rises(world_and_policy):
    survival = reward_timeline(world_and_policy[0], 0, world_and_policy[1], 12).sum(axis=2)
    np.testing.assert_allclose(survival[:, 0], 1.0)
    assert np.all(np.diff(survival, axis=1) <= 1e-12)
    assert np.all(survival >= 0)


@given(worlds(max_states=3, max_actions=2))
def test_finite_horizon_optimum_equals_trying_everything(world):
    optimum = finite_horizon_optimum(world, 4, 0.9)
    for horizon, s, a in np.ndindex(4, world.n_states, world.n_actions):
        assert optimum[horizon, s, a] == pytest.approx(
            best_by_recursion(world, s, a, horizon + 1, gamma=0.9), abs=1e-12
        )
    for s in range(world.n_states):
        np.testing.assert_array_equal(finite_horizon_optimum(world, 4, 0.9, s), optimum[:, s])


@given(st.data())
def test_value_of_a_rule_equals_following_it(data):
    world = data.draw(worlds(max_states=4))
    size = 4 * world.n_states
    chosen = data.draw(st.lists(st.integers(0, world.n_actions - 1), min_size=size, max_size=size))
    rule = np.array(chosen).reshape(4, world.n_states)
    values = value_of_rule(world, rule, 0.9)
    for horizon, s in np.ndindex(4, world.n_states):
        assert values[horizon, s] == pytest.approx(rule_by_recursion(world, rule, s, horizon + 1, gamma=0.9), abs=1e-12)
