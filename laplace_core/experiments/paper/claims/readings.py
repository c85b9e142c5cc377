"""Entries whose trainings are read besides being scored: sections 3.3 and 5. No torch here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from laplace_core.acting.bootstrap import interval, mean_interval
from laplace_core.experiments.paper.claims.entry import (
    AGREES,
    DIFFERS,
    IN_PART,
    NEW,
    Claim,
    Entry,
    Finding,
    Line,
    Results,
    View,
)
from laplace_core.experiments.paper.claims.scores import Judge, beside
from laplace_core.experiments.paper.claims.words import fraction, listed, within
from laplace_core.experiments.paper.interpolation import NETWORKS
from laplace_core.experiments.paper.termination import ENDINGS, HORIZONS, READINGS


def readings_of(results: Results) -> dict[str, dict[int, Mapping[str, Any]]]:
    """What was read of the finished trainings, by the label of a cell and by seed."""
    found = {
        cell["label"]: {row["seed"]: row["reading"] for row in cell["trainings"] if row.get("reading")}
        for cell in results.cells
    }
    return {label: each for label, each in found.items() if each}


# ---- section 3.3


def held_out_errors(results: Results) -> dict[str, dict[str, list[float]]]:
    """Mean errors at the held-out discounts, a number a seed, by the label of a cell and how the values were read.

    ``network`` is the network's own value there, ``line`` a straight line between the discounts that it trained. A cell
    that trained all fifteen is read at the same discounts.
    """
    found = readings_of(results)
    trained = [each["trained"] for seeds in found.values() for each in seeds.values() if not all(each["trained"])]
    if not trained:
        return {}
    held = [i for i, kept in enumerate(trained[0]) if not kept]
    errors: dict[str, dict[str, list[float]]] = {}
    for label, seeds in found.items():
        for how in ("network", "line"):
            rows = [[each[how][i] for i in held] for each in seeds.values()]
            if all(value is not None for row in rows for value in row):
                errors.setdefault(label, {})[how] = [float(np.mean(row)) for row in rows]
    return errors


def _small(values: Sequence[float]) -> str:
    low, high = fraction(min(values)), fraction(max(values))
    return f"{fraction(float(np.mean(values)))} ({low} to {high}, {len(values)} seed{'s' if len(values) > 1 else ''})"


def _interpolates(environment: str) -> Judge:
    """Whether values at discounts that were held out are as near as those of a network that trained them."""

    def judge(results: Results) -> Finding | None:
        errors, states, words = held_out_errors(results), set(), []
        for network in NETWORKS:
            out = errors.get(f"{environment}, {network}, every other", {}).get("network")
            all_of_them = errors.get(f"{environment}, {network}, all fifteen", {}).get("network")
            if not out or not all_of_them:
                continue
            apart = min(out) > max(all_of_them)
            states.add(DIFFERS if apart else AGREES if np.mean(out) <= max(all_of_them) else IN_PART)
            name = "one network" if network == "network" else f"the {network}"
            words.append(f"{_small(out)} with {name}, and {_small(all_of_them)} where they were trained")
        if not words:
            return None
        told = f"At the discounts that were held out, values on {environment} are off by {listed(words)}"
        return Finding(states.pop() if len(states) == 1 else IN_PART, f"{told}; in reward a step.")

    return judge


def _by_line(results: Results) -> Finding | None:
    errors = held_out_errors(results)
    words = [
        f"{_small(each['line'])} by a line and {_small(each['network'])} by the network ({label.rpartition(',')[0]})"
        for label, each in errors.items()
        if "line" in each
    ]
    if not words:
        return None
    told = "A straight line between the trained neighbours needs no such network: values are off by"
    return Finding(NEW, f"{told} {listed(words)}.")


def _interpolation_lines(results: Results) -> list[Line]:
    errors = held_out_errors(results)
    return [
        Line(f"error at seven discounts, {label}", "", _small(each["network"])) for label, each in errors.items()
    ] or [Line("error of the values at the held-out discounts")]


INTERPOLATION = Entry(
    name="interpolation",
    place="Section 3.3",
    title="Discounts that were never trained",
    claims=[
        Claim(
            "The network interpolates the values at discounts that it was not trained with.", _interpolates("CartPole")
        ),
        Claim("The same on LunarLander.", _interpolates("LunarLander")),
        Claim("A straight line between trained discounts (not in the paper).", _by_line),
    ],
    lines=_interpolation_lines,
    view=View("agents", {"checkpoint": "laplace_LunarLander-v3"}),
)


# ---- section 5


def difference(results: Results, ending: str, reading: str, horizon: int) -> tuple[float, list[float]] | None:
    """Return with an ending less that without, both by one reading: mean and 95% interval over seeds and starts."""
    found = readings_of(results)
    seeds = sorted(set(found.get(ending, {})) & set(found.get("plain", {})))
    if not seeds:
        return None
    with_it, without = (
        np.array([found[label][seed][f"T {horizon}"][reading]["returns"] for seed in seeds])
        for label in (ending, "plain")
    )
    apart = with_it - without
    return float(apart.mean()), interval(apart) if len(apart) > 1 else mean_interval(apart[0])


def _differences(results: Results, ending: str, reading: str) -> tuple[list[str], list[list[float]]]:
    """The difference at each T in words, and its intervals."""
    known = {horizon: difference(results, ending, reading, horizon) for horizon in HORIZONS}
    there = {horizon: each for horizon, each in known.items() if each is not None}
    words = [f"{within(*each)} at T = {horizon}" for horizon, each in there.items()]
    return words, [each[1] for each in there.values()]


def _repairs(results: Results) -> Finding | None:
    words, intervals = _differences(results, "auxiliary", "rescaled")
    if not words:
        return None
    better = [low > 0 for low, _ in intervals]
    state = AGREES if all(better) else IN_PART if any(better) else DIFFERS
    return Finding(state, f"Acting on rescaled rows, agents with auxiliary states gain {listed(words)} of return.")


def _nothing_else(results: Results) -> Finding | None:
    words, intervals = _differences(results, "auxiliary", "left alone")
    if not words:
        return None
    same = [low <= 0 <= high for low, high in intervals]
    state = AGREES if all(same) else IN_PART if any(same) else DIFFERS
    return Finding(state, f"Acting on rows that keep the survival, they gain {listed(words)}.")


def _absorbing(results: Results) -> Finding | None:
    rescaled, alone = (_differences(results, "absorbing", reading)[0] for reading in READINGS)
    if not rescaled:
        return None
    return Finding(
        NEW, f"Such states gain {listed(rescaled)} with rescaled rows, and {listed(alone)} with rows left alone."
    )


def _termination_lines(results: Results) -> list[Line]:
    found, lines = readings_of(results), []
    for horizon in HORIZONS:
        for reading in ("greedy", *READINGS):
            for ending in ENDINGS:
                seeds = found.get(ending, {}).values()
                returns = np.array([each[f"T {horizon}"][reading]["returns"] for each in seeds])
                if not len(returns):
                    continue
                wide = interval(returns) if len(returns) > 1 else mean_interval(returns[0])
                what = reading if reading == "greedy" else f"rows {reading}"
                agents = f"{len(returns)} agent{'s' if len(returns) > 1 else ''} x {returns.shape[1]}"
                lines.append(
                    Line(f"T {horizon}, {what}: {ending}", "", f"{within(float(returns.mean()), wide)}, {agents}")
                )
    return lines or [Line(f"return until T by rows {reading}, {ending}") for reading in READINGS for ending in ENDINGS]


TERMINATION = Entry(
    name="termination",
    place="Section 5",
    title="The experiment that the paper proposes: auxiliary states after the end",
    claims=[
        Claim(
            "Trained with auxiliary states until the time limit, Laplace DQN should act better for another horizon.",
            _repairs,
        ),
        Claim(
            "They repair the reward that rescaled rows repeat; where rows keep the survival they change nothing "
            "(what the explanation predicts, not said in the paper).",
            _nothing_else,
        ),
        Claim("States that pay 0 for ever, as if the value after the end were 0 (not in the paper).", _absorbing),
        Claim(
            "Acting at .99 in whole episodes (not in the paper).",
            beside("auxiliary", "plain", "Agents with auxiliary states score {one}, without {other}."),
        ),
    ],
    lines=_termination_lines,
    view=View("train", {"algorithm": "laplace", "environment": "LunarLander-v3", "t.termination": "auxiliary"}),
)  # fmt: skip
