"""Which ratio of two times is resolved at a signal-to-noise ratio."""

import numpy as np
import pytest

from laplace_core import InputError
from laplace_core.code.encoding import discount_grid
from laplace_core.inverse.resolution import needed_snr, resolution, resolvable_ratio

GAMMAS = discount_grid(15, "log")


@pytest.mark.parametrize(("snr", "ratio"), [(10, 6.4), (100, 2.7), (1e3, 2.0), (1e4, 1.7)])
def test_the_ratio_is_that_of_mcwhirter_and_pike(snr, ratio):
    # arccosh(100) = 5.298: w = 1.686, exp(pi / 1.686) = 6.44; and so on.
    assert resolvable_ratio(snr) == pytest.approx(ratio, abs=0.06)


@pytest.mark.parametrize("snr", [2.0, 30.0, 1e5])
def test_the_needed_ratio_of_signal_to_noise_is_the_inverse(snr):
    assert needed_snr(resolvable_ratio(snr)) == pytest.approx(snr, rel=1e-9)


def test_the_ratio_is_where_the_transform_falls_to_the_noise():
    # The gain of the Laplace transform at frequency w over log time is |Gamma(1/2 + i w)| = sqrt(pi / cosh(pi w)).
    from scipy.special import gamma

    frequency = np.pi / np.log(resolvable_ratio(50.0))
    assert abs(gamma(0.5 + 1j * frequency)) / abs(gamma(0.5)) == pytest.approx(1 / 50.0, rel=1e-9)


def test_pairs_are_resolved_marginal_or_not(subtests):
    # At 100 the ratio is 2.71, at 300 2.28: 3 is resolved, 2.5 marginal, 1.5 not.
    for late, verdict in ((30.0, "resolved"), (25.0, "marginal"), (15.0, "unresolved")):
        with subtests.test(late=late):
            found = resolution(late, 10.0, 100.0, GAMMAS)
            assert found.verdict == verdict
            assert verdict in found.sentence
            assert found.surrounded
    resolved, marginal = resolution(10, 30, 100.0, GAMMAS), resolution(10, 25, 100.0, GAMMAS)
    assert (resolved.samples, resolved.discounts) == (1.0, 15)
    assert marginal.samples == pytest.approx((needed_snr(2.5) / 100.0) ** 2)
    assert marginal.discounts == np.ceil(15 * marginal.samples)
    assert f"{marginal.discounts} discounts" in marginal.sentence


def test_times_outside_the_time_constants_are_named():
    assert "surround" in resolution(10.0, 900.0, 100.0, GAMMAS).sentence


def test_impossible_pairs_are_refused(subtests):
    for first, second, snr, named in [
        (0.0, 3.0, 10.0, "times"),
        (3.0, 3.0, 10.0, "times"),
        (1.0, np.inf, 10.0, "times"),
        (1.0, 2.0, 1.0, "signal-to-noise"),
        (1.0, 2.0, np.nan, "signal-to-noise"),
    ]:
        with subtests.test(first=first, second=second, snr=snr), pytest.raises(InputError, match=named):
            resolution(first, second, snr, GAMMAS)
