"""Names, measures and explains what in a tau-space is not real.

An artefact is measured for one action, from what was decoded and how, and carries the change of settings that
removes it. Each size has the unit that its name suggests and a threshold below which it is not worth a word.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from laplace_core.encoding import bin_masses
from laplace_core.horizon import horizon_values
from laplace_core.inverse import MAX_STEPS, decode
from laplace_core.pipeline import Study, basis_of, encoded_under
from laplace_core.settings import SLOPE_TIMES_SPACING, Settings
from laplace_core.worlds import PRESETS


@dataclass(frozen=True)
class Remedy:
    """A change of settings, by field; ``param:NAME`` is a parameter of the world."""

    label: str
    changes: Mapping[str, object]

    @property
    def changes_world(self) -> bool:
        return any(name.startswith("param:") for name in self.changes)

    def apply(self, settings: Settings) -> Settings:
        fields = {name: value for name, value in self.changes.items() if not name.startswith("param:")}
        params = dict(settings.params)
        params |= {name.removeprefix("param:"): v for name, v in self.changes.items() if name.startswith("param:")}
        return replace(settings, params=tuple(params.items()), **fields)


@dataclass(frozen=True)
class Artefact:
    """One thing in the picture that is not in the world.

    Attributes:
        size: the measure, in the unit that ``shown`` names.
        shown: the measure in words, with its unit.
        sentence: what it does to the picture and why.
        remedies: changes that remove it, the first one the usual choice.
    """

    name: str
    size: float
    shown: str
    sentence: str
    remedies: tuple[Remedy, ...]


def find_artefacts(study: Study, action: int) -> list[Artefact]:
    """Every artefact present in the tau-space of one action, the gravest kinds first.

    A gamma-space without a world has no truth to measure against; only what shows in the data is found.
    """
    found = (measure(study, action) for measure in _MEASURES)
    return [artefact for artefact in found if artefact is not None]


def repeated_reward(study: Study, action: int, least: float = 0.05) -> Artefact | None:
    """Rows rescaled to probability 1 although the episode is over: probability invented, summed over time."""
    if study.settings.normalise != "paper":
        return None
    alive = np.clip(study.decoded.survival[action] / study.settings.time_step, 0.0, 1.0)
    size = float(np.sum(1.0 - alive)) * study.settings.time_step
    if size < least:
        return None
    remedies = [Remedy("Keep survival", {"normalise": "none"})]
    preset = PRESETS.get(study.settings.world)
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


def mixed_policies(study: Study, action: int, least: float = 0.01) -> Artefact | None:
    """Discounts that follow other policies than the acting one: largest change of (1 - gamma) Q."""
    if study.world is None or study.settings.policy != "per_gamma":
        return None
    shared, mixed = encoded_under(study, "shared"), encoded_under(study, "per_gamma")
    change = np.abs(mixed.values - shared.values)[action] * (1.0 - shared.gammas[:, None])
    size = float(change.max())
    if size < least:
        return None
    others = int(np.sum(change.max(axis=1) >= least))
    return Artefact(
        "mixed policies",
        size,
        f"{others} of {len(shared.gammas)} discounts differ, by up to {size:.2f} in probability",
        "Each discount follows its own greedy policy, so the values over gamma are no transform of any single "
        "process and the rows show rewards that never occur together.",
        (Remedy("Share one policy", {"policy": "shared"}),),
    )


def folding(study: Study, action: int, least: float = 0.05) -> Artefact | None:
    """Time beyond the last row: the share of the largest discount's steps that tau-space cannot hold."""
    if study.truth is None:
        return None
    s, gammas = study.settings, study.gamma_space.gammas
    whole = study.gamma_space.constant[action, -1]
    if s.policy == "per_gamma":
        whole = encoded_under(study, "shared").constant[action, -1]
    held = study.truth.survival[action] @ gammas[-1] ** np.floor(study.taus + 1e-9)
    size = float(1.0 - held / whole)
    if size < least or s.steps >= MAX_STEPS:
        return None
    # Survival left after the last row fades at least as fast as the discount: gamma^steps < least / 2.
    needed = np.ceil(np.log(least / 2.0) / np.log(gammas[-1]) / s.time_step)
    steps = int(min(MAX_STEPS, max(2 * s.steps, min(needed, 4 * s.steps))))
    return Artefact(
        "folding",
        size,
        f"{100 * size:.0f}% of the discounted time lies beyond row {s.steps - 1}",
        "Gamma-space holds rewards that come after the last row; the inverse folds them into the rows that exist.",
        (Remedy(f"Decode {steps} rows", {"steps": steps}),),
    )


