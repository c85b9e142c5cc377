"""Noise amplification: against the exact gamma-space, in a learned basis, and in data without a truth."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from laplace_core import GammaSpace, Settings, load_world, study, study_of_gamma_space
from laplace_core.code.gamma_space import with_noise
from laplace_core.inverse import decode
from laplace_core.study.artefacts import VISIBLE, find_artefacts
from laplace_core.study.artefacts.look import Look
from laplace_core.study.artefacts.noise import noise_amplification, violations
from laplace_core.study.pipeline import basis_of, decode_and_read
from tests.support.random_gamma_spaces import noisy, random_space

NAME = "noise amplification"


def look(world: str, **settings):
    return study(load_world(world, settings.pop("params", {})), Settings(world=world, **settings))


def noise_of(found, action: int = 0):
    return next((artefact for artefact in find_artefacts(found, action) if artefact.name == NAME), None)


def measured(found, action: int = 0):
    """The artefact with all changes that may remove it, none of them tried."""
    return noise_amplification(Look(found, action))


def saved(noise: float = 0.0, **settings):
    """The gamma-space of a chain as somebody's data, without its world."""
    space = look("rise_and_fade", gammas=20, thetas=60).gamma_space
    data = GammaSpace(space.values, space.constant, space.gammas, space.thetas)
    return study_of_gamma_space(data, Settings(world="mine.npz", noise=noise, steps=20, **settings))


# --- with a truth ---


@pytest.mark.parametrize("noise", [1e-4, 1e-3, 1e-2])
def test_its_size_is_what_the_noise_moves(noise):
    noisy, clean = look("rise_and_fade", noise=noise), look("rise_and_fade")
    rewards, middles = noisy.world.reward_values, noisy.midpoints
    nearest = np.abs(middles[:, None] - rewards).argmin(axis=1)
    change = (noisy.decoded.tau_space - clean.decoded.tau_space)[0]
    by_reward = np.array([change[:, nearest == v].sum(axis=1) for v in range(rewards.size)])
    moved = 0.5 * np.abs(by_reward).sum(axis=0).max()
    assert noise_of(noisy).size == pytest.approx(moved, rel=1e-9)


def test_noise_that_does_not_show_is_not_listed():
    assert noise_of(look("two_branch", noise=1e-5)) is None


def test_the_first_change_takes_it_away_and_a_larger_alpha_comes_nearer_to_the_truth(subtests):
    for seed in range(3):
        for world in ["rise_and_fade", "double_chain", "cliff_grid", "discounting_chain"]:
            for noise in [1e-4, 3e-4, 1e-3]:
                with subtests.test(seed=seed, world=world, noise=noise):
                    found = look(world, noise=noise, noise_seed=seed)
                    artefact = measured(found)
                    if artefact is None:
                        return
                    assert noise_of(study(found.world, artefact.remedies[0].apply(found.settings))) is None
                    for remedy in artefact.remedies:
                        if "alpha" in remedy.changes:
                            assert remedy.changes["alpha"] > found.settings.alpha
                            repaired = study(found.world, remedy.apply(found.settings))
                            assert Look(repaired, 0).error() < Look(found, 0).error()
                    assert len({tuple(remedy.changes) for remedy in artefact.remedies}) == len(artefact.remedies)


def test_a_larger_alpha_comes_first_where_it_takes_the_noise_away():
    found = look("rise_and_fade", noise=1e-4, alpha=1e-4)
    assert [set(remedy.changes) for remedy in measured(found).remedies] == [{"alpha"}, {"noise"}]


def test_no_larger_alpha_is_offered_where_all_of_them_are_worse():
    # Alpha 1 smears already: more of it costs more than so little noise.
    found = look("two_branch", alpha=1.0, noise=0.01)
    assert noise_of(found).size > VISIBLE
    assert [remedy.changes for remedy in measured(found).remedies] == [{"noise": 0.0}]
    # Noise that was added is left out; there is nothing to learn on.
    assert "No alpha removes the noise" in noise_of(found).sentence
    assert "more learning" not in noise_of(found).sentence


# --- a learned basis, a policy of one's own ---


def test_a_learned_basis_is_noise_as_far_as_it_is_wrong():
    found = look("rise_and_fade")
    exact = basis_of(found)
    assert noise_of(study(found.world, found.settings, learned=exact)) is None
    wrong = exact + np.random.default_rng(0).normal(0.0, 0.02, exact.shape)
    artefact = noise_of(study(found.world, found.settings, learned=wrong))
    assert artefact.size > VISIBLE
    assert all(set(remedy.changes) == {"alpha"} for remedy in artefact.remedies)  # what was learned stays


