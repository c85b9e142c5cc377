"""Distributions of the return: the independent-steps one against enumeration, distances, bounds and the codes."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import wasserstein_distance

from laplace_core import InputError, Settings, load_world
from laplace_core.planning import greedy_policy
from laplace_core.tabular import (
    CODES,
    Learning,
    LearnSettings,
    independent_steps_return,
    return_bounds,
    return_distributions,
    study_of,
    wasserstein,
)
from laplace_core.tabular.marginals import marginals
from laplace_core.tabular.peers import return_distribution


def enumerated(tau_space, midpoints, discounts) -> dict[float, float]:
    """Every combination of what each step may pay, nothing included."""
    steps = []
    for row, discount in zip(marginals(tau_space, midpoints), discounts, strict=True):
        paid = [(discount * reward, mass) for reward, mass in zip(midpoints, row, strict=True)]
        steps.append([*paid, (0.0, 1.0 - row.sum())])
    law: dict[float, float] = {}
    for combination in itertools.product(*steps):
        total = round(sum(reward for reward, _ in combination), 9)
        law[total] = law.get(total, 0.0) + float(np.prod([mass for _, mass in combination]))
    return law


@given(seed=st.integers(0, 10_000), steps=st.integers(1, 4), scale=st.sampled_from([0.5, 1.0, 1.6]))
def test_independent_steps_equal_their_enumeration(seed, steps, scale):
    rng = np.random.default_rng(seed)
    midpoints = np.sort(rng.integers(-8, 9, 3) / 4 + np.array([0.0, 0.01, 0.02]))
    tau_space = rng.dirichlet(np.ones(3), steps) * scale - 0.05  # some rows above 1, some masses below 0
    discounts = 0.9 ** np.arange(steps)
    locations, masses = independent_steps_return(tau_space, midpoints, discounts)
    law = enumerated(tau_space, midpoints, discounts)
    assert masses.sum() == pytest.approx(1.0)
    assert np.all(np.diff(locations) > 0)
    wanted = np.array(list(law)), np.array(list(law.values()))
    assert wasserstein((locations, masses), wanted) < 1e-8


def test_many_steps_keep_their_mean_and_stay_few():
    rng = np.random.default_rng(0)
    tau_space, midpoints = rng.dirichlet(np.ones(40), 60) * 0.9, np.linspace(-1, 3, 40)
    discounts = 0.97 ** np.arange(60)
    locations, masses = independent_steps_return(tau_space, midpoints, discounts, most=500)
    assert locations.size <= 500
    mean, square = (tau_space @ midpoints) @ discounts, (tau_space @ midpoints**2) @ discounts**2
    variance = square - ((tau_space @ midpoints) ** 2) @ discounts**2
    assert locations @ masses == pytest.approx(mean, rel=1e-9)
    assert masses @ (locations - mean) ** 2 == pytest.approx(variance, rel=0.01)


def test_rare_large_rewards_do_not_widen_the_grid_for_the_rest():
    """Small rewards of many steps, and at each a chance of 1e-6 of +-135: independent, so that variances add up.

    Merging to cells of the whole range after every step, as an earlier version did, loses half of it.
    """
    rng, midpoints = np.random.default_rng(1), np.linspace(-135, 135, 113)
    near = np.abs(midpoints) < 9
    tau_space = np.full((400, 113), 1e-6)
    tau_space[:, near] = 0.9 * rng.dirichlet(np.ones(near.sum()), 400)
    discounts = 0.99 ** np.arange(400)
    locations, masses = independent_steps_return(tau_space, midpoints, discounts)
    assert locations.size <= 2_000
    mean = discounts @ (tau_space @ midpoints)
    variance = discounts**2 @ (tau_space @ midpoints**2 - (tau_space @ midpoints) ** 2)
    assert locations @ masses == pytest.approx(mean, abs=1e-3)
    assert masses @ (locations - mean) ** 2 == pytest.approx(variance, rel=0.01)


def test_the_grid_says_what_adding_exactly_does():
    rng = np.random.default_rng(2)
    tau_space, midpoints, discounts = rng.dirichlet(np.ones(5), 5) * 0.8, rng.normal(size=5), 0.9 ** np.arange(5)
    exact = independent_steps_return(tau_space, midpoints, discounts, most=10_000)  # 6^5 = 7,776 combinations
    grid = independent_steps_return(tau_space, midpoints, discounts, most=7_000)
    assert exact[0].size > 7_000 >= grid[0].size
    assert wasserstein(exact, grid) < 5 * 0.0059 / 2  # each of 5 steps shares a reward between points .0059 apart


def test_a_row_of_nothing_pays_nothing():
    locations, masses = independent_steps_return(np.array([[0.0, 0.0], [-0.1, 0.0]]), np.array([1.0, 2.0]), np.ones(2))
    assert (locations.tolist(), masses.tolist()) == ([0.0], [1.0])


@given(seed=st.integers(0, 10_000))
def test_the_distance_is_that_of_scipy(seed):
    rng = np.random.default_rng(seed)
    first, second = ((rng.integers(-5, 6, n) / 2, rng.random(n) + 0.01) for n in rng.integers(1, 8, 2))
    wanted = wasserstein_distance(first[0], second[0], first[1], second[1])
    assert wasserstein(first, second) == pytest.approx(wanted, abs=1e-12)


@pytest.mark.parametrize(
    ("name", "params", "gamma"),
    [
        ("fig6_chain", {}, 0.99),
        ("double_chain", {}, 0.9),
        ("two_decisions", {"slip": 0.2}, 0.99),
        ("cliff_grid", {}, 0.9),
    ],
)
def test_bounds_are_the_ends_of_the_true_distributions(name, params, gamma):
    world = load_world(name, params)
    policy = greedy_policy(world, 0.99)
    low, high = return_bounds(world, policy, gamma)
    ends = [
        (law.locations[0], law.locations[-1])
        for s, a in itertools.product(range(world.n_states), range(world.n_actions))
        for law in [return_distribution(world, s, a, policy, gamma=gamma)]
    ]
    assert low == pytest.approx(min(least for least, _ in ends), abs=1e-5)
    assert high == pytest.approx(max(most for _, most in ends), abs=1e-5)


def test_bounds_of_a_world_that_never_ends_hold_what_is_left():
    world = load_world("gym:FrozenLake-v1")
    low, high = return_bounds(world, greedy_policy(world, 0.99), 0.99)
    assert low <= 0.0
    assert 1.0 <= high < 1.001
    one = load_world("fig6_chain", {"outer": 0, "inner": 0})
    assert return_bounds(one, np.zeros(4, dtype=int), 0.9) == (-0.5, 0.5)


@pytest.fixture(scope="module")
def learned():
    learning = Learning(load_world("double_chain"), LearnSettings(episodes=2_500, peers=True, rate_half=30.0))
    for _ in learning:
        pass
    return learning.snapshot()


def test_every_code_stands_beside_the_truth(learned):
    found = return_distributions(learned, "start", 0)
    assert set(found.codes) == set(found.distances) == set(CODES)
    np.testing.assert_allclose(found.truth[0], [0.6 * 0.99**2, 0.99**6])
    assert found.truth_error < 1e-6
    for name, (locations, masses) in found.codes.items():
        assert locations.shape == masses.shape
        assert masses.sum() == pytest.approx(1.0, abs=1e-5)
        assert np.all(np.diff(locations) >= 0)
        wanted = wasserstein_distance(locations, found.truth[0], masses, found.truth[1])
        assert found.distances[name] == pytest.approx(wanted, abs=1e-9)
    # One atom between two is half their distance away; the codes of a distribution come near; independent steps may
    # pay both chains or neither, which no episode does.
    assert found.distances["plain"] == pytest.approx(0.177, abs=0.01)
    assert found.distances["laplace"] == pytest.approx(found.distances["plain"], abs=1e-6)
    assert max(found.distances[name] for name in ("categorical", "quantile", "expectile")) < 0.09
    assert found.distances["independent_steps"] > 0.3


def test_independent_steps_come_from_the_tau_space_that_is_seen(learned):
    settings = Settings(alpha=0.003, thetas=60)
    found = return_distributions(learned, "start", 0, settings=settings)
    decoded = study_of(learned, settings)
    wanted = independent_steps_return(decoded.decoded.tau_space[0], decoded.midpoints, 0.99**decoded.taus)
    np.testing.assert_array_equal(found.codes["independent_steps"], wanted)


@pytest.mark.long
def test_where_steps_are_independent_they_say_the_truth():
    learning = Learning(load_world("fig6_chain"), LearnSettings(peers=True, episodes=3_000))
    for _ in learning:
        pass
    found = return_distributions(learning.snapshot(), 0, 0)
    assert found.distances["independent_steps"] < 0.3 < 2.0 < found.distances["plain"]


def test_what_is_not_there_is_refused(learned):
    with pytest.raises(InputError, match="action 1"):
        return_distributions(learned, 0, 1)
    with pytest.raises(InputError, match="state 'nowhere'"):
        return_distributions(learned, "nowhere", 0)
    with pytest.raises(InputError, match="seed_index 1"):
        return_distributions(learned, 0, 0, seed_index=1)
    with pytest.raises(InputError, match="learn again with peers"):
        return_distributions(Learning(load_world("two_branch"), LearnSettings()).snapshot(), 0, 0)
