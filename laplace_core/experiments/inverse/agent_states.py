"""Timelines of trained agents' states, decoded by every kind of solver, against simulated continuations.

States are drawn from greedy episodes that no training has seen, the first action is the one the agent took, and every
solver decodes the agent's own gamma-space: no truth of a world stands behind it, only what the network learned. The
fixed alpha is the one that the page of agents opens with.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.acting.continuations import continue_from
from laplace_core.acting.rollout import Rollout, roll_out
from laplace_core.acting.simulated_truth import Empirical, empirical
from laplace_core.agents.agent import Agent
from laplace_core.agents.capabilities import HasGammaSpace
from laplace_core.errors import InputError
from laplace_core.inverse import choose_alpha, problem_of, solve
from laplace_core.training.checkpoint import load_checkpoint

CHECKPOINTS = Path(__file__).resolve().parents[3] / "checkpoints"
AGENTS = ("laplace_CartPole-v1", "laplace_LunarLander-v3")
FIXED = 1.0
"""Alpha of the first column, which the page of agents opens with."""
STEPS = 100
"""Rows, and steps that are simulated."""
CONTINUATIONS = 200
"""Simulations from each state."""
EPISODES = 5
"""Episodes that the states are drawn from."""
SEEDS = 700_000
"""Start seeds of the first episode for seed 0: none that a training or an evaluation uses."""
MOST_CASES = 1_000
TODAY, AUTO = "tikhonov, alpha 1", "tikhonov, auto"
SOLVERS = {TODAY: "tikhonov", AUTO: "tikhonov", "nonnegative, auto": "nonnegative", "feasible, auto": "feasible",
           "neural": "neural"}  # fmt: skip


def drawn_states(agent: Agent[Any], environment: str, cases: int, seed: int) -> list[tuple[Rollout, int]]:
    """Episodes and steps of them: as many of each episode as their number allows, evenly spread and jittered."""
    rng = np.random.default_rng([seed, 5])
    rollouts = [roll_out(agent, environment, SEEDS + EPISODES * seed + i) for i in range(min(EPISODES, cases))]
    states = []
    for i, rollout in enumerate(rollouts):
        count = len(range(i, cases, len(rollouts)))
        edges = np.linspace(0, len(rollout), count + 1).astype(int)
        states += [(rollout, int(rng.integers(low, max(low + 1, high)))) for low, high in pairwise(edges)]
    return states


def timelines(agent: Agent[Any], rollout: Rollout, step: int) -> dict[str, np.ndarray]:
    """Decoded masses of the action that was taken, ``(K, H+1)``, by column of the table."""
    assert isinstance(agent, HasGammaSpace)  # :func:`measure` refused any other
    action = int(rollout.actions[step])
    space = agent.gamma_space(rollout.observations[step])
    space = replace(space, values=space.values[[action]], constant=space.constant[[action]])
    problem = problem_of(space, STEPS)
    chosen = {solver: choose_alpha(problem, solver, "auto").value for solver in ("tikhonov", "nonnegative", "feasible")}
    alphas = {name: FIXED if name == TODAY else chosen.get(solver, FIXED) for name, solver in SOLVERS.items()}
    return {name: solve(problem, solver, np.asarray(alphas[name])).masses[0] for name, solver in SOLVERS.items()}


def scores(masses: np.ndarray, simulated: Empirical, agent: Agent[Any]) -> tuple[float, float]:
    """W1 to the simulated timeline, mean over the rows, in reward; and the error of the undiscounted value of all rows
    as a share of what rewards come to in size."""
    assert isinstance(agent, HasGammaSpace)
    distance = float(simulated.distance(masses, agent.thetas).mean())
    worth = np.concatenate([agent.thetas[:1], (agent.thetas[1:] + agent.thetas[:-1]) / 2.0, agent.thetas[-1:]])
    return distance, abs(float((masses @ worth - simulated.reward).sum())) / max(
        1.0, float(np.abs(simulated.reward).sum())
    )


def measure(name: str, cases: int, seed: int) -> np.ndarray:
    """W1 and value error of every column, and W1 by chance alone, ``(cases, columns + 1, 2)``.

    Raises:
        InputError: an agent without a gamma-space.
    """
    loaded = load_checkpoint(CHECKPOINTS / f"{name}.safetensors")
    agent, environment = loaded.agent, loaded.environment
    if not isinstance(agent, HasGammaSpace):
        raise InputError(f"{name} has no gamma-space to decode.")
    rows = []
    for rollout, step in drawn_states(agent, environment, cases, seed):
        sample = continue_from(agent, rollout, step, count=CONTINUATIONS, steps=STEPS, seed=seed)
        simulated = empirical(agent, sample)
        decoded = timelines(agent, rollout, step)
        rows.append(
            [*(scores(decoded[each], simulated, agent) for each in SOLVERS), (float(simulated.chance.mean()), 0.0)]
        )
    return np.array(rows)


def report(cases: int, seed: int) -> tuple[dict[str, Any], str]:
    """Numbers and a table for each agent: mean W1 with its standard error, and in how many states W1 falls.

    Raises:
        InputError: a number of cases out of range.
    """
    if not 2 <= cases <= MOST_CASES:
        raise InputError(f"cases is {cases}; it must be from 2 to {MOST_CASES:,}.")
    columns = [*SOLVERS, "chance"]
    rows, lines = [], [
        f"{cases} states of each agent from {min(EPISODES, cases)} episodes (seed {seed}), {STEPS} rows, "
        f"{CONTINUATIONS} simulated continuations each",
        "W1 to the simulated timeline, mean over rows and states, in reward, +- its standard error; 'chance' is what a "
        "perfect timeline would have",
    ]  # fmt: skip
    for name in AGENTS:
        found = measure(name, cases, seed)
        means, errors = found.mean(axis=0), found.std(axis=0, ddof=1) / np.sqrt(cases)
        today = found[:, 0, 0]
        lines.append(f"\n{name}\n{'':18} {'W1':>8} {'+-':>8} {'value error':>12} {'nearer than today in':>21}")
        for i, column in enumerate(columns):
            nearer = int((found[:, i, 0] < today).sum())
            rows.append({
                "agent": name, "column": column, "w1": means[i, 0], "w1 error": errors[i, 0],
                "value error": means[i, 1], "nearer than today": nearer,
            })  # fmt: skip
            value = f"{means[i, 1]:12.3f}" if column in SOLVERS else f"{'':12}"
            beside = f"{nearer:>14} of {cases}" if column in SOLVERS and column != TODAY else ""
            lines.append(f"{column:18} {means[i, 0]:8.4f} {errors[i, 0]:8.4f} {value} {beside}".rstrip())
    return {"cases": cases, "seed": seed, "rows": rows}, "\n".join(lines)


def shortfalls(numbers: dict[str, Any]) -> list[str]:
    """Agents whose feasible timelines are not nearer, on average, than today's picture."""
    w1 = {(row["agent"], row["column"]): row["w1"] for row in numbers["rows"]}
    return [agent for agent in AGENTS if not w1[agent, "feasible, auto"] < w1[agent, TODAY]]
