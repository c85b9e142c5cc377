"""Artefacts of the regularised linear inverse itself: too much alpha smears, and a linear inverse rings."""

from __future__ import annotations

import numpy as np

from laplace_core.study.artefacts.look import Look, Measure, largest_change, of_a_row
from laplace_core.study.artefacts.model import VISIBLE, Artefact, Remedy
from laplace_core.study.pipeline import decoder
from laplace_core.study.trials import ALPHAS, WHY

LEAST_ALPHA = ALPHAS[0]
NONNEGATIVE = Remedy("Use the non-negative solver", {"solver": "nonnegative"}, "negative mass")
FEASIBLE = Remedy("Use the feasible timeline", {"solver": "feasible"}, "survival above 1")
"""Solvers to which the artefact cannot happen, whatever the values are: the first has no negative mass, the second no
survival above 1 or that rises."""


def over_smoothing(look: Look) -> Artefact | None:
    """The decrease of the timeline's error under a smaller alpha, with the same gamma-space."""
    alpha = look.settings.alpha
    if not look.has_truth or alpha == 0:
        return None
    here = look.error()
    if here < VISIBLE:
        return None
    # The error may dip within a decade of alpha, where smearing and folding cancel; far below it hardly changes.
    decades = np.concatenate([np.arange(0.1, 2.0, 0.1), np.arange(2.0, 9.0, 0.5)])
    smaller = np.append(alpha / 10.0**decades, LEAST_ALPHA)
    tried = {a: look.error(a) for a in smaller if LEAST_ALPHA <= a < alpha}
    size = here - min(tried.values(), default=here)
    if size < VISIBLE:
        return None
    # The largest alpha that leaves little to gain: the smaller alpha is, the louder any noise.
    enough = here - size + min(0.1 * size, 0.5 * VISIBLE)
    best = float(f"{max(a for a, left in tried.items() if left <= enough):.2g}")
    return Artefact(
        "over-smoothing",
        size,
        f"the timeline is off by {100 * here:.0f}%, with a smaller alpha by {100 * (here - size):.0f}%",
        f"Alpha {alpha:g} suppresses components that gamma-space still holds, so rewards spread over neighbouring "
        "steps.",
        (Remedy(f"Lower alpha to {best:g}", {"alpha": best}),),
    )


def shifted_index(look: Look) -> Artefact | None:
    """Discounts that are decoded by the row of their neighbour: the most probability that this moves in a row."""
    s = look.settings
    if not s.shift:
        return None
    right = decoder(look.gammas, s, look.steps) @ look.differences / s.time_step
    size = largest_change(look.decode(look.differences) - right)
    if size < VISIBLE:
        return None
    return Artefact(
        "shifted index",
        size,
        f"the index shift moves up to {of_a_row(size)}",
        WHY["shifted index"],
        (Remedy("Undo the index shift", {"shift": False}),),
    )


def survival_above_one(look: Look) -> Artefact | None:
    """The amount by which the decoded survival exceeds 1."""
    size = float(look.drawn.survival.max(initial=0.0)) / look.settings.time_step - 1.0
    if size < VISIBLE:
        return None
    return Artefact(
        "survival above 1",
        size,
        f"the decoded survival reaches {1.0 + size:.2f}",
        "A survival cannot exceed 1, and an episode that has ended cannot continue. Only the feasible solver uses "
        "this.",
        (FEASIBLE,),
    )


def negative_mass(look: Look) -> Artefact | None:
    """Ringing of the linear inverse: the most that entries below zero, by reward, take away from a row."""
    s = look.settings
    if s.normalise == "paper":
        return None
    size = _negative(look.rows(s.alpha))
    if size < VISIBLE:
        return None
    known = {float(f"{alpha:.1g}") for alpha in np.geomspace(1e-8, 10, 28)} if look.searching else set()
    trials = sorted(known, key=lambda a: abs(np.log(a / max(s.alpha, 1e-9))))
    # Ringing and smearing trade off: no remedy may make the timeline worse.
    allowed = look.error() + 1e-3 if look.has_truth else np.inf
    calm = (a for a in trials if _negative(look.rows(a)) < VISIBLE)
    nearest = [a for a in [next((a for a in calm if not look.has_truth or look.error(a) <= allowed), None)] if a]
    return Artefact(
        "negative mass",
        size,
        f"entries below zero take away up to {of_a_row(size)}",
        "A linear inverse can go below zero, which no probability does: it rings beside sharp events and magnifies "
        "the errors of gamma-space."
        + ("" if nearest else " With these discounts less ringing would mean more smearing."),
        (*(Remedy(f"Set alpha to {a:g}", {"alpha": a}) for a in nearest), NONNEGATIVE),
    )


def _negative(rows: np.ndarray) -> float:
    return float(-np.minimum(rows, 0.0).sum(axis=-1).min())


MEASURES: dict[str, Measure] = {
    "over-smoothing": over_smoothing,
    "negative mass": negative_mass,
}
"""The artefacts of this module by name, the gravest kinds first."""