def edge_clipping(study: Study, action: int, least: float = 0.02) -> Artefact | None:
    """Rewards outside the sensitivities, or on their edge: largest probability lost in a row."""
    s = study.settings
    if study.truth is None:
        lost = (study.decoded.survival - study.decoded.mass)[action] if s.normalise == "none" else np.zeros(1)
        least = max(least, 0.1)  # two decoded rows differ by their own noise
    else:
        lost = (study.truth.survival - study.truth.tau_space.sum(axis=-1))[action]
    size = float(lost.max()) / s.time_step
    if size < least:
        return None
    remedies = ()
    if study.world is not None:
        rewards = study.world.reward_values
        over = max(0.2 * (rewards[-1] - rewards[0]), 6.0 / s.slope)
        low, high = min(s.theta_min, float(rewards[0] - over)), max(s.theta_max, float(rewards[-1] + over))
        remedies = (Remedy("Widen the sensitivities", _theta_range(s, low, high)),)
    return Artefact(
        "edge clipping",
        size,
        f"up to {size:.2f} of a row's probability is missing",
        "A reward at the edge of the sensitivities, or beyond it, leaves part of its probability outside the picture.",
        remedies,
    )


def _theta_range(s: Settings, low: float, high: float) -> dict[str, object]:
    """A wider range at the same spacing, as far as the number of sensitivities allows."""
    thetas = min(2000, int(np.ceil((s.thetas - 1) * (high - low) / (s.theta_max - s.theta_min))) + 1)
    return {"theta_min": float(f"{low:.6g}"), "theta_max": float(f"{high:.6g}"), "thetas": max(s.thetas, thetas)}


def _possible_rewards(study: Study, action: int) -> np.ndarray:
    """Rewards that ever come after an action under the target policies."""
    return study.world.reward_values[basis_of(study)[action].max(axis=0) > 1e-6]


def slope_blur(study: Study, action: int, least: float = 1.0) -> Artefact | None:
    """Neighbouring rewards that run together: 10-90% width of the activation over their distance."""
    if study.world is None:
        return None
    rewards = _possible_rewards(study, action)
    if rewards.size < 2:
        return None
    gap = float(np.diff(rewards).min())
    width = 4.4 / study.settings.slope
    size = width / gap
    if size < least:
        return None
    slope = float(f"{9.0 / gap:.2g}")
    s = study.settings
    thetas = int(np.ceil((s.theta_max - s.theta_min) * slope / SLOPE_TIMES_SPACING)) + 1
    return Artefact(
        "slope blur",
        size,
        f"a reward is {width:.2g} wide where the next lies {gap:.2g} away",
        "The activation is too gentle: neighbouring rewards run together in every row.",
        (Remedy("Steepen the slope", {"slope": slope, "thetas": min(2000, max(s.thetas, thetas))}),),
    )


def reward_quantisation(study: Study, action: int, least: float = 0.01) -> Artefact | None:
    """Midpoints that miss the rewards: largest error of the proxy, in units of the spacing."""
    if study.world is None:
        return None
    thetas, slope = study.gamma_space.thetas, study.settings.slope
    rewards = _possible_rewards(study, action)
    inside = rewards[(rewards > thetas[0] + 6.0 / slope) & (rewards < thetas[-1] - 6.0 / slope)]
    if not inside.size:
        return None
    proxy = bin_masses(inside, thetas, slope) @ study.midpoints
    spacing = np.diff(thetas)[np.clip(np.searchsorted(thetas, inside) - 1, 0, thetas.size - 2)]
    worst = int(np.argmax(np.abs(proxy - inside) / spacing))
    size = float(np.abs(proxy - inside)[worst] / spacing[worst])
    if size < least:
        return None
    gentle = float(f"{SLOPE_TIMES_SPACING / np.diff(thetas).max():.2g}")
    return Artefact(
        "reward quantisation",
        size,
        f"reward {inside[worst]:g} counts as {proxy[worst]:.4g}, off by {size:.2f} of the spacing",
        "The slope is so steep that no two sensitivities overlap, and every reward is rounded to a midpoint.",
        (Remedy("Soften the slope", {"slope": gentle}),),
    )


