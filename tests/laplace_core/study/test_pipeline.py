"""The whole line: the toy MDP's table, the Fig. 6 chain, and the truth beside the decoded."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError, Settings, load_world, study, study_of_gamma_space
from laplace_core.code.encoding import activation, bin_masses
from laplace_core.inverse import transform_matrix
from laplace_core.planning import finite_horizon_optimum, greedy_policy, reward_indicator_basis, reward_timeline
from laplace_core.study.pipeline import on_rows, row_shares
from laplace_core.study.settings import resolve
from laplace_core.study.trials import Trials
from laplace_core.worlds import END, Outcome, World
from tests.support.hostile import assert_refused
from tests.support.random_worlds import worlds

TOY = {"gammas": 15, "alpha": 0.2, "thetas": 150, "theta_min": -2.0, "theta_max": 12.0, "slope": 25.0, "steps": 3}
"""The paper's toy MDP: 15 inverse-log discounts, 150 sensitivities on [-2, 12], slope 25, K = 3."""

SMALL = Settings(gammas=6, gamma_min=0.2, gamma_max=0.95, spacing="linear", thetas=9, alpha=0.05)


def truth_of(world, **changes):
    return study(world, replace(SMALL, **changes)).truth


# --- golden values ---


@pytest.mark.parametrize(
    ("auxiliary", "normalise", "rewards", "short", "long", "picks"),
    [
        # Rows rescaled to 1: whatever is left after the end becomes a 5 again, 5 (1 + .99 + .9801) = 14.85.
        (False, "paper", [5.0, 5.0, 5.0], 14.85, 9.74, 0),
        # The paper's remedy: zero rewards until both branches are equally long, so every row has its mass.
        (True, "paper", [4.81, 0.15, 0.04], 5.00, 9.74, 1),
        # Rows left alone: a vanishing row says that the episode is over, and no remedy is needed.
        (False, "none", [4.81, 0.16, 0.04], 5.00, 9.70, 1),
    ],
)
def test_toy_table(auxiliary, normalise, rewards, short, long, picks):
    found = study(load_world("two_branch", {"auxiliary": auxiliary}), Settings(normalise=normalise, **TOY)).decoded
    np.testing.assert_allclose(found.expected_reward[0], rewards, atol=0.0051)
    np.testing.assert_allclose(found.horizon_values[:, 2], [short, long], atol=0.005)
    assert found.actions[2] == picks


def test_mass_and_survival_vanish_after_the_end():
    # The short branch is over after one step: .96, .03, .01 of probability are decoded, and .04 is leakage.
    found = study(load_world("two_branch"), Settings(**TOY)).decoded
    np.testing.assert_allclose(found.survival[0], [0.96, 0.03, 0.01], atol=0.005)
    np.testing.assert_allclose(found.mass, found.survival, atol=1e-9)  # the sensitivities overhang every reward


def test_gamma_space_of_two_branch_in_closed_form():
    # Short: f(5). Long: (1 + g) f(0) + g^2 f(10). Constant channel: 1 and 1 + g + g^2.
    space = study(load_world("two_branch"), Settings(**TOY)).gamma_space
    g = space.gammas[:, None]
    f0, f5, f10 = activation([0.0, 5.0, 10.0], space.thetas, 25.0)
    np.testing.assert_allclose(space.values, [0 * g + f5, (1 + g) * f0 + g**2 * f10], atol=1e-12)
    np.testing.assert_allclose(space.constant, [1 + 0 * g[:, 0], (1 + g + g**2)[:, 0]], atol=1e-12)
    np.testing.assert_allclose(space.differences, space.values[..., :-1] - space.values[..., 1:])


def test_fig6_chain_is_recovered_within_one_percent_of_its_peak():
    found = study(load_world("fig6_chain"), Settings())
    off = np.abs(found.decoded.tau_space - found.truth.tau_space).max()
    assert off < 0.01 * found.truth.tau_space.max()


@pytest.mark.parametrize("params", [{}, {"r1": 9.9}, {"auxiliary": True}, {"slip": 0.2}])
def test_default_settings_choose_the_best_action_for_every_horizon(params):
    found = study(load_world("two_branch", params), Settings())
    np.testing.assert_array_equal(found.decoded.actions, found.truth.optimal_action)


