"""Worlds: tabular MDPs as presets, files and gymnasium environments."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache

from laplace_core.errors import InputError
from laplace_core.parameters import Parameter, parse_named
from laplace_core.worlds.files import dump_world, parse_world, read_world
from laplace_core.worlds.model import END, Outcome, World
from laplace_core.worlds.presets import PRESETS, Preset
from laplace_core.worlds.table import rescaled, world_from_rows, world_rows
from laplace_core.worlds.timeline import MAX_TAU, TIMELINE_RESTS, timeline_rows, timeline_world
from laplace_core.worlds.toy_text import TOY_TEXT, toy_text_name, toy_text_world

__all__ = [
    "END",
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
    "read_world",
    "rescaled",
    "timeline_rows",
    "timeline_world",
    "world_from_rows",
    "world_rows",
]


def parameters_of(source: str) -> tuple[Parameter, ...]:
    """What can be set in a preset or a ``gym:`` environment; files have no parameters."""
    if source.startswith("gym:"):
        return TOY_TEXT[toy_text_name(source.removeprefix("gym:"))]
    return PRESETS[source].parameters if source in PRESETS else ()


def load_world(source: str, params: Mapping[str, object] | None = None) -> World:
    """A world from a preset's name, ``gym:NAME``, or the path of a JSON file.

    Raises:
        InputError: unknown source, or parameters that do not fit it.
    """
    if source.startswith("gym:"):
        source = f"gym:{toy_text_name(source.removeprefix('gym:'))}"
    if source.startswith("gym:") or source in PRESETS:
        given = parse_named(source, parameters_of(source), dict(params or {}))
        return _built(source, tuple(sorted(given.items())))
    if not source.endswith(".json"):
        raise InputError(f"world {source[:60]!r} is none of: {', '.join(PRESETS)}, a .json file, or gym:NAME.")
    if params:
        raise InputError(f"{source[:60]} is a file: it has no parameters, edit the file instead.")
    return replace(read_world(source), source=source)


@lru_cache(maxsize=32)
def _built(source: str, params: tuple[tuple[str, object], ...]) -> World:
    """The same world object for the same words, so that what is cached per world is found again."""
    if source.startswith("gym:"):
        built = toy_text_world(source.removeprefix("gym:"), dict(params))
    else:
        built = PRESETS[source].make(dict(params))
    return replace(built, source=source, params=params)
