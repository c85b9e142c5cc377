"""One state at many alphas: the action that is chosen at each horizon, and the error of the timeline."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from laplace_core.errors import InputError
from laplace_core.inverse import SOLVERS
from laplace_core.inverse.distances import (
    choice_regret,
    mean_time_distance,
    relative_error,
    total_variation,
    value_error,
)
from laplace_core.study.horizon import choose_actions, horizon_values, scale_of_values
from laplace_core.study.pipeline import Study, is_linear_reading, rewards_of


@dataclass(frozen=True, eq=False)
class Course:
    """A study at a alphas.

    Attributes:
        alphas: ``(a,)``, increasing.
        chosen: the action chosen at each horizon, int ``(a, K)``.
        time_error: ``(a,)``, :func:`laplace_core.inverse.distances.mean_time_distance` from the truth, mean over the
            actions, in steps; None without a truth.
        solver: the solver of the study.
    """

    alphas: np.ndarray
    chosen: np.ndarray
    time_error: np.ndarray | None
    solver: str

    @property
    def best(self) -> int | None:
        """The alpha of least distance from the truth, of equals the largest; None without a truth."""
        if self.time_error is None:
            return None
        return int(len(self.alphas) - 1 - np.argmin(self.time_error[::-1]))


def course(study: Study, alphas: np.ndarray) -> Course:
    """A study at these alphas, everything else as in its settings; one picture is held at a time."""
    chosen, errors = [], []
    for alpha in alphas.tolist():
        if study.truth is None and is_linear_reading(study.settings):  # then no tau-space is needed
            chosen.append(_chosen(study, alpha))
            continue
        decoded = study.under(study.settings.at_alpha(alpha)).decoded
        chosen.append(decoded.actions)
        if study.truth is not None:
            errors.append(_time_error(study, decoded.tau_space))
    return Course(
        np.asarray(alphas), np.array(chosen, dtype=int), np.array(errors) if errors else None, study.settings.solver
    )


def _chosen(study: Study, alpha: float) -> np.ndarray:
    s = study.settings
    rewards = rewards_of(study.gamma_space, s.at_alpha(alpha))
    values = horizon_values(rewards, s.value_gamma, s.softness, s.time_step)
    return choose_actions(values, scale_of_values(rewards, study.midpoints))


def _time_error(study: Study, tau_space: np.ndarray) -> float:
    assert study.truth is not None
    return float(mean_time_distance(tau_space, study.truth.tau_space, study.settings.time_step).mean())


def turns(chosen: np.ndarray) -> list[tuple[int, int]]:
    """Stretches of horizons with one choice, ``(K,)``: the first column of each and its action."""
    begins = np.flatnonzero(np.diff(chosen, prepend=-1))
    return [(int(k), int(chosen[k])) for k in begins]


class Errors(NamedTuple):
    """The distances of a study from its truth; all None without a truth.

    Attributes:
        relative_error, distance, variation: of :mod:`laplace_core.inverse.distances`, mean over the actions.
        value_error: mean error of V_T over actions and horizons, by the range of its true values.
        regret: mean over horizons of what the chosen action loses, by the same range.
    """

    relative_error: float | None = None
    distance: float | None = None
    variation: float | None = None
    value_error: float | None = None
    regret: float | None = None


@dataclass(frozen=True)
class Ranked:
    """One solver on one study, with the alpha that a rule chooses for it.

    Attributes:
        alpha: None where the solver has none.
        seconds: that the choice of alpha and the inverse took.
    """

    solver: str
    alpha: float | None
    seconds: float
    errors: Errors


def ranking(study: Study, rule: str = "auto") -> Iterator[Ranked]:
    """Every solver that can be used on a study, in the order of ``SOLVERS``.

    A solver that refuses the study, such as a network that was fitted to other discounts, is left out.
    """
    for solver in SOLVERS:
        began = time.perf_counter()
        try:
            found = study.under(replace(study.settings, solver=solver, selector=rule))
        except InputError:
            continue
        seconds = time.perf_counter() - began
        yield Ranked(solver, found.settings.alpha if SOLVERS[solver].has_alpha else None, seconds, errors_of(found))


def errors_of(study: Study) -> Errors:
    """The distances of a study from its truth."""
    truth, decoded = study.truth, study.decoded
    if truth is None:
        return Errors()
    pictures = decoded.tau_space, truth.tau_space
    return Errors(
        float(relative_error(*pictures).mean()),
        _time_error(study, decoded.tau_space),
        float(total_variation(*pictures).mean()),
        value_error(decoded.horizon_values, truth.horizon_values),
        choice_regret(decoded.horizon_values, truth.horizon_values),
    )
