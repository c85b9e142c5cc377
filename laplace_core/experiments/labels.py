"""What is really wrong with a picture, by brute force: the ground truth for the detector.

Nothing here calls the detector; only the level from which on a thing is visible is shared with it. Each effect is
the change that turning one thing off makes, everything else kept: the study is run again without it, or the world
is rebuilt without it, or every path of the world is walked. An artefact is really there if its effect exceeds the
one visible level. Pictures are compared by reward, each midpoint counted for the reward nearest to it; what the
inverse does is judged before rows are rescaled, and without noise where another grid or operator would draw another.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np
from scipy.optimize import nnls

from laplace_core.artifacts import VISIBLE
from laplace_core.experiments.cases import Case, spacing_of
from laplace_core.learning import greedy_policy
from laplace_core.pipeline import grids, study
from laplace_core.settings import SLOPE_TIMES_SPACING, Settings
from laplace_core.worlds import END, Outcome, World

SEEN = 0.02
"""A reward that never has this chance in a row is not missed where another runs into it."""
LEAST_ALPHA = 1e-9
"""Below it a smaller alpha is nobody's choice."""


class Effects:
    """The effect of every artefact in one case, by the artefact's name: :meth:`all`."""

    def __init__(self, case: Case):
        self.case, self.world, self.action = case, case.world, case.action
        self.settings = replace(case.settings, normalise="none")  # before rescaling
        self.quiet = replace(self.settings, noise=0.0)
        self.policy = greedy_policy(case.world, case.settings.acting_gamma)

    def all(self) -> dict[str, float]:
        return {
            "repeated reward": self.invented(),
            "mixed policies": self.mixed(),
            "noise amplification": self.noise(),
            "folding": self.folded(),
            "edge clipping": self.clipped(),
            "slope blur": self.blurred(),
            "reward quantisation": self.rounded(),
            "over-smoothing": self.smeared(),
            "negative mass": self.negative(),
            "soft deadline": self.softened(),
            "constant horizon": self.constant(),
        }

    def by_reward(self, bins: np.ndarray) -> np.ndarray:
        """Midpoints ``(..., H-1)`` counted for the reward nearest to each, ``(..., V)``."""
        low, high = self.settings.theta_min, self.settings.theta_max
        edges = np.linspace(low, high, bins.shape[-1] + 1)
        counted = np.zeros((*bins.shape[:-1], self.world.reward_values.size))
        for n, middle in enumerate(0.5 * (edges[1:] + edges[:-1])):
            counted[..., np.abs(self.world.reward_values - middle).argmin()] += bins[..., n]
        return counted

    def rows(self, settings: Settings, world: World | None = None, policy: np.ndarray | None = None) -> np.ndarray:
        """The picture of the action, ``(K, H-1)``."""
        found = study(self.world if world is None else world, settings, policy)
        return found.decoded.tau_space[self.action]

    def moved(self, rows: np.ndarray, others: np.ndarray) -> float:
        """Probability that lies with another reward, or row, in the worst row: half the absolute difference."""
        return 0.5 * float(np.abs(self.by_reward(rows - others)).sum(axis=-1).max())

    @cached_property
    def timeline(self) -> dict[int, dict[float, float]]:
        """Chance of each reward at each step, by walking every path under the acting policy."""
        found: dict[int, dict[float, float]] = {}

        def walk(state: int, action: int, step: int, chance: float) -> None:
            for row in self.world.outcomes(state, action):
                at = found.setdefault(step, {})
                at[row.reward] = at.get(row.reward, 0.0) + chance * row.probability
                if row.next_state != END:
                    walk(row.next_state, int(self.policy[row.next_state]), step + 1, chance * row.probability)

        walk(int(np.argmax(self.world.start)), self.action, 0, 1.0)
        return found

    def shown(self) -> list[dict[float, float]]:
        """The true chances in each row that is decoded."""
        return [self.timeline.get(step, {}) for step in range(self.settings.steps)]

    def invented(self) -> float:
        """Probability in the picture beyond the true survival, summed over rows."""
        if self.case.settings.normalise != "paper":
            return 0.0
        mass = self.rows(self.case.settings).sum(axis=-1)
        return float(sum(max(0.0, m - sum(at.values())) for m, at in zip(mass, self.shown(), strict=True)))

    def mixed(self) -> float:
        return self.moved(self.rows(self.settings), self.rows(replace(self.settings, policy="shared")))

    def noise(self) -> float:
        return self.moved(self.rows(self.settings), self.rows(self.quiet))

    def folded(self) -> float:
        """Against a copy of the world that ends by itself after the last row."""
        steps, n = self.settings.steps, self.world.n_states
        rows = []
        for t in range(steps):
            for state in range(n):
                for action in range(self.world.n_actions):
                    for row in self.world.outcomes(state, action):
                        over = row.next_state == END or t + 1 == steps
                        goal = END if over else (t + 1) * n + row.next_state
                        rows.append(Outcome(t * n + state, action, row.probability, goal, row.reward))
        names = [f"{name} {t}" for t in range(steps) for name in self.world.states]
        start = np.concatenate([self.world.start, np.zeros(n * (steps - 1))])
        ended = World.from_outcomes("ended", names, self.world.actions, rows, start)
        settings = replace(self.quiet, policy="shared", state=str(int(np.argmax(start))))
        policy = np.tile(self.policy, steps)
        return self.moved(self.rows(settings, policy=self.policy), self.rows(settings, ended, policy))

    def clipped(self) -> float:
        """Mass that a range beyond every reward, at the same spacing and slope, adds to a row."""
        s, rewards, spacing = self.quiet, self.world.reward_values, spacing_of(self.quiet)
        over = 8.0 / s.slope
        below = max(0, int(np.ceil((s.theta_min - rewards[0] + over) / spacing)))
        above = max(0, int(np.ceil((rewards[-1] + over - s.theta_max) / spacing)))
        thetas, low, high = s.thetas + below + above, s.theta_min - below * spacing, s.theta_max + above * spacing
        wide = replace(s, thetas=thetas, theta_min=low, theta_max=high)
        return float((self.rows(wide).sum(axis=-1) - self.rows(s).sum(axis=-1)).max())

    def unit(self, reward: float, thetas: np.ndarray | None = None) -> np.ndarray:
        """What one sure reward leaves at the midpoints, ``(H-1,)``: the sigmoid as a hyperbolic tangent."""
        thetas = grids(self.settings)[1] if thetas is None else thetas
        return -np.diff(0.5 * (1.0 + np.tanh(0.5 * self.settings.slope * (reward - thetas))))

    def mean(self, reward: float, thetas: np.ndarray) -> float:
        unit = self.unit(reward, thetas)
        return float(unit @ (0.5 * (thetas[1:] + thetas[:-1])) / unit.sum())

    def blurred(self) -> float:
        """Probability in a row that lies nearer to another reward that is seen than to the one that was paid."""
        thetas = grids(self.settings)[1]
        middles = 0.5 * (thetas[1:] + thetas[:-1])
        seen = sorted({v for at in self.shown() for v, p in at.items() if p >= SEEN})
        if len(seen) < 2:
            return 0.0
        nearest = np.abs(middles[:, None] - np.array(seen)).argmin(axis=1)
        wrong = {v: float(self.unit(v)[nearest != i].sum()) for i, v in enumerate(seen)}
        return max(sum(p * wrong.get(v, 0.0) for v, p in at.items()) for at in self.shown())

    def rounded(self) -> float:
        """Shift of the rewards' means, in spacings, against a grid so fine that the same slope overlaps itself."""
        s, spacing = self.settings, spacing_of(self.settings)
        if s.slope * spacing <= SLOPE_TIMES_SPACING * 1.001:
            return 0.0
        count = int(np.ceil((s.theta_max - s.theta_min + 12.0 * spacing) * s.slope / 2.0))
        fine = np.linspace(s.theta_min - 6.0 * spacing, s.theta_max + 6.0 * spacing, count)
        off = {}
        for v in map(float, self.world.reward_values):
            whole = self.unit(v).sum() > 0.97  # at the edge of the range a reward is clipped, not rounded
            off[v] = abs(self.mean(v, grids(s)[1]) - self.mean(v, fine)) / spacing if whole else 0.0
        return max(sum(p * off[v] for v, p in at.items()) for at in self.shown())

    def smeared(self) -> float:
        """How much nearer to the truth some smaller alpha brings the picture, in shares of its probability."""
        s, units = self.settings, {}
        if s.alpha <= LEAST_ALPHA:
            return 0.0
        for v in self.world.reward_values:
            units[float(v)] = self.unit(float(v))
        true = np.zeros((s.steps, s.thetas - 1))
        for row, at in enumerate(self.shown()):
            for v, p in at.items():
                true[row] += p * units[v]

        def error(alpha: float) -> float:
            off = np.abs(self.by_reward(self.rows(replace(s, alpha=alpha)) - true)).sum()
            return float(off / max(2.0 * true.sum(), 0.1))  # hardly anything may be left inside the sensitivities

        here = error(s.alpha)
        if here <= VISIBLE:  # no fall can exceed it
            return 0.0
        return here - min(error(alpha) for alpha in np.geomspace(s.alpha, LEAST_ALPHA, 24)[1:])

    def negative(self) -> float:
        """What the inverse of the same data and alpha adds to a row's troughs if it may not go below zero."""
        if self.case.settings.normalise == "paper":
            return 0.0
        found = study(self.world, self.settings)
        rows = self.by_reward(found.decoded.tau_space[self.action])
        bounded = self._bounded(found.gamma_space.gammas, self.by_reward(found.gamma_space.differences[self.action]))
        return float((np.where(rows < 0.0, bounded, rows) - rows).sum(axis=-1).max())

    def _bounded(self, gammas: np.ndarray, Z: np.ndarray) -> np.ndarray:
        """min |F x - z|^2 + alpha^2 |x|^2 with x >= 0, one reward at a time, ``(K, V)``."""
        s = self.settings
        stacked = np.vstack([gammas[:, None] ** np.arange(s.steps), s.alpha * np.eye(s.steps)])
        rest = np.zeros(s.steps)
        return np.column_stack([nnls(stacked, np.append(z, rest))[0] for z in Z.T])

    def softened(self) -> float:
        """Largest change of a true value by the softness, as a share of the largest hard one."""
        s = self.settings
        if not s.softness:
            return 0.0
        means = [sum(v * p for v, p in at.items()) * s.acting_gamma**t for t, at in enumerate(self.shown())]
        change, largest = 0.0, 1e-12
        for T in range(1, s.steps + 1):
            hard = sum(means[:T])
            soft = sum(m / (1.0 + np.exp(-(T - 0.5 - t) / (s.softness * T))) for t, m in enumerate(means))
            change, largest = max(change, abs(soft - hard)), max(largest, abs(hard))
        return change / largest

    def constant(self) -> float:
        """Loss of an episode acted with constant T, each state decoded in a study of its own, by recursion."""
        if self.case.settings.deadline != "constant" or self.world.n_actions == 1:
            return 0.0
        s, world = replace(self.case.settings, noise=0.0), self.world
        chosen = [study(world, replace(s, state=str(state))).decoded.actions for state in range(world.n_states)]

        def collected(state: int, left: int, constant: int | None) -> float:
            if left == 0 or state == END:
                return 0.0
            action = chosen[state][(constant or left) - 1]
            return sum(
                row.probability * (row.reward + s.acting_gamma * collected(row.next_state, left - 1, constant))
                for row in world.outcomes(state, int(action))
            )

        def best(state: int, left: int) -> float:
            if left == 0 or state == END:
                return 0.0
            return max(
                sum(
                    row.probability * (row.reward + s.acting_gamma * best(row.next_state, left - 1))
                    for row in world.outcomes(state, action)
                )
                for action in range(world.n_actions)
            )

        start, horizons = int(np.argmax(world.start)), range(1, s.steps + 1)
        loss = max(collected(start, T, None) - collected(start, T, T) for T in horizons)
        return loss / max(1e-12, *(abs(best(start, T)) for T in horizons))
