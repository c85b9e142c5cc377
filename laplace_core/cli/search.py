"""The command line's ``search`` verb."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from laplace_core.cli.options import checked_number, named_params
from laplace_core.errors import InputError


def add_search(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``search`` to the verbs."""
    search = verbs.add_parser(
        "search",
        help="which settings score best over several seeds",
        description="Trains trials with every seed and ranks them by the median score. Listed values are all combined "
        "(or tried each by itself, --one-at-a-time); from ranges a sampler chooses. A search that was interrupted goes "
        "on where it was, and several commands on one storage share the trials.",
    )
    search.add_argument("algorithm", metavar="ALGORITHM", help="as in train")
    search.add_argument("environment", metavar="ENVIRONMENT", help="as in train")
    search.add_argument(
        "--vary", action="append", default=[], metavar="NAME=V,V,...",
        help="values of a setting: a list, or a range LOW..HIGH, evenly on a log scale with :log behind it",
    )  # fmt: skip
    search.add_argument("--space", metavar="NAME", help="vary the settings of a named space: paper or ours")
    search.add_argument("--set", action="append", default=[], metavar="NAME=V", help="a setting of all trainings")
    search.add_argument("--seeds", default="3", metavar="N", help="how many, from seed 0 (default: 3)")
    search.add_argument("--one-at-a-time", action="store_true", help="each value by itself, against the settings file")
    search.add_argument(
        "--sampler", metavar="NAME", help="tpe, gp, random or grid (default: grid, with ranges or --trials tpe)"
    )
    search.add_argument("--trials", metavar="N", help="that the sampler makes (default: 50)")
    search.add_argument("--sampler-seed", default="0", metavar="N", help="decides what it draws (default: 0)")
    search.add_argument(
        "--pruner", default="none", metavar="NAME",
        help="ends trials early by their evaluations while training: none, median or hyperband (default: none)",
    )  # fmt: skip
    search.add_argument(
        "--objective", default="score", metavar="NAME",
        help="score: 100 held-out episodes of the best checkpoint; paper: the last 100 episodes of training, a mean "
        "over the discounts (default: score)",
    )  # fmt: skip
    search.add_argument("--runs", default="runs/search", metavar="FOLDER", help="where the runs are (runs/search)")
    search.add_argument(
        "--storage", metavar="WHERE",
        help="of the trials: FILE.db (SQLite), FILE.journal for many machines, or postgresql://... (default: search.db "
        "in the folder of the runs)",
    )  # fmt: skip
    search.add_argument("--study", metavar="NAME", help="its name in the storage (default: by the search's settings)")
    search.add_argument(
        "--heartbeat", default="20", metavar="SECONDS",
        help="between two signs of life of a trial; after three without one another worker takes it (default: 20)",
    )  # fmt: skip
    search.add_argument("--jobs", default="1", metavar="N", help="trials at once, one core each (default: 1)")
    search.add_argument("--cluster", metavar="ADDRESS", help="do the trials on a Ray cluster, such as 127.0.0.1:6379")
    search.add_argument("--budget", action="store_true", help="print what it would cost, and stop")
    search.add_argument("--json", action="store_true", help="print JSON")
    search.set_defaults(run=_search)


def _search(options: argparse.Namespace) -> None:
    seeds, folder = checked_number("seeds", options.seeds, int, 1, high=100), Path(options.runs)
    jobs = checked_number("jobs", options.jobs, int, 1, high=256)
    count = None if options.trials is None else checked_number("trials", options.trials, int, 1, high=10_000)
    sampler_seed = checked_number("sampler-seed", options.sampler_seed, int, 0, high=10**6)
    heartbeat = checked_number("heartbeat", options.heartbeat, int, 1, high=3600)
    given = named_params(options.vary, "--vary")
    common: dict[str, Any] = dict(named_params(options.set, "--set"))
    _check_names(given, common)
    from laplace_core.experiments.search import results, spaces  # loads torch, as does the next line
    from laplace_core.experiments.search.search import Search

    varied = dict(given)
    if options.space is not None:
        named = spaces.named_space(options.space, options.algorithm)
        varied = {name: text for name, text in named.items() if name not in common} | given
    ranges = count is not None or any(".." in text for text in varied.values())
    search = Search(
        options.algorithm,
        options.environment,
        common,
        varied,
        seeds,
        folder,
        one_at_a_time=options.one_at_a_time,
        sampler=options.sampler or ("tpe" if ranges else "grid"),
        pruner=options.pruner,
        count=count,
        objective=options.objective,
        storage=options.storage,
        study=options.study,
        sampler_seed=sampler_seed,
        heartbeat=heartbeat,
    )
    if options.budget or not options.json:
        print(search.budget(), flush=True)
    if options.budget:
        return
    rows, refused = [], 0
    for row in search.run(processes=jobs, cluster=options.cluster):
        if "trouble" in row:
            refused += 1
            print(f"{results.in_words(row['trial'])}: {row['trouble']}", file=sys.stderr, flush=True)
            continue
        rows.append(row)
        if not options.json:
            found = f"pruned at {row['median']:.1f}" if row["pruned"] else row["scores"]
            print(f"{results.in_words(row['trial'])}: {found}, {row['seconds']:.0f} s", flush=True)
    rows.sort(key=lambda row: int(row["number"]))
    if options.json:
        print(json.dumps(rows, indent=1))
    elif rows:
        print(results.table(rows, one_at_a_time=options.one_at_a_time))
    if refused:
        raise InputError(f"{refused} of {len(search.jobs)} trials could not be trained: see above.")


def _check_names(varied: dict[str, str], common: dict[str, Any]) -> None:
    """Refuse settings that a search has of its own, and one that is both varied and set.

    Raises:
        InputError: naming the setting.
    """
    if "seed" in varied or "seed" in common:
        raise InputError("seeds are counted from 0: say how many with --seeds.")
    for name in ("algorithm", "environment"):
        if name in varied or name in common:
            raise InputError(f"the {name} of a search is named behind the verb, one a search: it cannot be varied.")
    if both := [name for name in varied if name in common]:
        raise InputError(f"{both[0][:40]} is given to --vary and to --set: leave one of them out.")
