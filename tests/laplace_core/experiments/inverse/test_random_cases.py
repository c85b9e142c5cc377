"""Random cases of the study of the inverse, against simulation and dense solves."""

import numpy as np
import pytest

from laplace_core.code.gamma_space import bin_differences
from laplace_core.experiments.inverse.random_cases import random_case
from laplace_core.inverse import transform_matrix
from tests.support.slow_twins import as_table, dense_model


@pytest.fixture(scope="module")
def cases():
    return [random_case(np.random.default_rng([7, number])) for number in range(80)]


def test_all_kinds_of_worlds_are_drawn(cases):
    names = {case.world.name for case in cases}
    assert {"two decisions", "layers", "tree", "cycles", "long chain", "grid", "continuing", "idling", "rich"} <= names
    assert {case.settings.time_step for case in cases} == {1.0, 0.5, 0.25}
    assert max(case.settings.steps for case in cases) >= 200
    assert max(case.world.reward_values.size for case in cases) >= 20
    assert {case.policy.ndim for case in cases} == {1, 2}
    endless = [case.masses.sum(axis=-1)[:, -1].min() for case in cases if case.settings.time_step == 1.0]
    assert max(endless) == pytest.approx(1.0)


def test_true_timelines_are_feasible_and_have_the_values(cases, subtests):
    for number, case in enumerate(cases):
        with subtests.test(number=number, world=case.world.name):
            survival = case.masses.sum(axis=-1)
            assert case.masses.min() >= -1e-12
            np.testing.assert_allclose(survival[:, 0], 1.0)
            # Small discounts see no further than the rows.
            gammas = np.array([0.1, 0.3])
            s = case.settings
            seen = transform_matrix(gammas, s.steps, s.time_step) @ case.masses
            space = case.gamma_space(gammas)
            left = gammas ** (s.steps * s.time_step) / (1.0 - gammas)
            problem = bin_differences(space.values, space.constant, open_ends=True)
            assert np.all(np.abs(seen - problem).max(axis=(0, 2)) <= left + 1e-9)


def test_a_timeline_is_that_of_the_policy(cases):
    """Step by step with dense matrices, for worlds of few states."""
    few = [case for case in cases if case.world.n_states <= 9 and case.settings.time_step == 1.0][:10]
    assert len(few) == 10
    for case in few:
        moves, paid = dense_model(case.world)
        table = as_table(case.world, case.policy)
        for action in range(case.world.n_actions):
            expected = [paid[case.state, action] @ case.world.reward_values]
            at = moves[case.state, action]
            for _ in range(case.settings.steps - 1):
                expected.append(at @ ((table[..., None] * paid).sum(axis=1) @ case.world.reward_values))
                at = at @ (table[..., None] * moves).sum(axis=1)
            np.testing.assert_allclose(case.rewards[action], expected, atol=1e-10)


def test_noise_has_the_size_that_the_problem_states(cases):
    """Of the tails: masses have it twice, but the last bin and the constant channel, which are one value each."""
    case = next(case for case in cases if case.world.name == "rich")
    exact, noisy = case.problem(), case.problem(0.01, seed=3)
    assert noisy.deviations is not None
    errors = (noisy.masses - exact.masses) / noisy.deviations[:, None]
    assert np.sqrt((errors[..., :-1] ** 2).mean()) == pytest.approx(np.sqrt(2.0), rel=0.1)
    np.testing.assert_allclose(noisy.deviations, 0.01 / (1.0 - noisy.gammas))


def test_the_same_seed_draws_the_same_case():
    first, second = (random_case(np.random.default_rng(5)) for _ in range(2))
    assert first.settings == second.settings
    np.testing.assert_array_equal(first.policy, second.policy)
    np.testing.assert_array_equal(first.masses, second.masses)
