"""The one line from a world (or a saved gamma-space) to the action it chooses.

    world --exact--> gamma-space --decode--> tau-space --read--> horizon values --> action

Each stage is a function of just what it depends on, in a small bounded cache, so that moving alpha costs a
matrix product and never a solve.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Self, TypeVar

import numpy as np

from laplace_core.caching import cached
from laplace_core.code.encoding import PAPER_GAMMAS, discount_grid, sensitivity_grid, smeared
from laplace_core.code.gamma_space import GammaSpace, encode, shifted, softened, with_noise
from laplace_core.errors import InputError
from laplace_core.inverse import (
    SOLVERS,
    AlphaRecord,
    Problem,
    Solution,
    choose_alpha,
    decode_matrix,
    is_linear,
    normalise_rows,
    problem_of,
    rounding_of_rows,
    solve,
)
from laplace_core.inverse.neural import ASSUMED_NOISE
from laplace_core.inverse.smoothing import filtered, probability_filter
from laplace_core.planning import (
    check_policy,
    finite_horizon_optimum,
    greedy_policy,
    reward_indicator_basis,
    reward_timeline,
    target_policies,
)
from laplace_core.study.conventions import check_convention
from laplace_core.study.horizon import choose_actions, expected_rewards, horizon_values, row_horizons, scale_of_values
from laplace_core.study.settings import (
    Resolved,
    ResolvedForWorld,
    Settings,
    levels_in,
    resolve,
    resolve_for_gamma_space,
)
from laplace_core.study.size import check_size
from laplace_core.worlds import World

AnyResolved = TypeVar("AnyResolved", bound=Resolved)
MAX_FOLDED = 200_000_000
"""Most numbers of the inverses of all horizons together, if each has its own: two or three seconds."""


@dataclass(frozen=True, eq=False)
class Decoded:
    """A tau-space and what is read from it; A actions, K rows.

    ``survival`` is the decoded constant channel before any rescaling; everything else comes after it. Rows
    are densities over time: with ``time_step`` < 1 the probability of a step is the sum of the 1 / ``time_step`` rows
    around it, and about each of them divided by ``time_step``. ``scale`` is the size of the terms that the horizon
    values are sums of, in units of reward, for ties.
    """

    tau_space: np.ndarray
    survival: np.ndarray
    expected_reward: np.ndarray
    horizon_values: np.ndarray
    scale: float

    @property
    def actions(self) -> np.ndarray:
        """Action chosen at each horizon, int ``(K,)``."""
        return choose_actions(self.horizon_values, self.scale)

    @property
    def mass(self) -> np.ndarray:
        """Row sums of the tau-space, ``(A, K)``."""
        return self.tau_space.sum(axis=-1)


@dataclass(frozen=True, eq=False)
class Truth(Decoded):
    """The same arrays without an inverse, and the optimum: Q*_T(a), ``(A, K)``.

    The timeline is that of the policy, each step on the row at its own time (:func:`row_shares`); rewards count as
    themselves, not as midpoints. Values are read as the decoded ones are, with the deadline of the study, hard or soft,
    so that they differ from those by nothing but the inverse; the optimum's deadline is hard.
    """

    optimum: np.ndarray

    @property
    def optimal_action(self) -> np.ndarray:
        """Best action for each horizon, int ``(K,)``."""
        return choose_actions(self.optimum)


@dataclass(frozen=True, eq=False)
class Study:
    """One state under one choice of settings; a :class:`WorldStudy` if there is a world.

    ``midpoints`` are what each column of the tau-space counts as: the bin values of the gamma-space, ``(B,)``.
    ``learned`` is the learned reward-indicator basis, ``(A, G, V)``, that was decoded in place of the exact one;
    ``policy`` is the one that was given in place of the target policy of the settings. ``automatic`` says how a rule
    chose the alpha of the settings; None if it was typed.
    """

    settings: Resolved
    action_names: tuple[str, ...]
    gamma_space: GammaSpace
    midpoints: np.ndarray
    decoded: Decoded
    world: World | None = None
    state: int | None = None
    truth: Truth | None = None
    learned: np.ndarray | None = None
    policy: np.ndarray | None = None
    automatic: AlphaRecord | None = None

    @property
    def alpha_record(self) -> AlphaRecord:
        """How alpha was chosen; a typed value is recorded as typed."""
        return self.automatic or AlphaRecord("typed", self.settings.alpha, solver=self.settings.solver)

    @property
    def horizons(self) -> np.ndarray:
        """T of each column of the horizon values, in steps of the world, ``(K,)``."""
        return row_horizons(self.settings.steps, self.settings.time_step)

    def row_at(self, horizon: float) -> int:
        """The column of the horizon values that comes nearest to a horizon.

        Raises:
            InputError: a horizon that is not a number above 0.
        """
        if not horizon > 0:
            raise InputError(f"the horizon is {horizon:g}; it must be above 0.")
        return int(np.argmin(np.abs(self.horizons - horizon)))

    @property
    def row(self) -> int:
        """The column of the horizon T of the settings; the last one where none is chosen."""
        return chosen_row(self.settings)

    def reading(self, row: int) -> tuple[int, int]:
        """:func:`reading` of the horizon of a row: of the very T of the settings, where that is the row of T."""
        asked = self.settings.horizon if row == self.row else None
        return reading(self.settings, float(self.horizons[row]) if asked is None else asked)

    def at(self, row: int) -> Decoded:
        """What is decoded for the horizon of a row: under ``fold`` only as many rows as the value read has."""
        read = self.reading(row)[0]
        if not self.settings.fold or read == self.reading(self.row)[0]:
            return self.decoded
        return decode_and_read(self.gamma_space, self.settings, read)

    def under(self, settings: Resolved) -> Self:
        """The same gamma-space, decoded and read by other settings; a truth stays as it is."""
        settings, automatic = with_alpha(self.gamma_space, settings)
        return replace(self, settings=settings, decoded=read_study(self.gamma_space, settings), automatic=automatic)

    def check_view(self, row: int | None = None, action: int | None = None) -> None:
        """Refuse a row of no horizon, or an action that this study does not have.

        Raises:
            InputError: naming how many there are.
        """
        for name, index, count in (("row", row, len(self.horizons)), ("action", action, len(self.action_names))):
            if index is not None and not 0 <= index < count:
                raise InputError(f"{name} {index} does not exist: this study has {count}, numbered 0 to {count - 1}.")

    @property
    def taus(self) -> np.ndarray:
        """Time of each row of the tau-space, in steps of the world, ``(K,)``."""
        return np.arange(self.settings.steps) * self.settings.time_step


@dataclass(frozen=True, eq=False)
class WorldStudy(Study):
    """A study of a state of a world, which knows the truth."""

    settings: ResolvedForWorld
    world: World
    state: int
    truth: Truth


def study(
    world: World, settings: Settings, policy: np.ndarray | None = None, learned: np.ndarray | None = None
) -> WorldStudy:
    """Run the whole line for one state of a world.

    Args:
        policy: a policy of your own, int ``(S,)`` or float ``(S, A)``, that every discount and the truth follow
            in place of the one that ``settings.policy`` names.
        learned: a reward-indicator basis of this state that was learned, ``(A, G, V)``, to be decoded in place of
            the exact one; the truth stays exact.

    Raises:
        InputError: settings that do not fit the world or each other.
    """
    if not isinstance(world, World) or not isinstance(settings, Settings):
        raise InputError("a study takes a world, as load_world makes it of a name or a file, and Settings.")
    s = resolve(settings, world)
    state = world.state_index(s.state)
    gammas, thetas = grids(s)
    check_size(world.n_actions, len(gammas), len(thetas), s.steps, rewards=world.reward_values.size)
    check_fold(s, len(gammas), world.n_actions * (len(thetas) if s.normalise == "paper" else 2))
    length = int(np.ceil(row_horizons(s.steps, s.time_step)[-1] - 1e-9))
    if policy is None:
        basis = _basis(world, state, gammas.tobytes(), s.policy, acting_gamma=s.acting_gamma)
        timeline = timeline_from(world, s)
    else:
        policy = check_policy(world, policy)
        basis = reward_indicator_basis(world, state, gammas, [policy] * gammas.size)
        timeline = reward_timeline(world, state, policy, length)
    if learned is not None:
        if learned.shape != basis.shape:
            raise InputError(f"the learned basis is {learned.shape}; this world and grid need {basis.shape}.")
        basis = learned
    if s.clip:
        clipped = clipped_sensitivities(s, world, timeline)
        thetas = thetas if clipped is None else clipped
    gamma_space = with_noise(encode(basis, world.reward_values, gammas, thetas, s.slope), s.noise, s.noise_seed)
    s, automatic = with_alpha(gamma_space, s)
    optimum = _optimum(world, state, s.acting_gamma, length)
    truth = _truth(world, timeline, optimum, thetas, settings=s)
    midpoints = gamma_space.bin_values
    decoded = read_study(gamma_space, s)
    return WorldStudy(
        s, world.actions, gamma_space, midpoints, decoded, world, state, truth, learned, policy, automatic
    )


def study_of_gamma_space(gamma_space: GammaSpace, settings: Settings, *, own_convention: bool = True) -> Study:
    """Decode a gamma-space learned elsewhere: there is no world and no truth.

    Args:
        own_convention: whether the values may follow another convention than ours, and are looked at for that; those
            of an agent of this library do not.

    Raises:
        InputError: settings that the gamma-space decides, or values that are those of another convention.
    """
    if own_convention:
        check_convention(gamma_space.values, gamma_space.constant, gamma_space.gammas, gamma_space.thetas)
    resolved = resolve_for_gamma_space(settings, gamma_space.gammas)
    actions, discounts, thetas = gamma_space.values.shape
    check_size(actions, discounts, thetas, resolved.steps)
    gamma_space = with_noise(softened(gamma_space, resolved.slope_share), resolved.noise, resolved.noise_seed)
    check_fold(resolved, discounts, actions * (thetas if resolved.normalise == "paper" else 2))
    names = tuple(f"action {a}" for a in range(len(gamma_space.values)))
    resolved, automatic = with_alpha(gamma_space, resolved)
    decoded = read_study(gamma_space, resolved)
    return Study(resolved, names, gamma_space, gamma_space.bin_values, decoded, automatic=automatic)


def grids(settings: ResolvedForWorld) -> tuple[np.ndarray, np.ndarray]:
    """Discounts ``(G,)`` and sensitivities ``(H,)`` of resolved settings."""
    s = settings
    own = discount_grid(s.gammas, s.spacing, s.gamma_min, s.gamma_max)
    gammas = np.array(PAPER_GAMMAS) if s.paper_grid else own
    return gammas, sensitivity_grid(s.thetas, s.theta_min, s.theta_max, s.theta_spacing, s.theta_scale or None)


def clipped_sensitivities(settings: ResolvedForWorld, world: World, timeline: np.ndarray) -> np.ndarray | None:
    """Sensitivities ``(H,)`` that begin at the lowest reward which occurs, so that half of its probability is lost.

    Args:
        timeline: P(r_tau = v, alive), ``(A, N, V)``.

    Returns:
        None where that reward lies outside the sensitivities, or too close to their end for so many of them.
    """
    s = settings
    occurs = world.reward_values[timeline.max(axis=(0, 1)) > 1e-9]
    if not occurs.size or not s.theta_min < occurs[0] < s.theta_max:
        return None
    try:
        return sensitivity_grid(s.thetas, float(occurs[0]), s.theta_max, s.theta_spacing, s.theta_scale or None)
    except InputError:
        return None


def rows_decoded(settings: Resolved, row: int | None) -> int:
    """The number of rows of the inverse: all K, or under ``fold`` as many as the horizon of a row."""
    return row + 1 if settings.fold and row is not None else settings.steps


def deviations_of(settings: Resolved, gammas: np.ndarray) -> np.ndarray | None:
    """Standard deviations that the inverse divides each discount by, ``(G,)``; None where all count alike.

    Without a noise level only their ratios are known. Most solvers need no more; the neural one takes its usual size.
    """
    known = noise_of(settings, gammas)
    return None if settings.weighting == "equal" else ASSUMED_NOISE / (1.0 - gammas) if known is None else known


def noise_of(settings: Resolved, gammas: np.ndarray) -> np.ndarray | None:
    """Standard deviation of the error that each discount is taken to have, ``(G,)``; None where it is not known.

    Raises:
        InputError: not as many levels as discounts.
    """
    s = settings
    if s.noise_levels is None:
        return None if s.noise_level is None else s.noise_level / (1.0 - gammas)
    levels = np.array(levels_in(s.noise_levels))
    if levels.size != gammas.size:
        raise InputError(f"noise_levels has {levels.size} numbers for {gammas.size} discounts: give one for each.")
    return levels / (1.0 - gammas)


def decoder(
    gammas: np.ndarray, settings: Resolved, rows: int | None = None, alpha: float | None = None
) -> np.ndarray:  # fmt: skip
    """The matrix from gamma-space to tau-space of a linear solver, ``(rows, G)``: the inverse after any filter.

    Args:
        rows, alpha: default to those of the settings.

    Raises:
        InputError: a solver that has no matrix, or a filter that does not fit the grid.
    """
    s = settings
    matrix = decode_matrix(
        gammas, s.steps if rows is None else rows, s.alpha if alpha is None else alpha, s.time_step,
        solver=s.solver, deviations=deviations_of(s, gammas),
    )  # fmt: skip
    return matrix if s.filter == "none" else matrix @ probability_filter(gammas, s.filter_window, s.filter_order)


def inverted(values: np.ndarray, gammas: np.ndarray, settings: Resolved, row: int | None = None) -> np.ndarray:
    """Anything that lies over the discounts, ``(..., G, n)``, over the rows instead, ``(..., K, n)``.

    The solver of the settings has to be a linear one. Rows that are not decoded, because the horizon of ``row`` has
    fewer, are 0.
    """
    s = settings
    decoded = decoder(gammas, s, rows_decoded(s, row)) @ (shifted(values) if s.shift else values)
    return _with_all_rows(decoded, s)


def _with_all_rows(decoded: np.ndarray, settings: Resolved) -> np.ndarray:
    """Rows ``(..., rows, n)`` with those that were not decoded, which are 0, ``(..., K, n)``."""
    missing = settings.steps - decoded.shape[-2]
    return decoded if not missing else np.pad(decoded, [(0, 0)] * (decoded.ndim - 2) + [(0, missing), (0, 0)])


def problem_for(gamma_space: GammaSpace, settings: Resolved, row: int | None = None) -> Problem:
    """The problem that settings make of a gamma-space, before any filter; with as many rows as :func:`inverted` has."""
    s = settings
    problem = problem_of(gamma_space, rows_decoded(s, row), s.time_step, deviations_of(s, gamma_space.gammas))
    return replace(problem, masses=shifted(problem.masses)) if s.shift else problem


def solver_of(settings: Resolved) -> Callable[[Problem, float], Solution]:
    """What settings make of any masses over their discounts: filtered, shifted and weighted as those of a study are.

    The deviations of the problem that is given say how large its noise is; how discounts count follows from the
    settings.
    """
    s = settings

    def solver(problem: Problem, alpha: float) -> Solution:
        masses = problem.masses
        if s.filter != "none":
            masses = probability_filter(problem.gammas, s.filter_window, s.filter_order) @ masses
        if s.shift:
            masses = shifted(masses)
        counted = deviations_of(s, problem.gammas)
        return solve(replace(problem, masses=masses, deviations=counted), s.solver, alpha)

    return solver


def with_alpha(gamma_space: GammaSpace, settings: AnyResolved) -> tuple[AnyResolved, AlphaRecord | None]:
    """Settings with the alpha that their rule chooses for a gamma-space, and its record.

    The record is None where alpha was typed, or where the solver has no alpha and there is nothing to choose.

    A rule looks at the values as they are, before any filter, whose output no longer has independent errors. A solver
    that is not linear takes the alpha that the rule chooses for Tikhonov; the record says so.

    Raises:
        InputError: a rule that cannot choose, for lack of a noise level or of discounts.
    """
    s = settings
    if s.selector == "typed" or not SOLVERS[s.solver].has_alpha:
        return s, None
    problem = problem_for(gamma_space, s, row_read(s))
    record = choose_alpha(problem, s.solver, s.selector, noise=noise_of(s, gamma_space.gammas))
    assert isinstance(record.value, float)  # one for all bins
    return replace(s, alpha=record.value), record


def decode_and_read(gamma_space: GammaSpace, settings: Resolved, row: int | None = None) -> Decoded:
    """From gamma-space to the values of every horizon.

    Args:
        row: of the horizon that is read. Under ``fold`` it decides how many rows are decoded: of the values, only that
            of this horizon is then meant.
    """
    s, gammas = settings, gamma_space.gammas
    rounding = None
    if is_linear(s.solver):
        differences = gamma_space.differences
        tau_space = inverted(differences, gammas, s, row)
        survival = inverted(gamma_space.constant[..., None], gammas, s, row)[..., 0]
        if s.normalise == "paper":
            matrix = decoder(gammas, s, rows_decoded(s, row))
            least = rounding_of_rows(shifted(differences) if s.shift else differences, matrix)
            rounding = _with_all_rows(least[..., None], s)[..., 0]
    else:
        space = gamma_space if s.filter == "none" else filtered(gamma_space, s.filter_window, s.filter_order)
        solution = solve(problem_for(space, s, row), s.solver, s.alpha)
        tau_space = _with_all_rows(solution.tau_space(open_ends=gamma_space.open_ends), s)
        survival = _with_all_rows(solution.survival[..., None], s)[..., 0]
    tau_space = normalise_rows(tau_space, survival, s.normalise, s.time_step, rounding)
    rewards = expected_rewards(tau_space, gamma_space.bin_values)
    values = horizon_values(rewards, s.value_gamma, s.softness, s.time_step)
    return Decoded(tau_space, survival, rewards, values, scale_of_values(rewards, gamma_space.bin_values))


def chosen_row(settings: Resolved) -> int:
    """The column of the horizon T of settings; the last one where none is chosen."""
    s = settings
    if s.horizon is None:
        return s.steps - 1
    return int(np.argmin(np.abs(row_horizons(s.steps, s.time_step) - s.horizon)))


def reading(settings: Resolved, horizon: float) -> tuple[int, int]:
    """For a horizon T, the column whose value is read, and that of the steps which are left.

    With ``used`` steps over, T less these are left. An agent with a constant horizon still reads the value of T.
    """
    s, horizons = settings, row_horizons(settings.steps, settings.time_step)
    left = int(np.argmin(np.abs(horizons - max(0.0, horizon - s.used))))
    return (int(np.argmin(np.abs(horizons - horizon))) if s.deadline == "constant" else left), left


def row_read(settings: Resolved) -> int:
    """The column of the horizon values that is read for the horizon of settings, or the longest one."""
    s = settings
    return reading(s, float(row_horizons(s.steps, s.time_step)[-1]) if s.horizon is None else s.horizon)[0]


def read_study(gamma_space: GammaSpace, settings: Resolved) -> Decoded:
    """The decoded part of a study: the rows that the horizon of its settings has, and the value of every horizon."""
    s = settings
    decoded = decode_and_read(gamma_space, s, row_read(s))
    if not s.fold:
        return decoded
    return replace(decoded, horizon_values=folded_values(lambda each: rewards_of(gamma_space, s, each), s))


def folded_values(rewards_at: Callable[[int], np.ndarray], settings: Resolved) -> np.ndarray:
    """V_T, ``(..., K)``, if every horizon has its own inverse.

    Args:
        rewards_at: E[r_tau], ``(..., K)``, decoded for the horizon of a row.
    """
    s = settings
    columns = [
        horizon_values(rewards_at(row)[..., : row + 1], s.value_gamma, s.softness, s.time_step)[..., row]
        for row in range(s.steps)
    ]
    return np.stack(columns, axis=-1)


def work_of_fold(settings: Resolved, discounts: int, columns: int) -> int:
    """Numbers of the inverses of all horizons together, if each has its own; 0 if all share one.

    Args:
        columns: how many columns each of them decodes.
    """
    return settings.steps**2 * (discounts**2 + columns) if settings.fold else 0


def check_fold(settings: Resolved, discounts: int, columns: int) -> None:
    """Refuse more :func:`work_of_fold` than seconds do.

    Raises:
        InputError: it is more.
    """
    work = work_of_fold(settings, discounts, columns)
    if work > MAX_FOLDED:
        raise InputError(
            f"an inverse for each of {settings.steps:,} horizons (--fold) is {work:,} numbers, above {MAX_FOLDED:,}: "
            "lower steps, gammas or thetas, or decode all rows."
        )


def rewards_of(gamma_space: GammaSpace, settings: Resolved, row: int | None = None) -> np.ndarray:
    """Decoded E[r_tau], ``(A, K)``, as :func:`decode_and_read` has it.

    Where it is linear in gamma-space (:func:`is_linear_reading`), it needs no tau-space.
    """
    if not is_linear_reading(settings):
        return decode_and_read(gamma_space, settings, row).expected_reward
    return rewards_of_parts(linear_parts(gamma_space), gamma_space.gammas, settings, row)


def is_linear_reading(settings: Resolved) -> bool:
    """Whether expected rewards are linear in gamma-space: by a linear solver, without rows that are clipped."""
    return is_linear(settings.solver) and settings.normalise != "paper"


def linear_parts(gamma_space: GammaSpace) -> np.ndarray:
    """What :func:`rewards_of_parts` reads: the reward that the values imply and the constant channel, ``(A, G, 2)``."""
    means = gamma_space.differences @ gamma_space.bin_values
    return np.stack([means, gamma_space.constant], axis=-1)


def rewards_of_parts(
    parts: np.ndarray, gammas: np.ndarray, settings: Resolved, row: int | None = None
) -> np.ndarray:  # fmt: skip
    """:func:`rewards_of` from :func:`linear_parts`, ``(A, K)``, for rows that are not rescaled to 1."""
    s = settings
    decoded = inverted(parts, gammas, s, row)
    if s.normalise == "none":
        return decoded[..., 0]
    return normalise_rows(decoded[..., :1], decoded[..., 1], s.normalise, s.time_step)[..., 0]


def basis_of(study: WorldStudy, policy: str | None = None) -> np.ndarray:
    """The exact reward-indicator basis of a study of a world, ``(A, G, V)``, under its own or another target policy.

    A policy that was given stays: it is the process of every discount, whatever the settings name.
    """
    s = study.settings
    if study.policy is not None:
        policies = [study.policy] * study.gamma_space.gammas.size
        return reward_indicator_basis(study.world, study.state, study.gamma_space.gammas, policies)
    gammas = study.gamma_space.gammas.tobytes()
    return _basis(study.world, study.state, gammas, policy or s.policy, acting_gamma=s.acting_gamma)


def timeline_of(study: WorldStudy, length: int) -> np.ndarray:
    """P(r_tau = v, alive) at whole steps, ``(A, length, V)``, under the policy of the study's truth."""
    if study.policy is not None:
        return reward_timeline(study.world, study.state, study.policy, length)
    return _timeline(study.world, study.state, study.settings.acting_gamma, length)


