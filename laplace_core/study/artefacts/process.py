"""Artefacts of what is decoded as one process: rows rescaled, and mixed policies."""

from __future__ import annotations

import numpy as np

from laplace_core.inverse import SURVIVAL_FLOOR
from laplace_core.study.artefacts.look import Look, Measure, largest_change, of_a_row
from laplace_core.study.artefacts.model import VISIBLE, Artefact, Remedy
from laplace_core.study.horizon import horizon_values
from laplace_core.worlds import PRESETS


def repeated_reward(look: Look) -> Artefact | None:
    """Rows rescaled to probability 1: what this adds beyond the truth of each reward, summed over time.

    Whether the episode is over or idles on zero reward makes no difference: a step counts as far as the rescaled rows
    exceed the true chances of its rewards by more than the rows do as they were decoded. Without a truth, by which no
    reward is distinguishable from its residue, the excess over the decoded survival counts.
    """
    s = look.settings
    if s.normalise != "paper":
        return None
    drawn = look.drawn.tau_space / s.time_step
    if look.has_truth:
        rescaled, decoded = look.by_step(look.by_reward(drawn)), look.by_step(look.decode(look.differences))
        size = float(np.clip(_beyond(rescaled, look.true_steps) - _beyond(decoded, look.true_steps), 0.0, None).sum())
    else:
        alive = np.clip(look.drawn.survival / s.time_step, 0.0, 1.0)
        size = float(s.time_step * np.clip(drawn.sum(axis=-1) - alive, 0.0, None).sum())
    if size < VISIBLE:
        return None
    remedies = [Remedy("Keep survival", {"normalise": "none"})]
    preset = PRESETS.get(s.world)
    if preset and any(parameter.name == "auxiliary" for parameter in preset.parameters):
        remedies.append(Remedy("Add auxiliary states", {"param:auxiliary": True}))
    return Artefact(
        "repeated reward",
        size,
        f"rescaling invents the probability of {size:.2f} certain rewards",
        "Rows are rescaled to probability 1 even if they are nearly empty, so that a residue of an earlier reward "
        "counts as a certain reward.",
        tuple(remedies),
    )


def _beyond(rows: np.ndarray, true: np.ndarray) -> np.ndarray:
    """Probability in each row that no true reward accounts for, ``(N,)``."""
    return np.clip(rows - true, 0.0, None).sum(axis=-1)


def conditional_rewards(look: Look) -> Artefact | None:
    """Rewards given survival, summed as if sure: largest change of a value, as a share of the largest true one.

    Against the rows as they were decoded, in which survival is still a factor. A hundredth of the largest reward is the
    least value that counts as one, so that an action that is worth nothing is no measure. Without a truth the largest
    value of the rows as they were decoded stands in.
    """
    study, s = look.study, look.settings
    if s.normalise != "survival":
        return None
    Z = study.gamma_space.differences[look.action]
    weighted = s.time_step * look.decode((Z @ study.midpoints)[:, None])[:, 0]
    plain = look.drawn.expected_reward
    weighted, plain = (horizon_values(rows, s.value_gamma, s.softness, s.time_step) for rows in (weighted, plain))
    change = float(np.abs(plain - weighted).max())
    true = look.true_values(s.softness) if look.has_truth else weighted
    least = 1e-2 * np.abs(look.of_world.world.reward_values).max() if look.has_truth else 0.0
    size = float(change / max(np.abs(true).max(), least, 1e-12))
    if size < VISIBLE:
        return None
    return Artefact(
        "conditional rewards",
        size,
        f"a value moves by up to {change:.3g}, where the largest {'true ' if look.has_truth else ''}one "
        f"is {np.abs(true).max():.3g}",
        "Each row is divided by its survival, so that it holds the rewards if the episode still runs; the values add "
        f"them up as if it always ran, and leave out rows whose survival is at most {SURVIVAL_FLOOR:g}.",
        (Remedy("Weigh rewards by survival", {"normalise": "none"}),),
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
        f"{others} of {len(look.gammas)} discounts differ, which moves up to {of_a_row(size)}",
        "Each discount follows its own greedy policy, so the values over gamma are no transform of any single "
        "process and the rows are no timeline of one.",
        (Remedy("Share one policy", {"policy": "shared"}),),
    )


MEASURES: dict[str, Measure] = {
    "repeated reward": repeated_reward,
    "conditional rewards": conditional_rewards,
    "mixed policies": mixed_policies,
}
"""The artefacts of this module by name, the gravest kinds first."""
