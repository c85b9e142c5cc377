"""Entries that are trained: figures 3 and 7, table 2, and sections 2.3, 3.2, 3.3 and 5."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.experiments.paper import EXPERIMENTS
from laplace_core.experiments.paper.claims.entry import (
    AGREES,
    DIFFERS,
    IN_PART,
    NEW,
    RUN,
    Claim,
    Entry,
    Finding,
    Line,
    Results,
    View,
)
from laplace_core.experiments.paper.claims.words import listed, number, spread

_SOLVED = 475.0
"""Mean return from which CartPole-v1 counts as solved, by gymnasium's own threshold."""


def scores_of(cell: Mapping[str, Any]) -> list[float]:
    """Of every seed that is finished, the best checkpoint's mean over 100 episodes."""
    return [float(row["best"]["score"]) for row in cell["trainings"]]


def _cells(results: Results) -> dict[str, list[float]]:
    """Scores by the label of a cell; none where no seed is finished."""
    return {cell["label"]: scores_of(cell) for cell in results.cells if cell["trainings"]}


def _learning(results: Results, label: str) -> list[float]:
    """Of every seed the mean of all evaluations while training: the sooner it learns, the higher."""
    rows = [row for cell in results.cells if cell["label"] == label for row in cell["trainings"]]
    return [float(np.mean(row["evaluations"]["scores"])) for row in rows]


def _lines(name: str, paper: Mapping[str, str]) -> Any:
    """A line for each planned cell; ``paper`` has the paper's number by its label."""

    def lines(results: Results) -> list[Line]:
        found = _cells(results)
        return [
            Line(cell.label, paper.get(cell.label, ""), spread(found[cell.label]) if cell.label in found else "")
            for cell in EXPERIMENTS[name].cells
        ]

    return lines


def _above(high: Sequence[float], low: Sequence[float]) -> str:
    """Whether one setting scores higher than another: clearly, if its lowest seed is above the other's highest."""
    if min(high) > max(low):
        return AGREES
    return DIFFERS if np.mean(high) <= np.mean(low) else IN_PART


def _higher(better: str, worse: str, told: str) -> Any:
    """Judges a claim that one cell scores higher than another; ``told`` has both, as ``{better}`` and ``{worse}``."""

    def judge(results: Results) -> Finding | None:
        found = _cells(results)
        if better not in found or worse not in found:
            return None
        state = _above(found[better], found[worse])
        rest = {AGREES: "no seeds overlap", DIFFERS: "that is no gain", IN_PART: "the seeds overlap"}[state]
        words = told.format(better=spread(found[better]), worse=spread(found[worse]))
        return Finding(state, f"{words}: {rest}.")

    return judge


def _beside(one: str, other: str, told: str) -> Any:
    """Says how two cells score, where the paper has nothing of it; ``told`` has both, as ``{one}`` and ``{other}``."""

    def judge(results: Results) -> Finding | None:
        found = _cells(results)
        if one not in found or other not in found:
            return None
        return Finding(NEW, told.format(one=spread(found[one]), other=spread(found[other])))

    return judge


# ---- figure 3

_COMPARED = {"laplace": "Laplace DQN", "c51": "C51", "qrdqn": "QR-DQN", "dqn": "DQN"}
ENVIRONMENTS = ("CartPole-v1", "Acrobot-v1", "LunarLander-v3")
_FINAL = {"c51": "161.63", "qrdqn": "224.71", "laplace": "188.45"}
"""The paper's returns on LunarLander-v2 at full length, which table 1 has; figure 3 is a picture."""


def _shipped(agents: Path) -> Results:
    """The scores of every seed of the agents that ship."""
    from laplace_core.experiments.shipping import MANIFEST, manifest  # loads torch

    found: dict[str, Any] = {}
    for entry in manifest(agents):
        algorithm, _, environment = entry["file"].removesuffix(".safetensors").partition("_")
        if algorithm in _COMPARED and environment in ENVIRONMENTS:
            found.setdefault(environment, {})[algorithm] = [float(score) for score in entry["scores"]]
    count = sum(len(each) for each in found.values())
    planned = len(ENVIRONMENTS) * len(_COMPARED)
    return Results(agents / MANIFEST, count, planned, "agents", summary=found)


def _comparable(results: Results) -> Finding | None:
    words, states = [], []
    for environment in ENVIRONMENTS:
        found = results.summary.get(environment, {})
        peers = {name: found[name] for name in ("c51", "qrdqn") if name in found}
        if "laplace" not in found or not peers:
            continue
        mine = found["laplace"]
        # Comparable: its best seed reaches the worst seed of either peer.
        states.append(all(max(mine) >= min(each) for each in peers.values()))
        medians = [f"{_COMPARED[name]} {number(float(np.median(each)))}" for name, each in peers.items()]
        words.append(f"{environment} {number(float(np.median(mine)))} ({listed(medians)})")
    if not words:
        return None
    state = AGREES if all(states) else IN_PART if any(states) else DIFFERS
    return Finding(state, f"Medians of Laplace DQN's seeds, and of the peers': {'; '.join(words)}. In "
                   f"{sum(states)} of {len(states)} its best seed reaches the worst seed of each peer.")  # fmt: skip


