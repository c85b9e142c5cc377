"""Artefacts of what is decoded as one process: rescaled rows, mixed policies, time beyond the last row."""

from __future__ import annotations

import numpy as np

from laplace_core.artifacts.look import Look, largest_change
from laplace_core.artifacts.model import VISIBLE, Artefact, Remedy
from laplace_core.inverse import MAX_STEPS
from laplace_core.pipeline import MAX_VALUES
from laplace_core.worlds import PRESETS


def repeated_reward(look: Look) -> Artefact | None:
    """Rows rescaled to probability 1 although the episode is over: probability invented, summed over time.

    Without a truth the decoded survival stands in for the true one.
    """
    study, s = look.study, look.settings
    if s.normalise != "paper":
        return None
    alive = (study.truth or study.decoded).survival[look.action]
    invented = np.clip(study.decoded.mass[look.action] - np.clip(alive, 0.0, s.time_step), 0.0, None)
    size = float(invented.sum())
    if size < VISIBLE:
        return None
    remedies = [Remedy("Keep survival", {"normalise": "none"})]
    preset = PRESETS.get(s.world)
    if preset and any(parameter.name == "auxiliary" for parameter in preset.parameters):
        remedies.append(Remedy("Add auxiliary states", {"param:auxiliary": True}))
    return Artefact(
        "repeated reward",
        size,
        f"{size:.2f} steps of invented probability",
        "Every row is rescaled to probability 1, also where survival is gone, so a residue of the last reward "
        "comes back as a certain one.",
        tuple(remedies),
    )


def mixed_policies(look: Look) -> Artefact | None:
    """Discounts that follow other policies than the acting one: the most probability that this moves in a row."""
    if look.study.world is None or look.settings.policy != "per_gamma":
        return None
    change = look.exact("per_gamma") - look.exact("shared")
    size = largest_change(look.decode(change))
    if size < VISIBLE:
        return None
    others = int(np.sum(np.abs(change).sum(axis=-1) * (1.0 - look.gammas) > 1e-9))
    return Artefact(
        "mixed policies",
        size,
        f"{others} of {len(look.gammas)} discounts differ, which moves {size:.2f} of a row's probability",
        "Each discount follows its own greedy policy, so the values over gamma are no transform of any single "
        "process and the rows show rewards that never occur together.",
        (Remedy("Share one policy", {"policy": "shared"}),),
    )


def folding(look: Look) -> Artefact | None:
    """Time beyond the last row: the most probability that what comes after it leaves in a row."""
    s = look.settings
    if not look.has_truth or s.steps >= MAX_STEPS:
        return None
    whole = look.exact("shared")
    size = _folded(look, whole, s.steps)
    if size < VISIBLE:
        return None
    trials = [min(MAX_STEPS, s.steps * 2**n) for n in range(1, 5)]
    trials = [steps for steps in trials if steps * look.settings.thetas * len(look.study.action_names) <= MAX_VALUES]
    steps = next((steps for steps in trials if _folded(look, whole, steps) < VISIBLE), max(trials, default=None))
    return Artefact(
        "folding",
        size,
        f"{size:.2f} of probability in a row comes from after row {s.steps - 1}",
        "Gamma-space holds rewards that come after the last row; the inverse folds them into the rows that exist.",
        (Remedy(f"Decode {steps} rows", {"steps": steps}),) if steps else (),
    )


def _folded(look: Look, whole: np.ndarray, steps: int) -> float:
    """D (Z - what the rows hold): ``whole`` is the exact Z of the true process, ``(G, V)``."""
    timeline = look.timeline(steps)
    held = (look.gammas[:, None] ** np.arange(len(timeline)) @ timeline) @ (look.masses @ look.nearest)
    return largest_change(look.decode(whole - held, steps=steps))
