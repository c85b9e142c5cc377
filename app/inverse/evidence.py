"""The test of the values and the certificates of a study, as a job, because they take seconds."""

from __future__ import annotations

from collections.abc import Hashable

from app.session.jobs import Wish, background
from laplace_core import Study
from laplace_core.study.evidence import Evidence, gathered, seconds_to_gather
from laplace_core.study.pipeline import noise_of
from laplace_core.supervise.jobs import Kind, Progress

MOST_KEPT = 24
_found: Kind[Evidence] = Kind("tests of values", MOST_KEPT, line=background)


def wish(study: Study, key: Hashable, *, independent: bool) -> Wish[Evidence] | None:
    """The evidence of a study; None where the size of its noise is not known.

    Args:
        independent: whether the errors of different sensitivities are.
    """
    deviations = noise_of(study.settings, study.gamma_space.gammas)
    if deviations is None:
        return None

    def make(progress: Progress) -> Evidence:
        return gathered(study, deviations, independent=independent, progress=progress)

    return Wish(
        _found, key, make, lambda: seconds_to_gather(study), slot="evidence", lower="lower gammas or steps"
    )  # fmt: skip
