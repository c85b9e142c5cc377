"""The artefacts of a picture by brute force: the ground truth for the detector.

Nothing here calls the detector; only the level from which on a thing is visible is shared with it. Each effect is
the change that turning one thing off makes, everything else kept: the study is run again without it, or the world
is rebuilt without it, or the distribution over its states is carried on step by step. An artefact is really there if
its effect exceeds the one visible level. Pictures are compared by reward, each midpoint counted for the reward nearest
to it, and with the truth by whole step; what the inverse does is judged before rows are rescaled, and without noise
where another grid or operator would draw another.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from laplace_core.code.gamma_space import encode
from laplace_core.experiments.cases import Case, Switch, spacing_of
from laplace_core.inverse import decode_matrix
from laplace_core.planning import greedy_policy, target_policies
from laplace_core.study.artefacts import VISIBLE
from laplace_core.study.pipeline import decode_and_read, grids, study
from laplace_core.study.settings import SLOPE_TIMES_SPACING, ResolvedForWorld, Settings
from laplace_core.worlds import END, Outcome, World

SEEN = 0.02
"""A reward that never has this chance in a row is not missed where another runs into it."""
LEAST_ALPHA = 1e-9
"""Below it a smaller alpha is nobody's choice."""
ROUNDING = 1e-12
"""Share of the largest mass that a row may have from which on it holds more than rounding."""


