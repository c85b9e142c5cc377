"""Trained agents: those that ship, those that were trained here, those that this session opened, and what they see
of one observation."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from app import session
from app.catalogue import training_runs
from app.session.url import Entries, by_name, check_of
from laplace_core import InputError
from laplace_core.agents.settings import ENVIRONMENTS, SETTINGS, algorithm_title
from laplace_core.caching import cached
from laplace_core.experiments.shipping import TABULAR, TrainingCurve, curves_of, damaged, manifest
from laplace_core.parameters import Parameter
from laplace_core.training.checkpoint import Loaded, load_checkpoint, parse_checkpoint

SHIPPED = Path(__file__).resolve().parents[2] / "checkpoints"
RUN = "run:"  # prefix of the names of those that were trained here


@cache
def shipped() -> tuple[str, ...]:
    """Names of the checkpoints that come with the workbench, ``ALGORITHM_ENVIRONMENT``: those with many discounts
    first, then by environment. Tabular ones open on the page of worlds; damaged ones are left out."""
    files = [path for path in SHIPPED.glob("*.safetensors") if not path.stem.endswith(TABULAR)]
    stems = [path.stem for path in files if path.name not in _damaged(SHIPPED)]
    return tuple(sorted(stems, key=lambda name: (not name.startswith("laplace_"), *_place(name))))


@cached(1, fixed=True)
def _damaged(folder: Path) -> dict[str, str]:
    return damaged(folder)


def left_out() -> tuple[str, ...]:
    """What cannot be used of the files that come with the workbench, a sentence each."""
    return tuple(_damaged(SHIPPED).values())


def _place(name: str) -> tuple[int, int, str]:
    """Environment and algorithm by their places in the lists of the library."""
    algorithm, environment = _parts(name)
    listed, algorithms = [each.replace(":", "-") for each in ENVIRONMENTS], list(SETTINGS)
    at = listed.index(environment) if environment in listed else len(listed)
    return at, algorithms.index(algorithm) if algorithm in algorithms else len(algorithms), name


def _parts(name: str) -> tuple[str, str]:
    # The longest, because the name of one algorithm may begin with that of another.
    algorithm = max((each for each in SETTINGS if name.startswith(f"{each}_")), key=len, default="")
    return algorithm, name.removeprefix(f"{algorithm}_")


def title(name: str) -> str:
    """A checkpoint as a person reads it."""
    if name in opened():
        return f"opened file: {titled(opened()[name])}"
    if name.startswith(RUN):
        return f"run: {name.removeprefix(RUN).replace('_', ' ')}"
    algorithm, environment = _parts(name)
    return f"{plain(environment)} · {algorithm_title(algorithm)}"


def titled(loaded: Loaded) -> str:
    return f"{plain(loaded.environment)} · {loaded.settings.TITLE}"


def plain(environment: str) -> str:
    """An environment's name without its version."""
    return re.sub(r"-v\d+$", "", environment).removeprefix("gym:")


def curves(name: str) -> tuple[TrainingCurve, ...]:
    """Evaluations while training, that of the checkpoint's own seed first; none where they are not known."""
    if name in opened():
        return ()
    if name.startswith(RUN):
        c = training_runs.curves(training_runs.queue().get(name.removeprefix(RUN)))
        points = (tuple(part.tolist()) for part in (c.steps, c.scores, c.errors))
        return (TrainingCurve(checkpoint(name).seed, *points),) if len(c.steps) else ()
    return _shipped_curves(name)


@cached(32, fixed=True)
def _shipped_curves(name: str) -> tuple[TrainingCurve, ...]:
    try:
        for entry in manifest(SHIPPED):
            if entry["file"] == f"{name}.safetensors":
                return tuple(sorted(curves_of(SHIPPED, entry), key=lambda curve: curve.seed != entry.get("seed")))
    except InputError:  # which is among those that are left out
        pass
    return ()


def shipped_curves(environment: str) -> dict[str, tuple[TrainingCurve, ...]]:
    """Evaluations while training of the agents that ship for an environment, by algorithm, those of several seeds."""
    curves = {_parts(name)[0]: _shipped_curves(name) for name in _shipped_for(environment)}
    return {algorithm: seeds for algorithm, seeds in curves.items() if len(seeds) > 1}


def same_environment(loaded: Loaded) -> list[Loaded]:
    """Agents that ship, of this environment."""
    return [_shipped(name) for name in _shipped_for(loaded.environment)]


def _shipped_for(environment: str) -> list[str]:
    return [name for name in shipped() if _parts(name)[1] == environment.replace(":", "-")]


@cached(16, fixed=True)
def _shipped(name: str) -> Loaded:
    return load_checkpoint(SHIPPED / f"{name}.safetensors")


def trained() -> tuple[str, ...]:
    """Names of the best checkpoints of the runs of this server, the newest first."""
    try:
        runs = training_runs.queue().runs()
    except InputError:  # the page of runs says so
        return ()
    return tuple(RUN + run.name for run in runs if training_runs.best(run))


@cached(8)
def _trained(path: Path, written: int) -> Loaded:
    return load_checkpoint(path)


def opened() -> Mapping[str, Loaded]:
    """The checkpoint that this session has opened from a file, by digest; one at a time."""
    return session.opened(Loaded)


def names() -> tuple[str, ...]:
    """All agents there are: those that ship, those of runs, the one that was opened."""
    return (*shipped(), *trained(), *opened())


def open_checkpoint(name: str, data: bytes) -> str:
    """Check an uploaded checkpoint and keep it for this session; returns its digest.

    Raises:
        InputError: not such a file.
    """
    loaded = parse_checkpoint(data, Path(name).name[-80:] or "upload.safetensors")
    return session.keep_opened(loaded, data)


def checkpoint(name: str) -> Loaded:
    """A checkpoint by the name that a link gives it.

    Raises:
        InputError: it neither ships with the workbench nor was trained or opened here.
    """
    if name in opened():
        return opened()[name]
    if name.startswith(RUN):
        run = training_runs.queue().get(name.removeprefix(RUN))
        path = training_runs.best(run)
        if path is None:
            raise InputError(f"the run {run.name} has no checkpoint yet: it comes with the first evaluation.")
        return _trained(path, path.stat().st_mtime_ns)
    if name not in shipped():
        listed = ", ".join(shipped()) or "none"
        raise InputError(f"no checkpoint {name[:40]!r} comes with the workbench; there are: {listed}.")
    return _shipped(name)


NAMED = (
    Entries(by_name(Parameter("checkpoint", None, help="The agent.", kind=str))),
    check_of("checkpoint", lambda name: checkpoint(name)),
)
"""How the link of a page that shows an agent begins: its name. Without such an agent nothing else has a meaning."""
