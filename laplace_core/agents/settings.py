"""The settings of a trained agent, as one frozen, typed object per algorithm.

The command line, the settings files, the run folders and the checkpoints all read and write these through the one
schema of each class.
"""

from __future__ import annotations

from laplace_core.agents.laplace_settings import LaplaceSettings
from laplace_core.agents.loop_settings import LOOP_SCHEMA, LoopSettings
from laplace_core.agents.peer_settings import (
    PEERS,
    C51Settings,
    DqnSettings,
    ExpectileSettings,
    FixedHorizonSettings,
    QrdqnSettings,
)
from laplace_core.environments import ENVIRONMENTS

__all__ = [
    "ENVIRONMENTS", "LOOP_SCHEMA", "SETTINGS", "C51Settings", "DqnSettings",
    "ExpectileSettings", "FixedHorizonSettings", "LaplaceSettings", "LoopSettings", "QrdqnSettings",
    "algorithm_title",
]  # fmt: skip

_KINDS: tuple[type[LoopSettings], ...] = (LaplaceSettings, *PEERS)
SETTINGS: dict[str, type[LoopSettings]] = {kind.ALGORITHM: kind for kind in _KINDS}
"""The settings of every algorithm, by the name that commands, files and checkpoints give it."""


def algorithm_title(name: str) -> str:
    """The name that people call an algorithm by; an unknown one keeps its own name."""
    return SETTINGS[name].TITLE if name in SETTINGS else name
