"""The entry of figure 3: scores and evaluations of the agents that ship, and the trainings over episodes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.acting.bootstrap import interquartile_band
from laplace_core.experiments.paper.claims.entry import (
    AGREES,
    DIFFERS,
    IN_PART,
    Claim,
    Entry,
    Finding,
    Line,
    Results,
    View,
    results_of,
)
from laplace_core.experiments.paper.claims.words import listed, number
from laplace_core.experiments.paper.fig3 import ALGORITHMS, ENVIRONMENTS
from laplace_core.experiments.paper.result_files import result_file
from laplace_core.experiments.paper.smoothing import smoothed

PEERS = ("c51", "qrdqn")
"""Which the paper compares with."""
_FINAL = {"c51": "161.63", "qrdqn": "224.71", "laplace": "188.45"}
"""The paper's returns on LunarLander-v2 at full length, which table 1 has; figure 3 is a picture."""
_POINTS = 200
_AT_FIRST = 0.1
"""Share of the episodes that begin a training, and of those that end it."""


def _sources(folder: Path, agents: Path) -> list[Path]:
    return [result_file(folder, "fig3"), agents / "manifest.json"]


def _read(folder: Path, agents: Path) -> Results:
    """Trainings from the file of the experiment; scores and evaluations by environment from the agents that ship."""
    from laplace_core.experiments import shipped_agents  # loads torch
    from laplace_core.experiments.shipping import MANIFEST, manifest

    trained = results_of("fig3", result_file(folder, "fig3"))
    shipped: dict[str, dict[str, Any]] = {each: {} for each in ENVIRONMENTS}
    for entry in manifest(agents):
        algorithm, _, environment = entry["file"].removesuffix(".safetensors").partition("_")
        if algorithm in ALGORITHMS and environment in ENVIRONMENTS:
            shipped[environment][algorithm] = {
                "scores": [float(score) for score in entry["scores"]],
                "curves": shipped_agents.curves(agents, f"{algorithm}_{environment}"),
            }
    path = trained.path if trained.finished else agents / MANIFEST
    return replace(trained, path=path, summary={name: each for name, each in shipped.items() if each})


def scores_in(results: Results, environment: str) -> dict[str, list[float]]:
    """Scores of the seeds of the agents that ship, by algorithm."""
    return {name: each["scores"] for name, each in results.summary.get(environment, {}).items()}


def over_episodes(results: Results, environment: str) -> dict[str, list[Mapping[str, Any]]]:
    """Every episode of every training that is there, by algorithm: ``episodes``, ``steps`` and ``returns``."""
    found: dict[str, list[Mapping[str, Any]]] = {}
    for cell in results.cells:
        rows = [row["each_episode"] for row in cell["trainings"] if row.get("each_episode", {}).get("returns")]
        if rows and cell["environment"] == environment:
            found[cell["algorithm"]] = rows
    return found


def at_episodes(rows: Sequence[Mapping[str, Any]], reach: int) -> tuple[np.ndarray, np.ndarray]:
    """Numbers of episodes that all seeds reached, ``(N,)``, and the returns of each seed there, ``(n, N)``.

    Args:
        reach: of the smoothing; 0 leaves the returns as they are.
    """
    last = min(row["episodes"][-1] for row in rows)
    places = np.unique(np.round(np.linspace(1, last, min(last, _POINTS))).astype(int))
    return places, np.array([np.interp(places, row["episodes"], smoothed(row["returns"], reach)) for row in rows])


def at_steps(curves: Sequence[Any]) -> tuple[np.ndarray, np.ndarray]:
    """Steps of the evaluations, ``(N,)``, and the scores of each seed there, ``(n, N)``.

    Seeds are evaluated a few steps apart: all are read, linearly, at the steps of the one that ends first.
    """
    steps = np.asarray(min((curve.steps for curve in curves), key=lambda each: each[-1]), dtype=float)
    return steps, np.array([np.interp(steps, curve.steps, curve.scores) for curve in curves])


# ---- what the paper says


