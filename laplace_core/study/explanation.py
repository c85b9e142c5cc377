"""Everything about a view that takes a search: the cause in its verdict, and the remedies of its artefacts."""

from __future__ import annotations

from dataclasses import dataclass, replace

from laplace_core.study.artefacts import Artefact, find_artefacts
from laplace_core.study.evidence import MOST_WORK, Belief, believe, work_to_believe
from laplace_core.study.pipeline import Study, WorldStudy
from laplace_core.study.trials import Trials
from laplace_core.study.verdict import Verdict, judge


@dataclass(frozen=True)
class Explanation:
    """A verdict with its cause, and the artefacts of the action that is looked at, with remedies that were tried.

    Where the size of the noise is known, both say what it allows to believe.
    """

    verdict: Verdict
    artefacts: tuple[Artefact, ...]
    belief: Belief | None = None


def trials_of(study: Study, row: int, action: int) -> Trials | None:
    """The trials of single changes of a view; None without a world, where nothing can be tried."""
    return Trials(study, row, action) if isinstance(study, WorldStudy) else None


def explain(study: Study, row: int, action: int, trials: Trials | None = None) -> Explanation:
    """Search for the cause and the remedies of a view; a change that both try is tried once.

    Args:
        row: of the horizon, ``study.horizons[row]``.
        action: whose timeline is graded and whose artefacts are listed.
        trials: of this very view, where they are there already.

    Raises:
        InputError: a row or an action that the study does not have.
    """
    study.check_view(row, action)
    trials = trials or trials_of(study, row, action)
    verdict = judge(study, row, action, trials=trials)
    found = find_artefacts(study, action, float(study.horizons[row]), trials=trials)
    if work_to_believe(study) > MOST_WORK:
        words = "Whether any timeline has these values was not tested: the view is too large."
        return Explanation(replace(verdict, sentence=f"{verdict.sentence} {words}"), tuple(found))
    belief = believe(study, row, action)
    if belief is not None:
        verdict = replace(verdict, sentence=f"{verdict.sentence} {belief.sentence}")
        found = [*belief.artefacts, *found]
    return Explanation(verdict, tuple(found), belief)
