"""Entries of acting for another horizon: table 1, and acting through tau-space. No torch here."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

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
from laplace_core.experiments.paper.claims.words import listed, number, within

PAPER = {
    "c51": {"50": 26.51, "100": 67.28, "200": 121.47, "full": 161.63},
    "qrdqn": {"50": 16.53, "100": 48.58, "200": 65.65, "full": 224.71},
    "laplace": {"50": 2.14, "100": 52.32, "200": 57.42, "full": 188.45},
}
"""Table 1 of the paper, LunarLander-v2, by algorithm and T."""
TITLES = {
    "c51, greedy": "C51",
    "qrdqn, greedy": "QR-DQN",
    "dqn, greedy": "DQN",
    "laplace, greedy": "Laplace, greedy",
    "laplace, matched": "Laplace, matched",
    "laplace, fading": "Laplace, fading",
    "laplace, as in the paper": "Laplace, decoded as in the paper",
    "laplace, 6 mended": "the same, six faults mended",
}
"""Rows of the table by their names in the results."""
HORIZONS = ("50", "100", "200", "full")
_LANDER = "LunarLander-v3, T "
_FAULTS = {
    "rescaled": "rows left alone",
    "folded": "more rows than T",
    "constant": "time to go in place of T",
    "linear": "the trained discounts only",
    "closed": "rewards beyond the sensitivities counted",
    "hard": "a soft deadline",
}


def of_paper(name: str, horizon: str) -> float | None:
    """The paper's number for a row of ours; its Laplace DQN acted on the decoded timeline."""
    row = {"c51, greedy": "c51", "qrdqn, greedy": "qrdqn", "laplace, as in the paper": "laplace"}.get(name)
    return None if row is None else PAPER[row][horizon]


def columns(results: Results) -> dict[str, Mapping[str, Any]]:
    """Measured returns on LunarLander, by T."""
    found = {horizon: results.summary.get(_LANDER + horizon, {}) for horizon in HORIZONS}
    return {horizon: column for horizon, column in found.items() if column}


def _lines(results: Results) -> list[Line]:
    lines, found = [], columns(results)
    for horizon in HORIZONS:
        for name, title in TITLES.items():
            row, paper = found.get(horizon, {}).get(name), of_paper(name, horizon)
            if row is not None or paper is not None:
                ours = "" if row is None else f"{within(row['mean'], row['interval'])}, {_counted(row)}"
                lines.append(Line(f"T {horizon}: {title}", "" if paper is None else f"{paper:.2f}", ours))
    return lines


def _counted(row: Mapping[str, Any]) -> str:
    return f"{row['agents']} agent{'s' if row['agents'] > 1 else ''} x {row['episodes']}"


def _when(horizon: str) -> str:
    return "in full" if horizon == "full" else f"at T = {horizon}"


def _adapts(results: Results) -> Finding | None:
    """Whether acting for the deadline is above the best peer: certainly, by the interval, or not."""
    words, above = [], []
    for horizon, column in columns(results).items():
        mine, peers = column.get("laplace, fading"), [name for name in column if name.endswith(", greedy")]
        peers = [name for name in peers if not name.startswith("laplace")]
        if mine is None or not peers or horizon == "full":
            continue
        best = max(peers, key=lambda name: column[name]["mean"])
        above.append(mine["interval"][0] > column[best]["mean"])
        best_peer = f"best peer {TITLES[best]}, {number(column[best]['mean'])}"
        words.append(f"{within(mine['mean'], mine['interval'])} {_when(horizon)} ({best_peer})")
    if not words:
        return None
    state = DIFFERS if all(above) else IN_PART if any(above) else AGREES
    return Finding(state, f"By the rule fading Laplace DQN scores {listed(words)}.")


def _decoded_as_in_the_paper(results: Results) -> Finding | None:
    words, gains = [], []
    for horizon, column in columns(results).items():
        decoded, greedy = column.get("laplace, as in the paper"), column.get("laplace, greedy")
        if decoded is None or greedy is None:
            continue
        gains.append(decoded["interval"][0] > greedy["mean"])
        score = within(decoded["mean"], decoded["interval"])
        words.append(f"{score} {_when(horizon)} (greedy {number(greedy['mean'])})")
    if not words:
        return None
    state = DIFFERS if all(gains) else IN_PART if any(gains) else AGREES
    return Finding(state, f"Decoded as in the paper it scores {listed(words)}.")


def _unchanged(results: Results) -> Finding | None:
    """Elsewhere no rule scores otherwise than greedy, as a policy that does not depend on T would."""
    same: dict[str, list[str]] = {}
    other = []
    for name, column in results.summary.items():
        environment, _, horizon = name.partition(", T ")
        greedy, fading = column.get("laplace, greedy"), column.get("laplace, fading")
        if name.startswith(_LANDER) or greedy is None or fading is None:
            continue
        low, high = fading["interval"]
        if low <= greedy["mean"] <= high:
            same.setdefault(environment, []).append(f"{number(fading['mean'])} {_when(horizon)}")
        else:
            score = within(fading["mean"], fading["interval"])
            other.append(f"{environment} {number(greedy['mean'])} greedy and {score} fading {_when(horizon)}")
    words = [f"the same by greedy and fading on {environment} ({listed(each)})" for environment, each in same.items()]
    if not words and not other:
        return None
    state = AGREES if not other else IN_PART if words else DIFFERS
    return Finding(state, f"Returns are {listed([*words, *other])}.")


