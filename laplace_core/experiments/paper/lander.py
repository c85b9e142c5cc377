"""The shared settings of the experiments on LunarLander: long enough to land, short enough for three seeds each."""

from __future__ import annotations

from collections.abc import Mapping

from laplace_core.experiments.paper.experiment import Cell

ENVIRONMENT = "LunarLander-v3"
"""The paper used v2, which gymnasium no longer has; v3 differs in its wind and in the bounds of its observations."""
STEPS = 250_000


def lander(label: str, settings: Mapping[str, object]) -> Cell:
    """Laplace DQN with three seeds; with no settings of its own it is the training that all of these compare with."""
    return Cell(label, "laplace", ENVIRONMENT, {"steps": STEPS, **settings}, seeds=(0, 1, 2))
