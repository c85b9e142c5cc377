"""Entries that are measured on worlds: figures 1, 4, 5 and 6, and section 6. No torch here."""

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
from laplace_core.experiments.paper.claims.words import fraction, listed, number

_CODES = {
    "categorical": "categorical",
    "quantile": "quantile",
    "expectile": "expectile",
    "plain": "plain mean",
    "laplace": "Laplace",
    "laplace, if steps were independent": "Laplace, if steps were independent",
}
_NEAR = 0.1
"""A code holds a distribution whose range it misses by less than this share of it (Wasserstein-1)."""


# ---- figures 1 and 5


def _codes_lines(results: Results) -> list[Line]:
    lines = []
    for name, code in results.summary.items():
        exact = "" if code["exact"] is None else f"exact {fraction(code['exact'])}, "
        spread = f"{fraction(code['low'])} to {fraction(code['high'])}, {code['of']} seeds"
        ours = f"{exact}learned {fraction(code['learned'])} ({spread})"
        lines.append(Line(f"{_CODES.get(name, name)}: W1", "" if "laplace" in name else "a picture", ours))
    return lines or [Line("distance of each code from the true return (W1)", "a picture")]


def _codes_hold_it(results: Results) -> Finding | None:
    shown = {
        name: results.summary[name] for name in ("categorical", "quantile", "expectile") if name in results.summary
    }
    if not shown:
        return None
    locations = results.rows[0]["result"]["truth"]["locations"]
    reach = locations[-1] - locations[0]
    *_, worst = ranked = sorted(shown, key=lambda name: shown[name]["learned"])
    best = ranked[0]
    far = [name for name, code in shown.items() if code["learned"] > _NEAR * reach]
    return Finding(
        IN_PART if 0 < len(far) < len(shown) else DIFFERS if far else AGREES,
        f"Learned, the {_CODES[best]} code lies {fraction(shown[best]['learned'])} from the true return and the "
        f"{_CODES[worst]} code {fraction(shown[worst]['learned'])} (W1), where returns range over {number(reach)}; "
        f"taken from the true return they lie {fraction(shown[best]['exact'])} and {fraction(shown[worst]['exact'])} "
        "from it.",
    )


FIG1_5 = Entry(
    name="fig1_5",
    place="Figures 1 and 5",
    title="Codes of one return",
    claims=[Claim("Categorical, quantile and expectile codes each approximate the distribution.", _codes_hold_it)],
    lines=_codes_lines,
    view=View("worlds", {"world": "fig6_chain", "source": "learned", "l.peers": "true"}),
)  # fmt: skip


# ---- figure 4

_ORIGINS = {"exact": "exact values", "tabular": "values of a table", "network": "values of a network"}
_ENDINGS = {"plain": "no auxiliary states", "auxiliary": "auxiliary states"}
_ROWS = {"paper": "rows rescaled", "none": "rows left alone"}


def _choices(results: Results, ending: str, rows: str) -> dict[str, Mapping[str, Any]]:
    """What each origin of the values chooses, by the origin; without those that are not measured."""
    named = {origin: f"{origin}, {ending}, rows {rows}" for origin in _ORIGINS}
    return {origin: results.summary[name] for origin, name in named.items() if name in results.summary}


def _toy_lines(results: Results) -> list[Line]:
    lines = []
    for ending, rows in (("plain", "paper"), ("auxiliary", "paper"), ("plain", "none"), ("auxiliary", "none")):
        paper = {"plain": "chooses action 0", "auxiliary": "chooses action 1"}[ending] if rows == "paper" else ""
        what, found = f"{_ENDINGS[ending]}, {_ROWS[rows]}", _choices(results, ending, rows)
        for origin, each in found.items():
            values = " v ".join(f"{value:.2f}" for value in each["values"])
            told = f"{values}: action 1 in {each['right']} of {each['of']}"
            lines.append(Line(f"{what}, {_ORIGINS[origin]}", paper if origin == "tabular" else "", told))
        if not found:
            lines.append(Line(what, paper))
    return lines


def _counted(found: Mapping[str, Mapping[str, Any]]) -> tuple[int, int, str]:
    """How many chose the better action, of how many, and each origin with its numbers."""
    words = [f"{each['right']} of {each['of']} with {_ORIGINS[origin]}" for origin, each in found.items()]
    return sum(each["right"] for each in found.values()), sum(each["of"] for each in found.values()), listed(words)


