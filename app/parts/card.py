"""What a trained agent says of itself: algorithm, environment, settings, score, and how the score came about."""

from __future__ import annotations

from html import escape

import streamlit as st

from app import checkpoints, figures
from app.chart import chart
from app.figures.training import CARD, score_curve
from app.observations import Scene
from laplace_core.agents.settings import (
    C51Settings,
    DqnSettings,
    ExpectileSettings,
    FixedHorizonSettings,
    LaplaceSettings,
    QrdqnSettings,
)
from laplace_core.training.checkpoint import Loaded


def card(name: str, loaded: Loaded, scene: Scene) -> None:
    """In the sidebar."""
    score = "not evaluated" if loaded.score is None else f"{loaded.score:.1f} over {loaded.episodes} episodes"
    st.caption(scene.title)
    st.caption(
        f"{checkpoints.ALGORITHMS[loaded.algorithm]}, seed {loaded.seed}, {loaded.step:,} steps; return {score}. "
        f"Outputs: {_outputs(loaded)}."
    )
    curves = checkpoints.curves(name)
    if curves:
        alt = f"Score over the steps of training: {len(curves)} seeds, the one shown heavier."
        chart(figures.to_json(score_curve(curves, loaded.step)), "card", alt, CARD, revision=name)
    with st.expander("Settings"):
        rows = "".join(
            f"<tr><td>{escape(key)}</td><td>{escape(_written(value))}</td></tr>"
            for key, value in loaded.settings.as_dict().items()
        )
        st.html(f'<table class="numbers settings">{rows}</table>')


def _outputs(loaded: Loaded) -> str:
    """What its network gives for an action."""
    s = loaded.settings
    if isinstance(s, LaplaceSettings):
        grid = f"{s.n_discounts} discounts to {s.gamma_max:g}, {s.thetas} sensitivities"
        return f"{grid}, {s.network}, {s.parametrisation}"
    assert isinstance(s, DqnSettings)  # what all others are
    return f"{_numbers(s)}, discount {s.gamma:g}"


def _numbers(settings: DqnSettings) -> str:
    match settings:
        case C51Settings(atoms=atoms, v_min=low, v_max=high):
            return f"{atoms} atoms from {low:g} to {high:g}"
        case QrdqnSettings(quantiles=quantiles):
            return f"{quantiles} quantiles"
        case ExpectileSettings(expectiles=expectiles):
            return f"{expectiles} expectiles"
        case FixedHorizonSettings(horizon=horizon):
            return f"a mean for every T to {horizon}"
        case _:
            return "the mean return"


def _written(value: object) -> str:
    return f"{value:,}" if isinstance(value, int) and not isinstance(value, bool) else str(value)