def timeline_from(world: World, settings: ResolvedForWorld) -> np.ndarray:
    """P(r_tau = v, alive) from the state of settings, ``(A, N, V)``, as many whole steps as the longest horizon has."""
    s = settings
    length = int(np.ceil(row_horizons(s.steps, s.time_step)[-1] - 1e-9))
    return _timeline(world, world.state_index(s.state), s.acting_gamma, length)


def noiseless(study: WorldStudy) -> GammaSpace:
    """The gamma-space of a study of a world before its noise, exact or learned."""
    if not study.settings.noise:
        return study.gamma_space
    basis, space = basis_of(study) if study.learned is None else study.learned, study.gamma_space
    return encode(basis, study.world.reward_values, space.gammas, space.thetas, study.settings.slope)


def encoded_under(study: WorldStudy, policy: str) -> GammaSpace:
    """The exact gamma-space of the same state, free of noise and learning, under this target policy."""
    space = study.gamma_space
    basis = basis_of(study, policy)
    return encode(basis, study.world.reward_values, space.gammas, space.thetas, study.settings.slope)


def policies_of(world: World, gammas: np.ndarray, kind: str, acting_gamma: float) -> list[np.ndarray]:
    """Cached :func:`laplace_core.planning.target_policies`."""
    return _policies(world, gammas.tobytes(), kind, acting_gamma)


