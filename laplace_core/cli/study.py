"""The command line's ``study`` verb: solvers and selectors on random worlds whose truth is known."""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path

from laplace_core.cli.options import checked_number
from laplace_core.errors import InputError
from laplace_core.inverse import SELECTORS
from laplace_core.supervise.parallel import end_with

OUT, RANDOM = "inverse_study.csv", "random"
PATIENT = 10
"""By how much a study that a server has begun is less urgent than the server."""


def add_study(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``study`` to the verbs."""
    study = verbs.add_parser(
        "study",
        help="compare solvers and selectors of the inverse on random worlds",
        description="Decodes random worlds with every solver and the alpha of every selector, compares the timelines "
        "with the true ones and with those of the best alpha, and writes a row for each to a CSV file. A study that "
        "was stopped goes on where it was.",
    )
    study.add_argument("--out", default=OUT, metavar="FILE.csv", help=f"the table (default: {OUT})")
    study.add_argument("--worlds", default="100", metavar="N", help="random worlds (default: 100)")
    study.add_argument("--of", default=RANDOM, metavar="NAME,NAME", help="random worlds, or listed ones, each "
                       "with N draws of its noise (default: random)")  # fmt: skip
    study.add_argument("--noise", default="1e-4,1e-3,1e-2", metavar="S,S", help="standard deviations of (1 - gamma) Q")
    study.add_argument("--grids", default="paper,inverse-log,log", metavar="NAME,NAME", help="grids of 15 discounts")
    study.add_argument("--solvers", default="tikhonov,tikhonov1,tikhonov2", metavar="NAME,NAME")
    study.add_argument("--selectors", metavar="NAME,NAME", help="rules for alpha (default: all)")
    study.add_argument("--seed", default="0", metavar="N", help="seed of the worlds and of their noise (default: 0)")
    study.add_argument("--jobs", default="1", metavar="N", help="processes (default: 1)")
    study.add_argument("--cluster", metavar="ADDRESS", help="run on a Ray cluster, such as 127.0.0.1:6379")
    study.add_argument("--by", default="solver,selector", metavar="COLUMN,COLUMN", help="columns to sum up by")
    study.add_argument("--summary", action="store_true", help="sum up the table that is there, and measure nothing")
    study.add_argument("--json", action="store_true", help="print JSON")
    study.add_argument("--parent", type=int, help=argparse.SUPPRESS)  # end with this process, and leave it the machine
    study.set_defaults(run=_study)


def _study(options: argparse.Namespace) -> None:
    from laplace_core.experiments.inverse import selection, selection_report
    from laplace_core.experiments.inverse.table_file import TableFile

    path, by = Path(options.out), options.by.split(",")
    for name in by:
        if name not in ("noise", "grid", "solver", "selector"):
            raise InputError(f"--by takes noise, grid, solver and selector, not {name[:40]!r}.")
    seed = checked_number("seed", options.seed, int, 0, high=2**31 - 1)
    if options.summary:
        if not path.exists():
            raise InputError(f"there is no file {path}: run the study first.")
    else:
        plan = selection.Plan(
            cases=checked_number("worlds", options.worlds, int, 1, high=100_000),
            noises=[checked_number("noise", word, float, 0.0, high=1.0) for word in options.noise.split(",")],
            grids=options.grids.split(","),
            solvers=options.solvers.split(","),
            selectors=tuple(SELECTORS) if options.selectors is None else options.selectors.split(","),
            seed=seed,
            worlds=options.of.split(","),
        )
        if options.parent is not None:
            end_with(options.parent)
            if hasattr(os, "nice"):
                os.nice(PATIENT)
        jobs = checked_number("jobs", options.jobs, int, 1, high=256)
        shown = -1
        for done, count in selection.run(plan, path, processes=jobs, cluster=options.cluster):
            if not options.json and 20 * done // count > shown:
                shown = 20 * done // count
                print(f"{done:,} of {count:,} worlds, noises and grids", file=sys.stderr, flush=True)
    rows = TableFile(path, selection.COLUMNS, ("case", "noise", "grid"), about=f"seed {seed}").rows()
    if not rows:
        raise InputError(f"{path} has no row yet: run the study first.")
    entries = selection_report.summed(rows, by)
    print(json.dumps(entries, indent=1) if options.json else selection_report.table(entries, by))
