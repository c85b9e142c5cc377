"""Every single setting that may be to blame for a view, tried on that very view.

A *change* is one setting of the picture put otherwise, everything else kept. It *repairs* a view if, under it,

- a wrong choice becomes right and the largest error of V_T smaller;
- values that were off under a right choice come within the tolerance, the choice staying right;
- a timeline that was not sound under a right choice and right values becomes sound, both staying right;

and, where gamma-space keeps its noise, if the first two also hold under fresh noise. ``acting_gamma``, ``state``, the
horizon and ``deadline`` are the question and not how it is answered: they are never tried, but for a constant horizon
after some steps of an episode, when it no longer is what is left.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, TypeVar

import numpy as np

from laplace_core.code.encoding import GAMMA_SPACINGS
from laplace_core.code.gamma_space import GammaSpace, with_noise
from laplace_core.errors import InputError
from laplace_core.inverse import MAX_STEPS, SOLVERS, is_linear
from laplace_core.inverse.selectors import TYPED
from laplace_core.study.grades import SOUND, Grade, grade, grade_values, timeline_error, timeline_grade
from laplace_core.study.horizon import horizon_values, scale_of_values
from laplace_core.study.pipeline import (
    Decoded,
    WorldStudy,
    decode_and_read,
    is_linear_reading,
    linear_parts,
    noiseless,
    rewards_of,
    rewards_of_parts,
    study,
    work_of_fold,
)
from laplace_core.study.settings import BY_NAME, OVERHANG, SLOPE_TIMES_SPACING, Resolved, ResolvedForWorld, Settings
from laplace_core.worlds import load_world, parameters_of

ALPHAS = tuple(float(f"{alpha:.2g}") for alpha in np.geomspace(1e-9, 10.0, 60))
"""The regularisations that are tried."""
FRESH_SEEDS = 100
"""Noise seeds, besides the view's own, under which a repair is tried."""
IMPOSSIBLE = 0.05
"""Probability below 0 in a row, or of survival above 1, from which on a solver to which that cannot happen is tried."""
MAY_FAIL = 2
"""Of these so many may fail: what holds under 98.5% holds under nine of any ten others with a chance of 99%."""
OFTEN = 0.6
"""A change that holds under this share of them, but not under all, is neither offered nor ruled out."""
LEAST_FALL = 1e-6
"""Share of an error that must go before it counts as smaller."""
MOST_THETAS, MOST_GAMMAS = (int(BY_NAME[name].bounds[1]) for name in ("thetas", "gammas"))
TAIL = 8.0
"""In 1/slope: sensitivities are widened to so far beyond the last reward; sigmoid(-8) is negligible."""
STEEP = 1.1 * SLOPE_TIMES_SPACING
"""A slope above this, in units of 1/spacing, rounds rewards."""
APART = 9.0
"""A slope of this, in units of 1/gap, keeps two rewards apart: it leaves sigmoid(-4.5) = .011 on either side."""
MOST_WORK, MOST_FOR_SOLVERS = 3e10, 5e9
"""Products that a search may cost before it is left out, half a minute if it comes to the worst; and those of its
trials of other solvers, before they are."""

WHY = {
    "repeated reward": "Rows that are nearly empty are rescaled to probability 1, and a residue of an earlier reward "
    "counts as a certain reward.",
    "conditional rewards": "Rows given survival hold the rewards if the episode still runs; adding them up counts "
    "rewards after its end as if it always ran.",
    "early end": "One action ends the episode before the deadline, and what the inverse leaves in the rows after "
    "its end counts as reward; with steps of reward 0 in their place it does not.",
    "mixed policies": "Each discount follows its own greedy policy, so that the values over gamma are no transform of "
    "any single process.",
    "noise amplification": "Gamma-space has random errors, and the inverse divides them by small singular values.",
    "soft deadline": "The soft deadline counts part of the rewards after T and leaves out part of those before T.",
    "edge clipping": "A reward at the edge of the sensitivities, or beyond it, leaves part of its probability outside "
    "the picture.",
    "reward quantisation": "The slope is so steep that no two sensitivities overlap, and every reward is rounded to a "
    "midpoint.",
    "slope blur": "The activation is so gentle that neighbouring rewards run together.",
    "uneven sensitivities": "The sensitivities are unevenly spaced, and the slope suits only some of their gaps.",
    "folding": "Gamma-space holds rewards that come after the last row; the inverse folds them into the rows that "
    "exist.",
    "fine rows": "Rows finer than a step ask the inverse for detail that no world has.",
    "over-smoothing": "Alpha suppresses components that gamma-space still holds, so that rewards spread over "
    "neighbouring steps.",
    "negative mass": "So small an alpha lets the inverse ring around sharp events.",
    "unconstrained inverse": "Nothing keeps a linear inverse from probabilities below 0 or from a survival above 1; a "
    "solver that knows one of these limits comes nearer to the truth with the same values.",
    "only T rows": "Only T rows are decoded, and the inverse puts later rewards into them.",
    "shifted index": "Each discount is decoded by the row of the next one, so that no time has its own place.",
    "discount of the values": "The values are read at another discount than the one that the best action is for.",
    "constant horizon": "The agent still acts as if all of T were left, and aims at rewards that come after the end.",
    "discount grid": "These discounts do not distinguish the steps that matter here; others do.",
    "not learned yet": "With the exact values of this world the same settings are right: the learner does not hold "
    "these values yet.",
}  # fmt: skip
"""What each cause does, in one sentence."""

