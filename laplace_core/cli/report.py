"""The command line's ``report`` verb: run an experiment and print its results."""

from __future__ import annotations

import argparse
import json
import sys
from importlib import import_module
from pathlib import Path

from laplace_core.cli.options import checked_number
from laplace_core.errors import InputError
from laplace_core.files.atomic import write_whole
from laplace_core.training.defaults import settings_of


def add_report(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``report`` to the verbs."""
    report = verbs.add_parser("report", help="run an experiment and print its report")
    kinds = report.add_subparsers(dest="experiment", required=True, metavar="EXPERIMENT")

    detectors = kinds.add_parser("detectors", help="precision and recall of each artefact's detector")
    detectors.add_argument(
        "--cases", type=int, default=500, metavar="N", help="random cases of each kind (default: 500)"
    )
    detectors.add_argument("--seed", type=int, default=0, metavar="N", help="seed of the cases (default: 0)")
    detectors.add_argument("--json", action="store_true", help="print JSON")
    detectors.add_argument("--check", action="store_true", help="end with status 1 where a share is below .97")
    detectors.set_defaults(run=_detectors)

    verdicts = kinds.add_parser("verdicts", help="verdicts against those of an independent judge")
    verdicts.add_argument("--cases", default="2000", metavar="N", help="random views (default: 2000)")
    verdicts.add_argument("--seed", default="0", metavar="N", help="seed of the views (default: 0)")
    verdicts.add_argument("--jobs", default="1", metavar="N", help="processes at a time (default: 1)")
    verdicts.add_argument("--only", metavar="NUMBER", help="show this one view in full instead")
    verdicts.add_argument("--json", action="store_true", help="print JSON")
    verdicts.add_argument(
        "--check", action="store_true", help="end with status 1 where a share is below what is demanded"
    )
    verdicts.set_defaults(run=_verdicts)

    auto = kinds.add_parser("auto", help="fit the coefficients of the selector auto to random worlds")
    auto.add_argument("--worlds", default="1000", metavar="N", help="random worlds (default: 1000)")
    auto.add_argument("--solvers", metavar="NAMES", help="solvers to fit, separated by commas (default: all)")
    auto.add_argument("--jobs", default="1", metavar="N", help="processes at a time (default: 1)")
    auto.add_argument("--out", metavar="FILE.json", help="write the coefficients there")
    auto.add_argument("--json", action="store_true", help="print JSON")
    auto.set_defaults(run=_auto)

    training = kinds.add_parser("training", help="score, steps and time of an algorithm over several seeds")
    training.add_argument("algorithm", metavar="ALGORITHM", help="as in train")
    training.add_argument("environment", metavar="ENVIRONMENT", help="as in train")
    training.add_argument("--seeds", default="5", metavar="N", help="how many, from seed 0 (default: 5)")
    training.add_argument("--aim", default="490", metavar="X", help="score to be reached (default: 490)")
    training.add_argument("--runs", default="runs", metavar="FOLDER", help="where the runs are kept (default: runs)")
    training.add_argument("--json", action="store_true", help="print JSON")
    training.set_defaults(run=_training)

    ship = kinds.add_parser("ship", help="evaluate finished runs, keep the median seed's checkpoint and its manifest")
    ship.add_argument("algorithm", metavar="ALGORITHM", help="as in train")
    ship.add_argument("environment", metavar="ENVIRONMENT", help="as in train")
    ship.add_argument("--seeds", default="5", metavar="N", help="how many, from seed 0 (default: 5)")
    ship.add_argument("--runs", default="runs", metavar="FOLDER", help="where the runs are (default: runs)")
    ship.add_argument("--out", default="checkpoints", metavar="FOLDER", help="where it goes (default: checkpoints)")
    ship.set_defaults(run=_ship)

    shipped = kinds.add_parser("shipped", help="scores of the agents that ship, and how steady their trainings were")
    shipped.add_argument("--folder", default="checkpoints", metavar="FOLDER", help="default: checkpoints")
    shipped.add_argument("--json", action="store_true", help="print JSON")
    shipped.set_defaults(run=_shipped)

    horizon = kinds.add_parser("horizon", help="acting for other horizons, against greedy and the matched discount")
    horizon.add_argument("checkpoints", nargs="+", metavar="CHECKPOINT", help="agents of one environment")
    horizon.add_argument("--horizons", default="50,100,200,full", metavar="T,T,...", help="default: 50,100,200,full")
    horizon.add_argument("--rule", default="fading", metavar="NAME", help="the rule to be judged (default: fading)")
    horizon.add_argument("--stretch", metavar="C", help="of the rule fading")
    horizon.add_argument("--alpha", metavar="A", help="of the rules readout and decoded")
    horizon.add_argument("--softness", metavar="W", help="of the rules readout and decoded")
    horizon.add_argument(
        "--reference", action="append", default=[], metavar="CHECKPOINT", help="another agent to show beside them"
    )
    horizon.add_argument("--episodes", default="100", metavar="N", help="episodes of each agent (default: 100)")
    horizon.add_argument("--seed", default="0", metavar="N", help="which start seeds (default: 0)")
    horizon.add_argument("--json", action="store_true", help="print JSON")
    horizon.set_defaults(run=_horizon)

    interpolation = kinds.add_parser("interpolation", help="errors of values at discounts between the trained ones")
    interpolation.add_argument("checkpoint", metavar="CHECKPOINT", help="an agent with values at many discounts")
    interpolation.add_argument("--seed", default="0", metavar="N", help="start seed of the episode (default: 0)")
    interpolation.add_argument("--json", action="store_true", help="print JSON")
    interpolation.set_defaults(run=_interpolation)

    grids = kinds.add_parser("grids", help="a designed grid of discounts against the usual ones, on random worlds")
    grids.add_argument("--gammas", default="15", metavar="N", help="number of discounts (default: 15)")
    grids.add_argument("--horizon", default="100", metavar="T", help="longest horizon, in steps (default: 100)")
    grids.add_argument("--noise", default="0.001", metavar="S", help="as in grid (default: 0.001)")
    _add_cases(grids, "200")
    grids.set_defaults(run=_grids)

    neural = kinds.add_parser("neural", help="the neural inverse against Tikhonov, on random worlds")
    neural.add_argument("network", nargs="?", metavar="FILE", help="a trained network (default: each one that ships)")
    _add_cases(neural, "200")
    neural.set_defaults(run=_neural)

    searches = kinds.add_parser("searches", help="results of searches over settings")
    searches.add_argument("files", nargs="+", metavar="FILE", help="results of searches: their search.json")
    searches.add_argument("--json", action="store_true", help="print JSON")
    searches.set_defaults(run=_searches)

    add_inverse_reports(kinds)


INVERSE_REPORTS = {
    "inverse-certificates": ("certificates", 1000, "certified decisions: how many there are, how many are wrong"),
    "inverse-consistency": ("alarms", 1000, "alarms of the test of consistency, true and false ones"),
    "inverse-bumps": ("bumps", 2000, "probabilities of bumps against how often they are real"),
    "inverse-feasible": ("timelines", 5, "feasible timelines against Tikhonov with its best alpha, on every preset"),
    "inverse-agents": ("agent_states", 20, "timelines of trained agents' states against simulated continuations"),
}
"""Name of the report: its module in ``laplace_core.experiments.inverse``, how many cases it takes, what it says."""


def add_inverse_reports(kinds: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the reports on the inverse."""
    for name, (module, cases, words) in INVERSE_REPORTS.items():
        parser = kinds.add_parser(name, help=words)
        parser.add_argument("--cases", default=str(cases), metavar="N", help=f"how many (default: {cases})")
        parser.add_argument("--seed", default="0", metavar="N", help="seed of the cases (default: 0)")
        parser.add_argument("--json", action="store_true", help="print JSON")
        parser.add_argument("--check", action="store_true", help="end with status 1 where it is not as demanded")
        if module == "alarms":
            parser.add_argument("--jobs", default="1", metavar="N", help="processes at a time (default: 1)")
        if module == "bumps":
            parser.add_argument("--fit", action="store_true", help="fit the calibration on other worlds, and print it")
        parser.set_defaults(run=_inverse, module=module)


def _inverse(options: argparse.Namespace) -> None:
    cases = checked_number("cases", options.cases, int, 1, high=10**6)
    seed = checked_number("seed", options.seed, int, 0, high=2**31 - 1)
    module = import_module(f"laplace_core.experiments.inverse.{options.module}")  # only this verb needs it
    if getattr(options, "fit", False):
        print(json.dumps(module.fit(cases, seed), indent=1))
        return
    given = {} if not hasattr(options, "jobs") else {"jobs": checked_number("jobs", options.jobs, int, 1, high=256)}
    numbers, text = module.report(cases, seed, **given)
    print(json.dumps(numbers, indent=1) if options.json else text)
    if options.check:
        _check(module.shortfalls(numbers))


def _add_cases(parser: argparse.ArgumentParser, cases: str) -> None:
    parser.add_argument("--cases", default=cases, metavar="N", help=f"random worlds (default: {cases})")
    parser.add_argument("--seed", default="0", metavar="N", help="seed of the worlds (default: 0)")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("--check", action="store_true", help="end with status 1 where another does better")


def _detectors(options: argparse.Namespace) -> None:
    from laplace_core.experiments import detector  # only this verb needs it

    numbers, text = detector.report(options.cases, options.seed)
    print(json.dumps(numbers, indent=1) if options.json else text)
    if options.check:
        kinds = {"all": numbers["artefacts"], **numbers["kinds"]}
        _check([f"{one['name']} ({kind})" for kind, ones in kinds.items() for one in ones if detector.falls_short(one)])


def _check(missed: list[str]) -> None:
    """Exit with status 1 and one line where a report does not meet its criteria."""
    if missed:
        print(f"laplace: not reached: {', '.join(missed)}.", file=sys.stderr)
        raise SystemExit(1)


def _verdicts(options: argparse.Namespace) -> None:
    from laplace_core.experiments import verdicts  # only this verb needs it

    seed = checked_number("seed", options.seed, int, 0, high=2**31 - 1)
    if options.only is not None:
        print(verdicts.described(checked_number("only", options.only, int, 0, high=verdicts.MOST_VIEWS), seed))
        return
    cases = checked_number("cases", options.cases, int, 1, high=verdicts.MOST_VIEWS)
    numbers, text = verdicts.report(cases, seed, checked_number("jobs", options.jobs, int, 1, high=verdicts.MOST_JOBS))
    print(json.dumps(numbers, indent=1) if options.json else text)
    if options.check:
        _check([row["words"] for row in numbers["rows"] if not row["met"]])


def _auto(options: argparse.Namespace) -> None:
    worlds = checked_number("worlds", options.worlds, int, 2, high=100_000)
    jobs = checked_number("jobs", options.jobs, int, 1, high=256)
    from laplace_core.experiments.inverse import auto_fit

    fitted = (*auto_fit.LEARNED, *auto_fit.SLOW)
    solvers = fitted if options.solvers is None else tuple(options.solvers.split(","))
    for name in solvers:
        if name not in fitted:
            raise InputError(f"solver {name[:40]!r} is not one of {', '.join(fitted)}.")
    if set(solvers) & set(auto_fit.SLOW) and "tikhonov" not in solvers:
        raise InputError("the feasible solver is fitted to what the network of tikhonov says: name tikhonov as well.")
    numbers, text = auto_fit.report(worlds, jobs, solvers=solvers)
    if options.out is not None:
        write_whole(Path(options.out), auto_fit.as_file(numbers))
    print(json.dumps(numbers, indent=1) if options.json else text)


def _training(options: argparse.Namespace) -> None:
    seeds = checked_number("seeds", options.seeds, int, 1, high=100)
    aim = checked_number("aim", options.aim, float, -1e9, high=1e9)
    settings_of(options.algorithm, options.environment, {})
    from laplace_core.experiments import training  # loads torch

    numbers, text = training.report(options.algorithm, options.environment, seeds, aim, folder=Path(options.runs))
    print(json.dumps(numbers, indent=1) if options.json else text)


def _horizon(options: argparse.Namespace) -> None:
    episodes, seed = (
        checked_number("episodes", options.episodes, int, 2, high=10_000),
        checked_number("seed", options.seed, int, 0, high=10**6),
    )
    horizons = [
        None if word == "full" else checked_number("horizons", word, int, 1, high=10_000)
        for word in options.horizons.split(",")
    ]
    given = {
        name: checked_number(name, getattr(options, name), float, low, high=high)
        for name, low, high in (("stretch", 0.01, 100.0), ("alpha", 1e-9, 1e6), ("softness", 0.0, 10.0))
        if getattr(options, name) is not None
    }
    from laplace_core.acting.rules import check_rule_options
    from laplace_core.experiments import horizon  # loads torch

    check_rule_options(options.rule, given)
    paths, references = ([Path(path) for path in several] for several in (options.checkpoints, options.reference))
    numbers, text = horizon.report(
        paths, options.rule, horizons, episodes, seed=seed, options=given, references=references
    )
    print(json.dumps(numbers, indent=1) if options.json else text)


def _interpolation(options: argparse.Namespace) -> None:
    seed = checked_number("seed", options.seed, int, 0, high=10**6)
    from laplace_core.experiments import interpolation  # loads torch

    numbers, text = interpolation.report(Path(options.checkpoint), seed)
    print(json.dumps(numbers, indent=1) if options.json else text)


def _cases(options: argparse.Namespace) -> tuple[int, int]:
    """Number and seed of random worlds."""
    return (
        checked_number("cases", options.cases, int, 1, high=10_000),
        checked_number("seed", options.seed, int, 0, high=2**31 - 1),
    )


def _grids(options: argparse.Namespace) -> None:
    cases, seed = _cases(options)
    count = checked_number("gammas", options.gammas, int, 2, high=100)
    horizon = checked_number("horizon", options.horizon, int, 2, high=1_000)
    noise = checked_number("noise", options.noise, float, 0.0, high=1.0)
    from laplace_core.experiments.inverse import grid_report  # only this verb needs it

    numbers, text = grid_report.report(count, horizon, noise, cases, seed=seed)
    print(json.dumps(numbers, indent=1) if options.json else text)
    if options.check:
        _check([f"less error than with the grid {name}" for name in numbers["missed"]])


def _neural(options: argparse.Namespace) -> None:
    cases, seed = _cases(options)
    from laplace_core.experiments.inverse import neural_report  # only this verb needs it
    from laplace_core.inverse.neural import SHIPPED, read_network

    paths = sorted(SHIPPED.glob("*.safetensors")) if options.network is None else [Path(options.network)]
    reports = {path.stem: neural_report.report(read_network(path), cases, seed) for path in paths}
    if options.json:
        print(json.dumps({name: numbers for name, (numbers, _) in reports.items()}, indent=1))
    else:
        print("\n\n".join(f"{name}: {text}" for name, (_, text) in reports.items()))
    if options.check:
        missed = [(name, noise) for name, (numbers, _) in reports.items() for noise in numbers["missed"]]
        _check([f"the least distance of {name} at noise {noise:g}" for name, noise in missed])


def _searches(options: argparse.Namespace) -> None:
    from laplace_core.experiments.search import results

    numbers, text = results.report([Path(path) for path in options.files])
    print(json.dumps(numbers, indent=1) if options.json else text)


def _ship(options: argparse.Namespace) -> None:
    seeds = checked_number("seeds", options.seeds, int, 1, high=100)
    settings_of(options.algorithm, options.environment, {})
    from laplace_core.experiments import shipping  # loads torch

    entry = shipping.ship(options.algorithm, options.environment, seeds, Path(options.runs), folder=Path(options.out))
    print(json.dumps(entry, indent=1))


def _shipped(options: argparse.Namespace) -> None:
    from laplace_core.experiments import shipped_report  # loads torch

    numbers, text = shipped_report.report(Path(options.folder))
    print(json.dumps(numbers, indent=1) if options.json else text)
