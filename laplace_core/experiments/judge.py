"""An independent judge of verdicts: the same definitions, written a second time in the plain and slow way.

Nothing here calls the line from world to action that verdicts are made by: no pipeline, no learning, no inverse, no
reading, no artefacts. Only the world's table, the record of settings, the seeded noise (which has to be the same
numbers) and the one exception are shared. Matrices are dense, processes are stepped through, the inverse is a full SVD.

A view is judged by these numbers, all at the column k that lies nearest to the horizon T:

- decoded V[a]: the rows of tau-space are decoded, normalised, and read under the deadline of the settings.
- true V[a]: the true rewards a row, read in the same way. Step n lies whole on the row n / time_step; between two rows
  it is shared between them linearly. Hard true V[a] is the same without softness.
- optimum[a]: backward induction at acting_gamma over the nearest whole number of steps.

Decisions where the definition leaves a choice:

- A set of states in which nothing but 0 is ever paid and from which no episode can end, whatever is done, is the end:
  who enters it is over. In a start state of this kind one step is still counted.
- Policies tie by the same rule as values do; the scale is the largest |Q| of the world at that discount.
- The scale of decoded values is the largest sum of their terms, and at least the largest midpoint: those terms are made
  of midpoints.
- With time_step < 1 both sides of the timeline error are gathered by whole step and divided by time_step, so that this
  matters for the floor of 0.05 only. Rescaling by survival takes place before gathering, in both.
- On a fresh seed a wrong choice is repaired if it is not wrong under the change and the error is smaller than that of
  the unchanged settings on the same seed. What else is to be repaired has to hold on the fresh seeds in full, the
  timeline too.
- steps times 2, 4, 8 and so on stop at 2,000: what exceeds it is tried as 2,000.
- Widened sensitivities keep an end that already overhangs; their number grows in proportion to the range, rounded up.
- The steep slope never lowers thetas.
- time_step 1 keeps as many steps as reach the last horizon of the finer rows.
- Where nothing is to be repaired, nothing repairs.
- With steps used, the best action, the true values and the decoded ones are those of the steps that are left; an agent
  with a constant horizon still reads its values at T.
- Rows that `fold` leaves out hold nothing: what truly comes there counts as misplaced in the timeline.
- The discount of the values weighs decoded and true values. The error that a repair has to lower is against true values
  at acting_gamma, as the best action is.
- Under `clip` a reward occurs if it comes with a chance above 1e-9 at some step up to the last horizon, after some
  action.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from statistics import NormalDist
from typing import Any, Literal

import numpy as np

from laplace_core.code.noise import normal_noise
from laplace_core.errors import InputError
from laplace_core.experiments.views import View
from laplace_core.study.settings import ResolvedForWorld
from laplace_core.worlds import END, PRESETS, World, load_world

OFF = 0.1
SOUND, SMEARED = 0.1, 1.0 / 3.0
FRESH_SEEDS = tuple(1_600_000_033 + 7_919 * n for n in range(10))
LEAST_HELD = 9
MOST_STEPS, MOST_THETAS, MOST_GAMMAS, MOST_NUMBERS = 2_000, 2_000, 500, 50_000_000
MOST_FOLDED = 200_000_000
ALPHAS = tuple(float(f"{a:.2g}") for a in np.geomspace(1e-9, 10.0, 60))
PAPER = (0.01, 0.108, 0.206, 0.304, 0.402, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.81, 0.87, 0.93, 0.99)
EPSILON = 2.0**-52

Choice = Literal["right", "off", "wrong"]
Change = tuple[tuple[str, object], ...]
"""A change of settings as sorted pairs, so that it can be the key of a dictionary."""


@dataclass(frozen=True)
class Judged:
    """The judge's findings on a view.

    Attributes:
        choice: ``wrong``: another action is better; ``off``: a best action on values that are off; else ``right``.
        error: largest |decoded - hard true| value, in reward.
        value_error: largest |decoded - true| value as a share of the largest true one.
        timeline_errors, grades: one an action.
    """

    chosen: int
    best: int
    choice: Choice
    error: float
    value_error: float
    timeline_errors: tuple[float, ...]
    grades: tuple[str, ...]

    def needs_repair(self, action: int) -> bool:
        """Whether there is anything to repair in the choice, the values or the timeline of an action."""
        return self.choice != "right" or self.grades[action] != "sound"


Fault = Callable[[Judged, Judged], str | None]
"""The fault of a view under a change, given the view before it; None if there is none."""


def grade(timeline_error: float) -> str:
    return "sound" if timeline_error <= SOUND else "smeared" if timeline_error <= SMEARED else "ruined"


def judge_view(view: View) -> Judged:
    """Choice, values and timelines of a view.

    Raises:
        InputError: settings that make no grid or are too large.
    """
    return Judge(view).judged


def repairs(view: View, changes: Mapping[str, Any]) -> bool:
    """Whether a change of settings repairs what is wrong with a view, and on fresh noise too."""
    return Judge(view).repairs(changes)


def every_single_setting(view: View, *, until_one: bool = False) -> dict[Change, bool]:
    """Whether each change of one setting repairs the view; ``until_one`` stops at the first that does."""
    return Judge(view).every_single_setting(until_one=until_one)


class Judge:
    """One view and all that was computed for it; a memory of solves and singular values, no more."""

    def __init__(self, view: View):
        self.view = view
        self.horizon = _horizons(view.settings)[view.row]
        self._memory: dict[tuple[object, ...], object] = {}
        self.judged = self._judge(view.settings, self.horizon)
        self.action = self.judged.chosen if view.action is None else view.action

    # --- what repairs ---

    def repairs(self, changes: Mapping[str, Any]) -> bool:
        """Whether the change repairs, by the definition for what is wrong with the view."""
        return self.objection(changes) is None

    def objection(self, changes: Mapping[str, Any]) -> str | None:
        """Why the change does not repair the view, in a few words; None where it does."""
        if not self.judged.needs_repair(self.action):
            return "nothing is to be repaired"
        return self._objection(changes, self._unmended)

    def harm(self, changes: Mapping[str, Any]) -> str | None:
        """The harm of a change to a view in which nothing is to be repaired, in a few words; None if there is none."""
        return self._objection(changes, self._unsound)

    def share_held(self, changes: Mapping[str, Any], seeds: int) -> float:
        """Share of noise seeds, other than those that decide, on which the change repairs; to look into a case."""
        settings = self._changed(changes)
        others = [1_900_000_007 + 104_729 * n for n in range(seeds)]
        return sum(self._on_seed(settings, seed, self._unmended) is None for seed in others) / seeds

    def _objection(self, changes: Mapping[str, Any], fault: Fault) -> str | None:
        """The fault of the view under a change: on its own noise first, then on more than one of the fresh seeds."""
        settings = self._changed(changes)
        try:
            if _horizons(settings)[-1] < self.horizon - 1e-9:
                return "its last horizon does not reach T"
            objection = fault(self._judge(settings, self.horizon), self.judged)
        except InputError as error:
            return f"refused: {error}"
        if objection or not settings.noise:
            return objection
        held = []
        for seed in FRESH_SEEDS:
            held.append(self._on_seed(settings, seed, fault) is None)
            if held.count(False) > len(FRESH_SEEDS) - LEAST_HELD:
                return f"fails on {held.count(False)} of {len(held)} fresh seeds"
        return None

    def _on_seed(self, settings: ResolvedForWorld, seed: int, fault: Fault) -> str | None:
        """The fault of settings on another noise, beside the unchanged view on the same noise."""
        before = self._once(
            ("before", seed), lambda: self._judge(replace(self.view.settings, noise_seed=seed), self.horizon)
        )
        return fault(self._judge(replace(settings, noise_seed=seed), self.horizon), before)

    def _unmended(self, judged: Judged, before: Judged) -> str | None:
        """The fault of the view that is left under a change; ``before`` has the error to compare with."""
        if judged.choice == "wrong":
            return "the choice is wrong"
        if self.judged.choice == "wrong":
            larger = judged.error >= before.error * (1.0 - 1e-6)
            return f"the error is {judged.error:.4g}, not below {before.error:.4g}" if larger else None
        return self._off(judged) if self.judged.choice == "off" else self._unsound(judged, before)

    def _off(self, judged: Judged) -> str | None:
        return f"the value error is {judged.value_error:.6g}" if judged.value_error > OFF else None

    def _unsound(self, judged: Judged, before: Judged) -> str | None:
        if judged.choice == "wrong":
            return "the choice is wrong"
        error = judged.timeline_errors[self.action]
        return self._off(judged) or (f"the timeline error is {error:.6g}" if error > SOUND else None)

    def _changed(self, changes: Mapping[str, Any]) -> ResolvedForWorld:
        fields = {name: value for name, value in changes.items() if not name.startswith("param:")}
        params = dict(self.view.settings.params)
        for name, value in changes.items():
            if name.startswith("param:"):
                params[name.removeprefix("param:")] = value
        return replace(self.view.settings, params=tuple(sorted(params.items())), **fields)

    def every_single_setting(self, *, until_one: bool = False) -> dict[Change, bool]:
        results: dict[Change, bool] = {}
        for changes in single_settings(self.view, self._thetas(self.view.world, self.view.settings)):
            results[tuple(sorted(changes.items()))] = repaired = self.repairs(changes)
            if repaired and until_one:
                break
        return results

    # --- the numbers of a view ---

    def _judge(self, s: ResolvedForWorld, horizon: float) -> Judged:
        _check(s, self.view.world.n_actions)
        world = self._world(s)
        dense = self._dense(world)
        state = world.state_index(s.state)
        horizons = _horizons(s)
        read, left = _columns(s, horizon)
        weights = _deadline(s, horizons[read], s.softness, s.value_gamma)
        true_weights = _deadline(s, horizons[left], s.softness, s.value_gamma)
        hard = _deadline(s, horizons[left], 0.0, s.acting_gamma)
        true_rows = self._true_rows(world, state, s)
        decoded = self._decoded(world, state, s, read + 1 if s.fold else s.steps)
        each_value, sizes, errors = [], [], []
        for action in range(world.n_actions):
            rewards, by_reward = decoded[action]
            each_value.append(float(weights @ rewards))
            sizes.append(float(np.abs(weights * rewards).sum()))
            errors.append(self._timeline_error(world, s, by_reward, true_rows[action]))
        values = np.array(each_value)
        true_rewards = true_rows @ dense.rewards
        true, hard_true = true_rewards @ true_weights, true_rewards @ hard
        optimum = self._optimum(world, state, s.acting_gamma, max(1, round(float(horizons[left]))))
        thetas = self._thetas(world, s)
        largest = float(np.abs((thetas[:-1] + thetas[1:]) / 2.0).max())
        chosen = _first_best(values, max(*sizes, largest))
        best = _first_best(optimum, float(np.abs(optimum).max()))
        wrong = optimum[chosen] < optimum.max() - _tie(optimum.max(), np.abs(optimum).max())
        error = float(np.abs(values - hard_true).max())
        off_by = float(np.abs(values - true).max())
        value_scale = max(float(np.abs(true).max()), 1e-2 * float(np.abs(dense.rewards).max()))
        value_error = off_by / value_scale if value_scale else (0.0 if off_by <= 1e-12 else math.inf)
        choice: Choice = "wrong" if wrong else "off" if value_error > OFF else "right"
        return Judged(
            chosen, best, choice, error, value_error, tuple(errors), tuple(grade(error) for error in errors)
        )  # fmt: skip

    def _world(self, s: ResolvedForWorld) -> World:
        """The view's world, or the preset under other parameters."""
        world = self.view.world
        if not world.source or dict(s.params) == dict(world.params):
            return world
        return self._once(("world", s.params), lambda: load_world(world.source, dict(s.params)))

    def _dense(self, world: World) -> _Dense:
        return self._once(("dense", id(world)), lambda: _Dense(world))

    def _once(self, key: tuple[object, ...], compute: Callable[[], Any]) -> Any:
        if key not in self._memory:
            self._memory[key] = compute()
        return self._memory[key]

    # --- truth ---

    def _optimum(self, world: World, state: int, gamma: float, steps: int) -> np.ndarray:
        """Q*_T(state, a), ``(A,)``."""
        dense = self._dense(world)

        def compute() -> np.ndarray:
            later = np.zeros(world.n_states)
            for _ in range(steps):
                q = np.array([now + gamma * moves @ later for now, moves in zip(dense.paid, dense.moves, strict=True)])
                later = q.max(axis=0)
            return q[:, state]

        return self._once(("optimum", id(world), state, gamma, steps), compute)

    def _true_rows(self, world: World, state: int, s: ResolvedForWorld) -> np.ndarray:
        """P(r = v, alive) on every row, ``(A, K, V)``, after each action and then the acting policy."""
        dense = self._dense(world)

        def compute() -> np.ndarray:
            policy = self._policy(world, s.acting_gamma)
            moves, pays = dense.under(policy)
            rows = np.zeros((world.n_actions, s.steps, dense.rewards.size))
            for action in range(world.n_actions):
                paid, where = dense.pays[action][state], dense.moves[action][state]
                step = 0
                while True:
                    place = round(step / s.time_step, 9)
                    row = math.floor(place)
                    if row >= s.steps:
                        break
                    share = place - row
                    rows[action, row] += (1.0 - share) * paid
                    if share and row + 1 < s.steps:
                        rows[action, row + 1] += share * paid
                    paid, where = where @ pays, where @ moves
                    step += 1
            return rows

        return self._once(("rows", id(world), state, s.acting_gamma, s.steps, s.time_step), compute)

    def _policy(self, world: World, gamma: float) -> np.ndarray:
        """The best policy at one discount by policy iteration; of tied actions the lowest, int ``(S,)``."""
        dense = self._dense(world)

        def compute() -> np.ndarray:
            policy = np.zeros(world.n_states, dtype=int)
            everywhere = np.arange(world.n_states)
            for _ in range(100 + 10 * world.n_states):
                moves, pays = dense.under(policy)
                values = np.linalg.solve(np.eye(world.n_states) - gamma * moves, pays @ dense.rewards)
                q = np.array([now + gamma * m @ values for now, m in zip(dense.paid, dense.moves, strict=True)])
                largest = np.abs(q).max()
                ties = np.array([_tie(best, largest) for best in q.max(axis=0)])
                lowest = np.argmax(q >= q.max(axis=0) - ties, axis=0)
                better = q.max(axis=0) - q[policy, everywhere] > ties
                if not better.any():
                    return lowest
                policy = np.where(better, lowest, policy)
            raise ArithmeticError(f"policy iteration at gamma {gamma:g} did not end")

        return self._once(("policy", id(world), gamma), compute)

    # --- gamma-space and tau-space ---

    def _basis(self, world: World, state: int, gammas: tuple[float, ...], s: ResolvedForWorld) -> np.ndarray:
        """Expected discounted count of each reward, ``(A, G, V)``."""
        dense = self._dense(world)

        def compute() -> np.ndarray:
            basis = np.zeros((world.n_actions, len(gammas), dense.rewards.size))
            for g, gamma in enumerate(gammas):
                policy = self._policy(world, s.acting_gamma if s.policy == "shared" else gamma)
                moves, pays = dense.under(policy)
                later = np.linalg.solve(np.eye(world.n_states) - gamma * moves, pays)
                for action in range(world.n_actions):
                    basis[action, g] = dense.pays[action][state] + gamma * dense.moves[action][state] @ later
            return basis

        return self._once(("basis", id(world), state, gammas, s.policy, s.acting_gamma), compute)

    def gamma_space(self, s: ResolvedForWorld) -> tuple[np.ndarray, np.ndarray]:
        """Q with its noise, ``(A, G, H)``, and the constant channel, ``(A, G)``."""
        world = self._world(s)
        return self._gamma_space(world, world.state_index(s.state), s)

    def _gamma_space(self, world: World, state: int, s: ResolvedForWorld) -> tuple[np.ndarray, np.ndarray]:
        gammas, thetas = discounts(s), self._thetas(world, s)
        basis = self._basis(world, state, tuple(gammas), s)
        values = basis @ sigmoid(s.slope * np.subtract.outer(self._dense(world).rewards, thetas))
        constant = basis.sum(axis=2)
        if s.noise:
            drawn = self._once(
                ("noise", s.noise_seed, values.shape),
                lambda: normal_noise(s.noise_seed, (values.size + constant.size,)),
            )
            deviation = s.noise / (1.0 - np.array(gammas))
            values = values + deviation[:, None] * drawn[: values.size].reshape(values.shape)
            constant = constant + deviation * drawn[values.size :].reshape(constant.shape)
        return values, constant

    def _thetas(self, world: World, s: ResolvedForWorld) -> np.ndarray:
        """The thresholds, ``(H,)``; under ``clip`` they begin at the lowest reward that occurs, if there is room."""
        if not s.clip:
            return sensitivities(s)
        lowest = self._lowest_reward(world, s)
        if lowest is None or not s.theta_min < lowest < s.theta_max:
            return sensitivities(s)
        return sensitivities(replace(s, theta_min=lowest))

    def _lowest_reward(self, world: World, s: ResolvedForWorld) -> float | None:
        """The lowest reward that comes with a chance above 1e-9 at some step; None if there is none."""
        dense, state = self._dense(world), world.state_index(s.state)

        def compute() -> float | None:
            moves, pays = dense.under(self._policy(world, s.acting_gamma))
            occurs: set[float] = set()
            for action in range(world.n_actions):
                paid, where = dense.pays[action][state], dense.moves[action][state]
                for _ in range(math.ceil(_horizons(s)[-1] - 1e-9)):
                    occurs |= {float(r) for r, chance in zip(dense.rewards, paid, strict=True) if chance > 1e-9}
                    paid, where = where @ pays, where @ moves
            return min(occurs, default=None)

        return self._once(("lowest", id(world), state, s.acting_gamma, s.steps, s.time_step), compute)

    def decode_matrix(self, s: ResolvedForWorld, rows: int | None = None) -> np.ndarray:
        """V diag(s / (s^2 + alpha^2)) U^T, ``(rows, G)``, without the components that are rounding."""
        gammas, rows = discounts(s), s.steps if rows is None else rows

        def factors() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
            transform = np.array([[gamma ** (row * s.time_step) for row in range(rows)] for gamma in gammas])
            return np.linalg.svd(transform, full_matrices=False)

        U, sizes, Vt = self._once(("svd", tuple(gammas), rows, s.time_step), factors)
        used = sizes > max(len(gammas), rows) * EPSILON * sizes[0]
        back = np.array(
            [size / (size**2 + s.alpha**2) if keep else 0.0 for size, keep in zip(sizes, used, strict=True)]
        )
        return Vt.T @ np.diag(back) @ U.T

    def rows(self, s: ResolvedForWorld) -> tuple[np.ndarray, np.ndarray]:
        """Tau-space and the decoded survival, ``(A, K, H-1)`` and ``(A, K)``: as many rows as are drawn."""
        values, constant = (_shifted(each) if s.shift else each for each in self.gamma_space(s))
        inverse = self.decode_matrix(s, _columns(s, self.horizon)[0] + 1 if s.fold else s.steps)
        drawn = [
            _normalised(inverse, q[:, :-1] - q[:, 1:], inverse @ c, s) for q, c in zip(values, constant, strict=True)
        ]
        return np.array(drawn), np.array([inverse @ c for c in constant])

    def _decoded(
        self, world: World, state: int, s: ResolvedForWorld, rows: int | None = None
    ) -> list[tuple[np.ndarray, np.ndarray]]:
        """Of each action the expected reward a row, ``(K,)``, and the rows gathered by reward, ``(K, V)``.

        Only the first ``rows`` are decoded, the others are 0. Rows that are not clipped are gathered before they are
        decoded, which is the same and far less work.
        """
        thetas = self._thetas(world, s)
        midpoints = (thetas[:-1] + thetas[1:]) / 2.0
        gathering = np.column_stack([midpoints, self._nearest(world, thetas)])
        values, constant = self._gamma_space(world, state, s)
        if s.shift:
            values, constant = _shifted(values), _shifted(constant)
        inverse, actions = self.decode_matrix(s, rows), []
        for q, c in zip(values, constant, strict=True):
            differences = q[:, :-1] - q[:, 1:]
            if s.normalise == "paper":
                read = _normalised(inverse, differences, inverse @ c, s) @ gathering
            else:
                read = _normalised(inverse, differences @ gathering, inverse @ c, s)
            whole = np.zeros((s.steps, read.shape[1]))
            whole[: len(read)] = read
            actions.append((whole[:, 0], whole[:, 1:]))
        return actions

    def _nearest(self, world: World, thetas: np.ndarray) -> np.ndarray:
        """Which of the world's rewards is nearest to each midpoint, one-hot ``(H-1, V)``; the lower one if none is."""
        rewards = self._dense(world).rewards
        midpoints = (thetas[:-1] + thetas[1:]) / 2.0
        gathering = np.zeros((midpoints.size, rewards.size))
        gathering[np.arange(midpoints.size), np.abs(midpoints[:, None] - rewards).argmin(axis=1)] = 1.0
        return gathering

    def _timeline_error(
        self, world: World, s: ResolvedForWorld, by_reward: np.ndarray, true: np.ndarray
    ) -> float:  # fmt: skip
        thetas = self._thetas(world, s)
        tails = sigmoid(s.slope * np.subtract.outer(self._dense(world).rewards, thetas))
        seeing = (tails[:, :-1] - tails[:, 1:]) @ self._nearest(world, thetas)
        if (true @ seeing).sum() < 0.05 * true.sum():  # the picture lies beside what comes
            return 1.0
        if s.normalise == "survival":
            alive = true.sum(axis=1, keepdims=True)
            true = np.where(alive > 0.05, true / np.where(alive > 0.05, alive, 1.0), 0.0)
        seen = true @ seeing
        if s.time_step < 1.0:
            by_reward, seen = _by_step(by_reward, s.time_step), _by_step(seen, s.time_step)
        return float(0.5 * np.abs(by_reward - seen).sum() / max(float(seen.sum()), 0.05))


