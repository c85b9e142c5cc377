"""Random gamma-spaces of known truth: of worlds that end within nine steps, and with cycles, long or without end."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from laplace_core.code.gamma_space import GammaSpace
from laplace_core.experiments.case_worlds import lasting_world, short_world
from laplace_core.study.pipeline import WorldStudy, study
from laplace_core.study.settings import Settings
from laplace_core.worlds import World

SPACINGS = ("log", "inverse-log", "paper")
NOISES = (1e-4, 1e-3, 1e-2)
DISCOUNTS = 15


@dataclass(frozen=True, eq=False)
class Space:
    """A world, its exact gamma-space from one state, and the truth of ``steps`` steps."""

    world: World
    study: WorldStudy
    steps: int

    @property
    def exact(self) -> GammaSpace:
        return self.study.gamma_space

    def deviations(self, noise: float) -> np.ndarray:
        """Standard deviation of one value at each discount, where that of (1 - gamma) Q is ``noise``, ``(G,)``."""
        return np.asarray(noise / (1.0 - self.exact.gammas))

    def noisy(self, noise: float, rng: np.random.Generator) -> GammaSpace:
        """Values with independent normal errors."""
        values, constant = seeds_of(self.exact, self.deviations(noise), 1, rng)
        return replace(self.exact, values=values[0], constant=constant[0])


def draw_space(rng: np.random.Generator, *, policy: str = "shared", actions: int = 1) -> Space:
    """A random space; half of the worlds end within nine steps.

    Args:
        actions: the fewest that its world has.
    """
    while True:
        if rng.random() < 0.5:
            world, length = short_world(rng), int(rng.integers(3, 12))
        else:
            world, length = lasting_world(rng)
        spacing = str(rng.choice(SPACINGS))
        if world.n_actions >= actions:
            break
    settings = Settings(world=world.name, gammas=DISCOUNTS, spacing=spacing, steps=length, policy=policy)
    return Space(world, study(world, settings), length)


def one_action(space: GammaSpace, action: int) -> GammaSpace:
    """The gamma-space of one action alone."""
    return replace(space, values=space.values[action : action + 1], constant=space.constant[action : action + 1])


def seeds_of(
    space: GammaSpace, deviations: np.ndarray, count: int, rng: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    """Values ``(count, A, G, H)`` and constant channels ``(count, A, G)`` of seeds with independent normal errors."""
    values = space.values + deviations[:, None] * rng.normal(size=(count, *space.values.shape))
    return values, space.constant + deviations * rng.normal(size=(count, *space.constant.shape))
