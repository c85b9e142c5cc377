"""The command line's ``reproduce`` verb."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from laplace_core.cli.options import checked_number
from laplace_core.cli.stop import Stop
from laplace_core.errors import InputError
from laplace_core.experiments.paper import EXPERIMENTS
from laplace_core.experiments.paper.experiment import Experiment
from laplace_core.experiments.paper.result_files import measured_speeds, recorded_rows, result_file
from laplace_core.experiments.paper.runs import FINISHED, Budget, Speeds, Training, adopt, once_each, trainings_of

RUNS, OUT = "runs/paper", "docs/paper"


def add_reproduce(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``reproduce`` to the verbs."""
    reproduce = verbs.add_parser(
        "reproduce",
        help="train the experiments of the paper again",
        description="Trains what an experiment of the paper needs, one training after another, and writes the "
        "result of each to a small file. An interrupted training goes on where it was; one that several experiments "
        "need is trained once, and one whose result is in the folder of results is not trained again.",
    )
    reproduce.add_argument("name", nargs="?", metavar="NAME", help=f"one of {', '.join(EXPERIMENTS)}, or all")
    reproduce.add_argument("--runs", default=RUNS, metavar="FOLDER", help=f"where the runs are kept (default: {RUNS})")
    reproduce.add_argument("--out", metavar="FOLDER", help=f"where the results are written (default: {OUT})")
    reproduce.add_argument("--list", action="store_true", help="list the experiments and how far they are, and stop")
    reproduce.add_argument("--budget", action="store_true", help="print what is left to be trained, and stop")
    reproduce.add_argument("--adopt", metavar="FOLDER", help="copy a run made elsewhere to where it is looked for")
    reproduce.add_argument("--collect", action="store_true", help="train nothing: write the results of finished runs")
    reproduce.add_argument(
        "--steps", metavar="N", help="end every training after so many steps, to see that it runs; needs --out"
    )
    reproduce.add_argument("--json", action="store_true", help="print JSON")
    reproduce.set_defaults(run=_reproduce)


def _reproduce(options: argparse.Namespace) -> None:
    asked = [word for word in ("list", "budget", "adopt", "collect") if getattr(options, word)]
    if len(asked) > 1:
        raise InputError(f"--{asked[0]} and --{asked[1]} are asked for one at a time: leave one of them out.")
    experiments = _named(options.name, some=bool(asked))
    steps = None if options.steps is None else checked_number("steps", options.steps, int, 2, high=10**9)
    if steps is not None and options.out is None and asked in ([], ["collect"]):
        raise InputError("--steps makes results that are none of the paper's: name a folder for them with --out.")
    runs, out = Path(options.runs), Path(options.out or OUT)
    recorded = recorded_rows(list(EXPERIMENTS.values()), out)
    trainings = trainings_of(experiments, runs, steps, recorded=recorded)
    if options.list:
        _list(experiments, trainings, out, as_json=options.json)
    elif options.budget:
        _budget(experiments, trainings, out, as_json=options.json)
    elif options.adopt is not None:
        adopted = adopt(Path(options.adopt), once_each(trainings))
        report = {"run": adopted.name, "state": adopted.state, "folder": str(adopted.folder)}
        print(json.dumps(report, indent=1) if options.json else f"{options.adopt} is {adopted.folder} now")
    else:
        _train(experiments, trainings, out, collect=options.collect, as_json=options.json)


def _named(name: str | None, *, some: bool) -> list[Experiment]:
    """The experiments that were asked for; without a name all, where nothing is trained.

    Raises:
        InputError: a name that none of them has, or none where one is needed.
    """
    if name == "all" or (name is None and some):
        return list(EXPERIMENTS.values())
    listed = f"one of {', '.join(EXPERIMENTS)}, or all"
    if name is None:
        raise InputError(f"name the experiment to reproduce: {listed}.")
    if name not in EXPERIMENTS:
        near = get_close_matches(name, EXPERIMENTS, 1)
        hint = f" (the nearest is {near[0]})" if near else ""
        raise InputError(f"the experiment must be {listed}, not {name[:40]!r}{hint}.")
    return [EXPERIMENTS[name]]


def _list(
    experiments: Sequence[Experiment], trainings: dict[str, list[Training]], out: Path, *, as_json: bool
) -> None:  # fmt: skip
    listed: list[dict[str, Any]] = []
    for experiment in experiments:
        file = result_file(out, experiment)
        rows = [
            {
                "run": each.name, "cell": each.cell.label, "seed": each.settings.seed, "state": each.state,
                "step": each.step, "steps": each.settings.steps,
            }
            for each in trainings[experiment.name]
        ]  # fmt: skip
        states = {row["state"] for row in rows}
        listed.append(
            {
                "name": experiment.name, "title": experiment.title, "question": experiment.question,
                "state": states.pop() if len(states) == 1 else "part", "trainings": rows,
                "result": str(file) if file.exists() else None,
            }
        )  # fmt: skip
    if as_json:
        print(json.dumps(listed, indent=1))
        return
    width = max(len(each["name"]) for each in listed)
    for each in listed:
        rows = each["trainings"]
        finished = sum(row["state"] == FINISHED for row in rows)
        began = sum(row["state"] == "part" for row in rows)
        words = [f"{finished} of {len(rows)} trainings finished"]
        words += [f"{began} begun"] if began else []
        words += [each["result"]] if each["result"] else []
        print(f"{each['name']:{width}}  {each['title']}\n{'':{width}}  {', '.join(words)}")


def _budget(
    experiments: Sequence[Experiment], trainings: dict[str, list[Training]], out: Path, *, as_json: bool
) -> None:  # fmt: skip
    everything = once_each(trainings)
    known = measured_speeds(list(EXPERIMENTS.values()), _all_planned(everything), out)
    speeds = Speeds(known)
    budgets = {each.name: Budget(trainings[each.name], speeds) for each in experiments}
    together = Budget(everything, speeds)
    if as_json:
        report = {name: budget.as_dict() for name, budget in budgets.items()}
        print(json.dumps({"experiments": report, "together": together.as_dict()}, indent=1))
        return
    for name, budget in {**budgets, "together, each run once": together}.items():
        print(f"{name}: {_cost(budget)}")


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


def _train(
    experiments: Sequence[Experiment], trainings: dict[str, list[Training]], out: Path, *, collect: bool, as_json: bool
) -> None:  # fmt: skip
    from laplace_core.experiments.paper import reproduce  # loads torch

    def report(words: str) -> None:
        if not as_json:
            print(words, flush=True)

    def begins(each: Training) -> None:
        report(f"{each.cell.label}, seed {each.settings.seed}: {each.step:,} of {each.settings.steps:,} steps")

    failed = 0
    with Stop() as stop:
        for done in reproduce.reproduce(
            experiments, trainings, out, lambda: stop.asked, begins=begins, collect=collect
        ):
            each, row = done.training, done.row
            failed += row is None
            which = f"{each.cell.label}, seed {each.settings.seed}"
            about = {"run": each.name, "cell": each.cell.label, "seed": each.settings.seed}
            if as_json:
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
        report(f"{experiment.name}: {result_file(out, experiment)}")
    if failed:
        raise InputError(f"{failed} of the trainings have no result yet: see above, and give the same command again.")
