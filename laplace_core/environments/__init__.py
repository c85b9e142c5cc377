"""The environments that agents are trained in, and how they are stepped side by side."""

from laplace_core.environments.catalogue import (
    ENVIRONMENTS,
    GYMNASIUM,
    GYMNASIUM_ENVIRONMENTS,
    WORLD_TIME_LIMIT,
    Component,
    Environment,
    environment_of,
)

__all__ = [
    "ENVIRONMENTS",
    "GYMNASIUM",
    "GYMNASIUM_ENVIRONMENTS",
    "WORLD_TIME_LIMIT",
    "Component",
    "Environment",
    "environment_of",
]
