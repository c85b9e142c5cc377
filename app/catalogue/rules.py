"""Control rules: what they are called, and which of them an agent can act by."""

from __future__ import annotations

from laplace_core.acting import rules
from laplace_core.acting.rollout import RANDOM
from laplace_core.acting.rules import RULES
from laplace_core.agents.agent import Agent
from laplace_core.agents.capabilities import HasDiscounts, HasTimeToGo

TITLES = {
    "greedy": ("greedy at a discount", "greedy"),
    "fading": ("for T: fading deadline", "fading deadline"),
    "readout": ("for T: readout of all discounts", "readout"),
    "decoded": ("for T: decoded tau-space (slow)", "decoded tau-space"),
    "certified": ("for T: greedy unless another action is certainly better", "certified"),
    "matched": ("for T: nearest discount", "nearest discount"),
    "own": ("for T: values of the steps to go", "learned values"),
    "random": ("random", "random"),
}
"""What rules are called in the form of a rollout, and in a sentence; a rule without a row goes by its own name."""


def title_of(rule: str) -> str:
    """What the form of a rollout calls a rule."""
    return TITLES.get(rule, (rule, rule))[0]


def name_of(rule: str) -> str:
    """What a sentence calls a rule."""
    return TITLES.get(rule, (rule, rule))[1]


def for_deadline(rule: str) -> bool:
    """Whether a rule acts for the T of an episode."""
    return rule != RANDOM and RULES[rule].for_deadline


def rules_of(agent: Agent) -> dict[str, str]:
    """Rules that an agent can act by with nothing given, the first one by default, and what they are called."""
    suitable = (name for name in rules.rules_of(agent) if not RULES[name].needs)
    titles = {name: title_of(name) for name in (*suitable, RANDOM)}
    if isinstance(agent, HasTimeToGo):
        titles["greedy"] = "greedy for the longest T"
    elif not isinstance(agent, HasDiscounts):
        titles["greedy"] = "greedy"
    return titles
