"""Every agent by name."""

from __future__ import annotations

from laplace_core.agents.agent import Agent
from laplace_core.agents.laplace import LaplaceAgent

AGENTS: dict[str, type[Agent]] = {kind.settings_class.ALGORITHM: kind for kind in (LaplaceAgent,)}
