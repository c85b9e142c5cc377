"""What the numbers of an observation mean, and the actions, of the environments that agents are trained in."""

from __future__ import annotations

from dataclasses import dataclass

from laplace_core.environments import Component, environment_of


@dataclass(frozen=True)
class Scene:
    """An environment as a person reads it.

    Attributes:
        components: of an observation; empty for a tabular world, whose observation is its state.
    """

    title: str
    components: tuple[Component, ...]
    actions: tuple[str, ...]
    states: tuple[str, ...] = ()


def scene_of(environment: str) -> Scene:
    entry = environment_of(environment)
    return Scene(entry.title, entry.components, entry.actions, entry.states)