def _comparable(results: Results) -> Finding | None:
    words, states = [], []
    for environment in ENVIRONMENTS:
        found = scores_in(results, environment)
        peers = {name: found[name] for name in PEERS if name in found}
        if "laplace" not in found or not peers:
            continue
        mine = found["laplace"]
        # Comparable: its best seed reaches the worst seed of either peer.
        states.append(all(max(mine) >= min(each) for each in peers.values()))
        medians = [f"{ALGORITHMS[name]} {number(float(np.median(each)))}" for name, each in peers.items()]
        words.append(f"{environment} {number(float(np.median(mine)))} ({listed(medians)})")
    if not words:
        return None
    state = AGREES if all(states) else IN_PART if any(states) else DIFFERS
    told = f"Medians of Laplace DQN's seeds, and of the peers': {'; '.join(words)}. In {sum(states)} of {len(states)} "
    return Finding(state, f"{told}its best seed is at least as good as the worst seed of each peer.", whole=True)


def _seeds_vary(results: Results) -> Finding | None:
    """Whether the seeds of Laplace DQN lie further apart than those of both peers."""
    words, states = [], []
    for environment in ENVIRONMENTS:
        found = {name: each for name, each in scores_in(results, environment).items() if len(each) > 1}
        if "laplace" not in found or not set(PEERS) <= set(found):
            continue
        reach = {name: max(found[name]) - min(found[name]) for name in ("laplace", *PEERS)}
        states.append(reach["laplace"] > max(reach[name] for name in PEERS))
        peers = listed([f"{ALGORITHMS[name]} {number(reach[name])}" for name in PEERS])
        words.append(f"{number(reach['laplace'])} on {environment} ({peers})")
    if not words:
        return None
    state = AGREES if all(states) else IN_PART if any(states) else DIFFERS
    return Finding(
        state, f"The range from the lowest to the highest seed of Laplace DQN is {listed(words)}.", whole=True
    )


def _improves(results: Results) -> Finding | None:
    words, states = [], []
    for environment in ENVIRONMENTS:
        rows = over_episodes(results, environment).get("laplace")
        if not rows:
            continue
        ends = []
        for row in rows:
            part = max(1, round(_AT_FIRST * len(row["returns"])))
            ends.append((float(np.mean(row["returns"][:part])), float(np.mean(row["returns"][-part:]))))
        first, last = np.array(ends).T
        states.append(bool((last > first).all()))
        seeds = f"{len(rows)} seed{'s' if len(rows) > 1 else ''}"
        words.append(f"from {number(float(first.mean()))} to {number(float(last.mean()))} on {environment} ({seeds})")
    if not words:
        return None
    state = AGREES if all(states) else IN_PART if any(states) else DIFFERS
    told = "From the first tenth of the episodes to the last, Laplace DQN's return while training goes"
    return Finding(state, f"{told} {listed(words)}.")


def _lines(results: Results) -> list[Line]:
    lines = []
    for environment in ENVIRONMENTS:
        scores = scores_in(results, environment)
        for name, title in ALGORITHMS.items():
            paper = f"{_FINAL[name]} (v2)" if environment.startswith("LunarLander") and name in _FINAL else ""
            paper = paper or ("a curve" if name in _FINAL else "")
            ours = ""
            if name in scores:
                low, middle, high = interquartile_band(np.array(scores[name])[:, None])
                ends = f"95% {number(float(low[0]))} to {number(float(high[0]))}"
                ours = f"IQM {number(float(middle[0]))} ({ends}, {len(scores[name])} seeds)"
            lines.append(Line(f"{environment}, {title}", paper, ours))
    return lines


FIG3 = Entry(
    name="fig3",
    place="Figure 3",
    title="Learning curves of C51, QR-DQN and Laplace DQN",
    claims=[
        Claim("Laplace DQN, acting at .99, has results comparable to C51's and QR-DQN's.", _comparable),
        Claim("The seed matters even more for Laplace DQN than for its peers.", _seeds_vary),
        Claim("Curves over episodes are noisy and improve.", _improves),
    ],
    lines=_lines,
    view=View("train", {"environment": "LunarLander-v3"}),
    read=_read,
    sources=_sources,
)