def _chooses(ending: str, rows: str, *, right: bool, lead: str) -> Any:
    """Judges whether the better action is chosen, where the paper says that it is (or is not)."""

    def judge(results: Results) -> Finding | None:
        found = _choices(results, ending, rows)
        if not found:
            return None
        chosen, count, words = _counted(found)
        agree = chosen if right else count - chosen
        values = next(iter(found.values()))["values"]
        state = AGREES if agree == count else DIFFERS if not agree else IN_PART
        told = f"{lead} V(0) is {values[0]:.2f} and V(1) {values[1]:.2f}: the better action 1 is chosen by {words}."
        return Finding(state, told)

    return judge


def _cause(results: Results) -> Finding | None:
    """Whether the early end alone causes the wrong action: not if rows that are left alone choose the right one."""
    rescaled, alone = _choices(results, "plain", "paper"), _choices(results, "plain", "none")
    if not rescaled or not alone:
        return None
    wrong = _counted(rescaled)[1] - _counted(rescaled)[0]
    chosen, count, words = _counted(alone)
    values = next(iter(alone.values()))["values"]
    lead = f"Without auxiliary states and with rows left alone V(0) is {values[0]:.2f} and V(1) {values[1]:.2f}:"
    if wrong and chosen == count:
        return Finding(
            DIFFERS,
            f"{lead} the better action is chosen by {words}. The cause is that rows are rescaled to a probability of "
            "1, which turns the rest after the end into a certain reward. An unscaled row adds up to the survival.",
        )
    return Finding(AGREES if not chosen else IN_PART, f"{lead} the better action is chosen by {words} only.")


FIG4 = Entry(
    name="fig4",
    place="Figure 4",
    title="The toy MDP: a reward that is repeated",
    claims=[
        Claim(
            "Going to tau-space and back makes the agent choose action 0, because its reward is repeated.",
            _chooses("plain", "paper", right=False, lead="With rescaled rows"),
        ),
        Claim(
            "With auxiliary states that pay 0 until all branches are equally long, it chooses action 1.",
            _chooses("auxiliary", "paper", right=True, lead="With auxiliary states and rescaled rows"),
        ),
        Claim("The cause is that an episode ends before the time limit.", _cause),
    ],
    lines=_toy_lines,
    view=View("worlds", {"world": "two_branch", "normalise": "paper", "alpha": "0.2", "horizon": "3"}),
)


# ---- figure 6

_WHOLE = 0.05
"""Share of the probability that may be misplaced in a timeline that counts as recovered."""


def _chain_lines(results: Results) -> list[Line]:
    paper = {"exact": "", "tabular": "a picture", "network": ""}
    lines = []
    for origin in _ORIGINS:
        each, what = results.summary.get(origin), f"misplaced probability, {_ORIGINS[origin]}"
        if each is None:
            lines.append(Line(what, paper[origin]))
            continue
        spread = (
            f" ({100 * each['low']:.1f} to {100 * each['high']:.1f}%, {each['of']} seeds)" if each["of"] > 1 else ""
        )
        lines.append(Line(what, paper[origin], f"{100 * each['mean']:.1f}%{spread}"))
    return lines


def _recovers(*origins: str) -> Any:
    def judge(results: Results) -> Finding | None:
        found = {origin: results.summary[origin]["mean"] for origin in origins if origin in results.summary}
        if not found:
            return None
        near = [error <= _WHOLE for error in found.values()]
        words = listed([f"{100 * error:.1f}% with {_ORIGINS[origin]}" for origin, error in found.items()])
        state = AGREES if all(near) else IN_PART if any(near) else DIFFERS
        told = f"At the best alpha the decoded timeline misplaces this share of the probability: {words}."
        exact = results.summary.get("exact", {"mean": 1.0})["mean"]
        rest = " With exact values nothing is lost, so the loss comes from errors of learning."
        return Finding(state, told if all(near) or exact > _WHOLE else told + rest)

    return judge


def _table_is_cleaner(results: Results) -> Finding | None:
    table, network = results.summary.get("tabular"), results.summary.get("network")
    if table is None or network is None:
        return None
    words = [
        f"{100 * each['mean']:.1f}% ({100 * each['low']:.1f} to {100 * each['high']:.1f}%, {each['of']} seeds)"
        for each in (table, network)
    ]
    state = AGREES if table["high"] < network["low"] else IN_PART if table["mean"] < network["mean"] else DIFFERS
    return Finding(state, f"A table misplaces {words[0]} of the probability and a network {words[1]}.")


FIG6 = Entry(
    name="fig6",
    place="Figure 6",
    title="The chain of four rewards, from gamma-space to tau-space",
    claims=[
        Claim("The code recovers all rewards at all future times.", _recovers("exact", "tabular")),
        Claim("Laplace DQN's gamma-space of a chain (appendix B.1) gives a timeline as well.", _recovers("network")),
        Claim("Learned in a table, gamma-space has less noise: tau-space is cleaner (section 4).", _table_is_cleaner),
    ],
    lines=_chain_lines,
    view=View("worlds", {"world": "fig6_chain"}),
)  # fmt: skip


