"""The command line's ``report`` verb: run an experiment and print what it found."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from laplace_core.training.command import settings_of
from laplace_core.words import checked_number


def add_report(verbs: argparse._SubParsersAction) -> None:
    """Add ``report`` to the verbs."""
    report = verbs.add_parser("report", help="run an experiment and print its report")
    kinds = report.add_subparsers(dest="experiment", required=True, metavar="EXPERIMENT")

    detectors = kinds.add_parser("detectors", help="precision and recall of each artefact's detector")
    detectors.add_argument("--cases", type=int, default=500, metavar="N", help="random cases (default: 500)")
    detectors.add_argument("--seed", type=int, default=0, metavar="N", help="seed of the cases (default: 0)")
    detectors.add_argument("--json", action="store_true", help="print JSON")
    detectors.set_defaults(run=_detectors)

    training = kinds.add_parser("training", help="score, steps and time of an algorithm over several seeds")
    training.add_argument("algorithm", metavar="ALGORITHM", help="as in train")
    training.add_argument("environment", metavar="ENVIRONMENT", help="as in train")
    training.add_argument("--seeds", default="5", metavar="N", help="how many, from seed 0 (default: 5)")
    training.add_argument("--aim", default="490", metavar="X", help="score to be reached (default: 490)")
    training.add_argument("--runs", default="runs", metavar="FOLDER", help="where the runs are kept (default: runs)")
    training.add_argument("--json", action="store_true", help="print JSON")
    training.set_defaults(run=_training)


def _detectors(options: argparse.Namespace) -> None:
    from laplace_core.experiments import detector  # only this verb needs it

    numbers, text = detector.report(options.cases, options.seed)
    print(json.dumps(numbers, indent=1) if options.json else text)


def _training(options: argparse.Namespace) -> None:
    seeds = checked_number("seeds", options.seeds, int, 1, 100)
    aim = checked_number("aim", options.aim, float, -1e9, 1e9)
    settings_of(options.algorithm, options.environment, {})
    from laplace_core.experiments import training  # loads torch

    numbers, text = training.report(options.algorithm, options.environment, seeds, aim, Path(options.runs))
    print(json.dumps(numbers, indent=1) if options.json else text)
