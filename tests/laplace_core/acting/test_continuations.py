"""Truth by simulation: continuations from a state, outcomes of many states, and calibration."""

from __future__ import annotations

import numpy as np
import pytest
import torch

from laplace_core import load_world
from laplace_core.acting import continuations
from laplace_core.acting.continuations import calibration, continue_from, outcomes_of_states, steps_known
from laplace_core.acting.rollout import roll_out
from laplace_core.agents import LaplaceSettings
from laplace_core.environments import vector
from laplace_core.errors import InputError
from laplace_core.training.checkpoint import new_agent

torch.set_num_threads(1)
SMALL = {"hidden": 8, "features": 4, "gammas": 4, "thetas": 5, "theta_min": -3.0, "theta_max": 12.0, "seed": 3}


def made(environment: str):
    return new_agent(LaplaceSettings(environment=environment, **SMALL))


class Pushing:
    """An agent of CartPole that pushes to and fro by the pole's velocity, and holds it for long."""

    n_observations, n_actions, acting_head, gammas = 4, 2, 0, np.array([0.9])

    def action_values(self, observations, head):
        push = observations[:, 2] + 0.5 * observations[:, 3] + 0.02 * observations[:, 0] + 0.05 * observations[:, 1]
        return np.stack([-push, push], axis=1)


@pytest.mark.parametrize("name", ["CartPole-v1", "Acrobot-v1", "MountainCar-v0"])
def test_without_chance_all_continuations_are_the_episode_itself(name):
    agent = made(name)
    rollout = roll_out(agent, name, 7, horizon=30)
    assert not vector.chance(name)
    found = continue_from(agent, rollout, 3, count=4, steps=20)
    wanted = rollout.rewards[3:23]
    assert (found.rewards[:, : len(wanted)] == wanted).all()
    assert (found.alive.sum(axis=1) == found.alive[0].sum()).all()


def test_the_lander_has_chance_and_the_same_past():
    agent = made("LunarLander-v3")
    rollout = roll_out(agent, "LunarLander-v3", 7)
    assert vector.chance("LunarLander-v3")
    found = continue_from(agent, rollout, 5, action=2, count=6, steps=60)
    assert len(np.unique(found.rewards.sum(axis=1))) == 6  # each its own future
    np.testing.assert_array_equal(found.rewards, continue_from(agent, rollout, 5, action=2, count=6, steps=60).rewards)
    found = continue_from(agent, rollout, 5, action=0, count=6, steps=60)
    # The same past: without an engine nothing is left to chance in the first step.
    np.testing.assert_allclose(found.rewards[:, 0], found.rewards[0, 0], atol=1e-9)


def test_chances_of_a_world_are_met():
    """P(alive at tau) on the ice by counting, against products of the world's own transition matrix."""
    name = "gym:FrozenLake-v1"
    world, agent = load_world(name), made(name)
    rollout = roll_out(agent, name, 0, rule="random")
    start, first = int(rollout.observations[0].argmax()), int(rollout.actions[0])
    policy = agent.greedy(np.eye(world.n_states))
    moves = world.transition_matrix.toarray().reshape(world.n_states, world.n_actions, world.n_states)
    state, wanted = moves[start, first], [1.0]
    for _ in range(11):
        wanted.append(state.sum())
        state = state @ moves[np.arange(world.n_states), policy]
    found, error = continue_from(agent, rollout, 0, count=600, steps=12).survival
    assert wanted[-1] < 0.999  # chance is at work
    assert (np.abs(found - wanted) <= 4 * np.maximum(error, 1e-3)).all()


@pytest.mark.parametrize("rule", ["greedy", "fading", "readout", "matched", "decoded"])
def test_under_its_own_rule_an_episode_without_chance_goes_on_as_it_did(rule):
    """The rule has 9 steps to go at the step, as it had in the episode, and says nothing after them."""
    agent = made("CartPole-v1")
    gamma = 0.5 if rule == "greedy" else None
    rollout = roll_out(agent, "CartPole-v1", 7, rule=rule, horizon=12, gamma=gamma)
    found = continue_from(agent, rollout, 3, count=2, steps=20, own=True)
    known = 20 if rule == "greedy" else 9  # a rule for a deadline says nothing after it
    assert found.rewards.shape == (2, known)
    wanted = rollout.rewards[3:]
    assert (found.rewards[:, : len(wanted)] == wanted).all()
    assert steps_known(agent, rollout, 3, 20, own=True) == known
    assert steps_known(agent, rollout, 3, 20, own=False) == 20


