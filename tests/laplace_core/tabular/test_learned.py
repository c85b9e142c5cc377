"""Learners in turns: defaults that learn every preset, curves, bands and the reading of one learner's table."""

from dataclasses import replace

import numpy as np
import pytest

from laplace_core import PRESETS, InputError, Settings, load_world, study
from laplace_core.study.pipeline import basis_of
from laplace_core.tabular import (
    CURVE_NAMES,
    LEARN_SCHEMA,
    QUANTILE_LEVELS,
    Learned,
    Learning,
    LearnSettings,
    bands,
    parse_learn_settings,
    read_learned,
    resolve_learning,
    study_of,
)
from laplace_core.tabular.peers import PlainQ
from laplace_core.tabular.td import LaplaceTD, Schedule, learn
from laplace_core.worlds import dump_world, parse_world
from tests.support.hostile import assert_one_sentence


def learned_to_the_end(world, settings: LearnSettings | None = None) -> Learned:
    learning = Learning(world, settings or LearnSettings())
    for _ in learning:
        pass
    return learning.snapshot()


@pytest.fixture(scope="module")
def coin() -> Learned:
    """Three seeds that disagree: a slippery branch after few episodes."""
    world = load_world("two_decisions", {"slip": 0.3})
    return learned_to_the_end(world, LearnSettings(episodes=60, seeds=3, seed=5, peers=True))


# --- settings ---


def test_defaults_are_complete_and_settled(subtests):
    for source in [*PRESETS, "gym:FrozenLake-v1", "gym:Taxi-v4"]:
        with subtests.test(source=source):
            world = load_world(source)
            settings = resolve_learning(LearnSettings(), world)
            assert None not in vars(settings).values()
            assert resolve_learning(settings, world) == settings
            as_text = {name: str(value) for name, value in vars(settings).items()}
            assert parse_learn_settings(as_text) == settings.chosen()


def test_the_grid_is_that_of_the_study():
    world = load_world("discounting_chain")
    s = resolve_learning(LearnSettings(), world)
    np.testing.assert_array_equal(s.discounts, study(world, Settings()).gamma_space.gammas)
    paper = resolve_learning(LearnSettings(spacing="paper"), world)
    assert (paper.gammas, paper.gamma_min, paper.gamma_max) == (15, 0.01, 0.99)
    assert resolve_learning(LearnSettings(acting_gamma=0.9), world).peer_gamma == 0.9


def test_settings_out_of_range_are_refused(subtests):
    for parameter in [p for p in LEARN_SCHEMA if p.type in (int, float)]:
        for beyond in ["low", "high"]:
            with subtests.test(parameter.name, beyond=beyond):
                value = parameter.bounds[0] - 1 if beyond == "low" else parameter.bounds[1] * 2 + 1
                with pytest.raises(InputError) as in_words:
                    parse_learn_settings({parameter.name: str(value)})
                with pytest.raises(InputError) as in_numbers:
                    resolve_learning(LearnSettings(**{parameter.name: value}), load_world("two_branch"))
                for error in (in_words, in_numbers):
                    assert_one_sentence(f"laplace: {error.value}", parameter.name)


def test_settings_that_contradict_each_other_are_refused(subtests):
    for given, named in [
        ({"expectiles": 4}, "expectiles"),
        ({"rate_first": 0.5, "rate_floor": 0.6}, "rate_floor"),
        ({"epsilon_first": 0.1, "epsilon_floor": 0.2}, "epsilon_floor"),
        ({"gamma_min": 0.9, "gamma_max": 0.5}, "gamma"),
        ({"starts": "nowhere"}, "starts"),
        ({"policy": "mixed"}, "policy"),
    ]:
        with subtests.test(given=given, named=named):
            with pytest.raises(InputError) as error:
                resolve_learning(LearnSettings(**given), load_world("two_branch"))
            assert_one_sentence(f"laplace: {error.value}", named)


def test_tables_that_no_file_would_hold_are_refused_before_they_are_made():
    with pytest.raises(InputError, match="lower seeds or gammas"):
        Learning(load_world("gym:Taxi-v4"), LearnSettings(gammas=500, seeds=8))
    with pytest.raises(InputError, match="no_such"):
        parse_learn_settings({"no_such": "1"})