class Effects:
    """The effect of every artefact in one case, by the artefact's name: :meth:`all`."""

    def __init__(self, case: Case):
        self.case, self.world, self.action = case, case.world, case.action
        self.settings = replace(case.settings, normalise="none")  # before rescaling
        self.quiet = replace(self.settings, noise=0.0)
        self.policy = greedy_policy(case.world, case.settings.acting_gamma)

    def all(self) -> dict[str, float]:
        return {name: label.effect(self) for name, label in LABELS.items()}

    def by_reward(self, bins: np.ndarray) -> np.ndarray:
        """Midpoints ``(..., H-1)`` counted for the reward nearest to each, ``(..., V)``."""
        low, high = self.settings.theta_min, self.settings.theta_max
        edges = np.linspace(low, high, bins.shape[-1] + 1)
        counted = np.zeros((*bins.shape[:-1], self.world.reward_values.size))
        for n, middle in enumerate(0.5 * (edges[1:] + edges[:-1])):
            counted[..., np.abs(self.world.reward_values - middle).argmin()] += bins[..., n]
        return counted

    def rows(self, settings: Settings, world: World | None = None, policy: np.ndarray | None = None) -> np.ndarray:
        """The picture of the action as probability, ``(K, H-1)``."""
        result = study(self.world if world is None else world, settings, policy)
        return result.decoded.tau_space[self.action] / result.settings.time_step

    def moved(self, rows: np.ndarray, others: np.ndarray) -> float:
        """Probability that lies with another reward, or row, in the worst row: half the absolute difference."""
        return 0.5 * float(np.abs(self.by_reward(rows - others)).sum(axis=-1).max())

    def by_step(self, rows: np.ndarray) -> np.ndarray:
        """Rows as probability, gathered at the whole step that each is nearest to, as many as there are of these."""
        dt = self.settings.time_step
        steps = np.array([int(np.floor(k * dt + 0.5)) for k in range(len(rows))])
        return np.array([dt * rows[steps == n].sum(axis=0) for n in range(steps[-1] + 1)])

    @cached_property
    def held(self) -> int:
        """Number of whole steps that the rows hold."""
        s = self.settings
        return sum(1 for n in range(s.steps + 1) if n <= (s.steps - 1) * s.time_step)

    @cached_property
    def processes(self) -> tuple[np.ndarray, np.ndarray]:
        """Chances of the next state ``(A, S, S)`` and of each reward ``(A, S, V)``, outcome by outcome."""
        values, n, actions = self.world.reward_values, self.world.n_states, self.world.n_actions
        moves, pays = np.zeros((actions, n, n)), np.zeros((actions, n, values.size))
        for state in range(n):
            for action in range(actions):
                for row in self.world.outcomes(state, action):
                    pays[action, state, int(np.flatnonzero(values == row.reward)[0])] += row.probability
                    if row.next_state != END:
                        moves[action, state, row.next_state] += row.probability
        return moves, pays

    @cached_property
    def timeline(self) -> np.ndarray:
        """Chance of each reward at each whole step that the rows hold, ``(N, V)``, under the acting policy."""
        moves, pays = self.processes
        start, everywhere = int(np.argmax(self.world.start)), np.arange(self.world.n_states)
        chances, there = [pays[self.action, start]], moves[self.action, start]
        for _ in range(1, self.held):
            chances.append(there @ pays[self.policy, everywhere])
            there = there @ moves[self.policy, everywhere]
        return np.array(chances)

    def like(self, steps: np.ndarray) -> np.ndarray:
        """The timeline beside gathered steps: nothing is true of a step beyond the last row."""
        return np.concatenate([self.timeline, np.zeros((len(steps) - len(self.timeline), self.timeline.shape[1]))])

    def invented(self) -> float:
        """Probability beyond the true chances that rescaling adds, by reward, summed over the steps."""
        s = self.settings
        if self.case.settings.normalise != "paper":
            return 0.0
        result = study(self.world, s)
        rows, sizes = result.decoded.tau_space[self.action], np.abs(result.gamma_space.differences[self.action])
        largest = np.sqrt((sizes.sum(axis=1) ** 2).sum())
        rescaled = np.zeros_like(rows)
        matrix = decode_matrix(result.gamma_space.gammas, s.steps, s.alpha, s.time_step)
        for k, row in enumerate(rows):
            clipped = np.where(row > 0.0, row, 0.0)
            if clipped.sum() > ROUNDING * largest * np.sqrt((matrix[k] ** 2).sum()):
                rescaled[k] = clipped / clipped.sum()
        drawn, left = (self.by_step(self.by_reward(each)) for each in (rescaled, rows / s.time_step))
        true, total = self.like(drawn), 0.0
        for p, d, t in zip(drawn, left, true, strict=True):
            total += max(0.0, np.maximum(p - t, 0.0).sum() - np.maximum(d - t, 0.0).sum())
        return float(total)

    def conditional(self) -> float:
        """Largest change of a value between rows given survival and rows left alone, in shares of the largest true."""
        if self.case.settings.normalise != "survival":
            return 0.0
        both = [study(self.world, replace(self.case.settings, normalise=how)) for how in ("survival", "none")]
        given, alone = (result.decoded.horizon_values[self.action] for result in both)
        least = 0.01 * np.abs(self.world.reward_values).max()
        return float(np.abs(given - alone).max() / max(least, 1e-12, *np.abs(self.values(self.settings.softness))))

    def values(self, softness: float) -> list[float]:
        """True V_T of the action at the horizon of every row, the deadline hard or soft."""
        s, values, steps = self.settings, [], np.arange(self.held)
        means = (self.timeline @ self.world.reward_values) * s.acting_gamma**steps
        for k in range(s.steps):
            T = k * s.time_step + 0.5 + 0.5 * s.time_step
            if softness:
                values.append(float(means @ (0.5 + 0.5 * np.tanh((T - 0.5 - steps) / (2.0 * softness * T)))))
            else:
                values.append(float(means[steps <= k * s.time_step].sum()))
        return values

    def mixed(self) -> float:
        return self.moved(self.rows(self.settings), self.rows(replace(self.settings, policy="shared")))

    def noise(self) -> float:
        return self.moved(self.rows(self.settings), self.rows(self.quiet))

    def folded(self) -> float:
        """Against a copy of the world that ends by itself after the last row, in which all follow one policy."""
        start = int(np.argmax(self.world.start))
        states, rows, names = [(0, start)], [], []
        number = {states[0]: 0}
        for at, (t, state) in enumerate(states):  # more are added on the way
            names.append(f"{self.world.states[state]} after {t}")
            for action in range(self.world.n_actions):
                for row in self.world.outcomes(state, action if t == 0 else int(self.policy[state])):
                    after = END
                    if row.next_state != END and t + 1 < self.held:
                        if (t + 1, row.next_state) not in number:
                            number[t + 1, row.next_state] = len(states)
                            states.append((t + 1, row.next_state))
                        after = number[t + 1, row.next_state]
                    rows.append(Outcome(at, action, row.probability, after, row.reward))
        ended = World.from_outcomes("ended", names, self.world.actions, rows)
        policy = np.array([self.policy[state] for _, state in states])
        settings = replace(self.quiet.chosen(), policy="shared", state=None)
        return self.moved(self.rows(settings, policy=self.policy), self.rows(settings, ended, policy))

    def ever_paid(self) -> np.ndarray:
        """Rewards that the action may bring, sooner or later, under any of the policies that discounts follow."""
        moves, pays = self.processes
        paid = pays[self.action, int(np.argmax(self.world.start))] > 0.0
        s, everywhere = self.quiet, np.arange(self.world.n_states)
        for policy in target_policies(self.world, grids(s)[0], s.policy, s.acting_gamma):
            there = moves[self.action, int(np.argmax(self.world.start))] > 0.0
            for _ in everywhere:
                there = there | (there @ moves[policy, everywhere] > 0.0)
            paid = paid | (pays[policy, everywhere][there] > 0.0).any(axis=0)
        return self.world.reward_values[paid]

    def clipped(self) -> float:
        """Mass that a range beyond every reward of the action, at the same spacing and slope, adds to a row."""
        s, rewards, spacing = self.quiet, self.ever_paid(), spacing_of(self.quiet)
        over = 8.0 / s.slope
        below = max(0, int(np.ceil((s.theta_min - rewards[0] + over) / spacing)))
        above = max(0, int(np.ceil((rewards[-1] + over - s.theta_max) / spacing)))
        thetas, low, high = s.thetas + below + above, s.theta_min - below * spacing, s.theta_max + above * spacing
        wide = replace(s, thetas=thetas, theta_min=low, theta_max=high)
        return float((self.rows(wide).sum(axis=-1) - self.rows(s).sum(axis=-1)).max())

    def unit(self, reward: float, thetas: np.ndarray | None = None) -> np.ndarray:
        """Probability of one certain reward at the midpoints, ``(H-1,)``: the sigmoid as a hyperbolic tangent."""
        thetas = grids(self.settings)[1] if thetas is None else thetas
        return -np.diff(0.5 * (1.0 + np.tanh(0.5 * self.settings.slope * (reward - thetas))))

    def mean(self, reward: float, thetas: np.ndarray) -> float:
        unit = self.unit(reward, thetas)
        return float(unit @ (0.5 * (thetas[1:] + thetas[:-1])) / unit.sum())

    def blurred(self) -> float:
        """Probability in a row that lies nearer to another reward that is seen than to the one that was paid."""
        thetas = grids(self.settings)[1]
        middles = 0.5 * (thetas[1:] + thetas[:-1])
        values = self.world.reward_values
        seen = [i for i in range(values.size) if self.timeline[:, i].max() >= SEEN]
        if len(seen) < 2:
            return 0.0
        nearest = np.abs(middles[:, None] - values[seen]).argmin(axis=1)
        wrong = [float(self.unit(float(values[i]))[nearest != n].sum()) for n, i in enumerate(seen)]
        return max(float(sum(chance[i] * w for i, w in zip(seen, wrong, strict=True))) for chance in self.timeline)

    def rounded(self) -> float:
        """Shift of the rewards' means, in spacings, against a grid so fine that the same slope overlaps itself."""
        s, spacing = self.settings, spacing_of(self.settings)
        if s.slope * spacing <= SLOPE_TIMES_SPACING * 1.001:
            return 0.0
        count = int(np.ceil((s.theta_max - s.theta_min + 12.0 * spacing) * s.slope / 2.0))
        fine = np.linspace(s.theta_min - 6.0 * spacing, s.theta_max + 6.0 * spacing, count)
        off = []
        for v in map(float, self.world.reward_values):
            whole = self.unit(v).sum() > 0.97  # at the edge of the range a reward is clipped, not rounded
            off.append(abs(self.mean(v, grids(s)[1]) - self.mean(v, fine)) / spacing if whole else 0.0)
        return max(float(chance @ off) for chance in self.timeline)

    def smeared(self) -> float:
        """How much nearer to the truth some smaller alpha brings the picture, in shares of its probability."""
        s = self.settings
        if s.alpha <= LEAST_ALPHA:
            return 0.0
        units = np.array([self.by_reward(self.unit(float(v))) for v in self.world.reward_values])

        def error(alpha: float) -> float:
            steps = self.by_step(self.by_reward(self.rows(replace(s, alpha=alpha))))
            true = self.like(steps) @ units
            return float(np.abs(steps - true).sum() / max(2.0 * true.sum(), 0.1))  # hardly anything may be left inside

        here = error(s.alpha)
        if here <= VISIBLE:  # no fall can exceed it
            return 0.0
        near, far = np.geomspace(s.alpha, s.alpha / 100.0, 41)[1:], np.geomspace(s.alpha, LEAST_ALPHA, 24)[1:]
        return here - min(error(alpha) for alpha in (*near, *far) if alpha >= 0.999 * LEAST_ALPHA)

    def negative(self) -> float:
        """What a picture that stops at zero has more than the one that is drawn, in the worst row."""
        if self.case.settings.normalise == "paper":
            return 0.0
        rows = self.by_reward(self.rows(self.case.settings))
        return float((np.maximum(rows, 0.0) - rows).sum(axis=-1).max())

    def softened(self) -> float:
        """Largest change of a true value by the softness, as a share of the largest hard one."""
        if not self.settings.softness:
            return 0.0
        hard, soft = self.values(0.0), self.values(self.settings.softness)
        change = max(abs(b - a) for a, b in zip(hard, soft, strict=True))
        return change / max(1e-12, *map(abs, hard))

    def chosen_everywhere(self, settings: ResolvedForWorld) -> np.ndarray:
        """Action chosen in every state at the horizon of every row, ``(K, S)``, each state decoded by itself."""
        s, world, everywhere = settings, self.world, np.arange(self.world.n_states)
        (gammas, thetas), (moves, pays) = grids(s), self.processes
        bases = np.empty((world.n_states, world.n_actions, gammas.size, world.reward_values.size))
        for g, policy in enumerate(target_policies(world, gammas, s.policy, s.acting_gamma)):
            system = np.eye(world.n_states) - gammas[g] * moves[policy, everywhere]
            later = np.linalg.solve(system, pays[policy, everywhere])
            bases[:, :, g] = np.moveaxis(pays + gammas[g] * (moves @ later), 0, 1)
        spaces = (encode(basis, world.reward_values, gammas, thetas, s.slope) for basis in bases)
        return np.array([decode_and_read(space, s).actions for space in spaces]).T

    def constant(self) -> float:
        """Loss of an episode acted with constant T, each state decoded by itself, step by step."""
        if self.case.settings.deadline != "constant" or self.world.n_actions == 1:
            return 0.0
        s, world, everywhere = replace(self.case.settings, noise=0.0), self.world, np.arange(self.world.n_states)
        horizons = np.array([k * s.time_step + 0.5 + 0.5 * s.time_step for k in range(s.steps)])
        whole = range(1, int(np.floor(horizons[-1])) + 1)
        nearest = [int(np.argmin(np.abs(horizons - T))) for T in whole]
        chosen = self.chosen_everywhere(s)[nearest]
        moves, pays = self.processes
        now = pays @ world.reward_values

        def later(actions: np.ndarray, values: np.ndarray) -> np.ndarray:
            there = moves[actions, everywhere] @ values
            return now[actions, everywhere] + s.acting_gamma * there

        start, losses, best_values = int(np.argmax(world.start)), [0.0], [1e-12]
        to_go, best = np.zeros(world.n_states), np.zeros(world.n_states)
        for T in whole:
            to_go = later(chosen[T - 1], to_go)
            best = (now + s.acting_gamma * (moves @ best)).max(axis=0)
            constant = np.zeros(world.n_states)
            for _ in range(T):
                constant = later(chosen[T - 1], constant)
            losses.append(float(to_go[start] - constant[start]))
            best_values.append(abs(float(best[start])))
        return max(losses) / max(best_values)


