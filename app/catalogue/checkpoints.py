"""Trained agents: those that ship, those that were trained here, those that this session opened, and what they see
of one observation."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from app import session
from app.catalogue import training_runs
from laplace_core import InputError
from laplace_core.caching import cached
from laplace_core.exchange.links import Entries, by_name, check_of
from laplace_core.experiments import shipped_agents
from laplace_core.experiments.shipping import TrainingCurve
from laplace_core.parameters import Parameter
from laplace_core.trained.observations import titled
from laplace_core.training.checkpoint import Loaded, load_checkpoint, parse_checkpoint

SHIPPED = Path(__file__).resolve().parents[2] / "checkpoints"
RUN = "run:"  # prefix of the names of those that were trained here


def shipped() -> tuple[str, ...]:
    """Names of the checkpoints that come with the workbench; tabular ones open on the page of worlds."""
    return shipped_agents.names(SHIPPED)


def left_out() -> tuple[str, ...]:
    """Sentences about the damaged files of the workbench, which are left out."""
    return shipped_agents.left_out(SHIPPED)


def title(name: str) -> str:
    """A checkpoint as a person reads it."""
    if name in opened():
        return f"opened file: {titled(opened()[name])}"
    if name.startswith(RUN):
        return f"run: {name.removeprefix(RUN).replace('_', ' ')}"
    return shipped_agents.title(name)


def curves(name: str) -> tuple[TrainingCurve, ...]:
    """Evaluations while training, that of the checkpoint's own seed first; none where they are not known."""
    if name in opened():
        return ()
    if name.startswith(RUN):
        c = training_runs.curves(training_runs.queue().get(name.removeprefix(RUN)))
        points = (tuple(part.tolist()) for part in (c.steps, c.scores, c.errors))
        return (TrainingCurve(checkpoint(name).seed, *points),) if len(c.steps) else ()
    return shipped_agents.curves(SHIPPED, name)


def shipped_curves(environment: str) -> dict[str, tuple[TrainingCurve, ...]]:
    """Evaluations while training of the agents that ship for an environment, by algorithm, those of several seeds."""
    return shipped_agents.curves_for(SHIPPED, environment)


def same_environment(loaded: Loaded) -> list[Loaded]:
    """Agents that ship, of this environment."""
    return [shipped_agents.load(SHIPPED, name) for name in shipped_agents.names_for(SHIPPED, loaded.environment)]


def trained() -> tuple[str, ...]:
    """Names of the best checkpoints of the runs of this server, the newest first."""
    try:
        runs = training_runs.queue().runs()
    except InputError:  # the page of runs says so
        return ()
    return tuple(RUN + run.name for run in runs if run.best)


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
        path = run.best
        if path is None:
            raise InputError(f"the run {run.name} has no checkpoint yet: the first evaluation writes one.")
        return _trained(path, path.stat().st_mtime_ns)
    return shipped_agents.load(SHIPPED, name)


def file_of(name: str) -> str:
    """The path of a checkpoint; None for one that was opened from a file."""
    if name.startswith(RUN):
        return f"runs/{name.removeprefix(RUN)}/best.safetensors"
    return f"checkpoints/{name}.safetensors" if name in shipped() else "opened.safetensors"


NAMED = (
    Entries(by_name(Parameter("checkpoint", None, help="The agent.", kind=str))),
    check_of("checkpoint", lambda name: checkpoint(name)),
)
"""How the link of a page that shows an agent begins: its name. Without such an agent nothing else has a meaning."""
