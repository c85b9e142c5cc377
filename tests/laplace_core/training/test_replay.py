"""Replay by hand-worked episodes: what is stored, what is not, and what a batch of it is."""

from __future__ import annotations

from functools import partial

import gymnasium
import numpy as np
import pytest
import torch
from gymnasium.spaces import Box, Discrete
from hypothesis import given
from hypothesis import strategies as st

from laplace_core.environments.vector import Environments, make
from laplace_core.errors import InputError
from laplace_core.training.replay import Replay
from laplace_core.training.sum_tree import SumTree
from tests.support.hostile import assert_one_sentence


class Script(gymnasium.Env):
    """Observations count every reset and step, so that each is told from all others.

    Episodes last 3, 2, 3, 2, ... steps; the first kind terminates, the second is truncated. The reward of a step is
    ten times the number of its observation.
    """

    observation_space = Box(-1e6, 1e6, (1,), np.float32)
    action_space = Discrete(2)

    def __init__(self, first: int = 0):
        self._count, self._episode = first - 1, -1

    def _next(self) -> np.ndarray:
        self._count += 1
        return np.array([self._count], np.float32)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self._episode, self._time = self._episode + 1, 0
        return self._next(), {}

    def step(self, action):
        self._time += 1
        even = self._episode % 2 == 0
        terminated, truncated = even and self._time == 3, not even and self._time == 2
        return self._next(), 10.0 * self._count, terminated, truncated, {}


def gathered(steps: int, envs: int = 1, **options) -> Replay:
    """So many steps of scripted environments; the i-th one counts from 100 i."""
    environments = Environments([partial(Script, 100 * i) for i in range(envs)], [0] * envs)
    replay = Replay(options.pop("capacity", 1_000), envs, 1, **options)
    for _ in range(steps):
        observations = environments.observations
        s = environments.step(np.zeros(envs, np.int64))
        replay.add(
            s.real, observations, np.zeros(envs, np.int64), s.rewards, next_observations=s.observations,
            terminated=s.terminated, truncated=s.truncated, elapsed=s.elapsed,
        )  # fmt: skip
    return replay


def rows(replay: Replay, count: int = 400) -> set[tuple]:
    """Every distinct transition in a large sample: what a small buffer holds, in the words of a batch."""
    batch, _ = replay.sample(count, np.random.default_rng(0))
    columns = zip(
        batch.observations[..., 0].flatten().tolist(), batch.rewards.flatten(0, 1).tolist(),
        batch.next_observations[..., 0].flatten().tolist(), batch.terminated.flatten().tolist(),
        batch.lengths.flatten().tolist(), batch.elapsed.flatten().tolist(), strict=True,
    )  # fmt: skip
    return {(first, tuple(rewards), *others) for first, rewards, *others in columns}


def test_the_reset_step_is_not_stored_and_final_observations_are_the_true_ones():
    """Episode 0 shows 0 1 2 3 and terminates, episode 1 shows 4 5 6 and is truncated, episode 2 shows 7 8 ...

    Six transitions by the eighth step, for two of the eight are resets. None leads from 3 to 4 or from 6 to 7, and the
    truncated one leads to observation 6, from which it bootstraps.
    """
    replay = gathered(8)
    assert len(replay) == 6
    assert rows(replay) == {
        (0, (10,), 1, False, 1, 1), (1, (20,), 2, False, 1, 2), (2, (30,), 3, True, 1, 3),
        (4, (50,), 5, False, 1, 1), (5, (60,), 6, False, 1, 2),
        (7, (80,), 8, False, 1, 1),
    }  # fmt: skip


def test_n_step_rewards_stop_where_the_episode_or_the_buffer_does():
    """With n = 3: from 0 all three rewards and the end; from 1 two; from 5 one, truncated, bootstrapping from 6; and
    from 7, the newest, the one reward there is, bootstrapping from 8."""
    assert rows(gathered(8, n_step=3)) == {
        (0, (10, 20, 30), 3, True, 3, 3), (1, (20, 30, 0), 3, True, 2, 3), (2, (30, 0, 0), 3, True, 1, 3),
        (4, (50, 60, 0), 6, False, 2, 2), (5, (60, 0, 0), 6, False, 1, 2),
        (7, (80, 0, 0), 8, False, 1, 1),
    }  # fmt: skip


