"""The card of a trained agent: algorithm, environment, settings, score and training curves."""

from __future__ import annotations

from html import escape

import streamlit as st

from app.catalogue import checkpoints
from app.components.chart import chart
from laplace_core.environments import Environment
from laplace_core.figures.training import CARD, score_curve
from laplace_core.training.checkpoint import Loaded


def card(name: str, loaded: Loaded, scene: Environment) -> None:
    """In the sidebar."""
    score = "not evaluated" if loaded.score is None else f"{loaded.score:.1f} over {loaded.episodes} episodes"
    st.caption(scene.title)
    st.caption(
        f"{loaded.settings.TITLE}, seed {loaded.seed}, {loaded.step:,} steps; return {score}. "
        f"Outputs: {loaded.settings.describe()}."
    )
    curves = checkpoints.curves(name)
    if curves:
        alt = f"Score over the steps of training: {len(curves)} seeds; the line of this one is thicker."
        chart(score_curve(curves, loaded.step), "card", alt, CARD, revision=name)
    with st.expander("Settings"):
        rows = "".join(
            f"<tr><td>{escape(key)}</td><td>{escape(_written(value))}</td></tr>"
            for key, value in loaded.settings.as_dict().items()
        )
        st.html(f'<table class="numbers settings">{rows}</table>')


def _written(value: object) -> str:
    return f"{value:,}" if isinstance(value, int) and not isinstance(value, bool) else str(value)
