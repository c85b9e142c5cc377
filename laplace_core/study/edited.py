"""A study's timeline, changed by hand: what it would be worth, what would be chosen, what would have been learned."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from laplace_core.code.gamma_space import GammaSpace, bin_values
from laplace_core.inverse import solve
from laplace_core.study.manipulate import cut, distorted, rediscounted, transformed, values_of
from laplace_core.study.pipeline import Study, problem_for


@dataclass(frozen=True)
class Edit:
    """Changes of a timeline, made in this order.

    Attributes:
        horizon: the episode is stopped after so many steps; None: it is not.
        gamma: the chance to go on after each step.
        worst: each step counts as the mean of this share of its worst outcomes.
    """

    horizon: float | None = None
    gamma: float = 1.0
    worst: float = 1.0

    @property
    def changes(self) -> bool:
        """Whether anything is changed at all."""
        return self != Edit()


@dataclass(frozen=True, eq=False)
class Edited:
    """A timeline before and after an edit; values ``(A, K)``, actions int ``(K,)``.

    Attributes:
        before, after: the gamma-spaces of both.
    """

    values: np.ndarray
    actions: np.ndarray
    new_values: np.ndarray
    new_actions: np.ndarray
    before: GammaSpace
    after: GammaSpace


def edit(study: Study, wanted: Edit) -> Edited:
    """The timeline that the solver of a study finds, with its open ends, before and after an edit.

    Raises:
        InputError: a horizon, a discount or a share out of its range.
    """
    s, space = study.settings, study.gamma_space
    masses = solve(problem_for(space, s), s.solver, s.alpha).masses
    changed = masses if wanted.horizon is None else cut(masses, wanted.horizon, 0.0, s.time_step)
    changed = rediscounted(changed, wanted.gamma, s.time_step)
    if wanted.worst != 1.0:
        worth = bin_values(space.thetas, open_ends=True)
        changed = distorted(changed, worth, "cvar", wanted.worst, time_step=s.time_step)
    read = [values_of(each, space.thetas, s.value_gamma, softness=s.softness, time_step=s.time_step)
            for each in (masses, changed)]  # fmt: skip
    back = [transformed(each, space.gammas, space.thetas, s.time_step) for each in (masses, changed)]
    return Edited(*read[0], *read[1], *back)
