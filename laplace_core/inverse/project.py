"""A filter before the inverse: the values of the feasible timeline that fits a gamma-space best."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from laplace_core.code.gamma_space import GammaSpace
from laplace_core.inverse.feasible import feasible
from laplace_core.inverse.problem import problem_of

ROWS = 40
"""Exact steps; later ones are in windows."""


def projected(gamma_space: GammaSpace, deviations: np.ndarray | None = None, rows: int = ROWS) -> GammaSpace:
    """The gamma-space of the feasible timeline of least weighted misfit, with every other field as it was.

    It has tails that never rise with the sensitivity, and discounted steps that some episode can have. Values of a
    feasible timeline stay what they are, up to the width of the windows. What is fitted are masses, the differences of
    neighbouring values: these come nearer to the truth, while their small positive errors add up in the tails.

    Args:
        deviations: ``(G,)``, standard deviation of the error of one value at each discount; default: in proportion to
            1 / (1 - gamma).
        rows: exact steps of that timeline.
    """
    deviations = 1.0 / (1.0 - gamma_space.gammas) if deviations is None else deviations
    problem = problem_of(gamma_space, rows, deviations=deviations)
    masses = problem.masses - feasible(problem, 0.0).residual
    tails = np.cumsum(masses[..., ::-1], axis=-1)[..., ::-1]
    return replace(gamma_space, values=tails[..., 1:], constant=tails[..., 0])