AnySettings = TypeVar("AnySettings", bound=Settings)


@dataclass(frozen=True)
class Remedy:
    """A change of settings.

    Attributes:
        label: what to do, as a button says it.
        changes: settings by field; ``param:NAME`` is a parameter of the world.
        name: the artefact that it takes away.
    """

    label: str
    changes: Mapping[str, object]
    name: str = ""

    @property
    def changes_world(self) -> bool:
        return any(name.startswith("param:") for name in self.changes)

    def apply(self, settings: AnySettings) -> AnySettings:
        """The settings with the changes made, as complete as they were; an alpha that is changed is a typed one."""
        fields: dict[str, Any] = {name: value for name, value in self.changes.items() if not name.startswith("param:")}
        fields |= {"selector": TYPED} if "alpha" in fields else {}
        params = dict(settings.params)
        params |= {name.removeprefix("param:"): v for name, v in self.changes.items() if name.startswith("param:")}
        return replace(settings, params=tuple(params.items()), **fields)


@dataclass(frozen=True, eq=False)
class Trial:
    """A view under a change: its study, the row of its horizon and its grade."""

    study: WorldStudy
    row: int
    grade: Grade


class Trials:
    """What single changes make of one view of a world.

    Args:
        study: of a world; a gamma-space without one has no truth to grade against.
        row: of the horizon, ``study.horizons[row]``.
        action: whose timeline is graded; default: the chosen one.

    Attributes:
        doubtful: whether a change that was tried repairs the view under its own noise and often, but not always, under
            other noise.
    """

    def __init__(self, study: WorldStudy, row: int, action: int | None = None):
        self.study, self.row, self.settings = study, row, study.settings
        self.horizon = float(study.horizons[row])
        self.grade = grade(study, row)
        self.action, self._given = self.grade.chosen if action is None else action, action
        self.timeline_error = timeline_error(study, self.action, study.at(row))
        self.doubtful = False
        self._here, self._fresh = Trial(study, row, self.grade), _Fresh(study, row)
        self._known: dict[int, Grade] = {}

    @property
    def smeared(self) -> bool:
        return timeline_grade(self.timeline_error) != "sound"

    @property
    def work(self) -> float:
        """Products that a search for a cause costs at most."""
        return self._own_work + sum(self._work_of(change) for change in self.solvers)

    @cached_property
    def _own_work(self) -> float:
        """The work without that of other solvers."""
        s, space = self.settings, self.study.gamma_space
        rows = len(self.study.action_names) * s.steps * len(space.gammas)
        solver = SOLVERS[s.solver]
        width = len(space.thetas) if s.normalise == "paper" or self.smeared or not solver.linear else 1
        seeds = 1 + (FRESH_SEEDS if self._noise_stays({}) else 0)
        solves = 10 * self.study.world.n_states * len(space.gammas)
        longer = 0.0 if s.fold else sum(more_rows(s.steps)) * rows / s.steps
        folded = 20 * work_of_fold(s, len(space.gammas), len(self.study.action_names) * width)
        decoded = len(ALPHAS) * seeds * rows * width + (20 * rows + longer) * len(space.thetas)
        decodes = len(ALPHAS) * seeds + 20
        return float(folded + 20 * solves + solver.work * decoded + solver.least_work * decodes)

    @property
    def affordable(self) -> bool:
        """Whether the search is small enough to be made."""
        return self._own_work <= MOST_WORK

    def _work_of(self, change: Remedy) -> float:
        """Products that it takes to try another solver, under fresh noise as well."""
        s, space, solver = self.settings, self.study.gamma_space, SOLVERS[str(change.changes["solver"])]
        numbers = len(self.study.action_names) * s.steps * len(space.gammas) * len(space.thetas)
        return (1 + (FRESH_SEEDS if self._noise_stays({}) else 0)) * (solver.work * numbers + solver.least_work)

    # ---- the changes

    @cached_property
    def switches(self) -> tuple[Remedy, ...]:
        """Every change but those of alpha and of the grid of discounts, the gravest artefacts first."""
        return tuple(self._switches())

    def _switches(self) -> Iterator[Remedy]:
        s, world, free = self.settings, self.study.world, self.study.policy is None and self.study.learned is None
        if s.normalise == "paper":
            yield Remedy("Keep survival", {"normalise": "none"}, "repeated reward")
        if s.normalise == "survival":
            yield Remedy("Weigh rewards by survival", {"normalise": "none"}, "conditional rewards")
        if _can_add_auxiliary(self.study):
            cause = "repeated reward" if s.normalise == "paper" else "early end"
            yield Remedy("Add auxiliary states", {"param:auxiliary": True}, cause)
        if s.policy == "per_gamma" and free:
            yield Remedy("Share one policy", {"policy": "shared"}, "mixed policies")
        if s.noise:
            yield Remedy("Leave out the noise", {"noise": 0.0}, "noise amplification")
        if s.used and s.deadline == "constant":
            yield Remedy("Act by the time to go", {"deadline": "time_to_go"}, "constant horizon")
        if s.fold:
            yield Remedy("Decode all rows", {"fold": False}, "only T rows")
        if s.shift:
            yield Remedy("Undo the index shift", {"shift": False}, "shifted index")
        if s.value_gamma != s.acting_gamma:
            label = f"Read values at the acting gamma {s.acting_gamma:g}"
            yield Remedy(label, {"value_gamma": s.acting_gamma}, "discount of the values")
        if s.clip:
            yield Remedy("Begin the sensitivities below the rewards", {"clip": False}, "edge clipping")
        if s.softness:
            yield Remedy("Set softness to 0", {"softness": 0.0}, "soft deadline")
        rewards = world.reward_values
        if changes := widened(s, rewards):
            yield Remedy("Widen the sensitivities", changes, "edge clipping")
        thetas = self.study.gamma_space.thetas
        if s.slope > STEEP / float(np.diff(thetas).max()):
            yield Remedy("Soften the slope", softened_slope(thetas), "reward quantisation")
        if rewards.size > 1 and s.slope < APART / float(np.diff(rewards).min()):
            yield Remedy("Steepen the slope", steepened_slope(s, float(np.diff(rewards).min())), "slope blur")
        if s.theta_spacing != "uniform":
            yield Remedy("Space the sensitivities evenly", {"theta_spacing": "uniform"}, "uneven sensitivities")
        for steps in () if s.fold else more_rows(s.steps):  # folded, a horizon has its own number of rows
            yield Remedy(f"Decode {steps} rows", {"steps": steps}, "folding")
        if s.time_step < 1.0:
            steps = int(np.ceil(self.study.horizons[-1] - 1e-9))  # the same stretch of time
            yield Remedy("Decode one row a step", {"time_step": 1.0, "steps": steps}, "fine rows")

    @cached_property
    def grids(self) -> tuple[Remedy, ...]:
        """Other grids of discounts; none where the values were learned at this one."""
        s = self.settings
        if self.study.learned is not None:
            return ()
        if s.paper_grid:
            return (Remedy("Choose another grid than the paper's", {"paper_grid": False}, "discount grid"),)
        changes: list[dict[str, Any]] = [{"spacing": other} for other in GAMMA_SPACINGS if other != s.spacing]
        labels = [f"Space the discounts as {each['spacing']}" for each in changes]
        if s.spacing != "paper":
            more: list[dict[str, Any]] = [{"gammas": s.gammas * n} for n in (2, 4) if s.gammas * n <= MOST_GAMMAS]
            ends = [{"gamma_min": low} for low in (0.01, 0.1, 0.3) if low != s.gamma_min]
            ends += [{"gamma_max": high} for high in (0.99, 0.995, 0.999) if high != s.gamma_max]
            labels += [f"Use {each['gammas']} discounts" for each in more]
            which = {"gamma_min": "smallest", "gamma_max": "largest"}
            labels += [f"Put the {which[name]} discount at {value:g}" for each in ends for name, value in each.items()]
            changes += more + ends
        return tuple(Remedy(label, each, "discount grid") for label, each in zip(labels, changes, strict=True))

    @cached_property
    def solvers(self) -> tuple[Remedy, ...]:
        """Solvers to which it cannot happen what a linear one has done, as many as are affordable, the faster first."""
        left, tried = min(MOST_FOR_SOLVERS, MOST_WORK - self._own_work), []
        for change in self._other_solvers:
            left -= self._work_of(change)
            if left < 0:
                break
            tried.append(change)
        return tuple(tried)

    @property
    def too_slow(self) -> tuple[Remedy, ...]:
        """Solvers that would be tried if they were faster."""
        return self._other_solvers[len(self.solvers) :]

    @cached_property
    def _other_solvers(self) -> tuple[Remedy, ...]:
        s, decoded = self.settings, self.study.at(self.row)
        if s.fold or not is_linear(s.solver):  # folded, a horizon has an inverse of its own
            return ()
        below = -np.minimum(decoded.tau_space, 0.0).sum(axis=-1).min(initial=0.0) / s.time_step
        above = decoded.survival.max(initial=0.0) / s.time_step - 1.0
        negative = Remedy("Use the non-negative solver", {"solver": "nonnegative"}, "unconstrained inverse")
        feasible = Remedy("Use the feasible timeline", {"solver": "feasible"}, "unconstrained inverse")
        if below > IMPOSSIBLE:
            return negative, feasible
        return (feasible,) if above > IMPOSSIBLE else ()

    def alpha_change(self, alpha: float) -> Remedy:
        """The change to another alpha."""
        lower = alpha < self.settings.alpha
        cause = "over-smoothing" if lower else "noise amplification" if self._noisy else "negative mass"
        return Remedy(f"{'Lower' if lower else 'Raise'} alpha to {alpha:g}", {"alpha": alpha}, cause)

    @property
    def _noisy(self) -> bool:
        return bool(self.settings.noise) or self.study.learned is not None

    # ---- running them

    def run(self, change: Remedy) -> Trial | None:
        """The view under a change; None where it cannot be had or does not reach the horizon."""
        settings = change.apply(self.settings)
        try:
            world = self.study.world
            if change.changes_world:
                world = load_world(world.source, dict(settings.params))
            result = study(world, settings, self.study.policy, self.study.learned)
        except InputError:  # a change may ask for more than a study may hold
            return None
        if result.horizons[-1] < self.horizon - 1e-9:
            return None
        row = result.row_at(self.horizon)
        return Trial(result, row, grade(result, row))

    def repairs(self, change: Remedy, trial: Trial | None = None) -> bool:
        """Whether a change repairs the view, also under fresh noise."""
        trial = trial or self.run(change)
        if trial is None:
            return False
        if not self._repaired(trial.grade, lambda: _timeline_error(trial, self.action)):
            return False
        if not self._noise_stays(change.changes):
            return True
        fresh = _Fresh(trial.study, trial.row)
        return self._holds(
            lambda seed: self._grade_of(trial, fresh.rewards(seed)),
            lambda seed: timeline_error(trial.study, self.action, fresh.decoded(seed)),
        )

    @property
    def learned_wrong(self) -> bool:
        """Whether the exact values of the world, in place of what was learned, repair the view; any noise stays."""
        if self.study.learned is None:
            return False
        result = study(self.study.world, self.settings, self.study.policy)
        return self.repairs(Remedy("", {}), Trial(result, self.row, grade(result, self.row)))

    def _repaired(self, after: Grade, timeline: Callable[[], float]) -> bool:
        before = self.grade
        if after.wrong:
            return False
        if before.wrong:
            return after.error < before.error * (1.0 - LEAST_FALL)
        if before.off:
            return not after.off
        return self.smeared and not after.off and timeline_grade(timeline()) == "sound"

    def _noise_stays(self, changes: Mapping[str, object]) -> bool:
        return bool(changes.get("noise", self.settings.noise))

    @cached_property
    def _seeds(self) -> list[int]:
        """Seeds that no view counts through: a person who tries others meets none of them."""
        random = np.random.default_rng([self.settings.noise_seed, FRESH_SEEDS])
        return [int(seed) for seed in random.integers(2**30, 2**31, FRESH_SEEDS)]

    def _holds(self, graded: Callable[[int], Grade], timeline: Callable[[int], float]) -> bool:
        """Whether a view is repaired under nearly all fresh noise; notes where it often is."""
        failed = 0
        for seed in self._seeds:
            after = graded(seed)
            if self.grade.wrong:
                good = not after.wrong and after.error < self._before(seed).error * (1.0 - LEAST_FALL)
            else:
                good = not after.wrong and not after.off
                good = good and (self.grade.off or timeline_grade(timeline(seed)) == "sound")
            failed += not good
            if failed > (1.0 - OFTEN) * FRESH_SEEDS:
                return False
        self.doubtful |= failed > MAY_FAIL
        return failed <= MAY_FAIL

    def _before(self, seed: int) -> Grade:
        """The view itself under another noise."""
        if seed not in self._known:
            self._known[seed] = self._grade_of(self._here, self._fresh.rewards(seed))
        return self._known[seed]

    def _grade_of(self, trial: Trial, rewards: np.ndarray) -> Grade:
        """The grade of a view with other expected rewards, ``(A, K)``, in their place."""
        s, read = trial.study.settings, trial.study.reading(trial.row)[0]
        values = horizon_values(rewards, s.value_gamma, s.softness, s.time_step)[:, read]
        return grade_values(
            trial.study.truth, trial.study, trial.row, values, scale=scale_of_values(rewards, trial.study.midpoints)
        )

    # ---- alpha

    @cached_property
    def alpha(self) -> float | None:
        """The one alpha that may be suggested: it repairs this view, and none other would be suggested after it.

        Of those that repair, one with little timeline error among those whose values hold, else one with little error
        of V_T; so that at that alpha nothing better is left to suggest.
        """
        best = self._best_alpha()
        for _ in range(4):
            if best is None:
                return None
            following = Trials(self._with_alpha(best), self.row, self._given)._best_alpha()
            if following is None:
                return best
            best = following if following in self._repairing else None
        return None

    def _with_alpha(self, alpha: float) -> WorldStudy:
        return self.study.under(self.settings.at_alpha(alpha))

    @cached_property
    def _repairing(self) -> dict[float, Grade]:
        """Every alpha tried that repairs the view, with the grade under it."""
        own, grades = Part.of(self.study.gamma_space, self.settings), dict[float, Grade]()
        for alpha in ALPHAS:
            if alpha == self.settings.alpha:
                continue
            after = self._grade_of(self._here, own.rewards(self.settings, alpha, self._read))
            if self._repaired_by(alpha, after):
                grades[alpha] = after
        return grades

    def _repaired_by(self, alpha: float, after: Grade) -> bool:
        """Whether an alpha, under which the view has this grade, repairs it, also under fresh noise."""
        if not self._repaired(after, lambda: self._timeline_at(alpha)):
            return False
        return not self._noise_stays({}) or self._holds(
            lambda seed: self._grade_of(self._here, self._fresh.rewards(seed, alpha)),
            lambda seed: timeline_error(self.study, self.action, self._fresh.decoded(seed, alpha)),
        )

    def _timeline_at(self, alpha: float) -> float:
        return timeline_error(self.study, self.action, self._decoded_at(alpha))

    def _decoded_at(self, alpha: float) -> Decoded:
        return decode_and_read(self.study.gamma_space, self.settings.at_alpha(alpha), self._read)

    @property
    def _read(self) -> int:
        """The row whose value is read."""
        return self.study.reading(self.row)[0]

    def _best_alpha(self) -> float | None:
        good = [alpha for alpha, after in self._repairing.items() if not after.off]
        if good:
            errors = {alpha: self._timeline_at(alpha) for alpha in good}
            enough = max(0.5 * SOUND, 1.1 * min(errors.values()))
        else:
            errors = {alpha: after.error for alpha, after in self._repairing.items()}
            enough = 1.1 * min(errors.values(), default=0.0)
        # The largest that leaves little to gain: the smaller alpha is, the louder any noise.
        return max((alpha for alpha, error in errors.items() if error <= enough), default=None)


