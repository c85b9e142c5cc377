"""Learning from transitions: one update against a bare multiply-add, and whole episodes."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from bench.report import Figure, Goal
from bench.timing import interleaved, spread
from laplace_core import World, load_world
from laplace_core.code.encoding import discount_grid, sensitivity_grid
from laplace_core.tabular.td import LaplaceTD, Schedule, learn, sensitivity_channels, td_update

GAMMAS, THETAS, EPISODES = 100, 250, 3_000
SUBJECT = "Learning from transitions"


def figures() -> Iterator[Figure]:
    yield from _one_update()
    yield from _episodes(load_world("fig6_chain"))


def learner(world: World, *, direct: bool) -> LaplaceTD:
    """Of gamma-space directly, or of the reward-indicator basis W."""
    thetas = sensitivity_grid(THETAS, -4.0, 4.0)
    channels = sensitivity_channels(world.reward_values, thetas, 25.0) if direct else None
    return LaplaceTD(world, discount_grid(GAMMAS), channels=channels)


def run(world: World, *, direct: bool, episodes: int = EPISODES) -> LaplaceTD:
    """A fresh learner after so many episodes, every event consumed."""
    fresh = learner(world, direct=direct)
    for _ in learn(world, [fresh], Schedule(episodes)):
        pass
    return fresh


def _one_update() -> Iterator[Figure]:
    random = np.random.default_rng(0)
    value, following, work, a, b, c = (random.random((GAMMAS, THETAS)) for _ in range(6))
    now, gammas = random.random(THETAS), discount_grid(GAMMAS)[:, None]

    def bare():
        nonlocal a
        a += b * c

    seconds = interleaved(
        {
            "update": (lambda: td_update(value, following, now, gammas, rate=0.01, work=work), 100),
            "bare": (bare, 100),
            "same bare": (bare, 100),
            "ending": (lambda: td_update(value, None, now, gammas, rate=0.01, work=work), 100),
        },
        rounds=101,
    )
    sizes = f"{GAMMAS} discounts x {THETAS} channels"
    yield Figure(
        SUBJECT, "one update / a += b * c", spread(seconds["update"] / seconds["bare"]), "x", sizes,
        Goal("<=", 3), "a transition that bootstraps; all arrays of that size",
    )  # fmt: skip
    yield Figure(
        SUBJECT, "one update of a termination / a += b * c", spread(seconds["ending"] / seconds["bare"]), "x", sizes,
    )  # fmt: skip
    yield Figure(
        SUBJECT, "a += b * c / itself", spread(seconds["same bare"] / seconds["bare"]), "x", sizes,
        note="the same statement timed twice a round: what noise alone makes",
    )  # fmt: skip


def _episodes(world: World) -> Iterator[Figure]:
    seconds = interleaved(
        {
            "direct": (lambda: run(world, direct=True), 1),
            "basis": (lambda: run(world, direct=False), 1),
        },
        rounds=7,
    )
    steps = f"{4 * EPISODES:,} transitions"
    yield Figure(
        SUBJECT, f"{EPISODES:,} episodes of fig6_chain, gamma-space", spread(seconds["direct"]), "s",
        f"{steps}, {GAMMAS} discounts x {THETAS} sensitivities and the constant channel", Goal("<", 3),
        "with sampling, control and an event an episode",
    )  # fmt: skip
    yield Figure(
        SUBJECT, f"{EPISODES:,} episodes of fig6_chain, basis W", spread(seconds["basis"]), "s",
        f"{steps}, {GAMMAS} discounts x {world.reward_values.size} rewards",
        note="gives the same gamma-space for any sensitivities",
    )  # fmt: skip
