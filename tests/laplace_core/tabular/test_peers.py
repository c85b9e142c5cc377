"""The peers: directions pinned by hand, projections and imputations by their laws, and the true return distribution."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq
from scipy.stats import wasserstein_distance

from laplace_core import InputError, load_world
from laplace_core.planning import greedy_policy, reward_indicator_basis
from laplace_core.tabular.peers import (
    Categorical,
    Expectile,
    PlainQ,
    Quantile,
    impute,
    project,
    quantiles_of,
    return_distribution,
)
from laplace_core.tabular.td import Decay, LaplaceTD, Schedule, Transition, learn
from laplace_core.worlds import END
from tests.support.random_worlds import worlds_with_policy
from tests.support.slow_twins import assert_mean_agrees, sampled_rewards

ALWAYS = Decay(1.0, np.inf)  # rate 1
EVERYWHERE = {"epsilon": ALWAYS, "every": 10_000}  # all actions at random

amounts = st.integers(-40, 40).map(lambda quarters: quarters / 4)


@st.composite
def laws(draw, most: int = 6) -> tuple[np.ndarray, np.ndarray]:
    """Distinct increasing locations and masses."""
    locations = np.array(sorted(draw(st.sets(amounts, min_size=1, max_size=most))))
    weights = np.array(draw(st.lists(st.integers(1, 8), min_size=locations.size, max_size=locations.size)), dtype=float)
    return locations, weights / weights.sum()


def ending(reward):
    return Transition(0, 0, reward, 0, END)


# --- directions ---


def test_quantiles_move_towards_their_levels():
    # Two quantiles, levels 1/4 and 3/4. The loss u (level - 1[u < 0]) falls along level - P(target < q).
    # From (0, 0) with the target 1, above both: they rise by their levels, the upper one MORE.
    # From (.25, .75) with the target -1, below both: they fall by 1 - level, 3/4 and 1/4, the lower one MORE.
    peer = Quantile(load_world("two_branch"), 0.9, count=2, rate=ALWAYS)
    peer.update(ending(1.0))
    np.testing.assert_allclose(peer.locations[0, 0], [0.25, 0.75])
    peer.update(ending(-1.0))
    np.testing.assert_allclose(peer.locations[0, 0], [-0.5, 0.5])
    assert peer.values[0, 0] == pytest.approx(0.0)


def test_expectiles_move_towards_their_levels():
    # Three expectiles, levels 1/4, 1/2, 3/4. The loss |level - 1[u < 0]| u^2 falls along 2 |level - 1[u < 0]| u.
    # From 0 with the target 1: 2 (1/4, 1/2, 3/4) * 1, the upper one MORE.
    # From (.5, 1, 1.5) with the target 0: -2 (3/4 * .5, 1/2 * 1, 1/4 * 1.5) = (-.75, -1, -.75).
    peer = Expectile(load_world("two_branch"), 0.9, -5.0, 5.0, count=3, rate=ALWAYS)
    peer.update(ending(1.0))
    np.testing.assert_allclose(peer.expectiles[0, 0], [0.5, 1.0, 1.5])
    peer.update(ending(0.0))
    np.testing.assert_allclose(peer.expectiles[0, 0], [-0.25, 0.0, 0.75])
    assert peer.values[0, 0] == 0.0


@pytest.mark.parametrize("target", [-1.3, 0.2, 2.6])
def test_steps_are_the_negative_gradients_of_the_losses(target):
    world, start, nudge = load_world("two_branch"), np.array([-0.7, 0.5, 1.9]), 1e-6

    def descent(loss):
        return -(loss(start + nudge) - loss(start - nudge)) / (2 * nudge)

    def weight(u, levels):
        return np.abs(levels - (u < 0))

    quantile = Quantile(world, 0.9, count=3, rate=ALWAYS)
    quantile.locations[0, 0] = start
    quantile.update(ending(target))
    steps = descent(lambda q: weight(target - q, quantile.levels) * np.abs(target - q))
    np.testing.assert_allclose(quantile.locations[0, 0] - start, steps, atol=1e-8)

    expectile = Expectile(world, 0.9, -5.0, 5.0, count=3, rate=ALWAYS)
    expectile.expectiles[0, 0] = start
    expectile.update(ending(target))
    steps = descent(lambda e: weight(target - e, expectile.levels) * (target - e) ** 2)
    np.testing.assert_allclose(expectile.expectiles[0, 0] - start, steps, atol=1e-8)


def test_one_step_of_each_peer_by_hand():
    # From state 1 to state 2 with reward 1, gamma 1/2, rate 1/2, where state 2 is worth 2 for sure: the target is 2.
    # Plain Q: 0 to 1. Categorical: half of the mass of 0 moves to 2. Quantiles (levels 1/4, 3/4, scale 4): up by
    # 1/2 * 4 * level. Expectiles (levels 1/4, 1/2, 3/4): up by 1/2 * 2 * level * 2.
    world, rate = load_world("two_branch"), Decay(0.5, np.inf)
    plain, categorical = PlainQ(world, 0.5, rate=rate), Categorical(world, 0.5, np.arange(4.0), rate=rate)
    quantile, expectile = (
        Quantile(world, 0.5, count=2, scale=4.0, rate=rate),
        Expectile(world, 0.5, 0.0, 3.0, count=3, rate=rate),
    )
    for table in (plain.values, quantile.locations, expectile.expectiles):
        table[2] = 2.0
    categorical.probabilities[2] = [0, 0, 1, 0]
    for peer in (plain, categorical, quantile, expectile):
        peer.update(Transition(1, 0, 1.0, 0, 2))
    assert plain.values[1, 0] == 1.0
    np.testing.assert_allclose(categorical.probabilities[1, 0], [0.5, 0, 0.5, 0])
    np.testing.assert_allclose(quantile.locations[1, 0], [0.5, 1.5])
    np.testing.assert_allclose(expectile.expectiles[1, 0], [0.5, 1.0, 1.5])


# --- projection and imputation ---


@given(laws(), st.sets(amounts, min_size=2, max_size=8))
def test_the_projection_conserves_mass_and_mean(law, support):
    locations, masses = law
    atoms = np.array(sorted(support))
    projected = project(locations, masses, atoms)
    assert projected.min() >= 0
    assert projected.sum() == pytest.approx(1.0)
    assert projected @ atoms == pytest.approx(masses @ np.clip(locations, atoms[0], atoms[-1]))


def test_a_projection_by_hand():
    # .3 lies 3/10 of the way from 0 to 1; -4 and 9 go to the ends; 2 is an atom.
    projected = project(np.array([0.3, -4.0, 9.0, 2.0]), np.array([0.4, 0.1, 0.2, 0.3]), np.arange(4.0))
    np.testing.assert_allclose(projected, [0.4 * 0.7 + 0.1, 0.4 * 0.3, 0.3, 0.2])


def expectiles_of(locations, masses, levels):
    """By their definition: level E(x - e)+ = (1 - level) E(e - x)+, one root a level."""
    if np.ptp(locations) == 0:
        return np.full(levels.size, locations[0])

    def balance(e, level):
        return level * (masses @ np.maximum(locations - e, 0)) - (1 - level) * (masses @ np.maximum(e - locations, 0))

    return np.array([brentq(balance, locations[0], locations[-1], args=(level,), xtol=1e-13) for level in levels])


@given(laws(), st.sampled_from([1, 3, 11, 31]))
def test_the_imputed_distribution_has_the_given_expectiles(law, count):
    levels = np.arange(1, count + 1) / (count + 1)
    expectiles = expectiles_of(*law, levels)
    locations, masses = impute(expectiles, levels, -11.0, 12.0)
    assert masses.min() >= 0
    assert masses.sum() == pytest.approx(1.0)
    np.testing.assert_allclose(expectiles_of(locations, masses, levels), expectiles, rtol=0, atol=1e-6)


@given(st.lists(amounts, min_size=5, max_size=5))
def test_any_numbers_impute_to_a_distribution(expectiles):
    # While learning, they need not be in order, nor inside the bounds.
    locations, masses = impute(np.array(expectiles), np.arange(1, 6) / 6, -3.0, 2.0)
    assert masses.min() >= 0
    assert masses.sum() == pytest.approx(1.0)
    assert (locations.min(), locations.max()) == (-3.0, 2.0)


# --- the truth ---


def test_the_returns_of_fig6_are_its_sixteen_sums():
    g = 0.9
    signs = itertools.product([-1, 1], repeat=4)
    sums = sorted(2 * a + g * 2 * b + g**2 * c + g**3 * d for a, b, c, d in signs)
    found = return_distribution(load_world("fig6_chain"), 0, 0, np.zeros(4, dtype=int), gamma=g)
    np.testing.assert_allclose(found.locations, sums, atol=1e-12)
    np.testing.assert_allclose(found.masses, np.full(16, 1 / 16))
    assert found.error < 1e-9


@given(worlds_with_policy(max_states=4), st.sampled_from([0.3, 0.8]))
def test_the_mean_of_the_returns_is_their_expectation(world_and_policy, gamma):
    world, policy = world_and_policy
    found = return_distribution(world, 0, 0, policy, gamma=gamma, most=300)
    basis = reward_indicator_basis(world, 0, np.array([gamma]), [policy])
    assert found.masses.sum() == pytest.approx(1.0)
    assert found.locations @ found.masses == pytest.approx(basis[0, 0] @ world.reward_values, abs=2e-6)


def test_the_returns_agree_with_sampled_episodes():
    world, gamma = load_world("cliff_grid", {"width": 4, "height": 3, "slip": 0.3}), 0.95
    policy = greedy_policy(world, gamma)
    found = return_distribution(world, 0, 0, policy, gamma=gamma)
    rewards = np.nan_to_num(sampled_rewards(world, 0, 0, policy, count=5_000, seed=0))
    returns = rewards @ gamma ** np.arange(rewards.shape[1])
    levels = (found.locations[1:] + found.locations[:-1]) / 2
    assert_mean_agrees(returns[:, None] < levels, np.cumsum(found.masses)[:-1])


def test_the_error_of_a_coarse_propagation_is_a_bound():
    world = load_world("cliff_grid", {"slip": 0.6})
    walk = np.full((world.n_states, 4), 0.25)
    fine, coarse = (return_distribution(world, 0, 0, walk, gamma=0.97, most=most) for most in (20_000, 60))
    apart = wasserstein_distance(fine.locations, coarse.locations, fine.masses, coarse.masses)
    assert 1e-3 < apart <= coarse.error + fine.error
    assert coarse.locations @ coarse.masses == pytest.approx(fine.locations @ fine.masses, abs=1e-5)


# --- learning it ---

GAMMA = 0.99


@pytest.fixture(scope="module")
def learned():
    """All representations of the double chain's return, from the same 2,500 episodes: about 12,500 transitions."""
    world, rate = load_world("double_chain"), Decay(1.0, 30.0)
    peers = {
        "laplace": LaplaceTD(world, [0.5, GAMMA], acting_gamma=GAMMA, rate=rate),
        "plain": PlainQ(world, GAMMA, rate=rate),
        "categorical": Categorical(world, GAMMA, np.linspace(0, 1, 51), rate=rate),
        "quantile": Quantile(world, GAMMA, count=50, rate=rate),
        "expectile": Expectile(world, GAMMA, 0.0, 1.0, count=11, rate=rate),
    }
    list(learn(world, list(peers.values()), Schedule(2_500, 1, **EVERYWHERE)))
    return peers


