"""Temporal-difference learning: against loops over every number, against exact solutions, and its events."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import PRESETS, InputError, load_world
from laplace_core.code.encoding import discount_grid
from laplace_core.code.ties import greedy_action
from laplace_core.planning import reward_indicator_basis, target_policies
from laplace_core.study.pipeline import grids
from laplace_core.study.settings import Settings, resolve
from laplace_core.tabular.td import (
    Decay,
    LaplaceTD,
    Sampler,
    Schedule,
    Transition,
    first_best,
    learn,
    sensitivity_channels,
)
from laplace_core.worlds import END, Outcome, World
from tests.support.random_worlds import policies, worlds
from tests.support.slow_twins import as_table

GAMMAS = np.array([0.1, 0.5, 0.9, 0.95])
EXPLORE = Decay(1.0, np.inf)  # every action at random: what is learned is learned off-policy


class NaiveTD:
    """One discount, one channel, one action at a time; the acting discount and the reward are kept as one more."""

    def __init__(self, world, gammas, channels, policy, *, acting_gamma, rate):
        self.gammas, self.policy, self.rate = [*gammas, acting_gamma], policy, rate
        self.channels = [[*row, reward] for row, reward in zip(channels, world.reward_values, strict=True)]
        self.rewards = list(world.reward_values)
        shape = (world.n_states, world.n_actions, len(self.gammas), len(self.channels[0]))
        self.q, self.visits = np.zeros(shape), np.zeros(shape[:2])
        self.table = None if isinstance(policy, str) else as_table(world, policy)

    def chances(self, state, g):
        """Probability of every next action at discount g."""
        if self.table is not None:
            return self.table[state]
        judge = g if self.policy == "per_gamma" else -1
        values = np.array([self.q[state, a, judge, -1] for a in range(self.q.shape[1])])
        return np.eye(len(values))[greedy_action(values)]

    def update(self, transition):
        s, a, reward, _, successor = transition
        rate = max(self.rate.floor, self.rate.first / (1 + self.visits[s, a] / self.rate.half))
        self.visits[s, a] += 1
        learned = self.q[s, a].copy()
        for g, gamma in enumerate(self.gammas):
            chances = [] if successor == END else self.chances(successor, g)
            for c, now in enumerate(self.channels[self.rewards.index(reward)]):
                later = sum(p * self.q[successor, b, g, c] for b, p in enumerate(chances))
                learned[g, c] += rate * (now + gamma * later - self.q[s, a, g, c])
        self.q[s, a] = learned


MODES = ["shared", "per_gamma", "given", "mixed"]


def a_policy(world, mode):
    if mode == "given":
        return np.arange(world.n_states) % world.n_actions
    if mode == "mixed":
        weights = np.random.default_rng(1).random((world.n_states, world.n_actions))
        return weights / weights.sum(axis=1, keepdims=True)
    return mode


def against_loops(world, policy, schedule, *, gammas=GAMMAS, acting_gamma=0.8):
    """Both learners on the same samples, for W and for gamma-space; the leader is the vectorised one."""
    rate = Decay(0.9, 4.0, 0.05)
    thetas = np.linspace(world.reward_values[0] - 1, world.reward_values[-1] + 1, 4)
    sensitivities = sensitivity_channels(world.reward_values, thetas, 3.0)
    for channels in (None, sensitivities):
        fast = LaplaceTD(world, gammas, channels=channels, policy=policy, acting_gamma=acting_gamma, rate=rate)
        used = np.eye(world.reward_values.size) if channels is None else channels
        naive = NaiveTD(world, gammas, used, policy, acting_gamma=acting_gamma, rate=rate)
        naive.values = fast.values
        list(learn(world, [fast, naive], schedule))
        np.testing.assert_allclose(fast.table, naive.q[:, :, :-1, :-1], rtol=0, atol=1e-12)
        np.testing.assert_allclose(fast.values, naive.q[:, :, :-1, -1], rtol=0, atol=1e-12)
        np.testing.assert_allclose(fast.acting_values, naive.q[:, :, -1, -1], rtol=0, atol=1e-12)
    return fast


def test_one_update_equals_a_loop_over_discounts_and_channels(subtests):
    for mode in MODES:
        for name in ["two_decisions", "cliff_grid"]:
            with subtests.test(mode=mode, name=name):
                world = load_world(name, {"slip": 0.3})
                schedule = Schedule(60, seed=3, epsilon=Decay(0.5, np.inf), max_steps=20, starts="everywhere")
                learner = against_loops(world, a_policy(world, mode), schedule)
                assert np.abs(learner.table).max() > 1


@given(st.data())
def test_random_worlds_equal_the_loop(data):
    world = data.draw(worlds(max_states=4))
    policy = data.draw(st.one_of(st.sampled_from(["shared", "per_gamma"]), policies(world)))
    schedule = Schedule(6, seed=data.draw(st.integers(0, 99)), epsilon=Decay(0.5, np.inf), max_steps=6)
    against_loops(world, policy, schedule, gammas=GAMMAS[1:3])


@pytest.mark.parametrize("mode", MODES)
def test_the_basis_and_gamma_space_learn_the_same(mode):
    # The update is linear in f: learning W and then choosing f is choosing f and learning.
    world = load_world("two_decisions", {"slip": 0.2})
    channels = sensitivity_channels(world.reward_values, np.linspace(-2, 12, 30), 2.0)
    basis, direct = (LaplaceTD(world, GAMMAS, channels=c, policy=a_policy(world, mode)) for c in (None, channels))
    list(learn(world, [basis, direct], Schedule(200, epsilon=EXPLORE)))
    np.testing.assert_allclose(basis.table @ channels, direct.table, rtol=0, atol=1e-12)
    np.testing.assert_allclose(basis.table @ world.reward_values, basis.values, rtol=0, atol=1e-12)
    assert direct.table.shape == (4, 2, 4, 31)


# --- convergence ---

# Preset -> episodes, starts, half-life of the learning rate in visits. A deterministic world forgives any large
# half-life; where chance decides, 10 leaves a hundredth of a sample's variance after 1,000 visits. The long chain needs
# every step of its 100 learned in turn, from the end.
SCHEDULES = {
    "two_branch": (200, "everywhere", 10),
    "two_decisions": (200, "everywhere", 10),
    "fig6_chain": (6_000, "world", 10),
    "double_chain": (6_000, "world", 10),
    "rise_and_fade": (400, "everywhere", 100),
    "discounting_chain": (2_000, "world", 1_000),
    "cliff_grid": (600, "everywhere", 1_000),
}


def error_of(name, mode, episodes, starts, half, params=None):
    """Largest error of the learned gamma-space over all states and actions, over the range of the true one."""
    world = load_world(name, params)
    s = resolve(Settings(world=name), world)
    gammas, thetas = grids(s)
    channels = sensitivity_channels(world.reward_values, thetas, s.slope)
    followed = target_policies(world, gammas, "shared" if mode == "given" else mode, s.acting_gamma)
    mode = followed[0] if mode == "given" else mode
    learner = LaplaceTD(world, gammas, channels=None, policy=mode, acting_gamma=s.acting_gamma, rate=Decay(1.0, half))
    list(learn(world, [learner], Schedule(episodes, 0, EXPLORE, starts=starts, every=500)))
    errors, low, high = [], np.inf, -np.inf
    for state in range(world.n_states):
        exact = reward_indicator_basis(world, state, gammas, followed) @ channels
        errors.append(np.abs(learner.table[state] @ channels - exact).max())
        low, high = min(low, exact.min()), max(high, exact.max())
    return max(errors) / (high - low)


@pytest.mark.parametrize("name", PRESETS)
def test_learned_within_two_percent(name):
    assert error_of(name, "shared", *SCHEDULES[name]) < 0.02


@pytest.mark.parametrize("name", ["two_decisions", "cliff_grid"])
def test_every_discount_learns_its_own_control(name):
    assert error_of(name, "per_gamma", *SCHEDULES[name]) < 0.02


def test_a_given_policy_where_actions_slip():
    assert error_of("two_decisions", "given", 6_000, "everywhere", 10, {"slip": 0.3}) < 0.02


def test_a_constant_rate_stays_noisy_where_a_decaying_one_settles():
    # After many visits a constant rate keeps rate / (2 - rate) of a sample's variance, a decaying one nothing.
    world = load_world("fig6_chain")
    decaying, fixed = (LaplaceTD(world, GAMMAS, rate=rate) for rate in (Decay(1, 10), Decay(0.5, np.inf)))
    list(learn(world, [decaying, fixed], Schedule(3_000)))
    exact = reward_indicator_basis(world, 0, GAMMAS, [np.zeros(4, dtype=int)] * 4)
    wrong = [np.abs(learner.table[0] - exact).max() for learner in (decaying, fixed)]
    assert 10 * wrong[0] < wrong[1]


# --- termination, truncation, sampling, events ---


def test_termination_bootstraps_from_nothing_and_truncation_goes_on():
    # Both worlds pay 2 and are cut after one step. The first one ends, and counts 1 step. The second would go on for
    # ever, and counts 1/(1 - g) steps although no episode was longer than one.
    ends = World.from_outcomes("ends", ["s"], ["a"], [Outcome(0, 0, 1.0, END, 2.0)])
    waits = World.from_outcomes("waits", ["s"], ["a"], [Outcome(0, 0, 1.0, 0, 2.0)])
    for world, steps, truncated in ((ends, np.ones(4), False), (waits, 1 / (1 - GAMMAS), True)):
        learner = LaplaceTD(world, GAMMAS, rate=Decay(1.0, np.inf))
        *_, event = learn(world, [learner], Schedule(1_000, max_steps=1))
        assert event.truncated is truncated
        assert event.steps == 1_000
        np.testing.assert_allclose(learner.table[0, 0, :, 0], steps, rtol=1e-9)


def test_transitions_come_with_the_chances_of_the_outcomes():
    rows = [Outcome(0, 0, 0.3, END, 1.0), Outcome(0, 0, 0.7, 1, -1.0), Outcome(0, 0, 0.0, 1, 5.0)]
    rows += [Outcome(1, 0, 0.1, END, 0.0), Outcome(1, 0, 0.9, 0, 1.0)]
    world = World.from_outcomes("chance", ["s", "t"], ["a"], rows, start=np.array([0.25, 0.75]))
    sampler, count = Sampler(world, 0), 20_000
    for state, chances in ((0, {(1.0, END): 0.3, (-1.0, 1): 0.7}), (1, {(0.0, END): 0.1, (1.0, 0): 0.9})):
        drawn = [sampler.step(state, 0) for _ in range(count)]
        assert {(t.reward, t.next_state) for t in drawn} == set(chances)
        assert all(world.reward_values[t.kind] == t.reward for t in drawn)
        for (reward, _), chance in chances.items():
            off = np.mean([t.reward == reward for t in drawn]) - chance
            assert abs(off) < 4 * np.sqrt(chance * (1 - chance) / count)
    for starts, chance in (("world", 0.75), ("everywhere", 0.5)):
        off = np.mean([sampler.first_state(starts) for _ in range(count)]) - chance
        assert abs(off) < 4 * np.sqrt(chance * (1 - chance) / count)

    # Nine ninths add up to less than 1 by rounding: the largest draw must not fall to the tenth, which has no chance.
    ninths = [Outcome(0, 0, 1 / 9, END, 1.0)] * 9 + [Outcome(0, 0, 0.0, END, 5.0)]
    sampler = Sampler(World.from_outcomes("ninths", ["s"], ["a"], ninths), 0)
    sampler.draw = lambda: 1 - 2**-53
    assert sampler.step(0, 0).reward == 1.0


def test_the_same_seed_gives_the_same_result_however_it_is_consumed():
    world = load_world("cliff_grid", {"slip": 0.2})

    def run(seed, every=1):
        learner = LaplaceTD(world, GAMMAS)
        events = list(learn(world, [learner], Schedule(50, seed, every=every, max_steps=50)))
        return events, learner.table

    events, table = run(1)
    again, same = run(1)
    assert events == again
    np.testing.assert_array_equal(table, same)
    fewer, same = run(1, every=20)
    assert [event.episode for event in fewer] == [20, 40, 50]
    np.testing.assert_array_equal(table, same)
    assert np.abs(run(2)[1] - table).max() > 0.01


def test_events_tell_what_happened_and_learning_waits_between_them():
    # One state that pays 2 and ends, rate 1/2: returns 1, then 1.5, then 1.75.
    world = World.from_outcomes("ends", ["s"], ["a"], [Outcome(0, 0, 1.0, END, 2.0)])
    learner = LaplaceTD(world, GAMMAS, rate=Decay(0.5, np.inf))
    events = learn(world, [learner], Schedule(1_000_000_000, epsilon=Decay(0.4, 1.0, 0.15)))
    seen = []
    for event in itertools.islice(events, 3):
        seen.append((event.episode, event.steps, event.episode_return, event.largest_change, event.epsilon))
        assert learner.values[0, 0, 0] == 2 - 0.5 ** (event.episode - 1)
    assert seen == [(1, 1, 2.0, 1.0, 0.4), (2, 2, 2.0, 0.5, 0.2), (3, 3, 2.0, 0.25, 0.15)]
    events.close()


def test_decays_by_hand():
    # first / (1 + n / half): 1, 10/11, 1/2 at n = 0, 1, 10; never below the floor; half = inf never falls.
    assert [Decay(1.0, 10.0)(n) for n in (0, 1, 10)] == pytest.approx([1.0, 10 / 11, 0.5])
    assert Decay(1.0, 1.0)(3) == 1 / 4  # the plain average of four samples
    assert (Decay(0.3, 2.0, 0.2)(100), Decay(0.3, np.inf)(1e12)) == (0.2, 0.3)


def test_a_stochastic_policy_acts_with_its_probabilities():
    world = load_world("two_decisions")
    policy = np.array([[0.2, 0.8], [0.0, 1.0], [1.0, 0.0], [1.0, 0.0]])
    learner = LaplaceTD(world, GAMMAS, policy=policy)
    assert [learner.act(0, draw) for draw in (0.0, 0.19, 0.2, 0.99)] == [0, 0, 1, 1]
    assert {learner.act(1, draw) for draw in (0.0, 0.5, 1 - 2**-53)} == {1}
    assert {learner.act(2, draw) for draw in (0.0, 0.5, 1 - 2**-53)} == {0}


@given(st.lists(st.sampled_from([0.0, 1.0, 1.0 + 1e-10, 1.0 - 1e-8, 1e6, 1e6 + 1e-4, -3.0, -3.0 + 1e-9]), min_size=1))
def test_the_short_rule_for_ties_is_the_rule(values):
    assert first_best(values) == greedy_action(values)


def test_a_transition_back_to_its_own_state_and_action():
    # W = 1 + g W' with the old W' on the right: from 0, rate 1, the counts are 1, then 1 + g, then 1 + g + g^2.
    world = World.from_outcomes("waits", ["s"], ["a"], [Outcome(0, 0, 1.0, 0, 2.0)])
    learner = LaplaceTD(world, GAMMAS, rate=Decay(1.0, np.inf))
    for _ in range(3):
        learner.update(Transition(0, 0, 2.0, 0, 0))
    np.testing.assert_allclose(learner.table[0, 0, :, 0], 1 + GAMMAS + GAMMAS**2)


def test_what_does_not_fit_is_refused():
    world = load_world("two_branch")
    refused = {
        "not one of": lambda: LaplaceTD(world, GAMMAS, policy="greedy"),
        "channels must be": lambda: LaplaceTD(world, GAMMAS, channels=np.ones((2, 3))),
        "between 0 and 1": lambda: LaplaceTD(world, [0.5, 1.0]),
        "exceeds": lambda: LaplaceTD(world, discount_grid(3_000), channels=np.ones((3, 3_000))),
        "outside 0 to 1": lambda: LaplaceTD(world, GAMMAS, policy=np.array([0, 2, 0])),
        "at least 1": lambda: Schedule(episodes=0),
        "everywhere": lambda: Schedule(starts="middle"),
        "a decay needs": lambda: Decay(first=0.1, floor=0.2),
    }
    for words, build in refused.items():
        with pytest.raises(InputError, match=words):
            build()