def test_a_shared_policy_decides_later_steps_for_its_own_discount_not_for_the_horizon():
    # With two steps to go, going on and taking 5 is worth .99 * 5 = 4.95, above leaving with 4. The policy of
    # gamma .99 waits for 10 at the branch, so that its own timeline holds nothing in two steps.
    found = study(load_world("two_decisions"), Settings())
    assert found.truth.optimum[1, 1] == pytest.approx(4.95)
    assert found.truth.horizon_values[1, 1] == 0.0
    assert (found.truth.optimal_action[1], found.decoded.actions[1]) == (1, 0)


def test_default_settings_suit_the_rewards():
    # Rewards 0 to 10: 20% overhang, [-2, 12]; 150 thresholds are 14 / 149 apart; slope 2.35 / spacing = 25.0.
    settings = resolve(Settings(), load_world("two_branch"))
    assert (settings.theta_min, settings.theta_max, settings.slope) == (-2.0, 12.0, 25.0)
    assert (settings.policy, settings.normalise, settings.acting_gamma, settings.steps) == ("shared", "none", 0.99, 3)
    assert resolve(settings, load_world("two_branch")) == settings
    assert resolve(Settings(time_step=0.25), load_world("two_branch")).steps == 12  # the same stretch of time


# --- the truth ---


@given(worlds(), st.sampled_from([0.5, 0.9]))
def test_truth_at_whole_steps(world, gamma):
    found = truth_of(world, steps=7, acting_gamma=gamma)
    timeline = reward_timeline(world, 0, greedy_policy(world, gamma), 7)
    space = study(world, replace(SMALL, steps=7, acting_gamma=gamma))
    masses = bin_masses(world.reward_values, space.gamma_space.thetas, space.settings.slope)
    np.testing.assert_allclose(found.tau_space, timeline @ masses, atol=1e-12)
    np.testing.assert_allclose(found.survival, timeline.sum(axis=2), atol=1e-12)
    np.testing.assert_allclose(found.expected_reward, timeline @ world.reward_values, atol=1e-12)
    for a, k in np.ndindex(world.n_actions, 7):
        value = sum(gamma**tau * found.expected_reward[a, tau] for tau in range(k + 1))
        assert found.horizon_values[a, k] == pytest.approx(value, abs=1e-12)
    np.testing.assert_array_equal(found.optimum, finite_horizon_optimum(world, 7, gamma, 0).T)


@given(worlds(ends=True), st.sampled_from([1.0, 0.5, 0.25, 1 / 3]))
def test_the_transform_of_the_true_timeline_is_the_gamma_space(world, time_step):
    # After 60 steps less than 2^-60 of any episode is left, so that the rows of 60 steps hold it all.
    found = study(world, replace(SMALL, steps=round(60 / time_step), time_step=time_step))
    space, truth = found.gamma_space, found.truth
    F = transform_matrix(space.gammas, round(60 / time_step), time_step)
    assert np.abs(F @ truth.tau_space - space.differences).max() < 1e-9
    assert np.abs(F @ truth.survival[..., None] - space.constant[..., None]).max() < 1e-9


@given(worlds(), st.sampled_from([1.0, 0.5, 0.25]))
def test_true_survival_is_a_probability_that_never_rises(world, time_step):
    survival = truth_of(world, steps=20, time_step=time_step).survival[:, :: round(1 / time_step)]
    assert np.all((survival >= 0) & (survival <= 1 + 1e-12))
    assert np.all(np.diff(survival, axis=1) <= 1e-12)


@given(worlds(), st.sampled_from([1 / 3, 0.2]))
def test_finer_time_keeps_the_truth_of_whole_steps(world, time_step):
    # An odd number of rows a step: whole horizons are columns of their own.
    rows = round(1 / time_step)
    coarse, fine = truth_of(world, steps=6), truth_of(world, steps=6 * rows, time_step=time_step)
    half = rows // 2
    for name in ("tau_space", "survival", "expected_reward"):
        one, other = getattr(coarse, name), getattr(fine, name)
        np.testing.assert_allclose(other[:, ::rows], one, atol=1e-12)
        assert np.abs(np.delete(other, np.s_[::rows], axis=1)).max() == 0.0  # nothing happens between two steps
    np.testing.assert_allclose(fine.horizon_values[:, half::rows], coarse.horizon_values, atol=1e-12)
    np.testing.assert_array_equal(fine.optimum[:, half::rows], coarse.optimum)


