"""Exact gamma-spaces of random worlds, with noise if wanted."""

from __future__ import annotations

import numpy as np

from laplace_core.code.encoding import discount_grid
from laplace_core.code.gamma_space import GammaSpace, encode, with_noise
from laplace_core.planning import reward_indicator_basis, target_policies
from laplace_core.worlds import END, Outcome, World
from tests.support.timelines import timelines


def random_world(rng: np.random.Generator) -> World:
    """Up to six states and three actions; some worlds run for ever, some in cycles, rewards of both signs or of one."""
    states, actions = int(rng.integers(1, 7)), int(rng.integers(1, 4))
    ends, low = rng.choice([0.0, 0.1, 0.5]), rng.choice([-8, 0])
    outcomes = []
    for state in range(states):
        for action in range(actions):
            chances = rng.dirichlet(np.ones(int(rng.integers(1, 4))))
            for chance in chances:
                goal = END if rng.random() < ends else int(rng.integers(states))
                outcomes.append(Outcome(state, action, float(chance), goal, float(rng.integers(low, 13)) / 4))
    names = [f"s{i}" for i in range(states)]
    return World.from_outcomes("random", names, [f"a{i}" for i in range(actions)], outcomes)


def random_discounts(rng: np.random.Generator, least: int = 2) -> np.ndarray:
    return np.sort(rng.choice(np.arange(1, 100), int(rng.integers(least, 16)), replace=False)) / 100


def random_thetas(rng: np.random.Generator, least: int = 2) -> np.ndarray:
    """Around the rewards, or so that some or all of them lie beyond."""
    low, high = np.sort(rng.uniform(-3.5, 4.0, 2))
    if rng.random() < 0.7:
        low, high = -2.5, 3.5
    return np.linspace(low, high + 0.5, int(rng.integers(least, 31)))


def random_space(rng: np.random.Generator, least: tuple[int, int] = (2, 2), kind: str | None = None) -> GammaSpace:
    """The exact gamma-space of a random world, under one policy or one for each discount."""
    world, gammas, thetas = random_world(rng), random_discounts(rng, least[0]), random_thetas(rng, least[1])
    kind = kind or str(rng.choice(["shared", "per_gamma"]))
    policies = target_policies(world, gammas, kind, float(rng.choice([0.5, 0.9, 0.99])))
    basis = reward_indicator_basis(world, int(rng.integers(world.n_states)), gammas, policies)
    slope = float(rng.choice([1.0, 2.5, 10.0])) / float(np.diff(thetas).max())
    return encode(basis, world.reward_values, gammas, thetas, slope)


def noisy(space: GammaSpace, size: float, rng: np.random.Generator) -> GammaSpace:
    """An independent error of every (1 - gamma) Q."""
    sizes = 1.0 - space.gammas
    values = space.values + size * rng.standard_normal(space.values.shape) / sizes[:, None]
    constant = space.constant + size * rng.standard_normal(space.constant.shape) / sizes
    return GammaSpace(values, constant, space.gammas, space.thetas)


def noisy_space(noise: float, seed: int = 0) -> tuple[GammaSpace, GammaSpace, np.ndarray]:
    """A gamma-space of two feasible timelines, the same with noise, and the deviations of its values ``(G,)``."""
    rng, gammas = np.random.default_rng(seed), discount_grid(12, "log")
    masses = gammas[:, None] ** np.arange(15) @ timelines(rng, 2, 15, 7)
    tails = np.cumsum(masses[..., ::-1], axis=-1)[..., ::-1]
    exact = GammaSpace(tails[..., 1:], tails[..., 0], gammas, np.linspace(-1.0, 1.0, 6))
    deviations = noise / (1.0 - gammas)
    return exact, with_noise(exact, noise, seed + 1), deviations