def _timeline_error(study: Study, action: int, alpha: float) -> float:
    """Total variation between the rows decoded at ``alpha``, unscaled, and the truth, as a share of the truth."""
    s, true = study.settings, study.truth.tau_space[action]
    space = encoded_under(study, "shared")
    rows = decode(space.differences[action], space.gammas, s.steps, alpha, s.time_step)
    return float(np.abs(rows - true).sum() / max(2.0 * np.abs(true).sum(), 1e-12))


def over_smoothing(study: Study, action: int, least: float = 0.05) -> Artefact | None:
    """What a smaller alpha would bring back: fall of the timeline's error against the truth."""
    alpha = study.settings.alpha
    if study.truth is None or alpha == 0:
        return None
    here = _timeline_error(study, action, alpha)
    if here < least:
        return None
    tried = {a: _timeline_error(study, action, a) for a in alpha / 10.0 ** np.arange(1, 9) if a >= 1e-9}
    size = here - min(tried.values(), default=here)
    if size < least:
        return None
    # The largest alpha that brings most of it back: the smaller alpha is, the louder any noise.
    best = float(f"{max(a for a, left in tried.items() if here - left >= 0.9 * size):.2g}")
    return Artefact(
        "over-smoothing",
        size,
        f"{100 * size:.0f}% of the timeline is smeared over time by alpha",
        f"Alpha {alpha:g} suppresses components that gamma-space still holds, so rewards spread over neighbouring "
        "steps.",
        (Remedy(f"Lower alpha to {best:g}", {"alpha": best}),),
    )


def negative_mass(study: Study, action: int, least: float = 0.02) -> Artefact | None:
    """Ringing of the linear inverse: largest negative probability in a row."""
    s = study.settings
    if s.normalise == "paper":
        return None

    def negative(tau_space: np.ndarray) -> float:
        return float(-np.minimum(tau_space, 0.0).sum(axis=-1).min() / s.time_step)

    size = negative(study.decoded.tau_space[action])
    if size < least:
        return None
    rows, gammas = study.gamma_space.differences[action], study.gamma_space.gammas
    tried = np.array([float(f"{alpha:.1g}") for alpha in np.geomspace(1e-8, 10, 28)])
    calm = [a for a in tried if negative(decode(rows, gammas, s.steps, a, s.time_step)) < least]
    if study.truth is not None:  # ringing and smearing trade off: no remedy may make the timeline worse
        here = _timeline_error(study, action, s.alpha)
        calm = [a for a in calm if _timeline_error(study, action, a) <= here + 1e-3]
    nearest = sorted(calm, key=lambda a: abs(np.log(a / max(s.alpha, 1e-9))))[:1]
    return Artefact(
        "negative mass",
        size,
        f"up to {size:.2f} of negative probability in a row",
        "A linear inverse rings around sharp events; negative probability is the trough beside a peak."
        + ("" if nearest else " With these discounts less ringing would mean more smearing."),
        tuple(Remedy(f"Set alpha to {a:g}", {"alpha": a}) for a in nearest),
    )


def soft_deadline(study: Study, action: int, least: float = 0.05) -> Artefact | None:
    """A deadline so soft that it reads another horizon: largest change of the true values, relative."""
    s, truth = study.settings, study.truth
    if truth is None or s.softness == 0:
        return None
    hard = horizon_values(truth.expected_reward[action], s.acting_gamma, 0.0, s.time_step)
    soft = horizon_values(truth.expected_reward[action], s.acting_gamma, s.softness, s.time_step)
    size = float(np.abs(soft - hard).max() / max(np.abs(hard).max(), 1e-12))
    if size < least:
        return None
    return Artefact(
        "soft deadline",
        size,
        f"a value moves by up to {100 * size:.0f}% of the largest",
        "The soft deadline counts part of what comes after T and leaves out part of what comes before.",
        (Remedy("Set softness to 0", {"softness": 0.0}),),
    )


_MEASURES: tuple[Callable[[Study, int], Artefact | None], ...] = (
    repeated_reward,
    mixed_policies,
    folding,
    edge_clipping,
    slope_blur,
    reward_quantisation,
    over_smoothing,
    negative_mass,
    soft_deadline,
)
