"""Agents: networks that learn a gamma-space (or, as peers, a return) from experience.

This module loads no torch: ``from laplace_core.agents.registry import AGENTS`` does.
"""

from laplace_core.agents.settings import ENVIRONMENTS, SETTINGS, LaplaceSettings, LoopSettings

__all__ = ["ENVIRONMENTS", "SETTINGS", "LaplaceSettings", "LoopSettings"]