@dataclass(frozen=True)
class Label:
    """The ground truth of one artefact: the switch that causes it, and the measure of its effect.

    Attributes:
        effect: the change that turning the artefact off makes, in the unit of the artefact's size.
        switch: of the cases, meant for this artefact; others may bring it about as well.
        throw: what that switch does, where it is none of :data:`laplace_core.experiments.cases.SWITCHES`.
    """

    effect: Callable[[Effects], float]
    switch: str
    throw: Switch | None = None


LABELS: dict[str, Label] = {
    "repeated reward": Label(Effects.invented, "rescaling"),
    "conditional rewards": Label(Effects.conditional, "conditional"),
    "mixed policies": Label(Effects.mixed, "per gamma"),
    "noise amplification": Label(Effects.noise, "noise"),
    "folding": Label(Effects.folded, "few rows"),
    "edge clipping": Label(Effects.clipped, "narrow edges"),
    "slope blur": Label(Effects.blurred, "blur"),
    "reward quantisation": Label(Effects.rounded, "quantisation"),
    "over-smoothing": Label(Effects.smeared, "smearing"),
    "negative mass": Label(Effects.negative, "ringing"),
    "soft deadline": Label(Effects.softened, "softness"),
    "constant horizon": Label(Effects.constant, "constant"),
}
"""The true effect of every artefact, by the name of :data:`laplace_core.study.artefacts.MEASURES`."""
OWN_SWITCHES: dict[str, Switch] = {label.switch: label.throw for label in LABELS.values() if label.throw is not None}
"""Switches that are stated here and not with the cases."""