@cached(16)
def _policies(world: World, gammas: bytes, kind: str, acting_gamma: float) -> list[np.ndarray]:
    grid = np.frombuffer(gammas)
    if kind == "shared":
        return [_acting_policy(world, acting_gamma)] * grid.size
    return target_policies(world, grid, kind, acting_gamma)


@cached(16)
def _acting_policy(world: World, acting_gamma: float) -> np.ndarray:
    return greedy_policy(world, acting_gamma)


@cached(16)
def _basis(world: World, state: int, gammas: bytes, kind: str, *, acting_gamma: float) -> np.ndarray:
    basis = reward_indicator_basis(world, state, np.frombuffer(gammas), _policies(world, gammas, kind, acting_gamma))
    basis.setflags(write=False)
    return basis


@cached(16)
def _optimum(world: World, state: int, acting_gamma: float, horizon: int) -> np.ndarray:
    return finite_horizon_optimum(world, horizon, acting_gamma, state)


@cached(16)
def _timeline(world: World, state: int, acting_gamma: float, length: int) -> np.ndarray:
    return reward_timeline(world, state, _acting_policy(world, acting_gamma), length)


def _truth(
    world: World, timeline: np.ndarray, optimum: np.ndarray, thetas: np.ndarray, *, settings: ResolvedForWorld
) -> Truth:
    """The truth on the rows and columns of a study, from a timeline ``(A, N, V)`` and an optimum ``(N, A)``."""
    s, length = settings, timeline.shape[1]
    rows = on_rows(timeline, s.steps, s.time_step)
    rewards = on_rows((timeline @ world.reward_values)[..., None], s.steps, s.time_step)[..., 0]
    nearest = np.clip(np.rint(row_horizons(s.steps, s.time_step)).astype(int), 1, length)
    return Truth(
        tau_space=smeared(rows, world.reward_values, thetas, s.slope),
        survival=on_rows(timeline.sum(axis=-1, keepdims=True), s.steps, s.time_step)[..., 0],
        expected_reward=rewards,
        horizon_values=horizon_values(rewards, s.value_gamma, s.softness, s.time_step),
        scale=scale_of_values(rewards, world.reward_values),
        optimum=optimum.T[:, nearest - 1],
    )


