"""``python -m laplace_core VERB``: exit 0, or 2 and one line on stderr for bad input."""

from __future__ import annotations

import argparse
import io
import json
import re
import sys
from collections.abc import Sequence
from functools import cache
from typing import NoReturn

import numpy as np

from laplace_core.agents.settings import SETTINGS
from laplace_core.cli.check import add_check
from laplace_core.cli.evaluate import add_evaluate
from laplace_core.cli.grid import add_grid
from laplace_core.cli.learn import add_learn
from laplace_core.cli.options import action_runs, study_notes
from laplace_core.cli.race import add_race
from laplace_core.cli.report import add_report
from laplace_core.cli.reproduce import add_reproduce
from laplace_core.cli.search import add_search
from laplace_core.cli.stop import by_exception
from laplace_core.cli.study import add_study
from laplace_core.cli.subject import add_subject, study_of_options
from laplace_core.cli.sweep import add_sweep
from laplace_core.cli.train import add_train
from laplace_core.cli.train_inverse import add_train_inverse
from laplace_core.code.ties import ROUNDING
from laplace_core.errors import InputError
from laplace_core.interrupt import LINE, STATUS
from laplace_core.study.artefacts import Artefact
from laplace_core.study.explanation import explain
from laplace_core.study.npz import save_study
from laplace_core.study.pipeline import Study
from laplace_core.study.settings import SCHEMA, flag
from laplace_core.study.verdict import Verdict, judge
from laplace_core.tabular.settings import LEARN_SCHEMA
from laplace_core.worlds import PRESETS, TOY_TEXT


