"""Rollouts: what is kept of an episode, against the environment, the agent and slow twins."""

from __future__ import annotations

import io
import json

import gymnasium
import numpy as np
import pytest
import torch
from PIL import Image, ImageSequence

from laplace_core.acting import rollout
from laplace_core.acting.evaluation import evaluate
from laplace_core.acting.frames import HEIGHT, animation
from laplace_core.acting.rollout import longest, roll_out
from laplace_core.acting.rollout_file import rollout_npz
from laplace_core.acting.rules import RULES, Options, title_of
from laplace_core.agents import SETTINGS, LaplaceSettings
from laplace_core.errors import InputError
from laplace_core.training.checkpoint import new_agent

torch.set_num_threads(1)
SMALL = {"hidden": 8, "features": 4, "gammas": 5, "thetas": 9, "theta_min": -3.0, "theta_max": 12.0}


def made(environment: str = "CartPole-v1", **changes):
    return new_agent(LaplaceSettings(environment=environment, seed=3, **SMALL | changes))


@pytest.fixture(scope="module")
def agent():
    return made()


@pytest.fixture(scope="module")
def found(agent):
    return roll_out(agent, "CartPole-v1", 7, rule="readout", horizon=200)


def test_the_environment_repeats_it_from_its_seed_and_actions(found):
    env = gymnasium.make("CartPole-v1")
    seen, rewards, over = [env.reset(seed=7)[0]], [], False
    for action in found.actions:
        observation, reward, over, _, _ = env.step(int(action))
        seen.append(observation)
        rewards.append(reward)
    np.testing.assert_array_equal(found.observations, seen)
    np.testing.assert_array_equal(found.rewards, rewards)
    assert found.terminated == over
    assert len(found) > 5


@pytest.mark.parametrize("rule", ["greedy", "readout", "fading"])
def test_it_is_the_episode_that_an_evaluation_plays(agent, rule):
    first = 7
    scores = evaluate(agent, "CartPole-v1", episodes=1, horizon=50, rule=rule, first_seed=first)
    one = roll_out(agent, "CartPole-v1", first, rule=rule, horizon=50)
    assert (one.rewards.sum(), len(one)) == (scores.returns[0], scores.lengths[0])


def test_actions_are_the_best_of_the_values_under_the_rule(agent, found):
    judge = RULES["readout"].values(agent, 200, Options())
    wanted = [judge(one[None], t)[0] for t, one in enumerate(found.observations[:-1])]
    np.testing.assert_allclose(found.values, wanted, rtol=1e-5, atol=1e-6)
    np.testing.assert_array_equal(found.actions, found.values.argmax(axis=1))
    greedy = agent.greedy(found.observations[:-1])
    np.testing.assert_array_equal(found.differs, found.actions != greedy)


