"""The experiments of the paper, each in a module of its own: what is trained, and how often.

A training that several experiments need is one run: equal settings have the same folder.
"""

from __future__ import annotations

from laplace_core.experiments.paper import (
    auxiliary,
    fig7,
    multiplexer,
    new_agents,
    paper_agent,
    table2,
    termination,
)
from laplace_core.experiments.paper.experiment import Experiment

EXPERIMENTS: dict[str, Experiment] = {
    module.EXPERIMENT.name: module.EXPERIMENT
    for module in (new_agents, fig7, multiplexer, table2, auxiliary, termination, paper_agent)
}
"""By name, in the order in which ``reproduce all`` trains them."""