# --- learning ---


@pytest.mark.parametrize("name", PRESETS)
def test_the_defaults_learn_every_preset_within_two_percent(name):
    learned = learned_to_the_end(load_world(name))
    assert learned.finished
    assert learned.curves[0]["error"][-1] < 0.02
    assert 150 <= learned.curves[0]["error"].size <= 320


def test_the_error_is_the_distance_from_the_exact_gamma_space(coin):
    for i in range(3):
        found = study_of(coin, seed_index=i)
        exact = study(coin.world, found.settings).gamma_space.values
        apart = np.abs(found.gamma_space.values - exact).max() / np.ptp(exact)
        assert coin.curves[i]["error"][-1] == pytest.approx(apart, rel=1e-5)
        assert apart > 0.001


def test_every_seed_learns_as_if_alone(coin):
    for i in range(3):
        alone = learned_to_the_end(coin.world, replace(coin.settings, seeds=1, seed=5 + i))
        np.testing.assert_array_equal(coin.basis[i], alone.basis[0])
        np.testing.assert_array_equal(coin.peers.expectile[i], alone.peers.expectile[0])
    assert not np.array_equal(coin.basis[0], coin.basis[1])


@pytest.mark.parametrize("policy", ["shared", "per_gamma"])
def test_a_learner_is_that_of_the_learning_package(policy):
    world = load_world("two_decisions", {"slip": 0.2})
    learned = learned_to_the_end(world, LearnSettings(episodes=100, policy=policy, seed=3))
    s = learned.settings
    plain = LaplaceTD(world, s.discounts, channels=None, policy=policy, acting_gamma=s.acting_gamma, rate=s.rate)
    list(learn(world, [plain], Schedule(100, 3, s.epsilon, s.max_steps, s.starts)))
    np.testing.assert_array_equal(learned.basis[0], plain.table.astype(np.float32))
    np.testing.assert_array_equal(learned.acting_values[0], plain.acting_values)


def test_peers_see_what_the_leader_sees_and_change_nothing_for_it(coin):
    without = learned_to_the_end(coin.world, replace(coin.settings, peers=False))
    np.testing.assert_array_equal(coin.basis, without.basis)
    # All evaluate the leader's policy at one discount and one rate: their means are the leader's own values.
    peers, levels = coin.peers, coin.peers.expectile.shape[-1]
    np.testing.assert_allclose(peers.plain, peers.laplace_values, atol=1e-9)
    np.testing.assert_allclose(peers.laplace_values, coin.acting_values, atol=1e-9)
    np.testing.assert_allclose(peers.categorical.sum(axis=-1), 1.0, atol=1e-5)
    # An untouched pair may keep the atom nearest to 0; a visited one has the mean.
    visited = peers.plain != 0
    np.testing.assert_allclose((peers.categorical @ peers.atoms)[visited], peers.plain[visited], atol=0.5)
    assert levels == 11


def test_peers_follow_the_leader_and_not_themselves():
    # At its own discount of .3 a peer would take the short branch; the leader acts at .99 and takes the long one.
    world = load_world("two_decisions")
    learned = learned_to_the_end(world, LearnSettings(peers=True, peer_gamma=0.3))
    own = PlainQ(world, 0.3, rate=learned.settings.rate)
    list(learn(world, [own], Schedule(400, 0, learned.settings.epsilon, starts="everywhere")))
    assert own.values[0, 1] == pytest.approx(0.3 * 5.0, abs=1e-3)
    assert learned.peers.plain[0, 0, 1] == pytest.approx(0.3**3 * 10.0, abs=1e-3)
    assert learned.peers.laplace_values[0, 0, 1] == pytest.approx(0.3**3 * 10.0, abs=1e-3)


def test_learners_take_turns_and_can_be_looked_at():
    learning = Learning(load_world("two_branch"), LearnSettings(seeds=3, episodes=40))
    before = learning.snapshot()
    assert before.episodes == (0, 0, 0)
    assert not before.basis.any()
    assert learning.progress["error"] is None
    turns, seen = [], []
    for index in learning:
        turns.append(index)
        seen.append(learning.snapshot())
        assert max(seen[-1].episodes) - min(seen[-1].episodes) <= learning.every
    assert turns[:6] == [0, 1, 2, 0, 1, 2]
    assert not seen[-2].finished
    assert seen[-1].finished
    assert seen[-1].episodes == (40, 40, 40)
    assert not before.basis.any()  # a snapshot is a copy
    progress = learning.progress
    assert progress["episodes"] == progress["of"] == 120
    assert progress["finished"]
    assert progress["steps"] == sum(int(curve["steps"][-1]) for curve in seen[-1].curves)


