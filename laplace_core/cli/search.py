"""The command line's ``search`` verb."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from laplace_core.cli.options import checked_number, named_params
from laplace_core.errors import InputError


def add_search(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``search`` to the verbs."""
    search = verbs.add_parser(
        "search",
        help="which settings score best over several seeds",
        description="Trains every combination of the values (or each by itself, --one-at-a-time) with every seed and "
        "ranks them by the median score. An interrupted search goes on where it was.",
    )
    search.add_argument("algorithm", metavar="ALGORITHM", help="as in train")
    search.add_argument("environment", metavar="ENVIRONMENT", help="as in train")
    search.add_argument("--vary", action="append", default=[], metavar="NAME=V,V,...", help="values of a setting")
    search.add_argument("--set", action="append", default=[], metavar="NAME=V", help="a setting of all trainings")
    search.add_argument("--seeds", default="3", metavar="N", help="how many, from seed 0 (default: 3)")
    search.add_argument("--one-at-a-time", action="store_true", help="each value by itself, against the settings file")
    search.add_argument("--runs", default="runs/search", metavar="FOLDER", help="where the runs are (runs/search)")
    search.add_argument("--jobs", default="1", metavar="N", help="trainings at once, one core each (default: 1)")
    search.add_argument("--budget", action="store_true", help="print what it would cost, and stop")
    search.add_argument("--json", action="store_true", help="print JSON")
    search.set_defaults(run=_search)


def _search(options: argparse.Namespace) -> None:
    seeds, folder = checked_number("seeds", options.seeds, int, 1, high=100), Path(options.runs)
    jobs = checked_number("jobs", options.jobs, int, 1, high=256)
    varied = {name: text.split(",") for name, text in named_params(options.vary, "--vary").items()}
    common = dict(named_params(options.set, "--set"))
    if "seed" in varied or "seed" in common:
        raise InputError("seeds are counted from 0: say how many with --seeds.")
    for name in ("algorithm", "environment"):
        if name in varied or name in common:
            raise InputError(f"the {name} of a search is named behind the verb, one a search: it cannot be varied.")
    if both := [name for name in varied if name in common]:
        raise InputError(f"{both[0][:40]} is given to --vary and to --set: leave one of them out.")
    from laplace_core.experiments import search, search_report  # loads torch

    planned = [
        search.settings_for(options.algorithm, options.environment, common, trial, seed=seed)
        for trial in search.trials(varied, one_at_a_time=options.one_at_a_time)
        for seed in range(seeds)
    ]
    for name, values in varied.items():
        parsed = [
            parameter.parse(value) for parameter in planned[0].SCHEMA if parameter.name == name for value in values
        ]
        if len(set(parsed)) < len(parsed):
            raise InputError(f"--vary {name}={','.join(values)[:60]} has the same value twice: leave one out.")
    cost = search.budget(planned, folder)
    if options.budget or not options.json:
        print(cost, flush=True)
    if options.budget:
        return
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for row in search.search(
        options.algorithm,
        options.environment,
        common,
        varied,
        seeds=seeds,
        folder=folder,
        one_at_a_time=options.one_at_a_time,
        jobs=jobs,
    ):
        rows.append(row)
        if not options.json:
            print(f"{row['trial'] or 'as in the file'}: {row['scores']}, {row['seconds']:.0f} s", flush=True)
    print(
        json.dumps(rows, indent=1) if options.json else search_report.table(rows, one_at_a_time=options.one_at_a_time)
    )
