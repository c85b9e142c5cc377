"""Artefacts of a tau-space: their names, measures and explanations.

An artefact is measured for one action, from what was decoded and how, and carries the change of settings that
removes it. Each size has the unit that its name suggests and is listed from one level on, :data:`VISIBLE`.
"""

from __future__ import annotations

from laplace_core.inverse import LINEAR, is_linear
from laplace_core.study.artefacts import deadline, inverse, noise, process, rewards, rows
from laplace_core.study.artefacts.look import Look, Measure
from laplace_core.study.artefacts.model import VISIBLE, Artefact, Remedy
from laplace_core.study.artefacts.offers import offered
from laplace_core.study.pipeline import Study, WorldStudy
from laplace_core.study.trials import Trials

MEASURES: dict[str, Measure] = {
    **process.MEASURES,
    **noise.MEASURES,
    **rows.MEASURES,
    **rewards.MEASURES,
    **inverse.MEASURES,
    **deadline.MEASURES,
}
"""The measure of every artefact that studies are searched for, the gravest kinds first; each module lists its own."""
LISTED: dict[str, Measure] = {
    "shifted index": inverse.shifted_index,
    **MEASURES,
    "survival above 1": inverse.survival_above_one,
}
"""These, an error of the decoder that is there only if it was switched on, and what is read off the picture itself."""


def find_artefacts(
    study: Study, action: int, horizon: float | None = None, *, searching: bool = True, trials: Trials | None = None
) -> list[Artefact]:  # fmt: skip
    """Every artefact present in the tau-space of one action, the gravest kinds first.

    A gamma-space without a world has no truth to measure against; only artefacts that show in the data are listed.

    Args:
        horizon: the T of the view, at which remedies are tried and a constant horizon is judged; default: the longest,
            and for a constant horizon the one at which it costs most.
        searching: whether to search for remedies, which takes most of the time; without, those that are listed were
            not tried, and sentences are as if there were none.
        trials: of this very view and action, where they are there already.

    Raises:
        InputError: an action that the study does not have.
    """
    study.check_view(action=action)
    look = Look(study, action, horizon, searching=searching)
    if not is_linear(study.settings.solver):
        above = inverse.survival_above_one(look)
        return [*([] if above is None else [above]), _not_taken_apart(study.settings.solver)]
    artefacts = [artefact for measure in LISTED.values() if (artefact := measure(look)) is not None]
    if not searching:
        return artefacts
    if trials is None and isinstance(study, WorldStudy):
        trials = Trials(study, len(study.horizons) - 1 if horizon is None else study.row_at(horizon), action)
    return offered(artefacts, look, LISTED, trials)


def _not_taken_apart(solver: str) -> Artefact:
    """The entry in place of the artefacts, for a picture that is not a sum of parts."""
    sentence = (
        "Only the picture of a linear solver is a sum of parts, one for each artefact: choose one of "
        f"{', '.join(LINEAR)} to see them."
    )
    return Artefact("not taken apart", VISIBLE, f"the solver {solver} is not linear", sentence, ())


__all__ = ["LISTED", "MEASURES", "VISIBLE", "Artefact", "Remedy", "find_artefacts"]
