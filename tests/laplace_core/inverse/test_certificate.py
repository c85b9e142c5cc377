"""Bounds on V_T over all feasible timelines: they hold the truth, they are reached, and they decide."""

from dataclasses import replace

import numpy as np
import pytest

from laplace_core import InputError, Settings, load_world, study
from laplace_core.code.encoding import activation, discount_grid, sensitivity_grid
from laplace_core.code.gamma_space import GammaSpace, with_noise
from laplace_core.inverse.certificate import Certificate, certify, quantisation

GAMMAS = discount_grid(15, "log")
THETAS = sensitivity_grid(60, -2.0, 12.0)
SLOPE = 2.35 / (THETAS[1] - THETAS[0])
REWARDS = (0.0, 10.0)


def space_of(*timelines: dict[int, float]) -> GammaSpace:
    """The exact gamma-space of timelines that pay a reward at each of some steps, and end with the last of them."""
    values, constant = [], []
    for timeline in timelines:
        last = max(timeline)
        paid = np.array([timeline.get(step, 0.0) for step in range(last + 1)])
        powers = GAMMAS[:, None] ** np.arange(last + 1)
        values.append(powers @ activation(paid, THETAS, SLOPE))
        constant.append(powers.sum(axis=1))
    return GammaSpace(np.array(values), np.array(constant), GAMMAS, THETAS)


def certified(space: GammaSpace, horizon: int, noise: float, **options) -> Certificate:
    return certify(space, horizon, noise / (1 - GAMMAS), slope=SLOPE, rewards=REWARDS, **options)


def test_the_truth_lies_within_the_bounds(subtests):
    # 5 at once, or 10 after two steps of nothing: V_T is 5, and .99^2 * 10 from T = 3 on.
    exact = space_of({0: 5.0}, {2: 10.0})
    for noise in (1e-6, 1e-4, 1e-2):
        for horizon, second in ((1, 0.0), (2, 0.0), (3, 9.801), (6, 9.801)):
            with subtests.test(noise=noise, horizon=horizon):
                found = certified(with_noise(exact, noise, 5), horizon, noise)
                assert (found.low <= [5.0, second]).all()
                assert (found.high >= [5.0, second]).all()


def test_clear_cases_are_decided_and_close_ones_are_not():
    exact = space_of({0: 5.0}, {2: 10.0})
    assert certified(exact, 1, 1e-4).better(0, 1) == 0
    assert certified(exact, 6, 1e-4).better(0, 1) == 1
    assert certified(exact, 6, 1e-4).best == 1
    same = space_of({1: 5.0}, {1: 5.0})
    assert certified(same, 4, 1e-4).better(0, 1) is None
    assert certified(same, 4, 1e-4).best is None


def test_the_margin_of_two_actions_is_that_of_their_bounds():
    found = Certificate(np.array([1.0, 3.0]), np.array([2.0, 7.0]), 0.99, 0.0)
    assert found.margin(0, 1) == (-6.0, -1.0)
    assert found.better(0, 1) == found.better(1, 0) == 1


def test_more_noise_widens_the_bounds():
    exact = space_of({4: 10.0})
    widths = [np.ptp([f.low[0], f.high[0]]) for f in (certified(exact, 5, noise) for noise in (1e-5, 1e-3, 1e-1))]
    assert np.all(np.diff(widths) > 0)


def test_bounds_are_reached_by_a_timeline_that_fits():
    # At a noise of 10 nothing is known but that the first step happens: the best timeline pays theta_H = 12 in both
    # steps, the worst theta_1 = -2, discounted by 1 + .99, and the quantisation is added to either.
    found = certified(space_of({1: 5.0}), 2, 10.0)
    assert found.high[0] == pytest.approx(12.0 * 1.99 + found.quantisation * 1.99, abs=1e-6)
    assert found.low[0] == pytest.approx(-2.0 * 1.99 - found.quantisation * 1.99, abs=1e-6)


def test_values_that_no_timeline_has_give_no_bounds():
    exact = space_of({3: 10.0})
    wrong = replace(exact, values=exact.values * 1.2, constant=exact.constant * 1.2)
    found = certified(wrong, 4, 1e-4)
    assert not found.consistent
    assert found.better(0, 0) is None


def test_quantisation_is_what_a_reward_is_off_by(subtests):
    # Far from the ends, neighbouring sigmoids of slope * spacing 2.35 overlap: off by some .0012 of the spacing.
    # At the lowest theta the trapezoid rule counts 1/2 * 1/2 + sigmoid(-2.35) + sigmoid(-4.7) + ... = .347 spacings.
    spacing = THETAS[1] - THETAS[0]
    assert quantisation(THETAS, SLOPE * THETAS, REWARDS) == pytest.approx(1.2e-3 * spacing, rel=0.05)
    assert quantisation(THETAS, SLOPE * THETAS) == pytest.approx(0.347 * spacing, rel=0.01)
    assert quantisation(THETAS, None) == pytest.approx(spacing / 2)
    # A step for an activation counts a reward as the next midpoint: half a spacing.
    assert quantisation(THETAS, 1e6 * THETAS, REWARDS) == pytest.approx(spacing / 2, rel=0.05)


def test_it_decides_a_world_by_its_values():
    found = study(load_world("two_branch"), Settings(steps=6))
    space = with_noise(found.gamma_space, 1e-4, 1)
    certificate = certify(space, 4, 1e-4 / (1 - space.gammas), slope=found.settings.slope)
    assert certificate.best == found.truth.optimal_action[3]


def test_impossible_arguments_are_refused(subtests):
    space = space_of({0: 1.0})
    for named, change in [
        ("horizon", {"horizon": 0}),
        ("horizon", {"horizon": 1.5}),
        ("deviations", {"deviations": np.ones(3)}),
        ("deviations", {"deviations": np.zeros(15)}),
        ("confidence", {"confidence": 1.0}),
        ("layers", {"layers": 0}),
    ]:
        with subtests.test(named=named, change=str(change)), pytest.raises(InputError, match=named):
            certify(space, **({"horizon": 2, "deviations": np.ones(15)} | change))
