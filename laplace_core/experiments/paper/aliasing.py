"""Section 6: two states that share their return and differ in when it comes.

In ``soon`` a reward of 0 or 2 comes after 1 step, in ``late`` one of 0 or 2 / .99^5 after 6: at discount .99 both have
the same distribution of the return, so that no code of that return can tell them apart. ``either`` is what an agent
that cannot see which of the two it is in stands in: it goes on as either, by chance. Each code of a learner is a list
of numbers; two codes lie as far apart as the Wasserstein-1 distance of their distributions, and two Laplace codes as
the mean of (1 - gamma) |Q - Q'| over discounts and rewards.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from laplace_core.experiments.paper.measurement import Measurement, Options, Result, Row
from laplace_core.study.settings import Settings
from laplace_core.tabular import Learned, Learning, LearnSettings, return_distributions, study_of, wasserstein
from laplace_core.worlds.model import END, Outcome, World

GAMMA, EPISODES, LEARNERS = 0.99, 5_000, 8
EARLY, LATE = 1, 6
"""Steps after which the reward comes."""
CODES = ("categorical", "quantile", "expectile", "plain")
ALPHA, STEPS = 0.01, 10


def aliased_world() -> World:
    """States ``soon``, ``late`` and ``either``, and the steps that follow; one action."""
    names, rows = ["soon", "late", "either"], []
    for first, delay, reward in ((0, EARLY, 2.0), (1, LATE, 2.0 / GAMMA ** (LATE - EARLY))):
        chain = list(range(len(names), len(names) + delay))
        names += [f"{names[first]} {i}" for i in range(1, delay + 1)]
        walk = [first, *chain]
        rows += [Outcome(here, 0, 1.0, there, 0.0) for here, there in pairwise(walk)]
        rows += [Outcome(walk[-1], 0, 0.5, END, paid) for paid in (0.0, reward)]
        rows.append(Outcome(2, 0, 0.5, chain[0], 0.0))
    start = np.zeros(len(names))
    start[:3] = 1.0 / 3.0
    return World.from_outcomes("aliased", names, ["go"], rows, start=start)


def _measure(part: Options) -> Result:
    settings = LearnSettings(
        episodes=EPISODES, seeds=LEARNERS, seed=int(part["seed"]), peers=True, acting_gamma=GAMMA, peer_gamma=GAMMA,
        gammas=15, spacing="log", gamma_min=0.3, gamma_max=GAMMA,
    )  # fmt: skip
    learning = Learning(aliased_world(), settings)
    for _ in learning:
        pass
    learned = learning.snapshot()
    codes: Result = {}
    for name in CODES:
        laws = [[_law(learned, seed, state, name) for seed in range(LEARNERS)] for state in (0, 1)]
        codes[name] = _told_apart(laws, wasserstein)
    scale = 1.0 - np.asarray(study_of(learned).gamma_space.gammas)[:, None]
    spaces = [[learned.basis[seed, state, 0] * scale for seed in range(LEARNERS)] for state in (0, 1)]
    codes["laplace"] = _told_apart(spaces, lambda one, other: float(np.abs(one - other).mean()))
    return {"codes": codes, "either": _either(learned)}


def _law(learned: Learned, seed: int, state: int, name: str) -> tuple[np.ndarray, np.ndarray]:
    return return_distributions(learned, state, 0, seed_index=seed).codes[name]


def _told_apart(codes: list[list[Any]], distance: Callable[[Any, Any], float]) -> Result:
    """How far the codes of two states lie apart, against how far learners differ; and by the nearest of the others.

    A code is assigned to the state whose codes of the other learners lie nearer in the mean; a tie counts one half.
    """
    pairs = [(state, seed) for state in (0, 1) for seed in range(LEARNERS)]
    between = {
        (one, other): distance(codes[one[0]][one[1]], codes[other[0]][other[1]]) for one in pairs for other in pairs
    }
    right = 0.0
    for one in pairs:
        means = [
            float(np.mean([between[one, (state, seed)] for seed in range(LEARNERS) if seed != one[1]]))
            for state in (one[0], 1 - one[0])
        ]
        right += 0.5 if means[0] == means[1] else float(means[0] < means[1])
    apart = np.mean([between[(0, a), (1, b)] for a in range(LEARNERS) for b in range(LEARNERS) if a != b])
    same = np.mean(
        [between[(s, a), (s, b)] for s in (0, 1) for a in range(LEARNERS) for b in range(LEARNERS) if a != b]
    )
    return {"apart": round(float(apart), 6), "same": round(float(same), 6), "right": right, "of": len(pairs)}


def _either(learned: Learned) -> Result:
    """Probability of a reward above 1 at each step after ``either``, decoded, mean over the learners; true: .25."""
    chances = []
    for seed in range(LEARNERS):
        study = study_of(learned, Settings(state="either", alpha=ALPHA, steps=STEPS), seed)
        chances.append(study.decoded.tau_space[0][:, study.midpoints > 1.0].sum(axis=1))
    truth = np.zeros(STEPS)
    truth[[EARLY, LATE]] = 0.25
    return {"decoded": np.mean(chances, axis=0).round(4).tolist(), "true": truth.tolist()}


def _summary(rows: Sequence[Row]) -> Result:
    """Share of codes that are assigned to their state, over all learners."""
    return {
        name: {
            "right": sum(row["result"]["codes"][name]["right"] for row in rows),
            "of": sum(row["result"]["codes"][name]["of"] for row in rows),
            "apart over same": round(
                float(np.mean([row["result"]["codes"][name]["apart"] / row["result"]["codes"][name]["same"]
                               for row in rows])), 3,
            ),
        }
        for name in (*CODES, "laplace")
    }  # fmt: skip


EXPERIMENT = Measurement(
    name="aliasing",
    title="Section 6: two states with one return",
    question="Which codes distinguish two states that differ only in when their reward comes?",
    parts=[{"seed": seed} for seed in (0, 8, 16)],
    measure=_measure,
    summary=_summary,
)