@pytest.mark.parametrize("time_step", [1.0, 0.5, 0.25, 0.1])
def test_rewards_are_drawn_where_the_transform_puts_them(time_step):
    # The double chain pays .6 * 1/2 at step 2 and 1 * 1/2 at step 6: centroid (.3 * 2 + .5 * 6) / .8 = 4.5.
    found = study(load_world("double_chain"), Settings(steps=round(9 / time_step), time_step=time_step, alpha=1e-4))
    for rewards in (found.truth.expected_reward[0], found.decoded.expected_reward[0]):
        assert rewards @ found.taus / rewards.sum() == pytest.approx(4.5, abs=0.03)


@pytest.mark.parametrize("time_step", [1.0, 0.5, 1 / 3])
@pytest.mark.parametrize(("length", "steps"), [(5, 5), (5, 3), (3, 7)])
def test_values_of_steps_lie_on_rows_as_the_shares_put_them(length, steps, time_step):
    values = np.random.default_rng(0).uniform(size=(2, length, 3))
    expected = np.einsum("kn,anv->akv", row_shares(steps, length, time_step), values)
    np.testing.assert_allclose(on_rows(values, steps, time_step), expected, rtol=0, atol=1e-15)


def test_row_shares_by_hand():
    np.testing.assert_array_equal(row_shares(3, 3, 1.0), np.eye(3))
    # Rows at 0, .4, .8, 1.2: step 1 lies halfway between the third and the fourth.
    np.testing.assert_allclose(row_shares(4, 2, 0.4), [[1, 0], [0, 0], [0, 0.5], [0, 0.5]], atol=1e-15)
    # Rows at 0, 1/3, ...: 1 is the fourth, although 1 / (1/3) is not quite 3 in float64.
    np.testing.assert_array_equal(np.flatnonzero(row_shares(7, 3, 1 / 3)), [0, 10, 20])


def test_the_true_reward_of_a_step_is_whole_at_any_time_step():
    # The short branch pays 5 at once: its row holds 5 of 5, where the rows of 0.2.0 held 3.125 together.
    truth = study(load_world("two_branch"), Settings(time_step=0.25)).truth
    np.testing.assert_allclose(truth.expected_reward[0], [5.0] + [0.0] * 11)
    # The long branch pays 10 at step 2, which is row 8.
    np.testing.assert_allclose(truth.expected_reward[1], [0.0] * 8 + [10.0] + [0.0] * 3)


def test_optimum_of_a_fractional_horizon_is_that_of_the_nearest_whole_step():
    truth = study(load_world("two_branch"), Settings(time_step=0.25)).truth
    # Columns at .625, .875, ..., 3.375; long is worth 9.801 from T = 3 on, and 2.625 is nearest to 3.
    np.testing.assert_allclose(truth.optimum[1], [0.0] * 8 + [9.801] * 4)


def test_a_step_counts_from_its_row_on():
    # Rows of .4 lie at .4 k: the sixth is at 2, where the third step pays 10; the fifth, T = 2.3, has none of it.
    truth = study(load_world("two_branch"), Settings(steps=6, time_step=0.4)).truth
    np.testing.assert_allclose(truth.horizon_values[1, -2:], [0.0, 9.801], atol=1e-12)
    assert truth.optimum[1, -1] == pytest.approx(9.801)


# --- settings ---


def test_per_gamma_takes_each_discounts_own_policy_and_the_truth_stays_with_the_acting_one():
    world, settings = load_world("two_decisions"), Settings(gammas=8, thetas=20, spacing="linear")
    own = study(world, replace(settings, policy="per_gamma"))
    for g, gamma in enumerate(own.gamma_space.gammas):
        basis = reward_indicator_basis(world, 0, np.array([gamma]), [greedy_policy(world, float(gamma))])
        expected = basis[:, 0] @ activation(world.reward_values, own.gamma_space.thetas, own.settings.slope)
        np.testing.assert_allclose(own.gamma_space.values[:, g], expected, atol=1e-12)
    shared = study(world, settings)
    assert np.abs(own.gamma_space.values - shared.gamma_space.values).max() > 0.1
    np.testing.assert_array_equal(own.truth.tau_space, shared.truth.tau_space)


