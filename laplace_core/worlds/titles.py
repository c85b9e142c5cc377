"""Titles of worlds and environments."""

from __future__ import annotations

import re

from laplace_core.worlds.presets import PRESETS

TITLES = {"own": "Your own world", "timeline": "Your own timeline", "data": "Your own gamma-space"}
"""What is looked at without being listed, by its name in a link."""


def world_title(name: str) -> str:
    """A world or an environment as a person reads it."""
    if name in TITLES:
        return TITLES[name]
    return PRESETS[name].title if name in PRESETS else name.replace("gym:", "gymnasium ")


def plain(environment: str) -> str:
    """An environment's name without its version."""
    return re.sub(r"-v\d+$", "", environment).removeprefix("gym:")
