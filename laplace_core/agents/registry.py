"""Every agent by name."""

from __future__ import annotations

from laplace_core.agents.agent import Agent
from laplace_core.agents.c51 import C51Agent
from laplace_core.agents.dqn import DqnAgent
from laplace_core.agents.expectile import ExpectileAgent
from laplace_core.agents.fixed_horizon import FixedHorizonAgent
from laplace_core.agents.laplace import LaplaceAgent
from laplace_core.agents.qrdqn import QrdqnAgent

_KINDS = (LaplaceAgent, C51Agent, QrdqnAgent, ExpectileAgent, DqnAgent, FixedHorizonAgent)
AGENTS: dict[str, type[Agent]] = {kind.settings_class.ALGORITHM: kind for kind in _KINDS}