@pytest.mark.parametrize("normalise", ["none", "survival", "paper"])
def test_a_gamma_space_from_elsewhere_is_decoded_in_the_same_way(normalise):
    chosen = {"normalise": normalise, "alpha": 0.2, "steps": 4, "time_step": 0.5, "softness": 0.1}
    found = study(load_world("two_branch"), Settings(gammas=15, **chosen))
    alone = study_of_gamma_space(found.gamma_space, Settings(world="saved.npz", **chosen))
    assert alone.truth is None
    for name in ("tau_space", "survival", "expected_reward", "horizon_values"):
        np.testing.assert_array_equal(getattr(alone.decoded, name), getattr(found.decoded, name))
    with pytest.raises(InputError, match="gammas cannot be chosen"):
        study_of_gamma_space(found.gamma_space, Settings(gammas=3))


def test_rows_and_columns_know_their_time():
    found = study(load_world("two_branch"), Settings(time_step=0.25))
    np.testing.assert_allclose(found.taus[:3], [0, 0.25, 0.5])
    np.testing.assert_allclose(found.horizons[[0, 3, 11]], [0.625, 1.375, 3.375])
    assert found.row_at(1.4) == 3


def test_settings_that_do_not_fit_are_refused(subtests):
    for settings, named in [
        ({"state": "nowhere"}, "nowhere"),
        ({"thetas": 1}, "thetas"),
        ({"steps": 0}, "steps"),
        ({"acting_gamma": 1.0}, "acting_gamma"),
        ({"solver": "nonsense"}, "solver"),
        ({"gamma_min": 0.9, "gamma_max": 0.1}, "gamma-min"),
        ({"theta_min": 3.0, "theta_max": 1.0}, "theta-min"),
    ]:
        with subtests.test(settings=settings, named=named), pytest.raises(InputError, match=named):
            study(load_world("two_branch"), Settings(**settings))


def test_a_study_too_large_to_hold_is_refused():
    # 13 actions x 2000 thetas x 2000 rows are 52 million numbers, above 50 million.
    rows = [Outcome(0, a, 1.0, END, a) for a in range(13)]
    world = World.from_outcomes("wide", ["s"], [f"a{a}" for a in range(13)], rows)
    with pytest.raises(InputError, match="52,000,000"):
        study(world, Settings(thetas=2000, steps=2000))


def test_a_study_records_the_world_that_it_was_made_of():
    found = study(load_world("cliff_grid", {"slip": "0.1"}), Settings())
    assert found.settings.world == "cliff_grid"
    assert found.settings.params == (("slip", 0.1),)


def test_a_policy_of_ones_own_is_what_every_discount_and_the_truth_follow():
    # In two_decisions, after "go on" a coin between r1 = 5 at once and r2 = 10 two steps later: E[r] at tau = 1 is
    # 2.5 and at tau = 3 it is 5, with survival 1, 1, .5, .5.
    world, coin = load_world("two_decisions"), np.full((4, 2), 0.5)
    found = study(world, Settings(alpha=1e-7, steps=4), policy=coin)
    np.testing.assert_allclose(found.truth.expected_reward[1], [0, 2.5, 0, 5])
    np.testing.assert_allclose(found.truth.survival[1], [1, 1, 0.5, 0.5])
    np.testing.assert_allclose(found.decoded.expected_reward[1], [0, 2.5, 0, 5], atol=0.01)
    greedy = study(world, Settings(alpha=1e-7, steps=4))
    same = study(world, Settings(alpha=1e-7, steps=4), policy=greedy_policy(world, 0.99))
    np.testing.assert_array_equal(same.decoded.tau_space, greedy.decoded.tau_space)
    with pytest.raises(InputError, match="policy"):
        study(world, Settings(), policy=np.zeros((2, 2)))


def test_an_inverse_for_every_horizon_is_refused_where_it_takes_minutes(capsys):
    # 1,000 horizons x 1,000 rows x (15^2 + 2 actions x 150 thetas, which rescaled rows need) = 5.25e8.
    words = ["decode", "two_branch", "--steps", "1000", "--normalise", "paper", "--thetas", "150", "--fold"]
    assert_refused(capsys, words, "--fold", "1,000 horizons", "525,000,000", "lower steps")
    # Rows that are not rescaled need no tau-space: 229 million would still be too many, 500 horizons are 57.
    found = study(load_world("two_branch"), Settings(world="two_branch", steps=500, fold=True))
    assert found.decoded.horizon_values.shape == (2, 500)


def test_no_remedy_decodes_more_rows_where_every_horizon_has_its_own_number():
    found = study(load_world("two_branch"), Settings(world="two_branch", fold=True, used=1.0, alpha=0.01))
    assert not [each for each in Trials(found, found.row).switches if "steps" in each.changes]
