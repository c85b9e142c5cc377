"""What a verdict and a list of artefacts say of the noise: the test, the certainty of a choice, bumps, resolution."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from laplace_core import Settings, load_world, study
from laplace_core.code.gamma_space import with_noise
from laplace_core.inverse.bumps import Bump
from laplace_core.inverse.resolution import resolution
from laplace_core.study.evidence import Belief, Pair, believe, known_noise
from laplace_core.study.pipeline import read_study


def look(world="two_branch", **values):
    return study(load_world(world), Settings(world=world, **values))


def test_the_noise_is_known_where_it_was_put_in_or_assumed():
    assert known_noise(look()) is None
    found = look(noise=0.01)
    np.testing.assert_allclose(known_noise(found), 0.01 / (1.0 - found.gamma_space.gammas))
    found = look(noise=0.01, noise_level=0.002)
    np.testing.assert_allclose(known_noise(found), 0.002 / (1.0 - found.gamma_space.gammas))
    assert believe(look(), 0, 0) is None


def test_mixed_policies_are_no_timeline_and_one_policy_is():
    found = look("two_decisions", policy="per_gamma", noise_level=1e-3)
    mixed = believe(found, found.row, 0)
    assert mixed.p_value < 0.05
    assert "no transform of one process" in mixed.sentence
    assert mixed.artefacts[0].name == "no timeline"
    found = look("two_decisions", noise_level=1e-3, noise=1e-3)
    one = believe(found, found.row, 0)
    assert one.p_value > 0.05
    assert "may well have these values" in one.sentence
    assert "no timeline" not in [each.name for each in one.artefacts]


def test_the_spread_of_the_difference_is_the_one_of_many_draws():
    # A slow twin: 400 draws of noise, each decoded and read; a standard deviation of them is off by 1 / sqrt(800).
    found = look(noise=0.003, alpha=0.3, thetas=30)
    belief = believe(found, found.row, 0)
    exact = look(alpha=0.3, thetas=30)
    drawn = [
        np.subtract(*read_study(with_noise(exact.gamma_space, 0.003, seed), found.settings).horizon_values[:, -1])
        for seed in range(400)
    ]
    assert belief.spread == pytest.approx(np.std(drawn), rel=4.0 / np.sqrt(800.0))
    assert belief.difference == pytest.approx(abs(np.subtract(*found.decoded.horizon_values[:, -1])))


def test_a_choice_within_the_noise_is_called_so_and_another_is_not():
    quiet, loud = (believe(found, found.row, 0) for found in (look(noise=1e-4, alpha=0.3), look(noise=0.05, alpha=0.3)))
    assert "within the noise" not in quiet.sentence
    assert "within the noise" in loud.sentence


@pytest.mark.parametrize(("second", "word"), [(40.0, "resolved"), (3.0, "unresolved")])
def test_two_rewards_are_resolved_or_not_and_a_bump_may_be_doubtful(second, word):
    found = resolution(2.0, second, 100.0, np.array([0.1, 0.9, 0.99]))
    assert found.verdict == word
    real = Bump(2, 2, 3, 1, 1.0, 0.9)
    doubtful = replace(real, peak=7, probability=0.2)
    belief = Belief(0.4, (), None, None, (real, doubtful), (Pair(2.0, second, found),), 0.5)
    assert f"Rewards at τ 2 and {second:g} are {word}." in belief.sentence
    names = [each.name for each in belief.artefacts]
    assert names == ["doubtful bump", *(["unresolved rewards"] if word == "unresolved" else [])]
    assert "τ 3.5 (20%)" in belief.artefacts[0].shown


def test_rows_that_are_rescaled_have_no_bumps_of_the_inverse():
    found = look(noise=0.003, normalise="paper")
    belief = believe(found, found.row, 0)
    assert (belief.bumps, belief.pairs, belief.spread) == ((), (), None)
