"""Artefacts of reading for a deadline: a soft one, and one that never comes nearer."""

from __future__ import annotations

import numpy as np

from laplace_core.errors import InputError
from laplace_core.study.artefacts.look import Look, Measure
from laplace_core.study.artefacts.model import VISIBLE, Artefact, Remedy
from laplace_core.study.episodes import constant_horizon_loss
from laplace_core.study.pipeline import WorldStudy
from laplace_core.study.trials import WHY


def soft_deadline(look: Look) -> Artefact | None:
    """A deadline so soft that it reads another horizon: largest change of the true values, relative."""
    s = look.settings
    if not look.has_truth or s.softness == 0:
        return None
    hard, soft = look.true_values(0.0), look.true_values(s.softness)
    size = float(np.abs(soft - hard).max() / max(np.abs(hard).max(), 1e-12))
    if size < VISIBLE:
        return None
    return Artefact(
        "soft deadline",
        size,
        f"a true value moves by up to {100 * size:.0f}% of the largest one",
        WHY["soft deadline"],
        (Remedy("Set softness to 0", {"softness": 0.0}),),
    )


def constant_horizon(look: Look) -> Artefact | None:
    """Acting with the same T at every step: what a whole episode loses, as a share of the best one's value.

    Against acting by the time to go on the same decoded values (free of noise), at the horizon of the look or at
    the worst one. A world too large for whole episodes is left out, and so is a timeline too short for a whole step.
    """
    study, s = look.study, look.settings
    if not isinstance(study, WorldStudy) or s.deadline != "constant" or study.world.n_actions == 1:
        return None
    try:
        loss, best = constant_horizon_loss(study.world, study.settings)
    except InputError:
        return None
    if not len(loss):
        return None
    loss, best = loss[:, study.state], best[:, study.state]
    T = int(np.argmax(loss)) + 1
    if look.horizon is not None:
        T = int(np.clip(round(look.horizon), 1, len(loss)))
    size = float(loss[T - 1] / max(np.abs(best).max(), 1e-12))
    if size < VISIBLE:
        return None
    return Artefact(
        "constant horizon",
        size,
        f"an episode of {T} steps loses {loss[T - 1]:.2f}, {100 * size:.0f}% of the largest value of a best episode",
        "At every step the agent acts as if all of T were still left, and may aim at rewards that come after the end.",
        (Remedy("Act by the time to go", {"deadline": "time_to_go"}),),
    )


MEASURES: dict[str, Measure] = {
    "soft deadline": soft_deadline,
    "constant horizon": constant_horizon,
}
"""The artefacts of this module by name, the gravest kinds first."""
