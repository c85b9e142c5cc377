"""Section 2.3: which discount is accurate first, by the distance to the end of the episode.

A chain of ``LENGTH`` states pays 1 at each step, for sure or in the mean of a coin of 0 or 2, and ends: nothing differs
between its states but how far they are from the end. Tables learn it by temporal differences from values of 0. A value
is accurate from the first look on from which its error stays below ``NEAR`` of the true one.

Sure rewards leave only what has to come back from the end: after n episodes Q holds n of the d steps that are left, so
that its error is (gamma^n - gamma^d) / (1 - gamma^d). Coins leave only noise besides, of which a long sum has less.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from laplace_core.experiments.paper.measurement import Measurement, Options, Result, Row
from laplace_core.tabular import Learning, LearnSettings
from laplace_core.worlds.model import END, Outcome, World

LENGTH = 32
REWARDS = {"sure": (1.0,), "coins": (0.0, 2.0)}
EPISODES = {"sure": 48, "coins": 2_000}
LEARNERS, LOOKS, NEAR = 8, 250, 0.1
DISTANCES = (1, 2, 4, 8, 16, 32)
"""Steps to the end, the last one included."""


def chain(rewards: str) -> World:
    """States in a row, one action, and at each step a reward of a name in ``REWARDS``."""
    paid = REWARDS[rewards]
    rows = [
        Outcome(here, 0, 1.0 / len(paid), here + 1 if here + 1 < LENGTH else END, each)
        for here in range(LENGTH)
        for each in paid
    ]
    start = np.zeros(LENGTH)
    start[0] = 1.0
    names = [f"{LENGTH - here} to go" for here in range(LENGTH)]
    return World.from_outcomes(f"chain of {rewards}", names, ["go"], rows, start=start)


def true_values(gammas: np.ndarray) -> np.ndarray:
    """(1 - gamma^d) / (1 - gamma), a coin of mean 1 at each of d steps: ``(S, G)``."""
    left = np.arange(LENGTH, 0, -1)[:, None]
    return np.asarray((1.0 - gammas**left) / (1.0 - gammas))


def first_accurate(errors: np.ndarray, episodes: Sequence[float]) -> np.ndarray:
    """Episodes after which an error stays below ``NEAR``; infinite where it does not: ``(...)`` from ``(L, ...)``."""
    off = errors >= NEAR
    looks = len(off) - np.argmax(off[::-1], axis=0)  # the look behind the last one that was off
    looks = np.where(off.any(axis=0), looks, 0)
    return np.append(np.asarray(episodes, dtype=float), np.inf)[looks]


def _measure(part: Options) -> Result:
    rewards, errors, episodes = str(part["rewards"]), [], []
    settings = LearnSettings(
        episodes=EPISODES[rewards], seeds=LEARNERS, seed=int(part["seed"]), acting_gamma=0.99, starts="world",
        max_steps=LENGTH, gammas=15, spacing="log", gamma_min=0.3678794412, gamma_max=0.99,
        rate_floor=1.0 if rewards == "sure" else 0.0,  # where nothing is left to chance there is nothing to average
    )  # fmt: skip
    learning, seen = Learning(chain(rewards), settings), 0.0
    gammas = np.zeros(0)
    for index in learning:
        done = float(str(learning.progress["episodes"])) / LEARNERS if index == LEARNERS - 1 else 0.0
        if done < seen + EPISODES[rewards] / LOOKS:
            continue
        learned, seen = learning.snapshot(), done
        gammas, truth = learned.gammas, true_values(learned.gammas)
        values = learned.basis[:, :, 0].astype(float) @ learned.world.reward_values
        errors.append(np.abs(values - truth) / truth)
        episodes.append(done)
    first = np.minimum(first_accurate(np.array(errors), episodes), EPISODES[rewards])
    return {
        "gammas": np.round(gammas, 6).tolist(),
        "episodes": {str(left): np.median(first[:, LENGTH - left], axis=0).tolist() for left in DISTANCES},
    }


def _summary(rows: Sequence[Row]) -> Result:
    """By rewards and distance: episodes at the smallest and the largest discount, means of the rows' medians."""
    summed: Result = {}
    for rewards in REWARDS:
        mine = [row["result"] for row in rows if row["part"]["rewards"] == rewards]
        for left in map(str, DISTANCES if mine else ()):
            when = np.mean([each["episodes"][left] for each in mine], axis=0)
            summed.setdefault(rewards, {})[left] = {
                "smallest": mine[0]["gammas"][0], "after": round(float(when[0]), 1),
                "largest": mine[0]["gammas"][-1], "its after": round(float(when[-1]), 1),
                "played": EPISODES[rewards],
                "of": len(mine) * LEARNERS if len(REWARDS[rewards]) > 1 else 1,
            }  # fmt: skip
    return summed


EXPERIMENT = Measurement(
    name="timescales",
    title="Section 2.3: which discount is accurate first",
    question="Does it depend on the distance to the end of the episode at which discount a value is accurate first?",
    parts=[  # sure rewards leave nothing to chance
        {"rewards": "sure", "seed": 0},
        *({"rewards": "coins", "seed": seed} for seed in (0, 8, 16)),
    ],
    measure=_measure,
    summary=_summary,
)
