"""What the player is handed: an episode packed small, and how far that is from the exact one."""

from __future__ import annotations

import json
import struct
import zlib

import numpy as np
import pytest
import torch

from laplace_core.acting.rollout import roll_out
from laplace_core.agents import LaplaceSettings
from laplace_core.payloads.player import LEVELS, payload, rounded
from laplace_core.trained import rollouts
from laplace_core.trained.rollouts import Control
from laplace_core.training.checkpoint import new_agent

torch.set_num_threads(1)


@pytest.fixture(scope="module")
def rollout():
    settings = LaplaceSettings(hidden=8, features=4, gammas=5, thetas=9, theta_min=-3.0, theta_max=12.0, seed=3)
    return roll_out(new_agent(settings), "CartPole-v1", 7, pictures=True)


def blocks_of(data: bytes):
    (length,) = struct.unpack_from("<I", data)
    header = json.loads(data[4 : 4 + length])
    cut = {name: data[4 + length + at : 4 + length + at + size] for name, (_, at, size) in header["blocks"].items()}
    return header, cut


def test_differences_come_back_within_half_a_level(rollout):
    header, blocks = blocks_of(payload(rollout))
    low, high = np.frombuffer(zlib.decompress(blocks["differences"]), np.uint8).reshape(2, -1).astype(np.uint16)
    changes = (low | (high << 8)).astype(np.uint16).view(np.int16).reshape(len(rollout), 2, 5, 10)
    levels = np.cumsum(changes, axis=0, dtype=np.int16)
    scales = np.frombuffer(blocks["scales"])
    # Tails from the constant channel down to nothing: the ends are open.
    nothing = np.zeros_like(rollout.spaces[..., :1])
    exact = -np.diff(np.concatenate([rollout.constants[..., None], rollout.spaces, nothing], axis=-1)).astype(float)
    off = np.abs(levels * scales[:, None] - exact).max(axis=(0, 1, 3))
    np.testing.assert_array_less(off, 0.5001 * scales)
    np.testing.assert_allclose(scales * LEVELS, np.abs(exact).max(axis=(0, 1, 3)), rtol=1e-6)
    assert header["steps"] == len(rollout)


def test_everything_else_is_exact(rollout):
    _, blocks = blocks_of(payload(rollout))
    np.testing.assert_array_equal(np.frombuffer(blocks["surprise"]), rollout.surprise)
    np.testing.assert_array_equal(np.frombuffer(blocks["values"]).reshape(-1, 2), rollout.values)
    np.testing.assert_array_equal(np.frombuffer(blocks["observations"], "<f4").reshape(-1, 4), rollout.observations)
    constant = np.frombuffer(zlib.decompress(blocks["constant"]), "<f4").reshape(rollout.constants.shape)
    np.testing.assert_array_equal(constant, rollout.constants)
    ends = np.frombuffer(blocks["ends"]).astype(int)
    assert blocks["frames"][ends[2] : ends[3]] == rollout.frames[3]


def test_a_space_of_zeros_does_not_divide_by_zero():
    levels, scales = rounded(np.zeros((2, 1, 3, 4), np.float32))
    assert not levels.any()
    assert (scales > 0).all()


def test_a_thousand_steps_of_the_lander_are_less_than_ten_megabytes():
    """A smooth episode of 4 actions, 15 discounts and 113 sensitivities; of noise nothing would be left out."""
    t, theta = np.linspace(0, 20, 1000)[:, None, None, None], np.linspace(-135, 135, 113)
    sizes = 1 / (1 - np.linspace(0.37, 0.99, 15))[:, None]
    centre = 3 * np.sin(t + np.arange(4)[:, None, None])
    spaces = (sizes / (1 + np.exp((theta - centre) / 8))).astype(np.float32)
    levels, _ = rounded(spaces[..., :-1] - spaces[..., 1:])
    halves = np.diff(levels, axis=0, prepend=levels[:1] * 0).view(np.uint8).reshape(-1, 2).T
    assert len(zlib.compress(np.ascontiguousarray(halves).tobytes(), 6)) < 7e6  # pictures take some 3 MB


def test_what_followed_is_told_from_the_step_on(rollout):
    told = rollouts.followed(rollout, 3)
    assert told["rewards"] == rollout.rewards[3:].tolist()
    assert told["action"] == rollout.actions[3]
    assert told["over"] == (len(rollout) - 3 if rollout.terminated else None)


def test_a_control_by_the_values_of_a_link():
    assert rollouts.control_of({}, 500) == Control(0, "greedy", None, None)
    assert rollouts.control_of({"r.rule": "greedy", "r.gamma": 0.9, "r.horizon": 7}, 500) == Control(gamma=0.9)
    assert rollouts.control_of({"r.rule": "fading", "r.gamma": 0.9, "r.seed": 4}, 500) == Control(4, "fading", 500)
    assert rollouts.control_of({"r.rule": "readout", "r.horizon": 900}, 500) == Control(0, "readout", 500)
    assert rollouts.control_of({"r.rule": "random", "r.gamma": 0.9}, 500) == Control(0, "random", None)