@dataclass(frozen=True, eq=False)
class Part:
    """The part of a gamma-space that expected rewards need: all of it where rows are rescaled, else two numbers a
    discount."""

    source: GammaSpace | np.ndarray
    gammas: np.ndarray

    @classmethod
    def of(cls, space: GammaSpace, settings: Resolved) -> Part:
        if not is_linear_reading(settings):
            return cls(space, space.gammas)
        return cls(linear_parts(space), space.gammas)

    def rewards(self, settings: Resolved, alpha: float, row: int) -> np.ndarray:
        """Decoded E[r_tau] at an alpha, ``(A, K)``, for the horizon of a row."""
        s = settings.at_alpha(alpha)
        if isinstance(self.source, GammaSpace):
            return rewards_of(self.source, s, row)
        return rewards_of_parts(self.source, self.gammas, s, row)


class _Fresh:
    """A study's gamma-space under other noise of the same level, made once a seed."""

    MOST_BYTES = 100_000_000
    """Bytes of noisy gamma-spaces that are cached; beyond it they are made anew."""

    def __init__(self, study: WorldStudy, row: int):
        self._study, self._read = study, study.reading(row)[0]
        self._made: dict[int, Part] = {}

    @cached_property
    def _clean(self) -> GammaSpace:
        return noiseless(self._study)

    def rewards(self, seed: int, alpha: float | None = None) -> np.ndarray:
        """Decoded E[r_tau], ``(A, K)``, under the noise of a seed."""
        s = self._study.settings
        part = self._made.get(seed)
        if part is None:
            part = Part.of(with_noise(self._clean, s.noise, seed), s)
            if not isinstance(part.source, GammaSpace) or FRESH_SEEDS * part.source.values.nbytes <= self.MOST_BYTES:
                self._made[seed] = part
        return part.rewards(s, s.alpha if alpha is None else alpha, self._read)

    def decoded(self, seed: int, alpha: float | None = None) -> Decoded:
        """The whole tau-space under the noise of a seed."""
        s = self._study.settings
        s_ = s if alpha is None else s.at_alpha(alpha)
        return decode_and_read(with_noise(self._clean, s.noise, seed), s_, self._read)


