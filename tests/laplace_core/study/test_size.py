"""Memory in proportion to the input: no matrix of thetas by thetas or rewards by rewards, and a bound for a process."""

from __future__ import annotations

import io
import tracemalloc
from collections.abc import Callable

import numpy as np
import pytest

from laplace_core import GammaSpace, InputError, Settings, figures, load_world, study, study_of_gamma_space
from laplace_core.code import encoding
from laplace_core.code import gamma_space as gamma_space_module
from laplace_core.code.encoding import softening
from laplace_core.code.gamma_space import softened
from laplace_core.figures.learning import _nearest
from laplace_core.payloads.lens import payload
from laplace_core.study import conventions
from laplace_core.study.artefacts import find_artefacts
from laplace_core.study.compare import difference
from laplace_core.study.npz import npz_bytes, read_gamma_space
from laplace_core.study.size import MAX_VALUES, check_size, largest_study, set_largest_study
from laplace_core.study.verdict import judge
from laplace_core.tabular import Learning, LearnSettings, bands
from laplace_core.tabular.peers import return_distribution
from laplace_core.tabular.returns import wasserstein
from laplace_core.tabular.td import LaplaceTD, Schedule, learn
from laplace_core.worlds import World


def peak_of(make: Callable[[], object]) -> int:
    """Most bytes that a computation has at once, on top of what was there."""
    tracemalloc.start()
    try:
        make()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def many_rewards(count: int) -> World:
    """One state: the first action pays any of so many rewards and ends, the second pays 3 and may go on."""
    outcomes = [(0, 0, 1 / count, -1, i / 1_000) for i in range(count)] + [(0, 1, 0.5, -1, 3.0), (0, 1, 0.5, 0, 3.0)]
    return World.from_outcomes("many", ["s"], ["a", "b"], outcomes)


def test_a_world_of_many_rewards_takes_memory_in_proportion():
    """4,000 x 4,000 doubles would be 128 MB; what a study may hold here are 4 MB, and the search makes several."""
    world = many_rewards(4_000)
    set_largest_study(500_000)
    settings = Settings(thetas=60, gammas=8, steps=5, alpha=1e-4)

    def everything() -> None:
        found = study(world, settings)
        for action in range(2):
            find_artefacts(found, action)
        judge(found, found.row)
        payload(found)
        figures.comparison(difference(found, found, 0, 0))
        npz_bytes(found)

    assert peak_of(everything) < 60_000_000


def test_learning_a_world_of_many_rewards_takes_memory_in_proportion():
    """The table has 1 x 2 x 4 x 4,001 numbers, .26 MB; indicators as a matrix had 4,000 x 4,001, 128 MB."""
    world = many_rewards(4_000)
    schedule = Schedule(episodes=20)
    assert peak_of(lambda: list(learn(world, [LaplaceTD(world, np.array([0.5, 0.8, 0.9]))], schedule))) < 10_000_000


def test_the_law_of_the_return_of_many_rewards_keeps_its_bound():
    """The first action pays any of 3,000 rewards once, so that its law is known; 300 stand for them."""
    law = return_distribution(many_rewards(3_000), 0, 0, np.array([0]), gamma=0.9)
    exact = np.arange(3_000) / 1_000, np.full(3_000, 1 / 3_000)
    assert 0 < wasserstein((law.locations, law.masses), exact) <= law.error < 0.01


def test_the_law_of_the_return_of_many_rewards_takes_memory_in_proportion():
    """Up to 4,000 atoms have 1,600 outcomes next, and took .26 GB; 300 that stand for them take .04 GB.

    The action pays .3995 on average and goes on with probability 1/2: the mean return is .3995 / (1 - .9 / 2).
    """
    outcomes = [(0, 0, 1 / 1_600, state, i / 1_000) for i in range(800) for state in (-1, 0)]
    world, found = World.from_outcomes("restless", ["s"], ["a"], outcomes), []
    assert peak_of(lambda: found.append(return_distribution(world, 0, 0, np.array([0]), gamma=0.9))) < 100_000_000
    assert found[0].locations @ found[0].masses == pytest.approx(0.3995 / 0.55, abs=1e-5)


