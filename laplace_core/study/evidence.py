"""Conclusions from the size of the noise alone, for every alpha: whether a timeline has the values, and what is
certainly best."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from laplace_core.code.ties import greedy_action
from laplace_core.inverse import Problem, Solution, is_linear, solve
from laplace_core.inverse.bands import reward_gain, tikhonov_of_layers
from laplace_core.inverse.bumps import Bump, bumps
from laplace_core.inverse.certificate import certify
from laplace_core.inverse.consistency import LEVEL, check_noise
from laplace_core.inverse.resolution import Resolution, resolution
from laplace_core.study.artefacts.model import Artefact
from laplace_core.study.kernels import target_of, weights_of
from laplace_core.study.pipeline import Study, WorldStudy, decoder, noise_of

MOST_HORIZONS = 14
USUAL_NOISE = 1e-3


@dataclass(frozen=True)
class Evidence:
    """The conclusions that the noise allows.

    Attributes:
        p_value: of the test whether any feasible timeline has these values.
        certified: horizons, and the action that is certainly best there, -1 where none is.
    """

    p_value: float
    certified: tuple[tuple[float, int], ...]


def seconds_to_gather(study: Study) -> float:
    """An estimate of how long :func:`gathered` takes."""
    actions, discounts, _ = study.gamma_space.values.shape
    # The time axis has more windows, the smaller the noise is.
    finer = np.sqrt(np.clip(USUAL_NOISE / (study.settings.noise_level or USUAL_NOISE), 1.0, 100.0))
    return float(finer) * (actions * discounts / 60.0 + 0.05 * MOST_HORIZONS * actions)


def gathered(
    study: Study, deviations: np.ndarray, *, independent: bool, progress: Callable[[int, int], None]
) -> Evidence:
    """The test and the certificates of a study, one after the other."""
    horizons = horizons_of(study)
    progress(0, 1 + len(horizons))
    space, s = study.gamma_space, study.settings
    test = check_noise(space, deviations, independent=independent)
    rewards = None
    if isinstance(study, WorldStudy):
        rewards = float(study.world.reward_values[0]), float(study.world.reward_values[-1])
    certified = []
    for done, horizon in enumerate(horizons, start=1):
        progress(done, 1 + len(horizons))
        found = certify(
            space, horizon, deviations, value_gamma=s.value_gamma, slope=s.slope, rewards=rewards,
            independent=independent,
        )  # fmt: skip
        certified.append((float(horizon), -1 if found.best is None or not found.consistent else found.best))
    return Evidence(test.p_value, tuple(certified))


def horizons_of(study: Study) -> list[int]:
    """Whole horizons of a study, close together where they are short."""
    last = int(study.horizons[-1])
    return np.unique(np.rint(np.geomspace(1, max(1, last), MOST_HORIZONS)).astype(int)).tolist()


# --- what a verdict and a list of artefacts say of the noise ---

MOST_WORK = 2e10
"""Products that :func:`believe` may take: about twenty seconds."""
CERTAIN = 2.0
"""Standard deviations that the values of two actions must differ by for the choice not to be a matter of noise."""
REAL = 0.5
"""Probability from which on a bump counts as real."""


def tested(p_value: float) -> str:
    """The result of the test of the values, in a sentence."""
    if p_value > LEVEL:
        return f"Some timeline may well have these values (p = {p_value:.2g})."
    return f"No feasible timeline has these values (p = {p_value:.2g}): they are no transform of one process."


@dataclass(frozen=True)
class Pair:
    """Two bumps that follow each other in an action's timeline, and whether the discounts resolve them."""

    first: float
    second: float
    found: Resolution


@dataclass(frozen=True)
class Belief:
    """The reliable parts of a view, if the size of its noise is known.

    Attributes:
        p_value: of the test whether any feasible timeline has the values of all actions.
        blamed: discounts whose absence takes away half of what the misfit is too large.
        difference, spread: of the values of the best two actions at the horizon, and its standard deviation under the
            noise, in units of reward; None of one action, and of values that are not linear in gamma-space.
        bumps: of the action's expected reward, with the probability that each is real; none where rows are rescaled,
            shifted or folded.
        pairs: neighbours among the bumps that count as real.
        time_step: time from one row to the next, in steps of the world.
    """

    p_value: float
    blamed: tuple[float, ...]
    difference: float | None
    spread: float | None
    bumps: tuple[Bump, ...]
    pairs: tuple[Pair, ...]
    time_step: float

    @property
    def sentence(self) -> str:
        """The sentence for the verdict: the test, whether the choice is certain, and the worst resolved pair."""
        parts = [tested(self.p_value)]
        if self.difference is not None and self.spread is not None and self.difference < CERTAIN * self.spread:
            parts.append(
                f"The choice is within the noise: the best two values differ by {self.difference:.2g}, with a standard "
                f"deviation of {self.spread:.2g}."
            )
        worst = self.worst
        if worst is not None:
            parts.append(f"Rewards at τ {worst.first:g} and {worst.second:g} are {worst.found.verdict}.")
        return " ".join(parts)

    @property
    def worst(self) -> Pair | None:
        """The pair whose times are nearest for what can be resolved."""
        return min(self.pairs, key=lambda pair: np.log(pair.found.ratio) / np.log(pair.found.resolvable), default=None)

    @property
    def artefacts(self) -> list[Artefact]:
        """The effects of the noise on the picture, as entries of the list of artefacts."""
        found = []
        if self.p_value <= LEVEL:
            at = ", ".join(f"{gamma:.3g}" for gamma in self.blamed[:3])
            found.append(
                Artefact(
                    "no timeline",
                    1.0 - self.p_value,
                    f"p = {self.p_value:.2g}",
                    "No feasible timeline has these values under this noise: the discounts follow different policies, "
                    "or the noise is larger than assumed." + (f" The misfit lies mostly at gamma {at}." if at else ""),
                    (),
                )
            )
        doubtful = [bump for bump in self.bumps if bump.probability < REAL]
        if doubtful:
            listed = ", ".join(f"τ {bump.peak * self.time_step:g} ({bump.probability:.0%})" for bump in doubtful[:4])
            found.append(
                Artefact(
                    "doubtful bump",
                    1.0 - min(bump.probability for bump in doubtful),
                    f"probably not real: {listed}",
                    "A bump is real with the probability in brackets: other noise, another solver or another alpha "
                    "does not show it as often as a real one.",
                    (),
                )
            )
        worst = self.worst
        if worst is not None and worst.found.verdict != "resolved":
            found.append(
                Artefact(
                    "unresolved rewards",
                    1.0 - worst.found.ratio / worst.found.resolvable,
                    f"τ {worst.first:g} and {worst.second:g}: {worst.found.verdict}",
                    worst.found.sentence,
                    (),
                )
            )
        return found