def _timeline_error(trial: Trial, action: int) -> float:
    return timeline_error(trial.study, action, trial.study.at(trial.row))


def more_rows(steps: int) -> Iterator[int]:
    """Twice as many rows, four times as many and so on, up to the most that a timeline may have."""
    while steps < MAX_STEPS:
        steps = min(MAX_STEPS, 2 * steps)
        yield steps


def widened(s: ResolvedForWorld, rewards: np.ndarray) -> dict[str, object]:
    """Sensitivities that reach beyond every reward, at the same spacing as far as their number allows.

    Returns:
        the change; empty where they reach so far already.
    """
    over = max(OVERHANG * float(rewards[-1] - rewards[0]), TAIL / s.slope)
    low, high = min(s.theta_min, float(rewards[0]) - over), max(s.theta_max, float(rewards[-1]) + over)
    if (low, high) == (s.theta_min, s.theta_max):
        return {}
    thetas = min(MOST_THETAS, int(np.ceil((s.thetas - 1) * (high - low) / (s.theta_max - s.theta_min))) + 1)
    return {"theta_min": float(f"{low:.6g}"), "theta_max": float(f"{high:.6g}"), "thetas": max(s.thetas, thetas)}


def softened_slope(thetas: np.ndarray) -> dict[str, object]:
    """The change to the slope that suits the widest gap between sensitivities ``(H,)``."""
    return {"slope": float(f"{SLOPE_TIMES_SPACING / float(np.diff(thetas).max()):.2g}")}


def steepened_slope(s: ResolvedForWorld, gap: float) -> dict[str, object]:
    """The change to a slope that keeps rewards with this gap apart, and to as many sensitivities as it needs."""
    slope = float(f"{APART / gap:.2g}")
    thetas = int(np.ceil((s.theta_max - s.theta_min) * slope / SLOPE_TIMES_SPACING)) + 1
    return {"slope": slope, "thetas": min(MOST_THETAS, max(s.thetas, thetas))}


def _can_add_auxiliary(result: WorldStudy) -> bool:
    """Whether the world is a preset that can be built with auxiliary states and has none."""
    known = any(parameter.name == "auxiliary" for parameter in parameters_of(result.world.source))
    off = not dict(result.world.params).get("auxiliary", False)
    return known and off and result.learned is None and result.policy is None
