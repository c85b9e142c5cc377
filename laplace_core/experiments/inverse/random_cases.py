"""Cases of the study of the inverse: a world, a state, a policy, and how it is encoded, with its exact timeline.

Chains, branches, trees, cycles, grids, endless worlds, hundreds of steps, dozens of rewards, chance in worlds and in
policies, and rows that lie closer than steps.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from laplace_core.code.encoding import activation
from laplace_core.code.gamma_space import GammaSpace, bin_differences, bin_values, encode, with_noise
from laplace_core.experiments.case_worlds import lasting_world, rich_world, short_world
from laplace_core.inverse.problem import Problem, problem_of
from laplace_core.planning import greedy_policy, reward_indicator_basis, reward_timeline
from laplace_core.study.horizon import horizon_values, row_horizons
from laplace_core.study.pipeline import grids, row_shares
from laplace_core.study.settings import ResolvedForWorld, Settings, resolve
from laplace_core.worlds import World, load_world

MOST_ROWS = 400
LEAST_NOISE = 1e-9
"""Standard deviation of (1 - gamma) Q that stands for no noise: a deviation must be above 0."""


@dataclass(frozen=True, eq=False)
class RandomCase:
    """One state of a random world.

    Attributes:
        policy: what every discount evaluates, int ``(S,)`` or float ``(S, A)``.
        settings: discounts, sensitivities, rows and time_step, resolved.
    """

    world: World
    state: int
    policy: np.ndarray
    settings: ResolvedForWorld

    @property
    def thetas(self) -> np.ndarray:
        """``(H,)``."""
        return grids(self.settings)[1]

    @property
    def worth(self) -> np.ndarray:
        """What a reward in each bin counts as, ``(H+1,)``."""
        return bin_values(self.thetas, open_ends=True)

    @cached_property
    def _timeline(self) -> np.ndarray:
        """P(r = v, alive) at each row, ``(A, K, V)``."""
        s = self.settings
        length = int(np.ceil(row_horizons(s.steps, s.time_step)[-1] - 1e-9))
        whole = reward_timeline(self.world, self.state, self.policy, length)
        return row_shares(s.steps, length, s.time_step) @ whole

    @cached_property
    def masses(self) -> np.ndarray:
        """The true timeline, ``(A, K, H+1)``, blurred by the activation as every decoded one is."""
        tails = self._timeline @ activation(self.world.reward_values, self.thetas, self.settings.slope)
        return bin_differences(tails, self._timeline.sum(axis=-1), open_ends=True)

    @cached_property
    def rewards(self) -> np.ndarray:
        """True expected reward of each row, ``(A, K)``: rewards count as themselves."""
        return self._timeline @ self.world.reward_values

    def values_of(self, rewards: np.ndarray) -> np.ndarray:
        """V_T of expected rewards ``(A, K)`` for every horizon, ``(A, K)``."""
        return horizon_values(rewards, self.settings.value_gamma, time_step=self.settings.time_step)

    def gamma_space(self, gammas: np.ndarray | None = None) -> GammaSpace:
        """The exact gamma-space, at the discounts of the settings or at others."""
        gammas = grids(self.settings)[0] if gammas is None else gammas
        basis = reward_indicator_basis(self.world, self.state, gammas, [self.policy] * len(gammas))
        return encode(basis, self.world.reward_values, gammas, self.thetas, self.settings.slope)

    def problem(self, noise: float = 0.0, seed: int = 0, gammas: np.ndarray | None = None) -> Problem:
        """The problem for a solver: the gamma-space with noise, and the standard deviation of that noise.

        Args:
            noise: standard deviation of (1 - gamma) Q.
        """
        space = with_noise(self.gamma_space(gammas), noise, seed)
        deviations = max(noise, LEAST_NOISE) / (1.0 - space.gammas)
        return problem_of(space, self.settings.steps, self.settings.time_step, deviations)


def random_case(rng: np.random.Generator, *, whole_steps: bool = False) -> RandomCase:
    """A random case; two fifths are short worlds, two fifths lasting ones, one fifth has dozens of rewards.

    Args:
        whole_steps: rows lie a step apart in all cases, and not only in three of four.
    """
    kind = rng.choice(3, p=[0.4, 0.4, 0.2])
    if kind == 0:
        world = short_world(rng)
        length = world.n_states + int(rng.integers(1, 4))
    else:
        world, length = (lasting_world if kind == 1 else rich_world)(rng)
    dt = float(rng.choice([1.0, 0.5, 0.25], p=[0.75, 0.15, 0.1]))
    dt = 1.0 if whole_steps else dt
    settings = Settings(
        world=world.name,
        gammas=15,
        thetas=int(rng.integers(12, 41)),
        steps=int(np.clip(round(length / dt), 3, MOST_ROWS)),
        time_step=dt,
        acting_gamma=float(rng.choice([0.9, 0.97, 0.99])),
        state=str(int(np.argmax(world.start) if rng.random() < 0.5 else rng.integers(world.n_states))),
    )
    resolved = resolve(settings, world)
    return RandomCase(world, world.state_index(resolved.state), _policy(rng, world, resolved.acting_gamma), resolved)


def listed_case(name: str) -> RandomCase:
    """The start state of a listed world under the policy that is greedy at its acting gamma, as its page shows it."""
    world = load_world(name)
    s = resolve(Settings(world=name, gammas=15), world)
    s = replace(s, steps=min(s.steps, MOST_ROWS))
    return RandomCase(world, world.state_index(s.state), greedy_policy(world, s.acting_gamma), s)


def _policy(rng: np.random.Generator, world: World, gamma: float) -> np.ndarray:
    """The greedy one, another of the deterministic ones, or one that draws its actions."""
    kind = rng.choice(3, p=[0.4, 0.3, 0.3])
    if kind == 0:
        return greedy_policy(world, gamma)
    if kind == 1:
        return rng.integers(world.n_actions, size=world.n_states)
    return rng.dirichlet(np.ones(world.n_actions), size=world.n_states)