def test_n_step_rewards_do_not_reach_over_a_cut():
    """Four steps are three transitions and a reset; cut off after the fourth transition, whose episode had not ended.

    What follows begins at 100. From 4, the newest before the cut, there is one reward, and it bootstraps from 5.
    """
    replay = gathered(5, n_step=3)
    replay.cut()
    replay.add(
        np.array([True]), np.array([[100.0]]), np.array([0]), np.array([7.0]), next_observations=np.array([[101.0]]),
        terminated=np.array([False]), truncated=np.array([False]), elapsed=np.array([1]),
    )  # fmt: skip
    assert rows(replay) == {
        (0, (10, 20, 30), 3, True, 3, 3), (1, (20, 30, 0), 3, True, 2, 3), (2, (30, 0, 0), 3, True, 1, 3),
        (4, (50, 0, 0), 5, False, 1, 1), (100, (7, 0, 0), 101, False, 1, 1),
    }  # fmt: skip
    empty = Replay(10, 2, 1)
    empty.cut()
    assert not empty.ended.any()


def test_a_full_ring_forgets_the_oldest_and_never_reads_across_its_seam():
    """Ten steps are eight transitions, from 0 1 2, 4 5 and 7 8 9, and two resets: the last four are kept.

    Their three ring places after the seam hold 7 8 9, the one before it 5: from 5 the episode was truncated.
    """
    replay = gathered(10, n_step=3, capacity=4)
    assert rows(replay) == {
        (5, (60, 0, 0), 6, False, 1, 2),
        (7, (80, 90, 100), 10, True, 3, 3), (8, (90, 100, 0), 10, True, 2, 3), (9, (100, 0, 0), 10, True, 1, 3),
    }  # fmt: skip


def test_all_rings_are_drawn_from_alike():
    batch, _ = gathered(8, envs=3).sample(6_000, np.random.default_rng(0))
    firsts, counts = np.unique(batch.observations.numpy(), return_counts=True)
    assert firsts.tolist() == [first + 100 * i for i in range(3) for first in (0, 1, 2, 4, 5, 7)]
    # 18 transitions, 333 expected each; five standard deviations are 89.
    assert counts.min() > 244
    assert counts.max() < 422


