"""A race in words: its sides, who is ahead, the link of one side, and the command that prints the same."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from app.catalogue import checkpoints
from app.race.jobs import Control
from app.race.schema import AGAINST, AGENT
from laplace_core.acting.race import Race
from laplace_core.acting.rules import words_of
from laplace_core.words import capital


def sides(control: Control) -> tuple[str, str]:
    """Names of the left and the right side, that tell them apart."""
    left, right = words_of(control.left_rule), words_of(control.right_rule)
    if control.gamma is not None:
        left += f" (γ {control.gamma:.3g})"
    if control.left is control.right:
        return left, right
    if control.left.algorithm == control.right.algorithm:
        return f"{left}, other agent", right
    return f"{control.left.settings.TITLE}: {left}", f"{control.right.settings.TITLE}: {right}"


def alike(control: Control) -> bool:
    """Whether both sides are one and the same."""
    same = control.left is control.right and control.left_rule == control.right_rule
    return same and control.gamma is None


def verdict(race: Race, control: Control) -> tuple[str, str]:
    """``ahead``, ``behind`` or ``level``, and one sentence."""
    if alike(control):
        return "level", "Both sides act by the same rule: choose another one for either of them."
    left, right = sides(control)
    totals = [float(side.rewards.sum()) for side in (race.left, race.right)]
    where = f"Within {_steps(race.horizon)} from start {race.start}"
    if race.parting is None and len(race.left) == len(race.right):
        return "level", f"{where} both take the same actions: {totals[0]:.1f} each."
    if abs(race.difference) < 0.05:
        apart = f", by different actions from step {race.parting + 1} on" if race.parting is not None else ""
        return "level", f"{where}: {left} {totals[0]:.1f}, {right} {totals[1]:.1f}: level{apart}."
    leader = right if race.difference > 0 else left
    tone, lead = "ahead" if race.difference > 0 else "behind", abs(race.difference)
    returns = f"{where}: {left} {totals[0]:.1f}, {right} {totals[1]:.1f}"
    return tone, f"{returns}. {capital(leader)} is ahead by {lead:.1f}."


def field_verdict(summary: Mapping[str, Any], control: Control) -> tuple[str, str]:
    """The same for many races, from their summary."""
    left, right = sides(control)
    low, high = summary["interval"]
    count, mean = f"Over {summary['starts']} starts", float(summary["difference"])
    if summary["equal"] == 1.0:
        return "level", f"{count} both have the same return from every start."
    means = f"{count}: {left} {summary['left']:.1f}, {right} {summary['right']:.1f} on average"
    if low <= 0.0 <= high:
        return "level", f"{means}. The interval of the difference covers 0: these starts do not tell which is better."
    leader, tone = (right, "ahead") if mean > 0 else (left, "behind")
    return tone, f"{means}. {capital(leader)} is ahead by {abs(mean):.1f} ({_range(low, high)})."


def _range(low: float, high: float) -> str:
    """The interval of a lead, whoever leads."""
    return f"95% {min(abs(low), abs(high)):.1f} to {max(abs(low), abs(high)):.1f}"


def _steps(count: int) -> str:
    return f"{count} step" + ("" if count == 1 else "s")


def inside(control: Control, side: str, seed: int, step: int) -> dict[str, str]:
    """Values of the link that opens one side of a race on the page of trained agents, but for the agent's name."""
    rule = control.left_rule if side == "left" else control.right_rule
    query = {"r.shown": "yes", "r.seed": str(seed), "r.rule": rule, "r.at": str(max(0, step - 1))}
    if rule != "greedy":
        query["r.horizon"] = str(control.horizon)
    if side == "left" and control.gamma is not None:
        query["r.gamma"] = f"{control.gamma:.8g}"
    return query


def command(values: Mapping[str, Any], control: Control, count: int) -> str:
    """The command that prints the figures of many races."""
    words = ["laplace", "race", _file(str(values[AGENT])), "--horizon", str(control.horizon)]
    words += ["--rule", control.right_rule, "--against", control.left_rule]
    if AGAINST in values:
        words += ["--against-agent", _file(str(values[AGAINST]))]
    if control.gamma is not None:
        words += ["--gamma", f"{control.gamma:.8g}"]
    return " ".join([*words, "--seeds", str(count)])


def _file(name: str) -> str:
    """Where a checkpoint lies; of one that was opened only its owner knows."""
    if name.startswith(checkpoints.RUN):
        return f"runs/{name.removeprefix(checkpoints.RUN)}/best.safetensors"
    return f"checkpoints/{name}.safetensors" if name in checkpoints.shipped() else "opened.safetensors"
