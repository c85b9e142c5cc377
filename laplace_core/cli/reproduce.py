"""The command line's ``reproduce`` verb."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from functools import partial
from pathlib import Path
from typing import Any

from laplace_core.cli.options import checked_number
from laplace_core.cli.stop import Stop
from laplace_core.errors import InputError
from laplace_core.experiments.paper import EXPERIMENTS, MEASUREMENTS, measurement
from laplace_core.experiments.paper.experiment import Experiment
from laplace_core.experiments.paper.measurement import Measurement, finished, measure
from laplace_core.experiments.paper.result_files import measured_speeds, recorded_rows, result_file
from laplace_core.experiments.paper.runs import (
    FINISHED,
    MISSING,
    Budget,
    Speeds,
    Training,
    adopt,
    once_each,
    trainings_of,
)

RUNS, OUT = "runs/paper", "docs/paper"
AGENTS = Path("checkpoints")
"""The agents that ship, whose scores the document has as well."""


def add_reproduce(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``reproduce`` to the verbs."""
    reproduce = verbs.add_parser(
        "reproduce",
        help="make the figures and tables of the paper again",
        description="Trains or measures what an experiment of the paper needs, part by part, and writes the "
        "result of each to a small file. An interrupted training goes on where it was; one that several experiments "
        "need is trained once, and what has its result in the folder of results is not done again.",
    )
    reproduce.add_argument(
        "name", nargs="?", metavar="NAME", help=f"one of {', '.join([*MEASUREMENTS, *EXPERIMENTS])}, or all"
    )
    reproduce.add_argument("--runs", default=RUNS, metavar="FOLDER", help=f"where the runs are kept (default: {RUNS})")
    reproduce.add_argument("--out", metavar="FOLDER", help=f"where the results are written (default: {OUT})")
    reproduce.add_argument("--list", action="store_true", help="list the experiments and how far they are, and stop")
    reproduce.add_argument("--budget", action="store_true", help="print what is left to be trained, and stop")
    reproduce.add_argument(
        "--document", action="store_true", help="print what the results say, claim by claim, as Markdown, and stop"
    )
    reproduce.add_argument("--adopt", metavar="FOLDER", help="copy a run made elsewhere to where it is looked for")
    reproduce.add_argument("--collect", action="store_true", help="train nothing: write the results of finished runs")
    reproduce.add_argument(
        "--steps", metavar="N", help="end every training after so many steps, to see that it runs; needs --out"
    )
    reproduce.add_argument(
        "--jobs", default="1", metavar="N", help="parts or trainings that are done at once, in processes (default: 1)"
    )
    reproduce.add_argument(
        "--cluster", metavar="ADDRESS", help="measure and train on a Ray cluster, such as 127.0.0.1:6379"
    )
    reproduce.add_argument("--json", action="store_true", help="print JSON")
    reproduce.set_defaults(run=_reproduce)


def _reproduce(options: argparse.Namespace) -> None:
    asked = [word for word in ("list", "budget", "document", "adopt", "collect") if getattr(options, word)]
    if len(asked) > 1:
        raise InputError(f"--{asked[0]} and --{asked[1]} are asked for one at a time: leave one of them out.")
    if options.document:
        _document(options)
        return
    experiments, measurements = _named(options.name, some=bool(asked))
    steps = None if options.steps is None else checked_number("steps", options.steps, int, 2, high=10**9)
    if steps is not None and options.out is None and asked in ([], ["collect"]):
        raise InputError("--steps makes results that are none of the paper's: name a folder for them with --out.")
    jobs = checked_number("jobs", options.jobs, int, 1, high=256)
    runs, out = Path(options.runs), Path(options.out or OUT)
    recorded = recorded_rows(list(EXPERIMENTS.values()), out)
    trainings = trainings_of(experiments, runs, steps, recorded=recorded)
    if options.list:
        listed = [*map(partial(_measured_entry, out=out), measurements), *_entries(experiments, trainings, out)]
        _list(listed, as_json=options.json)
    elif options.budget:
        _budget(experiments, measurements, trainings, out, as_json=options.json)
    elif options.adopt is not None:
        adopted = adopt(Path(options.adopt), once_each(trainings))
        report = {"run": adopted.name, "state": adopted.state, "folder": str(adopted.folder)}
        print(json.dumps(report, indent=1) if options.json else f"{options.adopt} is {adopted.folder} now")
    else:
        for each in () if options.collect or steps is not None else measurements:
            _measure(each, out, jobs, options.cluster, as_json=options.json)
        if experiments:
            _train(experiments, trainings, out, options, jobs=jobs)