A, B = 0.6 * GAMMA**2, GAMMA**6  # .6 at step 2 or 1 at step 6, by a coin


# How near each comes, in Wasserstein distance. Plain Q has one atom between two: half their distance, .177, is all it
# can do. C51 blurs over its atoms, .02 apart, at every step: .015. Eleven exact expectiles impute to .048 from the
# truth. The coin's share was learned with a standard error of .04, worth .014.
@pytest.mark.parametrize(
    ("name", "least", "most"),
    [("plain", 0.17, 0.19), ("categorical", 0, 0.05), ("quantile", 0, 0.05), ("expectile", 0, 0.09)],
)
def test_learned_distributions_approach_the_true_one(learned, name, least, most):
    truth = return_distribution(load_world("double_chain"), 0, 0, np.zeros(9, dtype=int), gamma=GAMMA)
    np.testing.assert_allclose(truth.locations, [A, B])
    np.testing.assert_allclose(truth.masses, [0.5, 0.5])
    assert truth.error < 1e-6
    locations, masses = learned[name].distribution(0, 0)
    assert masses.sum() == pytest.approx(1.0)
    assert least <= wasserstein_distance(locations, truth.locations, masses, truth.masses) < most


def test_expectiles_of_a_coin_lie_at_their_levels(learned):
    # level (B - e) = (1 - level) (e - A) gives e = A + level (B - A). A wrong direction would turn their order round.
    peer = learned["expectile"]
    np.testing.assert_allclose(peer.expectiles[0, 0], A + peer.levels * (B - A), atol=0.03)


