"""Section 3.2: does one network for all discounts disturb itself, and does a multiplexer of three cure that?"""

from laplace_core.experiments.paper.experiment import Experiment
from laplace_core.experiments.paper.lander import lander

EXPERIMENT = Experiment(
    name="multiplexer",
    title="Section 3.2: one network, the multiplexer, and our shared trunk",
    question="Do low and high discounts disturb each other in one network, and do separate networks help?",
    cells=[lander(label, {"network": label}) for label in ("network", "multiplexer", "trunk")],
)