def _document(options: argparse.Namespace) -> None:
    """Print the catalogue as a document.

    Raises:
        InputError: options that it has no use for.
    """
    if options.name not in (None, "all") or options.json:
        other = "--json" if options.json else "the name of one"
        raise InputError(f"--document prints one document about all experiments: leave {other} out.")
    from laplace_core.experiments.paper.claims.document import document

    print(document(Path(options.out or OUT), AGENTS), end="")


def _named(name: str | None, *, some: bool) -> tuple[list[Experiment], list[Measurement]]:
    """The experiments and measurements that were asked for; without a name all, where nothing is made.

    Raises:
        InputError: a name that none of them has, or none where one is needed.
    """
    if name == "all" or (name is None and some):
        return list(EXPERIMENTS.values()), [measurement(each) for each in MEASUREMENTS]
    names = [*MEASUREMENTS, *EXPERIMENTS]
    listed = f"one of {', '.join(names)}, or all"
    if name is None:
        raise InputError(f"name the experiment to reproduce: {listed}.")
    if name in MEASUREMENTS:
        return [], [measurement(name)]
    if name not in EXPERIMENTS:
        near = get_close_matches(name, names, 1)
        hint = f" (the nearest is {near[0]})" if near else ""
        raise InputError(f"the experiment must be {listed}, not {name[:40]!r}{hint}.")
    return [EXPERIMENTS[name]], []


def _measured_entry(each: Measurement, out: Path) -> dict[str, Any]:
    """A measurement in the list."""
    file = result_file(out, each.name)
    rows = finished(each, file)
    state = FINISHED if len(rows) == len(each.parts) else "part" if rows else MISSING
    return {
        "name": each.name, "title": each.title, "question": each.question, "state": state,
        "parts": len(each.parts), "measured": len(rows), "result": str(file) if file.exists() else None,
    }  # fmt: skip


def _entries(
    experiments: Sequence[Experiment], trainings: dict[str, list[Training]], out: Path
) -> Iterator[dict[str, Any]]:  # fmt: skip
    """The trained experiments in the list."""
    for experiment in experiments:
        file = result_file(out, experiment.name)
        rows = [
            {
                "run": each.name, "cell": each.cell.label, "seed": each.settings.seed, "state": each.state,
                "step": each.step, "steps": each.settings.steps,
            }
            for each in trainings[experiment.name]
        ]  # fmt: skip
        states = {row["state"] for row in rows}
        yield {
            "name": experiment.name, "title": experiment.title, "question": experiment.question,
            "state": states.pop() if len(states) == 1 else "part", "trainings": rows,
            "result": str(file) if file.exists() else None,
        }  # fmt: skip


def _list(listed: Sequence[dict[str, Any]], *, as_json: bool) -> None:
    if as_json:
        print(json.dumps(listed, indent=1))
        return
    width = max(len(each["name"]) for each in listed)
    for each in listed:
        if "trainings" in each:
            rows = each["trainings"]
            words = [f"{sum(row['state'] == FINISHED for row in rows)} of {len(rows)} trainings finished"]
            began = sum(row["state"] == "part" for row in rows)
            words += [f"{began} begun"] if began else []
        else:
            words = [f"{each['measured']} of {each['parts']} parts measured"]
        words += [each["result"]] if each["result"] else []
        print(f"{each['name']:{width}}  {each['title']}\n{'':{width}}  {', '.join(words)}")


def _budget(
    experiments: Sequence[Experiment], measurements: Sequence[Measurement], trainings: dict[str, list[Training]],
    out: Path, *, as_json: bool,
) -> None:  # fmt: skip
    measured = {each.name: _to_measure(each, out) for each in measurements}
    budgets = {}
    if experiments:
        everything = once_each(trainings)
        speeds = Speeds(measured_speeds(list(EXPERIMENTS.values()), _all_planned(everything), out))
        budgets = {each.name: Budget(trainings[each.name], speeds) for each in experiments}
        budgets["together"] = Budget(everything, speeds)
    if as_json:
        together = budgets.pop("together", None)
        report: dict[str, Any] = {"experiments": {name: budget.as_dict() for name, budget in budgets.items()}}
        report |= {"measurements": measured} if measured else {}
        print(json.dumps(report | ({"together": together.as_dict()} if together else {}), indent=1))
        return
    for name, left in measured.items():
        cost = "" if left["hours"] is None else f", about {left['hours']:.1f} h"
        print(f"{name}: {left['parts']} parts, {left['measured']} of them measured{cost if left['left'] else ''}")
    for name, budget in budgets.items():
        print(f"{'together, each run once' if name == 'together' else name}: {_cost(budget)}")


