"""Bounded caches between the page of the inverse and the library."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, replace

import numpy as np

from app.view.compute import study_for
from laplace_core import InputError, Study
from laplace_core.caching import cached
from laplace_core.inverse import is_linear
from laplace_core.inverse.solvers import selecting
from laplace_core.payloads.inverse import FOLLOWS, Swept, payload, swept
from laplace_core.study.course import Course, Ranked, course, ranking
from laplace_core.study.settings import Resolved, ResolvedForWorld
from laplace_core.subjects import Exact, Learner, Subject, View
from laplace_core.tabular import reward_gain_over_seeds

ALPHAS, FEW_ALPHAS = 100, 24
"""Of a course, of a linear solver and of one that takes longer."""
MOST_WORK = 20_000_000
"""Numbers of all actions, discounts, rows and bins together up to which the non-negative solver has a course of its
own: a second or two."""
MOST_PAYLOAD = 25
"""Megabytes that the page may send to a browser."""


@dataclass(frozen=True, eq=False)
class Shown:
    """Everything that the page shows of a view, except the results that take seconds."""

    study: Study
    found: Swept
    course: Course
    data: bytes


def structure(settings: Resolved) -> Resolved:
    """Settings without those that move in the browser: equal ones have the same payload."""
    follows = is_linear(settings.solver) or settings.solver == FOLLOWS
    return replace(settings.at_alpha(1.0 if follows else settings.alpha), horizon=None)


def shown(view: View) -> Shown:
    """What the page shows of a view.

    Raises:
        InputError: settings that do not fit each other, or more than a browser should be sent.
    """
    study = study_for(view)
    base = structure(study.settings)
    subject = view.subject
    data = _payload(subject, base, view.action)
    return Shown(study, _swept(subject, base), _course(subject, base), data)


def independent(view: View) -> bool:
    """Whether errors of different sensitivities are independent.

    Those of noise that was put in are. A learner learns all sensitivities from the same steps: its errors are nearer to
    one error that all share.
    """
    return isinstance(view.subject, Exact)


def key_of(view: View) -> Hashable:
    """The cache key of the evidence of a view."""
    base = replace(structure(study_for(view).settings), solver="tikhonov", alpha=1.0)
    return view.subject, base


def _study(subject: Subject, settings: Resolved) -> Study:
    return study_for(View(subject, settings, 0))


@cached(16)
def _swept(subject: Subject, settings: Resolved) -> Swept:
    return swept(_study(subject, settings))


@cached(16)
def _course(subject: Subject, settings: Resolved) -> Course:
    """The course of a solver; if that takes too long, of the linear solver that chooses alpha."""
    study, found = _study(subject, settings), _swept(subject, settings)
    alphas = found.sweep.alphas[found.first :]
    actions, discounts, thetas = study.gamma_space.values.shape
    own = is_linear(settings.solver)
    if settings.solver == FOLLOWS:
        own = actions * discounts * thetas * settings.steps <= MOST_WORK
    count = ALPHAS if is_linear(settings.solver) or not own else FEW_ALPHAS
    if not own:
        study = study.under(replace(settings, solver=selecting(settings.solver)))
    low, high = (alphas[0], alphas[-1]) if len(alphas) > 1 else (alphas[0] / 10.0, alphas[0] * 10.0)
    return course(study, np.geomspace(low, high, count))  # evenly: truncation has none between two components


@cached(16)
def _payload(subject: Subject, settings: Resolved, action: int) -> bytes:
    found, along = _swept(subject, settings), _course(subject, settings)
    study, gain = _study(subject, settings), None
    if isinstance(subject, Learner) and settings.noise_levels is not None:
        assert isinstance(study.settings, ResolvedForWorld)  # a learner has a world
        gain = reward_gain_over_seeds(subject.learned, study.settings)
    data = payload(study, action, found, along, independent=isinstance(subject, Exact), gain=gain)
    if len(data) > MOST_PAYLOAD * 1_000_000:
        raise InputError(
            f"these pictures would take {len(data) / 1e6:.0f} MB in the browser, above {MOST_PAYLOAD}: lower thetas, "
            "gammas or steps."
        )
    return data


def ranked(view: View, rule: str) -> tuple[Ranked, ...]:
    """Every solver with the alpha of a rule."""
    study = study_for(view)
    return _ranked(view.subject, replace(structure(study.settings), solver="tikhonov", alpha=1.0), rule)


@cached(16)
def _ranked(subject: Subject, settings: Resolved, rule: str) -> tuple[Ranked, ...]:
    return tuple(ranking(_study(subject, settings), rule))
