"""The slow parts of a study, as jobs: the test of its values, its certificates, and the band of its rewards."""

from __future__ import annotations

from collections.abc import Hashable

from app.session.jobs import Wish, background
from laplace_core import Study
from laplace_core.inverse import is_linear
from laplace_core.payloads.inverse import Band, seconds_to_draw
from laplace_core.payloads.inverse import band as drawn_band
from laplace_core.study.evidence import Evidence, gathered, seconds_to_gather
from laplace_core.study.pipeline import noise_of
from laplace_core.supervise.jobs import Kind, Progress

MOST_KEPT = 24
_bands: Kind[Band | None] = Kind("bands", MOST_KEPT, line=background)
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


def band(study: Study, action: int, key: Hashable, *, independent: bool) -> Wish[Band | None] | None:
    """The band of the expected reward at the alpha of a study; None where the browser has it, or noise is unknown."""
    if noise_of(study.settings, study.gamma_space.gammas) is None or is_linear(study.settings.solver):
        return None
    return Wish(
        _bands, (key, study.settings.solver, study.settings.alpha, action),
        lambda progress: drawn_band(study, action, independent=independent, progress=progress),
        lambda: seconds_to_draw(study), "band", "lower gammas or steps",
    )  # fmt: skip
