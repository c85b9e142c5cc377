"""Table 2: where the sensitivities lie. The paper's two normal laws, in units of reward, and two spacings beside."""

from laplace_core.experiments.paper.experiment import Experiment
from laplace_core.experiments.paper.lander import lander

EXPERIMENT = Experiment(
    name="table2",
    title="Table 2: uniform and Gaussian sensitivities; and asinh",
    question="Does it help to put more sensitivities where the rewards are?",
    cells=[
        lander("uniform", {"theta_spacing": "uniform"}),
        lander("Gaussian, std 20", {"theta_spacing": "gaussian", "theta_scale": 20.0}),
        lander("Gaussian, std 50", {"theta_spacing": "gaussian", "theta_scale": 50.0}),
        lander("asinh", {"theta_spacing": "asinh"}),
    ],
)
