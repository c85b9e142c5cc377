"""Laplace DQN on LunarLander trained again, with the target averaging that the search selected, on new seeds."""

from laplace_core.experiments.paper.experiment import Cell, Experiment
from laplace_core.experiments.paper.lander import ENVIRONMENT

EXPERIMENT = Experiment(
    name="new_agents",
    title="Laplace DQN on LunarLander, trained again",
    question="Does no seed fall below 240 when the target network follows faster?",
    cells=[Cell("averaging .005", "laplace", ENVIRONMENT, {"averaging": 0.005}, seeds=(5, 6, 7, 8, 9))],
)