def test_curves_are_complete_and_in_order(coin):
    for curve in coin.curves:
        assert tuple(curve) == CURVE_NAMES
        assert all(np.isfinite(curve[name]).all() for name in CURVE_NAMES)
        assert np.all(np.diff(curve["episode"]) > 0)
        assert np.all(np.diff(curve["steps"]) > 0)
        assert curve["episode"][-1] == 60


# --- reading ---


def test_a_study_is_that_of_the_learned_basis(coin):
    settings = Settings(state="branch", alpha=0.05, steps=6, thetas=40, policy="per_gamma", acting_gamma=0.5, gammas=9)
    found = study_of(coin, settings, 1)
    assert (found.settings.policy, found.settings.acting_gamma) == ("shared", 0.99)  # the learner's
    np.testing.assert_array_equal(found.gamma_space.gammas, coin.gammas)
    assert (found.settings.alpha, found.settings.steps, found.state) == (0.05, 6, 1)
    exact = study(coin.world, found.settings)
    np.testing.assert_array_equal(found.truth.tau_space, exact.truth.tau_space)
    np.testing.assert_allclose(found.gamma_space.constant, coin.basis[1, 1].sum(axis=-1), atol=1e-5)
    assert np.abs(coin.basis[1, 1] - basis_of(exact)).max() > 1e-3


def test_bands_are_the_statistics_over_the_seeds(coin):
    settings = Settings(state="branch", steps=5, thetas=30)
    found = bands(coin, settings)
    each = [study_of(coin, settings, i).decoded for i in range(3)]
    for name in ("tau_space", "survival", "expected_reward", "horizon_values"):
        band, arrays = getattr(found, name), [getattr(decoded, name) for decoded in each]
        for place in np.ndindex(arrays[0].shape):
            values = sorted(float(array[place]) for array in arrays)
            assert band.mean[place] == pytest.approx(sum(values) / 3, abs=1e-12)
            assert (band.low[place], band.high[place]) == (values[0], values[2])
            assert band.quantiles[2][place] == values[1]  # the median of three
            # Between the lowest and the middle one: the level .25 is half way.
            assert band.quantiles[1][place] == pytest.approx((values[0] + values[1]) / 2, abs=1e-12)
    assert QUANTILE_LEVELS[1:3] == (0.25, 0.5)
    for action in range(2):
        for row in range(5):
            share = sum(int(decoded.actions[row] == action) for decoded in each) / 3
            assert found.action_share[action, row] == pytest.approx(share)
    np.testing.assert_allclose(found.action_share.sum(axis=0), 1.0)
    assert np.ptp([decoded.expected_reward for decoded in each], axis=0).max() > 1e-3  # they do disagree


def test_a_learner_that_is_not_there_is_refused(coin):
    for index in (-1, 3):
        with pytest.raises(InputError, match="use 0 to 2"):
            study_of(coin, seed_index=index)


def test_a_world_from_a_file_is_learned_with_defaults_that_suit_it():
    world = parse_world(dump_world(load_world("cliff_grid")))
    assert learned_to_the_end(world).curves[0]["error"][-1] < 0.02


def test_the_shipped_agent_decodes_close_to_the_exact_one():
    learned = read_learned("checkpoints/fig6_chain_td.safetensors")
    assert learned.finished
    assert learned.peers is not None
    found = bands(learned)
    exact = study(learned.world, found.studies[0].settings)
    assert max(curve["error"][-1] for curve in learned.curves) < 0.02
    assert np.abs(found.tau_space.mean - exact.decoded.tau_space).max() < 0.05 * exact.decoded.tau_space.max()
    for one in found.studies:
        assert np.abs(one.decoded.tau_space - exact.decoded.tau_space).max() < 0.08 * exact.decoded.tau_space.max()
