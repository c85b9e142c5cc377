"""Every agent by name."""

from __future__ import annotations

from laplace_core.agents.agent import Agent
from laplace_core.agents.c51 import C51Agent
from laplace_core.agents.dqn import DqnAgent
from laplace_core.agents.laplace import LaplaceAgent
from laplace_core.agents.qrdqn import QrdqnAgent

AGENTS: dict[str, type[Agent]] = {
    kind.settings_class.ALGORITHM: kind for kind in (LaplaceAgent, C51Agent, QrdqnAgent, DqnAgent)
}
