"""One gamma-space: what an agent acts on, what is decoded, and what the lens draws are the same numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import torch

from laplace_core import Settings, study_of_gamma_space
from laplace_core.acting.rollout import roll_out
from laplace_core.acting.rollout_file import rollout_npz
from laplace_core.acting.rules import RULES, Options
from laplace_core.agents import LaplaceSettings
from laplace_core.code.ties import greedy_action
from laplace_core.environments import vector
from laplace_core.payloads.lens import payload, structure
from laplace_core.payloads.state import state_of
from laplace_core.study.npz import read_gamma_space
from laplace_core.training.checkpoint import load_checkpoint, new_agent
from tests.support.lens_reference import seen

torch.set_num_threads(1)
ROOT = Path(__file__).resolve().parents[3] / "checkpoints"
SHIPPED = sorted([*ROOT.glob("laplace_*.safetensors"), *ROOT.glob("seeds/laplace_*.safetensors")])
LEARNED = ("softmax", "accumulated", "clipped", "free")


def visited(agent, environment: str, count: int = 30) -> np.ndarray:
    """Observations along episodes that the agent acts in, from seed 5 on."""
    env, found = vector.make(environment), []
    observation = env.reset(seed=5)[0]
    while len(found) < count:
        found.append(observation.ravel())
        observation, _, terminated, truncated, _ = env.step(int(agent.greedy(found[-1][None])[0]))
        if terminated or truncated:
            observation = env.reset()[0]
    env.close()
    return np.array(found)


def untrained(parametrisation: str):
    """An agent whose rewards lie beyond its sensitivities as well: thetas from -.5 to .5 where rewards are 1."""
    settings = LaplaceSettings(
        hidden=8, features=8, gammas=4, thetas=6, theta_min=-0.5, theta_max=0.5, parametrisation=parametrisation, seed=1
    )
    agent = new_agent(settings)
    with torch.no_grad():  # outputs that differ, so that no bin is empty
        for weights in agent.target.parameters():
            weights.add_(0.3 * torch.randn(weights.shape, generator=torch.Generator().manual_seed(2)))
    return agent


def agents():
    for path in SHIPPED:
        yield pytest.param(lambda path=path: _shipped(path), id=path.stem)
    for name in LEARNED:
        yield pytest.param(lambda name=name: (untrained(name), "CartPole-v1"), id=name)


def _shipped(path: Path):
    loaded = load_checkpoint(path)
    return loaded.agent, loaded.environment


def by_hand(agent, observation: np.ndarray) -> np.ndarray:
    """sum over bins of their mass times their reward at every discount, ``(A, G)``, from tails and constant channel.

    Below theta_1 lies what the constant channel exceeds the lowest tail by, and counts as theta_1; above theta_H the
    last tail, and counts as theta_H; between two sensitivities the middle counts.
    """
    tails, constant = (each[0] for each in agent.gamma_spaces(observation[None]))
    thetas = agent.thetas
    found = thetas[0] * (constant - tails[..., 0]) + thetas[-1] * tails[..., -1]
    for h in range(len(thetas) - 1):
        found = found + 0.5 * (thetas[h] + thetas[h + 1]) * (tails[..., h] - tails[..., h + 1])
    return found


AGENTS = list(agents())


@pytest.mark.parametrize("made", AGENTS)
def test_values_that_act_are_those_of_the_gamma_space(made):
    """The network computes in single precision, which rounds a sum of H terms of its size by some 1e-7 each: 1e-5."""
    agent, environment = made()
    observations = visited(agent, environment)
    acted = agent.action_values(observations)  # (N, G, A)
    spaces = [agent.gamma_space(observation) for observation in observations]
    drawn = np.stack([(space.differences @ space.bin_values).T for space in spaces])
    hand = np.stack([by_hand(agent, observation).T for observation in observations])
    size = np.abs(acted).max(axis=(0, 2), keepdims=True)
    assert (np.abs(acted - drawn) / size).max() < 1e-5
    np.testing.assert_allclose(drawn / size, hand / size, rtol=0, atol=1e-12)


@pytest.mark.parametrize("made", AGENTS)
def test_readout_and_decoded_are_one_rule(made):
    agent, environment = made()
    trained, observations = agent.settings.hidden > 8, visited(agent, environment)
    for length in (5, 50, 200):
        options = Options(steps=200)
        first, second = (RULES[name].values(agent, length, options)(observations, 0) for name in ("readout", "decoded"))
        # The terms of an untrained agent all but cancel: its values are rounded as their sizes are.
        spaces = [agent.gamma_space(observation) for observation in observations]
        terms = max(np.abs(space.differences * space.bin_values).sum(axis=-1).max() for space in spaces)
        assert np.abs(first - second).max() <= 1e-6 * (np.abs(first).max() if trained else terms)
        # Where two actions are as good to rounding, rounding decides.
        apart = np.ptp(np.sort(first, axis=1)[:, -2:], axis=1) > 1e-5 * np.abs(first).max()
        assert apart.sum() > len(apart) / 2
        np.testing.assert_array_equal(greedy_action(first)[apart], greedy_action(second)[apart])


@pytest.mark.parametrize("made", AGENTS)
def test_the_lens_draws_what_is_decoded(made):
    agent, environment = made()
    for observation in visited(agent, environment, 12)[::4]:
        settings = structure(Settings(world="network", steps=60, acting_gamma=agent.acting_discount), None)
        found = study_of_gamma_space(agent.gamma_space(observation), settings, own_convention=False)
        data, _ = payload(found, places=agent.sensitivities.places)
        state = state_of(found.settings, 20.0) | {"fold": False}
        shown = seen(data, state)
        scale = np.abs(found.decoded.horizon_values).max()
        np.testing.assert_allclose(shown["differences"], found.gamma_space.differences, rtol=0, atol=1e-9 * scale)
        for name in ("horizon_values", "expected_reward"):
            np.testing.assert_allclose(shown[name], getattr(found.decoded, name), rtol=0, atol=1e-9 * scale)
        np.testing.assert_allclose(shown["tau_space"], found.decoded.tau_space, atol=1e-9)
        softer = seen(data, state | {"slope_share": 0.5})
        np.testing.assert_allclose(softer["differences"].sum(-1), found.gamma_space.constant, rtol=1e-9)


def test_a_step_of_an_episode_and_its_file_keep_open_ends():
    agent = untrained("softmax")
    rollout = roll_out(agent, "CartPole-v1", 3, horizon=4)
    space, exact = rollout.space(2), agent.gamma_space(rollout.observations[2])
    assert space.open_ends
    np.testing.assert_allclose(space.differences @ space.bin_values, exact.differences @ exact.bin_values, rtol=1e-5)
    own = read_gamma_space(rollout_npz(rollout), "2")
    np.testing.assert_array_equal(own.differences, space.differences)
