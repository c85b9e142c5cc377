"""What the pictures of the inverse send to the browser and hear from it; tests/test_js.py compares what they draw."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from app.components.inverse import State, checked
from laplace_core import Settings, load_world, study
from laplace_core.inverse import choose_alpha
from laplace_core.inverse.bands import bins_of, reward_gain
from laplace_core.inverse.feasible import feasible
from laplace_core.inverse.nonnegative import nonnegative
from laplace_core.payloads.inverse import DRAWS, band, payload, swept
from laplace_core.study.course import course
from laplace_core.study.pipeline import noise_of, problem_for
from tests.support.lens_reference import unpacked

STATE = State(0.5, 3.0, "time")


def made(world="two_branch", **values):
    shown = study(load_world(world), Settings(world=world, **{"weighting": "deviation", **values}))
    found = swept(shown)
    return shown, found, unpacked(payload(shown, 0, found, course(shown, np.geomspace(1e-3, 10.0, 4))))


def test_every_rule_takes_the_alpha_that_the_library_takes():
    shown, _, (header, arrays) = made(noise=0.002, noise_level=0.002)
    problem, noise = problem_for(shown.gamma_space, shown.settings), noise_of(shown.settings, shown.gamma_space.gammas)
    record = choose_alpha(problem, "tikhonov", "gcv", noise=noise)
    taken = {rule: arrays["alphas"][at] for rule, at in zip(header["rules"], header["chosen"], strict=True)}
    assert taken == {"gcv": record.value, **record.others}


def test_arrays_are_those_that_a_solver_needs():
    assert "decoded" not in made()[2][1]
    assert {"reduced", "targets"} <= set(made(solver="nonnegative")[2][1])
    shown, _, (header, arrays) = made(solver="feasible", alpha=0.3, steps=6)
    np.testing.assert_allclose(arrays["decoded"], shown.decoded.tau_space[0], atol=1e-6)
    assert header["decoded_at"] == 0.3
    assert header["linear"] == "tikhonov"


def test_bands_need_a_noise_level_and_a_linear_solver():
    assert not {"deviations", "reference"} & set(made()[2][1])
    assert {"deviations", "reference"} <= set(made(noise_level=0.01)[2][1])
    assert "reference" not in made(noise_level=0.01, solver="nonnegative")[2][1]


def test_the_band_of_a_solver_that_is_not_linear_is_that_of_its_draws():
    shown, _, _ = made(noise=0.01, noise_level=0.01, solver="nonnegative", alpha=0.2, steps=6)
    space, s, seen = shown.gamma_space, shown.settings, []
    deviations = noise_of(s, space.gammas)
    for action in range(2):
        found = band(shown, action, independent=True, progress=lambda done, of: seen.append((done, of)))
        layers = bins_of(space, s.steps, deviations, time_step=s.time_step).of_action(action)
        fitted = feasible(layers.problem, 0.0)
        reference = (fitted.masses @ layers.sizes)[0]
        drawn = layers.redrawn(layers.problem.masses - fitted.residual, DRAWS, 0)
        rewards = [
            (nonnegative(replace(drawn, masses=each), s.alpha).masses @ layers.sizes)[0] for each in drawn.masses
        ]
        np.testing.assert_allclose(found.noise, np.std(rewards, axis=0, ddof=1), rtol=1e-6, atol=1e-12)
        np.testing.assert_allclose(found.bias, np.mean(rewards, axis=0) - reference, rtol=1e-6, atol=1e-9)
        assert found.alpha == s.alpha
    assert seen[:2] == [(0, DRAWS), (1, DRAWS)]


def test_a_band_counts_discounts_as_the_solver_does():
    equal, weighed = (
        band(made(noise=0.01, noise_level=0.01, solver="nonnegative", alpha=0.2, steps=6, weighting=weighting)[0], 0,
             independent=True, progress=lambda done, of: None)
        for weighting in ("equal", "deviation")
    )  # fmt: skip
    assert np.abs(np.subtract(equal.noise, weighed.noise)).max() > 0.1 * max(weighed.noise)


def test_a_linear_solver_and_values_of_unknown_noise_have_no_band_of_draws():
    for values in ({"noise_level": 0.01}, {"solver": "nonnegative"}):
        assert band(made(**values)[0], 0, independent=True, progress=lambda done, of: None) is None


def test_a_gain_that_was_measured_takes_the_place_of_the_assumed_one():
    shown, found, (header, _) = made(noise_level=0.01)
    assert header["gain"] == reward_gain(shown.gamma_space)
    assert unpacked(payload(shown, 0, found, gain=1.5))[0]["gain"] == 1.5


def test_a_large_case_is_small_enough_to_be_sent():
    shown = study(load_world("two_decisions"), Settings(world="two_decisions", gammas=100, thetas=250, steps=200))
    assert len(payload(shown, 0, swept(shown))) < 2_000_000


def test_a_state_from_the_browser_holds():
    assert checked({"alpha": 2, "horizon": 7.0, "axis": "gamma"}, STATE) == State(2.0, 7.0, "gamma")


@pytest.mark.parametrize(
    "reported",
    [None, [], "alpha", {}, {"alpha": 0}, {"alpha": -1.0}, {"alpha": True}, {"alpha": float("nan")}, {"alpha": "1"},
     {"alpha": 1e9}, {"horizon": [3]}, {"horizon": 1e9}, {"axis": "theta"}, {"axis": None}, {"other": 1}],
)  # fmt: skip
def test_what_makes_no_sense_is_not_taken_over(reported):
    assert checked(reported, STATE) == STATE