def chooses_by_the_clock(agent, horizon):
    """The observed choices of a rule that takes action 1 with an odd time to go, and 0 with an even one."""
    taken = []

    def judge(observations, time):
        taken.append((horizon - time, len(observations)))
        return np.tile([0.5, (horizon - time) % 2], (len(observations), 1))

    return judge, taken


def test_the_time_to_go_runs_on_from_that_of_the_step(monkeypatch):
    agent = made("CartPole-v1")
    rollout = roll_out(agent, "CartPole-v1", 7, rule="fading", horizon=9)
    judge, taken = chooses_by_the_clock(agent, 9)
    monkeypatch.setattr(continuations, "judge_of", lambda *_, **__: (judge, None))
    continue_from(agent, rollout, 3, count=3, own=True)
    assert taken == [(left, 3) for left in (5, 4, 3, 2, 1)]  # with 6 to go the first action is given


def test_random_continuations_are_random_and_the_same_again():
    name = "gym:FrozenLake-v1"
    agent = made(name)
    rollout = roll_out(agent, name, 0, rule="random")
    found = [continue_from(agent, rollout, 0, count=40, steps=12, seed=seed, own=True) for seed in (0, 0, 1)]
    np.testing.assert_array_equal(found[0].alive, found[1].alive)
    assert (found[0].alive != found[2].alive).any()
    assert (found[0].alive != continue_from(agent, rollout, 0, count=40, steps=12).alive).any()


def test_the_values_are_of_greedy_at_the_acting_discount():
    agent = made("CartPole-v1")
    acting = float(agent.gammas[agent.acting_head])
    for rule, gamma, wanted in (("greedy", None, True), ("greedy", acting, True), ("greedy", 0.5, False),
                                ("random", None, False), ("fading", None, False)):  # fmt: skip
        assert roll_out(agent, "CartPole-v1", 1, rule=rule, horizon=5, gamma=gamma).of_the_values is wanted


@pytest.mark.parametrize(("rule", "horizon", "known"), [("random", None, 30), ("fading", 9, 5), ("decoded", 1, 1)])
def test_outcomes_under_another_rule(rule, horizon, known):
    """Of a deadline of 9 the states are among the first 4 or 5 steps: 5 steps are known after each."""
    agent = made("CartPole-v1")
    like = roll_out(agent, "CartPole-v1", 7, rule=rule, horizon=horizon)
    found = outcomes_of_states(agent, "CartPole-v1", episodes=2, each=3, steps=30, like=like)
    assert found.rewards.shape[1] == known
    first = roll_out(agent, "CartPole-v1", 0, rule=rule, horizon=horizon, limited=False)
    np.testing.assert_array_equal(found.observations[0], first.observations[0])
    np.testing.assert_array_equal(found.rewards[0][: len(first)], first.rewards[:known])


def test_the_time_limit_does_not_end_a_continuation():
    agent = Pushing()
    rollout = roll_out(agent, "CartPole-v1", 1, spaces=False)
    assert len(rollout) == 500
    found = continue_from(agent, rollout, 495, count=2, steps=40)
    assert found.alive.all()


def test_tails_are_counted_and_die_with_the_episode():
    agent = made("CartPole-v1")
    rollout = roll_out(agent, "CartPole-v1", 7)
    found = continue_from(agent, rollout, 0, count=3, steps=60)
    above, error = found.exceeds(np.array([-1.0, 0.5, 1.5]))
    np.testing.assert_array_equal(above[:, 0], found.survival[0])
    np.testing.assert_array_equal(above[:, 1], found.survival[0])
    assert not above[:, 2].any()
    assert not error.any()


