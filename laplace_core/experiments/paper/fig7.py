"""Figure 7: ways to keep the outputs from rising over the sensitivities."""

from laplace_core.experiments.paper.experiment import Cell, Experiment

EXPERIMENT = Experiment(
    name="fig7",
    title="Figure 7: accumulation, clipped differences, no constraint; and our softmax",
    question="Which way of keeping the values monotone over the sensitivities trains best on CartPole?",
    cells=[
        Cell(label, "laplace", "CartPole-v1", {"parametrisation": label}, seeds=range(5))
        for label in ("accumulated", "clipped", "free", "softmax")
    ],
)