def _fig3_lines(results: Results) -> list[Line]:
    lines = []
    for environment in ENVIRONMENTS:
        for name, title in _COMPARED.items():
            scores = results.summary.get(environment, {}).get(name)
            paper = f"{_FINAL[name]} (v2)" if environment == "LunarLander-v3" and name in _FINAL else ""
            paper = paper or ("a curve" if name in _FINAL else "")
            lines.append(Line(f"{environment}, {title}", paper, spread(scores) if scores else ""))
    return lines


FIG3 = Entry(
    name="fig3",
    place="Figure 3",
    title="Learning curves of C51, QR-DQN and Laplace DQN",
    claims=[Claim("Laplace DQN, acting at .99, has results comparable to C51's and QR-DQN's.", _comparable)],
    lines=_fig3_lines,
    command=f"{RUN} report shipped",
    view=View("train", {"environment": "LunarLander-v3"}),
    read=_shipped,
)


# ---- figure 7


def _not_without(results: Results) -> Finding | None:
    found = _cells(results)
    if "free" not in found:
        return None
    solved = sum(score >= _SOLVED for score in found["free"])
    state = AGREES if not solved else DIFFERS if solved == len(found["free"]) else IN_PART
    told = f"Without a constraint CartPole scores {spread(found['free'])}: {solved} of {len(found['free'])} solve it."
    return Finding(state, told)


def _accumulated(results: Results) -> Finding | None:
    found = _cells(results)
    if "accumulated" not in found:
        return None
    scores = found["accumulated"]
    solved = sum(score >= _SOLVED for score in scores)
    state = AGREES if solved == len(scores) else DIFFERS if not solved else IN_PART
    return Finding(state, f"Accumulated outputs score {spread(scores)}: {solved} of {len(scores)} solve it.")


def _softmax(results: Results) -> Finding | None:
    fast = {label: _learning(results, label) for label in ("softmax", "accumulated")}
    if not all(fast.values()):
        return None
    words = listed([f"{number(float(np.mean(each)))} with {label} outputs" for label, each in fast.items()])
    return Finding(NEW, f"The mean of all evaluations while training, which says how soon it learns, is {words}.")


FIG7 = Entry(
    name="fig7",
    place="Figure 7",
    title="Ways to keep the outputs monotone over the sensitivities",
    claims=[
        Claim("Without a constraint Laplace DQN cannot be trained to the optimum.", _not_without),
        Claim("Accumulated outputs can.", _accumulated),
        Claim("A softmax over the bins between sensitivities (not in the paper).", _softmax),
    ],
    lines=_lines("fig7", {"accumulated": "a curve", "clipped": "a curve", "free": "a curve"}),
    view=View("train", {"algorithm": "laplace", "environment": "CartPole-v1", "t.parametrisation": "accumulated"}),
)


# ---- table 2

_GAUSSIAN = ("Gaussian, std 20", "Gaussian, std 50")


def _uniform_is_best(results: Results) -> Finding | None:
    found = _cells(results)
    others = [label for label in _GAUSSIAN if label in found]
    if "uniform" not in found or not others:
        return None
    states = {_above(found["uniform"], found[label]) for label in others}
    words = listed([f"{label} {spread(found[label])}" for label in others])
    state = states.pop() if len(states) == 1 else IN_PART
    return Finding(state, f"Uniform sensitivities score {spread(found['uniform'])}, {words}.")


def _gaussian_fails(results: Results) -> Finding | None:
    found = {label: scores for label, scores in _cells(results).items() if label in _GAUSSIAN}
    if not found:
        return None
    fails = [np.mean(scores) < 0 for scores in found.values()]
    words = listed([f"{number(float(np.mean(scores)))} with {label}" for label, scores in found.items()])
    return Finding(AGREES if all(fails) else IN_PART if any(fails) else DIFFERS, f"The mean return is {words}.")


TABLE2 = Entry(
    name="table2",
    place="Table 2",
    title="Where the sensitivities lie",
    claims=[
        Claim("Uniform sensitivities score higher than ones that are dense around frequent rewards.", _uniform_is_best),
        Claim("With Gaussian spacing the agent does not learn to land (returns below 0).", _gaussian_fails),
    ],
    lines=_lines("table2", {"uniform": "188.45", "Gaussian, std 20": "-90.22", "Gaussian, std 50": "-203.77"}),
    view=View("train", {"algorithm": "laplace", "environment": "LunarLander-v3", "t.theta_spacing": "gaussian"}),
)  # fmt: skip


# ---- sections 2.3, 3.2, 3.3 and 5

