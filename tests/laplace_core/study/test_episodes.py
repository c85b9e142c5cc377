"""Acting for whole episodes: values in every state, the rule they make, and what it loses."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError, Settings, load_world, study
from laplace_core.inverse import NORMALISATIONS
from laplace_core.planning import finite_horizon_optimum, reward_indicator_basis
from laplace_core.study import episodes
from laplace_core.study.episodes import (
    constant_horizon_loss,
    constant_horizon_values,
    episode_regret,
    episode_regret_of,
    rule_actions,
    values_everywhere,
)
from laplace_core.study.pipeline import grids, policies_of
from laplace_core.study.settings import resolve
from tests.support.random_worlds import worlds
from tests.support.slow_twins import rule_by_recursion

GAMMA = 0.9


def optimal_rule(optimum: np.ndarray) -> np.ndarray:
    """The rule that reads the optimum itself, ``(T, S)``, from ``(T, S, A)``."""
    return rule_actions(np.moveaxis(optimum, 0, -1))


# --- values in every state ---


def test_values_everywhere_equal_one_study_a_state(subtests):
    worlds = [
        ("two_decisions", {"auxiliary": True}),
        ("double_chain", {}),
        ("cliff_grid", {"width": 3, "height": 3, "slip": 0.2}),
    ]
    for (name, params), how, dt, softness in product(worlds, NORMALISATIONS, (1.0, 0.25), (0.0, 0.2)):
        with subtests.test(name, normalise=how, time_step=dt, softness=softness):
            world = load_world(name, params)
            settings = Settings(
                gammas=12, thetas=30, steps=16, normalise=how, time_step=dt, softness=softness, alpha=0.05
            )
            fast = values_everywhere(world, resolve(settings, world))
            for state in range(world.n_states):
                one = study(world, replace(settings, state=str(state)))
                np.testing.assert_allclose(fast[state], one.decoded.horizon_values, rtol=0, atol=1e-9)


@given(worlds(), st.sampled_from(NORMALISATIONS), st.sampled_from(["shared", "per_gamma"]))
def test_values_everywhere_equal_one_study_a_state_in_random_worlds(world, normalise, policy):
    settings = Settings(gammas=8, thetas=12, steps=6, alpha=0.05, normalise=normalise, policy=policy)
    fast = values_everywhere(world, resolve(settings, world))
    for state in range(world.n_states):
        one = study(world, replace(settings, state=str(state)))
        np.testing.assert_allclose(fast[state], one.decoded.horizon_values, rtol=0, atol=1e-9)


def test_too_much_work_is_refused(monkeypatch):
    world = load_world("two_branch")
    settings = resolve(Settings(gammas=3), world)
    monkeypatch.setattr(episodes, "MAX_WORK", 3 * 2 * 3 - 1)  # states, actions, steps
    with pytest.raises(InputError, match="lower steps or thetas"):
        values_everywhere(world, settings)
    monkeypatch.setattr(episodes, "MAX_WORK", 3 * 2 * 3)
    assert values_everywhere(world, settings).shape == (3, 2, 3)


# --- the rule ---


def test_a_rule_reads_the_column_of_each_time_to_go():
    # Two actions, one state: the better one by column.
    values = np.zeros((1, 2, 8))
    values[0, 1] = [-1, -1, -1, 1, -1, -1, -1, 1]
    np.testing.assert_array_equal(rule_actions(values)[:, 0], [0, 0, 0, 1, 0, 0, 0, 1])
    # Rows of 1/3: column k is T = (k + 2) / 3, so T = 1, 2, 3 are columns 1, 4, 7.
    values[0, 1] = [-1, 1, -1, -1, -1, -1, -1, 1]
    np.testing.assert_array_equal(rule_actions(values, 1 / 3)[:, 0], [1, 0, 1])
    # Rows of .4: column k is T = .4 k + .7; T = 1, 2, 3 are nearest to columns 1 (1.1), 3 (1.9) and 6 (3.1).
    values[0, 1] = [-1, 1, -1, 1, -1, -1, 1, -1]
    np.testing.assert_array_equal(rule_actions(values, 0.4)[:, 0], [1, 1, 1])


def test_ties_in_a_rule_go_to_the_lowest_action():
    values = np.zeros((2, 3, 1))
    values[0, :, 0], values[1, :, 0] = [1.0, 1.0 + 5e-10, 0.0], [0.0, 1.0, 1.0]
    np.testing.assert_array_equal(rule_actions(values), [[0, 1]])


# --- regret ---


@given(worlds())
def test_the_optimal_rule_regrets_nothing(world):
    optimum = finite_horizon_optimum(world, 8, GAMMA)
    np.testing.assert_allclose(episode_regret(world, optimal_rule(optimum), GAMMA, optimum), 0.0, atol=1e-8)


@given(st.data())
def test_no_rule_beats_the_optimum_and_regret_is_what_it_lacks(data):
    world = data.draw(worlds(max_states=4))
    size = 4 * world.n_states
    chosen = data.draw(st.lists(st.integers(0, world.n_actions - 1), min_size=size, max_size=size))
    rule = np.array(chosen).reshape(4, world.n_states)
    optimum = finite_horizon_optimum(world, 6, GAMMA)  # may be longer than the rule
    regrets = episode_regret(world, rule, GAMMA, optimum)
    assert np.all(regrets >= -1e-12)
    for t, s in np.ndindex(4, world.n_states):
        collected = rule_by_recursion(world, rule, s, t + 1, gamma=GAMMA)
        assert regrets[t, s] == pytest.approx(optimum[t, s].max() - collected, abs=1e-12)


@given(worlds(max_states=4), st.integers(1, 4))
def test_a_constant_horizon_repeats_one_row_of_the_rule(world, horizon):
    optimum = finite_horizon_optimum(world, 4, GAMMA)
    rule = optimal_rule(optimum)
    repeated = np.array([rule[horizon - 1]] * 4)
    np.testing.assert_array_equal(
        episode_regret(world, rule, GAMMA, optimum, constant_horizon=horizon),
        episode_regret(world, repeated, GAMMA, optimum),
    )


def test_acting_for_a_constant_horizon_costs_the_reward_that_no_longer_comes():
    # two_branch with three steps to go and always acting for T = 1 takes 5 instead of .81 * 10 = 8.1. Acting
    # for T = 3 throughout waits for a reward that comes too late when only one or two steps are left.
    world = load_world("two_branch")
    optimum = finite_horizon_optimum(world, 3, GAMMA)
    rule = optimal_rule(optimum)
    np.testing.assert_allclose(
        episode_regret(world, rule, GAMMA, optimum, constant_horizon=1)[:, 0], [0, 0, 3.1], atol=1e-12
    )
    np.testing.assert_allclose(
        episode_regret(world, rule, GAMMA, optimum, constant_horizon=3)[:, 0], [5.0, 5.0, 0.0], atol=1e-12
    )


def test_rescaled_rows_cost_what_the_repeated_reward_promises():
    # Table of the toy MDP: rescaled rows read 14.85 for the short branch, whose episode pays 5; the long one
    # pays .99^2 * 10 = 9.801 with three steps to go. Rows left alone choose it.
    world = load_world("two_branch")
    common = {"gammas": 15, "alpha": 0.2, "thetas": 150, "theta_min": -2.0, "theta_max": 12.0, "slope": 25.0}
    found = {
        how: episode_regret_of(world, resolve(Settings(normalise=how, **common), world)) for how in ("none", "paper")
    }
    np.testing.assert_allclose(found["none"][:, 0], 0.0, atol=1e-12)
    np.testing.assert_allclose(found["paper"][:, 0], [0.0, 0.0, 4.801], atol=1e-12)


@pytest.mark.parametrize("time_step", [1.0, 0.25])
def test_regret_of_a_study_covers_the_whole_steps_it_decodes(time_step):
    world = load_world("two_branch")
    settings = resolve(Settings(time_step=time_step), world)
    assert settings.steps == 3 / time_step
    regrets = episode_regret_of(world, settings)
    assert regrets.shape == (3, world.n_states)
    assert np.all(regrets >= -1e-12)


@given(worlds(max_states=4))
def test_constant_horizons_all_at_once_equal_one_after_the_other(world):
    optimum = finite_horizon_optimum(world, 5, GAMMA)
    rule = optimal_rule(optimum)
    together = constant_horizon_values(world, rule, GAMMA)
    for horizon in range(1, 6):
        regrets = episode_regret(world, rule, GAMMA, optimum, constant_horizon=horizon)
        expected = optimum.max(axis=2)[horizon - 1] - regrets[horizon - 1]
        np.testing.assert_allclose(together[horizon - 1], expected, atol=1e-12)


def test_a_constant_deadline_in_the_settings_keeps_t_for_the_whole_episode():
    world = load_world("cliff_grid")
    settings = {how: resolve(Settings(deadline=how), world) for how in ("time_to_go", "constant")}
    regrets = {how: episode_regret_of(world, chosen) for how, chosen in settings.items()}
    for horizon in (1, 7, 20):
        expected = episode_regret_of(world, settings["time_to_go"], constant_horizon=horizon)[horizon - 1]
        np.testing.assert_allclose(regrets["constant"][horizon - 1], expected, atol=1e-12)
    loss, best = constant_horizon_loss(world, settings["constant"])
    np.testing.assert_allclose(loss, regrets["constant"] - regrets["time_to_go"], atol=1e-12)
    np.testing.assert_allclose(best, finite_horizon_optimum(world, len(best), 0.99).max(axis=2))


def test_a_learner_that_holds_the_exact_basis_loses_what_exact_values_lose():
    world = load_world("two_decisions")
    for normalise in ("none", "paper"):
        for deadline in ("time_to_go", "constant"):
            settings = resolve(Settings(world="two_decisions", normalise=normalise, deadline=deadline), world)
            gammas = grids(settings)[0]
            policies = policies_of(world, gammas, settings.policy, settings.acting_gamma)
            bases = np.array([reward_indicator_basis(world, s, gammas, policies) for s in range(world.n_states)])
            np.testing.assert_allclose(
                episode_regret_of(world, settings, learned=bases), episode_regret_of(world, settings), atol=1e-9
            )
            # One that has learned nothing ties everywhere, takes the first action, and loses more somewhere.
            nothing = episode_regret_of(world, settings, learned=np.zeros_like(bases))
            first = rule_actions(np.zeros((world.n_states, world.n_actions, settings.steps)))
            if deadline == "time_to_go":
                optimum = finite_horizon_optimum(world, len(first), settings.acting_gamma)
                expected = episode_regret(world, first, settings.acting_gamma, optimum)
                np.testing.assert_allclose(nothing, expected, atol=1e-12)
