"""The command line's ``report`` verb: run an experiment and print what it found."""

from __future__ import annotations

import argparse
import json


def add_report(verbs: argparse._SubParsersAction) -> None:
    """Add ``report`` to the verbs."""
    report = verbs.add_parser("report", help="run an experiment and print its report")
    report.add_argument("experiment", choices=["detectors"], help="detectors: precision and recall of each artefact")
    report.add_argument("--cases", type=int, default=500, metavar="N", help="random cases (default: 500)")
    report.add_argument("--seed", type=int, default=0, metavar="N", help="seed of the cases (default: 0)")
    report.add_argument("--json", action="store_true", help="print JSON")
    report.set_defaults(run=_report)


def _report(options: argparse.Namespace) -> None:
    from laplace_core.experiments import detector  # only this verb needs it

    numbers, text = detector.report(options.cases, options.seed)
    print(json.dumps(numbers, indent=1) if options.json else text)
