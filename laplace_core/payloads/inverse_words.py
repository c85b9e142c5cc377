"""The words of rules and solvers on the page Inverse, and the sentence that judges an alpha."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from laplace_core import Study
from laplace_core.inverse import AUTO, SELECTORS, SOLVERS
from laplace_core.inverse.components import sweep_of
from laplace_core.inverse.consistency import LEVEL
from laplace_core.inverse.selectors import TYPED
from laplace_core.inverse.titles import RULE_TITLES, SOLVER_TITLES
from laplace_core.payloads.inverse import Swept
from laplace_core.study.course import Course, errors_of, turns
from laplace_core.study.evidence import Evidence, tested
from laplace_core.study.pipeline import problem_for


@dataclass(frozen=True)
class Said:
    """The sentence about a state; ``tone`` is ok, warn, bad or unknown."""

    tone: str
    sentence: str


@dataclass(frozen=True)
class Rule:
    """A rule for alpha: its title, what it makes small in a sentence, and the formula."""

    title: str
    why: str
    formula: str


_WHY: Mapping[str, tuple[str, str]] = {
    "gcv": ("Generalised cross-validation: how well values that are left out would be predicted.",
                "|r|²/n ÷ ((G − d)/G)²"),
    "rgcv": ("GCV with an extra penalty for fitted noise.", "GCV · (.9 + .1 tr(A²)/G)"),
    "loo": ("The error at each discount when the other discounts predict it.",
                "mean of (r_g / (1 − A_gg))²"),
    "aic": ("Misfit against degrees of freedom, corrected for small samples.",
                "n log(|r|²/n) + 2kn/(n − k − 1)"),
    "bic": ("As AIC, with a larger penalty for each degree of freedom.",
                "n log(|r|²/n) + log(n) kn/(n − k − 2)"),
    "lcurve": ("The sharpest bend of the L-curve.", "minus its curvature, in logarithms"),
    "corner": ("The point nearest to the lower left corner of the L-curve.",
                   "distance, each axis scaled to its span"),
    "discrepancy": ("The largest alpha whose misfit is no larger than the noise explains.",
                        "|r|² / expected |noise|² ≤ 1"),
    "ncp": ("How far the residual is from white noise along the discounts.",
                "distance of its cumulative periodogram from a line"),
    "quasiopt": ("The alpha around which the timeline changes least.",
                     "|x(α_i+1) − x(α_i)|"),
    "fitted": ("The answer of a small network that was fitted to random worlds. It is the default.",
                   "|log α − log α_fitted|"),
}  # fmt: skip
"""By the names of ``SELECTORS``: what the rule makes small, and its formula."""
RULES = {name: Rule(RULE_TITLES[name], *words) for name, words in _WHY.items()}
assert RULES.keys() == SELECTORS.keys()
MOST_TURNS = 4
FAR = 1.5
"""Times the error of the best alpha from which on an alpha is called far off."""


NO_NOISE = "Give a noise level to test whether any timeline has these values."
TESTING = "Whether any timeline has these values is being tested."
OFFERED = "The test of whether any timeline has these values takes longer: its button is below."


def said(study: Study, found: Swept, course: Course, evidence: Evidence | None, *, lacking: str = NO_NOISE) -> Said:
    """The judgement of a study's alpha.

    Args:
        course: of the solver, or of the linear one that alpha is chosen by.
        evidence: what needs the size of the noise; None where that is not known, or not computed yet.
        lacking: what is said in its place.
    """
    s, record = study.settings, study.alpha_record
    parts, tone = [_choice(study, found)], "unknown"
    edge = record.edge if record.rule != TYPED else "none"
    if edge != "none":
        end = "smallest" if edge == "lower" else "largest"
        parts.append(f"It is the {end} alpha of the sweep that the rule may choose: the optimum may lie beyond it.")
        tone = "warn"
    if course.best is not None and course.time_error is not None:
        here = int(np.argmin(np.abs(np.log(course.alphas / s.alpha))))
        least, error = float(course.time_error[course.best]), float(course.time_error[here])
        best, off = float(course.alphas[course.best]), s.alpha / float(course.alphas[course.best])
        if course.solver != s.solver:  # it takes too long at many alphas
            other, own = SOLVER_TITLES[course.solver], errors_of(study).distance
            parts.append(
                f"The timeline is off by {own:.3g} steps; that of {other} by {error:.3g}, "
                f"at its best alpha, {best:.3g}, by {least:.3g}."
            )
        elif error <= 1.02 * least:
            parts.append(f"That is the best alpha: the timeline is off by {error:.3g} steps.")
        else:
            times = f"{off:.3g} times" if off >= 1.0 else f"1/{1.0 / off:.3g} of"
            parts.append(
                f"It is {times} the best alpha, {best:.3g}: the timeline is off by {error:.3g} steps, "
                f"at the best by {least:.3g}."
            )
        if tone == "unknown" and course.solver == s.solver:
            tone = "ok" if error <= FAR * least else "warn"
    at_alpha = sweep_of(problem_for(study.gamma_space, s), s.solver, alphas=np.array([s.alpha]))  # may lie beyond it
    degrees = float(at_alpha.degrees[0])
    parts.append(f"{degrees:.3g} of {found.sweep.discounts} degrees of freedom are fitted.")
    if len(study.action_names) > 1:
        parts.append(chosen_over(study, study.decoded.actions))
    if evidence is not None:
        tone = tone if evidence.p_value > LEVEL else "bad"
        parts.append(tested(evidence.p_value))
    else:
        parts.append(lacking)
    return Said(tone, " ".join(parts))


def _choice(study: Study, found: Swept) -> str:
    record, alpha = study.alpha_record, study.settings.alpha
    if record.rule != TYPED:
        name = RULE_TITLES[record.rule]
        by = f", by the {RULE_TITLES[AUTO].lower()}," if record.rule == "auto" else ""
        return f"{name}{by} takes alpha {alpha:.3g}."
    if not SOLVERS[study.settings.solver].has_alpha:
        return "This solver has no alpha."
    by_hand = f"Alpha {alpha:.4g} was set by hand"
    if AUTO not in found.chosen:  # the rule is not fitted to this solver
        return f"{by_hand}."
    return f"{by_hand}; automatic takes {float(found.sweep.alphas[found.chosen[AUTO]]):.3g}."


def chosen_over(study: Study, actions: np.ndarray) -> str:
    """The chosen action and the first deadline of each run of equal choices ``(K,)``."""
    stretches = turns(actions)
    names = [study.action_names[action] for _, action in stretches]
    if len(names) == 1:
        return f"{names[0]} is chosen at every T."
    if len(names) > MOST_TURNS:
        return f"The choice turns {len(names) - 1} times over T."
    later = ", ".join(
        f"{name} from {study.horizons[k]:.4g}" for name, (k, _) in zip(names[1:], stretches[1:], strict=True)
    )
    return f"Chosen over T: {names[0]}, {later}."
