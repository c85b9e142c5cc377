"""Arrays in, plotly figures out; nothing here knows Streamlit."""

from app.figures.graph import world_graph
from app.figures.spaces import gamma_space, tau_space
from app.figures.timelines import rewards_and_survival, values_over_horizon

__all__ = ["gamma_space", "rewards_and_survival", "tau_space", "values_over_horizon", "world_graph"]