class _Dense:
    """The table of a world as dense matrices, one an action; entering states that never pay or end is the end."""

    def __init__(self, world: World):
        table = [
            (int(s), int(a), float(p), int(n), float(r))
            for s, a, p, n, r in zip(
                world.state, world.action, world.probability, world.next_state, world.reward, strict=True
            )
            if p > 0.0
        ]
        over = _idle_for_ever(world.n_states, table)
        self.rewards = np.array(sorted({float(r) for r in world.reward}))
        column = {reward: v for v, reward in enumerate(self.rewards)}
        self.moves = np.zeros((world.n_actions, world.n_states, world.n_states))
        self.pays = np.zeros((world.n_actions, world.n_states, self.rewards.size))
        for state, action, p, following, reward in table:
            self.pays[action, state, column[reward]] += p
            if following != END and following not in over:
                self.moves[action, state, following] += p
        self.paid = self.pays @ self.rewards

    def under(self, policy: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Moves ``(S, S)`` and chances of each reward ``(S, V)`` under a policy."""
        everywhere = np.arange(policy.size)
        return self.moves[policy, everywhere], self.pays[policy, everywhere]


def _idle_for_ever(states: int, table: list[tuple[int, int, float, int, float]]) -> set[int]:
    """The states from which nothing but 0 is ever paid and no episode ends, whatever is done."""
    idle = set(range(states))
    while True:
        leaves = {s for s, _, _, following, reward in table if s in idle and (reward or following not in idle)}
        if not leaves:
            return idle
        idle -= leaves


# --- grids, reading and rescaling ---


def discounts(s: ResolvedForWorld) -> list[float]:
    """The discounts of resolved settings, in increasing order."""
    if s.spacing == "paper" or s.paper_grid:
        return list(PAPER)
    n, low, high = s.gammas, s.gamma_min, s.gamma_max
    if not 0.0 < low < high < 1.0:
        raise InputError(f"discounts from {low:g} to {high:g} are no grid: gamma-min must be below gamma-max.")
    places = [i / (n - 1) for i in range(n)]
    if s.spacing == "linear":
        grid = [low + (high - low) * x for x in places]
    elif s.spacing == "inverse-log":  # evenly spaced in 1 / log gamma
        a, b = 1.0 / math.log(low), 1.0 / math.log(high)
        grid = [math.exp(1.0 / (a + (b - a) * x)) for x in places]
    else:  # time constants -1 / log gamma in a geometric series
        a, b = -1.0 / math.log(low), -1.0 / math.log(high)
        grid = [math.exp(-1.0 / (a * (b / a) ** x)) for x in places]
    grid[0], grid[-1] = low, high
    return grid


def sensitivities(s: ResolvedForWorld) -> np.ndarray:
    """The thresholds of resolved settings, ``(H,)``, in increasing order."""
    n, low, high = s.thetas, s.theta_min, s.theta_max
    if not low < high:
        raise InputError(f"sensitivities from {low:g} to {high:g} are no grid: theta-min must be below theta-max.")
    places = [i / (n - 1) for i in range(n)]
    if s.theta_spacing == "uniform":
        grid = [low + (high - low) * x for x in places]
    elif s.theta_spacing == "asinh":  # evenly spaced in asinh(theta / unit)
        unit = s.theta_scale or max(abs(low), abs(high)) / 100.0
        a, b = math.asinh(low / unit), math.asinh(high / unit)
        grid = [unit * math.sinh(a + (b - a) * x) for x in places]
    else:  # at evenly spaced quantiles of a normal law in the middle, cut at both ends
        law = NormalDist((low + high) / 2.0, s.theta_scale or (high - low) / 4.0)
        a, b = law.cdf(low), law.cdf(high)
        grid = [law.inv_cdf(a + (b - a) * x) for x in places]
    grid[0], grid[-1] = low, high
    return np.array(grid)


def sigmoid(x: np.ndarray) -> np.ndarray:
    below = np.exp(np.minimum(x, 0.0))
    above = np.exp(-np.maximum(x, 0.0))
    return np.where(x < 0.0, below / (1.0 + below), 1.0 / (1.0 + above))


def _horizons(s: ResolvedForWorld) -> np.ndarray:
    return np.array([row * s.time_step + (1.0 + s.time_step) / 2.0 for row in range(s.steps)])


def _columns(s: ResolvedForWorld, horizon: float) -> tuple[int, int]:
    """The column whose value is read for a horizon T, and that of the steps that are left of it."""
    horizons = _horizons(s)
    left = _nearest_column(horizons, max(0.0, horizon - s.used))
    return (_nearest_column(horizons, horizon) if s.deadline == "constant" else left), left


def _nearest_column(horizons: np.ndarray, horizon: float) -> int:
    """The first of the columns whose horizons are nearest to one."""
    return min(range(len(horizons)), key=lambda column: abs(float(horizons[column]) - horizon))


def _shifted(values: np.ndarray) -> np.ndarray:
    """Values of every action at the discount before it, ``(A, G, ...)``; nothing at the first."""
    moved = np.zeros_like(values)
    for g in range(1, values.shape[1]):
        moved[:, g] = values[:, g - 1]
    return moved


def _deadline(s: ResolvedForWorld, horizon: float, softness: float, gamma: float) -> np.ndarray:
    """Discount times deadline on every row, ``(K,)``; hard: the rows whose time lies before T - 1/2."""
    times = np.array([row * s.time_step for row in range(s.steps)])
    if softness == 0.0:
        counted = (times < horizon - 0.5 - 1e-9).astype(float)
    else:
        counted = sigmoid((horizon - 0.5 - times) / (softness * horizon))
    return counted * gamma**times


def _normalised(inverse: np.ndarray, differences: np.ndarray, survival: np.ndarray, s: ResolvedForWorld) -> np.ndarray:
    """Decoded rows of one action, rescaled as the settings say, ``(K, n)``; for ``paper`` n has to be H - 1."""
    rows = inverse @ differences
    if s.normalise == "none":
        return rows
    if s.normalise == "survival":
        alive = survival[:, None] / s.time_step
        return np.where(alive > 0.05, rows / np.where(alive > 0.05, alive, 1.0), 0.0)
    clipped = np.maximum(rows, 0.0)
    sizes = np.abs(differences).sum(axis=1)
    floor = 1e-12 * np.sqrt((inverse**2).sum(axis=1)) * math.sqrt(float((sizes**2).sum()))
    for row, mass in enumerate(clipped.sum(axis=1)):
        clipped[row] = s.time_step * clipped[row] / mass if mass > floor[row] else 0.0
    return clipped


def _by_step(rows: np.ndarray, time_step: float) -> np.ndarray:
    """Rows gathered at the whole step that each lies nearest to, ``(N, V)``, divided by the time step."""
    steps = [math.floor(row * time_step + 0.5 + 1e-9) for row in range(len(rows))]
    gathered = np.zeros((steps[-1] + 1, rows.shape[1]))
    for row, step in enumerate(steps):
        gathered[step] += rows[row] / time_step
    return gathered


def _tie(best: float, scale: float) -> float:
    return max(1e-9 * abs(best), 1e-12 * scale)


def _first_best(values: np.ndarray, scale: float) -> int:
    return int(np.flatnonzero(values >= values.max() - _tie(values.max(), scale))[0])


def _check(s: ResolvedForWorld, actions: int) -> None:
    """Refuses what no study holds.

    Raises:
        InputError: more steps, thetas or gammas than the largest study has.
    """
    if s.steps > MOST_STEPS or s.thetas > MOST_THETAS or s.gammas > MOST_GAMMAS:
        raise InputError(f"a study holds at most {MOST_STEPS} steps, {MOST_THETAS} thetas and {MOST_GAMMAS} gammas.")
    if s.fold:
        columns = actions * (s.thetas if s.normalise == "paper" else 2)
        if s.steps**2 * (len(discounts(s)) ** 2 + columns) > MOST_FOLDED:
            raise InputError(f"the inverses of all horizons may hold at most {MOST_FOLDED:,} numbers.")


# --- the single settings ---


def single_settings(view: View, thetas: np.ndarray | None = None) -> Iterator[dict[str, Any]]:
    """Every change of one setting that is tried, the cheap ones first; changes that change nothing are left out.

    Args:
        thetas: the thresholds of the view, ``(H,)``, where they are not those of its settings alone.
    """
    s, world = view.settings, view.world
    simple = (
        ("normalise", "none"), ("policy", "shared"), ("noise", 0.0), ("softness", 0.0), ("theta_spacing", "uniform"),
        ("fold", False), ("shift", False), ("clip", False), ("value_gamma", s.acting_gamma),
        *((("deadline", "time_to_go"),) if s.used else ()),
    )  # fmt: skip
    for name, value in simple:
        if getattr(s, name) != value:
            yield {name: value}
    preset = PRESETS.get(world.source)
    if preset and any(p.name == "auxiliary" for p in preset.parameters) and not dict(s.params).get("auxiliary", False):
        yield {"param:auxiliary": True}
    yield from _reward_axis(s, np.unique(world.reward), sensitivities(s) if thetas is None else thetas)
    yield from _discount_axis(s)
    if s.time_step < 1.0:
        yield {"time_step": 1.0, "steps": math.ceil(_horizons(s)[-1] - 1e-9)}
    for alpha in ALPHAS:
        if alpha != s.alpha:
            yield {"alpha": alpha}
    for steps in () if s.fold else dict.fromkeys(min(MOST_STEPS, s.steps * 2**doublings) for doublings in range(1, 12)):
        most = world.n_actions * s.thetas * max(s.gammas, steps)
        if steps > s.steps and most <= MOST_NUMBERS:
            yield {"steps": steps}


def _reward_axis(s: ResolvedForWorld, rewards: np.ndarray, grid: np.ndarray) -> Iterator[dict[str, Any]]:
    over = max(0.2 * float(rewards[-1] - rewards[0]), 8.0 / s.slope)
    low, high = min(s.theta_min, float(rewards[0]) - over), max(s.theta_max, float(rewards[-1]) + over)
    if low < s.theta_min or high > s.theta_max:
        thetas = math.ceil((s.thetas - 1) * (high - low) / (s.theta_max - s.theta_min) - 1e-9) + 1
        yield {"theta_min": low, "theta_max": high, "thetas": min(MOST_THETAS, max(s.thetas, thetas))}
    gentle = 2.35 / float(np.diff(grid).max())
    if s.slope > 1.1 * gentle:
        yield {"slope": gentle}
    if rewards.size > 1:
        steep = 9.0 / float(np.diff(rewards).min())
        if s.slope < steep:
            thetas = math.ceil((s.theta_max - s.theta_min) * steep / 2.35) + 1
            yield {"slope": steep, "thetas": min(MOST_THETAS, max(s.thetas, thetas))}


def _discount_axis(s: ResolvedForWorld) -> Iterator[dict[str, Any]]:
    if s.paper_grid:
        yield {"paper_grid": False}
        return
    for spacing in ("inverse-log", "log", "linear", "paper"):
        if spacing != s.spacing:
            yield {"spacing": spacing}
    if s.spacing == "paper":
        return
    for factor in (2, 4):
        if s.gammas * factor <= MOST_GAMMAS:
            yield {"gammas": s.gammas * factor}
    for name, choices in (("gamma_min", (0.01, 0.1, 0.3)), ("gamma_max", (0.99, 0.995, 0.999))):
        for value in choices:
            if value != getattr(s, name):
                yield {name: value}
