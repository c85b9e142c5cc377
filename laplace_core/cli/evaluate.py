"""The verb ``evaluate``. torch is loaded when it runs."""

from __future__ import annotations

import argparse
import json

from laplace_core.cli.options import checked_number
from laplace_core.cli.rule_options import add_rule_options, rule_options


def add_evaluate(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """The parser of the verb ``evaluate``."""
    evaluate = verbs.add_parser(
        "evaluate",
        help="how well a checkpoint acts",
        description="Whole episodes without exploration, from held-out start seeds.",
    )
    evaluate.add_argument("checkpoint", metavar="CHECKPOINT", help="a .safetensors file of a trained agent")
    evaluate.add_argument("--episodes", default="100", metavar="N", help="how many (default: 100)")
    evaluate.add_argument("--seed", default="0", metavar="N", help="which start seeds (default: 0)")
    evaluate.add_argument("--horizon", metavar="T", help="act for an episode of T steps, by the time to go")
    evaluate.add_argument(
        "--rule",
        metavar="NAME",
        help="greedy, matched (the discount nearest to the time to go), fading, readout, decoded (the same, slowly) or "
        "own (of fixed_horizon); default: with a horizon fading or own where the agent can, else greedy",
    )
    add_rule_options(evaluate)
    evaluate.add_argument("--json", action="store_true", help="print JSON, with every return")
    evaluate.set_defaults(run=run_evaluate)


def run_evaluate(options: argparse.Namespace) -> None:
    """Evaluate one checkpoint."""
    episodes = checked_number("episodes", options.episodes, int, 1, high=100_000)
    seed = checked_number("seed", options.seed, int, 0, high=10**6)
    given = rule_options(options)
    horizon = None if options.horizon is None else checked_number("horizon", options.horizon, int, 1, high=10_000)
    from laplace_core.acting.evaluation import evaluate, own_discount, return_notes
    from laplace_core.acting.rules import check_rule_options, suited
    from laplace_core.training.checkpoint import load_checkpoint  # all three load torch

    loaded = load_checkpoint(options.checkpoint)
    rule = suited(loaded.agent, horizon) if options.rule is None else options.rule
    check_rule_options(rule, given)
    scores = evaluate(
        loaded.agent, loaded.environment, episodes=episodes, seed=seed, horizon=horizon, rule=rule,
        discounts=own_discount(loaded.agent), **given,
    )  # fmt: skip
    notes = return_notes(loaded.agent, scores)
    report = {
        "checkpoint": options.checkpoint, "algorithm": loaded.algorithm, "environment": loaded.environment,
        "rule": rule, "horizon": horizon, "episodes": episodes, "seed": seed, "mean": scores.mean,
        "standard_error": scores.standard_error, "notes": notes,
    }  # fmt: skip
    if options.json:
        print(json.dumps(report | {"returns": scores.returns.tolist(), "lengths": scores.lengths.tolist()}))
        return
    limit = "" if horizon is None else f", T = {horizon}"
    print(
        f"{loaded.algorithm} on {loaded.environment}, {rule}{limit}: {scores.mean:.2f} +- {scores.standard_error:.2f} "
        f"(standard error, {episodes} episodes), from {scores.returns.min():.1f} to {scores.returns.max():.1f}"
    )
    for note in notes:
        print(note)
