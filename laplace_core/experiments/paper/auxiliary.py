"""Section 2.3: auxiliary learning, the acting discount alone and beside fourteen others."""

from laplace_core.experiments.paper.experiment import Cell, Experiment
from laplace_core.experiments.paper.lander import lander

ALONE = {"gammas": 1}
"""A single discount is gamma_max, .99: the one that acts where there are fifteen."""

EXPERIMENT = Experiment(
    name="auxiliary",
    title="Section 2.3: the discount .99 alone and beside fourteen others",
    question="Does .99 learn faster, and is it more accurate, when the network learns other discounts too?",
    cells=[
        Cell("CartPole, alone", "laplace", "CartPole-v1", ALONE, seeds=range(5)),
        Cell("CartPole, beside fourteen", "laplace", "CartPole-v1", seeds=range(5)),
        lander("LunarLander, alone", ALONE),
        lander("LunarLander, beside fourteen", {}),
    ],
)