def test_spaces_are_the_agents_own_of_each_observation(agent, found):
    for step in (0, len(found) // 2, len(found) - 1):
        wanted = agent.gamma_space(found.observations[step])
        np.testing.assert_allclose(found.space(step).values, wanted.values, rtol=1e-5, atol=1e-5)
        np.testing.assert_allclose(found.space(step).constant, wanted.constant, rtol=1e-5, atol=1e-5)


def test_surprise_and_return_by_their_definitions(agent, found):
    """G_t as the sum from t on, written out; the TD error from values asked for again."""
    gamma, N = float(agent.gammas[agent.acting_head]), len(found)
    Q = agent.action_values(found.observations, agent.acting_head)
    last = 0.0 if found.terminated else Q[N].max()
    for t in (0, N // 2, N - 1):
        later = sum(gamma**k * found.rewards[t + k] for k in range(N - t)) + gamma ** (N - t) * last
        assert found.received[t] == pytest.approx(later, rel=1e-5)
        following = Q[t + 1].max() if t + 1 < N else last
        assert found.surprise[t] == pytest.approx(
            found.rewards[t] + gamma * following - Q[t, found.actions[t]], abs=1e-4
        )
        assert found.predicted[t] == pytest.approx(Q[t, found.actions[t]], abs=1e-4)


def test_an_episode_that_is_cut_off_is_worth_what_would_have_followed(agent):
    cut = roll_out(agent, "CartPole-v1", 7, horizon=3)
    assert not cut.terminated
    gamma = cut.acting_gamma
    value = agent.action_values(cut.observations[-1:], agent.acting_head).max()
    assert cut.received[-1] == pytest.approx(1.0 + gamma * value, rel=1e-5)


def test_another_discount_is_greedy_at_its_own_head(agent):
    other = roll_out(agent, "CartPole-v1", 7, rule="greedy", gamma=0.4)
    assert other.gamma == pytest.approx(agent.gammas[0], abs=0.1)
    head = int(np.abs(agent.gammas - other.gamma).argmin())
    np.testing.assert_allclose(other.values, agent.action_values(other.observations[:-1], head), rtol=1e-5, atol=1e-6)


def test_random_actions_are_those_of_the_seed(agent):
    one, two, three = (roll_out(agent, "CartPole-v1", seed, rule="random") for seed in (1, 1, 2))
    np.testing.assert_array_equal(one.actions, two.actions)
    assert len(one) != len(three) or not np.array_equal(one.actions, three.actions)
    assert set(one.actions) == {0, 1}


@pytest.mark.parametrize("algorithm", [name for name in SETTINGS if name != "laplace"])
def test_agents_without_a_gamma_space_are_rolled_out_too(algorithm):
    one = roll_out(new_agent(SETTINGS[algorithm](environment="two_branch", hidden=4)), "two_branch", 0)
    assert one.spaces is None
    assert one.surprise.shape == (len(one),)
    with pytest.raises(InputError):
        one.space(0)


def test_frames_are_small_pictures_of_every_step_and_become_an_animation(agent):
    one = roll_out(agent, "CartPole-v1", 7, horizon=12, pictures=True)
    assert len(one.frames) == len(one) + 1
    assert max(map(len, one.frames)) < 10_000
    first, last = (Image.open(io.BytesIO(one.frames[i])) for i in (0, -1))
    assert (first.height, first.format) == (HEIGHT, "JPEG")
    assert not np.array_equal(np.asarray(first), np.asarray(last))
    whole, half = (Image.open(io.BytesIO(animation(one.frames, 0.04, most))) for most in (100, 7))
    assert whole.format == "GIF"
    # Pictures that are alike are one frame that is shown longer.
    assert sum(frame.info["duration"] for frame in ImageSequence.Iterator(whole)) == 40 * len(one.frames)
    assert half.n_frames <= 7
    assert sum(frame.info["duration"] for frame in ImageSequence.Iterator(half)) == 80 * len(one.frames[::2])


def test_a_tabular_world_draws_no_pictures():
    one = roll_out(made("two_branch"), "two_branch", 0, pictures=True)
    assert one.frames == ()
    with pytest.raises(InputError):
        animation(one.frames, 0.02)


def test_a_file_holds_everything(found):
    file = np.load(io.BytesIO(rollout_npz(found)), allow_pickle=False)
    np.testing.assert_array_equal(file["gamma_space"], found.spaces)
    np.testing.assert_array_equal(file["observations"], found.observations)
    np.testing.assert_array_equal(file["differs"], found.differs)
    told = json.loads(str(file["settings"]))
    assert (told["seed"], told["rule"], told["horizon"]) == (7, "readout", 200)


def test_memory_is_bounded(agent, monkeypatch):
    monkeypatch.setattr(rollout, "MOST_BYTES", 4 * 2 * 5 * 10 * 6)  # six steps of two actions, five discounts
    assert longest(agent) == 6
    assert len(roll_out(agent, "CartPole-v1", 7)) == 6
    with pytest.raises(InputError, match="from 1 to 6"):
        roll_out(agent, "CartPole-v1", 7, horizon=7)


def test_what_hears_of_progress_may_end_it(agent):
    heard = []

    def told(done: int, of: int) -> None:
        heard.append((done, of))
        if done == 4:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        roll_out(agent, "CartPole-v1", 7, horizon=60, progress=told)
    assert heard == [(1, 60), (2, 60), (3, 60), (4, 60)]


def test_what_does_not_fit_is_refused_in_one_sentence(subtests, agent):
    for wrong in [
            {"environment": "Acrobot-v1"}, {"environment": "pong"}, {"seed": -1}, {"seed": 2**31}, {"rule": "best"},
            {"horizon": 0}, {"horizon": 10**6}, {"gamma": 0.0}, {"gamma": 1.0}, {"rule": "readout", "gamma": 0.5},
            {"rule": "own"},
        ]:  # fmt: skip
        with subtests.test(wrong=wrong):
            with pytest.raises(InputError) as refused:
                roll_out(agent, **{"environment": "CartPole-v1", "seed": 0} | wrong)
            assert "\n" not in str(refused.value)


def test_every_rule_has_a_title_and_no_two_have_the_same():
    titles = [rule.title for rule in RULES.values()]
    assert all(titles)
    assert len({*titles, *map(title_of, (*RULES, "random"))}) == len(RULES) + 1