def on_rows(values: np.ndarray, steps: int, time_step: float) -> np.ndarray:
    """Values of every step, ``(A, N, V)``, on the rows of a study, ``(A, steps, V)``: a product with the row shares.

    At ``time_step`` 1 row k is step k, and no matrix is made: on thousands of rows the identity would cost more than
    all else in a study.
    """
    length = values.shape[1]
    if time_step != 1.0:
        return row_shares(steps, length, time_step) @ values
    rows = np.zeros((len(values), steps, values.shape[2]))
    rows[:, :length] = values[:, :steps]
    return rows


def row_shares(steps: int, length: int, time_step: float) -> np.ndarray:
    """How much of step n is held by row k, shape ``(steps, length)``; the identity at ``time_step`` 1.

    Step n lies at time n, and row k at k * time_step. Where the two meet, the row holds the whole step, so that the
    true rows transform to the gamma-space exactly: sum_k gamma^(k time_step) x_k = sum_n gamma^n p_n. That is so for
    every step where 1 / time_step is a whole number. A step that falls between two rows is shared by them, linearly.
    """
    place = np.arange(length) / time_step
    first = np.floor(place + 1e-9).astype(int)
    second = np.clip(place - first, 0.0, 1.0)
    rows = np.arange(steps)[:, None]
    return (rows == first) * (1.0 - second) + (rows == first + 1) * second