# ---- section 2.3


_CHAINS = {"sure": "sure rewards", "coins": "rewards of a coin"}


def _after(each: Mapping[str, Any], when: str) -> str:
    """Episodes, or that a value is not accurate in most of the learners before the last look."""
    return f"{each[when]:,.0f}" if each[when] < 0.95 * each["played"] else f"more than {0.95 * each['played']:,.0f}"


def _timescale_lines(results: Results) -> list[Line]:
    lines = [
        Line(
            f"{_CHAINS.get(rewards, rewards)}, {left} to go",
            "",
            f"{_after(each, 'after')} episodes at {each['smallest']:.3f}, "
            f"{_after(each, 'its after')} at {each['largest']:g}, {each['of']} learner{'s' if each['of'] > 1 else ''}",
        )
        for rewards, distances in results.summary.items()
        for left, each in distances.items()
    ]
    return lines or [Line("episodes until a value is accurate")]


def _first_accurate(results: Results) -> Finding | None:
    """Whether the smallest discount is accurate first far from the end, for each kind of rewards."""
    words, states = [], []
    for rewards, distances in results.summary.items():
        left, kind = max(distances, key=int), _CHAINS.get(rewards, rewards)
        far = distances[left]
        states.append(far["after"] < far["its after"])
        words.append(
            f"with {kind}, {left} steps from the end, discount {far['smallest']:.3f} is within "
            f"a tenth after {_after(far, 'after')} episodes and {far['largest']:g} after {_after(far, 'its after')}"
        )
    if not words:
        return None
    state = AGREES if all(states) else IN_PART if any(states) else DIFFERS
    told = "; ".join(words)
    why = " A long discount waits for more steps to come back from the end, but averages more of the noise."
    return Finding(state, f"{told[0].upper()}{told[1:]}.{why if state == IN_PART else ''}")


TIMESCALES = Entry(
    name="timescales",
    place="Section 2.3, timescales",
    title="Which discount is accurate first",
    claims=[
        Claim(
            "At which discount a value is accurate first depends on how near the end is: far from it, at a short one.",
            _first_accurate,
        ),
    ],
    lines=_timescale_lines,
)


# ---- section 6

_TOLD_APART, _CHANCE = 0.9, 0.5


def _aliasing_lines(results: Results) -> list[Line]:
    return [
        Line(f"distinguished by the {_CODES.get(name, name)} code", "", f"{each['right']:g} of {each['of']:g}")
        for name, each in results.summary.items()
    ] or [Line("codes of two states that are distinguished")]


def _tells_apart(results: Results) -> Finding | None:
    if "laplace" not in results.summary:
        return None
    shares = {name: each["right"] / each["of"] for name, each in results.summary.items()}
    others = {name: share for name, share in shares.items() if name != "laplace"}
    best = max(others, key=lambda name: others[name])
    told, beaten = shares["laplace"] >= _TOLD_APART, others[best] < _TOLD_APART
    return Finding(
        AGREES if told and beaten else IN_PART if told else DIFFERS,
        f"Of two states with one distribution of the return, {100 * shares['laplace']:.0f}% of the learned Laplace "
        f"codes are distinguished, and at most {100 * others[best]:.0f}% of any other ({_CODES.get(best, best)}); "
        f"chance alone makes {100 * _CHANCE:.0f}%.",
    )


def _sees_when(results: Results) -> Finding | None:
    """What an agent decodes that cannot see which of the two states it is in."""
    eithers = [row["result"]["either"] for row in results.rows]
    if not eithers:
        return None
    truth = eithers[0]["true"]
    paid = [step for step, chance in enumerate(truth) if chance]
    decoded = [sum(each["decoded"][step] for each in eithers) / len(eithers) for step in paid]
    words = listed([f"{fraction(chance)} at step {step} (true {fraction(truth[step])})"
                    for step, chance in zip(paid, decoded, strict=True)])  # fmt: skip
    return Finding(
        NEW, f"To an agent that cannot see which of the two it is in, tau-space gives the reward a chance of {words}."
    )


ALIASING = Entry(
    name="aliasing",
    place="Section 6",
    title="State aliasing: two states that share their return",
    claims=[
        Claim("The Laplace code hedges against state aliasing to a greater extent than other codes.", _tells_apart),
        Claim("It could be useful where states are only partly observed (not measured in the paper).", _sees_when),
    ],
    lines=_aliasing_lines,
)
