"""Figure 3: learning curves over episodes and steps, three environments.

The agents that ship are these trainings; of them the evaluations over steps are kept, and no single episodes. A curve
over episodes needs the trainings again: five seeds each, and three on LunarLander, where one takes about an hour.
"""

from laplace_core.experiments.paper.experiment import Cell, Experiment
from laplace_core.experiments.paper.lander import ENVIRONMENT

ALGORITHMS = {"laplace": "Laplace DQN", "c51": "C51", "qrdqn": "QR-DQN", "dqn": "DQN"}
ENVIRONMENTS = {"CartPole-v1": range(5), "Acrobot-v1": range(5), ENVIRONMENT: range(3)}
"""Seeds by environment."""

EXPERIMENT = Experiment(
    name="fig3",
    title="Figure 3: C51, QR-DQN, Laplace DQN and DQN while they learn",
    question="Does Laplace DQN, acting at .99, learn as well as C51 and QR-DQN do?",
    cells=[
        Cell(f"{environment}, {title}", algorithm, environment, seeds=seeds)
        for environment, seeds in ENVIRONMENTS.items()
        for algorithm, title in ALGORITHMS.items()
    ],
)
