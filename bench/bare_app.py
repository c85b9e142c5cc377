"""The least a Streamlit app can do: one slider, one 100 x 250 heatmap."""

import numpy as np
import plotly.graph_objects as go
import streamlit as st

st.set_page_config(layout="wide")
value = st.slider("alpha", 0, 100, 50)
st.markdown(f"value {value}")
grid = np.sin(np.linspace(0, 6, 250)[None] * (1 + value / 50)) * np.linspace(0, 1, 100)[:, None]
st.plotly_chart(go.Figure(go.Heatmap(z=grid, colorscale="Viridis")), key="chart")
