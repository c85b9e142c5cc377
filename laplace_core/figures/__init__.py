"""Arrays in, plotly figures out, as plain dictionaries; nothing here knows Streamlit."""

from laplace_core.figures.comparison import comparison, thinning
from laplace_core.figures.edited import edited_gamma_space, edited_values
from laplace_core.figures.graph import world_graph
from laplace_core.figures.learning import learning_curve, return_laws, reward_bands
from laplace_core.figures.race import differences
from laplace_core.figures.returns import (
    ReturnRow,
    returns_of_actions,
    returns_over_episode,
    returns_side_by_side,
    values_of_actions,
    values_over_time_to_go,
)
from laplace_core.figures.simulated import calibration_plot, simulated_timeline
from laplace_core.figures.theme import to_json
from laplace_core.figures.timelines import rewards_and_survival, values_over_horizon

__all__ = [
    "ReturnRow",
    "calibration_plot",
    "comparison",
    "differences",
    "edited_gamma_space",
    "edited_values",
    "learning_curve",
    "return_laws",
    "returns_of_actions",
    "returns_over_episode",
    "returns_side_by_side",
    "reward_bands",
    "rewards_and_survival",
    "simulated_timeline",
    "thinning",
    "to_json",
    "values_of_actions",
    "values_over_horizon",
    "values_over_time_to_go",
    "world_graph",
]
