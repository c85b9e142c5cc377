"""Trained agents: those that ship, those that were trained here, those that this session opened, and what they see
of one observation."""

from __future__ import annotations

import hashlib
import tempfile
from functools import cache, lru_cache
from pathlib import Path

import numpy as np
import streamlit as st

from app import training_runs
from app.sources import Observed
from laplace_core import InputError
from laplace_core.agents.laplace import LaplaceAgent
from laplace_core.interpolation import with_added
from laplace_core.training.checkpoint import Loaded, load_checkpoint

SHIPPED = Path(__file__).resolve().parent.parent / "checkpoints"
RUN = "run:"  # prefix of the names of those that were trained here


@cache
def shipped() -> tuple[str, ...]:
    """Names of the checkpoints that come with the workbench."""
    return tuple(sorted(path.stem for path in SHIPPED.glob("laplace_*.safetensors")))


@lru_cache(maxsize=8)
def _shipped(name: str) -> Loaded:
    return load_checkpoint(SHIPPED / f"{name}.safetensors")


def trained() -> tuple[str, ...]:
    """Names of the best checkpoints of the runs of this server, the newest first."""
    try:
        runs = training_runs.queue().runs()
    except InputError:  # the page of runs says so
        return ()
    found = [run.name for run in runs if training_runs.has_discounts(run) and training_runs.best(run)]
    return tuple(RUN + name for name in found)


@lru_cache(maxsize=8)
def _trained(path: Path, written: int) -> Loaded:
    return load_checkpoint(path)


def opened() -> dict[str, Loaded]:
    """The checkpoint that this session has opened from a file, by digest; one at a time."""
    return st.session_state.setdefault("_opened_checkpoints", {})


def open_checkpoint(name: str, data: bytes) -> str:
    """Check an uploaded checkpoint and keep it for this session; returns its digest.

    Raises:
        InputError: not such a file.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / (Path(name).name[-80:] or "upload.safetensors")
        path.write_bytes(data)
        loaded = load_checkpoint(path)
    if not isinstance(loaded.agent, LaplaceAgent):
        raise InputError(f"{loaded.algorithm} has no gamma-space to look at: open a checkpoint of laplace.")
    digest = hashlib.sha256(data).hexdigest()[:12]
    st.session_state["_opened_checkpoints"] = {digest: loaded}
    return digest


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
        if path is None or not training_runs.has_discounts(run):
            raise InputError(f"the run {run.name} has no checkpoint with values at many discounts.")
        return _trained(path, path.stat().st_mtime_ns)
    if name not in shipped():
        listed = ", ".join(shipped()) or "none"
        raise InputError(f"no checkpoint {name[:40]!r} comes with the workbench; there are: {listed}.")
    return _shipped(name)


@lru_cache(maxsize=64)
def observe(
    loaded: Loaded, observation: tuple[float, ...], action_names: tuple[str, ...], added: int = 0
) -> Observed:  # fmt: skip
    """The same object for the same observation, so that what is cached for it is found again.

    ``added`` interpolated discounts go into every gap between those that were trained.
    """
    space = with_added(loaded.agent.gamma_space(np.array(observation)), added)
    return Observed(space, action_names, loaded.agent.sensitivities.places, added)
