"""One interface for all solvers: masses over the discounts go in, a timeline of masses comes out.

H sensitivities cut the rewards into H + 1 bins: below the first sensitivity, the H - 1 bins between neighbours, above
the last one. What they hold at one discount sums to the constant channel, and what they hold at one step sums to
survival. A solver is given all of them, so that survival may stand in its constraints.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from laplace_core.code.gamma_space import GammaSpace, bin_differences
from laplace_core.errors import InputError
from laplace_core.inverse.transform import transform_matrix


@dataclass(frozen=True, eq=False)
class Problem:
    """Masses over the discounts, to be inverted.

    Attributes:
        masses: ``(..., G, B)``, discounted steps that pay what lies in each of the B = H + 1 bins.
        gammas: ``(G,)``, discounts.
        steps: K, rows of the timeline.
        time_step: time from one row to the next, in steps of the world.
        deviations: ``(G,)``, standard deviation of the error of one sensitivity's value at each discount, in the units
            of ``masses``; None where it is not known, and then every discount counts alike. A mass is a difference of
            two neighbouring values: its variance is twice this, and neighbouring masses correlate at -1/2.
        starts_alive: whether the first row has survival 1, as that of every state that is not terminal.

    Raises:
        InputError: arrays that do not fit each other.
    """

    masses: np.ndarray
    gammas: np.ndarray
    steps: int
    time_step: float = 1.0
    deviations: np.ndarray | None = None
    starts_alive: bool = True

    def __post_init__(self) -> None:
        if self.masses.ndim < 2 or self.masses.shape[-2] != len(self.gammas):
            raise InputError(
                f"masses of shape {self.masses.shape} do not have {len(self.gammas)} discounts on their second to "
                "last axis."
            )
        deviations = self.deviations
        if deviations is not None and (
            deviations.shape != self.gammas.shape or not np.all(np.isfinite(deviations) & (deviations > 0))
        ):
            raise InputError(f"deviations must be {len(self.gammas)} numbers above 0, one for each discount.")

    @property
    def constant(self) -> np.ndarray:
        """The constant channel: discounted steps still to come, ``(..., G)``."""
        return self.masses.sum(axis=-1)

    @property
    def transform(self) -> np.ndarray:
        """F, ``(G, K)``."""
        return transform_matrix(self.gammas, self.steps, self.time_step)

    @property
    def weights(self) -> np.ndarray:
        """How much each discount's row counts in the fit, ``(G,)``: in proportion to 1 / deviation, mean square 1.

        Equal deviations, or none, make them 1, so that alpha keeps its unit.
        """
        if self.deviations is None:
            return np.ones(len(self.gammas))
        precision = 1.0 / self.deviations
        return precision / np.sqrt(np.mean(precision**2))


@dataclass(frozen=True, eq=False)
class Solution:
    """A timeline that a solver found, and how it fits.

    Attributes:
        masses: ``(..., K, B)``, probability of each bin at each row; with ``time_step`` < 1 a density over time,
            times ``time_step``, as :func:`laplace_core.inverse.decode` returns it.
        residual: ``(..., G, B)``, masses over the discounts less the transform of the timeline (and of what the
            solver puts after the last row).
        degrees_of_freedom: ``(...)``, effective number of parameters that were fitted to the G numbers of one bin,
            mean over the bins: the trace of the influence matrix, or the number of free variables.
        active: bool ``(..., K, B)``, where a mass was held at a constraint; None of a linear solver.
        beyond: ``(..., J, B)``, what the solver puts after the last row, by time constant; None if it does not.
    """

    masses: np.ndarray
    residual: np.ndarray
    degrees_of_freedom: np.ndarray
    active: np.ndarray | None = None
    beyond: np.ndarray | None = None

    @property
    def survival(self) -> np.ndarray:
        """Probability that the episode still runs, ``(..., K)``."""
        return self.masses.sum(axis=-1)

    def tau_space(self, *, open_ends: bool) -> np.ndarray:
        """The bins that count, ``(..., K, H-1)``; with open ends all of them, ``(..., K, H+1)``."""
        return self.masses if open_ends else self.masses[..., 1:-1]


def problem_of(
    gamma_space: GammaSpace, steps: int, time_step: float = 1.0, deviations: np.ndarray | None = None
) -> Problem:
    """The problem of a gamma-space, ``masses`` ``(A, G, H+1)``."""
    masses = bin_differences(gamma_space.values, gamma_space.constant, open_ends=True)
    return Problem(masses, gamma_space.gammas, steps, time_step, deviations)
