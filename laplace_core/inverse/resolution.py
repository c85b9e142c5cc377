"""How far apart in time two rewards must be to be resolved by discounts, at a given noise.

The Laplace transform multiplies the component of frequency w over log time by sqrt(pi / cosh(pi w)) (McWhirter and
Pike, J. Phys. A 11, 1978). Components up to the w at which this falls to 1 / SNR of its largest can be recovered,
and two times are resolved if their ratio is at least exp(pi / w):

    w = arccosh(SNR^2) / pi,    ratio = exp(pi / w)

It holds for times that the time constants -1 / log(gamma) of the discounts surround.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from laplace_core.errors import InputError

MARGIN = 3.0
"""A pair is marginal if a signal-to-noise ratio this many times as large resolves it."""


@dataclass(frozen=True)
class Resolution:
    """Whether two rewards are resolved.

    Attributes:
        ratio: of the later time to the earlier one.
        resolvable: the smallest ratio that is resolved at this noise.
        verdict: ``resolved``, ``marginal`` or ``unresolved``.
        surrounded: whether both times lie within the time constants of the discounts.
        samples: how many times as many samples resolve them; 1 if they are resolved.
        discounts: how many discounts in the same range do, each as noisy as those there are.
    """

    ratio: float
    resolvable: float
    verdict: str
    surrounded: bool
    samples: float
    discounts: int

    @property
    def sentence(self) -> str:
        """What is found and what would resolve the pair, in one or two sentences."""
        found = f"Times at a ratio of {self.ratio:.2g} are {self.verdict}: {self.resolvable:.2g} is resolvable."
        if self.verdict != "resolved":
            found += f" {self.samples:.2g} times as many samples, or {self.discounts:,} discounts, would resolve them."
        if not self.surrounded:
            found += " The time constants of the discounts do not surround both times."
        return found


def resolvable_ratio(snr: float) -> float:
    """The smallest ratio of two times that is resolved at a signal-to-noise ratio.

    Raises:
        InputError: a ratio that is not above 1.
    """
    if not (np.isfinite(snr) and snr > 1.0):
        raise InputError(f"the signal-to-noise ratio is {snr:g}; it must be above 1.")
    return float(np.exp(np.pi**2 / np.arccosh(snr**2)))


def needed_snr(ratio: float) -> float:
    """The signal-to-noise ratio at which two times of a ratio are resolved, inverse to :func:`resolvable_ratio`."""
    return float(np.sqrt(np.cosh(np.pi**2 / np.log(ratio))))


def resolution(first: float, second: float, snr: float, gammas: np.ndarray) -> Resolution:
    """Whether rewards at two times are resolved.

    Args:
        first: time of a reward, in steps, above 0.
        second: of the other.
        snr: size of (1 - gamma) Q that the smaller reward makes, over its standard deviation.

    Raises:
        InputError: times that are not above 0, or equal; a ratio that is not above 1.
    """
    early, late = sorted((float(first), float(second)))
    if not (early > 0.0 and np.isfinite(late) and late > early):
        raise InputError(f"the times are {first:g} and {second:g}; they must be two different numbers above 0.")
    ratio, resolvable = late / early, resolvable_ratio(snr)
    if ratio >= resolvable:
        verdict = "resolved"
    else:
        verdict = "marginal" if ratio >= resolvable_ratio(MARGIN * snr) else "unresolved"
    more = max(1.0, (needed_snr(ratio) / snr) ** 2) if verdict != "resolved" else 1.0
    constants = -1.0 / np.log(np.asarray(gammas))
    surrounded = bool(constants.min() <= early and late <= constants.max())
    return Resolution(ratio, resolvable, verdict, surrounded, more, int(np.ceil(min(more * len(constants), 1e12))))
