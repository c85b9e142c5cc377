"""Learned agents as .safetensors files: written whole or not at all, validated before use.

Tensors: ``table_shapes`` names them; tables are float32, values float64. Metadata, all JSON: ``kind``, ``version``,
``world`` (preset and parameters, or the text of a world file), ``settings``, ``curves`` and ``finished``.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path

import numpy as np

from laplace_core.errors import InputError
from laplace_core.files.atomic import atomic_write
from laplace_core.files.strict_json import parse_json
from laplace_core.files.tensors import parse_tensor_file, read_bytes
from laplace_core.tabular.model import CURVE_NAMES, Learned, PeerTables
from laplace_core.tabular.reading import bounds_of
from laplace_core.tabular.settings import (
    BY_NAME,
    ResolvedLearning,
    parse_learn_settings,
    resolve_learning,
    table_shapes,
)
from laplace_core.worlds import PRESETS, World, dump_world, load_world, parse_world

KIND, VERSION = "laplace learned", 1
MAX_BYTES = 64_000_000
MAX_HEADER = 8_000_000
MAX_NOTES = 5_000
"""Most points of a learning curve that are read."""
_KEYS = ("kind", "version", "world", "settings", "curves", "finished")
_DTYPES = {"acting_values": "F64", "laplace_values": "F64", "plain": "F64"}  # the others: F32
_NUMPY = {"F32": np.float32, "F64": np.float64}


def learned_bytes(learned: Learned) -> bytes:
    """The content of the file.

    Raises:
        InputError: a world whose description alone is too long.
    """
    from safetensors.numpy import save

    tensors = {"basis": learned.basis, "acting_values": learned.acting_values}
    if learned.peers is not None:
        names = ("laplace_values", "plain", "categorical", "quantile", "expectile")
        tensors |= {name: getattr(learned.peers, name) for name in names}
    tensors = {name: np.ascontiguousarray(array, _NUMPY[_DTYPES.get(name, "F32")]) for name, array in tensors.items()}
    curves = [{name: [_short(x) for x in curve[name]] for name in CURVE_NAMES} for curve in learned.curves]
    entries = {
        "kind": KIND,
        "version": VERSION,
        "world": _describe(learned.world),
        "settings": asdict(learned.settings),
        "curves": curves,
        "finished": learned.finished,
    }
    metadata = {name: json.dumps(value, allow_nan=False, separators=(",", ":")) for name, value in entries.items()}
    if sum(map(len, metadata.values())) > MAX_HEADER // 2:  # quotes are escaped once more
        raise InputError(f"world {learned.world.name!r} is too large to be saved with what was learned of it.")
    return _in_order(save(tensors, metadata))


def _in_order(content: bytes) -> bytes:
    """The same file with its metadata sorted: equal agents make equal bytes."""
    size = int.from_bytes(content[:8], "little")
    header = json.loads(content[8 : 8 + size])
    header["__metadata__"] = dict(sorted(header["__metadata__"].items()))
    text = json.dumps(header, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-len(text) % 8)
    return len(text).to_bytes(8, "little") + text + content[8 + size :]


def _short(x: float) -> float:
    return float(f"{x:.6g}")


def _describe(world: World) -> dict[str, object]:
    if world.source in PRESETS or world.source.startswith("gym:"):
        return {"source": world.source, "params": dict(world.params)}
    return {"text": json.dumps(json.loads(dump_world(world)), separators=(",", ":"))}


def save_learned(learned: Learned, path: str | Path) -> None:
    """Write ``learned_bytes`` to ``path``: whole or not at all.

    Raises:
        InputError: the folder is missing or not writable, or the world too large.
    """
    content = learned_bytes(learned)
    with atomic_write(path) as file:
        file.write(content)


def read_learned(path: str | Path, limit: int = MAX_BYTES) -> Learned:
    """Read what :func:`save_learned` wrote.

    Raises:
        InputError: missing, larger than ``limit`` bytes, or in any way not such a file.
    """
    path = Path(path)
    return parse_learned(read_bytes(path, path.name, most_bytes=limit), path.name, limit)


def parse_learned(content: bytes, name: str = "the file", limit: int = MAX_BYTES) -> Learned:
    """A learned agent from the content of its file (an upload); ``name`` is what the sentences call it.

    Nothing is allocated or built before the header fits the bytes, the settings their schema, and every tensor the
    world and the settings.

    Raises:
        InputError: not such a file; the sentence names the entry at fault.
    """
    file = parse_tensor_file(content, name, most_bytes=limit, most_header=MAX_HEADER)
    metadata = _metadata(file.metadata, name)
    world = _world(metadata["world"])
    settings = _settings(metadata["settings"], world)
    curves = _curves(metadata["curves"], settings)
    if not isinstance(metadata["finished"], bool):
        raise InputError("'finished' must be true or false.")
    shapes = {key: (_DTYPES.get(key, "F32"), shape) for key, shape in table_shapes(settings, world).items()}
    tensors = file.load(tuple(_NUMPY), shapes)
    low, high = bounds_of(world, settings) if settings.peers else (0.0, 0.0)
    _check_ranges(tensors, world, settings, low=low, high=high)
    basis, acting_values = tensors.pop("basis"), tensors.pop("acting_values")
    peers = PeerTables(**tensors, low=low, high=high) if settings.peers else None
    return Learned(world, settings, basis, acting_values, curves, metadata["finished"], peers)


def _metadata(entries: Mapping[str, str], name: str) -> dict[str, object]:
    if parse_json(entries.get("kind", "null"), "'kind'") != KIND:
        raise InputError(f"{name} holds no agent learned here: its 'kind' is not {KIND!r}.")
    for key in _KEYS:
        if key not in entries:
            raise InputError(f"the metadata of {name} lacks {key!r}.")
    for key in entries:
        if key not in _KEYS:
            raise InputError(f"the metadata of {name} has an unknown entry {key[:40]!r}.")
    metadata = {key: parse_json(entries[key], f"the metadata entry {key!r}") for key in _KEYS}
    if metadata["version"] != VERSION or isinstance(metadata["version"], bool):
        raise InputError(f"{name} was saved in version {str(metadata['version'])[:20]}; this reads {VERSION}.")
    return metadata


def _world(entry: object) -> World:
    if isinstance(entry, dict) and set(entry) == {"text"} and isinstance(entry["text"], str):
        return parse_world(entry["text"])
    if isinstance(entry, dict) and set(entry) == {"source", "params"}:
        source, params = entry["source"], entry["params"]
        if isinstance(source, str) and (source in PRESETS or source.startswith("gym:")) and isinstance(params, dict):
            return load_world(source, params)
        raise InputError(f"'world' names {str(source)[:40]!r}; it must be a preset or a listed gym environment.")
    raise InputError("'world' must have 'source' and 'params', or the 'text' of a world file.")


def _settings(entry: object, world: World) -> ResolvedLearning:
    if not isinstance(entry, dict) or set(entry) != set(BY_NAME):
        raise InputError(f"'settings' must have exactly these entries: {', '.join(BY_NAME)}.")
    for name, value in entry.items():
        kind = BY_NAME[name].type
        fits = isinstance(value, bool) == (kind is bool) and isinstance(value, int | float if kind is float else kind)
        if not fits:
            raise InputError(f"the setting {name!r} must be of the type {kind.__name__}.")
    settings = parse_learn_settings(entry)
    resolved = resolve_learning(settings, world)
    if resolved.chosen() != settings:
        raise InputError("'settings' contradict each other: the discounts are not those of their spacing.")
    return resolved


def _curves(entry: object, settings: ResolvedLearning) -> tuple[Mapping[str, np.ndarray], ...]:
    if not isinstance(entry, list) or len(entry) != settings.seeds:
        raise InputError(f"'curves' must be a list of {settings.seeds}, one a seed.")
    curves = []
    for curve in entry:
        if not isinstance(curve, dict) or set(curve) != set(CURVE_NAMES):
            raise InputError(f"every curve must have exactly {', '.join(CURVE_NAMES)}.")
        for name, values in curve.items():
            if not isinstance(values, list) or len(values) > MAX_NOTES or len(values) != len(curve["episode"]):
                raise InputError(f"the curve {name!r} must be a list as long as the others, up to {MAX_NOTES:,}.")
            if not all(type(x) in (int, float) and abs(x) <= 1e15 for x in values):
                raise InputError(f"the curve {name!r} holds something that is not a number within +-1e15.")
        arrays = {name: np.array(curve[name], dtype=float) for name in CURVE_NAMES}
        episodes = arrays["episode"]
        if not np.all(np.diff(episodes, prepend=0.0, append=np.inf) > 0) or episodes.max(initial=0) > settings.episodes:
            raise InputError(f"the curve 'episode' must increase and end at {settings.episodes:,} at most.")
        curves.append(arrays)
    return tuple(curves)


def _check_ranges(
    tensors: Mapping[str, np.ndarray], world: World, settings: ResolvedLearning, *, low: float, high: float
) -> None:
    """Refuse values that no learner can reach: every update is an average, within the bounds of what it averages."""
    for name, array in tensors.items():
        if not np.all(np.isfinite(array)):
            raise InputError(f"the tensor {name!r} holds a value that is not a finite number.")
    basis = tensors["basis"]
    most = 1.0 / (1.0 - settings.discounts)
    if basis.min() < -1e-6 or np.any(basis.sum(axis=-1) > 1.0001 * most + 1e-6):
        raise InputError("the tensor 'basis' lies outside what counts of rewards can be: 0 to 1 / (1 - gamma).")
    largest = float(np.abs(world.reward_values).max()) * 1.0001 + 1e-9
    for name, gamma in (("acting_values", settings.acting_gamma), ("laplace_values", settings.peer_gamma),
                        ("plain", settings.peer_gamma)):  # fmt: skip
        if name in tensors and np.abs(tensors[name]).max() > largest / (1.0 - gamma):
            raise InputError(f"the tensor {name!r} lies outside what returns can be in this world.")
    if "categorical" in tensors:
        masses = tensors["categorical"]
        if masses.min() < -1e-4 or np.abs(masses.sum(axis=-1) - 1.0).max() > 1e-3:
            raise InputError("the tensor 'categorical' holds rows that are not probabilities.")
        # Quantiles step by a share of the bounds' distance, expectiles may jump past their target by as much again.
        room = 4.0 * (largest + high - low) / (1.0 - settings.peer_gamma)
        for name in ("quantile", "expectile"):
            if np.abs(tensors[name]).max() > room:
                raise InputError(f"the tensor {name!r} lies outside what returns can be in this world.")