@pytest.mark.parametrize("policy", ["shared", "per_gamma"])
def test_the_indicators_that_are_not_stored_learn_what_stored_ones_learn(policy):
    world, gammas = load_world("fig6_chain"), np.array([0.3, 0.6, 0.9])
    stored = LaplaceTD(world, gammas, channels=np.eye(world.reward_values.size), policy=policy)
    made = LaplaceTD(world, gammas, policy=policy)
    list(learn(world, [made, stored], Schedule(episodes=200, seed=4)))
    np.testing.assert_array_equal(made.table, stored.table)
    np.testing.assert_array_equal(made.values, stored.values)


def test_products_with_rewards_by_sensitivities_in_blocks_are_whole_products(monkeypatch, subtests):
    """The whole matrices are the slow twin; blocks of one column, of some, and one block of all."""
    rng = np.random.default_rng(8)
    rewards, thetas, weights = np.sort(rng.normal(size=7)), np.sort(rng.normal(size=11)), rng.normal(size=(2, 3, 7))
    masses = encoding.bin_masses(rewards, thetas, 3.0)
    for numbers in (1, 30, 10_000):
        with subtests.test(numbers=numbers):
            monkeypatch.setattr(encoding, "_BLOCK", numbers)
            found = encoding.encoded(weights, rewards, thetas, 3.0)
            np.testing.assert_allclose(found, weights @ encoding.activation(rewards, thetas, 3.0), atol=1e-14)
            found = encoding.smeared(weights, rewards, thetas, 3.0)
            np.testing.assert_allclose(found, weights @ masses, atol=1e-14)
            held, proxy = encoding.read_at_midpoints(rewards, thetas, 3.0)
            np.testing.assert_allclose(held, masses.sum(axis=1), atol=1e-14)
            np.testing.assert_allclose(proxy, masses @ encoding.theta_midpoints(thetas), atol=1e-14)


def test_a_softer_slope_in_blocks_is_the_whole_map(monkeypatch, subtests):
    """S as one matrix is the slow twin; blocks of 1, of 7 and of all rows."""
    rng = np.random.default_rng(3)
    thetas = np.sort(rng.uniform(0, 10, 30))
    values = np.sort(rng.uniform(0, 2, (2, 4, 30)))[..., ::-1]
    for open_ends in (False, True):
        space = GammaSpace(values, values[..., 0] + 1, np.array([0.2, 0.4, 0.6, 0.8]), thetas, open_ends, 3 * thetas)
        whole = space.differences @ softening(space.places, 0.4, open_ends)
        for numbers in (1, 30 * 7, 10_000):
            with subtests.test(open_ends=open_ends, numbers=numbers):
                monkeypatch.setattr(gamma_space_module, "_SOFTENED", numbers)
                np.testing.assert_allclose(softened(space, 0.4).differences, whole, atol=1e-12)


def test_a_softer_slope_takes_memory_in_proportion(monkeypatch):
    """5,000 x 5,000 doubles would be 200 MB."""
    monkeypatch.setattr(gamma_space_module, "_SOFTENED", 200_000)
    thetas = np.linspace(0, 10, 5_000)
    values = np.broadcast_to(np.linspace(1, 0, 5_000), (1, 2, 5_000))
    space = GammaSpace(values, values[..., 0], np.array([0.5, 0.9]), thetas, places=2.5 * np.arange(5_000))
    assert peak_of(lambda: softened(space, 0.5)) < 20_000_000


def test_the_reward_nearest_to_a_midpoint_is_that_of_all_distances():
    """All distances at once are the slow twin; on a grid of thetas that puts midpoints halfway between rewards."""
    found = study(load_world("two_branch"), Settings(thetas=61, theta_min=-5.0, theta_max=25.0))
    distances = np.abs(found.midpoints[:, None] - found.world.reward_values)
    np.testing.assert_array_equal(_nearest(found), distances.argmin(axis=1))


def test_discounts_that_fall_are_found_one_by_one_as_among_all_pairs():
    """The matrix of all pairs of discounts is the slow twin."""
    rng = np.random.default_rng(5)
    for _ in range(50):
        steps = np.cumsum(rng.normal(0.3, 0.4, (4, 6)), axis=1)
        facts = conventions._Facts(steps[..., None] * np.array([1.0, 0.5]), steps, np.linspace(0.9, 0.1, 6))
        errors = facts.errors / facts.sizes
        drops = steps[:, :, None] - steps[:, None, :]
        far = drops > np.maximum(conventions._FAR * np.hypot(errors[:, None], errors), conventions._SEEN / 2)
        pairs = np.any(far & (np.arange(6)[:, None] < np.arange(6)), axis=(1, 2))
        np.testing.assert_array_equal(facts._fell, pairs)