def _to_measure(each: Measurement, out: Path) -> dict[str, Any]:
    """Parts of a measurement, and the hours that those which are left take at the mean of the others."""
    rows = finished(each, result_file(out, each.name))
    left = len(each.parts) - len(rows)
    hours = left * sum(row["seconds"] for row in rows) / len(rows) / 3600 if rows else None
    return {"parts": len(each.parts), "measured": len(rows), "left": left, "hours": hours}


def _all_planned(asked: Sequence[Training]) -> list[Training]:
    """These trainings and those of all other experiments, whose measured speeds are used as well."""
    runs = asked[0].folder.parent
    return once_each({"asked": list(asked), **trainings_of(list(EXPERIMENTS.values()), runs)})


def _cost(budget: Budget) -> str:
    words = f"{len(budget.trainings)} trainings, {budget.finished} of them finished; {budget.steps:,} steps to go"
    if not budget.steps:
        return words
    left = len(budget.trainings) - budget.finished
    if budget.unknown == left:
        return f"{words}, at a speed that no finished run has measured yet"
    rough = f", for {budget.rough} of them by the speed of other settings" if budget.rough else ""
    unknown = f", without {budget.unknown} whose speed is not known" if budget.unknown else ""
    return f"{words}, about {budget.hours:.1f} h{rough}{unknown}"


def _measure(each: Measurement, out: Path, jobs: int, cluster: str | None, *, as_json: bool) -> None:
    file, failed = result_file(out, each.name), 0
    with Stop() as stop:
        for done in measure(each, file, lambda: stop.asked, processes=jobs, cluster=cluster):
            failed += done.row is None
            which = f"{each.name}, {', '.join(f'{name} {value}' for name, value in done.part.items())}"
            if as_json:
                outcome = {"trouble": done.trouble} if done.row is None else {"result": done.row["result"]}
                print(json.dumps({"experiment": each.name, "part": dict(done.part)} | outcome), flush=True)
            elif done.row is None:
                print(f"{which}: {done.trouble}", file=sys.stderr, flush=True)
            else:
                print(f"{which}: {done.row['seconds']:,.1f} s", flush=True)
    if stop.asked:
        print("stopped; the same command goes on from there", file=sys.stderr, flush=True)
        sys.exit(128 + stop.asked)
    if not as_json:
        print(f"{each.name}: {file}", flush=True)
    if failed:
        raise InputError(f"{failed} of the parts have no result yet: see above, and give the same command again.")


def _train(
    experiments: Sequence[Experiment],
    trainings: dict[str, list[Training]],
    out: Path,
    options: argparse.Namespace,
    *,
    jobs: int,
) -> None:
    from laplace_core.experiments.paper import reproduce  # loads torch

    def report(words: str) -> None:
        if not options.json:
            print(words, flush=True)

    def begins(each: Training) -> None:
        report(f"{each.cell.label}, seed {each.settings.seed}: {each.step:,} of {each.settings.steps:,} steps")

    failed = 0
    with Stop() as stop:
        for done in reproduce.reproduce(
            experiments, trainings, out, lambda: stop.asked, begins=begins, collect=options.collect,
            processes=jobs, cluster=options.cluster,
        ):  # fmt: skip
            each, row = done.training, done.row
            failed += row is None
            which = f"{each.cell.label}, seed {each.settings.seed}"
            about = {"run": each.name, "cell": each.cell.label, "seed": each.settings.seed}
            if options.json:
                result = {"trouble": done.trouble} if row is None else {"best": row["best"], "seconds": row["seconds"]}
                print(json.dumps(about | result), flush=True)
            elif row is None:
                print(f"{which}: {done.trouble}", file=sys.stderr, flush=True)
            else:
                best = row["best"]
                report(
                    f"{which}: {best['score']:.1f} +- {best['standard_error']:.1f} over {best['episodes']} episodes; "
                    f"{row['seconds']:,.0f} s of training"
                )
    if stop.asked:
        print("stopped; the same command goes on from there", file=sys.stderr, flush=True)
        sys.exit(128 + stop.asked)
    for experiment in experiments:
        report(f"{experiment.name}: {result_file(out, experiment.name)}")
    if failed:
        raise InputError(f"{failed} of the trainings have no result yet: see above, and give the same command again.")