def test_with_experience_of_their_own_each_discount_sees_one_environment():
    batch, places = gathered(8, envs=3, own=True).sample(50, np.random.default_rng(0))
    assert batch.observations.shape == (50, 3, 1)
    assert places.shape == (50, 3)
    np.testing.assert_array_equal(batch.observations[..., 0] // 100, np.tile([0, 1, 2], (50, 1)))


def test_what_was_kept_comes_back():
    replay, other = gathered(9, envs=2, exponent=0.6), Replay(1_000, 2, 1, exponent=0.6)
    replay.prioritise(np.array([[0], [3]]), np.array([5.0, 0.1]))
    other.restore({name: array.copy() for name, array in replay.arrays().items()}, "kept")
    samples = [one.sample(64, np.random.default_rng(1), 0.5) for one in (replay, other)]
    for name in ("observations", "rewards", "terminated", "weights"):
        assert torch.equal(getattr(samples[0][0], name), getattr(samples[1][0], name))
    assert other.top == replay.top


def one_hot(places) -> np.ndarray:
    """Observations of a world of five states."""
    return np.eye(5, dtype=np.float32)[places]


def walked(replay: Replay, steps: int) -> Replay:
    """Two environments that walk round five states, with a reward of its own for every step."""
    for step in range(steps):
        now, after = np.array([step % 5, (step + 2) % 5]), np.array([(step + 1) % 5, (step + 3) % 5])
        over = np.array([step % 3 == 2, False])
        replay.add(
            np.array([True, True]), one_hot(now), np.array([0, 1]), np.array([step, -step]),
            next_observations=one_hot(after), terminated=over, truncated=np.array([False, step % 4 == 3]),
            elapsed=np.array([step % 3, step % 4]),
        )  # fmt: skip
    return replay


@pytest.mark.parametrize("steps", [3, 9])
@pytest.mark.parametrize("exponent", [None, 0.6])
def test_places_of_one_hot_states_are_replayed_as_the_states_are(steps, exponent):
    """Six transitions a ring; the slow twin keeps every number of an observation."""
    kinds = [walked(Replay(12, 2, 5, n_step=2, exponent=exponent, one_hot=kind), steps) for kind in (True, False)]
    (one, _), (other, _) = (replay.sample(64, np.random.default_rng(1), 0.5) for replay in kinds)
    for name in vars(other):
        assert torch.equal(getattr(one, name), getattr(other, name)), name
        assert getattr(one, name).dtype == getattr(other, name).dtype
    assert kinds[0].bytes_of_transition < kinds[1].bytes_of_transition


def test_only_what_is_filled_is_saved():
    """Of 2,450 places a ring 3 are filled."""
    replay = walked(Replay(4_900, 2, 500), 0)
    assert {array.shape[1] for array in replay.arrays().values() if array.ndim > 1} == {0}
    small = walked(Replay(4_900, 2, 5), 3)
    assert {array.shape[1] for array in small.arrays().values() if array.ndim > 1} == {3}
    # 2 * 5 float32 observations, an int64 action, a float32 reward, two truth values and an int32: 58 bytes.
    assert sum(array.nbytes for array in small.arrays().values()) == 6 * 58 + 2 * 2 * 8
    assert small.bytes_of_transition == 58


@pytest.mark.parametrize("exponent", [None, 0.6])
@pytest.mark.parametrize("steps", [0, 3, 6, 9])
def test_resume_points_of_version_0_2_hold_every_place_and_every_number(steps, exponent):
    """They have whole rings, observations as vectors, and priorities in one row."""
    old, new = (Replay(12, 2, 5, exponent=exponent, one_hot=one_hot) for one_hot in (False, True))
    walked(old, steps)
    arrays = {name: array.copy() for name, array in old.arrays().items() if array.ndim == 1}
    arrays |= {name: getattr(old, name) for name in ("observations", "next_observations", "actions", "rewards")}
    arrays |= {name: getattr(old, name) for name in ("terminated", "ended", "elapsed")}
    if exponent:
        arrays["priorities"] = old.tree.leaves()
    new.restore(arrays, "old")
    assert (new.sizes.tolist(), new.heads.tolist()) == (old.sizes.tolist(), old.heads.tolist())
    if steps:
        (one, _), (other, _) = (replay.sample(64, np.random.default_rng(1)) for replay in (old, new))
        assert all(torch.equal(getattr(one, name), getattr(other, name)) for name in vars(one))


def test_a_buffer_that_cannot_be_is_refused(subtests):
    good = {name: array.copy() for name, array in walked(Replay(12, 2, 5, one_hot=True), 3).arrays().items()}
    longer = {name: np.repeat(array, 3, axis=1) if array.ndim > 1 else array for name, array in good.items()}
    for name, arrays in {
        "more places than the buffer has": longer,
        "a size beyond what is there": good | {"sizes": np.array([4, 4])},
        "a negative size": good | {"sizes": np.array([-1, 3])},
        "a head elsewhere": good | {"heads": np.array([2, 3])},
        "a head outside": good | {"heads": np.array([12, 3])},
        "no sizes": {name: array for name, array in good.items() if name != "sizes"},
        "no actions": {name: array for name, array in good.items() if name != "actions"},
        "a state that is not there": good | {"observations": np.full_like(good["observations"], 5)},
        "a state below 0": good | {"next_observations": np.full_like(good["observations"], -1)},
        "another type": good | {"rewards": good["rewards"].astype(float)},
        "another number of rings": {name: array[:1] for name, array in good.items()},
        "unequal lengths": good | {"rewards": good["rewards"][:, :2]},
        "an actions array of one dimension": good | {"actions": good["actions"][0]},
    }.items():
        with subtests.test(name):
            buffer = Replay(12, 2, 5, one_hot=True)
            with pytest.raises(InputError) as refused:
                buffer.restore(arrays, "kept")
            assert_one_sentence(str(refused.value), "kept")
            assert len(buffer) == 0


# Priorities


@given(st.lists(st.floats(0.0, 100.0), min_size=1, max_size=40).filter(lambda values: sum(values) > 1e-3))
def test_a_sum_tree_draws_what_a_search_in_cumulated_priorities_does(priorities):
    tree, count = SumTree(len(priorities)), 64
    tree.set(np.arange(len(priorities)), np.array(priorities))
    assert tree.total == pytest.approx(sum(priorities))
    wanted = (np.arange(count) + np.random.default_rng(3).random(count)) / count * tree.total
    drawn = tree.draw(count, np.random.default_rng(3))
    ends = np.cumsum(priorities)
    assert np.all(np.array(priorities)[drawn] > 0)
    assert np.all(wanted <= ends[drawn] + 1e-9 * tree.total)
    assert np.all(wanted >= ends[drawn] - np.array(priorities)[drawn] - 1e-9 * tree.total)


def test_changed_priorities_change_every_sum_above_them():
    tree = SumTree(5)
    tree.set(np.arange(5), np.ones(5))
    tree.set(np.array([4, 1]), np.array([7.0, 0.0]))
    assert tree.total == 10.0  # 1 + 0 + 1 + 1 + 7
    assert tree.leaves().tolist() == [1, 0, 1, 1, 7]


def test_large_losses_are_replayed_more_often_and_count_less():
    """Two transitions of priority 8^(1/3) = 2 and 1^(1/3) = 1: 2/3 and 1/3 of the draws. Weights (N p)^-1 are 3/4 and
    3/2, divided by the larger one: 1/2 and 1."""
    replay = Replay(2, 1, 1, exponent=1 / 3)
    for first in (0.0, 1.0):
        replay.add(
            np.array([True]), np.array([[first]]), np.array([0]), np.array([0.0]), next_observations=np.array([[0.0]]),
            terminated=np.array([False]), truncated=np.array([False]), elapsed=np.array([1]),
        )  # fmt: skip
    replay.prioritise(np.array([[0], [1]]), np.array([8.0, 1.0]) - 1e-3)
    batch, _ = replay.sample(3_000, np.random.default_rng(0))
    heavy = batch.observations[:, 0, 0].numpy() == 0.0
    assert heavy.mean() == pytest.approx(2 / 3, abs=0.01)
    np.testing.assert_allclose(batch.weights[heavy], 0.5, rtol=1e-5)
    np.testing.assert_allclose(batch.weights[~heavy], 1.0, rtol=1e-5)


def test_every_part_of_a_prioritised_round_sees_all_environments():
    """A round of four updates draws once and takes a quarter each. Of 32 rows drawn from four rings alike, none is of
    one ring with a probability of (3/4)^32 = 1e-4."""
    batch, places = gathered(8, envs=4, exponent=0.6).sample(128, np.random.default_rng(0))
    for part in batch.split(4):
        assert set((part.observations[:, 0, 0] // 100).tolist()) == {0, 1, 2, 3}
    np.testing.assert_array_equal(places[:, 0] // 250, batch.observations[:, 0, 0] // 100)


def test_new_transitions_have_the_largest_priority_so_far():
    replay = gathered(3, exponent=1.0)
    replay.prioritise(np.array([[0]]), np.array([9.0 - 1e-3]))
    replay.add(
        np.array([True]), np.zeros((1, 1)), np.array([0]), np.array([0.0]), next_observations=np.zeros((1, 1)),
        terminated=np.array([False]), truncated=np.array([False]), elapsed=np.array([1]),
    )  # fmt: skip
    assert replay.tree.leaves()[:4].tolist() == pytest.approx([9.0, 1.0, 1.0, 9.0])


# Environments


@pytest.mark.parametrize("name", ["CartPole-v1", "Acrobot-v1", "two_branch", "cliff_grid"])
def test_environments_go_on_from_a_saved_state(name):
    """The state passes through JSON, as a resume point does."""
    import json

    random = np.random.default_rng(0)
    one, other = (Environments([partial(make, name)] * 3, [seed, 1, 2]) for seed in (0, 5))
    count = one._vector.single_action_space.n
    for _ in range(33):
        one.step(random.integers(count, size=3))
    other.step(random.integers(count, size=3))
    assert one.saves
    other.restore(json.loads(json.dumps(one.state())))
    for _ in range(60):
        actions = random.integers(count, size=3)
        np.testing.assert_array_equal(one.fresh, other.fresh)
        for a, b in zip(one.step(actions), other.step(actions), strict=True):
            np.testing.assert_array_equal(a, b)


def test_worlds_show_their_states_as_one_hot_vectors():
    env = make("two_branch")
    observation, _ = env.reset(seed=0)
    assert observation.tolist() == [1.0, 0.0, 0.0]
    assert observation.dtype == np.float32
