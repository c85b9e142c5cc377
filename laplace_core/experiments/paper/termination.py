"""Section 5: the experiment that the paper proposes and did not run, auxiliary states behind the end of an episode.

``auxiliary`` pays 0 until the time limit, ``absorbing`` for ever. The paper's explanation predicts that they repair a
timeline with rescaled rows, and change nothing where the rows keep the survival: each agent acts for a shorter T by
both readings.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from laplace_core.experiments.paper.experiment import Experiment
from laplace_core.experiments.paper.lander import lander

HORIZONS = (50, 100, 200)
READINGS = ("rescaled", "left alone")
"""Rows rescaled to 1, and rows that keep the survival."""
ENDINGS = ("plain", "auxiliary", "absorbing")


def _reading(folder: Path) -> dict[str, Any]:
    from laplace_core.experiments.paper.rows_read import returns_by_rows  # loads torch

    return returns_by_rows(folder, HORIZONS)


EXPERIMENT = Experiment(
    name="termination",
    title="Section 5: what follows the end of an episode",
    question="Do auxiliary states make another horizon's actions better, with rescaled rows and without?",
    cells=[lander(label, {"termination": label}) for label in ENDINGS],
    reading=_reading,
)