def test_quantiles_of_a_coin_lie_at_its_sides(learned):
    # Well below 1/2 on the worse side, well above on the better one; the first, at the level .01, still climbs from 0,
    # by a hundredth of the rate at most.
    peer = learned["quantile"]
    np.testing.assert_allclose(peer.locations[0, 0, 1:20], A, atol=0.04)
    np.testing.assert_allclose(peer.locations[0, 0, 30:], B, atol=0.04)


@pytest.mark.parametrize("name", ["laplace", "categorical", "expectile"])
def test_means_are_those_of_plain_q(learned, name):
    # The projection keeps the mean, and the middle expectile is the mean: same samples, same rate, same value.
    values = learned[name].acting_values if name == "laplace" else learned[name].values
    np.testing.assert_allclose(values, learned["plain"].values, rtol=0, atol=1e-6 if name == "expectile" else 1e-12)


def test_the_peers_find_the_better_branch():
    world, rate = load_world("two_branch"), Decay(1.0, 100.0)
    peers = [PlainQ(world, GAMMA, rate=rate), Categorical(world, GAMMA, np.linspace(0, 10, 51), rate=rate)]
    peers += [
        Quantile(world, GAMMA, count=21, scale=10.0, rate=rate),
        Expectile(world, GAMMA, 0.0, 10.0, count=5, rate=rate),
    ]
    list(learn(world, peers, Schedule(400, **EVERYWHERE)))
    for peer in peers:
        assert peer.act(0) == 1
        np.testing.assert_allclose(peer.values[0], [5, 10 * GAMMA**2], atol=0.5)