def test_outcomes_of_many_states_are_what_came_after_each():
    agent = Pushing()
    found = outcomes_of_states(agent, "CartPole-v1", episodes=3, each=5, steps=30)
    assert found.observations.shape == (15, 4)
    assert found.alive.shape == (15, 30)
    assert (found.rewards == found.alive).all()  # one a step
    rollout = roll_out(agent, "CartPole-v1", 0, horizon=60, spaces=False)
    np.testing.assert_array_equal(found.observations[1], rollout.observations[np.linspace(0, 29, 5).astype(int)[1]])


def test_outcomes_begin_at_their_own_states():
    agent = made("LunarLander-v3")
    found = outcomes_of_states(agent, "LunarLander-v3", episodes=1, each=3, steps=40)
    whole = roll_out(agent, "LunarLander-v3", 0, horizon=80, limited=False).rewards
    last = min(40, len(whole)) if len(whole) < 80 else 40
    for row, at in zip(found.rewards, np.unique(np.linspace(0, last - 1, 3).astype(int)), strict=True):
        wanted = whole[at : at + 40]
        np.testing.assert_allclose(row[: len(wanted)], wanted)


def test_calibration_by_hand():
    """Of four said to come with .2, one came; of two said with .9, both; one said with 1.3, none."""
    found = calibration(np.array([0.2, 0.2, 0.2, 0.2, 0.85, 0.85, 1.3]), np.array([1, 0, 0, 0, 1, 1, 0]), bins=5)
    np.testing.assert_allclose(found.predicted, [0.2, 1.0])
    np.testing.assert_allclose(found.observed, [0.25, 2 / 3])
    np.testing.assert_array_equal(found.counts, [4, 3])
    np.testing.assert_allclose(found.errors, [np.sqrt(0.25 * 0.75 / 4), np.sqrt(2 / 9 / 3)])


def test_honest_predictions_are_calibrated():
    rng = np.random.default_rng(0)
    chances = rng.random(20_000)
    found = calibration(chances, rng.random(20_000) < chances)
    assert (np.abs(found.predicted - found.observed) < 4 * found.errors + 1e-3).all()


def test_what_does_not_fit_is_refused(subtests):
    for wrong in [{"step": -1}, {"step": 10**6}, {"count": 0}, {"count": 10**4}, {"steps": 0}, {"action": 2}]:
        with subtests.test(wrong=wrong):
            agent = made("CartPole-v1")
            rollout = roll_out(agent, "CartPole-v1", 7, horizon=5)
            with pytest.raises(InputError):
                continue_from(agent, rollout, **{"step": 0} | wrong)


def test_nor_does_it_end_what_comes_after_many_states():
    """Steps 0 and 299 of an episode that nothing ends, and 300 steps after each: past the limit of 500."""
    found = outcomes_of_states(Pushing(), "CartPole-v1", episodes=1, each=2, steps=300)
    assert found.alive.all()
    whole = roll_out(Pushing(), "CartPole-v1", 0, horizon=600, limited=False, spaces=False)
    assert len(whole) == 600
    np.testing.assert_array_equal(found.observations[1], whole.observations[299])


def test_progress_counts_the_steps_to_the_state_as_well():
    """Three steps to the state and five after it: what leads there takes as long as what follows."""
    agent, heard = made("two_branch"), []
    rollout = roll_out(made("CartPole-v1"), "CartPole-v1", 7, horizon=30)
    continue_from(made("CartPole-v1"), rollout, 3, count=2, steps=5, progress=lambda done, of: heard.append((done, of)))
    assert heard == [(done, 8) for done in range(1, 9)]
    heard.clear()
    outcomes_of_states(
        agent, "two_branch", episodes=3, each=1, steps=4, progress=lambda done, of: heard.append((done, of))
    )
    assert {of for _, of in heard} == {3 * 8}  # episodes of at most twice the steps
    assert [done // 8 for done, _ in heard] == sorted(done // 8 for done, _ in heard)
    assert len(heard) > 3


def test_work_under_way_can_be_ended_on_the_way_to_its_state():
    rollout = roll_out(made("CartPole-v1"), "CartPole-v1", 7, horizon=30)

    def end(done: int, of: int) -> None:
        raise InterruptedError(done)

    with pytest.raises(InterruptedError, match="1"):
        continue_from(made("CartPole-v1"), rollout, 5, count=2, steps=5, progress=end)
