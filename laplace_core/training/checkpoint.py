"""Checkpoints: a trained agent as one self-describing ``.safetensors`` file, of which every field is validated."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch

from laplace_core import __version__
from laplace_core.agents import ENVIRONMENTS, SETTINGS, LoopSettings
from laplace_core.agents.agent import Agent
from laplace_core.agents.registry import AGENTS
from laplace_core.environments import vector
from laplace_core.errors import InputError
from laplace_core.files.tensor_file import parse_tensors, read_tensors, write_tensors

MAX_BYTES = 64_000_000
LARGEST_WEIGHT = 1e6
MOST_COUNT = 2**53
"""Steps or episodes that a file may tell of: what a float holds exactly."""

_FIELDS: dict[str, type | tuple[type, ...]] = {
    "algorithm": str, "environment": str, "settings": dict, "seed": int, "step": int, "score": (float, int, type(None)),
    "episodes": int, "version": str,
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Loaded:
    """An agent and the metadata of its checkpoint.

    Attributes:
        score: mean return of the evaluation that it was saved after, over ``episodes``; None if there was none.
        version: of the package that wrote it.
    """

    agent: Agent
    algorithm: str
    environment: str
    settings: LoopSettings
    seed: int
    step: int
    score: float | None
    episodes: int
    version: str


def new_agent(settings: LoopSettings) -> Agent:
    """An untrained agent, its network fitted to the environment.

    Raises:
        InputError: settings whose network no checkpoint could hold.
    """
    spec, kind = vector.spec(settings.environment), AGENTS[settings.ALGORITHM]
    numbers = kind.network_numbers(settings, spec.observation, spec.actions)
    if 4 * numbers > MAX_BYTES - 1_000_000:
        raise InputError(
            f"these settings make a network of {numbers:,} weights: lower hidden or the number of outputs."
        )
    return kind(settings, spec.observation, spec.actions, spec.time_limit)


def save_checkpoint(path: str | Path, agent: Agent, step: int, score: float | None, *, episodes: int = 0) -> None:
    """Write the agent's averaged network, whole or not at all."""
    settings = agent.settings
    about = {
        "algorithm": settings.ALGORITHM, "environment": settings.environment, "settings": settings.as_dict(),
        "seed": settings.seed, "step": step, "score": score, "episodes": episodes, "version": __version__,
    }  # fmt: skip
    write_tensors(Path(path), {name: array.numpy() for name, array in agent.target.state_dict().items()}, about)


def load_checkpoint(path: str | Path) -> Loaded:
    """Read a checkpoint from an untrusted source; see :func:`parse_checkpoint`.

    Raises:
        InputError: one sentence for whatever is wrong first.
    """
    return _checked(*read_tensors(path, MAX_BYTES), Path(path).name)


def parse_checkpoint(data: bytes, name: str) -> Loaded:
    """The checkpoint in the content of a file from an untrusted source.

    Before anything is used, names, shapes, types and finiteness of the arrays are compared with a network built from
    the settings, and the settings with their ranges and with the size of the file.

    Raises:
        InputError: one sentence for whatever is wrong first.
    """
    return _checked(*parse_tensors(data, name, MAX_BYTES), name)


def _checked(arrays: dict[str, np.ndarray], about: dict[str, Any], name: str) -> Loaded:
    for field, kind in _FIELDS.items():
        if not isinstance(about.get(field), kind) or isinstance(about[field], bool):
            raise InputError(f"the metadata of {name!r} has no proper {field!r}.")
    if set(about) != set(_FIELDS):
        raise InputError(f"the metadata of {name!r} has entries that no checkpoint has.")
    if about["algorithm"] not in SETTINGS:
        raise InputError(f"{name!r} names the algorithm {about['algorithm'][:40]!r}; known: {', '.join(SETTINGS)}.")
    if about["environment"] not in ENVIRONMENTS:
        raise InputError(f"{name!r} names the environment {about['environment'][:40]!r}, which is not on the list.")
    settings = _settings(SETTINGS[about["algorithm"]], about["settings"], name)
    if settings.environment != about["environment"] or settings.seed != about["seed"]:
        raise InputError(f"the settings in {name!r} contradict the environment or seed beside them.")
    if not (0 <= about["step"] <= MOST_COUNT and 0 <= about["episodes"] <= MOST_COUNT) or len(about["version"]) > 40:
        raise InputError(f"the metadata of {name!r} has a step, episodes or version that cannot be.")
    score = about["score"]
    if score is not None and not (abs(score) <= 1e12 and math.isfinite(score)):
        raise InputError(f"the metadata of {name!r} has a score that cannot be.")
    agent = _agent(settings, arrays, name)
    about["score"] = None if score is None else float(score)
    return Loaded(**(about | {"settings": settings}), agent=agent)


def _settings(kind: type[LoopSettings], given: dict[str, Any], name: str) -> LoopSettings:
    types = {parameter.name: parameter.type for parameter in kind.SCHEMA}
    for key, value in given.items():
        wanted = types.get(key)
        fits = type(value) is wanted or (wanted is float and type(value) is int)
        if wanted is not None and not fits:
            raise InputError(f"setting {key!r} in {name!r} must be of the type {wanted.__name__}.")
    return kind.parse(given)


def _agent(settings: LoopSettings, arrays: dict[str, np.ndarray], name: str) -> Agent:
    spec, kind = vector.spec(settings.environment), AGENTS[settings.ALGORITHM]
    # Counted before anything is built, so that a small file cannot ask for a large network.
    numbers, held = (
        kind.network_numbers(settings, spec.observation, spec.actions),
        sum(a.size for a in arrays.values()),
    )
    if numbers != held:
        raise InputError(f"the settings in {name!r} ask for {numbers:,} weights, the file holds {held:,}.")
    agent = kind(settings, spec.observation, spec.actions, spec.time_limit)
    check_tensors(arrays, {key: tensor.numpy() for key, tensor in agent.target.state_dict().items()}, name)
    weights = {key: torch.from_numpy(array) for key, array in arrays.items()}
    agent.network.load_state_dict(weights)
    agent.target.load_state_dict(weights)
    return agent


def check_tensors(
    arrays: dict[str, np.ndarray], wanted: dict[str, np.ndarray], name: str, largest: float = LARGEST_WEIGHT
) -> None:
    """Refuse arrays that differ from those wanted in name, shape or type, or that hold no sensible numbers.

    Args:
        largest: size of a number; the default is that of a weight.

    Raises:
        InputError: naming the first of them.
    """
    for key in wanted:
        if key not in arrays:
            raise InputError(f"{name!r} lacks the array {key!r}.")
    for key in arrays:
        if key not in wanted:
            raise InputError(f"{name!r} holds an array {key[:60]!r} that its settings have no place for.")
    for key, array in arrays.items():
        if array.shape != wanted[key].shape or array.dtype != wanted[key].dtype:
            is_, should = (f"{one.dtype} {one.shape}" for one in (array, wanted[key]))
            raise InputError(f"array {key!r} in {name!r} is {is_}, not {should}.")
        if array.dtype.kind == "f" and not np.all(np.abs(array) <= largest):  # NaN fails as well
            raise InputError(f"array {key!r} in {name!r} holds a value that is not a number within +-{largest:g}.")
