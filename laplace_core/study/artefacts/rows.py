"""Artefacts of how many rows there are: time beyond the last one."""

from __future__ import annotations

import numpy as np

from laplace_core.inverse import MAX_STEPS
from laplace_core.study.artefacts.look import Look, Measure, largest_change, of_a_row
from laplace_core.study.artefacts.model import VISIBLE, Artefact, Remedy
from laplace_core.study.size import largest_study
from laplace_core.study.trials import WHY, more_rows


def folding(look: Look) -> Artefact | None:
    """Time beyond the last row: the most probability that what comes after it leaves in a row."""
    s = look.settings
    if not look.has_truth or look.steps >= MAX_STEPS:
        return None
    whole = look.exact("shared")
    size = _folded(look, whole, look.steps)
    if size < VISIBLE:
        return None
    most = largest_study() / (len(look.study.gamma_space.thetas) * len(look.study.action_names))
    trials = [] if s.fold else [steps for steps in more_rows(s.steps) if steps <= most]
    steps = next((steps for steps in trials if _folded(look, whole, steps) < VISIBLE), max(trials, default=None))
    remedies = [Remedy("Decode all rows", {"fold": False})] if s.fold else []
    return Artefact(
        "folding",
        size,
        f"rewards after the last row move up to {of_a_row(size)}",
        WHY["folding"],
        (*remedies, *([Remedy(f"Decode {steps} rows", {"steps": steps})] if steps else [])),
    )


def _folded(look: Look, whole: np.ndarray, steps: int) -> float:
    """D (Z - what the rows hold): ``whole`` is the exact Z of the true process, ``(G, V)``."""
    timeline = look.timeline(steps)
    held = look.by_reward(look.smeared(look.gammas[:, None] ** np.arange(len(timeline)) @ timeline))
    return largest_change(look.decode(whole - held, steps=steps))


MEASURES: dict[str, Measure] = {
    "folding": folding,
}
"""The artefacts of this module by name, the gravest kinds first."""
