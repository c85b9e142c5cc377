"""Section 3.3: values at discounts that were not trained, where the network takes the discount as an input.

Every other one of the fifteen discounts is held out: as these are evenly spaced in log time constant, eight between
the same two are every other of them.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from laplace_core.experiments.paper.experiment import Cell, Experiment
from laplace_core.experiments.paper.lander import lander

ALL, KEPT = 15, 8
NETWORKS = ("network", "multiplexer")
"""The networks that take the discount as an input; a trunk has heads for its own discounts only."""
HELD_OUT = {"gammas": KEPT}


def _reading(folder: Path) -> dict[str, Any]:
    from laplace_core.experiments.paper.held_out import value_errors  # loads torch

    return value_errors(folder, ALL)


EXPERIMENT = Experiment(
    name="interpolation",
    title="Section 3.3: every other discount held out in training",
    question="How far are values at discounts that were never trained, beside those of a network that trained them?",
    cells=[
        *(
            Cell(f"CartPole, {network}, {which}", "laplace", "CartPole-v1", {"network": network, **changed})
            for network in NETWORKS
            for which, changed in (("all fifteen", {}), ("every other", HELD_OUT))
        ),
        *(
            lander(f"LunarLander, {network}, {which}", {"network": network, **changed})
            for network in NETWORKS
            for which, changed in (("all fifteen", {}), ("every other", HELD_OUT))
        ),
    ],
    reading=_reading,
)
