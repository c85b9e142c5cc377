"""Entries that are trained and judged by their scores: figure 7, table 2, sections 2.3 and 3. No torch here."""

from __future__ import annotations

import numpy as np

from laplace_core.experiments.paper.claims.entry import (
    AGREES,
    DIFFERS,
    IN_PART,
    NEW,
    Claim,
    Entry,
    Finding,
    Results,
    View,
)
from laplace_core.experiments.paper.claims.scores import (
    SOLVED,
    Judge,
    above,
    beside,
    cells_of,
    higher,
    learning,
    lines_of,
)
from laplace_core.experiments.paper.claims.words import listed, number, spread

# ---- figure 7


def _not_without(results: Results) -> Finding | None:
    found = cells_of(results)
    if "free" not in found:
        return None
    solved = sum(score >= SOLVED for score in found["free"])
    state = AGREES if not solved else DIFFERS if solved == len(found["free"]) else IN_PART
    told = f"Without a constraint CartPole scores {spread(found['free'])}: {solved} of {len(found['free'])} solve it."
    return Finding(state, told)


def _solves(label: str, told: str) -> Judge:
    def judge(results: Results) -> Finding | None:
        found = cells_of(results)
        if label not in found:
            return None
        scores = found[label]
        solved = sum(score >= SOLVED for score in scores)
        state = AGREES if solved == len(scores) else DIFFERS if not solved else IN_PART
        return Finding(state, f"{told} score {spread(scores)}: {solved} of {len(scores)} solve it.")

    return judge


def _softmax(results: Results) -> Finding | None:
    fast = {label: learning(results, label) for label in ("softmax", "accumulated")}
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
        Claim("Accumulated outputs can.", _solves("accumulated", "Accumulated outputs")),
        Claim(
            "Outputs that are clipped to their left neighbour can, too.",
            _solves("clipped", "Clipped outputs"),
        ),
        Claim("A softmax over the bins between sensitivities (not in the paper).", _softmax),
    ],
    lines=lines_of("fig7", {"accumulated": "a curve", "clipped": "a curve", "free": "a curve"}),
    view=View("train", {"algorithm": "laplace", "environment": "CartPole-v1", "t.parametrisation": "accumulated"}),
)


# ---- table 2

_GAUSSIAN = ("Gaussian, std 20", "Gaussian, std 50")


def _uniform_is_best(results: Results) -> Finding | None:
    found = cells_of(results)
    others = [label for label in _GAUSSIAN if label in found]
    if "uniform" not in found or not others:
        return None
    states = {above(found["uniform"], found[label]) for label in others}
    words = listed([f"{label} {spread(found[label])}" for label in others])
    state = states.pop() if len(states) == 1 else IN_PART
    return Finding(state, f"Uniform sensitivities score {spread(found['uniform'])}, {words}.")


def _gaussian_fails(results: Results) -> Finding | None:
    found = {label: scores for label, scores in cells_of(results).items() if label in _GAUSSIAN}
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
    lines=lines_of("table2", {"uniform": "188.45", "Gaussian, std 20": "-90.22", "Gaussian, std 50": "-203.77"}),
    view=View("train", {"algorithm": "laplace", "environment": "LunarLander-v3", "t.theta_spacing": "gaussian"}),
)  # fmt: skip


# ---- sections 2.3 and 3

MULTIPLEXER = Entry(
    name="multiplexer",
    place="Section 3.2 and figure 2",
    title="One network for all discounts, or three behind a multiplexer",
    claims=[
        Claim(
            "One network for all discounts trains unstably, and a multiplexer of three cures that.",
            higher("multiplexer", "network", "The multiplexer scores {better}, one network {worse}"),
        ),
        Claim(
            "A shared trunk with a separate head for each discount (not in the paper).",
            beside("trunk", "multiplexer", "The trunk scores {one}, the multiplexer {other}."),
        ),
    ],
    lines=lines_of("multiplexer", {"network": "unstable", "multiplexer": "188.45"}),
    view=View("train", {"algorithm": "laplace", "environment": "LunarLander-v3", "t.network": "multiplexer"}),
)


def _faster(environment: str) -> Judge:
    def judge(results: Results) -> Finding | None:
        beside = learning(results, f"{environment}, beside fourteen")
        alone = learning(results, f"{environment}, alone")
        if not beside or not alone:
            return None
        state = above(beside, alone)
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
    lines=lines_of("auxiliary", {}),
    view=View("train", {"algorithm": "laplace", "environment": "CartPole-v1", "t.gammas": "1"}),
)  # fmt: skip


def _reaches(label: str, goal: float, words: str) -> Judge:
    def judge(results: Results) -> Finding | None:
        found = cells_of(results)
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
        Claim("It solves CartPole.", _reaches("CartPole", SOLVED, "475, from which it counts as solved")),
        Claim("It reaches 188.45 on LunarLander.", _reaches("LunarLander", 188.45, "188.45")),
    ],
    lines=lines_of("paper_agent", {"CartPole": "a curve", "LunarLander": "188.45"}),
    view=View("train", {"algorithm": "laplace", "environment": "LunarLander-v3", "t.experience": "per_discount"}),
)  # fmt: skip

_FLOOR = 240.0


def _no_seed_falls(results: Results) -> Finding | None:
    scores = [score for each in cells_of(results).values() for score in each]
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
    title="Laplace DQN on LunarLander, trained again",
    claims=[Claim("With a target network that follows faster (not in the paper).", _no_seed_falls)],
    lines=lines_of("new_agents", {"averaging .005": "188.45 (v2)"}),
    view=View("train", {"algorithm": "laplace", "environment": "LunarLander-v3", "t.averaging": "0.005"}),
)
