"""The verb ``learn``: learners that advance in turns, a snapshot file and a progress file while they do."""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from laplace_core.cli.options import action_runs, add_parameters, named_params
from laplace_core.errors import InputError
from laplace_core.parameters import as_text
from laplace_core.study.pipeline import Study
from laplace_core.study.settings import Settings, check_paper_grid
from laplace_core.tabular.files import read_learned, save_learned
from laplace_core.tabular.learner import Learning
from laplace_core.tabular.model import Learned
from laplace_core.tabular.reading import study_of
from laplace_core.tabular.settings import DECIDED_NAMES, LEARN_SCHEMA, parse_learn_settings
from laplace_core.worlds import load_world

REPORT_EVERY = 0.4
"""Seconds between two lines of progress, and between two snapshots unless writing them takes long."""


PEER_NAMES = ("peer_gamma", "atoms", "quantiles", "expectiles", "quantile_half")
"""Settings that only the peers have."""


def add_learn(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """The parser of the verb."""
    learn = verbs.add_parser(
        "learn",
        help="learn a world from sampled transitions",
        description="Temporal-difference learning of the Laplace code, several seeds at once. "
        "Every option has a default that suits the world.",
    )
    learn.add_argument("world", metavar="WORLD", help="a preset, a world file (.json) or gym:NAME")
    learn.add_argument("--param", action="append", default=[], metavar="name=value", help="a parameter of the world")
    add_parameters(learn, LEARN_SCHEMA)
    learn.add_argument(
        "--out", metavar="FILE.safetensors", help="save the learned tables here, again and again while it learns"
    )
    learn.add_argument("--progress", metavar="FILE.jsonl", help="append a JSON line of progress here as it learns")
    learn.add_argument("--json", action="store_true", help="print progress and result as JSON lines")
    learn.add_argument("--parent", type=int, help=argparse.SUPPRESS)  # end with this process
    learn.set_defaults(run=run_learn)


def run_learn(options: argparse.Namespace) -> None:
    """Learn to the end; SIGTERM ends it at once with status 143, and the snapshot on disk is whole."""
    given = {p.name: getattr(options, p.name) for p in LEARN_SCHEMA}
    settings = parse_learn_settings(given)
    check_paper_grid(given)
    for name in PEER_NAMES:
        if options.peers is None and given[name] is not None:
            raise InputError(f"--{name.replace('_', '-')} changes nothing without --peers: give both, or neither.")
    if options.out is not None and not options.out.lower().endswith(".safetensors"):
        raise InputError(f"--out {options.out[:60]!r} must end in .safetensors.")
    if options.world.lower().endswith((".npz", ".safetensors")):
        raise InputError(f"{options.world[:60]} is no world: learn a preset, a world file (.json) or gym:NAME.")
    learning = Learning(load_world(options.world, named_params(options.param)), settings)
    with _reporters(options) as reporters:
        learned = _learn(learning, options.out, reporters, options.parent)
    print(json.dumps(summary(learned)) if options.json else report(learned, learning.progress))


def _learn(
    learning: Learning, out: str | None, reporters: Sequence[Callable[[dict[str, object]], None]], parent: int | None
) -> Learned:
    pause = 0.0  # the first report comes at once, so that a file that cannot be written is refused early
    reported = time.monotonic()
    for _ in learning:
        if time.monotonic() - reported < pause:
            continue
        if parent is not None and os.getppid() != parent:
            raise SystemExit(1)
        began = time.monotonic()
        _report_and_save(learning, None if out is None else learning.snapshot(), out, reporters)
        reported = time.monotonic()
        pause = max(REPORT_EVERY, 10.0 * (reported - began))  # never more than a tenth of the time for writing
    learned = learning.snapshot()
    _report_and_save(learning, learned, out, reporters)
    return learned


def _report_and_save(
    learning: Learning,
    learned: Learned | None,
    out: str | None,
    reporters: Sequence[Callable[[dict[str, object]], None]],
) -> None:
    if learned is not None and out is not None:
        save_learned(learned, out)
    for reporter in reporters:  # after the file, so that it is there for whoever reads of the end
        reporter(learning.progress)


@contextmanager
def _reporters(options: argparse.Namespace) -> Iterator[list[Callable[[dict[str, object]], None]]]:
    """Functions that report progress: to the file, to standard output as JSON, or as one line in a terminal."""
    reporters: list[Callable[[dict[str, object]], None]] = []
    if options.json:
        reporters.append(lambda progress: print(json.dumps(progress), flush=True))
    elif sys.stderr.isatty():
        reporters.append(_terminal_line)
    if options.progress is None:
        yield reporters
        return
    try:
        file = Path(options.progress).open("a", encoding="utf-8")  # noqa: SIM115 - closed below; errors in use are ours
    except OSError as error:
        reason = (error.strerror or "unknown error").lower()
        raise InputError(f"{options.progress} cannot be written: {reason}.") from None
    except ValueError:
        raise InputError(f"{options.progress!r} cannot be the name of a file.") from None
    with file:

        def append(progress: dict[str, Any]) -> None:
            file.write(json.dumps(progress) + "\n")
            file.flush()

        yield [*reporters, append]


def _terminal_line(progress: dict[str, Any]) -> None:
    error = "" if progress["error"] is None else f", error {progress['error']:.2%} of the range"
    eta = "" if progress["eta"] is None else f", {progress['eta']:.0f} s to go"
    line = (
        f"{progress['episodes']:,} of {progress['of']:,} episodes, {progress['steps_per_second']:,} steps/s{error}{eta}"
    )
    print(f"\r{line:<78}", end="\n" if progress["finished"] else "", file=sys.stderr, flush=True)


def summary(learned: Learned) -> dict[str, object]:
    """The result in plain numbers: per seed the last error and the action of every horizon, and the best ones."""
    studies = [study_of(learned, seed_index=i) for i in range(len(learned.basis))]
    return {
        "actions": list(learned.world.actions),
        "state": studies[0].settings.state,
        "seeds": [
            {"seed": seed, "error": float(curve["error"][-1]), "chosen_action": study.decoded.actions.tolist()}
            for seed, curve, study in zip(learned.seeds, learned.curves, studies, strict=True)
        ],
        "optimal_action": studies[0].truth.optimal_action.tolist(),
    }


def report(learned: Learned, progress: dict[str, object]) -> str:
    """The report that ``learn`` prints at its end."""
    studies = [study_of(learned, seed_index=i) for i in range(len(learned.basis))]
    first, s = studies[0], learned.settings
    lines = [
        f"{learned.world.name}: {s.seeds} x {s.episodes:,} episodes, {progress['steps']:,} steps in "
        f"{progress['seconds']:.1f} s, {s.gammas} discounts, policy {s.policy}",
        f"from state {first.settings.state}, alpha {first.settings.alpha:g}: error of gamma-space and actions by T",
    ]
    for seed, curve, study in zip(learned.seeds, learned.curves, studies, strict=True):
        lines.append(f"  seed {seed:<5} {curve['error'][-1]:8.3%}   {action_runs(study, study.decoded.actions)}")
    lines.append(f"  {'best':<10} {'':8}   {action_runs(first, first.truth.optimal_action)}")
    return "\n".join(lines)


def study_of_file(path: str | Path, settings: Settings) -> Study:
    """``decode`` of a learned file: the state of one learner, the truth beside it; ``seed_index`` is its parameter.

    Raises:
        InputError: no such file, or a setting that the learner has decided.
    """
    params = dict(settings.params)
    text = str(params.pop("seed_index", "0"))
    if params:
        raise InputError("a learned file has no parameter but seed_index: leave out --param.")
    if not text.isdecimal() or len(text) > 9:
        raise InputError(f"seed_index must be a whole number from 0, not {text[:40]!r}.")
    learned = read_learned(path)
    for name in DECIDED_NAMES:
        wanted, has = getattr(settings, name), getattr(learned.settings, name)
        if wanted not in (None, has):
            raise InputError(f"--{name.replace('_', '-')} cannot be chosen: it is {as_text(has)} in this learned file.")
    result = study_of(learned, settings, int(text))
    return replace(result, settings=replace(result.settings, world=str(path), params=(("seed_index", int(text)),)))