def known_noise(study: Study) -> np.ndarray | None:
    """Standard deviation of the error at each discount, ``(G,)``: as assumed, or as it was put into exact values; None
    where it is not known."""
    s, gammas = study.settings, study.gamma_space.gammas
    if s.noise_level is None and s.noise and isinstance(study, WorldStudy) and study.learned is None:
        return np.asarray(s.noise / (1.0 - gammas))
    return noise_of(s, gammas)


def work_to_believe(study: Study) -> float:
    """Products that :func:`believe` takes, about; 0 where the noise is not known."""
    actions, discounts, _ = study.gamma_space.values.shape
    return 0.0 if known_noise(study) is None else 2e7 * actions * discounts


def believe(study: Study, row: int, action: int) -> Belief | None:
    """The reliable parts of a view; None if the size of its noise is not known.

    Args:
        row: of the horizon, ``study.horizons[row]``.
        action: whose bumps are looked at.
    """
    deviations = known_noise(study)
    if deviations is None:
        return None
    independent = isinstance(study, WorldStudy) and study.learned is None
    test = check_noise(study.gamma_space, deviations, independent=independent)
    difference, spread = _difference(study, row, deviations, independent=independent)
    found = _bumps(study, action, deviations, independent=independent)
    return Belief(
        test.p_value, tuple(test.blamed().tolist()), difference, spread, found,
        _pairs(study, found, deviations, independent=independent), study.settings.time_step,
    )  # fmt: skip


def _difference(
    study: Study, row: int, deviations: np.ndarray, *, independent: bool
) -> tuple[float, float] | tuple[None, None]:
    """The difference of the best two values, and its standard deviation.

    V_T is a sum of weights over the discounts times the expected reward there, whose error is the reward gain times
    that of one value; errors of two actions are independent.
    """
    s = study.settings
    if len(study.action_names) == 1 or not is_linear(s.solver) or s.normalise != "none":
        return None, None
    decoded, read = study.at(row), study.reading(row)[0]
    values = decoded.horizon_values[:, read]
    chosen = int(greedy_action(values, scale=decoded.scale))
    difference = float(values[chosen] - np.delete(values, chosen).max())
    here = replace(study, settings=replace(s, horizon=float(study.horizons[row])))
    weights = weights_of(here, target_of(here))
    gain = reward_gain(study.gamma_space, independent=independent)
    return difference, float(np.sqrt(2.0) * gain * np.linalg.norm(weights * deviations))


def _bumps(study: Study, action: int, deviations: np.ndarray, *, independent: bool) -> tuple[Bump, ...]:
    s, space = study.settings, study.gamma_space
    if s.fold or s.shift or s.normalise != "none":
        return ()
    alone = replace(space, values=space.values[[action]], constant=space.constant[[action]])

    def solver(problem: Problem, alpha: float) -> Solution:
        if s.weighting == "equal":
            problem = replace(problem, deviations=None)
        return solve(problem, s.solver, alpha)

    plain = s.solver == "tikhonov" and s.weighting == "equal"
    matrix = decoder(space.gammas, replace(s, filter="none")) if is_linear(s.solver) else None
    listed = bumps(
        alone, s.steps, s.alpha, deviations, time_step=s.time_step, independent=independent,
        solver=tikhonov_of_layers if plain else solver, matrix=matrix,
    )  # fmt: skip
    return tuple(listed[0])


def _pairs(
    study: Study, found: tuple[Bump, ...], deviations: np.ndarray, *, independent: bool
) -> tuple[Pair, ...]:  # fmt: skip
    """Neighbours among the real bumps after the first step, whose times have no ratio otherwise.

    The smaller reward R at time t makes gamma^t R of the expected reward at a discount, whose error is the reward gain
    times that of one value: the largest ratio of the two over the discounts is the signal-to-noise ratio.
    """
    s, gammas = study.settings, study.gamma_space.gammas
    gain = reward_gain(study.gamma_space, independent=independent)
    real = [bump for bump in found if bump.probability >= REAL and bump.peak > 0]
    pairs = []
    for first, second in pairwise(real):
        times = first.peak * s.time_step, second.peak * s.time_step
        ratios = [
            np.max(gammas**time * bump.contrast * (bump.stop - bump.start) / (gain * deviations))
            for bump, time in zip((first, second), times, strict=True)
        ]
        snr = max(1.0 + 1e-9, float(min(ratios)))  # with less nothing is resolved
        pairs.append(Pair(*times, resolution(*times, snr, gammas)))
    return tuple(pairs)
