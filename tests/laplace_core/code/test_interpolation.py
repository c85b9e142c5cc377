"""Discounts between those that were learned: where they lie, what they hold, and how far they are off."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError, Settings, load_world, study
from laplace_core.code.gamma_space import GammaSpace
from laplace_core.code.interpolation import left_out, log_times, mixing, with_added, with_between
from laplace_core.planning import greedy_policy, reward_indicator_basis

# Time constants of 1, 4 and 16 steps.
GAMMAS = np.exp(-1 / np.array([1.0, 4.0, 16.0]))


def test_discounts_are_added_evenly_in_log_time():
    np.testing.assert_allclose(with_between(GAMMAS, 1), np.exp(-1 / np.array([1.0, 2.0, 4.0, 8.0, 16.0])), rtol=1e-14)
    np.testing.assert_array_equal(with_between(GAMMAS, 3)[::4], GAMMAS)
    np.testing.assert_array_equal(with_between(GAMMAS, 0), GAMMAS)
    np.testing.assert_array_equal(with_between(GAMMAS[:1], 2), GAMMAS[:1])


def test_what_lies_half_way_is_the_mean_of_its_neighbours():
    """Of (1 - gamma) Q: .2 and .6 have .4 between them."""
    Q = np.array([0.2, 0.6]) / (1 - GAMMAS[:2])
    middle = np.exp(-1 / 2.0)
    assert (1 - middle) * (mixing(GAMMAS[:2], np.array([middle])) @ Q)[0] == pytest.approx(0.4)


@pytest.mark.parametrize("count", [-1, 4])
def test_only_a_few_are_added(count):
    with pytest.raises(InputError, match="between neighbours"):
        with_between(GAMMAS, count)


@pytest.mark.parametrize("gamma", [0.1, 0.99])
def test_nothing_is_added_outside(gamma):
    with pytest.raises(InputError, match="only"):
        mixing(GAMMAS, np.array([gamma]))


@given(st.lists(st.floats(0.01, 0.995), min_size=2, max_size=8, unique=True).map(sorted), st.integers(1, 3))
def test_probabilities_stay_probabilities(gammas, count):
    gammas = np.array(gammas)
    if np.diff(log_times(gammas)).min() < 1e-6:
        return
    rng = np.random.default_rng(count)
    tails = np.sort(rng.random((gammas.size, 5)), axis=-1)[:, ::-1]
    space = GammaSpace(tails[None] / (1 - gammas)[:, None], tails[None, :, 0] / (1 - gammas), gammas, np.arange(5.0))
    found = with_added(space, count)
    drawn = found.values[0] * (1 - found.gammas)[:, None]
    assert np.all(found.differences >= -1e-9)
    assert drawn.max() <= tails.max() + 1e-9
    np.testing.assert_allclose(found.values[:, :: count + 1], space.values, rtol=1e-12)
    np.testing.assert_allclose(found.constant, found.values[..., 0], rtol=1e-9)


def test_the_error_of_one_that_is_left_out_by_a_slow_twin():
    gammas = np.array([0.4, 0.6, 0.8, 0.9])
    values = np.random.default_rng(0).random((2, 4, 3))
    found = left_out(values, gammas)
    assert found.shape == (2, 2, 3)
    t = [np.log(-1 / np.log(g)) for g in gammas]
    for a in range(2):
        for i in (1, 2):
            for h in range(3):
                low, high = ((1 - gammas[j]) * values[a, j, h] for j in (i - 1, i + 1))
                drawn = low + (high - low) * (t[i] - t[i - 1]) / (t[i + 1] - t[i - 1])
                assert found[a, i - 1, h] == pytest.approx(abs(drawn - (1 - gammas[i]) * values[a, i, h]))
    assert left_out(values[:, :2], gammas[:2]).shape == (2, 0, 3)


def test_between_exact_discounts_it_is_nearer_than_where_one_is_left_out():
    found = study(load_world("fig6_chain"), Settings(gammas=15, spacing="log", gamma_min=0.37, gamma_max=0.99))
    world, space = found.world, found.gamma_space
    gammas = with_between(space.gammas, 1)
    policy = greedy_policy(world, found.settings.acting_gamma)
    basis = reward_indicator_basis(world, found.state, gammas, [policy] * gammas.size)
    off = np.abs(with_added(space, 1).constant - basis.sum(axis=-1)) * (1 - gammas)
    missed = left_out(space.constant[..., None], space.gammas)[..., 0]
    assert 0 < off.max() < missed.max() < 0.02
