"""The noise of a learner, measured from its seeds, and what is made of it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from laplace_core import InputError, Settings, load_world, study
from laplace_core.inverse import choose_alpha, problem_of
from laplace_core.inverse.bands import reward_gain
from laplace_core.study.pipeline import deviations_of, grids, noise_of
from laplace_core.study.settings import resolve
from laplace_core.tabular import (
    Learning,
    LearnSettings,
    noise_over_seeds,
    noise_settings,
    reward_gain_over_seeds,
    study_of,
)

PARAMS = (("slip", 0.3),)


@pytest.fixture(scope="module")
def learned():
    learning = Learning(load_world("two_branch", dict(PARAMS)), LearnSettings(episodes=60, seeds=3, gammas=6))
    for _ in learning:
        pass
    return learning.snapshot()


@pytest.fixture(scope="module")
def settings(learned):
    return resolve(Settings(world="two_branch", params=PARAMS, gammas=6, thetas=12), learned.world)


def test_it_is_the_spread_of_what_each_seed_encodes(learned, settings):
    """The slow twin: each seed's own study, each discount, action and sensitivity by itself."""
    _, thetas = grids(settings)
    values = [study_of(learned, settings, seed).gamma_space.values for seed in range(3)]
    for g, gamma in enumerate(learned.gammas):
        variances = []
        for a in range(2):
            for h in range(thetas.size):
                one = [float(each[a, g, h]) for each in values]
                mean = sum(one) / 3
                variances.append(sum((x - mean) ** 2 for x in one) / 2)
        expected = (1 - gamma) * np.sqrt(sum(variances) / len(variances))
        assert noise_over_seeds(learned, settings)[g] == pytest.approx(expected, rel=1e-9)


def test_it_finds_the_noise_that_was_put_in(learned, settings):
    """Values of 400 seeds that differ by normal errors of known size at each discount, of all tails alike."""
    rng, size = np.random.default_rng(3), np.array([0.3, 0.1, 0.05, 0.02, 0.01, 0.002])
    world, basis = learned.world, np.repeat(learned.basis[:1], 400, axis=0).astype(float)
    # An error of the highest reward moves every tail below it: those of the sensitivities far below it, by all of it.
    basis[..., -1] += size[:, None].T * rng.normal(size=(400, 1, 1, 6)) / (1 - learned.gammas)
    noisy = replace(learned, basis=basis)
    share = grids(settings)[1] < world.reward_values[-1]
    found = noise_over_seeds(noisy, settings)
    np.testing.assert_allclose(found / found[0], size / size[0], rtol=0.15)
    np.testing.assert_allclose(found, size * np.sqrt(share.mean()), rtol=0.25)


def test_one_seed_and_seeds_that_agree_have_no_noise_to_measure(learned, settings):
    with pytest.raises(InputError, match="learn at least 2"):
        noise_over_seeds(replace(learned, basis=learned.basis[:1]), settings)
    with pytest.raises(InputError, match="have learned the same values"):
        noise_over_seeds(replace(learned, basis=np.repeat(learned.basis[:1], 2, axis=0)), settings)


def test_a_discount_at_which_the_seeds_agree_is_not_trusted_without_limit(learned, settings):
    basis = learned.basis.copy()
    basis[:, :, :, 0] = basis[:1, :, :, 0]
    found = noise_over_seeds(replace(learned, basis=basis), settings)
    assert found[0] == pytest.approx(1e-3 * found.max())


def test_rows_count_and_rules_choose_by_the_measured_noise(learned, settings):
    measured = noise_settings(learned, settings)
    spread = noise_over_seeds(learned, settings)
    s = replace(settings, selector="discrepancy", weighting="deviation", **measured)
    expected = spread / (1 - learned.gammas)
    np.testing.assert_allclose(noise_of(s, learned.gammas), expected, rtol=1e-3)
    np.testing.assert_array_equal(deviations_of(s, learned.gammas), noise_of(s, learned.gammas))
    assert measured["noise_level"] == pytest.approx(np.sqrt(np.mean(spread**2)), rel=1e-3)
    found = study(learned.world, s)
    noise = noise_of(s, learned.gammas)
    alpha = choose_alpha(problem_of(found.gamma_space, s.steps, 1.0, noise), "tikhonov", "discrepancy", noise=noise)
    assert found.settings.alpha == alpha.value
    assert found.settings.alpha != study(learned.world, replace(s, noise_levels=None)).settings.alpha


def test_levels_are_checked_before_they_are_used():
    world = load_world("two_branch")
    for text in ("0.1,x", "0", "2", "nan,1", "", "1e-3,,1e-3", "1_0"):
        with pytest.raises(InputError, match="noise_levels must be numbers from 1e-12 to 1"):
            Settings(world="two_branch", noise_levels=text)
    with pytest.raises(InputError, match="noise_levels has 2 numbers for 15 discounts: give one for each"):
        study(world, Settings(world="two_branch", noise_levels="0.1,0.1"))
    flat = Settings(world="two_branch", noise_levels=",".join(["0.003"] * 15), selector="gcv", noise=0.003)
    same = replace(flat, noise_levels=None, noise_level=0.003)
    assert study(world, flat).settings.alpha == study(world, same).settings.alpha


def test_the_gain_is_that_of_each_seeds_expected_reward(learned, settings):
    spaces = [study_of(learned, settings, seed).gamma_space for seed in range(3)]
    rewards = np.array([each.differences @ each.bin_values for each in spaces])  # (3, A, G)
    errors = np.sqrt(rewards.var(axis=0, ddof=1).mean(axis=0))
    deviations = noise_over_seeds(learned, settings) / (1 - learned.gammas)
    expected = np.sqrt(np.mean((errors / deviations) ** 2))
    assert reward_gain_over_seeds(learned, settings) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(("world", "params"), [("two_branch", PARAMS), ("rise_and_fade", ())])
def test_the_errors_of_a_learner_are_nearer_to_one_error_than_to_independent_ones(world, params):
    learning = Learning(load_world(world, dict(params)), LearnSettings(episodes=60, seeds=8, gammas=15))
    for _ in learning:
        pass
    found = learning.snapshot()
    s = resolve(Settings(world=world, params=params, gammas=15), found.world)
    measured = reward_gain_over_seeds(found, s)
    shared, independent = (reward_gain(study_of(found, s, 0).gamma_space, independent=each) for each in (False, True))
    assert abs(np.log(measured / shared)) < abs(np.log(measured / independent))