MULTIPLEXER = Entry(
    name="multiplexer",
    place="Section 3.2 and figure 2",
    title="One network for all discounts, or three behind a multiplexer",
    claims=[
        Claim(
            "One network for all discounts trains unstably, and a multiplexer of three cures that.",
            _higher("multiplexer", "network", "The multiplexer scores {better}, one network {worse}"),
        ),
        Claim(
            "A shared trunk with heads of its own for each discount (not in the paper).",
            _beside("trunk", "multiplexer", "The trunk scores {one}, the multiplexer {other}."),
        ),
    ],
    lines=_lines("multiplexer", {"network": "unstable", "multiplexer": "188.45"}),
    view=View("train", {"algorithm": "laplace", "environment": "LunarLander-v3", "t.network": "multiplexer"}),
)


INTERPOLATION = Entry(
    name="interpolation",
    place="Section 3.3",
    title="Discounts that were never trained",
    claims=[Claim("The network interpolates the values at discounts that it was not trained with.", lambda _: None)],
    lines=lambda _: [],
    command=f"{RUN} report interpolation checkpoints/laplace_LunarLander-v3.safetensors",
    view=View("agents", {"checkpoint": "laplace_LunarLander-v3"}),
)


def _faster(environment: str) -> Any:
    def judge(results: Results) -> Finding | None:
        beside = _learning(results, f"{environment}, beside fourteen")
        alone = _learning(results, f"{environment}, alone")
        if not beside or not alone:
            return None
        state = _above(beside, alone)
        rest = {AGREES: "no seeds overlap", DIFFERS: "no gain", IN_PART: "the seeds overlap"}[state]
        return Finding(
            state,
            f"On {environment} the mean of all evaluations while training is {spread(beside)} beside fourteen others "
            f"and {spread(alone)} alone: {rest}.",
        )

    return judge


AUXILIARY = Entry(
    name="auxiliary",
    place="Section 2.3",
    title="Auxiliary learning: .99 alone and beside fourteen other discounts",
    claims=[
        Claim("Learning others too may make .99 learn faster (not measured in the paper).", _faster("CartPole")),
        Claim("The same on LunarLander.", _faster("LunarLander")),
    ],
    lines=_lines("auxiliary", {}),
    view=View("train", {"algorithm": "laplace", "environment": "CartPole-v1", "t.gammas": "1"}),
)  # fmt: skip

TERMINATION = Entry(
    name="termination",
    place="Section 5",
    title="The experiment that the paper proposes: auxiliary states behind the end",
    claims=[
        Claim(
            "Trained with auxiliary states until the time limit, Laplace DQN should act better.",
            _higher(
                "auxiliary", "plain", "Acting at .99, agents with auxiliary states score {better}, without {worse}"
            ),
        ),
        Claim(
            "States that pay 0 for ever, which is what a value of 0 behind the end means (not in the paper).",
            _beside("absorbing", "plain", "Agents with such states score {one}, without {other}."),
        ),
    ],
    lines=_lines("termination", {}),
    view=View("train", {"algorithm": "laplace", "environment": "LunarLander-v3", "t.termination": "auxiliary"}),
)


def _reaches(label: str, goal: float, words: str) -> Any:
    def judge(results: Results) -> Finding | None:
        found = _cells(results)
        if label not in found:
            return None
        scores = found[label]
        reached = sum(score >= goal for score in scores)
        state = AGREES if reached == len(scores) else DIFFERS if not reached else IN_PART
        return Finding(state, f"{label} scores {spread(scores)}: {reached} of {len(scores)} reach {words}.")

    return judge


PAPER_AGENT = Entry(
    name="paper_agent",
    place="Sections 3 to 3.3",
    title="The paper's whole recipe at once",
    claims=[
        Claim("It solves CartPole.", _reaches("CartPole", _SOLVED, "475, from which it counts as solved")),
        Claim("It reaches 188.45 on LunarLander.", _reaches("LunarLander", 188.45, "188.45")),
    ],
    lines=_lines("paper_agent", {"CartPole": "a curve", "LunarLander": "188.45"}),
    view=View("train", {"algorithm": "laplace", "environment": "LunarLander-v3", "t.experience": "per_discount"}),
)  # fmt: skip

_FLOOR = 240.0


def _no_seed_falls(results: Results) -> Finding | None:
    scores = [score for each in _cells(results).values() for score in each]
    if not scores:
        return None
    below = sum(score < _FLOOR for score in scores)
    return Finding(
        NEW,
        f"New seeds score {spread(scores)}, with a median of {number(float(np.median(scores)))}: "
        f"{below or 'none'} of them below {number(_FLOOR)}. The paper has 188.45, on LunarLander-v2.",
    )


NEW_AGENTS = Entry(
    name="new_agents",
    place="Beyond the paper",
    title="Laplace DQN on LunarLander, trained anew",
    claims=[Claim("With a target network that follows faster (not in the paper).", _no_seed_falls)],
    lines=_lines("new_agents", {"averaging .005": "188.45 (v2)"}),
    view=View("train", {"algorithm": "laplace", "environment": "LunarLander-v3", "t.averaging": "0.005"}),
)
