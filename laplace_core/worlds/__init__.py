"""Worlds: tabular MDPs as presets, files and gymnasium environments."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from laplace_core.caching import cached
from laplace_core.errors import InputError
from laplace_core.parameters import Parameter, parse_named
from laplace_core.worlds.files import dump_world, parse_world, parse_world_bytes, read_world, world_text
from laplace_core.worlds.model import END, MAX_STATES, Outcome, World
from laplace_core.worlds.presets import PRESETS, Preset
from laplace_core.worlds.table import rescaled, world_from_rows, world_rows
from laplace_core.worlds.timeline import MAX_TAU, TIMELINE_RESTS, timeline_rows, timeline_world
from laplace_core.worlds.toy_text import TOY_TEXT, toy_text_limit, toy_text_name, toy_text_world

__all__ = [
    "END",
    "MAX_STATES",
    "MAX_TAU",
    "PRESETS",
    "TIMELINE_RESTS",
    "TOY_TEXT",
    "Outcome",
    "Preset",
    "World",
    "dump_world",
    "load_world",
    "parameters_of",
    "parse_world",
    "parse_world_bytes",
    "read_world",
    "rescaled",
    "timeline_rows",
    "timeline_world",
    "toy_text_limit",
    "world_from_rows",
    "world_rows",
    "world_text",
]


def parameters_of(source: str) -> tuple[Parameter, ...]:
    """Parameters of a preset or of a ``gym:`` environment; files have none."""
    if source.startswith("gym:"):
        return TOY_TEXT[toy_text_name(source.removeprefix("gym:"))]
    return PRESETS[source].parameters if source in PRESETS else ()


def load_world(source: str | Path, params: Mapping[str, object] | None = None) -> World:
    """A world from a preset's name, ``gym:NAME``, or the path of a JSON file; a ``Path`` is always that of a file.

    Raises:
        InputError: unknown source, or parameters that do not fit it.
    """
    if isinstance(source, os.PathLike):
        return _from_file(os.fspath(source), params)
    if not isinstance(source, str):
        raise InputError(f"a world is named by text or by a path, not by {type(source).__name__}.")
    if source.startswith("gym:"):
        source = f"gym:{toy_text_name(source.removeprefix('gym:'))}"
    if source.startswith("gym:") or source in PRESETS:
        given = parse_named(source, parameters_of(source), dict(params or {}))
        return _built(source, tuple(sorted(given.items())))
    return _from_file(source, params)


def _from_file(source: str, params: Mapping[str, object] | None) -> World:
    if not source.lower().endswith(".json"):
        raise InputError(f"world {source[:60]!r} is none of: {', '.join(PRESETS)}, a .json file, or gym:NAME.")
    if params:
        raise InputError(f"{source[:60]} is a file: it has no parameters, edit the file instead.")
    return replace(read_world(source), source=source)


@cached(32)
def _built(source: str, params: tuple[tuple[str, object], ...]) -> World:
    """The same world object for the same words, so that caches by world are hit again."""
    if source.startswith("gym:"):
        built = toy_text_world(source.removeprefix("gym:"), dict(params))
    else:
        built = PRESETS[source].make(dict(params))
    return replace(built, source=source, params=params)