def test_a_peer_evaluates_a_given_policy():
    # In two_decisions, going on and then taking the short branch returns 0 + g r1.
    world = load_world("two_decisions")
    peer = PlainQ(world, GAMMA, policy=np.zeros(4, dtype=int), rate=ALWAYS)
    list(learn(world, [peer], Schedule(50, **EVERYWHERE)))
    np.testing.assert_allclose(peer.values[0], [4, GAMMA * 5])


def test_what_does_not_fit_is_refused():
    world = load_world("two_branch")
    refused = {
        "gamma must lie": lambda: PlainQ(world, 1.0),
        "deterministic": lambda: PlainQ(world, 0.9, policy=np.full((3, 2), 0.5)),
        "increasing": lambda: Categorical(world, 0.9, np.array([1.0, 0.0])),
        "positive scale": lambda: Quantile(world, 0.9, count=5, scale=0.0),
        "odd count": lambda: Expectile(world, 0.9, 0.0, 1.0, count=4),
    }
    for words, build in refused.items():
        with pytest.raises(InputError, match=words):
            build()


def test_quantiles_of_a_discrete_distribution_are_those_of_its_cumulated_mass():
    # Masses .2 at -1, .5 at 2, .3 at 7: cumulated .2, .7, 1.
    found = quantiles_of(np.array([7.0, -1.0, 2.0]), np.array([0.3, 0.2, 0.5]), np.array([0.1, 0.2, 0.5, 0.7, 0.9]))
    np.testing.assert_array_equal(found, [-1.0, -1.0, 2.0, 2.0, 7.0])


def test_while_the_rate_is_high_quantiles_are_taken_over_and_then_learned():
    world = load_world("two_branch")
    rate = Decay(1.0, 1.0, 0.0)  # 1, 1/2, 1/3: only the first is above .6
    peer = Quantile(world, 0.9, count=2, scale=1.0, rate=rate, takes_over=0.6)
    ends = Transition(0, 0, 5.0, int(np.searchsorted(world.reward_values, 5.0)), END)
    peer.update(ends)
    np.testing.assert_array_equal(peer.locations[0, 0], [5.0, 5.0])
    # Levels 1/4 and 3/4, rate 1/2, a target of 4 below both: each falls by 1/2 (1 - level).
    peer.update(ends._replace(reward=4.0))
    np.testing.assert_allclose(peer.locations[0, 0], [5.0 - 0.375, 5.0 - 0.125])


def test_no_step_leaps_over_the_target():
    world = load_world("two_branch")
    peer = Quantile(world, 0.9, count=2, scale=100.0, rate=Decay(1.0, 1.0, 0.0), takes_over=0.6)
    ends = Transition(0, 0, 5.0, int(np.searchsorted(world.reward_values, 5.0)), END)
    for reward, wanted in ((5.0, 5.0), (7.0, 7.0), (7.0, 7.0), (6.0, 6.0)):  # 100 a step, but no further than this
        peer.update(ends._replace(reward=reward))
        np.testing.assert_array_equal(peer.locations[0, 0], [wanted, wanted])
