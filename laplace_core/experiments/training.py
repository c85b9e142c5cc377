"""Score, speed and reliability of an algorithm on an environment: the same settings, several seeds."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.acting.evaluation import Scores, evaluate, return_notes
from laplace_core.agents.agent import Agent
from laplace_core.errors import InputError
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.training.defaults import settings_of
from laplace_core.training.loop import train
from laplace_core.training.run_folder import read_config, read_metrics

EPISODES = 100


def report(algorithm: str, environment: str, seeds: int, aim: float, *, folder: Path) -> tuple[dict[str, Any], str]:
    """Train what is not trained yet, evaluate the best checkpoint of every seed, and report.

    Runs are kept in ``folder``; one that is there already is used if it was made with the same settings, and gone on
    with if it was not finished.
    """
    rows = [_seed(algorithm, environment, seed, aim, folder=folder) for seed in range(seeds)]
    scores = np.array([row["score"] for row in rows])
    numbers = {"algorithm": algorithm, "environment": environment, "aim": aim, "episodes": EPISODES, "seeds": rows}
    numbers |= {"median": float(np.median(scores)), "lowest": float(scores.min())}
    lines = [
        f"{algorithm} on {environment}: mean of {EPISODES} episodes from held-out start seeds",
        f"{'seed':>4}  {'score':>16}  {'value error':>12}  {f'steps to {aim:g}':>14}  {'seconds':>8}  {'all steps':>9}"
        f"  {'seconds':>8}",
    ]
    for row in rows:
        reached, error = f"{'never':>14}  {'':>8}", f"{'':>12}"
        if row["value_error"] is not None:
            error = f"{row['value_error']:>+12.1f}"
        if row["steps_to_aim"]:
            reached = f"{row['steps_to_aim']:>14,}  {row['seconds_to_aim']:>8.0f}"
        lines.append(
            f"{row['seed']:>4}  {row['score']:>8.1f} +- {row['standard_error']:>4.1f}  {error}  {reached}  "
            f"{row['steps']:>9,}  {row['seconds']:>8.0f}"
        )
    lines.append(f"median {numbers['median']:.1f}, lowest {numbers['lowest']:.1f}; +- is the standard error")
    lines.append("value error: predicted less observed discounted return, a mean over the starts")
    others = settings_of(algorithm, environment, {}).evaluate_episodes
    lines.append(f"steps to {aim:g}: the first evaluation while training ({others} other start seeds) that reaches it")
    lines += [f"seed {row['seed']}: {note}" for row in rows for note in row["notes"]]
    return numbers, "\n".join(lines)


def run_name(algorithm: str, environment: str, seed: int) -> str:
    return f"{algorithm}_{environment.replace(':', '-')}_{seed}"


def _seed(algorithm: str, environment: str, seed: int, aim: float, *, folder: Path) -> dict[str, Any]:
    settings = settings_of(algorithm, environment, {"seed": seed})
    run = folder / run_name(algorithm, environment, seed)
    finished = (run / "last.safetensors").exists()
    there = (run / "config.json").exists()
    if there and read_config(run / "config.json") != settings:
        raise InputError(f"{run} was made with other settings: name another --runs folder.")
    if not finished:
        began = time.monotonic()
        for _ in train(None if there else settings, run, resume=there):
            pass
        print(f"seed {seed}: {time.monotonic() - began:.0f} s", flush=True)
    events = read_metrics(run)
    seconds = seconds_behind(events)
    reached = next((i for i, e in enumerate(events) if e["event"] == "Evaluation" and e["score"] >= aim), None)
    agent = load_checkpoint(run / "best.safetensors").agent
    scores, value_error = evaluated(agent, environment, EPISODES, seed)
    return {
        "seed": seed,
        "score": scores.mean,
        "value_error": value_error,
        "standard_error": scores.standard_error,
        "steps_to_aim": None if reached is None else events[reached]["step"],
        "seconds_to_aim": None if reached is None else seconds[reached],
        "steps": settings.steps,
        "seconds": seconds[-1],
        "notes": return_notes(agent, scores),
    }


def evaluated(agent: Agent, environment: str, episodes: int, seed: int) -> tuple[Scores, float | None]:
    """Scores of whole episodes, and the predicted less the observed discounted return at their starts.

    The second is None where the agent's values are of no return to the end of an episode. An agent may act well by
    values that are far too high, as long as they are so for all actions.
    """
    gamma = agent.acting_discount
    discounts = None if gamma is None else np.array([gamma])
    scores = evaluate(agent, environment, episodes=episodes, seed=seed, discounts=discounts)
    if gamma is None:
        return scores, None
    values, actions = agent.action_values(scores.starts, agent.acting_head), agent.greedy(scores.starts)
    taken = values[np.arange(len(actions)), actions]
    return scores, float((taken - scores.discounted[:, 0]).mean())


def seconds_behind(events: list[dict[str, Any]]) -> list[float]:
    """Seconds of training behind each event, over all times that the run was gone on with."""
    behind, last, seconds = 0.0, 0.0, []
    for event in events:
        if event["seconds"] < last:  # the clock began again
            behind += last
        last = event["seconds"]
        seconds.append(behind + last)
    return seconds
