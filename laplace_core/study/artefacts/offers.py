"""The remedies of an artefact that are offered: those that were tried on this view and remove it.

Another solver is always offered (:mod:`laplace_core.study.artefacts.inverse`). Any other remedy is offered if under it
the artefact is gone and what is wrong with the view is repaired
(:class:`laplace_core.study.trials.Trials`): the choice, else the values, else the timeline. Where nothing is wrong with
it, nothing may become so. One view suggests one alpha at most, that of the verdict; without a truth, one at which
nothing suggests another.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from laplace_core.errors import InputError
from laplace_core.study.artefacts.look import Look, Measure
from laplace_core.study.artefacts.model import Artefact
from laplace_core.study.grades import timeline_error
from laplace_core.study.pipeline import Study
from laplace_core.study.trials import Remedy, Trials

_NO_WORSE = 1e-3
"""How much more of a timeline's probability may be misplaced under a remedy of something else."""


def offered(
    artefacts: Sequence[Artefact], look: Look, measures: Mapping[str, Measure], trials: Trials | None
) -> list[Artefact]:
    """The same artefacts with those of their remedies that are offered.

    Args:
        trials: of the view; None where there is no truth to grade it against.
    """
    with_others = [
        replace(each, remedies=tuple(r for r in each.remedies if _is_offered(each, r, look, measures, trials=trials)))
        for each in artefacts
    ]
    alpha = _alpha(artefacts, look, measures, trials)
    if alpha is None:
        return with_others
    return [
        _with_alpha(offer, alpha, look, measures) if any("alpha" in r.changes for r in each.remedies) else offer
        for each, offer in zip(artefacts, with_others, strict=True)
    ]


def _is_offered(
    artefact: Artefact, remedy: Remedy, look: Look, measures: Mapping[str, Measure], *, trials: Trials | None
) -> bool:
    if "solver" in remedy.changes:
        return True  # its constraint is what takes the artefact away, and what else it does is to be seen
    if "alpha" in remedy.changes:
        return False  # one for all, in the end
    if trials is None:
        return _gone(artefact, _under(look.study, remedy), look, measures)
    trial = trials.run(remedy)
    if trial is None or not _gone(artefact, trial.study, look, measures):
        return False
    if trials.grade.wrong or trials.grade.off or trials.smeared:
        # What acts wrongly later in an episode is no fault of this choice: it may be mended by itself.
        return set(remedy.changes) == {"deadline"} or trials.repairs(remedy, trial)
    good = not trial.grade.wrong and not trial.grade.off
    after = timeline_error(trial.study, look.action, trial.study.at(trial.row))
    return good and after <= trials.timeline_error + _NO_WORSE


def _alpha(
    artefacts: Sequence[Artefact], look: Look, measures: Mapping[str, Measure], trials: Trials | None
) -> float | None:
    """The one alpha that is suggested for a view; None where none is."""
    changes: list[Mapping[str, Any]] = [r.changes for each in artefacts for r in each.remedies if "alpha" in r.changes]
    wished = list(dict.fromkeys(each["alpha"] for each in changes))
    if not wished:
        return None
    if trials is not None:
        return trials.alpha if trials.affordable else None
    for alpha in wished:
        under = _under(look.study, Remedy("", {"alpha": alpha}))
        if under is None:
            continue
        here = Look(under, look.action, look.horizon)
        left = [artefact for measure in measures.values() if (artefact := measure(here)) is not None]
        if not any("alpha" in remedy.changes for each in left for remedy in each.remedies):
            return alpha  # nothing at it suggests another one
    return None


def _with_alpha(artefact: Artefact, alpha: float, look: Look, measures: Mapping[str, Measure]) -> Artefact:
    """The artefact with the one alpha that is suggested, where that takes it away."""
    verb = "Lower" if alpha < look.settings.alpha else "Raise"
    remedy = Remedy(f"{verb} alpha to {alpha:g}", {"alpha": alpha}, artefact.name)
    if alpha == look.settings.alpha or not _gone(artefact, _under(look.study, remedy), look, measures):
        return artefact
    return replace(artefact, remedies=(remedy, *artefact.remedies))


def _gone(artefact: Artefact, under: Study | None, look: Look, measures: Mapping[str, Measure]) -> bool:
    return (
        under is not None and measures[artefact.name](Look(under, look.action, look.horizon, searching=False)) is None
    )


def _under(study: Study, remedy: Remedy) -> Study | None:
    """The same gamma-space decoded otherwise; None where the settings do not allow that."""
    try:
        settings = remedy.apply(study.settings)
        return study.under(settings)
    except InputError:
        return None
