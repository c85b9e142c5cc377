"""The bundled agents of a folder; damaged files are left out.

A folder is looked at once: :func:`forget` is for one whose files were changed meanwhile.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from laplace_core.agents.settings import ENVIRONMENTS, SETTINGS, algorithm_title
from laplace_core.caching import cached
from laplace_core.errors import InputError
from laplace_core.experiments.shipping import TABULAR, TrainingCurve, curves_of, damaged, manifest
from laplace_core.training.checkpoint import Loaded, load_checkpoint
from laplace_core.worlds.titles import plain


@cache
def names(folder: Path) -> tuple[str, ...]:
    """Names of the checkpoints, ``ALGORITHM_ENVIRONMENT``: those with many discounts first, then by environment.

    Those that learned a tabular world are :func:`laplace_core.tabular.shipped.names`.
    """
    files = [path for path in folder.glob("*.safetensors") if not path.stem.endswith(TABULAR)]
    stems = [path.stem for path in files if path.name not in _damaged(folder)]
    return tuple(sorted(stems, key=lambda name: (not name.startswith("laplace_"), *_place(name))))


@cached(1, fixed=True)
def _damaged(folder: Path) -> dict[str, str]:
    return damaged(folder)


def left_out(folder: Path) -> tuple[str, ...]:
    """A sentence about each damaged file."""
    return tuple(_damaged(folder).values())


def _place(name: str) -> tuple[int, int, str]:
    """Environment and algorithm by their places in the lists of the library."""
    algorithm, environment = parts_of(name)
    listed, algorithms = [each.replace(":", "-") for each in ENVIRONMENTS], list(SETTINGS)
    at = listed.index(environment) if environment in listed else len(listed)
    return at, algorithms.index(algorithm) if algorithm in algorithms else len(algorithms), name


def parts_of(name: str) -> tuple[str, str]:
    """The algorithm and the environment of a checkpoint's name."""
    # The longest, because the name of one algorithm may begin with that of another.
    algorithm = max((each for each in SETTINGS if name.startswith(f"{each}_")), key=len, default="")
    return algorithm, name.removeprefix(f"{algorithm}_")


def title(name: str) -> str:
    """A checkpoint's name as a person reads it."""
    algorithm, environment = parts_of(name)
    return f"{plain(environment)} · {algorithm_title(algorithm)}"


def load(folder: Path, name: str) -> Loaded:
    """The checkpoint of a name.

    Raises:
        InputError: there is none.
    """
    if name not in names(folder):
        listed = ", ".join(names(folder)) or "none"
        raise InputError(f"no checkpoint {name[:40]!r} comes with the workbench; there are: {listed}.")
    return _load(folder / f"{name}.safetensors")


@cached(16, fixed=True)
def _load(path: Path) -> Loaded:
    return load_checkpoint(path)


@cached(32, fixed=True)
def curves(folder: Path, name: str) -> tuple[TrainingCurve, ...]:
    """Evaluations while training, that of the checkpoint's own seed first; none where they are not known."""
    try:
        for entry in manifest(folder):
            if entry["file"] == f"{name}.safetensors":
                return tuple(sorted(curves_of(folder, entry), key=lambda curve: curve.seed != entry.get("seed")))
    except InputError:  # which is among those that are left out
        pass
    return ()


def curves_for(folder: Path, environment: str) -> dict[str, tuple[TrainingCurve, ...]]:
    """Evaluations while training of the agents of an environment, by algorithm, those of several seeds."""
    found = {parts_of(name)[0]: curves(folder, name) for name in names_for(folder, environment)}
    return {algorithm: seeds for algorithm, seeds in found.items() if len(seeds) > 1}


def names_for(folder: Path, environment: str) -> list[str]:
    """Names of the checkpoints of an environment."""
    return [name for name in names(folder) if parts_of(name)[1] == environment.replace(":", "-")]


def forget() -> None:
    """Look at all folders again."""
    for each in (names, _damaged, _load, curves):
        each.cache_clear()
