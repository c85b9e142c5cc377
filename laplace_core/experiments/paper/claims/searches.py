"""The entry of appendix C: the settings that the paper found, and the searches that are kept beside ours."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from laplace_core.experiments.paper.claims.entry import (
    AGREES,
    DIFFERS,
    NEW,
    RUN,
    Claim,
    Entry,
    Finding,
    Line,
    Results,
    View,
)
from laplace_core.experiments.paper.claims.words import listed, number
from laplace_core.experiments.search.results import read
from laplace_core.training.defaults import settings_of

LANDER, OTHERS = "LunarLander-v3", ("CartPole-v1", "Acrobot-v1")
PAPER_RATIO = 7.2
"""3 days of LunarLander to 10 hours of the others, 50 trainings each."""
_WITHIN = 2.0
"""Factor by which a ratio of times may differ and still agree."""
FOUND: Mapping[str, Mapping[str, str]] = {
    "qrdqn": {"batch": "128", "buffer": "100000", "epsilon_final": "0.04", "exploration": "0.16"},
    "c51": {"batch": "128", "atoms": "62", "learning_starts": "32", "update_every": "4", "learning_rate": "0.006"},
    "laplace": {"thetas": "500; 100 with many discounts", "gammas": "15, 5 a range",
                "learning_rate": "0.001; 0.005 with many discounts"},
}  # fmt: skip
"""Settings in the paper's table of hyperparameters, by algorithm and the name that ours have."""
_TITLES = {"qrdqn": "QR-DQN", "c51": "C51", "laplace": "Laplace DQN"}


def kept(agents: Path) -> Path:
    """The folder of the searches that are kept, in the repository that the agents ship with."""
    return agents.parent / "docs" / "searches"


def _sources(_: Path, agents: Path) -> list[Path]:
    return [kept(agents), *sorted(kept(agents).glob("*.json"))]


def _read(_: Path, agents: Path) -> Results:
    files = sorted(kept(agents).glob("*.json"))
    searches = [{"file": path.name, **read(path)} for path in files]
    return Results(kept(agents), len(files), len(files), "searches", rows=searches)


def _trainings(search: Mapping[str, Any]) -> int:
    return len(search["trials"]) * int(search["seeds"])


def _hours(search: Mapping[str, Any]) -> float:
    return sum(float(trial["seconds"]) for trial in search["trials"]) / 3600.0


def _extent(results: Results) -> Finding | None:
    if not results.rows:
        return None
    trainings, hours = sum(map(_trainings, results.rows)), sum(map(_hours, results.rows))
    return Finding(
        NEW,
        f"{len(results.rows)} searches are kept, with {trainings:,} trainings in {number(hours)} hours of one core. "
        "Every search varies settings around the shipped ones and scores several seeds of each.",
    )


def _lander_takes_longer(results: Results) -> Finding | None:
    """Hours of a training of LunarLander over those of one of the other environments."""
    spent: dict[bool, tuple[float, int]] = {}
    for search in results.rows:
        environment = search["settings"]["environment"]
        if environment in (LANDER, *OTHERS):
            hours, trainings = spent.get(environment == LANDER, (0.0, 0))
            spent[environment == LANDER] = hours + _hours(search), trainings + _trainings(search)
    if len(spent) < 2 or not all(hours > 0 for hours, _ in spent.values()):
        return None
    mean = {lander: 60.0 * hours / trainings for lander, (hours, trainings) in spent.items()}
    ratio = mean[True] / mean[False]
    state = AGREES if PAPER_RATIO / _WITHIN <= ratio <= PAPER_RATIO * _WITHIN else DIFFERS
    return Finding(
        state,
        f"A training of LunarLander takes {number(mean[True])} minutes in the mean and one of CartPole or Acrobot "
        f"{number(mean[False])}, {number(ratio)} times as long; the paper's 3 days are {PAPER_RATIO} times 10 hours.",
    )


def _what_helps(results: Results) -> Finding | None:
    """The change of one setting that gains most on LunarLander, for each algorithm that was searched one at a time."""
    best: dict[str, tuple[float, str, int]] = {}
    for search in results.rows:
        if not search["one_at_a_time"] or search["settings"]["environment"] != LANDER:
            continue
        usual, *changed = search["trials"]
        algorithm = search["file"].partition("_")[0]
        for trial in changed:
            gain = float(trial["median"]) - float(usual["median"])
            if algorithm not in best or gain > best[algorithm][0]:
                change = ", ".join(f"{name} {value}" for name, value in trial["trial"].items())
                best[algorithm] = gain, change, len(trial["scores"])
    if not best:
        return None
    gains = [
        f"{_titled(name)} gains {number(gain)} by {change} ({seeds} seeds)"
        for name, (gain, change, seeds) in best.items()
        if gain > 0
    ]
    none = [_titled(name) for name, (gain, *_) in best.items() if gain <= 0]
    words = [*gains, *([f"no single change gains anything for {listed(none)}"] if none else [])]
    return Finding(NEW, f"On LunarLander, over the median return with the settings of the search: {'; '.join(words)}.")


def _titled(algorithm: str) -> str:
    return _TITLES.get(algorithm, algorithm.upper())


def _lines(results: Results) -> list[Line]:
    lines = []
    for algorithm, found in FOUND.items():
        ours = settings_of(algorithm, LANDER, {}).as_dict()
        lines += [Line(f"{_TITLES[algorithm]}, {name}", paper, f"{ours[name]:g}") for name, paper in found.items()]
    return lines


SEARCH = Entry(
    name="search",
    place="Appendix C",
    title="The search for hyperparameters; ours are the shipped settings for LunarLander",
    claims=[
        Claim("Fifty trainings a search, two weeks in all, found the settings.", _extent),
        Claim("LunarLander took seven times as long as CartPole or Acrobot.", _lander_takes_longer),
        Claim("Which change of one setting gains most (not in the paper).", _what_helps),
    ],
    lines=_lines,
    command=f"{RUN} report searches docs/searches/*.json",
    view=View("train", {"environment": LANDER}),
    read=_read,
    sources=_sources,
)
