"""The scale of gaussian and asinh spacing as a setting of ``decode`` and ``train``."""

from __future__ import annotations

import json
from dataclasses import replace
from statistics import NormalDist

import numpy as np
import pytest
import torch

from laplace_core.agents.sensitivities import Sensitivities
from laplace_core.cli import main
from laplace_core.training.defaults import settings_of
from tests.laplace_core.agents.test_agents import SMALL
from tests.support.hostile import assert_refused

WIDE = replace(SMALL, thetas=113, theta_min=-135.0, theta_max=135.0, theta_spacing="gaussian", theta_scale=20.0)


@pytest.mark.parametrize("scale", [20.0, 50.0])
def test_gaussian_thresholds_of_an_agent_lie_at_even_quantiles(scale):
    thetas = Sensitivities(replace(WIDE, theta_scale=scale)).thetas
    quantiles = np.array([NormalDist(0.0, scale).cdf(theta) for theta in thetas])
    gaps = np.diff(quantiles)
    np.testing.assert_allclose(gaps, gaps[0], rtol=1e-6)
    np.testing.assert_array_equal(thetas[[0, 56, -1]], [-135.0, thetas[56], 135.0])
    assert thetas[56] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("reward", [-9.3, -0.3, 0.0, 0.1, 1.5, 14.0])
def test_gaussian_sensitivities_do_not_round_rewards_in_the_middle(reward):
    """The midpoint proxy of one reward misses it by less than a tenth of the gap it falls into, up to a deviation."""
    sensitivities = Sensitivities(WIDE)
    masses = sensitivities.masses(torch.tensor([reward], dtype=torch.float32)).double().numpy()[0]
    gap = np.diff(sensitivities.thetas)[np.searchsorted(sensitivities.thetas, reward)]
    assert masses.sum() == pytest.approx(1.0, abs=1e-6)
    assert masses @ sensitivities.bin_values == pytest.approx(reward, abs=0.1 * gap)


def test_train_takes_a_scale_and_refuses_one_that_changes_nothing(capsys, tmp_path):
    given = {"theta_spacing": "gaussian", "theta_scale": "20"}
    assert settings_of("laplace", "LunarLander-v3", given).theta_scale == 20.0
    words = ["train", "laplace", "two_branch", "--run", str(tmp_path / "run")]
    assert_refused(capsys, [*words, "--theta-scale", "20"], "theta_scale", "uniform")
    assert not (tmp_path / "run").exists()


def test_decode_takes_a_scale_and_gives_it_back(capsys, tmp_path):
    out = tmp_path / "decoded.npz"
    words = ["--theta-spacing", "gaussian", "--theta-min", "-4", "--theta-max", "6", "--thetas", "5"]
    assert main(["decode", "fig6_chain", *words, "--theta-scale", "2", "--out", str(out)]) == 0
    # The middle is 1, the ends lie 2.5 deviations away.
    law = NormalDist(1.0, 2.0)
    first, last = law.cdf(-4.0), law.cdf(6.0)
    inner = [law.inv_cdf(first + (last - first) * share) for share in (0.25, 0.5, 0.75)]
    with np.load(out) as found:
        np.testing.assert_allclose(found["thetas"], [-4.0, *inner, 6.0], rtol=1e-9)
        assert json.loads(str(found["settings"]))["theta_scale"] == 2.0
    assert_refused(capsys, ["decode", "fig6_chain", "--theta-scale", "2"], "--theta-scale", "uniform")
