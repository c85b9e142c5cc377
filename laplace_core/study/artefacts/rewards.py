"""Artefacts of the reward axis: its edges, and a slope that is too gentle or too steep for its spacing."""

from __future__ import annotations

import numpy as np

from laplace_core.code.encoding import sigmoid
from laplace_core.study.artefacts.look import Look, Measure
from laplace_core.study.artefacts.model import VISIBLE, Artefact, Remedy
from laplace_core.study.artefacts.noise import propagated, violations
from laplace_core.study.pipeline import WorldStudy
from laplace_core.study.trials import STEEP, TAIL, softened_slope, steepened_slope, widened

SEEN = 0.02
"""A reward that never gets this much of a row is not missed where it runs into another."""

NEGLIGIBLE = 1.05 * float(sigmoid(-TAIL))
"""A reward that has less than this outside the sensitivities lies inside them: .00035, and hardly more than widening
leaves."""


def edge_clipping(look: Look) -> Artefact | None:
    """Rewards outside the sensitivities, or on their edge: largest probability lost in a row."""
    study, s, least = look.study, look.settings, VISIBLE
    if look.has_truth:
        outside = 1.0 - look.at_midpoints[0]
        outside[outside < NEGLIGIBLE] = 0.0  # the tail of any activation, which a small alpha would magnify
        lost = look.decode((look.basis() @ outside)[:, None])[:, 0]
    elif s.normalise == "none":
        lost = (look.drawn.survival - look.drawn.tau_space.sum(axis=-1)) / s.time_step
        # Two decoded rows differ by their own noise: that of the constant channel and of both end tails.
        noise = np.sqrt(1.5 * (violations(look) ** 2).mean(axis=-1, keepdims=True))
        least = max(2.0 * VISIBLE, 4.0 * float(propagated(look, noise).max()))
    else:
        return None
    size = min(1.0, float(lost.max()))  # the inverse may overshoot, but no more than all of a row can be missing
    if size < least:
        return None
    remedies: tuple[Remedy, ...] = ()
    if isinstance(study, WorldStudy) and study.settings.clip:
        remedies = (Remedy("Begin the sensitivities below the rewards", {"clip": False}),)
    elif isinstance(study, WorldStudy):
        changes = widened(study.settings, study.world.reward_values)
        remedies = (Remedy("Widen the sensitivities", changes),) if changes else ()
    return Artefact(
        "edge clipping",
        size,
        f"up to {size:.2f} of a row's probability is missing",
        "A reward at the edge of the sensitivities, or beyond it, leaves part or all of its probability outside the "
        "picture.",
        remedies,
    )


def slope_blur(look: Look) -> Artefact | None:
    """Neighbouring rewards that run together: largest probability in a row that lands nearer to another reward.

    The activation smears a reward by a logistic law, which passes the middle of a gap with sigmoid(-slope gap / 2).
    """
    if not look.has_truth:
        return None
    s, timeline = look.of_world.settings, look.timeline()
    seen = timeline.max(axis=0) >= SEEN
    rewards = look.of_world.world.reward_values[seen]
    if rewards.size < 2:
        return None
    gaps = np.diff(rewards)
    beyond = sigmoid(-s.slope * gaps / 2.0)
    size = float((timeline[:, seen] @ (np.append(beyond, 0.0) + np.append(0.0, beyond))).max())
    if size < VISIBLE:
        return None
    gap = float(gaps.min())
    return Artefact(
        "slope blur",
        size,
        f"{size:.2f} of a row's probability lands nearer to another reward; a reward is {4.4 / s.slope:.2g} wide where "
        f"the next lies {gap:.2g} away",
        "The activation is too gentle: neighbouring rewards run together.",
        (Remedy("Steepen the slope", steepened_slope(s, gap)),),
    )


def reward_quantisation(look: Look) -> Artefact | None:
    """Midpoints that miss the rewards: largest error of a row's mean, in units of the spacing, never cancelling.

    Only a slope steeper than the default for the spacing rounds; a reward that is cut off at the edges is not judged.
    """
    if not look.has_truth:
        return None
    thetas, slope = look.study.gamma_space.thetas, look.of_world.settings.slope
    rewards, chance = look.of_world.world.reward_values, look.timeline()
    spacing = np.diff(thetas)[np.clip(np.searchsorted(thetas, rewards) - 1, 0, thetas.size - 2)]
    inside = (rewards > thetas[0] + 6.0 / slope) & (rewards < thetas[-1] - 6.0 / slope)
    inside &= (slope * spacing > STEEP) & (chance.max(axis=0) > 1e-6)
    if not inside.any():
        return None
    held, proxy = (each[inside] for each in look.at_midpoints)
    rewards, spacing, proxy = rewards[inside], spacing[inside], proxy / held
    off = np.abs(proxy - rewards) / spacing
    size = float((chance[:, inside] @ off).max())
    if size < VISIBLE:
        return None
    worst = int(np.argmax(off * chance[:, inside].max(axis=0)))
    return Artefact(
        "reward quantisation",
        size,
        f"reward {rewards[worst]:g} counts as {proxy[worst]:.4g}, off by {off[worst]:.2f} of the spacing",
        "The slope is so steep for the spacing of the sensitivities that rewards are rounded towards the midpoints.",
        (Remedy("Soften the slope", softened_slope(thetas)),),
    )


MEASURES: dict[str, Measure] = {
    "edge clipping": edge_clipping,
    "slope blur": slope_blur,
    "reward quantisation": reward_quantisation,
}
"""The artefacts of this module by name, the gravest kinds first."""
