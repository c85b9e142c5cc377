"""Grades of a view, in numbers: its choice, its values and its timeline, each graded separately.

A view is a study and one of its horizons. Grades do not say why something is wrong: :mod:`laplace_core.study.trials`
searches for the cause by running the view again under other settings, and :mod:`laplace_core.study.verdict` words it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from laplace_core.code.ties import greedy_action, tie_size
from laplace_core.inverse import SURVIVAL_FLOOR
from laplace_core.study.horizon import horizon_values
from laplace_core.study.pipeline import Decoded, Truth, WorldStudy

VALUE_TOLERANCE = 0.1
"""Values whose largest error is at most this share of the largest true value hold."""
SOUND = 0.10
"""Share of a timeline's probability that may lie at the wrong step or reward before the timeline is called smeared."""
RUINED = 1.0 / 3.0
"""The share from which on a smeared timeline is called ruined."""
LEAST_MASS = 0.05
"""A true timeline that holds less probability than this counts as holding this much."""
LEAST_SHOWN = 0.05
"""A picture that holds a smaller share of the true timeline than this shows nothing of it."""

Timeline = Literal["sound", "smeared", "ruined"]


@dataclass(frozen=True)
class Grade:
    """The numbers of a view.

    Attributes:
        chosen, best: indices of actions.
        regret: Q*_T of the best action minus that of the chosen one, in units of reward, >= 0.
        wrong: whether the regret exceeds a tie.
        error: largest |V_T - true V_T| over the actions, in units of reward, the deadline of the truth being hard.
        value_error: the same with the deadline of the study, as a share of the largest true value; where nothing is
            ever paid, any value that is not rounding is infinitely far off.
    """

    chosen: int
    best: int
    regret: float
    wrong: bool
    error: float
    value_error: float

    @property
    def off(self) -> bool:
        """Whether the values are too far off for a right choice to be right for its reason."""
        return self.value_error > VALUE_TOLERANCE


def grade(study: WorldStudy, row: int, decoded: Decoded | None = None) -> Grade:
    """The grade of a study at the horizon of one row.

    Args:
        decoded: a reading for this row, to be graded in place of the study's own.
    """
    decoded, read = study.at(row) if decoded is None else decoded, study.reading(row)[0]
    return grade_values(study.truth, study, row, decoded.horizon_values[:, read], scale=decoded.scale)


def grade_values(truth: Truth, study: WorldStudy, row: int, values: np.ndarray, *, scale: float) -> Grade:
    """The grade of values ``(A,)`` read for the horizon of a row, of terms of size ``scale``, against a truth.

    The world, the acting discount and the time step are those of the study.
    """
    s, left = study.settings, study.reading(row)[1]
    optimum, true = truth.optimum[:, left], truth.horizon_values[:, left]
    hard = true
    if s.softness or s.value_gamma != s.acting_gamma:
        hard = horizon_values(truth.expected_reward, s.acting_gamma, 0.0, s.time_step)[:, left]
    chosen, best = int(greedy_action(values, scale=scale)), int(greedy_action(optimum))
    regret = float(optimum.max() - optimum[chosen])
    largest = max(np.abs(true).max(), 1e-2 * np.abs(study.world.reward_values).max())
    off = float(np.abs(values - true).max())
    return Grade(
        chosen,
        best,
        regret,
        bool(regret > tie_size(optimum.max(), np.abs(optimum).max())),
        float(np.abs(values - hard).max()),
        off / largest if largest > 0 else np.inf if off > tie_size(0.0, scale) else 0.0,
    )


def timeline_error(study: WorldStudy, action: int, decoded: Decoded | None = None) -> float:
    """Share of an action's probability that its drawn rows have at the wrong step or reward.

    Half the sum of |decoded - true| over steps and rewards, by the sum of the true ones: 0 for a perfect inverse, 1
    where nothing lies where it should, more where probability is invented. Each bin counts for the world's nearest
    reward, and with a ``time_step`` below 1 each row for the nearest step, so that a finer picture is not a worse one.
    Rows given survival are compared with true rows given survival. A picture whose sensitivities hold less than
    ``LEAST_SHOWN`` of what truly comes counts as wholly misplaced.
    """
    decoded = study.decoded if decoded is None else decoded
    truth, s = study.truth, study.settings
    true = truth.tau_space[action]
    if true.sum() < LEAST_SHOWN * truth.survival[action].sum():
        return 1.0
    if s.normalise == "survival":
        alive = truth.survival[action][:, None]
        true = np.divide(true, alive, out=np.zeros_like(true), where=alive > SURVIVAL_FLOOR)
    rows = decoded.tau_space[action]
    true, rows = (by_step(by_reward(part, study), s.time_step) for part in (true, rows))
    return float(0.5 * np.abs(rows - true).sum() / max(true.sum(), LEAST_MASS))


def timeline_grade(error: float) -> Timeline:
    """``sound``, ``smeared`` or ``ruined`` of a :func:`timeline_error`."""
    return "sound" if error <= SOUND else "smeared" if error <= RUINED else "ruined"


def by_reward(bins: np.ndarray, study: WorldStudy) -> np.ndarray:
    """Bins ``(..., B)`` counted for the world's nearest reward each, ``(..., V)``."""
    rewards = study.world.reward_values
    edges = np.searchsorted(study.midpoints, (rewards[1:] + rewards[:-1]) / 2.0, side="right")
    sums = np.concatenate([np.zeros_like(bins[..., :1]), np.cumsum(bins, axis=-1)], axis=-1)
    return np.diff(sums[..., np.concatenate([[0], edges, [bins.shape[-1]]])], axis=-1)


def by_step(rows: np.ndarray, time_step: float) -> np.ndarray:
    """Rows ``(K, n)`` added up over the rows nearest to each whole step, ``(N, n)``."""
    if time_step == 1.0:
        return rows
    starts = np.flatnonzero(np.diff(np.floor(np.arange(len(rows)) * time_step + 0.5 + 1e-9), prepend=-1.0))
    return np.add.reduceat(rows, starts, axis=0)