def test_a_policy_of_one_s_own_is_neither_noise_nor_mixture():
    world = load_world("two_decisions")
    settings = Settings(world="two_decisions", policy="per_gamma", alpha=1e-6)
    assert {a.name for a in find_artefacts(study(world, settings), 1)} >= {"mixed policies"}
    own = study(world, settings, policy=np.zeros(world.n_states, dtype=int))
    assert find_artefacts(own, 1) == []


# --- without a truth ---


def test_exact_data_violate_nothing():
    found = saved()
    assert violations(Look(found, 0)).max() < 1e-12
    assert noise_of(found) is None


@pytest.mark.parametrize("noise", [1e-3, 3e-3])
def test_noisy_data_are_found_at_their_violations(noise):
    found, clean = saved(noise), saved()
    artefact = noise_of(found)
    # The mean error of P(reward > threshold, alive) in the worst row: the decoded tails.
    off = (found.gamma_space.values - clean.gamma_space.values)[0]
    moved = np.abs(decode(off, found.gamma_space.gammas, 20, found.settings.alpha)).mean(axis=-1).max()
    # A lower bound, and no empty one: noise breaks the rules in about half of the bins.
    assert 0.3 * moved < artefact.size < moved
    assert "at least" in artefact.shown
    repaired = replace(found.settings, **artefact.remedies[0].changes)
    assert repaired.alpha > found.settings.alpha
    assert noise_of(replace(found, settings=repaired, decoded=decode_and_read(found.gamma_space, repaired))) is None


def test_a_fall_with_gamma_is_a_violation_even_where_all_is_positive():
    gammas, thetas = np.array([0.5, 0.9]), np.array([0.0, 1.0])
    tails = np.array([[[2.0, 0.0], [1.0, 0.0]]])  # Z = 2 at gamma .5 and 1 at .9: impossible
    found = study_of_gamma_space(GammaSpace(tails, tails[..., 0], gammas, thetas), Settings(world="mine.npz", steps=5))
    # The fall of 1 is shared as the variances 1 / (1 - gamma)^2 = 4 and 100 would have it.
    np.testing.assert_allclose(violations(Look(found, 0))[:, 0] ** 2, [4 / 104, 100 / 104])


@pytest.mark.parametrize("alpha", [0.2, 0.05, 0.01, 0.001])
def test_exact_values_of_policies_that_differ_are_not_called_noise(alpha):
    """Discounts of two_decisions change their policy: exact values, saved and decoded without their world."""
    named = set()
    for world in ("two_decisions", "discounting_chain", "cliff_grid"):
        space = look(world, policy="per_gamma").gamma_space
        own = study_of_gamma_space(space, Settings(world="mine.npz", alpha=alpha, steps=8))
        for action in range(len(own.action_names)):
            for artefact in find_artefacts(own, action):
                assert artefact.name != NAME, (world, action, artefact)
                if artefact.name == "mixed policies":
                    assert artefact.remedies == ()
                    assert "different policies" in artefact.sentence
                    named.add(world)
    assert "two_decisions" in named or alpha > 0.02


def test_random_worlds_are_told_apart():
    """Per-discount policies are never called noise; noise that makes nothing negative may be called both things."""
    wrong, mixed, noise, either = [], 0, 0, 0
    for seed in range(120):
        rng = np.random.default_rng([6, seed])
        exact = random_space(rng, (8, 10), "per_gamma")
        settings = Settings(world="mine.npz", alpha=1e-3, steps=12)
        for action in range(len(exact.values)):
            names = {a.name for a in find_artefacts(study_of_gamma_space(exact, settings), action, searching=False)}
            mixed += "mixed policies" in names
            wrong += [(seed, "exact", names)] if NAME in names else []
        shared = noisy(random_space(rng, (8, 10), "shared"), 3e-3, rng)
        names = {a.name for a in find_artefacts(study_of_gamma_space(shared, settings), 0, searching=False)}
        noise += NAME in names
        either += "mixed policies" in names
    assert wrong == []
    assert either <= 3
    assert mixed >= 10
    assert noise >= 100


def test_noise_in_data_is_not_taken_for_clipped_edges():
    assert "edge clipping" not in {artefact.name for artefact in find_artefacts(saved(1e-3), 0)}


def test_noise_of_data_without_a_world_is_no_share_above_one():
    found = look("two_branch", steps=50)
    own = study_of_gamma_space(with_noise(found.gamma_space, 0.05, 0), Settings(alpha=1e-3, steps=50))
    artefact = noise_amplification(Look(own, 1))
    assert artefact.size > 1.0
    assert f"{artefact.size:.3g} times a row's whole probability" in artefact.shown
