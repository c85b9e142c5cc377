"""Section 5: the experiment that the paper proposes and did not run, auxiliary states behind the end of an episode.

``auxiliary`` pays 0 until the time limit, ``absorbing`` for ever. The paper's explanation predicts that they repair a
timeline with rescaled rows, and change nothing where the rows keep the survival.
"""

from laplace_core.experiments.paper.experiment import Experiment
from laplace_core.experiments.paper.lander import lander

EXPERIMENT = Experiment(
    name="termination",
    title="Section 5: what follows the end of an episode",
    question="Do auxiliary states make another horizon's actions better, with rescaled rows and without?",
    cells=[lander(label, {"termination": label}) for label in ("plain", "auxiliary", "absorbing")],
)