class _Parser(argparse.ArgumentParser):
    """argparse, with its errors in one line."""

    def error(self, message: str) -> NoReturn:
        named = re.sub(r"'([^']{40})[^']+'", r"'\1...'", message)  # as much of a long word as names it
        raise InputError(f"{named} (see {self.prog} --help)")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one verb; returns the exit status."""
    if isinstance(sys.stdout, io.TextIOWrapper):  # a terminal without the letters of a name shows their numbers
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        with by_exception():
            options = parser().parse_args(_joined(sys.argv[1:] if argv is None else argv))
            options.run(options)
    except InputError as error:
        print(f"laplace: {' '.join(str(error).split())}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print(LINE, file=sys.stderr)
        return STATUS
    except BrokenPipeError:  # the reader of a pipe has seen enough
        sys.stderr.close()
    return 0


def _joined(words: Sequence[str]) -> list[str]:
    """``--theta-min -1e-5`` as ``--theta-min=-1e-5``: argparse would take the value for an option."""
    schemas = (SCHEMA, LEARN_SCHEMA, *(kind.SCHEMA for kind in SETTINGS.values()))
    valued = {flag(parameter) for schema in schemas for parameter in schema if parameter.type is not bool}
    valued |= {"--param", "--out"}
    joined: list[str] = []
    for word in words:
        if joined and joined[-1] in valued and word.startswith("-") and not word.startswith("--"):
            joined[-1] += f"={word}"
        else:
            joined.append(word)
    return joined


@cache
def parser() -> argparse.ArgumentParser:
    """The whole parser, with a parser for each verb."""
    parser: argparse.ArgumentParser = _Parser(
        prog="laplace", description="The Laplace code: gamma-space, tau-space and the actions they choose."
    )
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="VERB")

    worlds = verbs.add_parser("worlds", help="list the preset worlds and their parameters")
    worlds.add_argument("--json", action="store_true", help="print JSON")
    worlds.set_defaults(run=_worlds)

    decode = verbs.add_parser(
        "decode",
        help="decode one state of a world",
        description="From a world's exact gamma-space to its tau-space and the action of every horizon. "
        "Every option has a default that suits the world.",
    )
    add_subject(decode)
    decode.add_argument(
        "--explain", action="store_true", help="search for the cause of what is wrong: every single setting is tried"
    )
    decode.add_argument("--out", metavar="FILE.npz", help="write all arrays and the settings here")
    decode.add_argument("--json", action="store_true", help="print JSON")
    decode.set_defaults(run=_decode)
    add_study(verbs)
    add_sweep(verbs)
    add_check(verbs)
    add_learn(verbs)
    add_train(verbs)
    add_evaluate(verbs)
    add_race(verbs)
    add_report(verbs)
    add_search(verbs)
    add_reproduce(verbs)
    add_grid(verbs)
    add_train_inverse(verbs)
    return parser


def _worlds(options: argparse.Namespace) -> None:
    if options.json:
        listed = [
            {
                "name": preset.name,
                "title": preset.title,
                "summary": preset.summary,
                "parameters": [
                    {"name": p.name, "default": p.default, "low": low, "high": high, "help": p.help}
                    for p in preset.parameters
                    for low, high in [(0, 1) if p.type is bool else p.bounds]
                ],
            }
            for preset in PRESETS.values()
        ]
        print(json.dumps({"presets": listed, "gym": list(TOY_TEXT)}, indent=1))
        return
    for preset in PRESETS.values():
        print(f"{preset.name}\n    {preset.summary}")
        for p in preset.parameters:
            default = str(p.default).lower() if p.type is bool else f"{p.default:g}"
            print(f"    {p.name}={default:8} {p.help}")
    for name, parameters in TOY_TEXT.items():
        print(f"gym:{name}")
        for p in parameters:
            print(f"    {p.name}={str(p.default).lower():8} {p.help}")


def _decode(options: argparse.Namespace) -> None:
    if options.out is not None and not options.out.lower().endswith(".npz"):
        raise InputError(f"--out {options.out[:60]!r} must end in .npz.")
    result = study_of_options(options)
    if options.out is not None:
        save_study(result, options.out)
    row = result.row
    verdict, listed = judge(result, row, explain=False), None
    if options.explain:
        made = explain(result, row, verdict.chosen)
        verdict, listed = made.verdict, list(made.artefacts)
    if options.json:
        print(json.dumps(summary(result) | {"verdict": _verdict(result, row, verdict, listed)}, indent=1))
    else:
        print("\n".join([_report(result), *_verdict_lines(result, verdict, listed)]))


def _verdict(result: Study, row: int, verdict: Verdict, listed: list[Artefact] | None) -> dict[str, object]:
    """The verdict at one horizon, for JSON; causes, remedies and artefacts only where they were searched for."""
    payload: dict[str, object] = {
        "horizon": float(result.horizons[row]),
        "choice": verdict.choice,
        "chosen": result.action_names[verdict.chosen],
        "timeline": verdict.timeline,
        "timeline_error": verdict.timeline_error,
        "value_error": verdict.value_error,
        "regret": verdict.regret,
        "sentence": verdict.sentence,
    }
    if listed is None:
        return payload
    remedies = [{"label": remedy.label, "changes": dict(remedy.changes)} for remedy in verdict.remedies]
    return payload | {
        "cause": verdict.cause.name if verdict.cause else None,
        "remedies": remedies,
        "exhausted": verdict.exhausted,
        "artefacts": [{"name": each.name, "size": each.size, "shown": each.shown} for each in listed],
    }


def _verdict_lines(result: Study, verdict: Verdict, listed: list[Artefact] | None) -> list[str]:
    lines = [f"verdict       {verdict.sentence}"]
    if listed is None:
        return lines
    lines += [f"remedy        {remedy.label}" for remedy in verdict.remedies]
    name = result.action_names[verdict.chosen]
    return lines + [f"artefact      {each.name}, in {name}: {each.shown}. {each.sentence}" for each in listed]


def summary(result: Study) -> dict[str, object]:
    """The summary that ``decode`` prints: expected rewards, values at the longest horizon, and the chosen actions."""
    decoded, truth = result.decoded, result.truth
    payload: dict[str, object] = {
        "settings": {**vars(result.settings), "params": dict(result.settings.params)},
        "alpha_record": json.loads(result.alpha_record.as_json()),
        "actions": list(result.action_names),
        "expected_reward": decoded.expected_reward.tolist(),
        "survival": decoded.survival.tolist(),
        "horizon_values": decoded.horizon_values.tolist(),
        "chosen_action": decoded.actions.tolist(),
        "notes": study_notes(result),
    }
    if truth is not None:
        payload |= {
            "true_expected_reward": truth.expected_reward.tolist(),
            "true_horizon_values": truth.horizon_values.tolist(),
            "optimal_action": truth.optimal_action.tolist(),
        }
    return payload


def _report(result: Study, most: int = 8) -> str:
    s, decoded, truth = result.settings, result.decoded, result.truth
    rows = min(s.steps, most)
    more = " ..." if s.steps > rows else ""
    lines = [
        f"{s.world}, state {s.state or 0}: "
        f"{len(result.gamma_space.gammas)} discounts, {len(result.gamma_space.thetas)} sensitivities, "
        f"{_inverse(result)}, {s.steps} {'step' if s.steps == 1 else 'steps'}, normalise {s.normalise}",
        f"expected reward at tau = {', '.join(f'{tau:g}' for tau in result.taus[:rows])}{more}",
    ]
    width = max(map(len, result.action_names))
    parts = [result.decoded] if truth is None else [result.decoded, truth]
    largest = max(float(np.abs(part.expected_reward).max()) for part in parts)
    largest = 0.0 if largest <= ROUNDING * decoded.scale else largest
    for a, name in enumerate(result.action_names):
        lines.append(f"  {name:{width}}  decoded  {_numbers(decoded.expected_reward[a, :rows], largest)}{more}")
        if truth is not None:
            lines.append(f"  {'':{width}}  true     {_numbers(truth.expected_reward[a, :rows], largest)}{more}")
    read, left = result.reading(result.row)
    lines.append(f"value for the horizon T = {result.horizons[read]:g} at gamma {s.value_gamma:g}")
    for a, name in enumerate(result.action_names):
        against = "" if truth is None else f"   true  {_numbers(truth.horizon_values[a, left : left + 1], largest)}"
        value = _numbers(decoded.horizon_values[a, read : read + 1], largest)
        lines.append(f"  {name:{width}}  decoded  {value}{against}")
    lines.append(f"chosen by T   {action_runs(result, decoded.actions)}")
    if truth is not None:
        lines.append(f"best by T     {action_runs(result, truth.optimal_action)}")
    lines += study_notes(result)
    return "\n".join(lines)


def _inverse(result: Study) -> str:
    """Alpha, and whatever else of the inverse is not the usual."""
    s, record = result.settings, result.alpha_record
    words = [f"alpha {s.alpha:g}"]
    if s.selector != "typed":
        edge = "" if record.edge == "none" else f", the {record.edge} edge of the sweep"
        words = [f"alpha {s.alpha:.4g} by {record.criterion}{edge}"]
    words += [f"solver {s.solver}"] if s.solver != "tikhonov" else []
    words += ["discounts weighed by their deviation"] if s.weighting != "equal" else []
    words += [f"filter {s.filter}"] if s.filter != "none" else []
    return ", ".join(words)


def _numbers(values: np.ndarray, largest: float) -> str:
    """Two decimals, never a negative zero; two significant digits where the largest of all values is small."""
    if 0.0 < largest < 0.05:
        return " ".join(f"{value + 0.0:8.1e}" for value in values)
    return " ".join(f"{round(float(value), 2) + 0.0:7.2f}" for value in values)
