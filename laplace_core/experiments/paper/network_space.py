"""The gamma-space of a start state as a small Laplace network learns it."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from laplace_core.acting.rollout import roll_out
from laplace_core.agents.capabilities import HasGammaSpace
from laplace_core.code.gamma_space import GammaSpace
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.training.defaults import settings_of
from laplace_core.training.loop import train


def learned_by_a_network(world: str, seed: int, **changed: Any) -> GammaSpace:
    """Train Laplace DQN with the settings file of a tabular world, and read its first state.

    Returns:
        the bins between the sensitivities, ``(A, G, H)``; what lies beyond the outermost ones does not count.
    """
    settings = settings_of("laplace", world, {"seed": seed, **changed})
    with tempfile.TemporaryDirectory() as folder:
        for _ in train(settings, Path(folder) / "run"):
            pass
        agent = load_checkpoint(Path(folder) / "run" / "last.safetensors").agent
    assert isinstance(agent, HasGammaSpace)
    space = agent.gamma_space(roll_out(agent, world, 0).observations[0])
    return GammaSpace(space.values, space.constant, space.gammas, space.thetas)
