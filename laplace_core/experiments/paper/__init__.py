"""The experiments of the paper, one module each.

What is trained lists settings and seeds; a training that several experiments need is one run, because equal settings
have the same folder. What is measured on worlds and on agents that ship needs no training; its modules load torch, and
so are imported one by one.
"""

from __future__ import annotations

from importlib import import_module

from laplace_core.experiments.paper import (
    auxiliary,
    fig3,
    fig7,
    interpolation,
    multiplexer,
    new_agents,
    paper_agent,
    table2,
    termination,
)
from laplace_core.experiments.paper.experiment import Experiment
from laplace_core.experiments.paper.measurement import Measurement

EXPERIMENTS: dict[str, Experiment] = {
    module.EXPERIMENT.name: module.EXPERIMENT
    for module in (new_agents, fig7, multiplexer, table2, auxiliary, termination, interpolation, paper_agent, fig3)
}
"""What is trained, by name, in the order in which ``reproduce all`` trains it."""
MEASUREMENTS = ("fig1_5", "fig4", "fig6", "aliasing", "timescales", "table1", "acting")
"""Names of what is measured, in the order in which ``reproduce all`` measures it."""


def measurement(name: str) -> Measurement:
    """The measurement of a name in ``MEASUREMENTS``."""
    found: Measurement = import_module(f"{__name__}.{name}").EXPERIMENT
    return found
