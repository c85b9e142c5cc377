"""Arrays in, plotly figures out, as plain dictionaries; nothing here knows Streamlit."""

from app.figures.graph import world_graph
from app.figures.spaces import gamma_space, tau_space
from app.figures.theme import to_json
from app.figures.timelines import rewards_and_survival, values_over_horizon

__all__ = ["gamma_space", "rewards_and_survival", "tau_space", "to_json", "values_over_horizon", "world_graph"]
