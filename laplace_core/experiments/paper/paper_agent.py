"""The paper's own recipe as a whole (sections 3 to 3.3, appendix C).

An environment, a buffer and a policy for every discount, its fifteen discounts and three networks, accumulated outputs
and no loss on the values; one-step targets of the target network alone, slope 25, batches of 128. The ranges of reward
are not in the paper; those here reach beyond every reward. Its 500 sensitivities on 240 units of reward lie .48 apart,
where slope 25 is 12 in units of 1/spacing; its 100 on CartPole's three lie .03 apart.

Steps, the buffer and what happens every so many steps are counted over all discounts: each has a fifteenth. So CartPole
gives every discount the 50,000 steps that our agents have, and LunarLander 200,000.
"""

from laplace_core.code.encoding import PAPER_GAMMAS
from laplace_core.experiments.paper.experiment import Cell, Experiment
from laplace_core.experiments.paper.lander import ENVIRONMENT

RECIPE = {
    "spacing": "paper",
    "network": "multiplexer",
    "parametrisation": "accumulated",
    "experience": "per_discount",
    "target_policy": "per_gamma",
    "consistency": 0.0,
    "acting_share": 0.0,
    "double": False,
    "n_step": 1,
    "batch": 128,
    "updates": 1,
    "epsilon_final": 0.04,
    "exploration": 0.16,
    "head_exploration": 0.0,
}
SLOPE = 25.0


def sensitivities(count: int, low: float, high: float) -> dict[str, object]:
    """The paper's evenly spaced sensitivities, with its slope in units of 1/spacing."""
    spacing = (high - low) / (count - 1)
    return {
        "thetas": count,
        "theta_spacing": "uniform",
        "theta_min": low,
        "theta_max": high,
        "slope_times_spacing": round(SLOPE * spacing, 6),
    }


def over_all(steps: int, every: int) -> dict[str, object]:
    """What is counted in steps of all discounts.

    Args:
        steps: of each.
        every: steps of each between two updates.
    """
    count = len(PAPER_GAMMAS)
    return {
        "steps": steps * count,
        "update_every": every * count,
        "buffer": min(steps * count, 1_000_000),
        "evaluate_every": steps * count // 20,
        "checkpoint_every": steps * count // 20,
    }


EXPERIMENT = Experiment(
    name="paper_agent",
    title="The paper's agent: its whole recipe at once",
    question="How well does Laplace DQN learn exactly as the paper trained it?",
    cells=[
        Cell(
            "CartPole", "laplace", "CartPole-v1",
            {
                **RECIPE, **sensitivities(100, -1.0, 2.0), **over_all(50_000, every=1), "learning_rate": 0.005,
            },
        ),
        Cell(
            "LunarLander", "laplace", ENVIRONMENT,
            {
                **RECIPE, **sensitivities(500, -120.0, 120.0), **over_all(200_000, every=4), "learning_rate": 0.001,
            },
            seeds=(0,),
        ),
    ],
)  # fmt: skip
