"""One state at many alphas: the fit of each, the curves of the selectors, and the distance from the truth."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.inverse import AlphaRecord, choose_alpha, is_linear
from laplace_core.inverse.components import sweep_alphas, sweep_of
from laplace_core.inverse.selectors import AUTO, curves_of, plain_curve
from laplace_core.inverse.solvers import spectrum_for
from laplace_core.study.pipeline import Decoded, Study, decode_and_read, noise_of, problem_for


@dataclass(frozen=True, eq=False)
class AlphaSweep:
    """A study at a alphas.

    Attributes:
        study: at the alpha of its own settings.
        alphas: ``(a,)``, increasing.
        residual: ``(a,)``, norm of the weighted residual, over all discounts, actions and tails.
        size: ``(a,)``, norm of L x, of the tails over time.
        degrees: ``(a,)``, effective degrees of freedom of one tail.
        curves: by selector, ``(a,)``; each takes the smallest value, infinity where it has none.
        record: what ``auto`` chooses, and each of the others.
        time_error: ``(a,)``, :func:`time_distance` from the truth, mean over the actions, in steps; None without one.
        value_error: ``(a,)``, largest error of V_T over the actions at the horizon of the study; None without a truth.
    """

    study: Study
    alphas: np.ndarray
    residual: np.ndarray
    size: np.ndarray
    degrees: np.ndarray
    curves: dict[str, np.ndarray]
    record: AlphaRecord
    time_error: np.ndarray | None
    value_error: np.ndarray | None

    def as_dict(self) -> dict[str, Any]:
        """Plain numbers, None for those that are not finite."""
        arrays = {
            "alpha": self.alphas, "residual_norm": self.residual, "solution_norm": self.size,
            "degrees_of_freedom": self.degrees, "w1": self.time_error, "value_error": self.value_error,
        }  # fmt: skip
        known = {name: list(plain_curve(array[None])) for name, array in arrays.items() if array is not None}
        curves = {name: list(plain_curve(curve[None])) for name, curve in self.curves.items()}
        chosen = {str(self.record.criterion): self.record.value, **self.record.others}
        return {**known, "curves": curves, "chosen": chosen, "auto": self.record.criterion}


def time_distance(decoded: np.ndarray, true: np.ndarray, time_step: float = 1.0) -> np.ndarray:
    """The distance over which probability moves along time from one tau-space to another, ``(..., K, B)`` to ``(...)``.

    The area between the sums up to each row, of every bin, added up over the bins: the W1 distance over time where both
    hold as much in a bin. What one of them lacks counts as carried to the end of the rows. In steps times probability.
    """
    return np.abs(np.cumsum(decoded - true, axis=-2)).sum(axis=(-2, -1)) * time_step


def sweep_alpha(study: Study, count: int | None = None) -> AlphaSweep:
    """A study at many alphas of its solver, everything else as in its settings.

    Args:
        count: how many alphas; truncation has one for each number of components instead. Default: as selectors have it.

    Raises:
        InputError: a solver that is not linear.
    """
    s = study.settings
    if not is_linear(s.solver):
        raise InputError(f"a sweep needs a linear solver, which {s.solver} is not: choose another --solver.")
    read, left = study.reading(study.row)
    problem, noise = problem_for(study.gamma_space, s, read), noise_of(s, study.gamma_space.gammas)
    alphas = None if count is None else sweep_alphas(spectrum_for(problem, s.solver), s.solver, count)
    sweep = sweep_of(problem, s.solver, alphas=alphas, noise=noise)
    times, values = None, None
    if study.truth is not None:
        pictures = [decode_and_read(study.gamma_space, s.at_alpha(alpha), read) for alpha in sweep.alphas.tolist()]
        times, values = errors_of(pictures, study, read, left=left)
    return AlphaSweep(
        study=study,
        alphas=sweep.alphas,
        residual=np.sqrt(sweep.residual[0]),
        size=np.sqrt(sweep.size[0]),
        degrees=sweep.degrees,
        curves={name: curve[0] for name, curve in curves_of(sweep).items()},
        record=choose_alpha(problem, s.solver, AUTO, noise=noise, alphas=sweep.alphas),
        time_error=times,
        value_error=values,
    )


def errors_of(pictures: list[Decoded], study: Study, read: int, *, left: int) -> tuple[np.ndarray, np.ndarray]:
    """:func:`time_distance` from the truth, mean over the actions, and largest error of V_T, one a picture.

    Args:
        read, left: columns of the decoded value and of the true one.
    """
    truth = study.truth
    assert truth is not None
    times = [time_distance(each.tau_space, truth.tau_space, study.settings.time_step).mean() for each in pictures]
    values = [np.abs(each.horizon_values[:, read] - truth.horizon_values[:, left]).max() for each in pictures]
    return np.array(times), np.array(values)