# ---- bounds


def test_a_study_above_the_bound_of_the_process_is_refused_in_one_sentence():
    """12 x 200 x 300 = 720,000."""
    assert largest_study() == MAX_VALUES
    set_largest_study(700_000)
    with pytest.raises(InputError, match=r"^12 actions, .* 200 thetas and 300 rows .* 720,000 .* above 700,000: low"):
        check_size(12, 15, 200, 300)
    check_size(12, 15, 200, 290)
    set_largest_study(10 * MAX_VALUES)
    assert largest_study() == MAX_VALUES


def test_the_bound_holds_for_worlds_and_files_alike():
    set_largest_study(10_000)
    with pytest.raises(InputError, match="above 10,000: lower thetas"):
        study(load_world("two_branch"), Settings(thetas=100, steps=60))
    values = np.broadcast_to(np.linspace(1.2, 0, 100), (1, 2, 100))
    space = GammaSpace(values, values[..., 0], np.array([0.5, 0.6]), np.linspace(0, 1, 100))
    with pytest.raises(InputError, match="above 10,000: lower thetas"):
        study_of_gamma_space(space, Settings(steps=101))


def test_the_studies_of_several_learners_count_together():
    """3 learners x 2 actions x 150 thetas x 40 rows = 36,000 numbers, where one learner has 12,000."""
    learning = Learning(load_world("two_branch"), LearnSettings(seeds=3, episodes=5))
    for _ in learning:
        pass
    learned = learning.snapshot()
    set_largest_study(35_000)
    with pytest.raises(InputError, match=r"^3 learners, 2 actions, .* above 35,000: lower seeds, thetas"):
        bands(learned, Settings(steps=40))
    set_largest_study(36_000)
    assert len(bands(learned, Settings(steps=40)).studies) == 3


def npz(actions: int, gammas: int, thetas: int) -> bytes:
    grid, file = np.linspace(0.1, 0.9, gammas), io.BytesIO()
    values = np.broadcast_to(np.linspace(1.0, 0.0, thetas), (actions, gammas, thetas)) / (1.0 - grid)[:, None]
    np.savez_compressed(file, gamma_space=values, gammas=grid, thetas=np.arange(float(thetas)))
    return file.getvalue()


@pytest.mark.parametrize(
    ("size", "words"),
    [
        ((1, 2, 2_001), "'thetas' holds 2,001 numbers, above 2,000: save"),
        ((1, 2, 45_000), "'thetas' holds 45,000 numbers, above 2,000: save"),
        ((1, 501, 2), "'gammas' holds 501 numbers, above 500: save"),
        ((5_001, 2, 2), "'gamma_space' holds 5,001 actions, above 5,000: save"),
    ],
)
def test_a_file_has_the_bounds_of_a_world(size, words):
    with pytest.raises(InputError, match=words):
        read_gamma_space(npz(*size))


def test_a_file_at_the_bounds_of_a_world_is_read():
    assert read_gamma_space(npz(1, 2, 2_000)).values.shape == (1, 2, 2_000)
    assert read_gamma_space(npz(1, 500, 2)).values.shape == (1, 500, 2)


def test_the_arrays_of_a_file_are_no_larger_than_a_study_may_be():
    """2 x 40 x 1,000 values and the grids are 81,040 numbers."""
    content = npz(2, 40, 1_000)
    set_largest_study(81_040)
    read_gamma_space(content)
    set_largest_study(81_039)
    with pytest.raises(InputError, match="brings the arrays above 0 MB; save fewer states or thetas"):
        read_gamma_space(content)


def test_one_state_of_a_file_does_not_keep_the_others():
    content = io.BytesIO()
    values = np.broadcast_to(np.linspace(1.5, 0, 20), (300, 2, 2, 20))
    np.savez(content, gamma_space=values, gammas=[0.4, 0.5], thetas=np.arange(20.0))
    read = read_gamma_space(content.getvalue(), state="7")
    assert read.values.base is None or read.values.base.nbytes == read.values.nbytes
