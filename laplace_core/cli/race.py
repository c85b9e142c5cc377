"""The verb ``race``: the worth of acting for a deadline, from held-out starts."""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING, Any

from laplace_core.cli.options import checked_number
from laplace_core.cli.rule_options import add_rule_options, rule_options
from laplace_core.errors import InputError

if TYPE_CHECKING:  # these bring torch along
    from laplace_core.acting.race import Race, Races


def add_race(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """The parser of the verb ``race``."""
    race = verbs.add_parser(
        "race",
        help="two ways to act, from the same starts to the same deadline",
        description="Races between two control rules, or two agents: who has the larger return after T steps. Starts "
        "are such that no agent was trained or chosen on. An option of a rule is for each side whose rule takes it.",
    )
    race.add_argument("checkpoint", metavar="CHECKPOINT", help="a .safetensors file of a trained agent")
    race.add_argument("--horizon", required=True, metavar="T", help="the deadline, in steps")
    race.add_argument("--rule", metavar="NAME", help="how it acts (default: for T as well as the agent can)")
    race.add_argument("--against", default="greedy", metavar="NAME", help="rule of the other side (default: greedy)")
    race.add_argument("--against-agent", metavar="CHECKPOINT", help="another agent for the other side")
    race.add_argument("--gamma", metavar="g", help="discount for the other side to be greedy at (default: acting one)")
    add_rule_options(race)
    race.add_argument("--seeds", metavar="N", help="how many starts, 2 to 500 (default: 100)")
    race.add_argument("--first", metavar="K", help="the first of them (default: 0)")
    race.add_argument("--start", metavar="K", help="only the race from this start, step by step")
    race.add_argument("--json", action="store_true", help="print JSON, with every return")
    race.set_defaults(run=run_race)


def run_race(options: argparse.Namespace) -> None:
    """One race, or many."""
    horizon = checked_number("horizon", options.horizon, int, 1, high=10_000)
    count = 100 if options.seeds is None else checked_number("seeds", options.seeds, int, 2, high=500)
    first = 0 if options.first is None else checked_number("first", options.first, int, 0, high=10**8)
    for name in ("seeds", "first"):
        if options.start is not None and getattr(options, name) is not None:
            raise InputError(f"--{name} changes nothing beside --start, which is one race: leave one of them out.")
    start = None if options.start is None else checked_number("start", options.start, int, 0, high=10**8)
    gamma = None if options.gamma is None else checked_number("gamma", options.gamma, float, 1e-6, high=0.999999)
    given = rule_options(options)
    from laplace_core.acting.race import Entrant, race, races
    from laplace_core.acting.rules import Options, check_rule_options, options_for, suited
    from laplace_core.training.checkpoint import load_checkpoint  # all three load torch

    loaded = load_checkpoint(options.checkpoint)
    other = load_checkpoint(options.against_agent) if options.against_agent else loaded
    if other.environment != loaded.environment:
        raise InputError(
            f"one agent is of {loaded.environment}, the other of {other.environment}: race two of one kind."
        )
    rule, against = options.rule or suited(loaded.agent, horizon), options.against
    check_rule_options(rule, [name for name in given if name not in options_for(against, given)])
    right = Entrant(loaded.agent, rule, options=Options(**options_for(rule, given)))
    left = Entrant(other.agent, against, gamma, Options(**options_for(against, given)))
    report = {
        "checkpoint": options.checkpoint, "environment": loaded.environment, "horizon": horizon,
        "rule": right.rule, "against": left.rule, "against_agent": options.against_agent, "gamma": gamma,
        "options": given,
    }  # fmt: skip
    if start is None:
        result = races(loaded.environment, left, right, horizon, count=count, first=first)
        _print_many(result, report | {"first": first}, as_json=options.json)
    else:
        _print_one(
            race(loaded.environment, left, right, start, horizon=horizon),
            report | {"start": start},
            as_json=options.json,
        )


def _print_many(result: Races, report: dict[str, Any], *, as_json: bool) -> None:
    summary = result.summary()
    if as_json:
        returns = {"left": result.left.tolist(), "right": result.right.tolist(), "all_starts": result.starts.tolist()}
        print(json.dumps(report | summary | {"notable": result.notable()} | {"returns": returns}))
        return
    low, high = summary["interval"]
    print(f"{report['environment']}, T = {result.horizon}, {summary['starts']} starts from {report['first']}")
    print(f"  {report['against']:>9} {summary['left']:9.2f}    mean return")
    print(f"  {report['rule']:>9} {summary['right']:9.2f}")
    print(f"  difference {summary['difference']:+8.2f}    95% {low:+.2f} to {high:+.2f}")
    print(f"  better {summary['better']:.0%}, equal {summary['equal']:.0%}, worse {summary['worse']:.0%}")
    if low <= 0.0 <= high:
        print("  the interval covers 0: these starts do not show which is better")


def _print_one(result: Race, report: dict[str, Any], *, as_json: bool) -> None:
    sides = {"left": result.left, "right": result.right}
    if as_json:
        report |= {"difference": result.difference, "parting": result.parting}
        report |= {f"{name}_actions": side.actions.tolist() for name, side in sides.items()}
        report |= {f"{name}_rewards": side.rewards.tolist() for name, side in sides.items()}
        print(json.dumps(report))
        return
    part = "never" if result.parting is None else f"first at step {result.parting + 1}"
    print(f"{report['environment']}, T = {result.horizon}, start {result.start}; the actions differ {part}")
    for rule, side in ((report["against"], result.left), (report["rule"], result.right)):
        print(f"  {rule:>9} {side.rewards.sum():9.2f} in {len(side)} steps")
    print(f"  difference {result.difference:+8.2f}")