def _repairs(results: Results) -> Finding | None:
    words = []
    for horizon, column in columns(results).items():
        worth = {fault: column[f"{fault} mended, then"] for fault in _FAULTS if f"{fault} mended, then" in column}
        first, last = column.get("laplace, as in the paper"), column.get("laplace, 6 mended")
        if not worth or first is None or last is None:
            continue
        most = max(worth, key=lambda fault: worth[fault]["mean"])
        gain = within(worth[most]["mean"], worth[most]["interval"])
        words.append(
            f"from {number(first['mean'])} to {number(last['mean'])} {_when(horizon)} ({_FAULTS[most]}: {gain})"
        )
    told = "Repairing six faults one after another changes the return"
    return Finding(NEW, f"{told} {listed(words)}; in brackets the repair that is worth most.") if words else None


def _rescaled(results: Results) -> Finding | None:
    """Whether leaving the rows alone, and nothing else, gains return on LunarLander."""
    words, gains = [], []
    for horizon, column in columns(results).items():
        worth = column.get("rescaled mended, alone")
        if worth is not None:
            words.append(f"{within(worth['mean'], worth['interval'])} {_when(horizon)}")
            gains.append(worth["interval"][0] > 0)
    if not words:
        return None
    state = AGREES if all(gains) else IN_PART if any(gains) else DIFFERS
    return Finding(state, f"Decoded as in the paper except that rows are left alone, it gains {listed(words)}.")


TABLE1 = Entry(
    name="table1",
    place="Table 1",
    title="LunarLander with T = 50, 100, 200 and in full",
    claims=[
        Claim("Laplace DQN has no benefit from the change of the horizon: a peer is better at every short T.", _adapts),
        Claim("Acting on the decoded timeline is no better than not adapting.", _decoded_as_in_the_paper),
        Claim(
            "On LunarLander, too, a reward that is repeated after the end misleads the agent (section 5).", _rescaled
        ),
        Claim("On CartPole and Acrobot the policy does not change with T.", _unchanged),
        Claim("What each fault of the paper's decoding costs (not in the paper).", _repairs),
    ],
    lines=_lines,
    view=View("race", {"checkpoint": "laplace_LunarLander-v3", "d.T": "50"}),
)

_RULES = ("greedy", "matched", "fading", "certified")


def _acting_lines(results: Results) -> list[Line]:
    lines = []
    for horizon in HORIZONS:
        for rule, row in results.summary.get(f"T {horizon}", {}).items():
            against = row.get("against greedy")
            gain = (
                f", {within(against['mean'], against['interval'])} against greedy"
                if against and rule != "greedy"
                else ""
            )
            name = rule if rule in _RULES else f"tau-space by {rule}"
            lines.append(Line(f"T {horizon}: {name}", "", f"{number(row['mean'])}, {_counted(row)}{gain}"))
    return lines


def _through_tau_space(against: str, rest: str) -> Any:
    def judge(results: Results) -> Finding | None:
        words, gains = [], []
        for horizon in HORIZONS:
            column = results.summary.get(f"T {horizon}", {})
            known = {rule: row[f"against {against}"] for rule, row in column.items()
                     if rule not in _RULES and f"against {against}" in row}  # fmt: skip
            if not known:
                continue
            best = max(known, key=lambda rule: known[rule]["mean"])
            gains.append(known[best]["interval"][0] > 0)
            words.append(f"{within(known[best]['mean'], known[best]['interval'])} {_when(horizon)} ({best})")
        if not words:
            return None
        state = AGREES if all(gains) else IN_PART if any(gains) else DIFFERS
        return Finding(state, f"The best solver's difference from {against}{rest} is {listed(words)}.")

    return judge


def _neural(results: Results) -> Finding | None:
    """Whether the fitted network acts better than the SVD-based inverse, on the same agents and starts."""
    words, better = [], []
    for horizon in HORIZONS:
        column = results.summary.get(f"T {horizon}", {})
        gains = {name: column.get(name, {}).get("against greedy") for name in ("neural", "tikhonov")}
        if all(gains.values()):
            better.append(gains["neural"]["mean"] > gains["tikhonov"]["mean"])
            both = " and ".join(within(each["mean"], each["interval"]) for each in gains.values())
            words.append(f"{both} {_when(horizon)}")
    if not words:
        return None
    state = AGREES if all(better) else IN_PART if any(better) else DIFFERS
    return Finding(
        state, f"The differences from greedy of the network and of the SVD-based inverse are {listed(words)}."
    )


ACTING = Entry(
    name="acting",
    place="Sections 2.2 and 6",
    title="Acting through tau-space, by every solver of the inverse",
    claims=[
        Claim("Tau-space lets an agent act for a shorter time at once.", _through_tau_space("greedy", "")),
        Claim(
            "It is what an agent needs for that: no other rule does as well (not measured in the paper).",
            _through_tau_space("fading", ", which decodes nothing,"),
        ),
        Claim("A network in place of the SVD-based inverse, which is sensitive to noise, may act better.", _neural),
    ],
    lines=_acting_lines,
    view=View("race", {"checkpoint": "laplace_LunarLander-v3", "d.T": "50", "d.right": "decoded"}),
)
